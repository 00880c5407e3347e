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


void ParticleStep::advance(double dt, double now, bool keepExchange, StepReport& report)
{
    lap();
    tried_.clear();     // an earlier step may have ended in an error
    if (keepExchange) exchangeAtRest(dt);
    if (communicator_.any(anyAwake()))
    {
        Work work;
        finder_.begin(dt);
        do
        {
            while (!finder_.settled(dt)) {}
            work = sortOut();
            report.secondsSearch += lap();
        }
        while (!tryToMove(work, dt, now, keepExchange, report));
        flyFreely(work.flights, dt, keepExchange, report);
        report.secondsFlight += lap();
    }
    finish(report);
    store_.entering.clear();
    report.secondsSearch += lap();
}


bool ParticleStep::anyAwake() const
{
    for (std::size_t i = 0; i < store_.size(); ++i) if (store_.awake(i)) return true;
    return false;
}


Member ParticleStep::member(std::size_t i, std::int64_t component) const
{
    const Path& path = finder_.path(i);
    return
    {
        store_.particles[i], store_.gas[i], store_.rest[i], store_.contacts[i], path.joint,
        path.corridor, 0, component, communicator_.rank(), i, {}, store_.delay(i)
    };
}


//- Closed-form flight, islands of this rank, islands moved elsewhere, which are sent there
ParticleStep::Work ParticleStep::sortOut() const
{
    const int rank = communicator_.rank();
    Work work;
    std::vector<std::vector<Member>> away(std::size_t(communicator_.size()));
    for (std::size_t i = 0; i < store_.size(); ++i)
    {
        if (!finder_.crowded(i) && store_.awake(i)) work.flights.push_back(i);
    }
    for (std::size_t k = 0; k < finder_.crowd().size(); ++k)
    {
        const std::size_t i = finder_.crowd()[k];
        const Label& of = finder_.labels()[k];
        if (!of.active) continue;
        if (of.alone && !store_.flies(i)) work.flights.push_back(i);
        else if (of.shared && of.home != rank)
        {
            away[std::size_t(of.home)].push_back(member(i, of.component));
        }
        else work.islands[of.component].members.push_back(member(i, of.component));
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


StepReport ParticleStep::moveIslands(Work& work, double dt, double now, bool keepExchange)
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
        else motion_.move(island, dt, now, keepExchange);
        report.add(island.report);
    }
    return report;
}


//- Move the islands; false, with nothing moved, if somebody may have missed others
bool ParticleStep::tryToMove
(
    Work& work, double dt, double now, bool keepExchange, StepReport& report
)
{
    const int rank = communicator_.rank();
    const StepReport moved = moveIslands(work, dt, now, keepExchange);
    report.secondsContact += lap();

    std::vector<std::vector<Member>> back(std::size_t(communicator_.size()));
    std::vector<const Member*> own;
    for (const auto& entry : work.islands)
    {
        for (const Member& m : entry.second.members)
        {
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
    for (const Member* m : own) takeBack(*m);
    report.add(moved);
    report.secondsSearch += lap();
    return true;
}


bool ParticleStep::widenThoseWhoOutran(const std::vector<const Member*>& moved)
{
    bool any = false;
    for (const Member* m : moved)
    {
        if (m->outran <= 0) continue;
        finder_.widen(m->index, m->outran);
        any = true;
    }
    return any;
}


void ParticleStep::takeBack(const Member& m)
{
    store_.particles[m.index] = m.p;
    store_.rest[m.index] = m.rest;
    store_.contacts[m.index] = m.contacts;
    store_.exchange[m.index] = m.exchange;
}


void ParticleStep::flyFreely
(
    const std::vector<std::size_t>& flights, double dt, bool keepExchange, StepReport& report
)
{
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
            store_.exchange[i] = {impulse, g.Sp*f.p1, f.e, false};
        }
        if (time_.energyLedger)
        {
            const double work = p.kineticEnergy() - before;
            report.energy.kinetic += work;
            report.energy.gas += work;
        }
        store_.rest[i].inContact = false;
        ++report.freeFlights;
    }
}


//- What the gas gives to those at rest, whom nothing else may look at in this particle step
void ParticleStep::exchangeAtRest(double dt)
{
    for (std::size_t i = 0; i < store_.size(); ++i)
    {
        if (store_.awake(i)) continue;
        const GasLoad& g = store_.gas[i];
        store_.exchange[i] = {dt*(g.Sp*g.Uc + g.Su), dt*g.Sp, 1, true};
    }
}


void ParticleStep::finish(StepReport& report)
{
    for (std::size_t i = 0; i < store_.size(); ++i)
    {
        Vec3& x = store_.particles[i].x;
        if (periodic_.on()) x = periodic_.wrapped(x);
        report.resting += store_.rest[i].resting && !store_.flies(i);
        report.flyingAtRest += store_.flies(i);
        report.inContact += store_.rest[i].inContact;
    }
}

}
