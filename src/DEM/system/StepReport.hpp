// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vector.hpp"
#include "system/EnergyLedger.hpp"

#include <cstdint>
#include <vector>

namespace dem
{

//- A contact with a wall, no mirror, that has formed
struct WallImpact
{
    std::int64_t id = 0;        // of the particle
    std::size_t index = 0;      // of the same, on its rank
    int patch = 0;              // index into Walls::patches
    double time = 0;            // [s]
    Vec3 x, v, omega;           // as it arrives: centre [m], velocity [m/s], spin [rad/s]
    Vec3 n;                     // into the wall

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.id);
        f(s.index);
        f(s.patch);
        f(s.time);
        f(s.x);
        f(s.v);
        f(s.omega);
        f(s.n);
    }
};

//- What one advance() did, on this rank. Counts add over steps and ranks.
struct StepReport
{
    std::int64_t contactSteps = 0;      // island contact steps taken
    std::int64_t contactUpdates = 0;    // contacts evaluated, summed over steps
    std::int64_t islands = 0;           // islands integrated
    std::int64_t freeFlights = 0;       // particles moved in closed form over the whole step
    std::int64_t aggregateFlights = 0;  // aggregates moved as one body over the whole step
    std::int64_t repeats = 0;           // steps done again, as particles left their boxes
    std::int64_t touches = 0;           // contacts formed, also with mirrors
    Sum touchSpeed;                     // sum of their speeds of approach [m/s]
    Sum touchSpeedSquare;               // sum of the squares of these [m2/s2]
    // contacts with walls (no mirrors) formed by particles that the gas has brought: tau_p v_n < r, i.e. they
    // would have stopped within their radius, and no other force has driven them
    std::int64_t followerTouches = 0;
    std::int64_t separations = 0;       // contacts ended
    std::int64_t sleeps = 0;            // particles put to rest
    std::int64_t wakes = 0;             // particles woken
    std::int64_t resting = 0;           // particles at rest in deposits at the end
    std::int64_t flyingAtRest = 0;      // particles in aggregates at rest inside at the end
    std::int64_t inContact = 0;         // particles in contact at the end
    double maxOverlapOverDiameter = 0;  // largest delta/(2 min(r_i, r_j)) met, but in mirrors
    double minStepsPerContact = 1e300;  // period over step of the stiffest contact met
    // largest contact step over its stability bound, at the end of each island; with the energy
    // ledger on also over that of the contacts as each step left them
    double maxStepOverBound = 0;
    Sum energyRemovedByRest;            // [J]
    EnergyLedger energy;                // timeIntegration { energyLedger on; } only
    std::vector<WallImpact> wallImpacts;      // where Walls::reportImpacts; of this rank's particles
    double secondsSearch = 0;           // broad phase, ghosts, islands
    double secondsContact = 0;          // integration of islands
    double secondsFlight = 0;           // closed-form flight

    void add(const StepReport& other);
};

}
