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
#include "syncTools.H"
#include "zeroGradientFvPatchFields.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Implicit steps
static const label nImplicit = 2;

//- Explicit steps that are still cheaper than these
static const label mostExplicit = 100;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::diffusiveSmoothing::stableSteps() const
{
    scalarField given(mesh_.nCells(), Zero);
    forAll(mesh_.neighbour(), facei)
    {
        given[mesh_.owner()[facei]] += diffusion_[facei];
        given[mesh_.neighbour()[facei]] += diffusion_[facei];
    }
    for (const fvsPatchScalarField& Db : diffusion_.boundaryField())
    {
        if (Db.coupled())
        {
            forAll(Db, i)
            {
                given[Db.patch().faceCells()[i]] += Db[i];
            }
        }
    }
    return label(std::ceil(1.5*gMax(given/mesh_.V())));
}


template<Foam::label n>
void Foam::diffusiveSmoothing::explicitStep
(
    scalarField& f,
    scalarField& change,
    scalarField& across
) const
{
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const scalarField& D = diffusion_;
    const scalarField& V = mesh_.V();
    const label nInternal = mesh_.nInternalFaces();

    change = Zero;
    forAll(neighbour, facei)
    {
        const scalar* fP = &f[owner[facei]*n];
        const scalar* fN = &f[neighbour[facei]*n];
        scalar* changeP = &change[owner[facei]*n];
        scalar* changeN = &change[neighbour[facei]*n];
        for (label i = 0; i < n; ++i)
        {
            const scalar d = D[facei]*(fN[i] - fP[i]);
            changeP[i] += d;
            changeN[i] -= d;
        }
    }

    if (coupled_)
    {
        for (label i = 0; i < n; ++i)
        {
            forAll(across, facei)
            {
                across[facei] = f[mesh_.faceOwner()[nInternal + facei]*n + i];
            }
            syncTools::swapBoundaryFaceList(mesh_, across);

            for (const fvsPatchScalarField& Db : diffusion_.boundaryField())
            {
                const label start = Db.patch().start() - nInternal;
                const labelUList& cells = Db.patch().faceCells();
                for (label j = 0; Db.coupled() && j < Db.size(); ++j)
                {
                    const label own = cells[j]*n + i;
                    change[own] += Db[j]*(across[start + j] - f[own]);
                }
            }
        }
    }

    forAll(V, celli)
    {
        const scalar part = 1/(V[celli]*explicitSteps_);
        for (label i = celli*n; i < (celli + 1)*n; ++i)
        {
            f[i] += part*change[i];
        }
    }
}


void Foam::diffusiveSmoothing::spreadExplicitly
(
    scalarField& f,
    const label n
) const
{
    scalarField change(f.size());
    scalarField across(coupled_ ? mesh_.nFaces() - mesh_.nInternalFaces() : 0);

    for (label step = 0; step < explicitSteps_; ++step)
    {
        switch (n)
        {
            case 1: explicitStep<1>(f, change, across); break;
            case 3: explicitStep<3>(f, change, across); break;
            case 4: explicitStep<4>(f, change, across); break;
            case 6: explicitStep<6>(f, change, across); break;
            default:
                FatalErrorInFunction
                    << n << " fields at once" << abort(FatalError);
        }
    }
}


void Foam::diffusiveSmoothing::spreadImplicitly(scalarField& f) const
{
    // Nothing to spread: also what PCG cannot normalise
    if (gMax(mag(f)) == 0)
    {
        return;
    }

    volScalarField smooth
    (
        IOobject("smooth", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    smooth.primitiveFieldRef() = f;
    smooth.correctBoundaryConditions();
    const surfaceScalarField part
    (
        diffusion_/(scalar(nImplicit)*mesh_.deltaCoeffs())
    );

    for (label i = 0; i < nImplicit; ++i)
    {
        fvScalarMatrix eqn
        (
            fvm::Sp(dimensionedScalar("one", dimless, 1), smooth)
          - fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
            (
                part,
                mesh_.deltaCoeffs(),
                smooth
            )
        );
        eqn.source() = mesh_.V().field()*smooth.primitiveField();

        // Many solutions a gas step are no news
        const int level = solverPerformance::debug;
        solverPerformance::debug = 0;
        eqn.solve(controls_);
        solverPerformance::debug = level;
    }
    f = smooth.primitiveField();
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
        dimensionedScalar(dimVolume, Zero)
    ),
    explicitSteps_(0),
    coupled_(false)
{
    for (const fvPatch& patch : mesh.boundary())
    {
        coupled_ = coupled_ || patch.coupled();
    }
    // Collective: also where this rank has no coupled patch
    reduce(coupled_, orOp<bool>());

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
        0.5*mesh_.magSf()*mesh_.deltaCoeffs()
       *(
            0.5*sqr(1/mesh_.deltaCoeffs())
          + sqr(dimensionedScalar("width", dimLength, width))
        );
    explicitSteps_ = max(label(1), stableSteps());
    if (explicitSteps_ > mostExplicit)
    {
        explicitSteps_ = 0;
    }
}


void Foam::diffusiveSmoothing::spread(scalarField& f, const label n) const
{
    if (explicitSteps_ > 0)
    {
        spreadExplicitly(f, n);
        return;
    }
    scalarField one(mesh_.nCells());
    for (label i = 0; i < n; ++i)
    {
        forAll(one, celli)
        {
            one[celli] = f[celli*n + i];
        }
        spreadImplicitly(one);
        forAll(one, celli)
        {
            f[celli*n + i] = one[celli];
        }
    }
}


Foam::tmp<Foam::scalarField> Foam::diffusiveSmoothing::operator()
(
    const scalarField& f
) const
{
    tmp<scalarField> tsmooth(new scalarField(f));
    spread(tsmooth.ref(), 1);
    return tsmooth;
}


Foam::tmp<Foam::vectorField> Foam::diffusiveSmoothing::operator()
(
    const vectorField& f
) const
{
    const label n = vector::nComponents;
    scalarField values(f.size()*n);
    forAll(values, i)
    {
        values[i] = f[i/n][i % n];
    }
    spread(values, n);

    tmp<vectorField> tsmooth(new vectorField(f.size()));
    forAll(values, i)
    {
        tsmooth.ref()[i/n][i % n] = values[i];
    }
    return tsmooth;
}



// ************************************************************************* //
