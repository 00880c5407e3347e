// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a step is chosen. Without a contact the island flies in closed form to its next touch. With
// one it takes equal contact steps (ContactSurvey.hpp) up to the end of the run, looked at again
// after some steps and after each event. Small islands, at steps well below the stability bound,
// keep second order where the force is not smooth, too: they end steps at events, and refine them
// (eventTimes.hpp). An island of many is dense: a single event is no longer worth a step of its
// own. With timeIntegration { islands off; } all take the step of the stiffest possible contact.
#pragma once

#include "island/Candidates.hpp"
#include "island/ContactSurvey.hpp"
#include "island/Environment.hpp"
#include "island/IslandState.hpp"
#include "island/Propagator.hpp"
#include "island/StiffestStep.hpp"
#include "system/Span.hpp"
#include "system/StepReport.hpp"

#include <optional>

namespace dem
{

struct Step
{
    double h;           // [s]
    double next;        // expected after it [s]
    double springLead;  // share of a step by which springs are to be ahead
    bool flight;        // without a contact
    bool refined;       // loads are foreseen
};

class StepControl
{
public:

    explicit StepControl(const Environment& environment)
    :
        env_(environment),
        survey_(environment),
        stiffest_(environment)
    {}

    //- A run begins
    void begin(IslandState& state, const Candidates& candidates, const Span& span);

    //- Of the run [s]
    double left() const { return run_ - done_; }
    double now() const { return time_ + done_; }

    //- Choose a step
    Step next
    (
        IslandState& state, Propagator& propagator, Candidates& candidates,
        StepReport& report
    );

    //- It has been taken. Returns whether contacts are to be looked at before the next one
    void took(const IslandState& state, const Step& step);

    //- Contacts have begun or ended
    void event();

    //- Time since rest was judged, if it is to be judged now
    std::optional<double> restDue();

    //- Steps end where contacts begin and end
    bool exactEvents() const { return !dense_; }

    //- As it is now [s]; none before the first one
    std::optional<double> contactStep() const { return contactStep_; }

    //- Stability bound of the contacts as they are [s]
    double boundNow(const IslandState& state) { return survey_.boundNow(state); }

    //- At the end: steps in the shortest contact, as taken
    void finish(IslandState& state, const Candidates& candidates, StepReport& report);


private:

    int lookInterval() const;
    bool lookIsDue() const { return looked_ >= lookInterval(); }
    void lookSoon() { looked_ = lookInterval(); }
    bool look(IslandState& state, const Candidates& candidates, StepReport& report);

    double even(double allowed) const;
    double evenStep
    (
        IslandState& state, Propagator& propagator, const Candidates& candidates,
        StepReport& report
    );
    double contactStep
    (
        IslandState& state, Propagator& propagator, Candidates& candidates,
        StepReport& report
    );
    void lookAtContacts
    (
        IslandState& state, Propagator& propagator, Candidates& candidates,
        StepReport& report
    );
    double toNextEvent(IslandState& state, Candidates& candidates, double h);
    double pastEvents(IslandState& state, Candidates& candidates, double h);
    double flight(const IslandState& state, Candidates& candidates);
    double overshoot() const;

    const Environment& env_;
    ContactSurvey survey_;
    StiffestStep stiffest_;
    double time_ = 0, run_ = 0, done_ = 0;  // [s] at the start; of the run; of it, done
    double ahead_ = 0;                      // [s] the particle step goes on after the run
    bool dense_ = false;
    double h_ = 0;                          // [s] step between events
    std::optional<double> contactStep_;     // [s] the same with contacts
    bool refined_ = false;                  // small islands well below the bound
    int looked_ = 0;                        // steps since the last look
    double sinceRest_ = 0;                  // [s] with contacts since rest was judged
    int shortened_ = 0;                     // steps in a row that ended at an event
    int nearTouch_ = 0;                     // flights in a row that ended close to a touch
    std::int64_t flights_ = 0;
};

}
