// SPDX-License-Identifier: GPL-3.0-or-later
//
// One particle step: finds the islands, sends those that span ranks to the rank that moves
// them, moves all, takes the results back. Contacts may make particles so fast that they leave
// the boxes they were searched in, and may have missed others, or wake the rim of those at rest
// who were let in: then it begins again, with their paths as fast as that, the rim farther out
// and nothing moved; what holds good is kept for the next try.
#pragma once

#include "materials/MaterialTable.hpp"
#include "system/IslandExchange.hpp"
#include "system/IslandFinder.hpp"
#include "system/IslandMotion.hpp"
#include "system/ParticleStore.hpp"
#include "system/Span.hpp"
#include "system/StepReport.hpp"

#include <chrono>
#include <map>
#include <unordered_map>
#include <vector>

namespace dem
{

class ParticleStep
{
public:

    //- Nothing is copied; the store is what it moves
    ParticleStep
    (
        ParticleStore& store, const MaterialTable& materials, const TimeSettings& time,
        const WallSearch& walls, const Periodic& periodic, const Communicator& communicator
    );

    //- keepExchange: with ParticleStore::exchange. Adds to the report. Collective.
    //  Errors: numericalError
    void advance(const Span& span, bool keepExchange, StepReport& report);


private:

    using Clock = std::chrono::steady_clock;

    //- Islands by component, and those who fly freely
    struct Work
    {
        std::map<std::int64_t, IslandMembers> islands;
        std::vector<std::size_t> flights;
    };

    Member member(std::size_t i, std::int64_t component) const;
    Work sortOut() const;
    bool tryToMove(Work& work, const Span& span, bool keepExchange, StepReport& report);
    StepReport moveIslands(Work& work, const Span& span, bool keepExchange);
    bool widenThoseWhoOutran(const std::vector<const Member*>& moved);
    void takeBack(const Member& m);
    void flyFreely
    (
        const std::vector<std::size_t>& flights, double dt, bool keepExchange, StepReport& report
    );
    void finish(StepReport& report);
    double lap();

    ParticleStore& store_;
    const TimeSettings& time_;
    const Periodic& periodic_;
    const Communicator& communicator_;
    IslandFinder finder_;
    IslandMotion motion_;
    IslandExchange exchange_;
    std::map<std::int64_t, IslandMembers> tried_;  // by component, from a try that was not enough
    std::unordered_map<std::int64_t, double> behind_;  // by id, of this step: ParticleStore::delay
    Clock::time_point clock_;
};

}
