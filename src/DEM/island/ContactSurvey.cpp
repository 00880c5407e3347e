// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/ContactSurvey.hpp"

#include "island/eventTimes.hpp"
#include "particles/finite.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dem
{

namespace
{

// A stability bound below this share of the period of the contacts is not worth keeping to
constexpr double leastBound = 1e-5;

// Contacts that can be so deep before the next look are watched at every step, and deeper ones
// are covered by no law [radii]
constexpr double deepOverlap = 0.85;
constexpr double deepestOverlap = 0.9;

}


double ContactSurvey::longestStep() const
{
    return std::min(1/env_.time.stepsPerContact, env_.time.boundShare/M_PI);
}


void ContactSurvey::findAccelerations(const IslandState& state)
{
    const std::size_t n = state.particles.size();
    accelerations_.resize(n);
    double strongest = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        accelerations_[i] = acceleration(state, int(i));
        strongest = std::max(strongest, accelerations_[i].squaredNorm());
    }
    last_.strongest = std::sqrt(strongest);
}


ContactSurvey::Approach ContactSurvey::approach
(
    const IslandState& state, const ContactList& list, std::size_t k
) const
{
    const std::size_t i = std::size_t(list.i[k]);
    const Body& bi = state.bodies[i];
    double smaller = bi.r;
    Vec3 n, v = vec(bi.v), a = accelerations_[i];
    if (list.isWall()) n = Vec3(list.nx[k], list.ny[k], list.nz[k]);
    else
    {
        const std::size_t j = std::size_t(list.j[k]);
        const Body& bj = state.bodies[j];
        n = env_.periodic.nearest(vec(bj.x) - vec(bi.x)).normalized();
        v -= vec(bj.v);
        a -= accelerations_[j];
        smaller = std::min(smaller, bj.r);
    }
    return {smaller, std::fabs(v.dot(n)), std::max(0.0, a.dot(n))};
}


void ContactSurvey::check
(
    const IslandState& state, const ContactList& list, std::size_t k, const Approach& a,
    double time, StepReport& report
) const
{
    const Partners p = partners(list, k);
    if (!isFinite(a.speed) || !isFinite(list.overlap[k]))
    {
        fail(state, "is not finite", p.i, p.j, time);
    }
    if (list.overlap[k] > deepestOverlap*a.smaller)
    {
        fail
        (
            state,
            "has an overlap of " + std::to_string(list.overlap[k]/a.smaller)
          + " radii, more than any contact law covers",
            p.i, p.j, time
        );
    }
    // in a mirror it stands for nothing but the time of the turn
    if (list.isWall() && env_.mirrors(list.j[k])) return;
    report.maxOverlapOverDiameter =
        std::max(report.maxOverlapOverDiameter, list.overlap[k]/(2*a.smaller));
}


//- One contact at its stiffest, from an overlap [m] and a speed of approach [m/s]
ContactBound ContactSurvey::boundAt
(
    const IslandState& state, std::size_t law, const ContactList& list, std::size_t k,
    double overlap, double speed
) const
{
    const ContactEntry& e = state.contacts.entry(list, k);
    const int mi = state.particles[std::size_t(list.i[k])].material;
    double c[maxConstants], history[maxHistory];
    for (std::size_t m = 0; m < list.constants.size(); ++m) c[m] = list.constants[m][k];
    for (std::size_t m = 0; m < list.history.size(); ++m) history[m] = list.history[m][k];
    return env_.law(law).bound
    (
        env_.materials.pairInLaw(mi, e.materialJ),
        {env_.materials.constants(mi, e.materialJ), e.R, e.m}, c, history, e.turning, overlap,
        speed
    );
}


ContactSurvey::Stiffest ContactSurvey::exactBound
(
    const IslandState& state, std::size_t law, const ContactList& list, std::size_t k,
    const Approach& a, double ahead
) const
{
    const ContactEntry& e = state.contacts.entry(list, k);
    ContactBound b = boundAt(state, law, list, k, list.overlap[k], a.speed);
    const double gained = a.pressing*ahead*b.period;
    const double depth = b.radius*b.radius/e.R;
    if (e.m*gained*(gained + a.speed) > 0.01*b.stiffness*depth*depth)
    {
        b = boundAt(state, law, list, k, list.overlap[k], a.speed + gained);
    }
    return {b, gained};
}


//- Of many contacts most are as they were: what was found with some margin goes on being right
ContactSurvey::Stiffest ContactSurvey::denseBound
(
    IslandState& state, std::size_t law, const ContactList& list, std::size_t k,
    const Approach& a, double ahead
) const
{
    ContactEntry& e = state.contacts.entries[std::size_t(list.tag[k])];
    const auto gain = [&](const ContactBound& b) { return a.pressing*ahead*b.period; };
    const double overlap = list.overlap[k];
    double gained = e.known ? gain(e.known->bound) : 0;
    const double fast = a.speed + gained;
    if
    (
        !e.known || !(fast <= e.known->fastest) || overlap > e.known->overlap
     || fast < e.known->slowest
    )
    {
        const ContactBound b = boundAt(state, law, list, k, overlap, 1.25*fast);
        const double depth = b.radius*b.radius/e.R;
        const double gentle = 0.1*depth*std::sqrt(b.stiffness/e.m);
        KnownBound known;
        known.fastest = std::max(1.25*fast, gentle);
        known.overlap = overlap + 0.05*depth;
        known.slowest = 1.25*fast > gentle ? 0.5*fast : 0;
        known.bound = boundAt(state, law, list, k, known.overlap, known.fastest);
        e.known = known;
        gained = gain(known.bound);
    }
    return {e.known->bound, gained};
}


bool ContactSurvey::look
(
    IslandState& state, const Candidates& candidates, int looks, bool dense, double time,
    StepReport& report
)
{
    last_.deep = false;
    sums_.reset(state.particles.size());
    findAccelerations(state);

    // what presses may make a contact faster, and so stiffer, before the next look; in an island
    // of many a load that stays, by a T/(2 pi) at most
    const double longest = longestStep();
    const double periods = looks*longest;
    const double ahead = dense ? std::min(periods, 0.25) : periods;
    Extremes most;
    state.contacts.each([&](std::size_t law, const ContactList& list, std::size_t k)
    {
        const Approach a = approach(state, list, k);
        check(state, list, k, a, time, report);
        const Stiffest s =
            dense
          ? denseBound(state, law, list, k, a, ahead)
          : exactBound(state, law, list, k, a, ahead);

        // no deeper than laws cover, unseen
        const double closing = looks*(a.speed + s.gained);
        if (closing > 0) most.path = std::min(most.path, 0.3*a.smaller/closing);
        last_.deep =
            last_.deep
         || list.overlap[k] + closing*s.bound.period*longest > deepOverlap*a.smaller;
        most.period = std::min(most.period, s.bound.period);
        most.slipTime = std::min(most.slipTime, s.bound.slipTime);
        most.turnTime = std::min(most.turnTime, s.bound.turnTime);
        sums_.add(partners(list, k), s.bound);
    });
    if (!state.contacts.anyListed()) return false;

    const StabilitySums::Sums sums = sums_.most(state);
    last_.bound = sums.bound();
    last_.period = most.period;
    double h = most.period/env_.time.stepsPerContact;
    if (last_.bound < leastBound*last_.period) failBound(state, time);
    h = std::min({h, env_.time.boundShare*last_.bound, most.path});
    h = std::min(h, meetingStep(env_, state, candidates, h, looks, dense));

    // what springs without a dashpot lack, see contactPeriod.hpp
    const double lacks = std::max
    ({
        0.0, h*h*sums.stiffness/8 - most.slipTime/h,
        h*h*(sums.rolling + sums.twisting)/8 - most.turnTime/h
    });
    last_.springLead = 0.5 - std::min(lacks, 0.5);
    last_.step = h;
    return true;
}


void ContactSurvey::failBound(const IslandState& state, double time) const
{
    std::ostringstream what;
    what << "is in an island whose dashpots are stable below a step of " << last_.bound
         << " s only, " << last_.bound/last_.period
         << " of a contact's period (rollingDamping, twistingDamping)";
    fail(state, what.str(), state.awake.empty() ? 0 : state.awake[0], -1, time);
}


double ContactSurvey::boundNow(const IslandState& state)
{
    sums_.reset(state.particles.size());
    state.contacts.each([&](std::size_t law, const ContactList& list, std::size_t k)
    {
        sums_.add(partners(list, k), boundAt(state, law, list, k, list.overlap[k], 0));
    });
    return sums_.most(state).bound();
}

}
