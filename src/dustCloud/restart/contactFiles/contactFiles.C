/*---------------------------------------------------------------------------*\
    dustFoam: adhesive dust in ventilation ducts
-------------------------------------------------------------------------------
License
    This file is part of dustFoam.

    dustFoam is free software: you can redistribute it and/or modify it under
    the terms of the GNU General Public License as published by the Free
    Software Foundation, either version 3 of the License, or (at your option)
    any later version.

    dustFoam is distributed in the hope that it will be useful, but WITHOUT ANY
    WARRANTY; without even the implied warranty of MERCHANTABILITY or FITNESS
    FOR A PARTICULAR PURPOSE.  See the GNU General Public License for more
    details.

    You should have received a copy of the GNU General Public License along
    with dustFoam.  If not, see <http://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/

#include "dustCloudData.H"
#include "contactFiles.H"
#include "restartFiles.H"
#include "dustParcel.H"

#include "Cloud.H"
#include "DEM.hpp"
#include "IOField.H"
#include "tensor.H"

#include <iterator>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

typedef dem::PackedState packed;

static const int64_t procStride = int64_t(1) << 31;

static const label width = tensor::nComponents;

//- Contacts with more than this are not contacts of spheres
static const label mostContacts = 1000;


static bool isOneOf(const std::size_t i, const std::size_t* some, label n)
{
    return std::find(some, some + n, i) != some + n;
}


//- Positions of the numbers that are not integers
template<std::size_t N>
static labelList reals(const std::size_t all, const std::size_t (&integers)[N])
{
    labelList result;
    for (std::size_t i = 0; i < all; ++i)
    {
        if (!isOneOf(i, integers, N))
        {
            result.append(label(i));
        }
    }
    return result;
}


static const labelList& restReals()
{
    static const labelList list
    (
        reals(packed::restNumbers, packed::restIntegers)
    );
    return list;
}


static const labelList& contactReals()
{
    static const labelList list
    (
        reals(packed::contactNumbers, packed::contactIntegers)
    );
    return list;
}


//- Tensors for so many numbers
static label pieces(const label n)
{
    return (n + width - 1)/width;
}


//- Fields by name, made when first asked for
struct fieldTable
{
    const Cloud<dustParcel>& cloud;
    HashTable<autoPtr<IOField<label>>> labels;
    HashTable<autoPtr<IOField<tensor>>> tensors;

    template<class Type>
    IOField<Type>& made
    (
        HashTable<autoPtr<IOField<Type>>>& table,
        const word& name,
        const Type& value
    )
    {
        if (!table.found(name))
        {
            const IOobject io
            (
                cloud.fieldIOobject(name, IOobject::NO_READ)
            );
            table.set
            (
                name,
                autoPtr<IOField<Type>>
                (
                    new IOField<Type>(io, Field<Type>(cloud.size(), value))
                )
            );
        }
        return *table[name];
    }

    IOField<label>& integers(const word& name, const label value)
    {
        return made(labels, name, value);
    }

    IOField<tensor>& numbers(const word& name)
    {
        return made(tensors, name, tensor(Zero));
    }

    void write() const
    {
        const bool valid = cloud.size();
        for (const word& name : labels.sortedToc())
        {
            labels[name]->write(valid);
        }
        for (const word& name : tensors.sortedToc())
        {
            tensors[name]->write(valid);
        }
    }

    template<class Type>
    void read(HashTable<autoPtr<IOField<Type>>>& table, const word& name)
    {
        restartFiles::checkOne(cloud, name, true);
        table.set
        (
            name,
            autoPtr<IOField<Type>>
            (
                new IOField<Type>
                (
                    cloud.fieldIOobject(name, IOobject::READ_IF_PRESENT),
                    cloud.size() > 0
                )
            )
        );
    }
};


//- Of the integers of the rest state, in the order of restIntegers
static const char* const restNames[] =
{
    "restVersion", "restContact", "restSleep", "restAggregate", "restMembers"
};
static_assert
(
    std::size(restNames) == std::size(packed::restIntegers),
    "one name for each integer of the rest state"
);


static word slot(const label k, const word& what)
{
    return "contact" + Foam::name(k) + what;
}


static label procOf(const scalar id)
{
    return id < 0 ? -1 : label(int64_t(id)/procStride);
}


static label numberOf(const scalar id)
{
    return id < 0 ? -1 : label(int64_t(id)%procStride);
}


//- A particle's blob, null where it remembers nothing (or too few contacts)
typedef List<scalarField*> blobList;


static scalar* contactOf(scalarField* blob, const label k)
{
    const label start =
        label(packed::restNumbers + std::size_t(k)*packed::contactNumbers);
    return blob && blob->size() > start ? blob->data() + start : nullptr;
}


static void storeRest(fieldTable& f, const blobList& blobs)
{
    labelField& proc = f.integers("restAggregateProc", -1);
    tensorField& state = f.numbers("restState");

    for (std::size_t n = 0; n < std::size(restNames); ++n)
    {
        const label from = label(packed::restIntegers[n]);
        const bool id = packed::restIntegers[n] == packed::aggregate;
        labelField& field = f.integers(restNames[n], 0);

        forAll(blobs, i)
        {
            if (blobs[i])
            {
                const scalar value = (*blobs[i])[from];
                field[i] = id ? numberOf(value) : label(value);
            }
        }
    }
    forAll(blobs, i)
    {
        if (blobs[i])
        {
            proc[i] = procOf((*blobs[i])[label(packed::aggregate)]);
            forAll(restReals(), n)
            {
                state[i][n] = (*blobs[i])[restReals()[n]];
            }
        }
    }
}


static void storeContact(fieldTable& f, const label k, const blobList& blobs)
{
    labelField& proc = f.integers(slot(k, "Proc"), -2);
    labelField& number = f.integers(slot(k, "Id"), -2);

    forAll(blobs, i)
    {
        const scalar* c = contactOf(blobs[i], k);
        if (c)
        {
            const scalar partner = c[packed::partner];
            proc[i] = procOf(partner);
            number[i] =
                partner < 0 ? label(c[packed::wall]) : numberOf(partner);
        }
    }
    forAll(contactReals(), n)
    {
        tensorField& state = f.numbers(slot(k, "State" + Foam::name(n/width)));
        forAll(blobs, i)
        {
            const scalar* c = contactOf(blobs[i], k);
            if (c)
            {
                state[i][n%width] = c[contactReals()[n]];
            }
        }
    }
}


static void takeRest(fieldTable& f, const blobList& blobs)
{
    for (std::size_t n = 0; n < std::size(restNames); ++n)
    {
        const label to = label(packed::restIntegers[n]);
        const labelField& field = *f.labels[restNames[n]];
        forAll(blobs, i)
        {
            if (blobs[i])
            {
                (*blobs[i])[to] = field[i];
            }
        }
    }

    const labelField& proc = *f.labels["restAggregateProc"];
    const tensorField& state = *f.tensors["restState"];
    forAll(blobs, i)
    {
        if (blobs[i])
        {
            scalar& aggregate = (*blobs[i])[label(packed::aggregate)];
            aggregate =
                proc[i] < 0 ? -1 : scalar(proc[i]*procStride) + aggregate;
            forAll(restReals(), n)
            {
                (*blobs[i])[restReals()[n]] = state[i][n];
            }
        }
    }
}


static void takeContact(fieldTable& f, const label k, const blobList& blobs)
{
    const labelField& proc = *f.labels[slot(k, "Proc")];
    const labelField& number = *f.labels[slot(k, "Id")];

    forAll(blobs, i)
    {
        scalar* c = contactOf(blobs[i], k);
        if (c)
        {
            c[packed::partner] =
                proc[i] < 0 ? -1 : scalar(proc[i]*procStride) + number[i];
            c[packed::wall] = proc[i] == -1 ? number[i] : -1;
        }
    }
    forAll(contactReals(), n)
    {
        const tensorField& state =
            *f.tensors[slot(k, "State" + Foam::name(n/width))];
        forAll(blobs, i)
        {
            scalar* c = contactOf(blobs[i], k);
            if (c)
            {
                c[contactReals()[n]] = state[i][n%width];
            }
        }
    }
}


//- All fields that there have to be for so many contacts each. For the first
//  slots, too, where this rank has none of them.
static void makeAll(fieldTable& f, const label slots)
{
    for (const char* name : restNames)
    {
        f.integers(name, 0);
    }
    f.integers("restAggregateProc", -1);
    f.numbers("restState");
    for (label k = 0; k < slots; ++k)
    {
        f.integers(slot(k, "Proc"), -2);
        f.integers(slot(k, "Id"), -2);
        for (label m = 0; m < pieces(contactReals().size()); ++m)
        {
            f.numbers(slot(k, "State" + Foam::name(m)));
        }
    }
}


static void readAll(fieldTable& f, const label slots)
{
    for (const char* name : restNames)
    {
        f.read(f.labels, name);
    }
    f.read(f.labels, "restAggregateProc");
    f.read(f.tensors, "restState");
    for (label k = 0; k < slots; ++k)
    {
        f.read(f.labels, slot(k, "Proc"));
        f.read(f.labels, slot(k, "Id"));
        for (label m = 0; m < pieces(contactReals().size()); ++m)
        {
            f.read(f.tensors, slot(k, "State" + Foam::name(m)));
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::contactFiles::write(const Cloud<dustParcel>& c)
{
    fieldTable f{c, {}, {}};
    labelField& identityProc = f.integers("identityProc", -1);
    labelField& identity = f.integers("identity", -1);
    labelField& contacts = f.integers("contacts", -1);
    blobList blobs(c.size(), nullptr);
    label slots = 0;
    label i = 0;

    for (const dustParcel& p : c)
    {
        identityProc[i] = p.origProc();
        identity[i] = p.origId();
        if (p.blob().size())
        {
            // Only read from
            blobs[i] = &const_cast<dustParcel&>(p).blob();
            contacts[i] =
                label(packed::contacts(std::size_t(p.blob().size())));
            slots = max(slots, contacts[i]);
        }
        ++i;
    }
    reduce(slots, maxOp<label>());

    makeAll(f, slots);
    storeRest(f, blobs);
    for (label k = 0; k < slots; ++k)
    {
        storeContact(f, k, blobs);
    }
    f.write();
}


void Foam::contactFiles::read(Cloud<dustParcel>& c, const bool needed)
{
    fieldTable f{c, {}, {}};

    const bool there = restartFiles::checkOne(c, "contacts", needed);
    if (!returnReduce(there && c.size(), orOp<bool>()))
    {
        return;
    }
    f.read(f.labels, "identityProc");
    f.read(f.labels, "identity");
    f.read(f.labels, "contacts");
    const labelList& contacts = *f.labels["contacts"];

    label slots = 0;
    forAll(contacts, i)
    {
        if (contacts[i] < -1 || contacts[i] > mostContacts)
        {
            FatalErrorInFunction
                << f.labels["contacts"]->objectPath() << ": particle " << i
                << " has " << contacts[i] << " contacts" << nl
                << "    allowed: -1 (remembers nothing) to " << mostContacts
                << exit(FatalError);
        }
        slots = max(slots, contacts[i]);
    }
    reduce(slots, maxOp<label>());
    readAll(f, slots);

    blobList blobs(c.size(), nullptr);
    label i = 0;
    for (dustParcel& p : c)
    {
        p.origProc() = (*f.labels["identityProc"])[i];
        p.origId() = (*f.labels["identity"])[i];

        const label n = contacts[i];
        if (n >= 0)
        {
            p.blob().setSize
            (
                label(packed::restNumbers + n*packed::contactNumbers)
            );
            blobs[i] = &p.blob();
        }
        ++i;
    }

    takeRest(f, blobs);
    for (label k = 0; k < slots; ++k)
    {
        takeContact(f, k, blobs);
    }
}


// ************************************************************************* //
