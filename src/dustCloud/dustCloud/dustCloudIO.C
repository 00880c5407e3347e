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
#include "masterFirst.H"
#include "dustSnapshot.H"
#include "contactWriter.H"
#include "loadFiles.H"
#include "nearestWallFaces.H"
#include "parcelChecksums.H"

#include "wallPolyPatch.H"
#include "OStringStream.H"
#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Counters of each material, by its name
template<class MaterialTally>
static dictionary stored(const HashTable<MaterialTally>& tallies)
{
    dictionary all;
    for (const word& name : tallies.sortedToc())
    {
        const MaterialTally& t = tallies[name];
        dictionary dict;
        dict.set("injected", t.injected.count);
        dict.set("injectedMass", t.injected.mass);
        dict.set("escaped", t.escaped.count);
        dict.set("escapedMass", t.escaped.mass);
        all.set(name, dict);
    }
    return all;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::readCounters(const dictionary& ledger)
{
    ledger.readEntry("injected", injected_.count);
    ledger.readEntry("injectedMass", injected_.mass);
    ledger.readEntry("refused", refused_.count);
    ledger.readEntry("refusedMass", refused_.mass);
    ledger.readEntry("nextId", nextId_);
    dem_->step.read(ledger, gasState());

    for (const entry& e : ledger.subDict("ofMaterial"))
    {
        demData::materialTally& t = dem_->ofMaterial(e.keyword());
        e.dict().readEntry("injected", t.injected.count);
        e.dict().readEntry("injectedMass", t.injected.mass);
        e.dict().readEntry("escaped", t.escaped.count);
        e.dict().readEntry("escapedMass", t.escaped.mass);
    }

    for (const entry& e : ledger.subDict("escaped"))
    {
        const label patchi = mesh_.boundaryMesh().findPatchID(e.keyword());
        tally& t =
            patchi >= 0 && patchi < escaped_.size()
          ? escaped_[patchi]
          : escapedBefore_(e.keyword());

        e.dict().readEntry("count", t.count);
        e.dict().readEntry("mass", t.mass);
    }
}


void Foam::dustCloud::checkCounters() const
{
    const label expected = injected_.count - escaped().count;
    const label found = returnReduce(size(), sumOp<label>());

    if (found != expected)
    {
        masterFirst();
        FatalErrorInFunction
            << "The files of time " << mesh_.time().timeName()
            << " do not belong together: " << outputProperties_.objectPath()
            << " tells of " << expected << " particles ("
            << injected_.count << " injected, " << escaped().count
            << " escaped), but "
            << "lagrangian/" << name() << " holds " << found << nl
            << "    Restore lagrangian/" << name() << " (of every rank), or"
            << " start from another time; to start without particles, delete "
            << "uniform/lagrangian/" << name() << ", too" << exit(FatalError);
    }
}


Foam::word Foam::dustCloud::gasState() const
{
    dictionary dict;
    dict.set("U", parcelChecksums::of(U_.primitiveField()));
    dict.set("rho", gMax(rho_.primitiveField()));
    dict.set("mu", gMax(mu_.primitiveField()));
    dict.set("g", g_.value());
    dict.set("forces", subModelProperties_.subDict("particleForces").toc());
    return parcelChecksums::of(dict);
}


void Foam::dustCloud::storeCounters()
{
    // The injectors store theirs when they print them
    #if OPENFOAM >= 2212
    const auto level = messageStream::level;
    messageStream::level = 0;
    injectors_.info();
    messageStream::level = level;
    #else
    OStringStream ignored;
    injectors_.info(ignored);
    #endif

    dictionary ledger;
    ledger.set("version", ledgerVersion);
    ledger.set("timeIndex", mesh_.time().timeIndex());
    ledger.set("time", mesh_.time().value());
    ledger.set("injected", injected_.count);
    ledger.set("injectedMass", injected_.mass);
    ledger.set("refused", refused_.count);
    ledger.set("refusedMass", refused_.mass);
    ledger.set("nextId", nextId_);
    ledger.set("coupling", word(twoWay_ ? "twoWay" : "oneWay"));
    ledger.set("gas", word(gasFrozen_ ? "frozen" : "solved"));
    dem_->step.store(ledger, gasState());
    stiffening::store
    (
        ledger,
        dem_->properties,
        dem_->system->materials().softening().ratio
    );

    wordList walls;
    for (const label patchi : dem_->wallPatches)
    {
        walls.append(mesh_.boundaryMesh()[patchi].name());
    }
    ledger.set("walls", walls);

    wordList materials;
    for (const dem::Material& m : dem_->properties.materials())
    {
        materials.append(word(m.name, false));
    }
    ledger.set("materials", materials);

    ledger.set("ofMaterial", stored(dem_->ofMaterial));

    dictionary escaped;
    const auto store = [&escaped](const word& name, const tally& t)
    {
        if (t.count)
        {
            dictionary patch;
            patch.set("count", t.count);
            patch.set("mass", t.mass);
            escaped.set(name, patch);
        }
    };
    forAll(escaped_, patchi)
    {
        store(mesh_.boundaryMesh()[patchi].name(), escaped_[patchi]);
    }
    for (const word& name : escapedBefore_.sortedToc())
    {
        store(name, escapedBefore_[name]);
    }
    ledger.set("escaped", escaped);

    // Last, so that a file that was cut short has no end
    outputProperties_.remove("ledger");
    outputProperties_.add("ledger", ledger);

    dictionary checksums(parcelChecksums::of(*this, dem_->step.underWay()));
    checksums.set("ledger", parcelChecksums::of(outputProperties_));
    dictionary& stored = outputProperties_.subDict("ledger");
    stored.add("checksums", checksums);
    stored.add("complete", true);
}


void Foam::dustCloud::writeDeposit() const
{
    const dustSnapshot& state = snapshot();

    contactWriter::write
    (
        mesh_.time(),
        mesh_.time().globalPath()/"postProcessing"/"contacts",
        state
    );

    // Deposited mass per area: each particle to the wall face that is nearest
    // to where it touches
    label n = 0;
    for (const auto& p : state.particles)   // on the master
    {
        n += p.patch >= 0;
    }
    labelList patches(n);
    pointField places(n);
    scalarList masses(n);
    n = 0;
    for (const auto& p : state.particles)
    {
        if (p.patch >= 0)
        {
            patches[n] = p.patch;
            places[n] = p.at;
            masses[n] = p.mass;
            ++n;
        }
    }
    Pstream::scatter(patches);
    Pstream::scatter(places);
    Pstream::scatter(masses);

    volScalarField field
    (
        IOobject
        (
            "depositedMass",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar(dimMass/dimArea, Zero)
    );

    const nearestWallFaces nearest(mesh_, patches, places);
    forAll(masses, i)
    {
        if (nearest.face[i] >= 0)
        {
            const label patchi = patches[i];
            const label facei = nearest.face[i];
            field.boundaryFieldRef()[patchi][facei] +=
                masses[i]/mesh_.magSf().boundaryField()[patchi][facei];
        }
    }

    field.write();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dustCloud::writeObject
(
    #if OPENFOAM >= 2006
    IOstreamOption streamOpt,
    #else
    IOstream::streamFormat fmt,
    IOstream::versionNumber ver,
    IOstream::compressionType cmp,
    #endif
    const bool valid
) const
{
    const stopwatch watch;

    // Writing fills buffers and counters, but changes no physics
    dustCloud& self = const_cast<dustCloud&>(*this);

    self.bringUp();
    for (dustParcel& p : self)
    {
        const std::vector<double> state
        (
            dem_->system->packState(std::size_t(p.demIndex()))
        );
        p.blob().setSize(label(state.size()));
        std::copy(state.begin(), state.end(), p.blob().begin());
        if (dem_->step.underWay())
        {
            self.packLoad(p);
        }
    }

    // Of a neck, the first 6 digits of a place know nothing
    const unsigned int precision = IOstream::defaultPrecision();
    IOstream::defaultPrecision(max(precision, 17u));

    #if OPENFOAM >= 2006
    const bool ok =
        KinematicCloud<Cloud<dustParcel>>::writeObject(streamOpt, valid);
    #else
    const bool ok =
        KinematicCloud<Cloud<dustParcel>>::writeObject(fmt, ver, cmp, valid);
    #endif
    if (dem_->step.underWay())
    {
        loadFiles::write(*this);
    }

    self.storeCounters();
    #if OPENFOAM >= 2006
    outputProperties_.writeObject
    (
        IOstreamOption(IOstream::ASCII, mesh_.time().writeCompression()),
        true
    );
    #else
    outputProperties_.writeObject
    (
        IOstream::ASCII,
        IOstream::currentVersion,
        mesh_.time().writeCompression(),
        true
    );
    #endif

    IOstream::defaultPrecision(precision);

    for (dustParcel& p : self)
    {
        p.blob().clear();
    }

    writeDeposit();

    dem_->ioSeconds += watch.seconds();
    return ok;
}


// ************************************************************************* //
