// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/ParticleStep.hpp"

#include "timeIntegration/freeFlight.hpp"

#include <algorithm>

namespace dem
{

ParticleStep::ParticleStep
(
    ParticleStore& store, const MaterialTable& materials, const TimeSettings& time,
    const WallSearch& walls, const Periodic& periodic, const Communicator& communicator
)
:
    store_(store),
    time_(time),
    periodic_(periodic),
    communicator_(communicator),
    finder_(store, walls, periodic, communicator, time.islands),
    motion_(materials, time, walls, periodic),
    exchange_(communicator)
{}


//- Seconds since the last call
double ParticleStep::lap()
{
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - clock_).count();
    clock_ = now;
    return seconds;
}


void ParticleStep::advance(const Span& span, bool keepExchange, StepReport& report)
{
    const double dt = span.dt;
    lap();
    tried_.clear();     // an earlier step may have ended in an error
    behind_.clear();
    store_.began(dt);
    store_.behind = 0;
    for (const auto& entry : store_.delays) store_.behind = std::max(store_.behind, -entry.second);
    if (!span.uncut || span.ahead > 0) store_.behind = communicator_.max(store_.behind);
    if (communicator_.any(store_.index.anyAwake()))
    {
        Work work;
        finder_.begin(dt);
        do
        {
            while (!finder_.settled(dt)) {}
            work = sortOut();
            report.secondsSearch += lap();
        }
        while (!tryToMove(work, span, keepExchange, report));
        flyFreely(work.flights, dt, keepExchange, report);
        report.secondsFlight += lap();
    }
    finish(report);
    store_.delays.swap(behind_);
    behind_.clear();
    report.secondsSearch += lap();
}


Member ParticleStep::member(std::size_t i, std::int64_t component) const
{
    Member m;
    m.p = store_.particles[i];
    m.gas = store_.gas[i];
    m.rest = store_.rest[i];
    m.contacts = store_.contacts[i];
    m.component = component;
    m.owner = communicator_.rank();
    m.index = i;
    m.delay = store_.delay(i);
    return m;
}


//- Closed-form flight, islands of this rank, islands moved elsewhere, which are sent there
ParticleStep::Work ParticleStep::sortOut() const
{
    const int rank = communicator_.rank();
    Work work;
    std::vector<std::vector<Member>> away(std::size_t(communicator_.size()));
    const auto send = [&](Member&& m, int home)
    {
        if (home != rank) away[std::size_t(home)].push_back(std::move(m));
        else work.islands[m.component].members.push_back(std::move(m));
    };
    work.flights = finder_.alone();
    for (std::size_t k = 0; k < finder_.crowd().size(); ++k)
    {
        const std::size_t i = finder_.crowd()[k];
        const Label& of = finder_.labels()[k];
        if (!of.active) continue;
        if (of.alone && !store_.flies(i))
        {
            work.flights.push_back(i);
            continue;
        }
        const Path& path = finder_.path(i);
        Member m = member(i, of.component);
        m.pushed = path.joint;
        m.corridor = path.corridor;
        m.rim = !path.open;
        send(std::move(m), of.shared ? of.home : rank);
    }
    for (const Seen& s : finder_.seen())
    {
        Member m = member(s.particle, s.component);
        m.seen = m.rim = true;
        m.corridor = {Vec3::Zero(), 0, 0, 0};
        send(std::move(m), s.home);
    }
    for (Member& m : exchange_.exchange(away))
    {
        work.islands[m.component].members.push_back(std::move(m));
    }
    for (auto& entry : work.islands)
    {
        std::vector<Member>& members = entry.second.members;
        std::sort
        (
            members.begin(), members.end(),
            [](const Member& a, const Member& b) { return a.p.id < b.p.id; }
        );
    }
    return work;
}


StepReport ParticleStep::moveIslands(Work& work, const Span& span, bool keepExchange)
{
    StepReport report;
    for (auto& entry : work.islands)
    {
        IslandMembers& island = entry.second;
        const auto before = tried_.find(entry.first);
        if (before != tried_.end() && before->second.holdsFor(island.members))
        {
            std::swap(island, before->second);
        }
        else motion_.move(island, span, keepExchange);
        report.add(island.report);
    }
    return report;
}


//- Move the islands; false, with nothing moved, if somebody may have missed others
bool ParticleStep::tryToMove
(
    Work& work, const Span& span, bool keepExchange, StepReport& report
)
{
    const int rank = communicator_.rank();
    const StepReport moved = moveIslands(work, span, keepExchange);
    report.secondsContact += lap();

    std::vector<std::vector<Member>> back(std::size_t(communicator_.size()));
    std::vector<const Member*> own;
    for (const auto& entry : work.islands)
    {
        for (const Member& m : entry.second.members)
        {
            if (m.seen) continue;
            if (m.owner == rank) own.push_back(&m);
            else back[std::size_t(m.owner)].push_back(m);
        }
    }
    const std::vector<Member> elsewhere = exchange_.exchange(back);
    for (const Member& m : elsewhere) own.push_back(&m);

    if (communicator_.any(widenThoseWhoOutran(own)))
    {
        tried_.swap(work.islands);
        report.repeats += rank == 0;
        report.secondsSearch += lap();
        return false;
    }
    tried_.clear();
    report.add(moved);
    for (const Member* m : own)
    {
        takeBack(*m);
        for (WallImpact h : m->impacts)
        {
            h.index = m->index;
            report.wallImpacts.push_back(h);
        }
    }
    report.secondsSearch += lap();
    return true;
}


bool ParticleStep::widenThoseWhoOutran(const std::vector<const Member*>& moved)
{
    bool any = false;
    for (const Member* m : moved)
    {
        if (m->outran > 0) finder_.widen(m->index, m->outran);
        if (m->woke) finder_.open(m->index);
        any = any || m->outran > 0 || m->woke;
    }
    return any;
}


void ParticleStep::takeBack(const Member& m)
{
    const std::size_t i = m.index;
    store_.moved.push_back(i);
    store_.contacts[i] = m.contacts;
    store_.give(i, m.exchange);
    store_.particles[i] = m.p;
    store_.rest[i] = m.rest;
    if (m.delay < 0) behind_.emplace(m.p.id, m.delay);
    if (periodic_.on()) store_.particles[i].x = periodic_.wrapped(m.p.x);
    store_.changed(i);
}


void ParticleStep::flyFreely
(
    const std::vector<std::size_t>& flights, double dt, bool keepExchange, StepReport& report
)
{
    store_.moved.insert(store_.moved.end(), flights.begin(), flights.end());
    for (const std::size_t i : flights)
    {
        Particle& p = store_.particles[i];
        const GasLoad& g = store_.gas[i];
        const double before = time_.energyLedger ? p.kineticEnergy() : 0;
        const double flown = dt - store_.delay(i);
        const Vec3 impulse = fly(p, g, flown);
        if (keepExchange)
        {
            const FlightFactors f(g.Sp/p.mass, flown);
            store_.give(i, {impulse, g.Sp*f.p1, f.e, false});
        }
        if (time_.energyLedger)
        {
            const double work = p.kineticEnergy() - before;
            report.energy.kinetic += work;
            report.energy.gas += work;
        }
        if (periodic_.on()) p.x = periodic_.wrapped(p.x);
        if (store_.rest[i].inContact)
        {
            store_.rest[i].inContact = false;
            store_.changed(i);
        }
        ++report.freeFlights;
    }
}


void ParticleStep::finish(StepReport& report)
{
    report.resting += store_.counts.resting;
    report.flyingAtRest += store_.counts.flyingAtRest;
    report.inContact += store_.counts.inContact;
}

}
