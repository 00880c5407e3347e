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

#include "diffusiveSmoothing.H"
#include "fvScalarMatrix.H"
#include "fvmSup.H"
#include "gaussLaplacianScheme.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    const Foam::label nSteps = 2;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::diffusiveSmoothing::diffusiveSmoothing
(
    const fvMesh& mesh,
    const scalar width
)
:
    mesh_(mesh),
    width_(-1),
    diffusion_
    (
        IOobject("smoothingDiffusion", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimArea*dimArea, Zero)
    )
{
    controls_.set("solver", "PCG");
    controls_.set("preconditioner", "DIC");
    controls_.set("tolerance", 1e-14);
    controls_.set("relTol", 0);
    setWidth(width);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::diffusiveSmoothing::setWidth(const scalar width)
{
    if (width == width_)
    {
        return;
    }
    width_ = width;
    diffusion_ =
        mesh_.magSf()/(2*nSteps)
       *(
            0.5*sqr(1/mesh_.deltaCoeffs())
          + sqr(dimensionedScalar("width", dimLength, width))
        );
}


Foam::tmp<Foam::scalarField> Foam::diffusiveSmoothing::operator()
(
    const scalarField& f
) const
{
    volScalarField smooth
    (
        IOobject("smooth", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    smooth.primitiveFieldRef() = f;
    smooth.correctBoundaryConditions();

    // Nothing to spread: also what PCG cannot normalise
    if (gMax(mag(f)) == 0)
    {
        return tmp<scalarField>(new scalarField(f));
    }

    for (label i = 0; i < nSteps; ++i)
    {
        fvScalarMatrix eqn
        (
            fvm::Sp(dimensionedScalar("one", dimless, 1), smooth)
          - fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
            (
                diffusion_,
                mesh_.deltaCoeffs(),
                smooth
            )
        );
        eqn.source() = mesh_.V().field()*smooth.primitiveField();

        // Six solutions a gas step are no news
        const int level = solverPerformance::debug;
        solverPerformance::debug = 0;
        eqn.solve(controls_);
        solverPerformance::debug = level;
    }

    return tmp<scalarField>(new scalarField(smooth.primitiveField()));
}


Foam::tmp<Foam::vectorField> Foam::diffusiveSmoothing::operator()
(
    const vectorField& f
) const
{
    tmp<vectorField> tsmooth(new vectorField(f.size()));
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        tsmooth.ref().replace(d, operator()(f.component(d)));
    }
    return tsmooth;
}



// ************************************************************************* //
