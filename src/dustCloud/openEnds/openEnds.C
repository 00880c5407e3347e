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

#include "openEnds.H"

#include "boundBox.H"
#include "dustParcel.H"
#include "SubField.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::openEnds::nearest
(
    const polyPatch& pp,
    const UList<point>& points,
    const UList<scalar>& range,
    const bool beyond,
    UList<scalar>& distance,
    UList<label>& patch
) const
{
    if (pp.empty())
    {
        return;
    }
    const boundBox box(pp.localPoints(), false);
    forAll(points, i)
    {
        const point& x = points[i];
        const vector margin(range[i]*vector::one);
        if (!boundBox(box.min() - margin, box.max() + margin).contains(x))
        {
            continue;
        }
        forAll(pp, facei)
        {
            if
            (
                beyond
             && ((x - pp.faceCentres()[facei]) & pp.faceAreas()[facei]) <= 0
            )
            {
                continue;
            }
            const scalar d =
                pp[facei].nearestPoint(x, mesh_.points()).distance();
            if (d < distance[i])
            {
                distance[i] = d;
                patch[i] = pp.index();
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::openEnds::patches
(
    const UList<point>& points,
    const UList<scalar>& range
) const
{
    const label n = points.size();
    scalarList open(n, GREAT);
    labelList best(n, -1);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!pp.coupled() && !dustParcel::endsAt(pp))
        {
            nearest(pp, points, range, true, open, best);
        }
    }
    const scalarList mine(open);
    Pstream::listCombineGather(open, minEqOp<scalar>());
    Pstream::listCombineScatter(open);

    // Mostly there is none: a facet of a curved wall
    if (!n || min(open) >= GREAT)
    {
        return labelList(n, -1);
    }

    scalarList wall(n, GREAT);
    labelList unused(n, -1);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (dustParcel::endsAt(pp))
        {
            nearest(pp, points, range, false, wall, unused);
        }
    }
    Pstream::listCombineGather(wall, minEqOp<scalar>());
    Pstream::listCombineScatter(wall);

    forAll(points, i)
    {
        // A corner that they share is as near on both, to the last digits
        if (mine[i] > open[i] || open[i] > wall[i] + 1e-9*range[i])
        {
            best[i] = -1;
        }
    }
    Pstream::listCombineGather(best, maxEqOp<label>());
    Pstream::listCombineScatter(best);
    return best;
}


// ************************************************************************* //
