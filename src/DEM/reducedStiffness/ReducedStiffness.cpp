// SPDX-License-Identifier: GPL-3.0-or-later
#include "reducedStiffness/ReducedStiffness.hpp"

#include <cmath>

namespace dem
{

double ReducedStiffness::surfaceEnergyFactor() const
{
    return scaleSurfaceEnergy ? std::pow(ratio, 0.4) : 1;
}

}
