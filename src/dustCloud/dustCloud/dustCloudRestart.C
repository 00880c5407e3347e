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
#include "loadFiles.H"
#include "masterFirst.H"
#include "parcelChecksums.H"
#include "restartCheck.H"
#include "untrapped.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::checkLedger() const
{
    const fileName path
    (
        "uniform"/cloud::prefix/name()/outputProperties_.name()
    );
    const bool found = outputProperties_.found("ledger");
    const bool some = returnReduce(found, orOp<bool>());

    if (some && !returnReduce(found, andOp<bool>()))
    {
        masterFirst();
        FatalErrorInFunction
            << "The files of time " << mesh_.time().timeName()
            << " do not belong together: " << path.c_str()
            << " is missing or cut short on some of the ranks" << nl
            << "    Restore it, or start from another time"
            << exit(FatalError);
    }

    IOobject x(fieldIOobject("x", IOobject::READ_IF_PRESENT));
    const bool ours = size() && x.typeHeaderOk<IOField<vector>>(false);

    if (!some && returnReduce(ours, orOp<bool>()))
    {
        masterFirst();
        FatalErrorInFunction
            << "The files of time " << mesh_.time().timeName()
            << " do not belong together: lagrangian/" << name()
            << " holds particles of dustFoam, but "
            << outputProperties_.objectPath()
            << ", which tells what was injected and who is who, is missing or"
            << " cut short" << nl
            << "    Restore it, or start from another time; to count the"
            << " particles as injected now, without their contacts, delete x,"
            << " angularVelocity, state and contacts in lagrangian/" << name()
            << ", too" << exit(FatalError);
    }

    if (!found)
    {
        return;
    }

    const dictionary& ledger = outputProperties_.subDict("ledger");
    const label version = ledger.lookupOrDefault<label>("version", 1);
    if (version != ledgerVersion)
    {
        masterFirst();
        FatalErrorInFunction
            << path.c_str() << " of time " << mesh_.time().timeName()
            << " has version " << version << nl
            << "    allowed: " << ledgerVersion << ", as this dustFoam writes"
            << exit(FatalError);
    }
    if (!ledger.lookupOrDefault("complete", false))
    {
        masterFirst();
        FatalErrorInFunction
            << "The files of time " << mesh_.time().timeName()
            << " are not complete: " << path.c_str() << " is cut short" << nl
            << "    Restore it, or start from another time"
            << exit(FatalError);
    }
}


void Foam::dustCloud::readParcels()
{
    checkLedger();

    const dictionary* ledgerPtr = outputProperties_.findDict("ledger");
    label nWalls = 0;
    if (ledgerPtr)
    {
        readCounters(*ledgerPtr);
        checkCounters();
        nWalls = ledgerPtr->get<wordList>("walls").size();
    }

    const bool underWay = dem_->step.underWay();
    {
        const untrapped reading;
        dustParcel::readFields(*this);
        if (underWay)
        {
            loadFiles::read(*this);
        }
    }

    const restartCheck check
    (
        *this,
        dem_->properties,
        nWalls,
        ledgerPtr,
        dem_->gasSpeed
    );
    if (ledgerPtr)
    {
        checkSums(*ledgerPtr);
        readMaterials(*ledgerPtr);
    }
    check.values();
    if (ledgerPtr)
    {
        check.identities();
        check.mass(injected_.mass - escaped().mass, injected_.mass);
    }
    else
    {
        adoptParcels();
    }
    check.places();
}


void Foam::dustCloud::checkSums(const dictionary& ledger) const
{
    const Time& time = mesh_.time();
    const label timeIndex = ledger.get<label>("timeIndex");

    if (timeIndex != time.timeIndex())
    {
        masterFirst();
        FatalErrorInFunction
            << "The files of time " << time.timeName()
            << " do not belong together: uniform/time has the index "
            << time.timeIndex() << " (or is missing), uniform/lagrangian/"
            << name() << '/' << outputProperties_.name() << " was written at "
            << timeIndex << nl
            << "    Restore uniform/time, or start from another time"
            << exit(FatalError);
    }

    const dictionary* thenPtr = ledger.findDict("checksums");
    if (!thenPtr)
    {
        Info<< "Note: the ledger of time " << time.timeName() << " has no"
            << " checksums: the particles are taken as the files have them"
            << nl << endl;
        return;
    }

    dictionary all(outputProperties_);
    all.subDict("ledger").remove("checksums");
    all.subDict("ledger").remove("complete");

    dictionary now(parcelChecksums::of(*this, dem_->step.underWay()));
    now.set("ledger", parcelChecksums::of(all));

    wordList changed(parcelChecksums::changed(*thenPtr, now));
    if (changed.empty())
    {
        return;
    }
    // The sums of all others depend on it (and those of the contacts cover
    // rest* and contact*)
    if (changed.found("identity"))
    {
        changed = wordList(1, "identity");
    }
    masterFirst();
    FatalErrorInFunction
        << "The files of time " << time.timeName() << " are not as dustFoam"
        << " has written them: ";
    for (const word& field : changed)
    {
        const fileName file
        (
            field == "ledger"
          ? "uniform"/cloud::prefix/name()/outputProperties_.name()
          : cloud::prefix/name()/field
        );
        FatalError
            << (&field == &changed.first() ? "" : ", ") << file.c_str();
    }
    FatalError
        << nl << "    They were changed or damaged, or a tool has rounded them"
        << " (writeFormat ascii needs writePrecision 17)." << nl
        << "    Restore them, or start from another time; to take them as they"
        << " are, delete checksums in uniform/lagrangian/" << name() << '/'
        << outputProperties_.name() << exit(FatalError);
}


void Foam::dustCloud::adoptParcels()
{
    // No run of ours wrote these parcels: they count as injected, with
    // identities of our own
    const label offset = Pstream::myProcNo();
    labelList sizes(Pstream::nProcs(), Zero);
    sizes[offset] = size();
    Pstream::listCombineGather(sizes, plusEqOp<label>());
    Pstream::listCombineScatter(sizes);

    const label total = sum(sizes);
    if (!total)
    {
        return;
    }
    const label material =
        dem_->properties.defaultMaterial(particleProperties_, "dustMaterial");

    for (label proci = 0; proci < offset; ++proci)
    {
        nextId_ += sizes[proci];
    }
    for (dustParcel& p : *this)
    {
        p.origProc() = 0;
        p.origId() = nextId_++;
        p.material() = material;
        p.rho() = dem_->properties.density(material);
    }
    nextId_ = total;

    injected_.count = nextId_;
    injected_.mass = returnReduce(massInSystem(), sumOp<scalar>());
    dem_->ofMaterial(dem_->properties.name(material)).injected = injected_;
}


void Foam::dustCloud::readMaterials(const dictionary& ledger)
{
    const dustProperties& properties = dem_->properties;
    const wordList then(ledger.get<wordList>("materials"));
    labelList now(then.size());
    forAll(then, i)
    {
        now[i] =
            properties.dustMaterials().found(then[i])
          ? properties.index(then[i])
          : -1;
    }

    for (dustParcel& p : *this)
    {
        if (p.material() < 0 || p.material() >= then.size())
        {
            FatalErrorInFunction
                << fieldIOobject("material", IOobject::NO_READ).objectPath()
                << ": particle " << p.origProc() << ':' << p.origId()
                << " is of material " << p.material() << nl
                << "    allowed: 0 to " << then.size() - 1
                << ", the materials of the ledger" << nl
                << "    Restore it, or start from another time"
                << exit(FatalError);
        }
        const label material = now[p.material()];
        if (material < 0)
        {
            dustProperties::error
            (
                particleProperties_,
                "materials",
                "time " + mesh_.time().timeName() + " has particles of "
              + then[p.material()]
              + ", and no material with a density has that name",
                then[p.material()] + " with its density, besides "
              + dustProperties::listed(properties.dustMaterials())
            );
        }
        p.material() = material;
    }
}


void Foam::dustCloud::readWalls()
{
    demData& d = *dem_;
    d.wallsThen =
        outputProperties_.subOrEmptyDict("ledger")
       .lookupOrDefault<wordList>("walls", wordList());

    const auto& patches = d.system->walls().patches;

    for (const word& name : d.wallsThen)
    {
        int now = -1;
        for (std::size_t i = 0; i < patches.size(); ++i)
        {
            if (name == patches[i].name)
            {
                now = int(i);
            }
        }
        d.wallNow.push_back(now);
    }
    d.ended = labelList(d.wallsThen.size(), Zero);
}


void Foam::dustCloud::closeWalls()
{
    demData& d = *dem_;

    forAll(d.ended, i)
    {
        const label n = returnReduce(d.ended[i], sumOp<label>());
        if (n)
        {
            Info<< "Warning: there is no wall patch " << d.wallsThen[i]
                << " any more: " << n << " contacts with it ended, their"
                << " particles are awake" << nl << endl;
        }
    }
    d.wallsThen.clear();
    d.ended.clear();
    d.wallNow.clear();
}


// ************************************************************************* //
