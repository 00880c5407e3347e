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
#include "parcelChecksums.H"
#include "dustParcel.H"

#include "Cloud.H"
#include "IStringStream.H"
#include "OStringStream.H"

#include <cstring>
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Hash of a row of numbers; the mixer is splitmix64 (S. Vigna, public domain)
class rowHash
{
    uint64_t h_;

public:

    explicit rowHash(const uint64_t start)
    :
        h_(0)
    {
        add(start);
    }

    void add(const uint64_t bits)
    {
        h_ += 0x9e3779b97f4a7c15ULL + bits;
        h_ = (h_ ^ (h_ >> 30))*0xbf58476d1ce4e5b9ULL;
        h_ = (h_ ^ (h_ >> 27))*0x94d049bb133111ebULL;
        h_ ^= h_ >> 31;
    }

    void add(const label value)
    {
        add(uint64_t(int64_t(value)));
    }

    void add(const scalar value)
    {
        // By its bits: comparing what is not a number may trap
        uint64_t bits;
        static_assert(sizeof(bits) == sizeof(value), "double precision");
        std::memcpy(&bits, &value, sizeof(bits));
        const bool tiny = (bits & 0x7fffffffffffffffULL) < tinyBits();
        add(tiny ? uint64_t(0) : bits);
    }

    void add(const vector& v)
    {
        add(v.x());
        add(v.y());
        add(v.z());
    }

    void add(const scalarField& f)
    {
        add(f.size());
        for (const scalar v : f)
        {
            add(v);
        }
    }

    template<unsigned N>
    void add(const FixedList<scalar, N>& f)
    {
        for (const scalar v : f)
        {
            add(v);
        }
    }

    uint64_t value() const
    {
        return h_;
    }

    //- Bits of positive numbers are in the order of the numbers
    static uint64_t tinyBits()
    {
        const scalar tiny = 1e-300;
        uint64_t bits;
        std::memcpy(&bits, &tiny, sizeof(bits));
        return bits;
    }
};


static word hexadecimal(const uint64_t value)
{
    std::ostringstream text;
    text << 'x' << std::hex << std::setw(16) << std::setfill('0') << value;
    return word(text.str());
}


static const wordList names
({
    "identity", "active", "typeId", "nParticle", "d", "dTarget", "U", "rho",
    "age", "tTurb", "UTurb", "angularVelocity", "x", "state", "owedImpulse",
    "material", "contacts", "gasLoad"
});


//- Sums of all fields, in the order of `names`
struct fieldSums
{
    List<uint64_t> sums;

    template<class Type>
    void add(label& fieldi, const dustParcel& p, const Type& value)
    {
        rowHash row((uint64_t(p.id())));
        row.add(value);
        sums[fieldi++] += row.value();
    }

    void add(const dustParcel& p)
    {
        label n = 0;
        add(n, p, p.origId());
        add(n, p, label(p.active()));
        add(n, p, p.typeId());
        add(n, p, p.nParticle());
        add(n, p, p.d());
        add(n, p, p.dTarget());
        add(n, p, p.U());
        add(n, p, p.rho());
        add(n, p, p.age());
        add(n, p, p.tTurb());
        add(n, p, p.UTurb());
        add(n, p, p.omega());
        add(n, p, p.x());
        add(n, p, p.state());
        add(n, p, p.owed());
        add(n, p, p.material());
        add(n, p, p.blob());
        add(n, p, p.load());
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::dictionary Foam::parcelChecksums::of
(
    const Cloud<dustParcel>& c,
    const bool withLoads
)
{
    fieldSums all{List<uint64_t>(names.size(), uint64_t(0))};
    for (const dustParcel& p : c)
    {
        all.add(p);
    }
    Pstream::listCombineGather(all.sums, plusEqOp<uint64_t>());
    Pstream::listCombineScatter(all.sums);

    dictionary result;
    const label n = names.size() - (withLoads ? 0 : 1);
    for (label i = 0; i < n; ++i)
    {
        result.set(names[i], hexadecimal(all.sums[i]));
    }
    return result;
}


Foam::word Foam::parcelChecksums::of(const dictionary& dict)
{
    const auto text = [](const dictionary& d)
    {
        OStringStream os;
        os.precision(17);
        d.write(os, false);
        return os.str();
    };

    // As a file would give it back: 600 from 600.0
    IStringStream is(text(dict));
    const dictionary read(is);

    rowHash row(uint64_t(0));
    for (const char c : text(read))
    {
        row.add(uint64_t(static_cast<unsigned char>(c)));
    }
    return hexadecimal(row.value());
}


Foam::word Foam::parcelChecksums::of(const UList<vector>& values)
{
    uint64_t sum = 0;
    for (const vector& value : values)
    {
        rowHash row(uint64_t(0));
        row.add(value);
        sum += row.value();
    }
    return hexadecimal(returnReduce(sum, sumOp<uint64_t>()));
}


Foam::wordList Foam::parcelChecksums::changed
(
    const dictionary& then,
    const dictionary& now
)
{
    wordList result;
    for (const entry& e : now)
    {
        // The name of before, see restartFiles::spin
        const word name
        (
            e.keyword() == "angularVelocity" && then.found("omega")
          ? "omega"
          : e.keyword()
        );
        if
        (
            then.lookupOrDefault<word>(name, word::null)
         != now.get<word>(e.keyword())
        )
        {
            result.append(name);
        }
    }
    return result;
}


// ************************************************************************* //
