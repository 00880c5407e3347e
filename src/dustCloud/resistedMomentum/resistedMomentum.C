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

Foam::solverPerformance Foam::resistedMomentum::solveComponent
(
    const direction cmpt,
    const vectorField& source,
    const dictionary& controls
)
{
    scalarField UCmpt(U_.primitiveField().component(cmpt));
    scalarField sourceCmpt(source.component(cmpt));
    const FieldField<Field, scalar> boundary(boundaryCoeffs().component(cmpt));
    const FieldField<Field, scalar> internal(internalCoeffs().component(cmpt));
    const lduInterfaceFieldPtrsList interfaces
    (
        U_.boundaryField().scalarInterfaces()
    );

    const scalarField without(diag());
    addBoundaryDiag(diag(), cmpt);
    diag() += resistance_.component(cmpt);

    // What coupled boundaries have put into source is implicit from here on:
    // as fvMatrix::solveSegregated
    {
        PrecisionAdaptor<solveScalar, scalar> result(sourceCmpt);
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

    // A residual of round-off is none: OpenFOAM takes it over how far U is from
    // its mean, and of an even flow its solvers would go on with noise, to 0/0
    solverPerformance performance
    (
        controls.get<word>("solver"),
        U_.name() + vector::componentNames[cmpt]
    );
    const scalar left = gSumMag
    (
        lduMatrix::residual(UCmpt, sourceCmpt, boundary, interfaces, cmpt)()
    );
    if (left > 1e-15*gSumMag(scalarField(diag()*UCmpt)))
    {
        performance = lduMatrix::solver::New
        (
            performance.fieldName(),
            *this,
            boundary,
            internal,
            interfaces,
            controls
        )->solve(UCmpt, sourceCmpt, cmpt);
    }

    U_.primitiveFieldRef().replace(cmpt, UCmpt);
    diag() = without;
    return performance;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::resistedMomentum::resistedMomentum
(
    const fvVectorMatrix& eqn,
    volVectorField& U,
    const volSymmTensorField& R,
    const vectorField& f
)
:
    fvVectorMatrix(eqn),
    U_(U),
    resistance_(U.size())
{
    const scalarField& V = U.mesh().V();
    const vectorField& UOld = U.oldTime().primitiveField();

    forAll(V, celli)
    {
        const symmTensor& RP = R[celli];
        const vector diagonal(RP.xx(), RP.yy(), RP.zz());
        resistance_[celli] = V[celli]*diagonal;
        source()[celli] += V[celli]
           *(
                f[celli]
              + (RP & (UOld[celli] - U[celli]))
              + cmptMultiply(diagonal, U[celli])
            );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::resistedMomentum::solve()
{
    const dictionary& controls = solverDict();
    const auto valid = U_.mesh().validComponents<vector>();

    vectorField source(this->source());
    addBoundarySource(source);

    solverPerformance performance;
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (valid[cmpt] != -1)
        {
            performance = solveComponent(cmpt, source, controls);
            performance.print(Info.masterStream(U_.mesh().comm()));
        }
    }
    U_.correctBoundaryConditions();
}


// ************************************************************************* //
