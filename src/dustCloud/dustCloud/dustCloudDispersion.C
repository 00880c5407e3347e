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
#include "langevinDispersionRAS.H"

#include "turbulenceModel.H"

#include "InjectionModelList.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::checkDispersion
(
    const dictionary& subModels,
    const volVectorField& U
)
{
    const word model(subModels.get<word>("dispersionModel"));
    if (model == "none")
    {
        return;
    }

    const auto* turbulencePtr = U.mesh().findObject<turbulenceModel>
    (
        IOobject::groupName(turbulenceModel::propertiesName, U.group())
    );
    const word type
    (
        turbulencePtr
      ? turbulencePtr->lookupOrDefault<word>("simulationType", "laminar")
      : word("laminar")
    );

    if (type != "RAS" && type != "RASModel")
    {
        dustProperties::error
        (
            subModels,
            "dispersionModel",
            "'" + model + "' needs k and epsilon of a RAS turbulence model, "
            "but simulationType in constant/turbulenceProperties is " + type,
            "none, or simulationType RAS"
        );
    }
}


void Foam::dustCloud::warnOfDispersion() const
{
    const word model(subModelProperties_.get<word>("dispersionModel"));

    if (model == "stochasticDispersionRAS")
    {
        WarningInFunction
            << "dispersionModel " << model << ": the variance of each"
            << " component is 0.33 of 2k/3 and the diffusivity 0.33 of u'^2 T"
            << " (T half of its eddy time k/epsilon), both zero where the"
            << " particle step is longer than k/epsilon; tracers gather where"
            << " k is low. langevinDispersionRAS has none of that." << endl;
    }
    else if (model == "gradientDispersionRAS")
    {
        WarningInFunction
            << "dispersionModel " << model << ": fluctuations go down the"
            << " gradient of k only, one way: a mean drift of 0.8 (2k/3)^(1/2)"
            << " there, none across, none where k is uniform or the particle"
            << " step is longer than k/epsilon. langevinDispersionRAS has none"
            << " of that." << endl;
    }
}


Foam::vector Foam::dustCloud::fluctuation
(
    dustParcel& p,
    dustParcel::trackingData& td,
    const scalar dt
)
{
    const label step = dem_->step.number();
    const vector Uc = td.Uc();

    // Keyed, so that neither restart nor decomposition matter
    if (const auto* langevinPtr = isA<langevinDispersionRAS>(dispersion()))
    {
        const scalar mass = p.mass();
        const scalar Sp = forces_.calcCoupled
        (
            p, td, dt, mass, p.Re(td), td.muc()
        ).Sp();

        return langevinPtr->fluctuation
        (
            p,
            {{
                uint32_t(p.origId()),
                uint32_t(p.origProc()),
                uint32_t(step),
                0u
            }},
            Uc,
            mass/max(Sp, VSMALL),
            dt
        );
    }

    rndGen_ = Random(seed(p.origId(), p.origProc(), step));
    p.calcDispersion(*this, td, dt);
    td.Uc() = Uc;

    // What OpenFOAM's models add
    return p.UTurb();
}


// ************************************************************************* //
