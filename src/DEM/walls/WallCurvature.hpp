// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

namespace dem
{

struct Walls;

//- Principal curvatures of a wall [1/m]: positive where it bulges towards the particles (the
//  outside of a wire has {1/R_w, 0}), negative in a groove or a bore, zero where it is flat
struct WallCurvature
{
    double k1 = 0, k2 = 0;

    bool flat() const { return k1 == 0 && k2 == 0; }

    //- Principal relative curvatures of a sphere of radius r on it [1/m]. All directions of a
    //  sphere are principal ones, so that the curvatures add.
    double smaller(double r) const { return 1/r + std::min(k1, k2); }
    double larger(double r) const { return 1/r + std::max(k1, k2); }
};

//- Curvature of the patches that have none given and consist of analytic shapes alike
void deriveCurvature(Walls& walls);

//- Errors: inputError if the sphere does not fit into a hollow of a patch, or meets one so
//  slim that contactModels/normal/ellipticContact.hpp does not hold. id < 0: of no particle
void checkCurvature(const Walls& walls, double radius, std::int64_t id);

}
