// SPDX-License-Identifier: GPL-3.0-or-later
//
// When contacts can begin and end, and steps made for that: steps that end where a contact
// begins or ends, because the force jumps there, and steps graded as h (t/tau)^(1/2), tau = T/16,
// where a force begins or ends with an infinite slope (dashpots with overlap^(1/4), the end of a
// neck): t is the time since overlap 0 or until the end, by the speed of now. The first of them is
// h^2/(4 tau).
#pragma once

#include "island/Candidates.hpp"
#include "island/Environment.hpp"
#include "island/IslandState.hpp"

namespace dem
{

//- Nothing passes through a particle unseen: the most that a pair that does not touch yet
//  closes in a step [radii]
inline constexpr double mostPath = 0.05;

//- Earliest time at which a contact could begin, without a contact now [s]
double timeToTouchInFlight
(
    const Environment& env, const IslandState& state, const Candidates& candidates
);

//- The same with contacts, of what is near; they take contact steps of h, and press with no more
//  than `strongest` [m/s2]
double timeToTouchInContact
(
    const Environment& env, const IslandState& state, const Candidates& candidates,
    double strongest, double h
);

struct GradedStep
{
    double h;       // [s]
    double end;     // time after which a contact ends, if within that step, else 1e300 [s]
};

//- A step of at most h, graded if it is to be refined
GradedStep gradedStep
(
    const Environment& env, const IslandState& state, double strongest, double h, bool refined
);

//- h, or shorter where particles that do not touch yet would pass through each other, or in a
//  dense island meet within the next `looks` steps faster than its contacts so far allow
double meetingStep
(
    const Environment& env, const IslandState& state, const Candidates& candidates, double h,
    int looks, bool dense
);

}
