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
#include "rehearsal.H"
#include "slipLoads.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <chrono>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What is left of the run [s]. With stopAt writeNow and the like no end is given: a step
static scalar lengthOf(const Time& time)
{
    const scalar end = time.endTime().value();
    return
        end < 0.5*GREAT
      ? max(scalar(0), end - time.value())
      : time.deltaTValue();
}

} // End namespace Foam


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


Foam::scalar Foam::runForecast::residence() const
{
    const fvMesh& mesh = cloud_.mesh();
    scalar inflow = 0;
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (!patch.coupled())
        {
            const scalarField flux
            (
                cloud_.U().boundaryField()[patchi] & patch.Sf()
            );
            inflow += sum(max(-flux, scalar(0)));
        }
    }
    reduce(inflow, sumOp<scalar>());
    return
        inflow > VSMALL
      ? min(length_, gSum(mesh.V().field())/inflow)
      : length_;
}


Foam::scalar Foam::runForecast::productSeconds() const
{
    const lduAddressing& address = cloud_.mesh().lduAddr();
    const labelUList& lower = address.lowerAddr();
    const labelUList& upper = address.upperAddr();
    const scalarField a(lower.size(), 0.1);
    scalarField x(cloud_.mesh().nCells(), 1);
    scalarField y(x);

    // The shortest of some: other jobs do not count
    scalar least = GREAT;
    for (int k = 0; k < 10; ++k)
    {
        const auto start = std::chrono::steady_clock::now();
        y = x;
        forAll(a, facei)
        {
            y[lower[facei]] += a[facei]*x[upper[facei]];
            y[upper[facei]] += a[facei]*x[lower[facei]];
        }
        x = 0.5*y;      // used, so that no compiler leaves it out
        least = min
        (
            least,
            std::chrono::duration<scalar>
            (
                std::chrono::steady_clock::now() - start
            ).count()
        );
    }
    return returnReduce(least, maxOp<scalar>());
}


Foam::label Foam::runForecast::systems() const
{
    const dictionary controls
    (
        cloud_.mesh().solutionDict().subOrEmptyDict("PIMPLE")
    );
    const label outer = controls.lookupOrDefault<label>("nOuterCorrectors", 1);
    const label inner = controls.lookupOrDefault<label>("nCorrectors", 1);
    const label again =
        controls.lookupOrDefault<label>("nNonOrthogonalCorrectors", 0);
    const bool predictor =
        controls.lookupOrDefault<Switch>("momentumPredictor", true);
    return outer*((predictor ? 3 : 0) + inner*(1 + again));
}


void Foam::runForecast::addWork
(
    const dem::System& system,
    const slipLoads& loads,
    const scalarList& moving,
    const scalarList& due
)
{
    const scalar flown = residence();

    for (const dem::RatioDust& dust : loads.dusts())
    {
        if (dust.loads.empty())
        {
            continue;
        }
        const scalar there = moving[dust.material];
        const scalar come = due[dust.material];
        const rehearsal tried
        (
            system, dust.material, dust.loads[dust.loads.size()/2]
        );

        // Those that come are there for half of the rest, on average
        const scalar flights =
            (there*flown + come*min(flown, 0.5*length_))
           *particleSteps_/length_;
        const scalar contactSteps =
            there*tried.contactSteps(length_)
          + touching*come*tried.contactSteps(0.5*length_);

        flights_ += flights;
        contactSteps_ += contactSteps;
        flightSeconds_ +=
            flights*perFlight*tried.flightSeconds()/Pstream::nProcs();
        contactSeconds_ +=
            contactSteps*tried.contactSeconds()/Pstream::nProcs();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::runForecast::runForecast
(
    const dustCloud& cloud,
    const dem::System& system,
    const slipLoads& loads,
    const scalarList& due
)
:
    cloud_(cloud),
    length_(lengthOf(cloud.mesh().time()))
{
    // Far from what overflows
    const scalar most = 1e15;
    const scalar deltaT = cloud.mesh().time().deltaTValue();
    gasSteps_ =
        length_ < most*deltaT
      ? max(scalar(0), std::ceil(length_/deltaT - 1e-6))
      : most;
    // In frozen gas they go on over gas steps
    const scalar span = cloud.gasFrozen() ? length_ : min(length_, deltaT);
    particleSteps_ =
        (cloud.gasFrozen() ? min(gasSteps_, scalar(1)) : gasSteps_)
       *max(scalar(1), std::ceil(span/longestStep() - 1e-6));

    scalarList moving(due.size(), Zero);
    for (const std::size_t i : system.awake())
    {
        ++moving[system.particle(i).material];
    }
    Pstream::listCombineGather(moving, plusEqOp<scalar>());
    Pstream::listCombineScatter(moving);
    particles_ =
        returnReduce(scalar(system.size()), sumOp<scalar>()) + sum(due);

    flightSeconds_ = particleSteps_*stepSeconds;
    if (!cloud.gasFrozen())
    {
        gasSeconds_ =
            gasSteps_*systems()*perSystem*productSeconds()
           *(cloud.twoWay() ? 1 + exchangeShare : 1);
    }
    if (gasSteps_ >= 1)
    {
        addWork(system, loads, moving, due);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::runForecast::print(Ostream& os) const
{
    const scalar cells = cloud_.mesh().globalData().nTotalCells();
    const scalar ranks = Pstream::nProcs();
    const scalar seconds = gasSeconds_ + flightSeconds_ + contactSeconds_;

    os  << formatted
        (
            "Forecast: %.3g gas steps, %.3g particle steps, about %.2g flights "
            "of particles over one and %.2g contact steps; %.3g particles in "
            "the end; about %.2g MB on %g ranks, and %.2g s (gas %.2g, flights "
            "%.2g, contacts %.2g)",
            gasSteps_, particleSteps_, flights_, contactSteps_, particles_,
            (
                ranks*rankBytes + particles_*particleBytes + cells*cellBytes
            )/1e6,
            ranks, seconds, gasSeconds_, flightSeconds_, contactSeconds_
        ).c_str() << nl;

    if (seconds > week)
    {
        os  << "  Warning: this run takes about " << seconds/86400
            << " days on " << ranks << " ranks. A longer deltaT, an earlier"
            << " endTime or fewer particles shorten it" << nl;
    }
    os  << endl;
}


// ************************************************************************* //
