// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vector.hpp"

#include <algorithm>

namespace dem
{

//- Where a particle is searched for: within width(t) of a point that flies at v from where the
//  particle begins. So near to it until something pushes it; then it gets away.
struct Corridor
{
    Vec3 v = Vec3::Zero();      // [m/s]
    double near = 1e30;         // [m]
    double from = 0;            // when it can first be pushed [s]
    double away = 0;            // how fast it then gets away, at most [m/s]

    double width(double t) const { return near + away*std::max(t - from, 0.0); }
};

}
