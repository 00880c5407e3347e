// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/shareOfGas.hpp"

#include "neighbourSearch/DisjointSets.hpp"
#include "particles/ClusterDrag.hpp"
#include "timeIntegration/freeFlight.hpp"

namespace dem
{

std::vector<GasExchange> shareOfGas(const IslandState& state, double dt)
{
    const std::size_t n = state.particles.size();
    const auto& stored = state.contacts.stored;
    DisjointSets clusters(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        for (const StoredContact& s : stored[i])
        {
            if (s.j >= 0) clusters.join(i, std::size_t(s.j));
        }
    }
    std::vector<ClusterDrag> drag(n);               // by root
    std::vector<double> mass(n, 0);
    std::vector<char> held(n, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t root = clusters.find(i);
        drag[root].add(state.gas[i], state.impulse[i], dt);
        mass[root] += state.particles[i].mass;
        if (state.rest[i].resting && state.rest[i].aggregate < 0) held[root] = 1;
        for (const StoredContact& s : stored[i]) if (s.j < 0) held[root] = 1;
    }

    std::vector<GasExchange> result(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t root = clusters.find(i);
        GasExchange& e = result[i];
        e.held = held[root];
        e.impulse =
            e.held ? state.impulse[i] : drag[root].given(state.gas[i], state.impulse[i], dt);
        const FlightFactors f(e.held ? 0 : drag[root].Sp/mass[root], dt);
        e.response = state.gas[i].Sp*f.p1;
        e.memory = f.e;
    }
    return result;
}


bool follows(const IslandState& state, int i, const Vec3& n)
{
    const Body& b = state.bodies[std::size_t(i)];
    const GasLoad& g = state.gas[std::size_t(i)];
    const double speed = vec(b.v).dot(n);
    return
        speed < state.particles[std::size_t(i)].radius*g.Sp*b.invM
     && g.Su.dot(n) <= 0.5*g.Sp*speed;
}

}
