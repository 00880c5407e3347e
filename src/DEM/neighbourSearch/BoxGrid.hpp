// SPDX-License-Identifier: GPL-3.0-or-later
//
// Overlaps among axis-aligned boxes, which may be periodic.
#pragma once

#include "neighbourSearch/Periodic.hpp"
#include "particles/vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

    bool contains(const Box& o) const
    {
        return
            (low.array() <= o.low.array()).all()
         && (o.high.array() <= high.array()).all();
    }

    void include(const Box& o)
    {
        low = low.cwiseMin(o.low);
        high = high.cwiseMax(o.high);
    }

    Box moved(const Vec3& shift) const { return {low + shift, high + shift}; }
    Vec3 middle() const { return 0.5*(low + high); }
};


//- Calls f(image of b) for b and its images that reach into the period
template<class F>
void periodicImages(const Box& b, const Periodic& periodic, F&& f)
{
    double shifts[3][3];
    int n[3];
    for (int d = 0; d < 3; ++d)
    {
        n[d] = 0;
        shifts[d][n[d]++] = 0;
        const double length = periodic.length[d];
        if (!(length > 0)) continue;
        if (b.low[d] < periodic.low[d]) shifts[d][n[d]++] = length;
        if (b.high[d] > periodic.low[d] + length) shifts[d][n[d]++] = -length;
    }
    for (int x = 0; x < n[0]; ++x)
    {
        for (int y = 0; y < n[1]; ++y)
        {
            for (int z = 0; z < n[2]; ++z)
            {
                f(b.moved(Vec3(shifts[0][x], shifts[1][y], shifts[2][z])));
            }
        }
    }
}


//- Boxes sorted by their middles into cells as large as the largest box
class BoxGrid
{
public:

    //- The boxes stay the caller's. Where there is a period, their middles are inside it.
    explicit BoxGrid(const std::vector<Box>& boxes, const Periodic& periodic = {});

    //- Sort the caller's boxes, as they are now
    void build(const Periodic& periodic);

    //- Calls found(i, j), i < j, for each pair of boxes that overlap, in no fixed order; a
    //  pair may be found twice where there is a period
    template<class Found>
    void pairs(Found&& found) const;

    //- To be told when the caller has changed box i
    void changed(int i);

    //- Calls found(j) for each box j that overlaps b
    template<class Found>
    void overlapping(const Box& b, Found&& found) const;


private:

    struct Entry { std::int64_t key; int box; };

    std::int64_t key(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return (x*cells_[1] + y)*cells_[2] + z;
    }

    std::int64_t cell(int d, double x) const
    {
        // one empty layer around all: neighbours never wrap into another row
        const double c = std::floor((x - low_[d])/size_) + 1;
        return std::int64_t(std::min(std::max(c, 0.0), double(cells_[d] - 1)));
    }

    void sort();

    const std::vector<Box>& boxes_;
    Periodic periodic_;
    std::vector<Box> all_;          // with images, where there is a period
    std::vector<int> original_;     // of images, counted from boxes_.size()
    Vec3 low_ = Vec3::Zero();
    double size_ = 1;
    std::int64_t cells_[3] = {1, 1, 1};
    std::vector<Entry> entries_, scratch_;
    std::vector<Vec3> middles_;     // when the grid was made
    double farthest_ = 0;           // side of any box from there, along an axis
};


template<class Found>
void BoxGrid::pairs(Found&& found) const
{
    const std::vector<Box>& boxes = periodic_.on() ? all_ : boxes_;
    const int n = int(middles_.size());
    const auto who = [&](int i) { return i < n ? i : original_[std::size_t(i - n)]; };
    const auto test = [&](int a, int b)
    {
        if (!boxes[std::size_t(a)].overlaps(boxes[std::size_t(b)])) return;
        const int i = who(a), j = who(b);
        if (i != j) found(std::min(i, j), std::max(i, j));
    };

    // Rows of three cells along the last axis are contiguous in key: with the own row that
    // is 1 + 4 half rows. One pointer per row moves on with the cells.
    const std::int64_t rows[4] = {key(0, 1, 0), key(1, -1, 0), key(1, 0, 0), key(1, 1, 0)};
    std::size_t pointer[4] = {0, 0, 0, 0};
    const std::size_t count = entries_.size();
    for (std::size_t first = 0; first < count;)
    {
        std::size_t last = first;
        const std::int64_t here = entries_[first].key;
        while (last < count && entries_[last].key == here) ++last;

        for (std::size_t a = first; a < last; ++a)
        {
            // the own cell and the next along the row
            for (std::size_t b = a + 1; b < count && entries_[b].key <= here + 1; ++b)
            {
                test(entries_[a].box, entries_[b].box);
            }
        }
        for (int r = 0; r < 4; ++r)
        {
            const std::int64_t from = here + rows[r] - 1, to = here + rows[r] + 1;
            std::size_t& p = pointer[r];
            while (p < count && entries_[p].key < from) ++p;
            for (std::size_t b = p; b < count && entries_[b].key <= to; ++b)
            {
                for (std::size_t a = first; a < last; ++a)
                {
                    test(entries_[a].box, entries_[b].box);
                }
            }
        }
        first = last;
    }
}


template<class Found>
void BoxGrid::overlapping(const Box& b, Found&& found) const
{
    const double half = farthest_;
    // boxes that stick out of the period reach b from the other side
    const Box wide{b.low.array() - half, b.high.array() + half};
    periodicImages(wide, periodic_, [&](const Box& region)
    {
        const Box image{region.low.array() + half, region.high.array() - half};
        std::int64_t from[3], to[3];
        for (int d = 0; d < 3; ++d)
        {
            from[d] = cell(d, region.low[d]);
            to[d] = cell(d, region.high[d]);
        }
        for (std::int64_t x = from[0]; x <= to[0]; ++x)
        {
            for (std::int64_t y = from[1]; y <= to[1]; ++y)
            {
                const std::int64_t last = key(x, y, to[2]);
                auto e = std::lower_bound
                (
                    entries_.begin(), entries_.end(), key(x, y, from[2]),
                    [](const Entry& a, std::int64_t k) { return a.key < k; }
                );
                for (; e != entries_.end() && e->key <= last; ++e)
                {
                    if (std::size_t(e->box) >= middles_.size()) continue;  // an image
                    if (boxes_[std::size_t(e->box)].overlaps(image)) found(e->box);
                }
            }
        }
    });
}

}
