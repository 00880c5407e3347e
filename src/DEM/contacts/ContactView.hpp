// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vector.hpp"

#include <cstdint>

namespace dem
{

//- One contact as diagnostics see it
struct ContactView
{
    std::int64_t idI;       // the lower id of a pair; the particle of a wall contact
    std::int64_t idJ;       // the higher id; -1 = wall
    int wall;               // index of the wall patch (Walls::patchName), -1 = pair
    Vec3 point;             // contact point [m]
    Vec3 normal;            // unit vector from i to j (into the wall)
    double overlap;         // delta [m]; negative in a neck
    Vec3 force;             // on i [N], elastic, damping and sliding
    double pullOff;         // critical pull-off force of this contact, as softened [N]
    double contactRadius;   // a [m]
    bool resting;
};

//- Which cluster of touching particles a particle belongs to
struct ClusterLabel
{
    std::int64_t root;      // lowest id of the cluster
    bool onWall;            // some member touches a wall
};

}
