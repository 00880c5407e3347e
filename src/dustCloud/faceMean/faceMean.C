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

#include "faceMean.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "surfaceInterpolate.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- S^-1/2 of a positive definite matrix (Denman and Beavers 1976)
static symmTensor inverseRoot(const symmTensor& S)
{
    symmTensor root(S);
    symmTensor inverse(symmTensor::I);
    for (label i = 0; i < 30; ++i)
    {
        const symmTensor last(inverse);
        const symmTensor next(0.5*(root + inv(inverse)));
        inverse = 0.5*(inverse + inv(root));
        root = next;
        if (mag(inverse - last) < 1e-15*mag(inverse))
        {
            break;
        }
    }
    return inverse;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::faceMean::makeScales()
{
    const scalarField& V = mesh_.V();
    const surfaceVectorField d(mesh_.delta());
    tensorField skew(mesh_.nCells(), Zero);
    symmTensorField normal(mesh_.nCells(), Zero);

    const auto add = [&](const label celli, const vector& S, const vector& way)
    {
        skew[celli] += S*way;
        normal[celli] += sqr(S)*(S & way)/magSqr(S);
    };
    const auto addNormalWay =
        [&](const label celli, const vector& S, const scalar way)
    {
        normal[celli] += sqr(S)*way/mag(S);
    };

    forAll(mesh_.neighbour(), facei)
    {
        const vector& S = mesh_.Sf()[facei];
        const scalar a = ownPart_[facei];
        const label own = mesh_.owner()[facei];
        const label other = mesh_.neighbour()[facei];
        skew[own] += S*d[facei]*a;
        skew[other] += S*d[facei]*(1 - a);
        addNormalWay(own, S, a*normalWay_[facei]);
        addNormalWay(other, S, (1 - a)*normalWay_[facei]);
    }
    // Of empty patches, too, whose faces no field has
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            const vector& S = patch.faceAreas()[i];
            if (patch.coupled())
            {
                const scalar a = ownPart_.boundaryField()[patch.index()][i];
                skew[celli] += S*d.boundaryField()[patch.index()][i]*a;
                addNormalWay
                (
                    celli,
                    S,
                    a*normalWay_.boundaryField()[patch.index()][i]
                );
            }
            else
            {
                add
                (
                    celli,
                    S,
                    patch.faceCentres()[i] - mesh_.cellCentres()[celli]
                );
            }
        }
    }

    forAll(V, celli)
    {
        upright_[celli] = inv(skew[celli]/V[celli]);
        normal[celli] = inverseRoot(normal[celli]/V[celli]);
    }
    const vectorField& S = mesh_.faceAreas();
    forAll(S, facei)
    {
        const vector n(S[facei]/mag(S[facei]));
        ownNormal_[facei] = normal[mesh_.faceOwner()[facei]] & n;
        if (mesh_.isInternalFace(facei))
        {
            neighbourNormal_[facei] = normal[mesh_.faceNeighbour()[facei]] & n;
        }
    }
}


void Foam::faceMean::addBoundary
(
    vectorField& seen,
    const volVectorField& U
) const
{
    forAll(open_, patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (open_[patchi])
        {
            continue;
        }
        // None on empty patches, whose faces no field has
        const vectorField& values = U.boundaryField()[patchi];
        const scalarField& way = normalWay_.boundaryField()[patchi];
        forAll(values, i)
        {
            const label celli = patch.faceCells()[i];
            const vector& m = ownNormal_[patch.start() + i];
            seen[celli] +=
                patch.magSf()[i]*way[i]/mesh_.V()[celli]*(m & values[i])*m;
        }
    }
}


void Foam::faceMean::addResistance
(
    symmTensorField& R,
    const label patchi,
    const scalarField& rf
) const
{
    const fvPatch& patch = mesh_.boundary()[patchi];
    const scalarField rWay
    (
        ownPart_.boundaryField()[patchi]*patch.magSf()
       *normalWay_.boundaryField()[patchi]*rf
    );
    forAll(rWay, i)
    {
        R[patch.faceCells()[i]] += rWay[i]*sqr(ownNormal_[patch.start() + i]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceMean::faceMean(const fvMesh& mesh)
:
    mesh_(mesh),
    ownPart_
    (
        IOobject("ownPart", mesh.time().timeName(), mesh),
        1 - mesh.weights()
    ),
    normalWay_
    (
        IOobject("normalWay", mesh.time().timeName(), mesh),
        1/mesh.nonOrthDeltaCoeffs()
    ),
    upright_(mesh.nCells()),
    ownNormal_(mesh.nFaces()),
    neighbourNormal_(mesh.nInternalFaces()),
    open_(mesh.boundary().size(), false),
    lack_(mesh.nCells(), Zero)
{
    // To the face, where nothing is behind it
    for (fvsPatchScalarField& part : ownPart_.boundaryFieldRef())
    {
        if (!part.coupled())
        {
            part = 1;
        }
    }
    makeScales();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::faceMean::setOpen(const volScalarField& p)
{
    forAll(open_, patchi)
    {
        const fvPatchScalarField& pb = p.boundaryField()[patchi];
        open_[patchi] =
            pb.coupled()
         || pb.fixesValue()
         || isA<fixedFluxPressureFvPatchScalarField>(pb);
    }

    lack_ = tensor::I;
    for (direction i = 0; i < vector::nComponents; ++i)
    {
        vector axis(Zero);
        axis[i] = 1;
        const volVectorField one
        (
            IOobject("one", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedVector("one", dimless, axis)
        );
        vectorField there(seen(one.primitiveField()));
        addBoundary(there, one);
        forAll(lack_, celli)
        {
            for (direction j = 0; j < vector::nComponents; ++j)
            {
                lack_[celli](j, i) -= there[celli][j];
            }
        }
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::faceMean::along
(
    const volVectorField& F
) const
{
    volVectorField upright("upright", F);
    upright.primitiveFieldRef() = upright_ & F.primitiveField();
    upright.correctBoundaryConditions();

    const surfaceVectorField d(mesh_.delta());
    tmp<surfaceScalarField> tpsi
    (
        new surfaceScalarField
        (
            IOobject("psi", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(F.dimensions()*dimLength, Zero)
        )
    );
    surfaceScalarField& psi = tpsi.ref();

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();

    forAll(neighbour, facei)
    {
        const scalar a = ownPart_[facei];
        psi[facei] =
            d[facei]
          & (
                a*upright[owner[facei]]
              + (1 - a)*upright[neighbour[facei]]
            );
    }
    forAll(psi.boundaryField(), patchi)
    {
        const fvPatchVectorField& Fb = upright.boundaryField()[patchi];
        fvsPatchScalarField& psib = psi.boundaryFieldRef()[patchi];
        if (Fb.coupled())
        {
            const scalarField& a = ownPart_.boundaryField()[patchi];
            psib =
                d.boundaryField()[patchi]
              & (a*Fb.patchInternalField() + (1 - a)*Fb.patchNeighbourField());
        }
        else if (open_[patchi])
        {
            psib = Fb.patch().delta() & Fb.patchInternalField();
        }
    }
    return tpsi;
}


Foam::tmp<Foam::volVectorField> Foam::faceMean::force
(
    const surfaceScalarField& psi
) const
{
    tmp<volVectorField> tforce
    (
        new volVectorField
        (
            IOobject("faceMeanForce", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedVector(psi.dimensions()/dimLength, Zero)
        )
    );
    vectorField& force = tforce.ref().primitiveFieldRef();

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const vectorField& S = mesh_.Sf().primitiveField();

    forAll(neighbour, facei)
    {
        const vector push(S[facei]*psi[facei]);
        const scalar a = ownPart_[facei];
        force[owner[facei]] += a*push;
        force[neighbour[facei]] += (1 - a)*push;
    }
    forAll(psi.boundaryField(), patchi)
    {
        const fvsPatchScalarField& psib = psi.boundaryField()[patchi];
        const labelUList& cells = psib.patch().faceCells();
        const vectorField& Sb = mesh_.Sf().boundaryField()[patchi];
        const scalarField& a = ownPart_.boundaryField()[patchi];
        forAll(psib, i)
        {
            force[cells[i]] += a[i]*Sb[i]*psib[i];
        }
    }
    force /= mesh_.V();
    tforce.ref().correctBoundaryConditions();
    return tforce;
}


Foam::tmp<Foam::surfaceScalarField> Foam::faceMean::flux
(
    const surfaceScalarField& psi,
    const volVectorField& force
) const
{
    tmp<surfaceScalarField> tflux
    (
        mesh_.magSf()
       *(
            psi*mesh_.nonOrthDeltaCoeffs()
          + (mesh_.nonOrthCorrectionVectors() & fvc::interpolate(force))
        )
    );
    tflux.ref().setOriented();
    return tflux;
}


Foam::tmp<Foam::surfaceScalarField> Foam::faceMean::onFaces
(
    const volScalarField& r
) const
{
    tmp<surfaceScalarField> trf
    (
        new surfaceScalarField
        (
            IOobject("resistanceOnFaces", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(r.dimensions(), Zero)
        )
    );
    surfaceScalarField& rf = trf.ref();

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();

    forAll(neighbour, facei)
    {
        const scalar a = ownPart_[facei];
        rf[facei] =
            a*r[owner[facei]] + (1 - a)*r[neighbour[facei]];
    }
    forAll(r.boundaryField(), patchi)
    {
        const fvPatchScalarField& rb = r.boundaryField()[patchi];
        const scalarField& a = ownPart_.boundaryField()[patchi];
        if (rb.coupled())
        {
            rf.boundaryFieldRef()[patchi] =
                a*rb.patchInternalField() + (1 - a)*rb.patchNeighbourField();
        }
        else if (open_[patchi])
        {
            rf.boundaryFieldRef()[patchi] = rb.patchInternalField();
        }
    }
    return trf;
}


Foam::tmp<Foam::symmTensorField> Foam::faceMean::resistance
(
    const surfaceScalarField& rf
) const
{
    tmp<symmTensorField> tR(new symmTensorField(mesh_.nCells(), Zero));
    symmTensorField& R = tR.ref();

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const scalarField& magS = mesh_.magSf().primitiveField();

    forAll(neighbour, facei)
    {
        const scalar a = ownPart_[facei];
        const scalar rWay =
            magS[facei]*normalWay_[facei]*rf[facei];
        R[owner[facei]] += a*rWay*sqr(ownNormal_[facei]);
        R[neighbour[facei]] +=
            (1 - a)*rWay*sqr(neighbourNormal_[facei]);
    }
    forAll(rf.boundaryField(), patchi)
    {
        addResistance(R, patchi, rf.boundaryField()[patchi]);
    }
    R /= mesh_.V();
    return tR;
}


Foam::tmp<Foam::symmTensorField> Foam::faceMean::wallResistance
(
    const volScalarField& r
) const
{
    tmp<symmTensorField> tR(new symmTensorField(mesh_.nCells(), Zero));
    forAll(open_, patchi)
    {
        if (!open_[patchi])
        {
            addResistance
            (
                tR.ref(),
                patchi,
                r.boundaryField()[patchi].patchInternalField()
            );
        }
    }
    tR.ref() /= mesh_.V();
    return tR;
}


Foam::tmp<Foam::vectorField> Foam::faceMean::seen(const vectorField& u) const
{
    tmp<vectorField> tseen(new vectorField(mesh_.nCells(), Zero));
    vectorField& seen = tseen.ref();
    const label nInternal = mesh_.nInternalFaces();

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const scalarField& magS = mesh_.magSf().primitiveField();

    forAll(neighbour, facei)
    {
        const label own = owner[facei];
        const label other = neighbour[facei];
        const scalar a = ownPart_[facei];
        const vector& mOwn = ownNormal_[facei];
        const vector& mOther = neighbourNormal_[facei];
        const vector through
        (
            magS[facei]*normalWay_[facei]
           *(
                a*(mOwn & u[own])*mOwn
              + (1 - a)*(mOther & u[other])*mOther
            )
        );
        seen[own] += a*through;
        seen[other] += (1 - a)*through;
    }

    // Each side's own term, for the other side
    vectorField across(mesh_.nFaces() - nInternal, Zero);
    forAll(open_, patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const scalarField& a = ownPart_.boundaryField()[patchi];
        forAll(a, i)
        {
            const vector& m = ownNormal_[patch.start() + i];
            across[patch.start() - nInternal + i] =
                a[i]*(m & u[patch.faceCells()[i]])*m;
        }
    }
    const vectorField mine(across);
    syncTools::swapBoundaryFaceList(mesh_, across);

    forAll(open_, patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!open_[patchi])
        {
            continue;
        }
        const scalarField weight
        (
            patch.magSf()*normalWay_.boundaryField()[patchi]
           *ownPart_.boundaryField()[patchi]
        );
        forAll(weight, i)
        {
            const label bFacei = patch.start() - nInternal + i;
            seen[patch.faceCells()[i]] +=
                weight[i]
               *(mine[bFacei] + (patch.coupled() ? across[bFacei] : vector::zero));
        }
    }
    seen /= mesh_.V();
    return tseen;
}


Foam::tmp<Foam::vectorField> Foam::faceMean::seen(const volVectorField& U) const
{
    tmp<vectorField> tseen(seen(U.primitiveField()));
    addBoundary(tseen.ref(), U);
    tseen.ref() += lack_ & U.primitiveField();
    return tseen;
}


// ************************************************************************* //
