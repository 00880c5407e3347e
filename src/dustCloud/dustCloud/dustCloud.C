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
#include "dustSnapshot.H"
#include "caseCheck.H"
#include "dictionaryLines.H"
#include "givenTwice.H"
#include "dustKeywords.H"
#include "ledgerCheck.H"
#include "modelTable.H"
#include "parcelPlaces.H"
#include "patchWalls.H"
#include "runForecast.H"
#include "sumOverRanks.H"
#include "untrapped.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dustCloud, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- OpenFOAM's own exchange is not used; ours and the forces need schemes.
//  cloudSolution has no other door than its dictionary
static void ownExchange(cloudSolution& cloud, const dictionary& forces)
{
    dictionary& solution = const_cast<dictionary&>(cloud.dict());
    solution.set("coupled", "false");
    cloud.read();

    modelTable::addSchemes
    (
        forces,
        solution.subDict("interpolationSchemes")
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::word& Foam::dustCloud::checkInput
(
    const word& cloudName,
    const volScalarField& rho,
    const volVectorField& U
)
{
    const fvMesh& mesh = rho.mesh();

    autoPtr<untrapped> reading(new untrapped);
    const IOdictionary properties
    (
        IOobject
        (
            cloudName + "Properties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    reading.clear();
    dictionaryLines::share(properties);
    givenTwice::check(properties);

    // Throws away what it reads: only the messages matter here. All keywords
    // are checked by it.
    const dustProperties materials(properties);

    const dictionary& subModels = properties.subDict("subModels");

    caseCheck::density(properties, materials);
    modelTable::check(subModels, materials, mesh);
    const caseCheck injectors(subModels.subDict("injectionModels"), mesh);
    injectors.sizes();
    injectors.rates(materials);
    injectors.positions();
    checkDispersion(subModels, U);
    ledgerCheck::check(mesh, cloudName, ledgerVersion);

    return cloudName;
}


void Foam::dustCloud::checkSolution() const
{
    if (!solution_.active() || solution_.steadyState())
    {
        dustProperties::error
        (
            particleProperties_.subDict("solution"),
            solution_.active() ? "transient" : "active",
            "is off, or system/fvSchemes has no transient ddtScheme",
            "active true; transient yes; and, for a frozen gas, too, a"
            " transient ddtScheme, for example Euler"
        );
    }
}


void Foam::dustCloud::checkGas() const
{
    forAll(U_, celli)
    {
        if (!dem::isFinite(toVec3(U_[celli])))
        {
            FatalErrorInFunction
                << "Gas field " << U_.name() << " is not finite at time "
                << mesh_.time().timeName() << " in cell " << celli << " at "
                << mesh_.C()[celli] << exit(FatalError);
        }
    }
}


void Foam::dustCloud::addArrival(dustParcel& p)
{
    dem::Particle particle;
    particle.id = p.id();
    particle.material = int(p.material());
    particle.radius = 0.5*p.d();
    particle.mass = p.mass();
    particle.x = toVec3(p.x());
    particle.v = toVec3(p.U());
    particle.omega = toVec3(p.omega());
    dem::System& system = *dem_->system;
    try
    {
        system.add
        (
            particle,
            p.age() < 0 ? -p.age() : -p.load()[dustParcel::loadBehind]
        );
        dem_->parcels.add(p);
        p.since() = dem_->clock;
        p.loaded() = false;
        unpackLoad(p);

        if (p.blob().size())
        {
            const std::vector<int> gone = system.unpackState
            (
                std::size_t(p.demIndex()),
                std::vector<double>(p.blob().begin(), p.blob().end()),
                dem_->wallNow
            );
            for (const int wall : gone)
            {
                ++dem_->ended[wall];
            }
            p.blob().clear();
        }
        if (system.resting(std::size_t(p.demIndex())))
        {
            dem_->parcels.settled(p);
        }
    }
    catch (const std::runtime_error& e)     // either of the DEM library
    {
        FatalErrorInFunction << "Particle " << p.origProc() << ':'
            << p.origId() << " at " << p.x() << ", diameter " << p.d()
            << " m, cannot be added: " << e.what() << exit(FatalError);
    }
}


Foam::scalar Foam::dustCloud::expectedMassLoading() const
{
    // Dust that is there over gas that is there
    const scalar gasMass = gSum(rho_.primitiveField()*mesh_.V().field());
    scalar loading = returnReduce(massInSystem(), sumOp<scalar>())/gasMass;

    // Dust over gas that flows in
    scalar gasFlow = 0;
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!patch.coupled())
        {
            const label i = patch.index();
            gasFlow += gSum
            (
                rho_.boundaryField()[i]
               *max(-(U_.boundaryField()[i] & patch.Sf()), scalar(0))
            );
        }
    }

    if (gasFlow > 0)
    {
        loading += dem_->massFlow/gasFlow;
    }

    return loading;
}


void Foam::dustCloud::decideCoupling()
{
    demData& d = *dem_;
    const dictionary& dict = particleProperties_;

    d.coupling = dustKeywords::wordOf(dict, "coupling");
    d.gas = dustKeywords::wordOf(dict, "gas");
    d.massLoadingLimit =
        dustKeywords::numberOf(dict, "couplingMassLoading");

    // A restart must not change what the run is
    const word coupled(ledgerCheck::entry(outputProperties_, "coupling"));
    const word gas(ledgerCheck::entry(outputProperties_, "gas"));
    const string asBefore("auto: as before the restart");

    if (d.coupling == "auto" && coupled.size())
    {
        twoWay_ = coupled == "twoWay";
        d.couplingReason = asBefore;
    }
    else if (d.coupling == "auto")
    {
        const scalar loading = expectedMassLoading();
        twoWay_ = loading > d.massLoadingLimit;
        d.couplingReason =
            "auto: mass loading " + Foam::name(loading)
          + (twoWay_ ? " above " : " below ")
          + Foam::name(d.massLoadingLimit) + " (couplingMassLoading)";
    }
    else
    {
        twoWay_ = d.coupling == "twoWay";
        d.couplingReason = "coupling " + d.coupling;
    }

    // A flow that comes from a solver is not uniform
    const scalar spread =
        mag(gMax(U_.primitiveField()) - gMin(U_.primitiveField()));

    if (d.gas == "auto" && !twoWay_ && gas.size())
    {
        gasFrozen_ = gas == "frozen";
        d.gasReason = asBefore;
    }
    else if (d.gas == "auto")
    {
        gasFrozen_ = !twoWay_ && spread > 1e-6*d.gasSpeed;
        d.gasReason =
            twoWay_ ? "auto: the gas feels the particles"
          : gasFrozen_
          ? "auto: one-way, and U at the start comes from a flow solver"
          : "auto: U at the start is uniform, so still to be solved";
    }
    else
    {
        gasFrozen_ = d.gas == "frozen";
        d.gasReason = "gas " + d.gas;
    }

    if (gasFrozen_ && twoWay_)
    {
        dustProperties::error
        (
            dict,
            "gas",
            "a frozen gas cannot feel the particles (" + d.couplingReason
          + ")",
            "gas frozen with coupling oneWay, or gas solved"
        );
    }

    if (!gasFrozen_)
    {
        d.step.end();
    }

    ownExchange(solution_, subModelProperties_.subDict("particleForces"));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dustCloud::dustCloud
(
    const word& cloudName,
    const volScalarField& rho,
    const volVectorField& U,
    const volScalarField& mu,
    const dimensionedVector& g,
    volScalarField& alphac
)
:
    KinematicCloud<Cloud<dustParcel>>
    (
        checkInput(cloudName, rho, U),
        rho,
        U,
        mu,
        g,
        false
    ),
    dem_(new demData(particleProperties_)),
    gasFrozen_(false),
    twoWay_(false),
    alphac_(alphac),
    denseDrag_(false),
    escaped_(mesh_.boundaryMesh().nNonProcessor()),
    nextId_(0),
    snapshotTimeIndex_(-1)
{
    checkSolution();
    demData& d = *dem_;
    d.escaping.setSize(escaped_.size());
    d.escapingOf.setSize(label(d.properties.materials().size()));

    checkGas();
    d.gasSpeed = returnReduce
    (
        max(mag(U_.primitiveField())()),
        maxOp<scalar>()
    );

    d.startTime = d.now = d.clock = mesh_.time().value();
    d.progressInterval =
        dustKeywords::numberOf(particleProperties_, "progressInterval");
    d.dispersion =
        subModelProperties_.get<word>("dispersionModel") != "none";
    findOwnForces();

    readParcels();
    parcelPlaces(*this).findAgain();
    readInjectors();

    if (d.properties.automaticRatio())
    {
        d.properties.setRatio(1);
    }
    dem::Walls walls
    (
        patchWalls::New(mesh_, particleProperties_, d.properties.table())
    );
    d.wallPatches = patchWalls::patches(walls, mesh_);

    scalar wanted = 1;
    try
    {
        wanted = stiffening::choose
        (
            *this, d.properties, d.advice, d.loads, d.sizes, walls,
            outputProperties_
        );
        d.system.reset
        (
            new dem::System
            (
                patchWalls::table(walls, d.properties.table()),
                d.properties.time(),
                d.comm.get()
            )
        );
        d.system->setWalls(std::move(walls));
        d.periodic = patchWalls::periodic(mesh_);
        if (d.periodic.on())
        {
            d.system->setPeriodic(d.periodic);
        }
    }
    catch (const dem::inputError& e)
    {
        dustProperties::error(particleProperties_, e);
    }

    decideCoupling();

    readWalls();
    addArrivals();
    closeWalls();
    d.changes.setFirst(d.properties.softening().ratio);
    if (wanted != d.properties.softening().ratio)
    {
        d.properties.setRatio(wanted);
        d.changes.change
        (
            *this, d.parcels, *d.system, wanted,
            "reducedStiffness/ratio is another one", d.totals.energy
        );
    }
    prepareInsertion();
    prepareExchange();

    printMaterials();
    printPlan();
    warnOfDispersion();
    caseCheck::calibration
    (
        particleProperties_.subDict("contact"),
        d.properties.softening().ratio, d.properties.automaticRatio()
    );
    const scalarList due
    (
        caseCheck(subModelProperties_.subDict("injectionModels"), mesh_).due
        (
            d.properties, U_
        )
    );
    runForecast(*this, *d.system, d.loads(), due).print(Info());
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::dustCloud::~dustCloud()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dustCloud::tally Foam::dustCloud::escaped() const
{
    tally sum;
    forAll(escaped_, i)
    {
        sum.count += escaped_[i].count;
        sum.mass += escaped_[i].mass;
    }
    forAllConstIters(escapedBefore_, iter)
    {
        sum.count += iter.val().count;
        sum.mass += iter.val().mass;
    }
    return sum;
}


Foam::scalar Foam::dustCloud::marginLimit() const
{
    return dem_->properties.limits().pullOffOverForce;
}


bool Foam::dustCloud::keepsEnergyLedger() const
{
    return dem_->properties.time().energyLedger;
}


dem::EnergyLedger Foam::dustCloud::energyLedger() const
{
    return sumOverRanks(dem_->totals.energy);
}


void Foam::dustCloud::evolve(const scalar gasSeconds)
{
    demData& d = *dem_;
    d.gasSeconds += gasSeconds;
    if (!solution_.canEvolve())
    {
        return;
    }

    if (!gasFrozen_)
    {
        checkGas();
    }

    // Building the interpolators costs more than a particle step
    if (!tdPtr_.valid())
    {
        dispersion().cacheFields(true);
        forces_.cacheFields(true);
        tdPtr_.reset(new dustParcel::trackingData(*this));
        if (twoWay_)
        {
            spreadVelocity();
        }

        for (dustParcel& p : *this)
        {
            p.loaded() = false;
        }
        d.parcels.newGas();
    }

    snapshotPtr_.reset();
    escapedInStep_.clear();
    #if OPENFOAM >= 2006
    functions_.preEvolve(*tdPtr_);
    #else
    functions_.preEvolve();
    #endif

    inject(*tdPtr_, false);
    motion(*tdPtr_);
    inject(*tdPtr_, true);
    updateVoidFraction();

    if (twoWay_)
    {
        closeExchange();
    }
    updateCellOccupancy();
    if (functions_.size())
    {
        bringUp();
    }
    #if OPENFOAM >= 2006
    functions_.postEvolve(*tdPtr_);
    #else
    functions_.postEvolve();
    #endif
    checkBalance();

    if (!gasFrozen_)
    {
        tdPtr_.clear();
        dispersion().cacheFields(false);
        forces_.cacheFields(false);
    }
    solution_.nextIter();
    const stopwatch checking;
    checkLimits();
    printProgress();
    d.checkSeconds += checking.seconds();
}


// ************************************************************************* //
