// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves one island over one particle step: as one rigid body, if it is one and nothing disturbs
// it, else by the steps of an Island.
#pragma once

#include "materials/MaterialTable.hpp"
#include "system/IslandExchange.hpp"
#include "system/Span.hpp"
#include "system/StepReport.hpp"
#include "island/Island.hpp"
#include "walls/WallSearch.hpp"

#include <vector>

namespace dem
{

class RigidAggregate;

//- Members in order of id, as moved in one particle step
struct IslandMembers
{
    std::vector<Member> members;
    StepReport report;
    bool outran = false;    // one of them has left its search box, or the rim has woken

    //- Whether `other`, not moved yet, would be moved to where this is
    bool holdsFor(const std::vector<Member>& other) const;
};

class IslandMotion
{
public:

    //- Nothing is copied
    IslandMotion
    (
        const MaterialTable& materials, const TimeSettings& time, const WallSearch& walls,
        const Periodic& periodic
    );

    //- Move the members; keepExchange: what the gas gives to each is wanted.
    //  Errors: numericalError
    void move(IslandMembers& island, const Span& span, bool keepExchange);


private:

    static void shareImpacts(IslandMembers& island);
    bool flyTogether(IslandMembers& island, double dt);
    bool undisturbed
    (
        const std::vector<Member>& members, const std::vector<Particle>& flyers,
        const RigidAggregate& body
    ) const;
    void turnHistory(std::vector<Member>& members, const Eigen::Matrix3d& turn) const;

    void load(IslandMembers& island, double dt);
    bool wokeAtRim(std::vector<Member>& members) const;
    void integrate(IslandMembers& island, const Span& span, bool keepExchange);
    void integrateInParts(IslandMembers& island, const Span& span, bool keepExchange);

    const MaterialTable& materials_;
    const TimeSettings& time_;
    const WallSearch& walls_;
    const Periodic& periodic_;
    Island integrator_;
};

}
