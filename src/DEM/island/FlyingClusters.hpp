// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "island/IslandState.hpp"
#include "neighbourSearch/Periodic.hpp"
#include "timeIntegration/RigidAggregate.hpp"

#include <utility>
#include <vector>

namespace dem
{

//- Clusters of awake particles that hold on to nothing
class FlyingClusters
{
public:

    //- At the start of a run: none
    void begin(const IslandState& state);

    //- Find them, by the contacts in lists
    void find(const IslandState& state);

    //- Whether particle k is in one
    bool flies(std::size_t k) const { return flies_[k]; }

    //- f(members, body) for each of them, body of a copy of the members as they move now
    template<class F>
    void each(const IslandState& state, const Periodic& periodic, F&& f) const
    {
        std::vector<int> members;
        std::vector<Particle> particles;
        std::vector<GasLoad> gas;
        for (std::size_t first = 0, last; first < members_.size(); first = last)
        {
            members.clear();
            particles.clear();
            gas.clear();
            last = first;
            for (; last < members_.size() && members_[last].first == members_[first].first; ++last)
            {
                const int i = members_[last].second;
                const std::size_t k = std::size_t(i);
                Particle p = state.particles[k];
                p.x = vec(state.bodies[k].x);
                p.v = vec(state.bodies[k].v);
                p.omega = vec(state.bodies[k].w);
                members.push_back(i);
                particles.push_back(p);
                gas.push_back(state.gas[k]);
            }
            RigidAggregate body(particles, gas, periodic);
            f(members, body);
        }
    }


private:

    std::vector<std::pair<int, int>> members_;  // cluster, particle
    std::vector<char> flies_;                   // by particle
};

}
