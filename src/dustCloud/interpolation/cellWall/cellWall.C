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

#include "cellWall.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Type Foam::cellWall<Type>::interpolate
(
    const vector& position,
    const label celli,
    const label
) const
{
    const polyMesh& mesh = this->pMesh_;
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    const Type& inside = this->psi_[celli];
    Type result = inside;
    scalar nearest = GREAT;

    for (const label facei : mesh.cells()[celli])
    {
        if (mesh.isInternalFace(facei))
        {
            continue;
        }
        const polyPatch& patch = patches[patches.whichPatch(facei)];
        if (!isA<wallPolyPatch>(patch))
        {
            continue;
        }

        // Not from the plane of the face, which may cut a cell that winds
        // round an edge of the wall
        const face& f = mesh.faces()[facei];
        const scalar here = f.nearestPoint(position, mesh.points()).distance();

        // Rounded, as the last bits of a cell's centre depend on the order of
        // its faces, and that on the decomposition
        const scalar centre = float
        (
            f.nearestPoint(mesh.cellCentres()[celli], mesh.points()).distance()
        );

        if (here < nearest*centre)
        {
            nearest = here/centre;
            const Type& wall =
                this->psi_.boundaryField()[patch.index()]
                [
                    patch.whichFace(facei)
                ];
            result = wall + min(scalar(2), nearest)*(inside - wall);
        }
    }

    return result;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
    makeInterpolationType(cellWall, scalar);
    makeInterpolationType(cellWall, vector);
}


// ************************************************************************* //
