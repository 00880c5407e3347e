// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where particles have to go for their contacts to get other overlaps (Stiffening.hpp).
//
// A first guess follows the contacts away from the walls, each particle at the mean of where those
// before it put it: exact where contacts make trees. A cluster that flies follows them from any of
// its particles if it is a tree, else its guess is to stay. What is then still missing is made as
// small as it can be in the sum of its squares over all contacts (Gauss-Newton, each step by
// conjugate gradients): 0 where all can be met, else shared by all who stand in each other's way.
// So it does not depend on ids, but by round-off. The centre of mass of what flies stays.
// Proof: tests/unit/DEM/stiffening.cpp
#pragma once

#include "particles/vector.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace dem
{

//- A contact, as far as it matters for that
struct Gap
{
    std::int64_t i, j;      // j = -1: wall
    Vec3 n;                 // from i to j
    double distance;        // of the centres [m]; wall: any
    double open;            // to move apart by [m]
    double mi, mj;          // [kg]

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.i);
        f(s.j);
        f(s.n);
        f(s.distance);
        f(s.open);
        f(s.mi);
        f(s.mj);
    }
};

//- Where particles go to, by id [m]
using Ways = std::unordered_map<std::int64_t, Vec3>;

//- gaps: all that there are, in any order
Ways setAside(std::vector<Gap> gaps);

//- By how much the two of a gap have moved apart [m]
double opened(const Gap& gap, const Vec3& wayI, const Vec3& wayJ);

}
