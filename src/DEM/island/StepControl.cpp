// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/StepControl.hpp"

#include "island/eventTimes.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

namespace
{

// Contact steps between two looks at the contact step and at rest
constexpr int stepsBetweenLooks = 4;
constexpr int stepsBetweenLooksDense = 64;

// Above this many candidates an island is dense
constexpr std::size_t denseIsland = 256;

// Steps are graded, and loads foreseen, below this share of the stability bound: both are for
// accuracy, and the bound is that of equal steps
constexpr double refinedShare = 0.4;

// So many steps in a row may end at an event
constexpr int mostShortened = 3;

constexpr std::int64_t mostFlights = 10000000;

}


int StepControl::lookInterval() const
{
    return dense_ ? stepsBetweenLooksDense : stepsBetweenLooks;
}


//- An event is passed by at most this part of a step: its error is of second order too
double StepControl::overshoot() const
{
    return std::min(1e-3, 0.05/env_.time.stepsPerContact);
}


void StepControl::begin
(
    IslandState& state, const Candidates& candidates, const Span& span
)
{
    const double dt = span.dt;
    survey_.forget();
    stiffest_.begin(state, dt);
    state.phase.fastest = stiffest_.freeSpeed();
    state.phase.left = dt;
    dense_ = candidates.pairs().all().size() >= denseIsland;
    time_ = span.now;
    run_ = dt;
    ahead_ = span.ahead;
    done_ = h_ = sinceRest_ = 0;
    contactStep_.reset();
    refined_ = false;
    shortened_ = 0;
    nearTouch_ = 0;
    flights_ = 0;
    lookSoon();
}


Step StepControl::next
(
    IslandState& state, Propagator& propagator, Candidates& candidates, StepReport& report
)
{
    const double left = state.phase.left = this->left();
    const bool contact = state.contacts.anyListed();
    const double now =
        !env_.time.islands ? evenStep(state, propagator, candidates, report)
      : contact ? contactStep(state, propagator, candidates, report)
      : flight(state, candidates);
    candidates.expect(state, now);
    return {now, std::min(h_, left - now), survey_.last().springLead, !contact, refined_};
}


void StepControl::took(const IslandState& state, const Step& step)
{
    done_ = step.h < state.phase.left ? done_ + step.h : run_;
}


void StepControl::event()
{
    if (!dense_) lookSoon();
}


std::optional<double> StepControl::restDue()
{
    if (survey_.last().deep) lookSoon();
    if (!lookIsDue() || !(sinceRest_ > 0)) return {};
    const double since = sinceRest_;
    sinceRest_ = 0;
    return since;
}


bool StepControl::look(IslandState& state, const Candidates& candidates, StepReport& report)
{
    return survey_.look(state, candidates, lookInterval(), dense_, time_ + done_, report);
}


//- The longest of equal steps up to the end of the particle step, at most `allowed`
double StepControl::even(double allowed) const
{
    const double left = this->left() + ahead_;
    return left/std::ceil(left/allowed*(1 - 1e-12));
}


//- Everything takes the step of the stiffest possible contact
double StepControl::evenStep
(
    IslandState& state, Propagator& propagator, const Candidates& candidates,
    StepReport& report
)
{
    const double left = state.phase.left;
    if (lookIsDue())
    {
        propagator.complete(state);
        stiffest_.note(state, survey_.longestStep());
        h_ = stiffest_.step();
        if (look(state, candidates, report)) h_ = std::min(h_, survey_.last().step);
        h_ = even(h_);
        looked_ = 0;
    }
    const double now = left < 1.5*h_ ? left : h_;
    ++report.contactSteps;
    ++looked_;
    sinceRest_ += now;
    return now;
}


//- Equal steps up to the end of the particle step
void StepControl::lookAtContacts
(
    IslandState& state, Propagator& propagator, Candidates& candidates, StepReport& report
)
{
    propagator.complete(state);
    look(state, candidates, report);
    const double allowed = survey_.last().step;
    if (!dense_ || !(h_ <= allowed && allowed < 1.05*h_))
    {
        h_ = even(allowed);
    }
    contactStep_ = h_;
    const bool refined = !dense_ && h_ < refinedShare*survey_.last().bound;
    if (!refined || !refined_) propagator.forgetLoads();
    refined_ = refined;
    const double skin = candidates.skin().width;
    if (skin > 4*200*state.phase.fastest*h_ && skin > 4e-3*candidates.smallest())
    {
        candidates.refresh(state, contactStep_);
    }
    looked_ = 0;
}


double StepControl::contactStep
(
    IslandState& state, Propagator& propagator, Candidates& candidates, StepReport& report
)
{
    if (lookIsDue()) lookAtContacts(state, propagator, candidates, report);
    const double left = state.phase.left;
    double now = left < 1.5*h_ ? left : h_;
    if (!dense_ && shortened_ < mostShortened) now = toNextEvent(state, candidates, now);
    else
    {
        if (shortened_ > 0) now = pastEvents(state, candidates, now);
        shortened_ = 0;
    }
    ++report.contactSteps;
    ++looked_;
    sinceRest_ += now;
    return now;
}


double StepControl::toNextEvent(IslandState& state, Candidates& candidates, double now)
{
    const double strongest = survey_.last().strongest;
    const GradedStep graded = gradedStep(env_, state, strongest, h_, refined_);
    now = std::min(now, graded.h);
    candidates.look(state, now, contactStep_);
    const double touch = timeToTouchInContact(env_, state, candidates, strongest, h_);
    const double event = std::min(touch, graded.end);
    if (event < now)
    {
        // a little beyond, so that it has happened
        now = std::min(now, std::max(event*(1 + 1e-9), overshoot()*h_));
        ++shortened_;
        lookSoon();
    }
    else shortened_ = 0;
    return now;
}


//- Where events crowd, one is passed; a touch by no more than a step of the stiffest contact
//  that can begin
double StepControl::pastEvents(IslandState& state, Candidates& candidates, double now)
{
    candidates.look(state, now, contactStep_);
    const double touch =
        timeToTouchInContact(env_, state, candidates, survey_.last().strongest, h_);
    if (touch < now)
    {
        stiffest_.note(state, survey_.longestStep());
        now = std::min(now, std::max(touch*(1 + 1e-9), stiffest_.step()));
        lookSoon();
    }
    return now;
}


double StepControl::flight(const IslandState& state, Candidates& candidates)
{
    const double left = state.phase.left;
    candidates.keepInBoxes(state, left);
    double now = timeToTouchInFlight(env_, state, candidates);
    const double smallest = candidates.smallest();
    const double speed = std::max({state.phase.fastest, stiffest_.freeSpeed(), 1e-300});
    if (now < 1e-6*smallest/speed)
    {
        // near a touch go on by small parts of the contact step that would follow: the first
        // so small that the overlap with which the contact begins tells nothing of the way there
        stiffest_.note(state, survey_.longestStep());
        const double path = mostPath*smallest/std::max(stiffest_.speed(), 1e-300);
        const double most = overshoot()*std::min(stiffest_.step(), path);
        now = std::max(now, std::ldexp(1e-3*most, std::min(nearTouch_++, 10)));
    }
    else nearTouch_ = 0;
    lookSoon();
    sinceRest_ = 0;
    if (++flights_ > mostFlights)
    {
        fail(state, "is approached in too many steps", state.awake[0], -1, time_ + done_);
    }
    return std::min(now, left);
}


void StepControl::finish
(
    IslandState& state, const Candidates& candidates, StepReport& report
)
{
    if (!state.contacts.anyListed()) return;
    done_ = run_;
    look(state, candidates, report);
    if (!(h_ > 0)) return;
    const Survey& last = survey_.last();
    report.minStepsPerContact = std::min(report.minStepsPerContact, last.period/h_);
    report.maxStepOverBound = std::max(report.maxStepOverBound, h_/last.bound);
}

}
