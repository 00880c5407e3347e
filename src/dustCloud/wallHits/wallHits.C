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

#include "wallHits.H"

#include "nearestWallFaces.H"
#include "startCells.H"

#include "globalIndex.H"
#include "polyMeshTetDecomposition.H"
#include "PstreamBuffers.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<std::pair<Foam::wallHits::hit, Foam::label>>
Foam::wallHits::atFaces() const
{
    std::vector<std::pair<hit, label>> result;
    const globalIndex numbers(label(hits_.size()));
    if (!numbers.size())
    {
        return result;
    }

    // The same lists on all ranks, each with its own part of them
    labelList patches(numbers.size(), labelMin);
    pointField places(numbers.size(), point::max);
    for (label i = 0; i < label(hits_.size()); ++i)
    {
        patches[numbers.toGlobal(i)] = hits_[i].patch;
        places[numbers.toGlobal(i)] = hits_[i].where;
    }
    Pstream::listCombineGather(patches, maxEqOp<label>());
    Pstream::listCombineScatter(patches);
    Pstream::listCombineGather(places, minEqOp<point>());
    Pstream::listCombineScatter(places);

    const labelList face(nearestWallFaces(mesh_, patches, places).face);
    labelList owner(face.size(), -1);
    forAll(face, i)
    {
        if (face[i] >= 0)
        {
            owner[i] = Pstream::myProcNo();
        }
    }
    Pstream::listCombineGather(owner, maxEqOp<label>());
    Pstream::listCombineScatter(owner);

    const auto facei = [&](const label number)
    {
        return mesh_.boundaryMesh()[patches[number]].start() + face[number];
    };
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    for (label proci = 0; proci < Pstream::nProcs(); ++proci)
    {
        labelList theirs;
        for (label i = 0; i < label(hits_.size()); ++i)
        {
            if (owner[numbers.toGlobal(i)] == proci)
            {
                theirs.append(i);
            }
        }
        if (proci == Pstream::myProcNo())
        {
            for (const label i : theirs)
            {
                result.push_back({hits_[i], facei(numbers.toGlobal(i))});
            }
        }
        else if (theirs.size())
        {
            UOPstream toOwner(proci, buffers);
            toOwner << theirs.size();
            for (const label i : theirs)
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
            result.push_back
            ({
                {
                    time, patches[number], places[number],
                    dustParcel(mesh_, fromRank)
                },
                facei(number)
            });
        }
    }
    return result;
}


void Foam::wallHits::put
(
    dustParcel& p,
    const label facei,
    const point& where
) const
{
    const label celli = mesh_.faceOwner()[facei];
    tetIndices tet;
    pointHit nearest(point::max);
    nearest.setDistance(GREAT);
    for
    (
        const tetIndices& t
      : polyMeshTetDecomposition::faceTetIndices(mesh_, facei, celli)
    )
    {
        const pointHit candidate(t.faceTri(mesh_).nearestPoint(where));
        if (candidate.distance() < nearest.distance())
        {
            nearest = candidate;
            tet = t;
        }
    }
    p.relocate
    (
        startCells::justInside(mesh_, nearest.rawPoint(), celli),
        celli
    );
    p.face() = facei;
    p.tetFace() = tet.face();
    p.tetPt() = tet.tetPt();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<Foam::dustParcel> Foam::wallHits::take()
{
    std::vector<std::pair<hit, label>> here(atFaces());
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

    std::vector<dustParcel> result;
    for (const label i : order)
    {
        const hit& h = here[i].first;
        result.push_back(h.parcel);
        put(result.back(), here[i].second, h.where);
    }
    return result;
}


// ************************************************************************* //
