// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who falls asleep and who wakes in an island, by the criteria of restCriteria.hpp. All functions
// want the velocities of a step's end.
#pragma once

#include "island/EnergyAccount.hpp"
#include "island/Environment.hpp"
#include "island/FlyingClusters.hpp"
#include "island/IslandState.hpp"
#include "contacts/restCriteria.hpp"
#include "system/StepReport.hpp"

#include <vector>

namespace dem
{

class Rest
{
public:

    explicit Rest(const Environment& environment) : env_(environment) {}

    //- At the start of a run
    void begin(const IslandState& state);

    //- Those at rest whose load from outside has changed
    std::vector<int> disturbed(const IslandState& state) const;

    //- Of these, at rest in contact with one awake, those that it loads too much
    std::vector<int> overloaded(const IslandState& state, const std::vector<int>& boundary) const;

    //- Of the partners of contacts that have ended, those at rest
    std::vector<int> bereft(const IslandState& state, const std::vector<Partners>& ended) const;

    //- Wake these; they become ascending and unique
    void wake(IslandState& state, std::vector<int>& woken, StepReport& report) const;

    //- Judge the awake: they have moved for `elapsed` [s]. Returns whether some may fall asleep.
    bool judge(IslandState& state, double elapsed);

    //- Put those to sleep that are quiet and hold on to a wall or to what rests. Returns whether
    //  there are any.
    bool fallAsleep(IslandState& state, const EnergyAccount& account, StepReport& report) const;

    //- At the end of a run: flying clusters that have been quiet go on as rigid aggregates
    void freezeFlying(IslandState& state, const EnergyAccount& account, StepReport& report);

    //- At the end of a run of dt: what the gas gave to those at rest
    void addImpulse(IslandState& state, double dt) const;


private:

    void findWeakest(const IslandState& state);
    void judge(IslandState& state, std::size_t k, const Unrest& u, double elapsed) const;
    void judgeFlying(IslandState& state, double elapsed) const;
    void unsettleRolling(IslandState& state) const;
    bool isQuiet(const IslandState& state, std::size_t k) const;
    //- A contact of a particle with a wall or with one at rest
    struct Holding
    {
        int particle;
        const ContactList* list;
        std::size_t k;
    };
    struct QuietCluster
    {
        std::vector<int> members;
        std::vector<Holding> holdings;
    };

    Vec3 normalAt(const IslandState& state, const ContactList& list, std::size_t k, int i) const;
    bool rollsOff(const IslandState& state, const QuietCluster& cluster) const;
    std::vector<char> heldAndQuiet(IslandState& state) const;
    void rested
    (
        double energy, const EnergyAccount& account, StepReport& report
    ) const;
    void freeze(IslandState& state, const std::vector<int>& members, const RigidAggregate& body)
        const;
    double kineticEnergy(const IslandState& state, std::size_t k, const Vec3& v, const Vec3& w)
        const
    {
        const Particle& p = state.particles[k];
        return 0.5*(p.mass*v.squaredNorm() + inertia(p)*w.squaredNorm());
    }

    const Environment& env_;
    std::vector<WeakestContact> weakest_;   // by particle
    double window_ = 0;                     // [s]
    FlyingClusters flying_;
};

}
