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

#include "thermophoresis.H"

// First: includes DEM.hpp
#include "dustProperties.H"

#include "fvcGrad.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(thermophoresis, 0);

    ParticleForce<dustCloud::kinematicCloudType>::
        adddictionaryConstructorToTable<thermophoresis>
        addThermophoresisToTable_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::thermophoresis::thermophoresis
(
    cloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    ParticleForce<cloudType>(owner, mesh, dict, typeName, true),
    lambda_(this->coeffs().get<scalar>("lambda")),
    k_(this->coeffs().get<scalar>("conductivityRatio"))
{
    const dictionary& coeffs = this->coeffs();
    const auto& T = mesh.lookupObject<volScalarField>
    (
        coeffs.lookupOrDefault<word>("T", "T")
    );
    const scalar coldest = gMin(T.primitiveField());
    if (!(coldest > 0))
    {
        dustProperties::error
        (
            coeffs,
            coeffs.found("T") ? "T" : "thermophoresis",
            "the field " + T.name() + " has " + Foam::name(coldest) + " K",
            "temperatures above 0 K"
        );
    }
    slope_ = fvc::grad(T)().primitiveField()/T.primitiveField();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::forceSuSp Foam::thermophoresis::calcCoupled
(
    const dustParcel& p,
    const dustParcel::trackingData& td,
    const scalar,
    const scalar,
    const scalar,
    const scalar muc
) const
{
    const scalar Cs = 1.17, Ct = 2.18, Cm = 1.14;
    const scalar Kn = 2*lambda_/p.d();

    return forceSuSp
    (
       -6*constant::mathematical::pi*sqr(muc)*p.d()*Cs*(k_ + Ct*Kn)
       /(td.rhoc()*(1 + 3*Cm*Kn)*(1 + 2*k_ + 2*Ct*Kn))
       *slope_[p.cell()],
        0
    );
}


// ************************************************************************* //
