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
#include "openEnds.H"
#include "parcelTracking.H"
#include "startCells.H"

#include "globalIndex.H"
#include "PstreamBuffers.H"
#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::bringUp(dustParcel& p)
{
    const demData& d = *dem_;
    if (p.since() == d.clock)
    {
        return;
    }

    // Gas step by gas step: a restart in between must not change a bit
    const scalar* end =
        std::upper_bound(d.ends.cbegin(), d.ends.cend(), p.since());
    for (; end != d.ends.cend(); ++end)
    {
        p.age() += *end - p.since();
        p.since() = *end;
    }
    const scalar rested = d.clock - p.since();
    p.age() += rested;
    p.since() = d.clock;

    // In two-way coupling all are brought up in each gas step
    if (twoWay_)
    {
        const dem::GasLoad& load =
            d.system->gasLoad(std::size_t(p.demIndex()));
        p.given() +=
            toVector(rested*(load.Sp*load.Uc + load.Su))
          - rested*p.nonCoupled();
        p.response() += rested*load.Sp;
        p.held() = true;
    }
}


void Foam::dustCloud::bringUp()
{
    for (dustParcel& p : *this)
    {
        bringUp(p);
    }
    dem_->ends.clear();
}


void Foam::dustCloud::takeMotion
(
    const UList<dustParcel*>& moved,
    const scalar dt
)
{
    demData& d = *dem_;
    dem::System& system = *d.system;

    for (dustParcel* pPtr : moved)
    {
        dustParcel& p = *pPtr;
        const std::size_t index = std::size_t(p.demIndex());
        const dem::Particle& particle = system.particle(index);
        const bool resting = system.resting(index);
        if
        (
            resting && p.state() == dustParcel::resting
         && p.x() == toVector(particle.x)
        )
        {
            continue;
        }
        bringUp(p);

        vector kick(Zero);
        if (d.brownian && !d.step.underWay())
        {
            if (!system.inContact(index))
            {
                kick = p.mass()*p.kick();
                system.kick(index, toVec3(kick));
            }
            p.kick() = Zero;
        }

        if (twoWay_)
        {
            const dem::GasExchange& e = system.gasExchange(index);
            const scalar flown = min(dt, dt + p.age());
            p.given() += toVector(e.impulse) + kick - flown*p.nonCoupled();
            p.response() = p.response()*e.memory + e.response;
            p.held() = e.held;
            p.owed() = Zero;
        }

        p.setX(toVector(particle.x));
        p.U() = toVector(particle.v);
        p.omega() = toVector(particle.omega);
        p.age() += dt;
        p.since() = d.now;
        p.state() =
            resting ? dustParcel::resting
          : system.inContact(index) ? dustParcel::inContact
          : dustParcel::airborne;

        if (resting && (!p.loaded() || twoWay_))
        {
            // Without what the gas owed
            p.loaded() = false;
            d.parcels.settled(p);
        }
    }
    d.clock = d.now;
}


void Foam::dustCloud::follow
(
    const UList<dustParcel*>& moved,
    dustParcel::trackingData& td,
    const scalar dt
)
{
    parcelTracking(*this, td).move(moved, dt);

    if (returnReduce(blocked_.size(), sumOp<label>()))
    {
        settleBlocked();
    }
    dem_->parcels.removeLeavers(*dem_->system);
    if (Pstream::parRun())
    {
        addArrivals();
    }
}


void Foam::dustCloud::settleBlocked()
{
    // Where are they? Every rank looks for all
    List<List<point>> all(Pstream::nProcs());
    List<point>& mine = all[Pstream::myProcNo()];
    mine.setSize(blocked_.size());
    forAll(blocked_, i)
    {
        mine[i] = blocked_[i]->x();
    }
    #if OPENFOAM >= 2206
    Pstream::allGatherList(all);
    #else
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    #endif

    List<labelList> owner(all.size());
    List<labelList> cell(all.size());
    forAll(all, proci)
    {
        owner[proci].setSize(all[proci].size(), -1);
        cell[proci].setSize(all[proci].size(), -1);
        forAll(all[proci], i)
        {
            cell[proci][i] = mesh_.findCell(all[proci][i]);
            if (cell[proci][i] >= 0)
            {
                owner[proci][i] = Pstream::myProcNo();
            }
        }
        Pstream::listCombineGather(owner[proci], maxEqOp<label>());
        Pstream::listCombineScatter(owner[proci]);
        forAll(all[proci], i)
        {
            if (owner[proci][i] != Pstream::myProcNo())
            {
                cell[proci][i] = -1;
            }
        }
        Pstream::listCombineGather(cell[proci], maxEqOp<label>());
        Pstream::listCombineScatter(cell[proci]);
    }

    DynamicList<dustParcel*> found;
    DynamicList<dustParcel*> outside;
    labelList owners;
    labelList cells;
    const labelList& myOwners = owner[Pstream::myProcNo()];
    const labelList& theirCells = cell[Pstream::myProcNo()];
    forAll(blocked_, i)
    {
        if (myOwners[i] < 0)
        {
            outside.append(blocked_[i]);
        }
        else
        {
            found.append(blocked_[i]);
            owners.append(myOwners[i]);
            cells.append(theirCells[i]);
        }
    }
    blocked_.clear();
    handOver(found, owners, cells);
    settleOutside(outside);
}


void Foam::dustCloud::settleOutside(const UList<dustParcel*>& outside)
{
    const globalIndex numbers(outside.size());
    if (!numbers.size())
    {
        return;
    }
    // The same list on all ranks, each with its own part of it
    pointField places(numbers.size(), point::max);
    scalarList range(numbers.size(), GREAT);
    forAll(outside, i)
    {
        const dustParcel& p = *outside[i];
        places[numbers.toGlobal(i)] = p.x();
        range[numbers.toGlobal(i)] = 2*mag(way(p.position(), p.x())) + p.d();
    }
    Pstream::listCombineGather(places, minEqOp<vector>());
    Pstream::listCombineScatter(places);
    Pstream::listCombineGather(range, minEqOp<scalar>());
    Pstream::listCombineScatter(range);

    const labelList patches(openEnds(mesh_).patches(places, range));
    forAll(outside, i)
    {
        dustParcel& p = *outside[i];
        const label patchi = patches[numbers.toGlobal(i)];
        if (patchi < 0)
        {
            // Behind a facet of a curved wall. The cell stays the last one; the
            // next step looks again.
            ++dem_->offMesh;
            continue;
        }
        if (functions().size())
        {
            dem_->hits.add(p, dem_->now, patchi, p.x());
        }
        noteEscape(p, patchi);
        giveLast(p);
        deleteParticle(p);
    }
}


void Foam::dustCloud::handOver
(
    const UList<dustParcel*>& parcels,
    const labelList& owner,
    const labelList& cell
)
{
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);

    for (label proci = 0; proci < Pstream::nProcs(); ++proci)
    {
        DynamicList<label> cells;
        forAll(parcels, i)
        {
            if (owner[i] == proci && proci != Pstream::myProcNo())
            {
                cells.append(cell[i]);
            }
        }
        if (cells.empty())
        {
            continue;
        }

        UOPstream toOwner(proci, buffers);
        toOwner << labelList(cells);
        forAll(parcels, i)
        {
            if (owner[i] == proci)
            {
                leaveRank(*parcels[i]);
                toOwner << *parcels[i];
                deleteParticle(*parcels[i]);
            }
        }
    }

    labelList received;
    buffers.finishedSends(received);

    forAll(received, proci)
    {
        if (proci == Pstream::myProcNo() || !received[proci])
        {
            continue;
        }
        UIPstream fromRank(proci, buffers);
        const labelList cells(fromRank);
        for (const label celli : cells)
        {
            dustParcel* pPtr = new dustParcel(mesh_, fromRank);
            pPtr->relocate
            (
                startCells::justInside(mesh_, pPtr->x(), celli),
                celli
            );
            pPtr->moved() = false;
            addParticle(pPtr);
        }
    }
}


void Foam::dustCloud::settleStarts(const UList<dustParcel*>& starting)
{
    DynamicList<dustParcel*> between;
    DynamicList<point> places;
    startCells cells(mesh_);

    for (dustParcel* pPtr : starting)
    {
        if (cells.onFace(pPtr->x(), pPtr->cell()))
        {
            between.append(pPtr);
            places.append(pPtr->x());
        }
    }
    if (!returnReduce(between.size(), sumOp<label>()))
    {
        return;
    }

    cells.find(pointField(places));
    forAll(between, i)
    {
        if
        (
            cells.owner()[i] == Pstream::myProcNo()
         && cells.cell()[i] != between[i]->cell()
        )
        {
            const label celli = cells.cell()[i];
            between[i]->relocate
            (
                startCells::justInside(mesh_, places[i], celli),
                celli
            );
        }
    }
    handOver(between, cells.owner(), cells.cell());
}


void Foam::dustCloud::motion(dustParcel::trackingData& td)
{
    demData& d = *dem_;

    d.gasStep = dem::StepReport();

    // Not the sum of all steps: a restarted run must have the same time
    const scalar end = mesh_.time().value();
    d.now = end - solution_.trackTime();
    if (twoWay_)
    {
        bringUp();
        exchangePtr_->reset();
        for (dustParcel& p : *this)
        {
            p.since() = d.now;
            p.given() = Zero;
            p.response() = 0;
        }
        d.clock = d.now;
    }
    if (!gasFrozen_)
    {
        d.insertion->newGas(end);
    }

    while (d.now < end)
    {
        const scalar left = end - d.now;
        const bool begins = !d.step.underWay();
        if (begins)
        {
            d.step.begin(nextParticleStep(left));
            ++d.particleSteps;
        }
        const scalar whole = d.step.left();
        const scalar dt = d.step.go(left);
        d.system->setTime(d.now);
        insert(dt);

        try
        {
            const stopwatch forcing;
            setGasLoads(td, whole, begins);
            d.forceSeconds += forcing.seconds();

            const stopwatch moving;
            d.gasStep.add(d.system->advance(dt, d.step.left(), begins));
            d.hits.take
            (
                d.gasStep.wallImpacts, d.parcels, d.wallPatches, d.periodic
            );
            d.demSeconds += moving.seconds();
        }
        catch (const dem::numericalError& e)
        {
            FatalErrorInFunction
                << "The DEM system cannot go on: " << e.what()
                << exit(FatalError);
        }

        const stopwatch tracking;
        d.now = dt < left ? d.now + dt : end;
        const UList<dustParcel*>& moved = d.parcels.changed(*d.system);
        takeMotion(moved, dt);
        follow(moved, td, dt);
        d.trackSeconds += tracking.seconds();
    }

    if (!twoWay_)
    {
        d.ends.append(d.now);
    }
    d.totals.add(d.gasStep);
    countEscapes();
    d.hits.tell(*this);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::dustCloud::way(const point& from, const point& to) const
{
    return toVector(dem_->periodic.nearest(toVec3(to - from)));
}


void Foam::dustCloud::findBlocked(dustParcel& p)
{
    const label celli = mesh_.findCell(p.x());

    if (celli >= 0)
    {
        p.relocate(p.x(), celli);
    }
    else
    {
        blocked_.append(&p);
    }
}


void Foam::dustCloud::leaveRank(dustParcel& p)
{
    // A second hop within one step: packed already
    if (p.demIndex() < 0)
    {
        return;
    }

    const std::vector<double> state
    (
        dem_->system->packState(std::size_t(p.demIndex()))
    );
    p.blob().setSize(label(state.size()));
    std::copy(state.begin(), state.end(), p.blob().begin());

    packLoad(p);
    dem_->parcels.leaves(p);
}


void Foam::dustCloud::packLoad(dustParcel& p) const
{
    const dem::GasLoad& load =
        dem_->system->gasLoad(std::size_t(p.demIndex()));
    auto& v = p.load();
    v[dustParcel::loadSp] = load.Sp;
    v[dustParcel::loadSpOmega] = load.SpOmega;
    for (int i = 0; i < 3; ++i)
    {
        v[dustParcel::loadUc + i] = load.Uc[i];
        v[dustParcel::loadSu + i] = load.Su[i];
        v[dustParcel::loadOmegaC + i] = load.omegaC[i];
        v[dustParcel::loadKick + i] = p.kick()[direction(i)];
    }
    v[dustParcel::loadBehind] =
        dem_->system->behind(std::size_t(p.demIndex()));
}


void Foam::dustCloud::unpackLoad(dustParcel& p)
{
    const auto& v = p.load();
    dem::GasLoad load;
    load.Sp = v[dustParcel::loadSp];
    load.SpOmega = v[dustParcel::loadSpOmega];
    for (int i = 0; i < 3; ++i)
    {
        load.Uc[i] = v[dustParcel::loadUc + i];
        load.Su[i] = v[dustParcel::loadSu + i];
        load.omegaC[i] = v[dustParcel::loadOmegaC + i];
        p.kick()[direction(i)] = v[dustParcel::loadKick + i];
    }
    p.loadHolds() = p.loadHolds() && dem_->step.underWay();
    dem_->system->setGasLoad(std::size_t(p.demIndex()), load);
}


// ************************************************************************* //
