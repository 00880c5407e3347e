// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/Rest.hpp"

#include "neighbourSearch/DisjointSets.hpp"

#include <algorithm>
#include <map>

namespace dem
{

namespace
{

constexpr double windowPeriods = 3;

//- Particle k rests from `since` on: addImpulse() adds the whole of the run
void restsFrom(IslandState& state, std::size_t k, double since)
{
    state.impulse[k] -= since*gasForceAtRest(state.gas[k]);
}

}


void Rest::begin(const IslandState& state)
{
    window_ = 0;
    flying_.begin(state);
}


std::vector<int> Rest::disturbed(const IslandState& state) const
{
    std::vector<int> result;
    for (std::size_t i = 0; i < state.particles.size(); ++i)
    {
        if (state.rest[i].resting && wakes(state.rest[i], state.gas[i]))
        {
            result.push_back(int(i));
        }
    }
    return result;
}


std::vector<int> Rest::overloaded
(
    const IslandState& state, const std::vector<int>& boundary
) const
{
    std::vector<int> result;
    for (const int i : boundary)
    {
        const std::size_t k = std::size_t(i);
        const Load& l = state.loads[k];
        if
        (
            overloads
            (
                vec(l.f) + gasForceAtRest(state.gas[k]),
                vec(l.t) + gasTorqueAtRest(state.gas[k]), state.rest[k].pullOff,
                state.bodies[k].r, env_.time.restTolerance
            )
        ) result.push_back(i);
    }
    return result;
}


std::vector<int> Rest::bereft
(
    const IslandState& state, const std::vector<Partners>& ended
) const
{
    std::vector<int> result;
    for (const Partners& partner : ended)
    {
        for (const int p : {partner.i, partner.j})
        {
            if (p >= 0 && state.rest[std::size_t(p)].resting) result.push_back(p);
        }
    }
    return result;
}


void Rest::wake(IslandState& state, std::vector<int>& woken, StepReport& report) const
{
    std::sort(woken.begin(), woken.end());
    woken.erase(std::unique(woken.begin(), woken.end()), woken.end());
    for (const int i : woken)
    {
        RestState& rest = state.rest[std::size_t(i)];
        restsFrom(state, std::size_t(i), -state.phase.elapsed);
        rest.resting = false;
        rest.quietTime = 0;
    }
    report.wakes += std::int64_t(woken.size());
    std::vector<int>& awake = state.awake;
    const std::size_t before = awake.size();
    awake.insert(awake.end(), woken.begin(), woken.end());
    std::inplace_merge(awake.begin(), awake.begin() + std::ptrdiff_t(before), awake.end());
}


//- And the window for which a particle must be quiet
void Rest::findWeakest(const IslandState& state)
{
    weakest_.assign(state.particles.size(), {});
    double longest = 0;
    state.contacts.each([&](std::size_t, const ContactList& list, std::size_t k)
    {
        // a mirror holds nothing
        if (list.isWall() && env_.mirrors(list.j[k])) return;
        const ContactEntry& e = state.contacts.entry(list, k);
        const Partners p = partners(list, k);
        weakest_[std::size_t(p.i)].add(e);
        if (p.j >= 0) weakest_[std::size_t(p.j)].add(e);
        longest = std::max(longest, normalPeriod(e));
    });
    window_ = longest*windowPeriods;
}


void Rest::judge(IslandState& state, std::size_t k, const Unrest& u, double elapsed) const
{
    double& quiet = state.rest[k].quietTime;
    const auto gain = quietGain
    (
        u, weakest_[k], state.bodies[k].r, env_.time.restTolerance, elapsed
    );
    if (gain) quiet += *gain;
    else quiet = 0;
}


void Rest::judgeFlying(IslandState& state, double elapsed) const
{
    flying_.each
    (
        state, env_.periodic,
        [&](const std::vector<int>& members, const RigidAggregate& body)
        {
            for (std::size_t m = 0; m < members.size(); ++m)
            {
                const std::size_t k = std::size_t(members[m]);
                const Load& l = state.loads[k];
                const Unrest u
                {
                    kineticEnergy(state, k, body.velocityBeyond(m), body.spinBeyond(m)),
                    (vec(l.f) - body.contactForce(m)).norm(),
                    (vec(l.t) - body.contactTorque(m)).norm()
                };
                judge(state, k, u, elapsed);
            }
        }
    );
}


//- What would fall asleep, but rolls on at a contact that yields, gathers speed slowly or keeps it:
//  not quiet
void Rest::unsettleRolling(IslandState& state) const
{
    const auto due = [&](int i)
    {
        return i >= 0 && window_ > 0 && state.rest[std::size_t(i)].quietTime >= window_;
    };
    state.contacts.each([&](std::size_t law, const ContactList& list, std::size_t k)
    {
        const Partners p = partners(list, k);
        if (!due(p.i) && !due(p.j)) return;
        const SpringEnergy spring = env_.law(law).energy
        (
            list, k, state.bodies.data(), state.phase.ahead, env_.periodic
        ).springs[1];
        if (!spring.yields || !(spring.input > 0)) return;
        for (const int i : {p.i, p.j})
        {
            if (due(i)) state.rest[std::size_t(i)].quietTime = 0;
        }
    });
}


bool Rest::judge(IslandState& state, double elapsed)
{
    if (env_.time.restTolerance <= 0) return false;
    findWeakest(state);
    flying_.find(state);
    judgeFlying(state, elapsed);
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        if (flying_.flies(k)) continue;
        const Body& b = state.bodies[k];
        const Load& l = state.loads[k];
        const GasLoad& g = state.gas[k];
        const Vec3 v = vec(b.v), w = vec(b.w);
        const Unrest u
        {
            kineticEnergy(state, k, v, w),
            (vec(l.f) + g.Sp*(g.Uc - v) + g.Su).norm(),
            (vec(l.t) + g.SpOmega*(g.omegaC - w)).norm()
        };
        judge(state, k, u, elapsed);
    }
    unsettleRolling(state);
    return
        window_ > 0
     && std::any_of
        (
            state.awake.begin(), state.awake.end(),
            [&](int i) { return isQuiet(state, std::size_t(i)); }
        );
}


bool Rest::isQuiet(const IslandState& state, std::size_t k) const
{
    const RestState& rest = state.rest[k];
    return
        !rest.resting && !flying_.flies(k) && rest.quietTime > 0
     && rest.quietTime >= window_;
}


//- From particle i into its partner in contact k of a list
Vec3 Rest::normalAt(const IslandState& state, const ContactList& list, std::size_t k, int i) const
{
    if (list.isWall()) return Vec3(list.nx[k], list.ny[k], list.nz[k]);
    const Body& partner = state.bodies[std::size_t(list.i[k] == i ? list.j[k] : list.i[k])];
    return env_.periodic.nearest
    (
        vec(partner.x) - vec(state.bodies[std::size_t(i)].x)
    ).normalized();
}


//- Whether the gas load of a cluster makes it roll off what holds it
bool Rest::rollsOff(const IslandState& state, const QuietCluster& cluster) const
{
    if (cluster.holdings.size() > mostHolds) return false;
    const Vec3 origin = vec(state.bodies[std::size_t(cluster.members[0])].x);
    const auto place = [&](int i)
    {
        return env_.periodic.nearest(vec(state.bodies[std::size_t(i)].x) - origin);
    };
    std::vector<Hold> holds;
    for (const Holding& h : cluster.holdings)
    {
        const ContactEntry& e = state.contacts.entry(*h.list, h.k);
        const double r = state.bodies[std::size_t(h.particle)].r;
        const Vec3 n = normalAt(state, *h.list, h.k, h.particle);
        holds.push_back
        (
            {place(h.particle) + r*n, n, rollingStrength(e.yield.moment, e.pullOff, r)}
        );
    }
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (const int i : cluster.members)
    {
        const Vec3 f = gasForceAtRest(state.gas[std::size_t(i)]);
        force += f;
        moment += gasTorqueAtRest(state.gas[std::size_t(i)]) + place(i).cross(f);
    }
    return dem::rollsOff(holds, force, moment);
}


//- By particle: it is quiet and holds on to a wall or to one at rest, by quiet ones if need be
std::vector<char> Rest::heldAndQuiet(IslandState& state) const
{
    const std::size_t n = state.particles.size();
    const auto quiet = [&](int i) { return isQuiet(state, std::size_t(i)); };
    const auto resting = [&](int i) { return state.rest[std::size_t(i)].resting; };
    DisjointSets sets(n);
    for (const ContactStore::Lists& l : state.contacts.lists)
    {
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            const int i = l.pairs.i[k], j = l.pairs.j[k];
            if (quiet(i) && quiet(j)) sets.join(std::size_t(i), std::size_t(j));
        }
    }
    std::map<std::size_t, QuietCluster> clusters;   // by root
    for (const int i : state.awake)
    {
        if (quiet(i)) clusters[sets.find(std::size_t(i))].members.push_back(i);
    }
    const auto hold = [&](int i, const ContactList& list, std::size_t k)
    {
        if (quiet(i)) clusters[sets.find(std::size_t(i))].holdings.push_back({i, &list, k});
    };
    for (const ContactStore::Lists& l : state.contacts.lists)
    {
        for (std::size_t k = 0; k < l.walls.size(); ++k)
        {
            if (!env_.mirrors(l.walls.j[k])) hold(l.walls.i[k], l.walls, k);
        }
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            const int i = l.pairs.i[k], j = l.pairs.j[k];
            if (resting(i)) hold(j, l.pairs, k);
            if (resting(j)) hold(i, l.pairs, k);
        }
    }
    std::vector<char> result(n, 0);
    for (const auto& [root, cluster] : clusters)
    {
        if (cluster.holdings.empty()) continue;
        const bool rolls = rollsOff(state, cluster);
        for (const int i : cluster.members)
        {
            result[std::size_t(i)] = !rolls;
            if (rolls) state.rest[std::size_t(i)].quietTime = 0;
        }
    }
    return result;
}


void Rest::rested(double energy, const EnergyAccount& account, StepReport& report) const
{
    report.energyRemovedByRest += energy;
    account.rested(energy, report.energy);
}


bool Rest::fallAsleep
(
    IslandState& state, const EnergyAccount& account, StepReport& report
) const
{
    const std::vector<char> sleeps = heldAndQuiet(state);
    std::size_t kept = 0;
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        if (!sleeps[k])
        {
            state.awake[kept++] = i;
            continue;
        }
        Body& b = state.bodies[k];
        rested(kineticEnergy(state, k, vec(b.v), vec(b.w)), account, report);
        for (int d = 0; d < 3; ++d) b.v[d] = b.w[d] = 0;
        for (double& v : state.motion[k].v) v = 0;
        for (double& w : state.motion[k].w) w = 0;
        RestState& rest = state.rest[k];
        restsFrom(state, k, state.phase.elapsed);
        rest.resting = true;
        const Vec3 gasForce = gasForceAtRest(state.gas[k]);
        for (int d = 0; d < 3; ++d) rest.force[d] = gasForce[d];
        rest.pullOff = weakest_[k].pullOff;
        rest.wakeForce = weakest_[k].wakeForce(env_.time.restTolerance, b.r);
        ++report.sleeps;
    }
    const bool any = kept < state.awake.size();
    state.awake.resize(kept);
    return any;
}


void Rest::freeze
(
    IslandState& state, const std::vector<int>& members, const RigidAggregate& body
) const
{
    std::int64_t lowest = state.particles[std::size_t(members[0])].id;
    for (const int i : members)
    {
        lowest = std::min(lowest, state.particles[std::size_t(i)].id);
    }
    for (std::size_t m = 0; m < members.size(); ++m)
    {
        const std::size_t k = std::size_t(members[m]);
        const Vec3 v = body.velocity(m), omega = body.spin();
        const Vec3 force = body.contactForce(m), arm = body.arm(m);
        RestState& rest = state.rest[k];
        Body& b = state.bodies[k];
        for (int d = 0; d < 3; ++d)
        {
            b.v[d] = v[d];
            b.w[d] = omega[d];
            rest.force[d] = force[d];
            rest.arm[d] = arm[d];
        }
        rest.resting = true;
        rest.aggregate = lowest;
        rest.members = int(members.size());
        rest.pullOff = weakest_[k].pullOff;
        rest.wakeForce = weakest_[k].wakeForce(env_.time.restTolerance, b.r);
    }
}


void Rest::freezeFlying(IslandState& state, const EnergyAccount& account, StepReport& report)
{
    if (!env_.time.islands || env_.time.restTolerance <= 0 || window_ <= 0) return;
    const auto quiet = [&](int i)
    {
        return state.rest[std::size_t(i)].quietTime >= window_;
    };
    if (!std::any_of(state.awake.begin(), state.awake.end(), quiet)) return;

    flying_.find(state);
    flying_.each
    (
        state, env_.periodic, [&](const std::vector<int>& members, RigidAggregate& body)
        {
            if (!std::all_of(members.begin(), members.end(), quiet)) return;
            rested(body.stiffen(), account, report);
            freeze(state, members, body);
            report.sleeps += std::int64_t(members.size());
        }
    );
}


void Rest::addImpulse(IslandState& state, double dt) const
{
    for (std::size_t i = 0; i < state.particles.size(); ++i)
    {
        if (state.rest[i].resting) restsFrom(state, i, -dt);
    }
}

}
