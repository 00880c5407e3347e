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
#include "dustPatchInjection.H"
#include "injectionRate.H"
#include "injectorPast.H"
#include "modelTable.H"

#include "OStringStream.H"
#include "Tuple2.H"
#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

//- A parcel that wants to be added, as every rank knows it
struct Foam::dustCloud::candidate
{
    point x;
    scalar d;
    scalar nParticle;
    label injector;
    label number;       // within this injection
    label rank;         // on which it is
    label index;        // there
};


//- What it overlaps
struct Foam::dustCloud::obstacle
{
    scalar overlap;
    string what;
};


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::prepareInsertion()
{
    demData& d = *dem_;
    d.insertion.reset(new dustInsertion(mesh_));

    // One that is new at a restart gets identities of its own
    label last = max(injectors_.size() - 1, injectorPast::last(outputProperties_));
    for (const dustParcel& p : *this)
    {
        last = max(last, p.origProc() - 1);
    }
    reduce(last, maxOp<label>());

    wordList names(injectors_.size());
    forAll(injectors_, injectori)
    {
        names[injectori] = injectors_[injectori].modelName();
    }
    injectorPast::tellGone(outputProperties_, names, mesh_.time());

    const bool restarted = outputProperties_.found("ledger");
    forAll(injectors_, injectori)
    {
        auto* i = dynamic_cast<dustPatchInjection*>(&injectors_[injectori]);
        if (!i)
        {
            continue;
        }
        if (i->key() < 0)
        {
            i->setKey
            (
                !restarted ? injectori
              : i->known()
              ? injectorPast::place(outputProperties_, i->modelName())
              : ++last
            );
        }
        if (i->active())
        {
            d.insertion->add(*i, injectori);
        }
    }
    d.insertion->check(gasFrozen_);
}


void Foam::dustCloud::countInjected(const label material, const scalar d)
{
    const scalar m = dem_->properties.mass(material, d);
    injected_.add(m);
    dem_->ofMaterial(dem_->properties.name(material)).injected.add(m);
}


void Foam::dustCloud::insert(const scalar dt)
{
    demData& d = *dem_;
    const stopwatch watch;
    const auto newcomers =
        d.insertion->enter(*d.system, d.periodic, d.now, dt);

    DynamicList<dustParcel*> starting;
    for (const dustInsertion::newcomer& n : newcomers)
    {
        const label material = d.injectorMaterials[n.injector];
        countInjected(material, n.d);
        if (n.celli < 0)
        {
            continue;
        }
        dustParcel* pPtr = new dustParcel(mesh_, n.x, n.celli);
        dustParcel& p = *pPtr;
        p.typeId() = injectors_[n.injector].injectorID();
        p.nParticle() = 1;
        p.material() = material;
        p.rho() = d.properties.density(material);
        p.d() = n.d;
        p.U() = n.U;
        p.origProc() =
            dynamic_cast<const dustPatchInjection&>
            (
                injectors_[n.injector]
            ).key() + 1;
        p.origId() = n.number;
        p.state() = dustParcel::airborne;

        // It is born later
        p.age() = -n.delay;
        addParticle(pPtr);
        starting.append(pPtr);
    }

    if (newcomers.size())
    {
        settleStarts(starting);
        addArrivals();
    }
    d.injectionSeconds += watch.seconds();
}


Foam::string Foam::dustCloud::leftOut() const
{
    const auto part = [](const label n, const char* why)
    {
        return n ? "; " + Foam::name(n) + why : string();
    };
    return
        part(refused_.count, " refused at injection")
      + part
        (
            dem_->insertion->withoutRoom(),
            " left out for want of room at injection"
        )
      + part
        (
            dem_->insertion->withoutFlow(),
            " left out: due while no gas flowed in"
        );
}


bool Foam::dustCloud::callInjectors
(
    dustParcel::trackingData& td,
    const bool streams
)
{
    // Which injector made which parcel; until it has a DEM particle, demIndex
    // holds -2 - injector
    td.relocating = false;
    td.displacing = streams;
    bool any = false;

    forAll(injectors_, injectori)
    {
        auto& injector = injectors_[injectori];
        if
        (
            isA<dustPatchInjection>(injector)
         || modelTable::streams(injector.modelType()) != streams
        )
        {
            continue;
        }
        any = true;

        // For numbers that are drawn by lot; parcels have keys of their own,
        // see completedModels.H
        rndGen_ = Random(seed(injectori, mesh_.time().timeIndex(), 1));
        dem_->injectedMaterial = dem_->injectorMaterials[injectori];

        injector.inject(*this, td);

        for (dustParcel& p : *this)
        {
            if (p.state() == dustParcel::fresh && p.demIndex() == -1)
            {
                p.demIndex() = -2 - injectori;
            }
        }
    }
    td.displacing = false;
    return any;
}


Foam::List<Foam::dustCloud::candidate> Foam::dustCloud::gatherCandidates
(
    const UList<dustParcel*>& fresh
) const
{
    const label width = 7;
    DynamicList<scalar> mine;
    for (const dustParcel* p : fresh)
    {
        mine.append(p->x().x());
        mine.append(p->x().y());
        mine.append(p->x().z());
        mine.append(p->d());
        mine.append(p->nParticle());
        mine.append(-2 - p->demIndex());
        mine.append(p->origId());
    }

    List<scalarList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = mine;
    #if OPENFOAM >= 2206
    Pstream::allGatherList(all);
    #else
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    #endif

    DynamicList<candidate> candidates;
    forAll(all, proci)
    {
        for (label i = 0; i < all[proci].size(); i += width)
        {
            const scalar* v = &all[proci][i];
            candidates.append
            (
                candidate
                {
                    point(v[0], v[1], v[2]), v[3], v[4], label(v[5]),
                    label(v[6]), proci, i/width
                }
            );
        }
    }

    // As they would come on one rank
    std::stable_sort
    (
        candidates.begin(),
        candidates.end(),
        [](const candidate& a, const candidate& b)
        {
            return
                a.injector != b.injector
              ? a.injector < b.injector
              : a.number < b.number;
        }
    );
    return List<candidate>(candidates);
}


Foam::List<Foam::dustCloud::obstacle> Foam::dustCloud::findObstacles
(
    const UList<candidate>& candidates
) const
{
    boundBox box;
    scalar largest = 0;
    for (const candidate& c : candidates)
    {
        box.add(c.x);
        largest = max(largest, 0.5*c.d);
    }
    const dem::Box places{toVec3(box.min()), toVec3(box.max())};
    const dem::Entrance entrance
    (
        dem_->system->entrance(places, 0, largest, 0)
    );

    // With walls and with the particles of every rank. All say the same
    typedef Tuple2<scalar, string> overlapOf;
    List<overlapOf> found(candidates.size());
    forAll(candidates, i)
    {
        const candidate& c = candidates[i];
        std::string wall;
        const scalar overlap =
            entrance.overlap(toVec3(c.x), 0.5*c.d, 0, wall);
        found[i] = overlapOf
        (
            overlap, wall.empty() ? "another particle" : "patch " + wall
        );
    }
    const auto larger = [](overlapOf& x, const overlapOf& y)
    {
        if
        (
            y.first() > x.first()
         || (y.first() == x.first() && y.second() > x.second())
        )
        {
            x = y;
        }
    };
    Pstream::listCombineGather(found, larger);
    Pstream::listCombineScatter(found);

    List<obstacle> obstacles(candidates.size());
    forAll(obstacles, i)
    {
        obstacles[i] = {found[i].first(), found[i].second()};
    }
    return obstacles;
}


bool Foam::dustCloud::admitted
(
    const candidate& c,
    const obstacle& o
)
{
    const auto& injector = injectors_[c.injector];

    if (mag(c.nParticle - 1) > 1e-9)
    {
        FatalErrorInFunction
            << "Injector " << injector.modelName() << " made a parcel of "
            << c.nParticle << " particles, but each parcel must be one:"
            << " use parcelBasisType fixed and nParticle 1"
            << exit(FatalError);
    }

    const bool free = o.overlap <= 0.01*c.d;
    if (!free && injector.modelType() == "manualInjection")
    {
        OStringStream reason;
        reason
            << "the particle at " << c.x << ", diameter " << c.d
            << " m, overlaps " << o.what.c_str() << " by " << o.overlap
            << " m";
        dustProperties::error
        (
            subModelProperties_.subDict("injectionModels")
           .subDict(injector.modelName()),
            "positionsFile",
            reason.str(),
            "overlaps of at most 1 % of the diameter"
        );
    }

    const label material = dem_->injectorMaterials[c.injector];
    if (free)
    {
        countInjected(material, c.d);
    }
    else
    {
        refused_.add(dem_->properties.mass(material, c.d));
    }
    return free;
}


void Foam::dustCloud::admit
(
    const UList<candidate>& candidates,
    const UList<dustParcel*>& fresh
)
{
    const List<obstacle> obstacles(findObstacles(candidates));
    DynamicList<dustParcel*> starting;

    // Those of this injection among themselves
    static const std::vector<dem::Particle> nobody;
    static const dem::WallSearch noWalls{dem::Walls()};
    scalar largest = 0;
    for (const candidate& c : candidates)
    {
        largest = max(largest, 0.5*c.d);
    }
    dem::Entrance among
    (
        nobody,
        noWalls,
        dem_->periodic,
        {dem::Vec3::Zero(), dem::Vec3::Zero()},
        0,
        largest,
        0
    );

    forAll(candidates, i)
    {
        const candidate& c = candidates[i];

        // Only on its own rank
        dustParcel* pPtr =
            c.rank == Pstream::myProcNo() ? fresh[c.index] : nullptr;

        obstacle o(obstacles[i]);
        std::string wall;
        const scalar other = among.overlap(toVec3(c.x), 0.5*c.d, 0, wall);
        if (other > o.overlap)
        {
            o.overlap = other;
            o.what = "another particle of the same injection";
        }

        if (!admitted(c, o))
        {
            if (pPtr)
            {
                deleteParticle(*pPtr);
            }
            continue;
        }

        among.enter(toVec3(c.x), dem::Vec3::Zero(), 0.5*c.d, 0);
        if (pPtr)
        {
            pPtr->origProc() = 0;
            pPtr->origId() = nextId_;
            pPtr->state() = dustParcel::airborne;
            pPtr->demIndex() = -1;
            starting.append(pPtr);
        }
        ++nextId_;
    }

    settleStarts(starting);
    addArrivals();

    // They may need a shorter one
    dem_->step.end();
}


void Foam::dustCloud::inject(dustParcel::trackingData& td, const bool streams)
{
    demData& d = *dem_;
    const stopwatch watch;

    if (!callInjectors(td, streams))
    {
        return;
    }

    // Every rank decides on the parcels of all ranks, so that all agree
    DynamicList<dustParcel*> fresh;
    for (dustParcel& p : *this)
    {
        if (p.state() == dustParcel::fresh)
        {
            fresh.append(&p);
        }
    }
    if (!returnReduce(fresh.size(), sumOp<label>()))
    {
        d.injectionSeconds += watch.seconds();
        return;
    }
    admit(gatherCandidates(fresh), fresh);

    if (streams && Pstream::parRun())
    {
        // On their way some have left this rank
        DynamicList<dustParcel*> all;
        for (dustParcel& p : *this)
        {
            all.append(&p);
        }
        follow(all, td, solution_.trackTime());
        countEscapes();
    }

    d.injectionSeconds += watch.seconds();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dustCloud::setParcelThermoProperties
(
    parcelType& parcel,
    const scalar
)
{
    parcel.material() = dem_->injectedMaterial;
    parcel.rho() = dem_->properties.density(dem_->injectedMaterial);
}


Foam::label Foam::dustCloud::seed(const label a, const label b, const label c)
{
    // splitmix64 (S. Vigna, public domain) over the three keys: neighbouring
    // keys must not give neighbouring seeds, as Rand48 would show it
    uint64_t h = 0;
    for (const label key : {a, b, c})
    {
        h += 0x9e3779b97f4a7c15ULL + uint64_t(uint32_t(key));
        h = (h ^ (h >> 30))*0xbf58476d1ce4e5b9ULL;
        h = (h ^ (h >> 27))*0x94d049bb133111ebULL;
        h ^= h >> 31;
    }
    return label(h & 0x7fffffff);
}


void Foam::dustCloud::addArrivals()
{
    DynamicList<dustParcel*> arrivals;
    for
    (
        auto iter = IDLList<dustParcel>::rbegin();
        iter.good() && iter().demIndex() < 0;
        ++iter
    )
    {
        arrivals.append(&iter());
    }
    for (label i = arrivals.size() - 1; i >= 0; --i)
    {
        addArrival(*arrivals[i]);
    }
}


void Foam::dustCloud::readInjectors()
{
    demData& d = *dem_;
    const dictionary& injectors =
        subModelProperties_.subDict("injectionModels");

    // OpenFOAM puts one that does nothing where there is none
    d.injectorMaterials.setSize(injectors_.size(), -1);
    forAll(injectors_, i)
    {
        const dictionary* dictPtr = injectors.findDict(injectors_[i].modelName());
        if (dictPtr && dictPtr->get<word>("type") != "none")
        {
            d.injectorMaterials[i] = d.properties.material(*dictPtr);
        }
    }

    for (const entry& e : injectors)
    {
        if (!modelTable::injects(e))
        {
            continue;
        }
        d.sizes.addInjector(e.dict());

        d.massFlow += injectionRate(e.dict(), d.properties).largestMass();
    }
}


// ************************************************************************* //
