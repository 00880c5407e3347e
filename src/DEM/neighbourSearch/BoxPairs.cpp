// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbourSearch/BoxPairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace dem
{

void boxPairs
(
    const std::vector<Box>& boxes, const std::function<void(int, int)>& found
)
{
    const int n = int(boxes.size());
    if (n < 2) return;

    const auto test = [&](int i, int j)
    {
        if (boxes[std::size_t(i)].overlaps(boxes[std::size_t(j)]))
        {
            found(std::min(i, j), std::max(i, j));
        }
    };

    if (n <= 16)
    {
        for (int i = 0; i < n; ++i)
        {
            for (int j = i + 1; j < n; ++j) test(i, j);
        }
        return;
    }

    Vec3 low = boxes[0].low, high = boxes[0].high;
    double size = 0;
    for (const Box& b : boxes)
    {
        low = low.cwiseMin(b.low);
        high = high.cwiseMax(b.high);
        size = std::max(size, (b.high - b.low).maxCoeff());
    }
    // at most 2^20 cells along an edge, so that three numbers fit into one key
    size = std::max(size*(1 + 1e-9), (high - low).maxCoeff()/1048000.0);
    if (!(size > 0)) size = 1;

    constexpr std::int64_t one = 1, shift = 21;
    struct Entry { std::int64_t key; int box; };
    std::vector<Entry> entries(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
    {
        const Box& b = boxes[std::size_t(i)];
        std::int64_t key = 0;
        for (int d = 0; d < 3; ++d)
        {
            const double middle = 0.5*(b.low[d] + b.high[d]) - low[d];
            key = (key << shift) + std::int64_t(middle/size) + 1;
        }
        entries[std::size_t(i)] = {key, i};
    }
    std::sort
    (
        entries.begin(), entries.end(),
        [](const Entry& a, const Entry& b)
        {
            return a.key < b.key || (a.key == b.key && a.box < b.box);
        }
    );

    // Rows of three cells along the last axis are contiguous in key: with the own row that
    // is 1 + 4 half rows. One pointer per row moves on with the cells.
    const std::int64_t rows[4] =
    {
        one << shift,
        (one << (2*shift)) - (one << shift),
        one << (2*shift),
        (one << (2*shift)) + (one << shift)
    };
    std::size_t pointer[4] = {0, 0, 0, 0};
    const std::size_t count = entries.size();

    for (std::size_t first = 0; first < count;)
    {
        std::size_t last = first;
        const std::int64_t key = entries[first].key;
        while (last < count && entries[last].key == key) ++last;

        for (std::size_t a = first; a < last; ++a)
        {
            // the own cell and the next along the row
            for (std::size_t b = a + 1; b < count && entries[b].key <= key + 1; ++b)
            {
                test(entries[a].box, entries[b].box);
            }
        }
        for (int r = 0; r < 4; ++r)
        {
            const std::int64_t from = key + rows[r] - 1, to = key + rows[r] + 1;
            std::size_t& p = pointer[r];
            while (p < count && entries[p].key < from) ++p;
            for (std::size_t b = p; b < count && entries[b].key <= to; ++b)
            {
                for (std::size_t a = first; a < last; ++a)
                {
                    test(entries[a].box, entries[b].box);
                }
            }
        }
        first = last;
    }
}


void boxPairs
(
    std::vector<Box> boxes, const Periodic& periodic,
    const std::function<void(int, int)>& found
)
{
    // images of what sticks out of the box, on the other side
    const std::size_t n = boxes.size();
    std::vector<int> original(n);
    for (std::size_t i = 0; i < n; ++i) original[i] = int(i);
    for (int d = 0; d < 3; ++d)
    {
        if (!(periodic.length[d] > 0)) continue;
        Vec3 shift = Vec3::Zero();
        shift[d] = periodic.length[d];
        for (std::size_t i = 0, present = boxes.size(); i < present; ++i)
        {
            const Box b = boxes[i];
            const int who = original[i];
            if (b.low[d] < periodic.low[d])
            {
                boxes.push_back({b.low + shift, b.high + shift});
                original.push_back(who);
            }
            if (b.high[d] > periodic.low[d] + periodic.length[d])
            {
                boxes.push_back({b.low - shift, b.high - shift});
                original.push_back(who);
            }
        }
    }

    boxPairs
    (
        boxes,
        [&](int i, int j)
        {
            const int a = original[std::size_t(i)], b = original[std::size_t(j)];
            if (a != b) found(std::min(a, b), std::max(a, b));
        }
    );
}

}
