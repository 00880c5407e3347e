// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contactModels/contactModel/ContactLaw.hpp"

#include <cstdint>

namespace dem
{

//- A contact between particle steps: what travels with its lower particle
struct ContactRecord
{
    std::int64_t idJ;               // partner; -1 = wall
    int wall;                       // wall patch; -1 = pair
    double n[3];                    // last normal into the wall (wall only)
    double history[maxHistory];

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.idJ);
        f(s.wall);
        f(s.n);
        f(s.history);
    }
};

//- What is remembered of a particle's contacts and rest
struct RestState
{
    bool inContact = false;
    bool resting = false;
    double quietTime = 0;   // [s] for how long it has met the sleep criterion
    double force[3] = {};   // gas force at rest when it fell asleep [N]
    double wakeForce = 0;   // change of that force which wakes it [N]
    double pullOff = 0;     // of its weakest contact then [N]

    // At rest among the members of a flying aggregate; `force` is then what its contacts
    // give to it
    std::int64_t aggregate = -1;    // lowest id of the members; -1 = does not fly
    int members = 0;
    double arm[3] = {};             // from the centre of mass [m]

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.inContact);
        f(s.resting);
        f(s.quietTime);
        f(s.force);
        f(s.wakeForce);
        f(s.pullOff);
        f(s.aggregate);
        f(s.members);
        f(s.arm);
    }
};

}
