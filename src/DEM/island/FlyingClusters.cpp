// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/FlyingClusters.hpp"

#include "neighbourSearch/DisjointSets.hpp"

#include <algorithm>

namespace dem
{

void FlyingClusters::begin(const IslandState& state)
{
    members_.clear();
    flies_.assign(state.particles.size(), 0);
}


void FlyingClusters::find(const IslandState& state)
{
    const std::size_t n = state.particles.size();
    members_.clear();
    flies_.assign(n, 0);
    DisjointSets clusters(n);
    std::vector<char>& loose = flies_;
    const std::vector<RestState>& rest = state.rest;
    for (const ContactStore::Lists& l : state.contacts.lists)
    {
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            const std::size_t i = std::size_t(l.pairs.i[k]), j = std::size_t(l.pairs.j[k]);
            if (!rest[i].resting && !rest[j].resting) clusters.join(i, j);
        }
    }
    std::vector<char> held(n, 0);   // by root
    for (const ContactStore::Lists& l : state.contacts.lists)
    {
        for (std::size_t k = 0; k < l.walls.size(); ++k)
        {
            held[clusters.find(std::size_t(l.walls.i[k]))] = 1;
        }
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            const std::size_t i = std::size_t(l.pairs.i[k]), j = std::size_t(l.pairs.j[k]);
            if (rest[i].resting != rest[j].resting)
            {
                held[clusters.find(rest[i].resting ? j : i)] = 1;
            }
            else loose[i] = loose[j] = 1;
        }
    }
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        loose[k] = loose[k] && !held[clusters.find(k)];
        if (loose[k]) members_.push_back({int(clusters.find(k)), i});
    }
    std::sort(members_.begin(), members_.end());
}

}
