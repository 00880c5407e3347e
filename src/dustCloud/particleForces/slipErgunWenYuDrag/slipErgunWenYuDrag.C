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

#include "slipErgunWenYuDrag.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(slipErgunWenYuDrag, 0);

    ParticleForce<dustCloud::kinematicCloudType>::
        adddictionaryConstructorToTable<slipErgunWenYuDrag>
        addSlipErgunWenYuDragToTable_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slipErgunWenYuDrag::slipErgunWenYuDrag
(
    cloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    slipDrag(owner, mesh, dict, typeName),
    alphac_(mesh.lookupObject<volScalarField>("alphac"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::forceSuSp Foam::slipErgunWenYuDrag::calcCoupled
(
    const dustParcel& p,
    const dustParcel::trackingData& td,
    const scalar dt,
    const scalar mass,
    const scalar Re,
    const scalar muc
) const
{
    const scalar alpha = alphac_[p.cell()];

    // 0: Ergun, 1: Wen and Yu
    const scalar dilute = min(max((alpha - 0.8)/0.05, scalar(0)), scalar(1));

    scalar Sp = 0;
    if (dilute < 1)
    {
        Sp +=
            (1 - dilute)*p.volume()
           *(150*(1 - alpha)/(alpha*slipCorrection(p.d())) + 1.75*Re)
           *muc/(alpha*sqr(p.d()));
    }
    if (dilute > 0)
    {
        Sp +=
            dilute*pow(alpha, -3.65)
           *slipDrag::calcCoupled(p, td, dt, mass, alpha*Re, muc).Sp();
    }
    return forceSuSp(vector(Zero), Sp);
}


// ************************************************************************* //
