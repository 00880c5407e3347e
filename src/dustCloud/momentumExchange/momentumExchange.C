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

#include "momentumExchange.H"
#include "zeroGradientFvPatchFields.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::momentumExchange::implicitness
(
    const scalar flying,
    const scalar held,
    const scalar square
)
{
    // Below that the implicit part is nothing
    const scalar least = 1e-9;
    scalar theta = 0.5;

    if (flying > least)
    {
        const scalar q = min(square/flying, 1 - 1e-15);
        const scalar loading = flying/q;
        const scalar f =
            -loading/(1 + loading)*std::expm1((1 + loading)*std::log1p(-q));
        theta = max(theta, 1/f - 1/flying);
    }
    if (held > least)
    {
        theta = max(theta, -1/std::expm1(-min(held, scalar(500))) - 1/held);
    }
    return theta;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentumExchange::momentumExchange
(
    const fvMesh& mesh,
    const diffusiveSmoothing& smoothing
)
:
    mesh_(mesh),
    smoothing_(smoothing),
    faces_(mesh),
    impulse_(mesh),
    flying_(mesh),
    held_(mesh),
    flyingSquare_(mesh),
    force_
    (
        IOobject("dustForce", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimForce/dimVolume, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    resistance_
    (
        IOobject("dustResistance", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimDensity/dimTime, Zero)
    ),
    alongFaces_
    (
        IOobject("dustForceAlongFaces", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimForce/dimArea, Zero)
    ),
    onFaces_
    (
        IOobject("dustResistanceOnFaces", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimDensity/dimTime, Zero)
    ),
    toParticles_(mesh.nCells(), Zero),
    throughFaces_(mesh.nCells(), Zero),
    implicitness_(mesh.nCells(), 1),
    imbalance_(0)
{
    reset();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentumExchange::reset()
{
    impulse_.reset();
    flying_.reset();
    held_.reset();
    flyingSquare_.reset();
    givenByGas_ = Zero;
    gotByParticles_ = Zero;
    exchanged_ = 0;
}


void Foam::momentumExchange::give
(
    const cellShares& place,
    const vector& impulse
)
{
    place.add(impulse_, impulse);
    gotByParticles_ += impulse;
    exchanged_ += mag(impulse);
}


void Foam::momentumExchange::respond
(
    const cellShares& place,
    const scalar response,
    const scalar mass,
    const bool held
)
{
    if (held)
    {
        place.add(held_, response);
    }
    else
    {
        place.add(flying_, response);
        place.add(flyingSquare_, sqr(response)/mass);
    }
}


void Foam::momentumExchange::close(const scalar dt, const scalarField& gasMass)
{
    const scalarField& V = mesh_.V();
    const cellShares shares(mesh_);
    shares.close(impulse_);
    shares.close(flying_);
    shares.close(held_);
    shares.close(flyingSquare_);

    // Impulse, response of what flies, of what is held, square: at once
    const label n = 6;
    scalarField all(n*V.size());
    forAll(V, celli)
    {
        scalar* of = &all[celli*n];
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            of[d] = impulse_.cells[celli][d]/V[celli];
        }
        of[3] = flying_.cells[celli]/V[celli];
        of[4] = held_.cells[celli]/V[celli];
        of[5] = flyingSquare_.cells[celli]/V[celli];
    }
    smoothing_.spread(all, n);

    const scalarField gas(gasMass/V);

    forAll(V, celli)
    {
        const scalar* of = &all[celli*n];
        const scalar flying = of[3];
        const scalar held = of[4];

        force_[celli] = -vector(of[0], of[1], of[2])/dt;
        implicitness_[celli] = implicitness
        (
            flying/gas[celli],
            held/gas[celli],
            of[5]/gas[celli]
        );
        resistance_[celli] = implicitness_[celli]*(flying + held)/dt;
    }
    force_.correctBoundaryConditions();
    resistance_.correctBoundaryConditions();
}


void Foam::momentumExchange::act()
{
    alongFaces_ = faces_.along(force_);
    onFaces_ = faces_.onFaces(resistance_);
    toParticles_ = faces_.resistance(onFaces_);
    throughFaces_ = toParticles_ + faces_.wallResistance(resistance_);
}


Foam::tmp<Foam::vectorField> Foam::momentumExchange::correction
(
    const vectorField& U,
    const vectorField& UOld,
    const scalar dt
)
{
    const vectorField change(U - UOld);
    const scalarField Vdt(mesh_.V()*dt);

    givenByGas_ = sum
    (
        Vdt*((toParticles_ & change) - force_.primitiveField())
    );
    exchanged_ += sum(Vdt*resistance_.primitiveField()*mag(U));

    return smoothing_(implicitness_*faces_.seen(change)());
}


void Foam::momentumExchange::balance()
{
    reduce(givenByGas_, sumOp<vector>());
    reduce(gotByParticles_, sumOp<vector>());
    reduce(exchanged_, sumOp<scalar>());

    if (exchanged_ > 0)
    {
        imbalance_ =
            max(imbalance_, mag(givenByGas_ - gotByParticles_)/exchanged_);
    }
}



// ************************************************************************* //
