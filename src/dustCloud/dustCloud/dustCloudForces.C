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
    }
}


Foam::vector Foam::dustCloud::setGasLoad
(
    dustParcel& p,
    dustParcel::trackingData& td,
    gasLoads& loads,
    const vector& fluctuation,
    const vector& owed,
    const label subStep
)
{
    demData& d = *dem_;
    dem::System& system = *d.system;
    const std::size_t index = std::size_t(p.demIndex());
    const bool flies =
        p.state() != dustParcel::resting
     && p.state() != dustParcel::inContact;

    p.loaded() = true;
    vector kick(Zero);
    dem::GasLoad load;

    if (flies && d.brownian)
    {
        const brownianStep noise(d.brownian->step(p, subStep));
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
        load.Su += toVec3(loads.contactNoise(d.brownian->step(p, subStep), load));
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


// ************************************************************************* //
