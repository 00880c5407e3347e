// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vector.hpp"

#include <cmath>

namespace dem
{

//- A periodic box: length 0 = not periodic in that direction
struct Periodic
{
    Vec3 low = Vec3::Zero();        // [m]
    Vec3 length = Vec3::Zero();     // [m]

    bool on() const { return (length.array() > 0).any(); }

    //- The nearest image of a difference of two positions inside the box
    Vec3 nearest(Vec3 d) const
    {
        for (int k = 0; k < 3; ++k)
        {
            if (d[k] > 0.5*length[k]) d[k] -= length[k];
            else if (d[k] < -0.5*length[k]) d[k] += length[k];
        }
        return d;
    }

    //- The image of x inside the box
    Vec3 wrapped(Vec3 x) const
    {
        for (int k = 0; k < 3; ++k)
        {
            if (length[k] > 0)
            {
                x[k] -= length[k]*std::floor((x[k] - low[k])/length[k]);
            }
        }
        return x;
    }
};

}
