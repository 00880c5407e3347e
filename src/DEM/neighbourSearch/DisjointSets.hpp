// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace dem
{

//- Union-find; the root of a set is its lowest index
class DisjointSets
{
public:

    explicit DisjointSets(std::size_t n)
    :
        parent_(n)
    {
        std::iota(parent_.begin(), parent_.end(), std::size_t(0));
    }

    //- One more, alone
    void add() { parent_.push_back(parent_.size()); }

    std::size_t find(std::size_t i)
    {
        while (parent_[i] != i)
        {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    bool together(std::size_t a, std::size_t b) { return find(a) == find(b); }

    void join(std::size_t a, std::size_t b)
    {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:

    std::vector<std::size_t> parent_;
};

}
