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
#include "wallHits.H"

#include "nearestWallFaces.H"
#include "startCells.H"

#include "globalIndex.H"
#include "polyMeshTetDecomposition.H"
#include "PstreamBuffers.H"
#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The same list on all ranks, of which each has its own part
template<class T, class Combine>
static void complete(List<T>& list, const Combine& combine)
{
    Pstream::listCombineGather(list, combine);
    Pstream::listCombineScatter(list);
}


//- Let face() be this one, with the tetrahedron next to the place
static void put
(
    dustParcel& p,
    const polyMesh& mesh,
    const label facei,
    const point& where
)
{
    const label celli = mesh.faceOwner()[facei];
    tetIndices tet;
    pointHit nearest(point::max);
    nearest.setDistance(GREAT);
    for
    (
        const tetIndices& t
      : polyMeshTetDecomposition::faceTetIndices(mesh, facei, celli)
    )
    {
        const pointHit candidate(t.faceTri(mesh).nearestPoint(where));
        if (candidate.distance() < nearest.distance())
        {
            nearest = candidate;
            tet = t;
        }
    }
    p.relocate
    (
        startCells::justInside(mesh, nearest.rawPoint(), celli),
        celli
    );
    p.face() = facei;
    p.tetFace() = tet.face();
    p.tetPt() = tet.tetPt();
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<std::pair<Foam::wallHits::hit, Foam::label>>
Foam::wallHits::atFaces(const polyMesh& mesh) const
{
    std::vector<std::pair<hit, label>> result;
    const globalIndex numbers(label(hits_.size()));
    if (!numbers.size())
    {
        return result;
    }

    labelList patches(numbers.size(), labelMin);
    pointField places(numbers.size(), point::max);
    for (label i = 0; i < label(hits_.size()); ++i)
    {
        patches[numbers.toGlobal(i)] = hits_[i].patch;
        places[numbers.toGlobal(i)] = hits_[i].where;
    }
    complete(patches, maxEqOp<label>());
    complete(places, minEqOp<point>());

    labelList face(nearestWallFaces(mesh, patches, places).face);
    labelList owner(face.size(), -1);
    forAll(face, i)
    {
        if (face[i] >= 0)
        {
            owner[i] = Pstream::myProcNo();
            face[i] += mesh.boundaryMesh()[patches[i]].start();
        }
    }
    complete(owner, maxEqOp<label>());

    List<labelList> away(Pstream::nProcs());
    for (label i = 0; i < label(hits_.size()); ++i)
    {
        const label number = numbers.toGlobal(i);
        if (owner[number] == Pstream::myProcNo())
        {
            result.push_back({hits_[i], face[number]});
        }
        else
        {
            away[owner[number]].append(i);
        }
    }
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(away, proci)
    {
        if (away[proci].size())
        {
            UOPstream toOwner(proci, buffers);
            toOwner << away[proci].size();
            for (const label i : away[proci])
            {
                toOwner
                    << numbers.toGlobal(i) << hits_[i].time << hits_[i].parcel;
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
        for (label n = readLabel(fromRank); n > 0; --n)
        {
            const label number = readLabel(fromRank);
            const scalar time = readScalar(fromRank);
            const dustParcel p(mesh, fromRank);
            const hit h{time, patches[number], places[number], p};
            result.push_back({h, face[number]});
        }
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallHits::add
(
    const dustParcel& p,
    const scalar time,
    const label patchi,
    const point& where
)
{
    hits_.push_back({time, patchi, where, p});
}


void Foam::wallHits::take
(
    std::vector<dem::WallImpact>& impacts,
    const awakeParcels& parcels,
    const labelUList& patches,
    const dem::Periodic& periodic
)
{
    for (const dem::WallImpact& i : impacts)
    {
        dustParcel p(parcels[i.index]);
        p.U() = toVector(i.v);
        p.omega() = toVector(i.omega);
        p.setX(toVector(periodic.wrapped(i.x)));
        add(p, i.time, patches[i.patch], p.x() + 0.5*p.d()*toVector(i.n));
    }
    impacts.clear();
}


void Foam::wallHits::tell(dustCloud& cloud)
{
    if (!cloud.functions().size())
    {
        return;
    }
    const polyMesh& mesh = cloud.mesh();
    std::vector<std::pair<hit, label>> here(atFaces(mesh));
    hits_.clear();

    labelList order(identity(label(here.size())));
    std::stable_sort(order.begin(), order.end(), [&](label i, label j)
    {
        const hit& a = here[i].first;
        const hit& b = here[j].first;
        return
            std::make_tuple(a.time, a.parcel.origProc(), a.parcel.origId())
          < std::make_tuple(b.time, b.parcel.origProc(), b.parcel.origId());
    });

    for (const label i : order)
    {
        dustParcel& p = here[i].first.parcel;
        put(p, mesh, here[i].second, here[i].first.where);
        const polyPatch& pp = mesh.boundaryMesh()[p.patch()];
        #if OPENFOAM >= 2312
        dustParcel::trackingData td(cloud);
        const bool keep = cloud.functions().postPatch(p, pp, td);
        #else
        bool keep = true;
        cloud.functions().postPatch(p, pp, keep);
        #endif
        if (!keep)
        {
            FatalErrorInFunction
                << "A cloud function wants to remove particle " << p.origProc()
                << ':' << p.origId() << " that has touched patch " << pp.name()
                << ", which is not supported" << exit(FatalError);
        }
    }
}


// ************************************************************************* //
