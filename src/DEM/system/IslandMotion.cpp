// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/IslandMotion.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"
#include "particles/ClusterDrag.hpp"
#include "particles/errors.hpp"
#include "timeIntegration/RigidAggregate.hpp"

#include <algorithm>
#include <unordered_map>

namespace dem
{

bool IslandMembers::holdsFor(const std::vector<Member>& other) const
{
    return !outran && std::equal
    (
        members.begin(), members.end(), other.begin(), other.end(),
        [](const Member& a, const Member& b) { return a.p.id == b.p.id; }
    );
}


IslandMotion::IslandMotion
(
    const MaterialTable& materials, const TimeSettings& time, const WallSearch& walls,
    const Periodic& periodic
)
:
    materials_(materials),
    time_(time),
    walls_(walls),
    periodic_(periodic),
    integrator_(materials, time, walls, periodic)
{}


void IslandMotion::move(IslandMembers& island, const Span& span, bool keepExchange)
{
    const auto delayed = [](const Member& m) { return m.delay != 0; };
    if (std::any_of(island.members.begin(), island.members.end(), delayed))
    {
        integrateInParts(island, span, keepExchange);
        ++island.report.islands;
    }
    else if (!flyTogether(island, span.dt))
    {
        integrate(island, span, keepExchange);
        ++island.report.islands;
    }
    for (const Member& m : island.members)
    {
        island.outran = island.outran || m.outran > 0 || m.woke;
    }
    shareImpacts(island);
}


//- Each goes back with its particle
void IslandMotion::shareImpacts(IslandMembers& island)
{
    std::vector<WallImpact> impacts;
    impacts.swap(island.report.wallImpacts);
    for (const WallImpact& h : impacts)
    {
        const auto before = [](const Member& m, std::int64_t id) { return m.p.id < id; };
        std::lower_bound(island.members.begin(), island.members.end(), h.id, before)
            ->impacts.push_back(h);
    }
}


//- Whether contacts can hold the members in the body as they did when it came to rest inside
bool IslandMotion::undisturbed
(
    const std::vector<Member>& members, const std::vector<Particle>& flyers,
    const RigidAggregate& body
) const
{
    for (std::size_t k = 0; k < members.size(); ++k)
    {
        const RestState& r = members[k].rest;
        const Vec3 force = body.contactForce(k);
        const double change = (force - Vec3(r.force[0], r.force[1], r.force[2])).norm();
        if (r.wakeForce < 0) return false;
        if (change <= r.wakeForce) continue;
        // Of many contacts a force may be the moment of one. A pair has one, whose force and
        // moment are known.
        if (members.size() > 2) return false;
        const double radius = flyers[k].radius;
        const Vec3 n = periodic_.nearest(flyers[1 - k].x - flyers[k].x).normalized();
        const Vec3 moment = body.contactTorque(k) - radius*n.cross(force);
        if
        (
            change > time_.restTolerance*wakeForceChange*r.pullOff
         || moment.norm() > r.wakeForce*radius
        ) return false;
    }
    return true;
}


//- What contacts remember in space turns with the body
void IslandMotion::turnHistory
(
    std::vector<Member>& members, const Eigen::Matrix3d& turn
) const
{
    for (Member& m : members)
    {
        for (ContactRecord& c : m.contacts)
        {
            const auto partner = std::find_if
            (
                members.begin(), members.end(),
                [&](const Member& o) { return o.p.id == c.idJ; }
            );
            if (partner == members.end()) continue;
            const int law = materials_.lawIndex(m.p.material, partner->p.material);
            materials_.laws()[std::size_t(law)]->turnHistory(turn, c.history);
        }
    }
}


//- Move the members as one body, if that is what they are; impulses from the gas included
bool IslandMotion::flyTogether(IslandMembers& island, double dt)
{
    std::vector<Member>& members = island.members;
    const RestState& first = members[0].rest;
    if (first.aggregate < 0 || first.members != int(members.size())) return false;
    std::vector<Particle> flyers;
    std::vector<GasLoad> loads;
    for (const Member& m : members)
    {
        if (m.rest.aggregate != first.aggregate || m.pushed || m.rim) return false;
        flyers.push_back(m.p);
        loads.push_back(m.gas);
    }
    RigidAggregate body(flyers, loads, periodic_);
    if (!undisturbed(members, flyers, body)) return false;

    std::vector<Vec3> impulses;
    const Eigen::Matrix3d turn = body.fly(dt, impulses);
    const FlightFactors flight = body.flight(dt);
    ClusterDrag drag;
    for (std::size_t k = 0; k < members.size(); ++k) drag.add(loads[k], impulses[k], dt);
    for (std::size_t k = 0; k < members.size(); ++k)
    {
        Member& m = members[k];
        m.p = flyers[k];
        m.exchange =
            {drag.given(m.gas, impulses[k], dt), m.gas.Sp*flight.p1, flight.e, false};
        Eigen::Map<Vec3> force(m.rest.force);
        force = turn*Vec3(force);
        Eigen::Map<Vec3> arm(m.rest.arm);
        arm = turn*Vec3(arm);
    }
    turnHistory(members, turn);
    ++island.report.aggregateFlights;
    return true;
}


//- Hand the members, the walls about them and their contacts to the integrator
void IslandMotion::load(IslandMembers& island, double dt)
{
    integrator_.clear();
    const std::vector<Member>& members = island.members;
    std::vector<int> surfaces;
    std::unordered_map<std::int64_t, int> local;
    for (const Member& m : members)
    {
        const double half =
            m.p.radius + materials_.reach(m.p.material, m.p.radius, walls_.walls())
          + m.corridor.width(dt);
        const Vec3 end = m.p.x + dt*m.corridor.v;
        surfaces.clear();
        if (!m.seen)
        {
            walls_.query
            (
                m.p.x.cwiseMin(end).array() - half, m.p.x.cwiseMax(end).array() + half, surfaces
            );
        }
        local.emplace(m.p.id, int(local.size()));
        RestState state = m.rest;
        if (state.aggregate >= 0)
        {
            // others may meet it, or its load has changed: no body of its own any more
            state.resting = false;
            state.aggregate = -1;
            ++island.report.wakes;
        }
        integrator_.addParticle(m.p, m.gas, state, m.corridor, m.rim);
        integrator_.addSurfaces(surfaces);
    }

    for (std::size_t i = 0; i < members.size(); ++i)
    {
        for (const ContactRecord& c : members[i].contacts)
        {
            int j = -1;
            if (c.wall < 0)
            {
                // the partner has left the system: the contact has gone with it
                const auto found = local.find(c.idJ);
                if (found == local.end()) continue;
                j = found->second;
            }
            integrator_.addContact(int(i), j, c);
        }
    }
}


void IslandMotion::integrate(IslandMembers& island, const Span& span, bool keepExchange)
{
    load(island, span.dt);
    integrator_.run(span, island.report);

    if (wokeAtRim(island.members)) return;
    std::vector<GasExchange> exchanges;
    if (keepExchange) exchanges = integrator_.gasExchange(span.dt);
    for (std::size_t i = 0; i < island.members.size(); ++i)
    {
        Member& m = island.members[i];
        if (m.seen) continue;
        m.outran = integrator_.outran(int(i));
        if (integrator_.atStart())
        {
            m.delay = m.rest.resting ? 0 : -integrator_.behind();
            continue;
        }
        if (keepExchange) m.exchange = exchanges[i];
        m.contacts = integrator_.contacts(int(i));
        m.p = integrator_.particle(int(i));
        m.rest = integrator_.rest(int(i));
        m.delay = m.rest.resting ? 0 : -integrator_.behind();
    }
}


//- Whether the run has ended because the rim would have woken; that is taken down
bool IslandMotion::wokeAtRim(std::vector<Member>& members) const
{
    bool any = false, known = false;
    for (std::size_t i = 0; i < members.size(); ++i)
    {
        Member& m = members[i];
        m.outran = integrator_.outran(int(i));
        m.woke = integrator_.wokeAtRim(int(i));
        any = any || m.woke;
        known = known || m.outran > 0 || (m.woke && !m.seen);
    }
    if (any && !known)
    {
        throw numericalError("Particles have touched that were not found to be able to");
    }
    return any;
}


//- From each moment on at which somebody enters or stood, with those who are there by then
void IslandMotion::integrateInParts
(
    IslandMembers& island, const Span& span, bool keepExchange
)
{
    double first = 0;
    for (const Member& m : island.members) first = std::min(first, m.delay);
    for (Member& m : island.members)
    {
        if (m.rest.resting && m.rest.aggregate < 0) m.delay = first;
    }
    const std::vector<Member> before = island.members;
    std::vector<double> moments{span.dt};
    for (const Member& m : before) moments.push_back(m.delay);
    std::sort(moments.begin(), moments.end());

    for (std::size_t part = 0; part + 1 < moments.size(); ++part)
    {
        const double start = moments[part], length = moments[part + 1] - start;
        if (!(length > 0)) continue;
        const double ahead = part + 2 < moments.size() ? 0 : span.ahead;
        IslandMembers there;
        for (std::size_t k = 0; k < before.size(); ++k)
        {
            // `delay` of what has been moved says where that ended
            if (before[k].delay > start) continue;
            const Member& m = island.members[k];
            there.members.push_back(m);
            there.members.back().exchange = {};
            // of its width, what the parts before have left
            Corridor& c = there.members.back().corridor;
            const Vec3 begun = before[k].p.x - before[k].delay*before[k].p.v;
            const double off = periodic_.nearest(m.p.x - begun - start*c.v).norm();
            c.near = std::max(c.width(start) - off, 0.0);
            c.from = std::max(c.from - start, 0.0);
        }
        if (there.members.empty()) continue;
        const bool uncut = start == first && (start < 0 || span.uncut);
        integrate(there, {length, span.now + start, ahead, uncut}, keepExchange);
        island.report.add(there.report);
        bool woke = false;

        auto m = island.members.begin();
        auto was = before.begin();
        for (Member& moved : there.members)
        {
            while (m->p.id != moved.p.id) ++m, ++was;
            moved.corridor = m->corridor;
            moved.outran = std::max(moved.outran, m->outran);
            const GasExchange &first = m->exchange, &last = moved.exchange;
            if (was->delay < start)
            {
                moved.exchange =
                {
                    first.impulse + last.impulse, first.response*last.memory + last.response,
                    first.memory*last.memory, last.held
                };
            }
            woke = woke || moved.woke;
            *m = std::move(moved);
        }
        if (woke) return;
    }
}

}
