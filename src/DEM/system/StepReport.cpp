// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/StepReport.hpp"

#include <algorithm>

namespace dem
{

void StepReport::add(const StepReport& o)
{
    contactSteps += o.contactSteps;
    contactUpdates += o.contactUpdates;
    islands += o.islands;
    freeFlights += o.freeFlights;
    aggregateFlights += o.aggregateFlights;
    repeats += o.repeats;
    touches += o.touches;
    touchSpeed += o.touchSpeed;
    touchSpeedSquare += o.touchSpeedSquare;
    followerTouches += o.followerTouches;
    separations += o.separations;
    sleeps += o.sleeps;
    wakes += o.wakes;
    resting = o.resting;
    flyingAtRest = o.flyingAtRest;
    inContact = o.inContact;
    maxOverlapOverDiameter =
        std::max(maxOverlapOverDiameter, o.maxOverlapOverDiameter);
    minStepsPerContact = std::min(minStepsPerContact, o.minStepsPerContact);
    maxStepOverBound = std::max(maxStepOverBound, o.maxStepOverBound);
    energyRemovedByRest += o.energyRemovedByRest;
    energy += o.energy;
    wallImpacts.insert(wallImpacts.end(), o.wallImpacts.begin(), o.wallImpacts.end());
    secondsSearch += o.secondsSearch;
    secondsContact += o.secondsContact;
    secondsFlight += o.secondsFlight;
}

}
