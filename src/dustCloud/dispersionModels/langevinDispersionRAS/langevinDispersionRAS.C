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

#include "langevinDispersionRAS.H"
#include "dustProperties.H"
#include "langevinStep.H"
#include "rounded.H"

#include "fvc.H"
#include "gradScheme.H"
#include "indexedOctree.H"
#include "IStringStream.H"
#include "pointFields.H"
#include "treeDataTriSurface.H"
#include "turbulenceModel.H"
#include "volPointInterpolation.H"
#include "wallPolyPatch.H"
#include "zeroGradientFvPatchFields.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(langevinDispersionRAS, 0);

    DispersionModel<dustCloud::kinematicCloudType>::
        adddictionaryConstructorToTable<langevinDispersionRAS>
        addLangevinDispersionRASToTable_;


    //- L of R = L L^T; R is floored, as it may be singular at walls
    static tensor cholesky(const symmTensor& R)
    {
        const scalar floor = 1e-12*tr(R) + VSMALL;
        const scalar a = sqrt(max(R.xx(), floor));
        const scalar b = R.xy()/a;
        const scalar c = R.xz()/a;
        const scalar d = sqrt(max(R.yy() - b*b, floor));
        const scalar e = (R.yz() - b*c)/d;
        return tensor
        (
            a, 0, 0,
            b, d, 0,
            c, e, sqrt(max(R.zz() - c*c - e*e, floor))
        );
    }

    //- Distance of a cell's farthest point from x [m]
    static scalar reachOf
    (
        const polyMesh& mesh,
        const label celli,
        const point& x
    )
    {
        scalar reach = 0;
        for (const label facei : mesh.cells()[celli])
        {
            for (const label pointi : mesh.faces()[facei])
            {
                reach = max(reach, mag(mesh.points()[pointi] - x));
            }
        }
        return reach;
    }


    //- Values at the points of the mesh
    static scalarField atPoints(const volScalarField& field)
    {
        scalarField values
        (
            volPointInterpolation::New(field.mesh())
           .interpolate(field)().primitiveField()
        );
        for (scalar& value : values)
        {
            value = rounded(value);
        }
        return values;
    }


    //- L of the field; s: for its boundary conditions
    static tmp<volTensorField> factorOf
    (
        const volSymmTensorField& R,
        const volScalarField& s
    )
    {
        tmp<volTensorField> tL
        (
            new volTensorField("L", s*tensor(tensor::I))
        );
        volTensorField& L = tL.ref();
        forAll(L, celli)
        {
            L[celli] = cholesky(R[celli]);
        }
        forAll(L.boundaryField(), patchi)
        {
            forAll(L.boundaryField()[patchi], facei)
            {
                L.boundaryFieldRef()[patchi][facei] =
                    cholesky(R.boundaryField()[patchi][facei]);
            }
        }
        return tL;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::turbulenceModel& Foam::langevinDispersionRAS::turbulence() const
{
    return this->owner().mesh().template lookupObject<turbulenceModel>
    (
        IOobject::groupName
        (
            turbulenceModel::propertiesName,
            this->owner().U().group()
        )
    );
}


void Foam::langevinDispersionRAS::setWalls(const volScalarField& k)
{
    const turbulenceModel& turb = turbulence();
    const scalar Cmu = 0.09;

    faceValues_.setSize(wallPatches_.size());
    forAll(wallPatches_, i)
    {
        const label patchi = wallPatches_[i];
        const fvPatchVectorField& U = this->owner().U().boundaryField()[patchi];
        const scalarField nu(turb.nu(patchi));
        const scalarField nuEff(turb.nuEff(patchi));
        const vectorField gradU(U.snGrad());
        const vectorField n(U.patch().nf());
        const labelUList& cells = U.patch().faceCells();

        vectorField& values = faceValues_[i];
        values.setSize(U.size());
        forAll(values, facei)
        {
            const vector past = gradU[facei] - (gradU[facei] & n[facei])*n[facei];
            values[facei] = vector
            (
                rounded
                (
                    max
                    (
                        sqrt(nuEff[facei]*mag(past)),
                        pow025(Cmu)*sqrt(max(k[cells[facei]], scalar(0)))
                    )
                ),
                rounded(nu[facei]),
                0
            );
        }
    }

    walls_ = patchWalls::gather(this->owner().mesh(), wallPatches_, faceValues_);
}


void Foam::langevinDispersionRAS::findWalls()
{
    const fvMesh& mesh = this->owner().mesh();

    nearest_.setSize(mesh.nCells(), -1);
    if (walls_.empty())
    {
        return;
    }

    // The same tree on every rank
    pointField points(3*walls_.size());
    List<labelledTri> triangles(walls_.size());
    forAll(walls_, i)
    {
        for (label v = 0; v < 3; ++v)
        {
            points[3*i + v] = walls_[i].vertices[v];
        }
        triangles[i] = labelledTri(3*i, 3*i + 1, 3*i + 2, 0);
    }
    const triSurface surface(triangles, points);
    treeBoundBox box(points);
    box.min() -= 1e-3*box.mag()*vector::one;
    box.max() += 1e-3*box.mag()*vector::one;
    const indexedOctree<treeDataTriSurface> tree
    (
        treeDataTriSurface(false, surface, 0),
        box,
        8,
        10,
        3
    );

    forAll(nearest_, celli)
    {
        nearest_[celli] =
            tree.findNearest(rounded(mesh.C()[celli]), sqr(GREAT)).index();
    }
}


void Foam::langevinDispersionRAS::setShear
(
    const volScalarField& k,
    const volScalarField& epsilon
)
{
    const fvMesh& mesh = this->owner().mesh();
    const volVectorField& U = this->owner().U();
    const volTensorField gradU(fvc::grad(U));

    volScalarField g
    (
        IOobject
        (
            "shearAnisotropy",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(seen_, celli)
    {
        const scalar speed = mag(U[celli]);
        if (speed < ROOTVSMALL)
        {
            continue;
        }
        const vector along = U[celli]/speed;
        vector gradSpeed = gradU[celli] & along;
        gradSpeed -= (gradSpeed & along)*along;
        gradSpeed = rounded(gradSpeed, speed/cbrt(mesh.V()[celli]));

        const scalar rate = mag(gradSpeed);
        if (rate > ROOTVSMALL)
        {
            g[celli] =
                min(scalar(1), 0.3*rate*k[celli]/max(epsilon[celli], VSMALL));
            seen_[celli].A = turbulenceSeen::sheared(along, gradSpeed);
        }
        seen_[celli].g = g[celli];
    }
    g.correctBoundaryConditions();
    gAtPoints_ = atPoints(g);
}


void Foam::langevinDispersionRAS::setCells(const volScalarField& k)
{
    const fvMesh& mesh = this->owner().mesh();
    const turbulenceModel& turb = turbulence();
    const volScalarField epsilon(turb.epsilon());

    const volScalarField s
    (
        "s",
        sqrt(2.0/3*max(k, dimensionedScalar(k.dimensions(), Zero)))
    );
    const volVectorField gradS
    (
        fv::gradScheme<scalar>::New
        (
            mesh,
            IStringStream("cellLimited Gauss linear 1")()
        )().grad(s)
    );

    sAtPoints_ = atPoints(s);

    // Reynolds-stress models keep R
    tmp<volTensorField> tL;
    tmp<volVectorField> tDivL;
    if (mesh.foundObject<volSymmTensorField>("R"))
    {
        const volSymmTensorField R(turb.R());
        tL = factorOf(R, s);
        const volTensorField& L = tL();
        tDivL = fvc::div(mesh.Sf() & fvc::interpolate(L));
    }

    seen_ = List<turbulenceSeen>(mesh.nCells());
    gAtPoints_.clear();
    if (!tL.valid())
    {
        setShear(k, epsilon);
    }

    forAll(seen_, celli)
    {
        turbulenceSeen& t = seen_[celli];
        t.origin = rounded(mesh.C()[celli]);
        t.reach = reachOf(mesh, celli, t.origin);
        t.s = s[celli];
        const scalar steepest = max(t.s, ROOTVSMALL)/cbrt(mesh.V()[celli]);
        t.gradS = rounded(gradS[celli], steepest);
        t.TFar = timeScale_*k[celli]/max(epsilon[celli], VSMALL);
        t.TFar = max(t.TFar, ROOTVSMALL);

        if (tL.valid() && t.s > ROOTVSMALL)
        {
            t.B = tL()[celli]/t.s;
            t.divB = rounded(tDivL()[celli], steepest) - (t.gradS & t.B);
        }

        const label walli = nearest_[celli];
        if (walli >= 0)
        {
            const auto& wall = walls_[walli];
            const triPointRef triangle
            (
                wall.vertices[0],
                wall.vertices[1],
                wall.vertices[2]
            );
            const vector way =
                t.origin - triangle.nearestPoint(t.origin).rawPoint();
            const vector d = rounded(way, max(mag(way), VSMALL));
            t.y = mag(d);
            t.n = t.y > VSMALL ? d/t.y : vector(1, 0, 0);
            t.uTau = wall.value.x();
            t.nu = wall.value.y();
        }
    }
}


void Foam::langevinDispersionRAS::useOwnTetrahedron
(
    turbulenceSeen& t,
    const dustParcel& p
) const
{
    const polyMesh& mesh = this->owner().mesh();
    triFace tri(p.currentTetIndices().faceTriIs(mesh));

    // A face between ranks has its points in the other order on one of them
    std::sort
    (
        tri.begin(),
        tri.end(),
        [&mesh](const label i, const label j)
        {
            const point& x = mesh.points()[i];
            const point& y = mesh.points()[j];
            return
                std::tie(x.x(), x.y(), x.z()) < std::tie(y.x(), y.y(), y.z());
        }
    );
    const vector a(mesh.points()[tri[0]] - t.origin);
    const vector b(mesh.points()[tri[1]] - t.origin);
    const vector c(mesh.points()[tri[2]] - t.origin);
    const scalar volume = a & (b ^ c);

    // Flat ones, of which there is little, keep the cell's
    if (mag(volume) > 1e-12*mag(a)*mag(b)*mag(c))
    {
        const auto gradient =
            [&](const scalarField& atPoints, const scalar atOrigin) -> vector
            {
                return
                (
                    (atPoints[tri[0]] - atOrigin)*(b ^ c)
                  + (atPoints[tri[1]] - atOrigin)*(c ^ a)
                  + (atPoints[tri[2]] - atOrigin)*(a ^ b)
                )/volume;
            };

        t.gradS = gradient(sAtPoints_, t.s);
        if (gAtPoints_.size())
        {
            t.gradG = gradient(gAtPoints_, t.g);
        }
    }
}


void Foam::langevinDispersionRAS::useOwnWall
(
    turbulenceSeen& t,
    const label celli,
    const point& x
) const
{
    const polyMesh& mesh = this->owner().mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    scalar nearest = GREAT;

    for (const label facei : mesh.cells()[celli])
    {
        if (mesh.isInternalFace(facei))
        {
            continue;
        }
        const label i = wallPatches_.find(patches.whichPatch(facei));
        if (i < 0)
        {
            continue;
        }
        const face& f = mesh.faces()[facei];
        const scalar y = f.nearestPoint(x, mesh.points()).distance();

        if (y < nearest)
        {
            const label own = patches[wallPatches_[i]].whichFace(facei);
            nearest = y;
            t.n = -f.unitNormal(mesh.points());
            t.y = y + (t.n & (t.origin - x));
            t.uTau = faceValues_[i][own].x();
            t.nu = faceValues_[i][own].y();
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::langevinDispersionRAS::langevinDispersionRAS
(
    const dictionary& dict,
    cloudType& owner
)
:
    DispersionModel<cloudType>(owner),
    timeScale_(0.3)
{
    const dictionary coeffs
    (
        dict.subOrEmptyDict("langevinDispersionRASCoeffs")
    );
    coeffs.readIfPresent("timeScale", timeScale_);

    for (const polyPatch& pp : owner.mesh().boundaryMesh())
    {
        if (isA<wallPolyPatch>(pp))
        {
            wallPatches_.append(pp.index());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::langevinDispersionRAS::cacheFields(const bool store)
{
    if (!store)
    {
        return;
    }
    const volScalarField k(turbulence().k());

    setWalls(k);
    if (nearest_.size() != this->owner().mesh().nCells())
    {
        findWalls();
    }
    setCells(k);
}


Foam::vector Foam::langevinDispersionRAS::fluctuation
(
    dustParcel& p,
    const counterRandom::counter& id,
    const vector& Uc,
    const scalar tau,
    const scalar dt
) const
{
    turbulenceSeen t(seen_[p.cell()]);
    useOwnTetrahedron(t, p);
    useOwnWall(t, p.cell(), p.x());
    t.along = turbulenceSeen::tangent(t.n, Uc);

    if (p.tTurb() <= 0)
    {
        langevinStep::start(id, p.UTurb());
    }
    p.tTurb() += dt;

    return langevinStep::advance
    (
        t,
        id,
        p.x(),
        p.U(),
        Uc,
        tau,
        dt,
        p.UTurb()
    );
}


Foam::vector Foam::langevinDispersionRAS::update
(
    const scalar,
    const label,
    const vector&,
    const vector&,
    vector&,
    scalar&
)
{
    FatalErrorInFunction
        << typeName << " needs the particle: see fluctuation()"
        << abort(FatalError);
    return Zero;
}


// ************************************************************************* //
