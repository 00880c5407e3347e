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

#include "dustCloudData.H"
#include "cellWall.H"
#include "dustSnapshot.H"

#include "fixedValueFvPatchFields.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::prepareExchange()
{
    for (const entry& e : subModelProperties_.subDict("particleForces"))
    {
        denseDrag_ =
            denseDrag_
         || e.keyword().endsWith("ErgunWenYuDrag")
         || e.keyword() == "WenYuDrag"
         || e.keyword() == "PlessisMasliyahDrag";
    }

    if (twoWay_)
    {
        wordList types
        (
            mesh_.boundary().size(),
            zeroGradientFvPatchVectorField::typeName
        );
        for (const fvPatch& patch : mesh_.boundary())
        {
            if (isA<wallFvPatch>(patch))
            {
                types[patch.index()] = fixedValueFvPatchVectorField::typeName;
            }
        }
        volumeFluxPtr_.reset
        (
            new volVectorField
            (
                IOobject("dustVolumeFlux", mesh_.time().timeName(), mesh_),
                mesh_,
                dimensionedVector(dimVelocity, Zero),
                types
            )
        );
    }
    if (twoWay_ || denseDrag_)
    {
        smoothingPtr_.reset(new diffusiveSmoothing(mesh_));
        updateVoidFraction();
    }
    if (twoWay_)
    {
        exchangePtr_.reset(new momentumExchange(mesh_, smoothingPtr_()));
        dem_->system->keepGasExchange(true);
        alphac_.writeOpt() = IOobject::AUTO_WRITE;
    }
}


void Foam::dustCloud::setSmoothingWidth()
{
    scalar largest = dem_->sizes.largest();
    for (const dustParcel& p : *this)
    {
        largest = max(largest, p.d());
    }
    smoothingPtr_->setWidth(3*returnReduce(largest, maxOp<scalar>()));
}


void Foam::dustCloud::spreadVelocity()
{
    spreadUPtr_.reset(new volVectorField("dustU", U_));
    spreadUPtr_->primitiveFieldRef() = smoothingPtr_()(exchangePtr_->faces().seen(U_)());
    spreadUPtr_->correctBoundaryConditions();

    const word scheme(solution_.interpolationSchemes().lookup("U"));
    if (scheme == cellWall<vector>::typeName)
    {
        tdPtr_->spreadUInterp.reset(new cellWall<vector>(spreadUPtr_(), true));
    }
    else
    {
        tdPtr_->spreadUInterp =
            interpolation<vector>::New(scheme, spreadUPtr_());
    }
}


void Foam::dustCloud::updateVoidFraction()
{
    if (!smoothingPtr_.valid())
    {
        return;
    }
    setSmoothingWidth();

    // With first moments, see cellShares
    cellShares place(mesh_);
    cellShares::sums<scalar> volume(mesh_);
    cellShares::sums<vector> flux(mesh_);
    for (const dustParcel& p : *this)
    {
        place.moveTo(p.x(), p.cell());
        place.add(volume, p.volume());
        if (twoWay_)
        {
            place.add(flux, vector(p.volume()*p.U()));
        }
    }
    place.close(volume);

    // Volume and its flux: spread at once
    const scalarField& V = mesh_.V();
    const label n = twoWay_ ? 4 : 1;
    scalarField all(n*V.size());
    if (twoWay_)
    {
        place.close(flux);
    }
    forAll(V, celli)
    {
        all[celli*n] = volume.cells[celli]/V[celli];
        for (label i = 1; i < n; ++i)
        {
            all[celli*n + i] = flux.cells[celli][i - 1]/V[celli];
        }
    }
    smoothingPtr_->spread(all, n);

    scalarField& alpha = alphac_.primitiveFieldRef();
    forAll(V, celli)
    {
        alpha[celli] = 1 - all[celli*n];
        for (label i = 1; i < n; ++i)
        {
            volumeFluxPtr_()[celli][i - 1] = all[celli*n + i];
        }
    }
    alphac_.correctBoundaryConditions();
    if (twoWay_)
    {
        volumeFluxPtr_->correctBoundaryConditions();
    }

    const scalar lowest = gMin(alpha);
    if (lowest <= 0)
    {
        const label celli = findMin(alpha);
        if (celli >= 0 && alpha[celli] == lowest)
        {
            FatalErrorInFunction
                << "Time " << mesh_.time().timeName() << ": the particles "
                << "about " << mesh_.C()[celli] << " fill " << 1 - lowest
                << " of the space, averaged over " << smoothingPtr_->width()
                << " m: no gas is left" << exit(FatalError);
        }
    }
}


void Foam::dustCloud::closeExchange()
{
    cellShares place(mesh_);
    for (dustParcel& p : *this)
    {
        bringUp(p);
        place.moveTo(p.x(), p.cell());
        exchangePtr_->give(place, p.given());
        exchangePtr_->respond(place, p.response(), p.mass(), p.held());
    }
    exchangePtr_->close
    (
        solution_.trackTime(),
        rho_.primitiveField()*alphac_.primitiveField()*mesh_.V()
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dustCloud::receive(const volVectorField& UOld)
{
    dem::System& system = *dem_->system;
    const vectorField changes
    (
        exchangePtr_->correction(U_, UOld, solution_.trackTime())
    );
    cellShares place(mesh_);
    const cellShares::samples<vector> change(place.sampled(changes));
    const word scheme(solution_.interpolationSchemes().lookup("U"));
    const cellWallGeometry* near =
        scheme == cellWall<vector>::typeName
      ? mesh_.cfindObject<cellWallGeometry>(cellWallGeometry::typeName)
      : nullptr;

    for (dustParcel& p : *this)
    {
        place.moveTo(p.x(), p.cell());
        vector impulse = p.response()*place.value(change);
        exchangePtr_->got(impulse);

        // The gas at a wall changes less than its cell; the wall has the rest
        if (const nearWall* walls = near ? near->walls(p.cell()) : nullptr)
        {
            impulse = walls->reaching(p.x(), impulse);
        }

        if (p.state() == dustParcel::airborne)
        {
            const std::size_t index = std::size_t(p.demIndex());
            system.kick(index, toVec3(impulse));
            p.U() = toVector(system.particle(index).v);
        }
        else if (p.state() == dustParcel::inContact)
        {
            p.owed() = impulse;
        }
    }
    exchangePtr_->balance();
    snapshotPtr_.reset();
    snapshotTimeIndex_ = -1;
}


void Foam::dustCloud::giveLast(dustParcel& p)
{
    if (twoWay_)
    {
        cellShares place(mesh_);
        place.moveTo(p.position(), p.cell());
        exchangePtr_->give(place, p.given());
    }

    // By a cloud function, and not through a patch
    if (p.demIndex() >= 0)
    {
        dem_->parcels.leaves(p);
    }
    if (blocked_.size() && blocked_.last() == &p)
    {
        blocked_.remove();
    }
}


// ************************************************************************* //
