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

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Implicit steps
static const label nSteps = 2;

//- Explicit steps that are still cheaper than these
static const label mostExplicit = 20;


//- Add to each cell, over its volume, D times the difference from each
//  neighbour's value
static void addDifferences
(
    scalarField& sum,
    const surfaceScalarField& D,
    const volScalarField& f
)
{
    const fvMesh& mesh = f.mesh();
    const scalarField& V = mesh.V();

    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei];
        const label N = mesh.neighbour()[facei];
        const scalar d = D[facei]*(f[N] - f[P]);
        sum[P] += d/V[P];
        sum[N] -= d/V[N];
    }
    for (const fvPatchScalarField& fb : f.boundaryField())
    {
        if (fb.coupled())
        {
            const scalarField d
            (
                D.boundaryField()[fb.patch().index()]
               *(fb.patchNeighbourField() - fb.patchInternalField())
            );
            const labelUList& cells = fb.patch().faceCells();
            forAll(cells, i)
            {
                sum[cells[i]] += d[i]/V[cells[i]];
            }
        }
    }
}


//- Explicit steps in which no cell gives more than it has
static label explicitSteps(const surfaceScalarField& D)
{
    const fvMesh& mesh = D.mesh();
    scalarField given(mesh.nCells(), Zero);
    forAll(mesh.neighbour(), facei)
    {
        given[mesh.owner()[facei]] += D[facei];
        given[mesh.neighbour()[facei]] += D[facei];
    }
    for (const fvsPatchScalarField& Db : D.boundaryField())
    {
        if (Db.coupled())
        {
            forAll(Db, i)
            {
                given[Db.patch().faceCells()[i]] += Db[i];
            }
        }
    }
    return label(std::ceil(1.5*gMax(given/mesh.V())));
}

} // End namespace Foam


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

    const surfaceScalarField D(nSteps*diffusion_*mesh_.deltaCoeffs());
    const label n = explicitSteps(D);
    if (n <= mostExplicit)
    {
        for (label i = 0; i < n; ++i)
        {
            scalarField change(f.size(), Zero);
            addDifferences(change, D, smooth);
            smooth.primitiveFieldRef() += change/n;
            smooth.correctBoundaryConditions();
        }
        return tmp<scalarField>(new scalarField(smooth.primitiveField()));
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
