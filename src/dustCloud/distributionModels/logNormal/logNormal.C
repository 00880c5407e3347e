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

// First: includes DEM.hpp
#include "dustProperties.H"

#include "logNormal.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace distributionModels
{
    defineTypeNameAndDebug(logNormal, 0);
    addToRunTimeSelectionTable(distributionModel, logNormal, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Share of the standard normal distribution below z
static scalar normalShare(const scalar z)
{
    return 0.5*std::erfc(-z/std::sqrt(2.0));
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::distributionModels::logNormal::logNormal
(
    const dictionary& dict,
    Random& rndGen
)
:
    distributionModel(typeName, dict, rndGen),
    minValue_(distributionModelDict_.get<scalar>("minValue")),
    maxValue_(distributionModelDict_.get<scalar>("maxValue")),
    median_(distributionModelDict_.get<scalar>("median")),
    sigma_
    (
        std::log
        (
            distributionModelDict_.get<scalar>("geometricStandardDeviation")
        )
    )
{
    if
    (
        !(minValue_ > 0 && maxValue_ > minValue_ && median_ > 0 && sigma_ > 0)
    )
    {
        dustProperties::error
        (
            distributionModelDict_,
            "median",
            "and its neighbours make no distribution",
            "0 < minValue < maxValue, median > 0, geometricStandardDeviation"
            " > 1"
        );
    }

    // What is sampled divides by it
    const scalar share =
        normalShare(std::log(maxValue_/median_)/sigma_)
      - normalShare(std::log(minValue_/median_)/sigma_);

    if (share < 1e-9)
    {
        dustProperties::error
        (
            distributionModelDict_,
            "median",
            "between minValue and maxValue lies a share of "
          + Foam::name(share) + " of the particles of median "
          + Foam::name(median_) + " m",
            "a median near minValue " + Foam::name(minValue_)
          + " m to maxValue " + Foam::name(maxValue_) + " m"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::distributionModels::logNormal::sample() const
{
    scalar zLow = std::log(minValue_/median_)/sigma_;
    scalar zHigh = std::log(maxValue_/median_)/sigma_;

    const scalar low = normalShare(zLow);
    const scalar share =
        low + rndGen_.sample01<scalar>()*(normalShare(zHigh) - low);

    // Bisection: to the last bit, and never outside
    for (label i = 0; i < 60; ++i)
    {
        const scalar z = 0.5*(zLow + zHigh);
        (normalShare(z) < share ? zLow : zHigh) = z;
    }

    return
        min(maxValue_, max(minValue_, median_*std::exp(sigma_*0.5*(zLow + zHigh))));
}


Foam::scalar Foam::distributionModels::logNormal::meanValue() const
{
    const scalar zLow = std::log(minValue_/median_)/sigma_;
    const scalar zHigh = std::log(maxValue_/median_)/sigma_;

    return
        median_*std::exp(0.5*sqr(sigma_))
       *(normalShare(zHigh - sigma_) - normalShare(zLow - sigma_))
       /(normalShare(zHigh) - normalShare(zLow));
}


// ************************************************************************* //
