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

#include "brownianMotion.H"

// First: includes DEM.hpp
#include "dustProperties.H"

#include "cellCrossing.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(brownianMotion, 0);

    ParticleForce<dustCloud::kinematicCloudType>::
        adddictionaryConstructorToTable<brownianMotion>
        addBrownianMotionToTable_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::brownianMotion::brownianMotion
(
    cloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    ParticleForce<cloudType>(owner, mesh, dict, typeName, true),
    kT_(0)
{
    kT_ = 1.380649e-23*this->coeffs().get<scalar>("T");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::brownianStep Foam::brownianMotion::step
(
    const dustParcel& p,
    const label number
) const
{
    return brownianStep
    (
        kT_,
        {{
            uint32_t(p.origId()),
            uint32_t(p.origProc()),
            uint32_t(number),
            0u
        }}
    );
}


Foam::scalar Foam::brownianMotion::longestStep
(
    const dustParcel& p,
    const dustParcel::trackingData& td,
    const vector& U,
    const scalar maxCo
) const
{
    const scalar muc =
        td.muInterp().interpolate(p.coordinates(), p.currentTetIndices());
    const scalar mass = p.mass();
    const scalar Sp = this->owner().forces().calcCoupled
    (
        p, td, 0, mass, 0, muc
    ).Sp();
    scalar limit = GREAT;

    const scalar gas = cellCrossing(this->mesh(), p.cell(), U);
    if (gas > VSMALL)
    {
        limit = maxCo/gas;
    }

    // tau (1 - e^(-dt/tau)) never exceeds tau
    const scalar own = cellCrossing(this->mesh(), p.cell(), p.U());
    const scalar tau = mass/max(Sp, VSMALL);
    if (own*tau > maxCo)
    {
        limit = min(limit, -tau*std::log1p(-maxCo/(own*tau)));
    }

    if (Sp > 0)
    {
        scalar narrowest = 0;
        for (direction i = 0; i < vector::nComponents; ++i)
        {
            vector axis(Zero);
            axis[i] = 1;
            narrowest =
                max(narrowest, cellCrossing(this->mesh(), p.cell(), axis));
        }
        limit = min(limit, sqr(maxCo/narrowest)*Sp/(2*kT_));
    }

    return limit;
}


// ************************************************************************* //
