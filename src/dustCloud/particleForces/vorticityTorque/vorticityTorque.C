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

#include "vorticityTorque.H"

#include "gasVorticity.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(vorticityTorque, 0);

    ParticleForce<dustCloud::kinematicCloudType>::
        adddictionaryConstructorToTable<vorticityTorque> addVorticityTorqueToTable_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::vorticityTorque::vorticityTorque
(
    cloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    ParticleForce<cloudType>(owner, mesh, dict, typeName, false)
{
    const word scheme(owner.solution().interpolationSchemes().lookup("U"));
    if (scheme != "cellWall")
    {
        dustProperties::error
        (
            owner.solution().interpolationSchemes(),
            "U",
            "vorticityTorque: the vorticity at a point is not known to '"
          + scheme + "'",
            "cellWall"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::vorticityTorque::apply
(
    dem::GasLoad& load,
    const dustParcel& p,
    const dustParcel::trackingData& td
) const
{
    load.omegaC = toVec3(0.5*gasVorticity(p, td));
}


// ************************************************************************* //
