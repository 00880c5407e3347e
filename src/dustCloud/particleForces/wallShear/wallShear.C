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

#include "wallShear.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(wallShear, 0);

    ParticleForce<dustCloud::kinematicCloudType>::
        adddictionaryConstructorToTable<wallShear> addWallShearToTable_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallShear::wallShear
(
    cloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    ParticleForce<cloudType>(owner, mesh, dict, typeName, false)
{
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallShear::apply
(
    dem::GasLoad& load,
    const dustParcel& p,
    const dustParcel::trackingData& td,
    const dem::Vec3& n
) const
{
    const scalar r = 0.5*p.d();
    const dem::Vec3 along = load.Uc - load.Uc.dot(n)*n;

    load.Sp *= 1.7009;
    load.omegaC = 0.944/(2*r)*along.cross(n);
    load.Su -= 9.22*td.rhoc()*r*r*along.squaredNorm()*n;
}


// ************************************************************************* //
