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
#include "modelTable.H"

#include "OStringStream.H"
#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <cstring>
#include <unordered_map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A parcel that wants to be added, as every rank knows it
struct candidate
{
    point x;
    scalar d;
    scalar nParticle;
    label injector;
    label numbered;     // has its identity already
};


//- Spheres in a grid of cells as wide as the largest: for overlaps among those
//  that are added in the same step
class sphereGrid
{
    scalar width_;
    std::unordered_multimap<int64_t, std::pair<point, scalar>> spheres_;

    int64_t key(const int64_t i, const int64_t j, const int64_t k) const
    {
        return (i*73856093) ^ (j*19349663) ^ (k*83492791);
    }

    int64_t cell(const scalar x) const
    {
        return int64_t(std::floor(x/width_));
    }

public:

    explicit sphereGrid(const scalar width)
    :
        width_(max(width, VSMALL))
    {}

    void insert(const point& x, const scalar d)
    {
        spheres_.emplace
        (
            key(cell(x.x()), cell(x.y()), cell(x.z())),
            std::make_pair(x, d)
        );
    }

    //- Largest overlap with those inserted
    scalar overlap(const point& x, const scalar d) const
    {
        scalar largest = -GREAT;
        for (int i = -1; i <= 1; ++i)
        {
            for (int j = -1; j <= 1; ++j)
            {
                for (int k = -1; k <= 1; ++k)
                {
                    const auto range = spheres_.equal_range
                    (
                        key
                        (
                            cell(x.x()) + i,
                            cell(x.y()) + j,
                            cell(x.z()) + k
                        )
                    );
                    for (auto s = range.first; s != range.second; ++s)
                    {
                        largest = max
                        (
                            largest,
                            0.5*(d + s->second.second)
                          - mag(x - s->second.first)
                        );
                    }
                }
            }
        }
        return largest;
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::inject(dustParcel::trackingData& td, const bool streams)
{
    demData& d = *dem_;
    const stopwatch watch;

    // Which injector made which parcel; until it has a DEM particle, demIndex
    // holds -2 - injector
    td.relocating = false;
    td.displacing = streams;

    forAll(injectors_, injectori)
    {
        if (modelTable::streams(injectors_[injectori].modelType()) != streams)
        {
            continue;
        }

        // Keyed, so that a restart goes on as if there had been none; and for
        // what is drawn for each parcel, see setParcelThermoProperties
        injectionKey_ = seed(injectori, mesh_.time().timeIndex(), 1);
        rndGen_ = Random(injectionKey_);

        injectors_[injectori].inject(*this, td);

        for (dustParcel& p : *this)
        {
            if (p.state() == dustParcel::fresh && p.demIndex() == -1)
            {
                p.demIndex() = -2 - injectori;
            }
        }
    }

    td.displacing = false;

    // Every rank decides on the parcels of all ranks, so that all agree
    const label width = 7;
    DynamicList<scalar> mine;
    DynamicList<dustParcel*> fresh;

    for (dustParcel& p : *this)
    {
        if (p.state() == dustParcel::fresh)
        {
            const label injectori = -2 - p.demIndex();
            const bool numbered =
                injectors_[injectori].modelType() == "dustPatchInjection";

            if (numbered)
            {
                p.origProc() = injectori + 1;
            }
            fresh.append(&p);
            mine.append(p.x().x());
            mine.append(p.x().y());
            mine.append(p.x().z());
            mine.append(p.d());
            mine.append(p.nParticle());
            mine.append(injectori);
            mine.append(numbered);
        }
    }

    if (!returnReduce(mine.size(), sumOp<label>()))
    {
        d.injectionSeconds += watch.seconds();
        return;
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
    label myStart = 0;
    scalar largest = 0;

    forAll(all, proci)
    {
        if (proci == Pstream::myProcNo())
        {
            myStart = candidates.size();
        }
        for (label i = 0; i < all[proci].size(); i += width)
        {
            const scalar* v = &all[proci][i];
            candidates.append
            (
                candidate
                {
                    point(v[0], v[1], v[2]), v[3], v[4], label(v[5]),
                    label(v[6])
                }
            );
            largest = max(largest, v[3]);
        }
    }

    // With walls and with the particles of every rank
    scalarList overlaps(candidates.size());
    List<string> whats(candidates.size());
    forAll(candidates, i)
    {
        std::string what;
        overlaps[i] = d.system->overlapAt
        (
            toVec3(candidates[i].x),
            0.5*candidates[i].d,
            what
        );
        whats[i] = what;
    }
    scalarList myOverlaps(overlaps);
    Pstream::listCombineGather(overlaps, maxEqOp<scalar>());
    Pstream::listCombineScatter(overlaps);

    sphereGrid grid(largest);
    DynamicList<dustParcel*> starting;

    forAll(candidates, i)
    {
        const candidate& c = candidates[i];

        // Only on its own rank
        dustParcel* pPtr =
            i >= myStart && i < myStart + fresh.size()
          ? fresh[i - myStart]
          : nullptr;

        const auto& injector = injectors_[c.injector];

        if (mag(c.nParticle - 1) > 1e-9)
        {
            FatalErrorInFunction
                << "Injector " << injector.modelName() << " made a parcel of "
                << c.nParticle << " particles, but each parcel must be one:"
                << " use parcelBasisType fixed and nParticle 1"
                << exit(FatalError);
        }

        scalar overlap = overlaps[i];
        string what =
            myOverlaps[i] == overlap && whats[i].size()
          ? "patch " + whats[i]
          : string("another particle");

        const scalar among = grid.overlap(c.x, c.d);
        if (among > overlap)
        {
            overlap = among;
            what = "another particle of the same injection";
        }

        const scalar mass =
            density_*constant::mathematical::pi/6*pow3(c.d);

        if (overlap > 0.01*c.d)
        {
            if (injector.modelType() == "manualInjection")
            {
                OStringStream reason;
                reason
                    << "the particle at " << c.x << ", diameter " << c.d
                    << " m, overlaps " << what.c_str() << " by " << overlap
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
            ++refused_.count;
            refused_.mass += mass;

            if (pPtr)
            {
                deleteParticle(*pPtr);
            }
            continue;
        }

        grid.insert(c.x, c.d);
        ++injected_.count;
        injected_.mass += mass;

        if (pPtr)
        {
            if (!c.numbered)
            {
                pPtr->origProc() = 0;
                pPtr->origId() = nextId_;
            }
            pPtr->state() = dustParcel::airborne;
            pPtr->demIndex() = -1;
            starting.append(pPtr);
        }
        if (!c.numbered)
        {
            ++nextId_;
        }
    }

    settleStarts(starting);
    addArrivals();

    if (streams && Pstream::parRun())
    {
        // On their way some have left this rank
        td.relocating = true;
        Cloud<dustParcel>::move(*this, td, solution_.trackTime());
        td.relocating = false;

        if (returnReduce(blocked_.size(), sumOp<label>()))
        {
            settleBlocked();
        }
        removeLeavers();
        addArrivals();
        countEscapes();
    }

    d.injectionSeconds += watch.seconds();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dustCloud::setParcelThermoProperties
(
    parcelType& parcel,
    const scalar lagrangianDt
)
{
    parcel.rho() = density_;

    // Size and velocity are drawn next, on the parcel's rank only: from its
    // time of injection, which no other of its injector has
    label key[2];
    static_assert(sizeof(key) >= sizeof(lagrangianDt), "32 bit each at least");
    std::memcpy(key, &lagrangianDt, sizeof(lagrangianDt));
    rndGen_ = Random(seed(injectionKey_, key[0], key[1]));
}


Foam::scalar Foam::dustCloud::overlapAt
(
    const point& x,
    const scalar d,
    word& what
) const
{
    std::string wall;
    const scalar mine = dem_->system->overlapAt(toVec3(x), 0.5*d, wall);
    const scalar overlap = returnReduce(mine, maxOp<scalar>());

    what = mine == overlap && wall.size() ? word(wall) : "another particle";

    return overlap;
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


// ************************************************************************* //
