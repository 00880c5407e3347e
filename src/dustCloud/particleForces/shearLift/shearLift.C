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

#include "shearLift.H"
#include "gasVorticity.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::shearLift::shearLift
(
    cloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    SaffmanMeiLiftForce<cloudType>(owner, mesh, dict),
    atPoint_
    (
        word(owner.solution().interpolationSchemes().lookup("U"))
     == cellWall<vector>::typeName
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::shearLift::cacheFields(const bool store)
{
    if (!atPoint_)
    {
        SaffmanMeiLiftForce<cloudType>::cacheFields(store);
    }
}


Foam::forceSuSp Foam::shearLift::calcCoupled
(
    const dustParcel& p,
    const dustParcel::trackingData& td,
    const scalar dt,
    const scalar mass,
    const scalar Re,
    const scalar muc
) const
{
    if (p.state() > dustParcel::airborne)
    {
        return forceSuSp(Zero);
    }
    if (!atPoint_)
    {
        return SaffmanMeiLiftForce<cloudType>::calcCoupled
        (
            p, td, dt, mass, Re, muc
        );
    }

    const vector curl(gasVorticity(p, td));
    return forceSuSp
    (
        mass/p.rho()*td.rhoc()*Cl(p, td, curl, Re, muc)
       *((td.Uc() - p.U()) ^ curl),
        0
    );
}


// ************************************************************************* //
