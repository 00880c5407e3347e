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

#include "nearestWallFaces.H"

#include "indexedOctree.H"
#include "PstreamReduceOps.H"
#include "Random.H"
#include "treeDataFace.H"

#include <memory>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nearestWallFaces::nearestWallFaces
(
    const polyMesh& mesh,
    const UList<label>& patches,
    const UList<point>& points
)
:
    face(points.size(), -1),
    distance(points.size(), GREAT)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        std::unique_ptr<indexedOctree<treeDataFace>> tree;

        forAll(points, i)
        {
            if (pp.empty() || patches[i] != pp.index())
            {
                continue;
            }
            if (!tree)
            {
                Random random(0);
                tree.reset
                (
                    new indexedOctree<treeDataFace>
                    (
                        treeDataFace(false, pp),
                        treeBoundBox(pp.localPoints()).extend(random, 1e-3),
                        8,
                        10,
                        3
                    )
                );
            }
            const pointIndexHit hit(tree->findNearest(points[i], sqr(GREAT)));
            if (hit.hit())
            {
                face[i] = hit.index();
                distance[i] = mag(hit.hitPoint() - points[i]);
            }
        }
    }

    const scalarList mine(distance);
    Pstream::listCombineGather(distance, minEqOp<scalar>());
    Pstream::listCombineScatter(distance);

    labelList rank(points.size(), Pstream::nProcs());
    forAll(rank, i)
    {
        if (face[i] >= 0 && mine[i] == distance[i])
        {
            rank[i] = Pstream::myProcNo();
        }
    }
    Pstream::listCombineGather(rank, minEqOp<label>());
    Pstream::listCombineScatter(rank);
    forAll(rank, i)
    {
        if (rank[i] != Pstream::myProcNo())
        {
            face[i] = -1;
        }
    }
}


// ************************************************************************* //
