// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace dem
{

//- What a change of chi did to the contacts that there were, of all ranks (Stiffening.hpp)
struct Restiffened
{
    std::int64_t contacts = 0;  // all
    std::int64_t similar = 0;   // of them, those that kept a/a0 instead of their force
    double normal = 0;          // change of the energy that normal forces store [J]
    double springs = 0;         // of that of the springs [J]
    double farthest = 0;        // way by which a particle was set aside [m]
    double misfit = 0;          // largest error of an overlap, over the overlap [-]
};

}
