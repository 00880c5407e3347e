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
#include "dragRange.H"
#include "dustSnapshot.H"
#include "formatted.H"
#include "runSummary.H"
#include "sumOverRanks.H"

#include "DispersionModel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of all ranks; times of this one
static dem::StepReport ofAllRanks(dem::StepReport r)
{
    for
    (
        std::int64_t* n :
        {
            &r.contactSteps, &r.contactUpdates, &r.freeFlights,
            &r.aggregateFlights, &r.repeats, &r.touches, &r.followerTouches,
            &r.separations, &r.sleeps, &r.wakes
        }
    )
    {
        *n = std::int64_t(returnReduce(scalar(*n), sumOp<scalar>()));
    }
    for
    (
        dem::Sum* x : {&r.touchSpeed, &r.touchSpeedSquare, &r.energyRemovedByRest}
    )
    {
        *x = sumOverRanks(*x);
    }
    reduce(r.maxOverlapOverDiameter, maxOp<scalar>());
    reduce(r.minStepsPerContact, minOp<scalar>());
    reduce(r.maxStepOverBound, maxOp<scalar>());
    return r;
}


//- A drag law that does not hold where the particles are now: which, and how
//  many of them. Empty if all is well. Collective.
static std::string denseDragRemark
(
    const dustCloud& cloud,
    const dictionary& forces
)
{
    const fvMesh& mesh = cloud.mesh();
    scalar largest = 0;
    for (const dustParcel& p : cloud)
    {
        largest = max(largest, p.d());
    }
    reduce(largest, maxOp<scalar>());

    const diffusiveSmoothing smoothing(mesh, 3*largest);
    cellShares place(mesh);
    cellShares::sums<scalar> volume(mesh);
    for (const dustParcel& p : cloud)
    {
        place.moveTo(p.x(), p.cell());
        place.add(volume, p.volume());
    }
    place.close(volume);
    const scalarField alpha(1 - smoothing(volume.cells/mesh.V()));

    for (const entry& e : forces)
    {
        const dragRange* range = dragRange::find(e.keyword());
        if (!range)
        {
            continue;
        }
        label n = 0;
        scalar lowest = 1;
        for (const dustParcel& p : cloud)
        {
            n += alpha[p.cell()] < range->minVoid;
            lowest = min(lowest, alpha[p.cell()]);
        }
        reduce(n, sumOp<label>());
        reduce(lowest, minOp<scalar>());
        if (n)
        {
            return dragRange::voidFractionRemark
            (
                e.keyword(), lowest, formatted("%d particles in dense places", n)
            );
        }
    }
    return "";
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::setBalance
(
    runSummary& summary,
    tally& airborne,
    tally& deposited
)
{
    std::map<label, tally> patches;
    HashTable<tally> flying, held;
    std::map<int64_t, label> members;
    for (const auto& p : snapshot().particles)
    {
        const word material(dem_->properties.name(p.material));
        (p.patch < 0 ? airborne : deposited).add(p.mass);
        (p.patch < 0 ? flying : held)(material).add(p.mass);
        if (p.patch >= 0)
        {
            patches[p.patch].add(p.mass);
        }
        ++members[p.cluster];
    }
    for (const auto& m : members)
    {
        ++summary.aggregates[m.second];
    }

    const auto row = [&](const std::string& name, const tally& t)
    {
        summary.balance.push_back({name, t.count, t.mass});
    };
    const auto patch = [&](const label i)
    {
        return mesh_.boundaryMesh()[i].name();
    };
    const wordList materials(dem_->ofMaterial.sortedToc());
    const auto rowsOf = [&](const auto& amount)
    {
        for (label i = 0; materials.size() > 1 && i < materials.size(); ++i)
        {
            row("  of " + materials[i], amount(materials[i]));
        }
    };
    row("injected", injected_);
    rowsOf([&](const word& m) { return dem_->ofMaterial[m].injected; });
    row("airborne", airborne);
    rowsOf([&](const word& m) { return flying(m); });
    row("deposited", deposited);
    rowsOf([&](const word& m) { return held(m); });
    for (const auto& p : patches)
    {
        row("  on " + patch(p.first), p.second);
    }
    row("escaped", escaped());
    rowsOf([&](const word& m) { return dem_->ofMaterial[m].escaped; });
    forAll(escaped_, patchi)
    {
        if (escaped_[patchi].count)
        {
            row("  through " + patch(patchi), escaped_[patchi]);
        }
    }
    for (const word& name : escapedBefore_.sortedToc())
    {
        row("  through " + name + ", now gone", escapedBefore_[name]);
    }
    row("refused at injection", refused_);
}


void Foam::dustCloud::printVerdict
(
    const runSummary& summary,
    const tally& airborne,
    const tally& deposited
) const
{
    const demData& d = *dem_;

    Info<< nl << "Verdict: ";
    if (summary.closes)
    {
        Info<< "balance closes (" << injected_.count << " injected = "
            << airborne.count << " airborne + " << deposited.count
            << " deposited + " << escaped().count << " escaped)";
    }
    else
    {
        Info<< "BALANCE DOES NOT CLOSE";
    }
    if (!injected_.count && injectors_.size())
    {
        Info<< "; NOTHING WAS INJECTED";
    }
    Info<< leftOut().c_str();
    if (d.changes.times())
    {
        Info<< formatted
            (
                "; chi changed %d times, %.3g -> %.3g",
                d.changes.times(), d.changes.first(),
                d.system->materials().softening().ratio
            ).c_str();
    }
    if (!d.marginSteps && !d.overlapSteps && !d.ratioBelowLimit)
    {
        Info<< "; all limits kept";
    }
    else
    {
        Info<< "; limits exceeded: margin in " << d.marginSteps
            << " gas steps (smallest "
            << (
                   d.smallestMargin < GREAT
                 ? formatted("%.3g", d.smallestMargin)
                 : std::string("-")
               ).c_str()
            << "), overlap in " << d.overlapSteps << ", chi "
            << (d.ratioBelowLimit ? "below" : "within") << " its limit"
            << (d.properties.limits().stiffen ? ", then stiffened" : "");
    }
    const label followers = label(summary.work.followerTouches);
    if (followers && !d.dispersion)
    {
        // Neither inertia nor a force: their radius, or an error of the gas
        // velocity at the walls
        Info<< "; " << followers << " touches of walls by particles"
            << " that follow the gas (tau_p v_n < r): interception, or numerics"
            << " if it does not stay with a finer mesh";
    }
    Info<< nl << endl;
}


void Foam::dustCloud::countEscapes()
{
    demData& d = *dem_;
    const auto addAll = [](tally& all, const tally& mine)
    {
        all.count += returnReduce(mine.count, sumOp<label>());
        all.mass += returnReduce(mine.mass, sumOp<scalar>());
    };
    forAll(d.escaping, patchi)
    {
        addAll(escaped_[patchi], d.escaping[patchi]);
    }
    d.escaping = tally();
    for (const dustSizes::kind& kind : d.sizes.kinds())
    {
        addAll
        (
            d.ofMaterial(d.properties.name(kind.material)).escaped,
            d.escapingOf[kind.material]
        );
    }
    d.escapingOf = tally();

    List<scalarList> diameters(Pstream::nProcs());
    diameters[Pstream::myProcNo()] = d.escapingDiameters;
    #if OPENFOAM >= 2206
    Pstream::allGatherList(diameters);
    #else
    Pstream::gatherList(diameters);
    Pstream::scatterList(diameters);
    #endif
    d.escapingDiameters.clear();
    for (const scalarList& ofRank : diameters)
    {
        escapedInStep_.append(ofRank);
    }
}


void Foam::dustCloud::checkBalance() const
{
    labelList n(2);
    n[0] = this->size();
    n[1] = label(dem_->system->size());
    Pstream::listCombineGather(n, plusEqOp<label>());
    Pstream::listCombineScatter(n);

    if (injected_.count != n[0] + escaped().count || n[0] != n[1])
    {
        masterFirst();
        FatalErrorInFunction
            << "Time " << mesh_.time().timeName() << ": the particle balance"
            << " does not close: injected " << injected_.count
            << ", in the cloud " << n[0] << ", in the DEM system " << n[1]
            << ", escaped " << escaped().count << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dustCloud::noteEscape(dustParcel& p, const label patchi)
{
    demData& d = *dem_;
    d.escaping[patchi].add(p.mass());
    d.escapingOf[p.material()].add(p.mass());
    d.escapingDiameters.append(p.d());

    if (p.demIndex() >= 0)
    {
        d.parcels.leaves(p);
    }
}


void Foam::dustCloud::summarise()
{
    checkBalance();

    demData& d = *dem_;
    runSummary summary;
    const label inCloud = returnReduce(this->size(), sumOp<label>());
    tally airborne, deposited;
    setBalance(summary, airborne, deposited);

    const dem::StepReport& w = d.totals;
    summary.parts =
    {
        {"gas", d.gasSeconds},
        {"injection", d.injectionSeconds},
        {"gas forces", d.forceSeconds},
        {"DEM: contacts", w.secondsContact},
        {"DEM: search", w.secondsSearch},
        {"DEM: free flight", w.secondsFlight},
        {
            "DEM: exchange and waiting",
            d.demSeconds - w.secondsContact - w.secondsSearch - w.secondsFlight
        },
        {"tracking", d.trackSeconds},
        {"checks and progress", d.checkSeconds},
        {"writing", d.ioSeconds}
    };
    summary.seconds = d.running.seconds();
    summary.work = ofAllRanks(w);
    summary.particleSteps = d.particleSteps;
    summary.offMesh = returnReduce(d.offMesh, sumOp<label>());
    summary.imbalance = twoWay_ ? exchangePtr_->imbalance() : -1;
    summary.smallestMargin = d.smallestMargin;
    summary.marginSteps = d.marginSteps;
    summary.chi = d.system->materials().softening().ratio;
    summary.firstChi = d.changes.first();
    summary.chiChanges = d.changes.times();
    summary.changes = d.changes.done();
    summary.overlapSteps = d.overlapSteps;

    if (keepsEnergyLedger())
    {
        summary.remarks += runSummary::energyText(energyLedger()) + "\n";
    }
    const std::string dense
    (
        denseDragRemark(*this, subModelProperties_.subDict("particleForces"))
    );
    if (!dense.empty())
    {
        summary.remarks += "    Warning: " + dense + "\n";
    }

    summary.closes =
        !Pstream::master() || airborne.count + deposited.count == inCloud;

    summary.print(Info());
    if (Pstream::master())
    {
        summary.write(mesh_.time().globalPath()/"postProcessing/summary.csv");
    }
    printVerdict(summary, airborne, deposited);

    if (!summary.closes)
    {
        masterFirst();
        FatalErrorInFunction
            << "The particle balance does not close: in the cloud " << inCloud
            << ", airborne " << airborne.count << ", deposited "
            << deposited.count << exit(FatalError);
    }
}


// ************************************************************************* //
