// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points that stay where they are, by the caller's index, in an octree: to put one in, to take one
// out and to find those near a box costs the logarithm of their number.
#pragma once

#include "neighbourSearch/BoxGrid.hpp"
#include "particles/vector.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem
{

class PointTree
{
public:

    //- unit [m]: length below which places are not told apart; taken from the first one put in
    void insert(std::size_t i, const Vec3& x, double unit);

    //- Whatever has become of its place
    void remove(std::size_t i);

    std::size_t size() const { return size_; }

    //- Point i, which is in, is at x, as far as places are told apart
    bool holds(std::size_t i, const Vec3& x) const { return cells_[i] == cell(x); }

    //- Calls f(i) for each point inside the box, and perhaps for some close to it
    template<class F>
    void inside(const Box& box, F&& f) const;

    //- Point i is number now[i] from here on; never larger
    void renumber(const std::vector<std::size_t>& now);


private:

    //- Place in units; what is beyond the range is at its end
    using Cell = std::array<std::uint32_t, 3>;

    //- A cube: eight smaller ones, or a list of points
    struct Node
    {
        int child = -1;     // first of the eight
        int first = -1;     // of the points, then next_
        int count = 0;
    };

    static constexpr int levels = 32;
    static constexpr int most = 8;      // points of a cube that is not divided

    Cell cell(const Vec3& x) const;
    static int octant(const Cell& c, int level)
    {
        const int shift = levels - 1 - level;
        return
            int((c[0] >> shift) & 1) | int((c[1] >> shift) & 1) << 1
          | int((c[2] >> shift) & 1) << 2;
    }
    void put(int i);
    void divide(int node, int level);
    void renew();

    template<class F>
    void inside
    (
        int node, int level, const Cell& corner, const Cell& low, const Cell& high, F&& f
    ) const;

    double unit_ = 0;                   // [m]
    Vec3 origin_ = Vec3::Zero();
    std::vector<Node> nodes_;
    std::vector<Cell> cells_;           // by point
    std::vector<int> next_;             // by point
    std::size_t size_ = 0;
};


template<class F>
void PointTree::inside(const Box& box, F&& f) const
{
    if (!size_) return;
    inside(0, 0, Cell{0, 0, 0}, cell(box.low), cell(box.high), f);
}


template<class F>
void PointTree::inside
(
    int node, int level, const Cell& corner, const Cell& low, const Cell& high, F&& f
) const
{
    const Node& n = nodes_[std::size_t(node)];
    if (n.child < 0)
    {
        for (int i = n.first; i >= 0; i = next_[std::size_t(i)])
        {
            const Cell& c = cells_[std::size_t(i)];
            bool in = true;
            for (std::size_t d = 0; d < 3; ++d) in = in && low[d] <= c[d] && c[d] <= high[d];
            if (in) f(std::size_t(i));
        }
        return;
    }
    const std::uint32_t half = std::uint32_t(1) << (levels - 1 - level);
    for (int o = 0; o < 8; ++o)
    {
        const Node& child = nodes_[std::size_t(n.child + o)];
        if (child.child < 0 && child.first < 0) continue;
        Cell at = corner;
        bool overlaps = true;
        for (std::size_t d = 0; d < 3; ++d)
        {
            if ((o >> d) & 1) at[d] += half;
            overlaps = overlaps && at[d] <= high[d] && low[d] <= at[d] + (half - 1);
        }
        if (overlaps) inside(n.child + o, level + 1, at, low, high, f);
    }
}

}
