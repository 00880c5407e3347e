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
#include "brownianMotion.H"
#include "cellWall.H"
#include "gasLoads.H"
#include "vorticityTorque.H"
#include "wallShear.H"

#include "DispersionModel.H"
#include "GravityForce.H"
#include "InjectionModelList.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::findOwnForces()
{
    demData& d = *dem_;
    for (const auto& force : forces_)
    {
        d.brownian = d.brownian ? d.brownian : isA<brownianMotion>(force);
        d.vorticity = d.vorticity ? d.vorticity : isA<vorticityTorque>(force);
        d.shear = d.shear ? d.shear : isA<wallShear>(force);
        if (const auto* weight = isA<GravityForce<kinematicCloudType>>(force))
        {
            d.gravity = weight->g();
        }
    }
}


Foam::vector Foam::dustCloud::setGasLoad
(
    dustParcel& p,
    dustParcel::trackingData& td,
    gasLoads& loads,
    const vector& fluctuation,
    const vector& owed
)
{
    demData& d = *dem_;
    dem::System& system = *d.system;
    const std::size_t index = std::size_t(p.demIndex());
    const bool flies =
        p.state() != dustParcel::resting
     && p.state() != dustParcel::inContact;

    p.loaded() = true;
    p.loadHolds() = true;
    vector kick(Zero);
    dem::GasLoad load;

    if (flies && d.brownian)
    {
        const brownianStep noise(d.brownian->step(p, d.step.number()));
        load = loads.flight(fluctuation, &noise);
        kick = loads.kick(noise, load);
    }
    else if (flies)
    {
        load = loads.flight(fluctuation);
    }
    else
    {
        load = loads.here();
    }

    const dem::Vec3 wall =
        d.shear && !flies ? system.wallNormal(index) : dem::Vec3::Zero();
    if (wall.squaredNorm() > 0)
    {
        d.shear->apply(load, p, td, wall);
    }
    else if (d.vorticity)
    {
        d.vorticity->apply(load, p, td);
    }

    if (d.brownian && p.state() == dustParcel::inContact)
    {
        load.Su += toVec3(loads.contactNoise(d.brownian->step(p, d.step.number()), load));
        p.loaded() = false;     // a new one in each step
    }

    if (twoWay_ && p.state() == dustParcel::inContact)
    {
        // Of all dust there, as if it had this particle's drag per volume
        const scalar alpha = alphac_[p.cell()];
        const scalar a =
            load.Sp*solution_.trackTime()*(1 - alpha)
           /(p.volume()*td.rhoc()*alpha);
        load.apart = a > SMALL ? -std::expm1(-a)/a : 1;
    }

    load.Su += toVec3(owed);
    system.setGasLoad(index, load);
    return kick;
}


void Foam::dustCloud::setGasLoads
(
    dustParcel::trackingData& td,
    const scalar dt,
    const bool begins
)
{
    demData& d = *dem_;

    // From x itself: the last bits of the tracked position depend on the
    // decomposition
    const bool atPoint = isA<cellWall<vector>>(td.UInterp());

    DynamicList<label> drags;

    // Turbulence changes what the gas does to those at rest, too
    const UList<dustParcel*>& parcels =
        begins
      ? d.parcels.toLoad(*d.system, d.dispersion)
      : d.parcels.withoutLoad(*d.system);

    for (dustParcel* pPtr : parcels)
    {
        dustParcel& p = *pPtr;
        const bool resting = p.state() == dustParcel::resting;

        // At rest in a gas that does not change (one that is solved: within
        // the gas step): nothing new
        if (p.loaded() && (resting || !twoWay_) && !d.dispersion)
        {
            continue;
        }
        if (twoWay_ && resting)
        {
            bringUp(p);
        }

        const tetIndices tets(p.currentTetIndices());
        td.rhoc() = td.rhoInterp().interpolate(p.coordinates(), tets);
        td.muc() = td.muInterp().interpolate(p.coordinates(), tets);
        td.Uc() =
            atPoint
          ? td.UInterp().interpolate(p.x(), p.cell())
          : td.UInterp().interpolate(p.coordinates(), tets);
        const vector Umean = td.Uc();

        // Of those that enter, what is left of it
        const scalar flown = min(dt, dt + p.age());

        if (d.dispersion)
        {
            td.Uc() += fluctuation(p, td, flown);
        }

        gasLoads loads(forces_, p, td, flown, drags);
        const forceSuSp& coupled = loads.coupled();
        const vector Su = coupled.Su() + loads.nonCoupled().Su();

        if
        (
            !dem::isFinite(coupled.Sp()) || !dem::isFinite(toVec3(Su))
         || !dem::isFinite(toVec3(td.Uc())) || coupled.Sp() < 0
        )
        {
            FatalErrorInFunction
                << "Impossible gas force on particle " << p.origProc() << ':'
                << p.origId() << " at " << p.x() << " in cell " << p.cell()
                << ": Sp " << coupled.Sp() << " kg/s, Su " << Su
                << " N, gas velocity " << td.Uc() << " m/s"
                << exit(FatalError);
        }

        const vector owed = p.owed()/dt;
        p.kick() = setGasLoad(p, td, loads, td.Uc() - Umean, owed);
        p.nonCoupled() = loads.nonCoupled().Su() + owed;
    }
}


// ************************************************************************* //
