// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbourSearch/PointTree.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

PointTree::Cell PointTree::cell(const Vec3& x) const
{
    Cell c;
    for (int d = 0; d < 3; ++d)
    {
        const double k = std::floor((x[d] - origin_[d])/unit_) + 2147483648.0;
        c[std::size_t(d)] = std::uint32_t(std::min(std::max(k, 0.0), 4294967295.0));
    }
    return c;
}


void PointTree::insert(std::size_t i, const Vec3& x, double unit)
{
    if (!size_)
    {
        unit_ = unit;
        origin_ = x;
        nodes_.assign(1, Node{});
    }
    if (cells_.size() <= i)
    {
        cells_.resize(i + 1);
        next_.resize(i + 1, -1);
    }
    cells_[i] = cell(x);
    ++size_;
    put(int(i));
    // cubes that all have left
    if (nodes_.size() > 4096 && nodes_.size() > 16*size_) renew();
}


void PointTree::put(int i)
{
    const Cell& c = cells_[std::size_t(i)];
    int node = 0, level = 0;
    while (nodes_[std::size_t(node)].child >= 0)
    {
        node = nodes_[std::size_t(node)].child + octant(c, level++);
    }
    Node& leaf = nodes_[std::size_t(node)];
    next_[std::size_t(i)] = leaf.first;
    leaf.first = i;
    if (++leaf.count > most && level < levels) divide(node, level);
}


//- Until no part has too many
void PointTree::divide(int node, int level)
{
    while (level < levels)
    {
        const int child = int(nodes_.size());
        nodes_.resize(nodes_.size() + 8);
        Node& n = nodes_[std::size_t(node)];
        int i = n.first;
        n = {child, -1, 0};
        int fullest = child;
        while (i >= 0)
        {
            const int after = next_[std::size_t(i)];
            const int to = child + octant(cells_[std::size_t(i)], level);
            Node& part = nodes_[std::size_t(to)];
            next_[std::size_t(i)] = part.first;
            part.first = i;
            if (++part.count > most) fullest = to;
            i = after;
        }
        // one more than fits has come: if a part has too many, it has all
        if (nodes_[std::size_t(fullest)].count <= most) return;
        node = fullest;
        ++level;
    }
}


void PointTree::remove(std::size_t i)
{
    const Cell& c = cells_[i];
    int node = 0;
    for (int level = 0; nodes_[std::size_t(node)].child >= 0; ++level)
    {
        node = nodes_[std::size_t(node)].child + octant(c, level);
    }
    Node& leaf = nodes_[std::size_t(node)];
    int* at = &leaf.first;
    while (*at != int(i)) at = &next_[std::size_t(*at)];
    *at = next_[i];
    next_[i] = -1;
    --leaf.count;
    --size_;
}


//- The same points in new cubes
void PointTree::renew()
{
    std::vector<int> points;
    for (const Node& n : nodes_)
    {
        if (n.child >= 0) continue;
        for (int i = n.first; i >= 0; i = next_[std::size_t(i)]) points.push_back(i);
    }
    nodes_.assign(1, Node{});
    for (const int i : points) put(i);
}


void PointTree::renumber(const std::vector<std::size_t>& now)
{
    const auto renamed = [&](int i) { return i < 0 ? i : int(now[std::size_t(i)]); };
    for (Node& n : nodes_) n.first = renamed(n.first);
    std::size_t last = 0;
    for (std::size_t i = 0; i < cells_.size() && i < now.size(); ++i)
    {
        if (now[i] > i) continue;       // it is no more
        cells_[now[i]] = cells_[i];
        next_[now[i]] = renamed(next_[i]);
        last = now[i] + 1;
    }
    cells_.resize(last);
    next_.resize(last);
}

}
