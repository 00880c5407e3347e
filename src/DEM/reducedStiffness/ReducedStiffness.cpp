// SPDX-License-Identifier: GPL-3.0-or-later
#include "reducedStiffness/ReducedStiffness.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

double ReducedStiffness::surfaceEnergyFactor() const
{
    return scaleSurfaceEnergy ? std::pow(ratio, 0.4) : 1;
}

double softestRatioForMargin
(
    double surfaceEnergy,
    double gasViscosity,
    double slipVelocity,
    double margin,
    bool wall
)
{
    // No quotient of what may be 0: gas at rest, surfaces that do not adhere
    const double pullOff = 2*surfaceEnergy*(wall ? 2 : 1);
    const double least = margin*8*gasViscosity*slipVelocity;

    return pullOff > least ? std::pow(least/pullOff, 2.5) : 1;
}

}
