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
    const double realMargin =
        2*surfaceEnergy/(8*gasViscosity*slipVelocity)*(wall ? 2 : 1);

    return realMargin > margin ? std::pow(margin/realMargin, 2.5) : 1;
}

}
