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

#include "resistedMomentum.H"
#include "PrecisionAdaptor.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::resistedMomentum::right
(
    const vectorField& f
) const
{
    const scalarField& V = U_.mesh().V();
    const vectorField& U = U_.primitiveField();
    const vectorField& UOld = U_.oldTime().primitiveField();
    tmp<vectorField> tright(new vectorField(source()));
    vectorField& right = tright.ref();

    forAll(V, celli)
    {
        const symmTensor& R = resistance_[celli];
        const vector diagonal(R.xx(), R.yy(), R.zz());
        right[celli] += V[celli]
           *(
                f[celli]
              + (R & (UOld[celli] - U[celli]))
              + cmptMultiply(diagonal, U[celli])
            );
    }
    addBoundarySource(right);
    return tright;
}


template<class Use>
void Foam::resistedMomentum::withComponent
(
    const direction cmpt,
    const vectorField& right,
    const Use& use
)
{
    scalarField UCmpt(U_.primitiveField().component(cmpt));
    scalarField rightCmpt(right.component(cmpt));
    const FieldField<Field, scalar> boundary(boundaryCoeffs().component(cmpt));
    const FieldField<Field, scalar> internal(internalCoeffs().component(cmpt));
    const lduInterfaceFieldPtrsList interfaces
    (
        U_.boundaryField().scalarInterfaces()
    );

    const scalarField without(diag());
    addBoundaryDiag(diag(), cmpt);
    const direction onDiagonal[] =
        {symmTensor::XX, symmTensor::YY, symmTensor::ZZ};
    diag() +=
        U_.mesh().V()
       *resistance_.primitiveField().component(onDiagonal[cmpt]);

    // What coupled boundaries have put into the right is implicit from here on:
    // as fvMatrix::solveSegregated
    {
        PrecisionAdaptor<solveScalar, scalar> result(rightCmpt);
        const ConstPrecisionAdaptor<solveScalar, scalar> psi(UCmpt);
        #if OPENFOAM >= 2306
        const label startRequest = UPstream::nRequests();
        #endif
        initMatrixInterfaces
        (
            true, boundary, interfaces, psi(), result.ref(), cmpt
        );
        updateMatrixInterfaces
        (
            true, boundary, interfaces, psi(), result.ref(), cmpt
            #if OPENFOAM >= 2306
            , startRequest
            #endif
        );
    }
    use(UCmpt, rightCmpt, boundary, internal, interfaces);
    diag() = without;
}


Foam::solverPerformance Foam::resistedMomentum::solveComponent
(
    const direction cmpt,
    const vectorField& right,
    const dictionary& controls
)
{
    solverPerformance performance
    (
        controls.get<word>("solver"),
        U_.name() + vector::componentNames[cmpt]
    );

    withComponent
    (
        cmpt,
        right,
        [&]
        (
            scalarField& U,
            const scalarField& b,
            const FieldField<Field, scalar>& boundary,
            const FieldField<Field, scalar>& internal,
            const lduInterfaceFieldPtrsList& interfaces
        )
        {
            // A residual of round-off is none: OpenFOAM takes it over how far
            // U is from its mean, and of an even flow its solvers would go on
            // with noise, to 0/0
            const scalar left = gSumMag
            (
                lduMatrix::residual(U, b, boundary, interfaces, cmpt)()
            );
            if (left > 1e-15*gSumMag(scalarField(diag()*U)))
            {
                performance = lduMatrix::solver::New
                (
                    performance.fieldName(),
                    *this,
                    boundary,
                    internal,
                    interfaces,
                    controls
                )->solve(U, b, cmpt);
            }
            U_.primitiveFieldRef().replace(cmpt, U);
        }
    );
    return performance;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::resistedMomentum::resistedMomentum
(
    const fvVectorMatrix& eqn,
    volVectorField& U,
    const volSymmTensorField& R
)
:
    fvVectorMatrix(eqn),
    U_(U),
    resistance_(R)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::resistedMomentum::solve(const vectorField& f, const scalar relTol)
{
    dictionary controls(solverDict());
    controls.set
    (
        "relTol",
        max(relTol, controls.lookupOrDefault<scalar>("relTol", 0))
    );
    const auto valid = U_.mesh().validComponents<vector>();
    const vectorField right(this->right(f));

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (valid[cmpt] != -1)
        {
            solveComponent(cmpt, right, controls).print
            (
                Info.masterStream(U_.mesh().comm())
            );
        }
    }
    U_.correctBoundaryConditions();
}


Foam::vector Foam::resistedMomentum::unbalanced(const vectorField& f)
{
    const vectorField right(this->right(f));
    const auto valid = U_.mesh().validComponents<vector>();
    vector sum(Zero);

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (valid[cmpt] == -1)
        {
            continue;
        }
        withComponent
        (
            cmpt,
            right,
            [&]
            (
                const scalarField& U,
                const scalarField& b,
                const FieldField<Field, scalar>& boundary,
                const FieldField<Field, scalar>&,
                const lduInterfaceFieldPtrsList& interfaces
            )
            {
                sum[cmpt] = gSum
                (
                    lduMatrix::residual(U, b, boundary, interfaces, cmpt)()
                );
            }
        );
    }
    return sum;
}


// ************************************************************************* //
