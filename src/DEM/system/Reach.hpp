// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a particle can get to within one particle step, and when two can first meet.
//
// Left alone, a particle follows a path that is known: straight but for what gas and spin bend.
// Whoever can be pushed gets away from that, from then on when it can first be hit, or from the
// mean motion of all that it can meet, as far as the fastest of them and some more; small
// motions of what holds together are allowed for. Where that turns out not to be enough the
// particle step is repeated.
#pragma once

#include "neighbourSearch/BoxGrid.hpp"
#include "system/ParticleStore.hpp"
#include "island/Corridor.hpp"
#include "walls/WallSearch.hpp"

namespace dem
{

//- What the search needs to know of a particle in one particle step
struct Path
{
    Vec3 x = Vec3::Zero();
    double size = 0;            // radius and reach of its contacts [m]
    Corridor corridor;          // of its own, or where others can push it
    Vec3 own = Vec3::Zero();    // velocity it has on its own [m/s]
    double gain = 0;            // what can come to that on its own [m/s]
    double bend = 0;            // how far from the straight line it gets on its own [m]
    std::int64_t rigid = -1;    // rigid aggregate; -2 = at rest
    bool pushed = false;        // contacts can push it off the path it has on its own
    bool held = false;          // at rest, or a wall can push it
    bool joint = false;         // others can: its corridor allows for that
    double hit = 1e300;         // when they first can [s]
    double hitNext = 1e300;     // as found since
    double least = 0;           // speed that it has had in a try [m/s]
    bool open = true;           // at rest it may wake: one awake can meet it. Else it is the rim
                                // of what moves
    bool openNext = false;      // as found since

    void pushedFromStart() { pushed = true; hit = hitNext = 0; }
};

//- How all that a particle can meet moves
struct Crowd
{
    Vec3 velocity;          // mean; 0 where anything is held [m/s]
    double speed;           // fastest member's bound, beyond that [m/s]
};

class Reach
{
public:

    //- Nothing is copied
    Reach(const ParticleStore& store, const WallSearch& walls, const Periodic& periodic)
    :
        store_(store),
        walls_(walls),
        periodic_(periodic)
    {}

    //- The path that particle i has on its own
    Path own(std::size_t i, double dt) const;

    //- Where others can push particle i, which has path p: off its own path, from the time on
    //  when they first can, or anywhere about the mean motion, whichever is less
    Corridor pushed(std::size_t i, const Path& p, const Crowd& crowd, double dt) const;

    //- The same where nothing is known of who meets whom; fastest: of all [m/s]
    Corridor anywhere(std::size_t i, double fastest) const;

    //- Where it can get to
    Box box(std::size_t i, const Path& p, double dt) const;

    bool wallWithin(const Box& b) const;

private:

    Corridor early(Corridor corridor) const;

    const ParticleStore& store_;
    const WallSearch& walls_;
    const Periodic& periodic_;
};

//- When two can first come as close as a contact, beyond dt if they cannot [s]
double meetingTime(const Path& a, const Path& b, double dt, const Periodic& periodic);

//- Whether two whose boxes overlap can meet, or belong together; takes down when, and whom one
//  awake can meet
bool meet(Path& a, Path& b, double dt, const Periodic& periodic);

}
