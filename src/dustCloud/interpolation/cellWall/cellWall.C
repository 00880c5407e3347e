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
#include "syncTools.H"
#include "turbulenceModel.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::labelList Foam::cellWall<Type>::kinds
(
    const GeometricField<Type, fvPatchField, volMesh>& psi
)
{
    const fvBoundaryMesh& patches = psi.mesh().boundary();
    const label n = psi.mesh().boundaryMesh().nNonProcessor();
    const scalar speed = gMax(mag(psi.primitiveField())());

    scalarField along(n, Zero);
    scalarField through(n, Zero);
    for (label patchi = 0; patchi < n; ++patchi)
    {
        const vectorField normals(patches[patchi].nf());
        forAll(normals, i)
        {
            const vector& U = psi.boundaryField()[patchi][i];
            const scalar un = U & normals[i];
            through[patchi] = max(through[patchi], mag(un));
            along[patchi] = max(along[patchi], mag(U - un*normals[i]));
        }
    }
    Pstream::listCombineGather(along, maxEqOp<scalar>());
    Pstream::listCombineScatter(along);
    Pstream::listCombineGather(through, maxEqOp<scalar>());
    Pstream::listCombineScatter(through);

    labelList result(n, label(cellWallGeometry::open));
    forAll(result, patchi)
    {
        if
        (
            isA<wallPolyPatch>(psi.mesh().boundaryMesh()[patchi])
         && through[patchi] <= max(1e-6*speed, 0.01*along[patchi])
        )
        {
            result[patchi] =
                along[patchi] > 1e-6*speed
              ? cellWallGeometry::slip
              : cellWallGeometry::noSlip;
        }
    }
    return result;
}


template<class Type>
void Foam::cellWall<Type>::setProfiles()
{
    const fvMesh& mesh = geometry_.mesh();
    const turbulenceModel* model = mesh.cfindObject<turbulenceModel>
    (
        IOobject::groupName(turbulenceModel::propertiesName, this->psi_.group())
    );
    if (!model)
    {
        return;
    }

    for (const fvPatch& patch : mesh.boundary())
    {
        if (!isA<wallPolyPatch>(patch.patch()))
        {
            continue;
        }
        const scalarField nut(model->nut(patch.index()));
        const scalarField nu(model->nu(patch.index()));
        const labelUList& cells = patch.faceCells();

        forAll(cells, i)
        {
            const label celli = cells[i];
            const nearWall* near = geometry_.walls(celli);
            const scalar A = 1 + nut[i]/nu[i];
            const scalar y = near ? near->height() : 0;
            const scalar speed = mag(this->psi_[celli]);

            if (A > 1 + SMALL && y > 0 && speed > VSMALL)
            {
                // Of several faces the one with the largest: in no order
                wallProfile& profile = profiles_(celli);
                profile.A = max(profile.A, A);
                profile.s1 =
                    min
                    (
                        11.53/sqrt(profile.A*speed*y/nu[i]),
                        1/profile.A
                    );
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::cellWall<Type>::cellWall
(
    const GeometricField<Type, fvPatchField, volMesh>& psi,
    const bool bounded
)
:
    interpolation<Type>(psi),
    geometry_(cellWallGeometry::get(psi.mesh(), kinds(psi)))
{
    const fvMesh& mesh = psi.mesh();

    Field<Type> boundary;
    syncTools::swapBoundaryCellList(mesh, psi.primitiveField(), boundary);
    for (const fvPatch& patch : mesh.boundary())
    {
        if (!patch.coupled())
        {
            const Field<Type>& values = psi.boundaryField()[patch.index()];
            const label start = patch.start() - mesh.nInternalFaces();
            forAll(values, i)
            {
                boundary[start + i] = values[i];
            }
        }
    }
    geometry_.gradients(psi.primitiveField(), boundary, !bounded, gradients_);
    if (bounded)
    {
        geometry_.ranges(psi.primitiveField(), boundary, low_, high_);
    }
    setProfiles();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Type Foam::cellWall<Type>::interpolate
(
    const vector& position,
    const label celli,
    const label
) const
{
    const Type& inside = this->psi_[celli];
    const vector d = position - geometry_.centre(celli);
    const nearWall* walls = geometry_.walls(celli);
    Type there;

    if (!walls)
    {
        there = inside + (d & gradients_[celli]);
    }
    else
    {
        const auto profile = profiles_.cfind(celli);
        there = walls->velocity
        (
            position,
            d,
            inside,
            gradients_[celli],
            profile.found() ? &*profile : nullptr
        );
    }
    return
        low_.empty()
      ? there
      : max(low_[celli], min(high_[celli], there));
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
    makeInterpolationType(cellWall, vector);
}


// ************************************************************************* //
