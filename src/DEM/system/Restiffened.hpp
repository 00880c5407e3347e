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
    double misfit = 0;          // largest error of an overlap, over the overlap or delta_0 [-]
    std::int64_t woken = 0;     // those at rest that wake, as an overlap could not be met

    // Largest overlap that two have now who did not touch, over the diameter of the smaller [-]; 0:
    // none. newJ: -1 = a wall
    double newOverlap = 0;
    std::int64_t newI = -1, newJ = -1;

    //- One more of these; of equal ones that of the lowest ids counts
    void add(double overlap, std::int64_t i, std::int64_t j)
    {
        if (overlap < newOverlap || !(overlap > 0)) return;
        const bool lower = i < newI || (i == newI && j < newJ);
        if (overlap == newOverlap && !lower) return;
        newOverlap = overlap;
        newI = i;
        newJ = j;
    }
};

}
