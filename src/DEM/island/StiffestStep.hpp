// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "island/Environment.hpp"
#include "island/IslandState.hpp"

#include <optional>

namespace dem
{

//- The contact step of the stiffest contact that could come about, at the greatest speed so far:
//  contacts can add to what a free flight allows
class StiffestStep
{
public:

    explicit StiffestStep(const Environment& environment) : env_(environment) {}

    //- At the start of a run of dt
    void begin(const IslandState& state, double dt);

    //- No particle can be faster in this run, but for contact forces [m/s]
    double freeSpeed() const { return freeSpeed_; }

    //- Note how fast they are now
    void note(const IslandState& state, double longestStep);

    //- As last noted [m/s], [s]
    double speed() const { return *speed_; }
    double step() const { return step_; }


private:

    double shortestPeriod(const IslandState& state, double speed) const;

    const Environment& env_;
    double freeSpeed_ = 0;
    std::optional<double> speed_;
    double step_ = 0;
};

}
