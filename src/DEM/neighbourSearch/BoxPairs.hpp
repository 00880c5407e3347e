// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of overlapping axis-aligned boxes.
#pragma once

#include "neighbourSearch/Periodic.hpp"
#include "particles/vector.hpp"

#include <functional>
#include <vector>

namespace dem
{

struct Box
{
    Vec3 low, high;

    bool overlaps(const Box& o) const
    {
        return
            (low.array() <= o.high.array()).all()
         && (o.low.array() <= high.array()).all();
    }

    void include(const Box& o)
    {
        low = low.cwiseMin(o.low);
        high = high.cwiseMax(o.high);
    }
};

//- Calls found(i, j), i < j, once for each pair of overlapping boxes, in no fixed order.
//  Boxes are binned by their middle in cells as large as the largest box.
void boxPairs
(
    const std::vector<Box>& boxes, const std::function<void(int, int)>& found
);

//- The same among boxes with their middles in a periodic box; a pair may be found twice
void boxPairs
(
    std::vector<Box> boxes, const Periodic& periodic,
    const std::function<void(int, int)>& found
);

}
