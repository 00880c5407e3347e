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

#include "slipDrag.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(slipDrag, 0);

    ParticleForce<dustCloud::kinematicCloudType>::
        adddictionaryConstructorToTable<slipDrag> addSlipDragToTable_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slipDrag::slipDrag
(
    cloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    slipDrag(owner, mesh, dict, typeName)
{}


Foam::slipDrag::slipDrag
(
    cloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict,
    const word& forceType
)
:
    ParticleForce<cloudType>(owner, mesh, dict, forceType, true),
    lambda_(this->coeffs().get<scalar>("lambda")),
    A_
    (
        this->coeffs().lookupOrDefault<vector>("A", vector(1.257, 0.4, 1.1))
    )
{
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::slipDrag::slipCorrection(const scalar d) const
{
    if (lambda_ == 0)
    {
        return 1;
    }
    const scalar Kn = 2*lambda_/d;

    return 1 + Kn*(A_.x() + A_.y()*exp(-A_.z()/Kn));
}


Foam::forceSuSp Foam::slipDrag::calcCoupled
(
    const dustParcel& p,
    const dustParcel::trackingData&,
    const scalar,
    const scalar,
    const scalar Re,
    const scalar muc
) const
{
    const scalar inertia =
        Re > 1000 ? 0.44/24*Re : 1 + 0.15*pow(Re, 0.687);

    return forceSuSp
    (
        vector(Zero),
        3*constant::mathematical::pi*muc*p.d()*inertia
       /slipCorrection(p.d())
    );
}


// ************************************************************************* //
