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

#include "runForecast.H"
#include "cellCrossing.H"
#include "formatted.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::runForecast::longestStep() const
{
    const volVectorField& U = cloud_.U();
    scalar fastest = 0;
    forAll(U, celli)
    {
        fastest = max
        (
            fastest,
            cellCrossing(cloud_.mesh(), celli, U[celli])
        );
    }
    reduce(fastest, maxOp<scalar>());

    const scalar most = cloud_.solution().dict().lookupOrDefault<scalar>
    (
        "deltaTMax",
        GREAT
    );
    return
        fastest > VSMALL
      ? min(most, cloud_.solution().maxCo()/fastest)
      : most;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::runForecast::runForecast
(
    const dustCloud& cloud,
    const dem::System& system,
    const int material,
    const scalar diameter,
    const scalar speed
)
:
    cloud_(cloud),
    gasSteps_(0),
    particleSteps_(1),
    touchSteps_(0)
{
    const Time& time = cloud.mesh().time();
    const scalar length = time.endTime().value() - time.value();

    // Far from what overflows
    const scalar most = 1e15;
    gasSteps_ =
        length < most*time.deltaTValue()
      ? max(scalar(0), std::ceil(length/time.deltaTValue() - 1e-6))
      : most;
    particleSteps_ = max
    (
        scalar(1),
        std::ceil(min(length, time.deltaTValue())/longestStep() - 1e-6)
    );

    if (diameter > 0)
    {
        const dem::MaterialTable& table = system.materials();
        const scalar mass =
            table.materials()[std::size_t(material)].density
           *constant::mathematical::pi/6*pow3(diameter);
        const dem::ContactFigures f = table.figures
        (
            material, material, 0.5*diameter, 0.5*diameter, mass, mass,
            max(speed, VSMALL)
        );
        const scalar step = min
        (
            f.period/system.timeSettings().stepsPerContact,
            system.timeSettings().boundShare*f.stableStep
        );
        touchSteps_ = restPeriods*f.period/step;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::runForecast::print
(
    Ostream& os,
    const scalar there,
    const scalar due
) const
{
    const scalar n = there + 0.5*due;   // on average
    const scalar steps = gasSteps_*particleSteps_;
    const scalar contactSteps = (there + due)*touchSteps_;
    const scalar cells = cloud_.mesh().globalData().nTotalCells();
    const scalar ranks = Pstream::nProcs();
    const scalar gas =
        cloud_.gasFrozen() ? 0 : gasSteps_*cells*cellSeconds/ranks;
    const scalar seconds =
        gas
      + (steps*n*particleSeconds + contactSteps*contactSeconds)/ranks;

    os  << formatted
        (
            "Forecast: %.3g gas steps, %.3g particle steps, about %.2g contact "
            "steps if each particle touches once and comes to rest, %.3g "
            "particles in the end; memory about %.2g MB on %g ranks, run time "
            "of the order of %.2g s (gas %.2g s)",
            gasSteps_, steps, contactSteps, there + due,
            (
                ranks*rankBytes + (there + due)*particleBytes
              + cells*cellBytes
            )/1e6,
            ranks, seconds, gas
        ).c_str() << nl << endl;
}


// ************************************************************************* //
