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


Description
    An error that every rank finds is said once: the master says it and ends them
    all, while the others wait a second. A rank that is alone speaks after that.
\*---------------------------------------------------------------------------*/

#include "openEnds.H"

#include "boundBox.H"
#include "SubField.H"
#include "PstreamReduceOps.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::openEnds::distance
(
    const point& x,
    const scalar range,
    const polyPatch& pp,
    const bool beyond
) const
{
    scalar nearest = GREAT;
    boundBox box(pp.localPoints(), false);
    box.min() -= range*vector::one;
    box.max() += range*vector::one;
    if (pp.empty() || !box.contains(x))
    {
        return nearest;
    }
    forAll(pp, i)
    {
        if (!beyond || ((x - pp.faceCentres()[i]) & pp.faceAreas()[i]) > 0)
        {
            nearest = min
            (
                nearest,
                pp[i].nearestPoint(x, mesh_.points()).distance()
            );
        }
    }
    return nearest;
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
    scalarList wall(n, GREAT);
    labelList best(n, -1);

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.coupled())
        {
            continue;
        }
        const bool isWall = isA<wallPolyPatch>(pp);
        forAll(points, i)
        {
            const scalar d = distance(points[i], range[i], pp, !isWall);
            if (isWall)
            {
                wall[i] = min(wall[i], d);
            }
            else if (d < open[i])
            {
                open[i] = d;
                best[i] = pp.index();
            }
        }
    }

    scalarList openOfAll(open);
    Pstream::listCombineGather(openOfAll, minEqOp<scalar>());
    Pstream::listCombineScatter(openOfAll);
    Pstream::listCombineGather(wall, minEqOp<scalar>());
    Pstream::listCombineScatter(wall);
    forAll(points, i)
    {
        // A corner that they share is as near on both, to the last digits
        if
        (
            open[i] > openOfAll[i]
         || openOfAll[i] > wall[i] + 1e-9*range[i]
        )
        {
            best[i] = -1;
        }
    }
    Pstream::listCombineGather(best, maxEqOp<label>());
    Pstream::listCombineScatter(best);
    return best;
}


// ************************************************************************* //
