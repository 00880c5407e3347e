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

#include "gasLoads.H"
#include "cellCrossing.H"
#include "cellWall.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::gasLoads::atPoint() const
{
    return isA<cellWall<vector>>(td_.UInterp());
}


Foam::point Foam::gasLoads::midway(const point& x) const
{
    const vector way(x - p_.x());
    const scalar cells = cellCrossing(p_.mesh(), p_.cell(), way);
    return cells > 1 ? p_.x() + way/cells : x;
}


Foam::scalar Foam::gasLoads::Re(const scalar slip) const
{
    return td_.rhoc()*slip*p_.d()/max(td_.muc(), ROOTVSMALL);
}


Foam::scalar Foam::gasLoads::drag(const scalar slip)
{
    scalar Sp = 0;
    for (const label i : drags_)
    {
        Sp += forces_[i].calcCoupled
        (
            p_, td_, dt_, mass_, Re(slip), td_.muc()
        ).Sp();
    }
    return Sp;
}


void Foam::gasLoads::setMeanDrag(dem::GasLoad& load)
{
    const dem::Vec3 w = toVec3(p_.U()) - load.Uc;
    const dem::Vec3 end =
        dem::meanDragDetail::endSlip(w, load.Su, effective_, dt_, load.Sp);
    const scalar largest = max(w.norm(), end.norm());

    if (Re(largest) < 1e-3 || (end - w).norm() <= 1e-11*largest)
    {
        return;
    }

    const dem::MeanDrag mean = dem::meanDrag
    (
        w, load.Su, effective_, dt_, drag(w.norm()),
        [this](const scalar slip) { return drag(slip); }
    );
    load.Sp = mean.Sp;
    load.Su = mean.force;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::gasLoads::gasLoads
(
    const forceList& forces,
    const dustParcel& p,
    dustParcel::trackingData& td,
    const scalar dt,
    DynamicList<label>& work
)
:
    forces_(forces),
    p_(p),
    td_(td),
    dt_(dt),
    mass_(p.mass()),
    effective_(forces.massEff(p, td, mass_)),
    coupled_(Zero),
    nonCoupled_(Zero),
    drags_(work)
{
    drags_.clear();

    const scalar Re = p.Re(td);
    const scalar muc = td.muc();

    // One by one, to see which are drag laws
    forAll(forces, i)
    {
        const forceSuSp f(forces[i].calcCoupled(p, td, dt, mass_, Re, muc));
        if (f.Sp() > 0)
        {
            drags_.append(i);
        }
        coupled_ += f;
        nonCoupled_ += forces[i].calcNonCoupled(p, td, dt, mass_, Re, muc);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

dem::GasLoad Foam::gasLoads::here() const
{
    dem::GasLoad load;
    load.Sp = coupled_.Sp();
    load.Uc = toVec3(td_.Uc());
    load.Su = toVec3(coupled_.Su() + nonCoupled_.Su());

    // Stokes: 8 pi mu r^3. The vorticity: see vorticityTorque
    load.SpOmega = constant::mathematical::pi*td_.muc()*pow3(p_.d());

    return load;
}


dem::GasLoad Foam::gasLoads::flight
(
    const vector& fluctuation,
    const brownianStep* noise
)
{
    dem::GasLoad load = here();

    if (atPoint())
    {
        dem::GasLoad first = load;
        if (noise)
        {
            first.Su += toVec3(noise->force(effective_, load.Sp, dt_));
        }
        dem::Particle half;
        half.mass = effective_;
        half.radius = 0.5*p_.d();
        half.x = toVec3(p_.x());
        half.v = toVec3(p_.U());
        dem::fly(half, first, 0.5*dt_);

        load.Uc = toVec3
        (
            td_.UInterp().interpolate(midway(toVector(half.x)), p_.cell())
          + fluctuation
        );
    }
    if (drags_.size())
    {
        setMeanDrag(load);
    }
    if (noise)
    {
        load.Su += toVec3(noise->force(effective_, load.Sp, dt_));
    }

    const scalar share = mass_/effective_;
    load.Sp *= share;
    load.Su *= share;
    return load;
}


Foam::vector Foam::gasLoads::kick
(
    const brownianStep& noise,
    const dem::GasLoad& flight
) const
{
    return noise.kick(effective_, flight.Sp*effective_/mass_, dt_);
}


// ************************************************************************* //
