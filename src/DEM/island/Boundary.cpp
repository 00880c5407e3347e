// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/Boundary.hpp"

namespace dem
{

void Boundary::begin(const IslandState& state)
{
    const std::size_t n = state.particles.size();
    list_.clear();
    frozen_.resize(n);
    version_.assign(n, -1);
    marked_.assign(n, 0);
}


void Boundary::find(const IslandState& state, const WallCandidates& walls)
{
    list_.clear();
    if (state.awake.size() == state.particles.size()) return;
    const auto look = [&](int i)
    {
        const std::size_t k = std::size_t(i);
        if (!state.rest[k].resting || marked_[k]) return;
        marked_[k] = 1;
        list_.push_back(i);
        if (version_[k] == state.contacts.version[k]) return;
        frozen_[k] = storedLoad(state, i, walls);
        version_[k] = state.contacts.version[k];
    };
    for (const ContactStore::Lists& l : state.contacts.lists)
    {
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            look(l.pairs.i[k]);
            look(l.pairs.j[k]);
        }
    }
    for (const int i : list_) marked_[std::size_t(i)] = 0;
}


Load Boundary::storedLoad(const IslandState& state, int i, const WallCandidates& walls)
{
    Load sum{};
    const auto add = [&](int lower, const StoredContact& s)
    {
        const Load load = storedLoad(state, lower, s, lower == i, walls);
        for (int d = 0; d < 3; ++d)
        {
            sum.f[d] += load.f[d];
            sum.t[d] += load.t[d];
        }
    };
    const ContactStore& store = state.contacts;
    for (const StoredContact& s : store.stored[std::size_t(i)]) add(i, s);
    for (const int h : store.holders[std::size_t(i)])
    {
        for (const StoredContact& s : store.stored[std::size_t(h)])
        {
            if (s.j == i) add(h, s);
        }
    }
    return sum;
}


//- What one stored contact gives to its lower or its higher partner
Load Boundary::storedLoad
(
    const IslandState& state, int lower, const StoredContact& s, bool ofLower,
    const WallCandidates& walls
)
{
    const bool wall = s.j < 0;
    const int mi = state.particles[std::size_t(lower)].material;
    const int mj =
        wall ? env_.wallMaterial(s.record.wall) : state.particles[std::size_t(s.j)].material;
    const ContactLaw& law = env_.law(std::size_t(env_.materials.lawIndex(mi, mj)));
    double c[maxConstants];
    contacts_.constants(state, lower, s.j, s.record.wall, mj, c);

    // the kernels work on a copy of the history
    scratch_.setUp(law.nConstants(), law.nHistory(), wall);
    scratch_.append(0, wall ? s.record.wall : 1, 0, c, s.record.history);
    const Body bodies[2] =
    {
        state.bodies[std::size_t(lower)], state.bodies[std::size_t(wall ? lower : s.j)]
    };
    Load loads[2] = {};
    if (wall)
    {
        std::vector<WallHit> hits;
        const WallHit* hit =
            walls.continues(state, lower, s.record.wall, vec(s.record.n), hits);
        if (hit)
        {
            scratch_.nx[0] = hit->n[0];
            scratch_.ny[0] = hit->n[1];
            scratch_.nz[0] = hit->n[2];
            scratch_.overlap[0] = bodies[0].r - hit->distance;
        }
        law.evaluateWalls(scratch_, 0, 1, bodies, loads, {}, 1);
    }
    else law.evaluatePairs(scratch_, 0, 1, bodies, loads, {}, 1, env_.periodic);
    return loads[ofLower ? 0 : 1];
}

}
