// SPDX-License-Identifier: GPL-3.0-or-later
//
// What System::packState() gives: restNumbers of the particle, then contactNumbers for each
// of its contacts. Some of them are integers, which a text file must not round.
#pragma once

#include "contactModels/contactModel/ContactLaw.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem
{

struct PackedState
{
    // Raise it with every change of the fields of RestState or ContactRecord. (1, which began
    // with whether the particle touches, 0 or 1, had none.)
    static constexpr double version = 2;

    // Of the particle: version, inContact, resting, quietTime, force (3), wakeForce, pullOff,
    // aggregate, members, arm (3)
    static constexpr std::size_t restNumbers = 14;
    static constexpr std::size_t restIntegers[] = {0, 1, 2, 9, 10};
    static constexpr std::size_t aggregate = 9;     // id of a particle, -1 = none

    // Of a contact: partner, wall, normal (3), history
    static constexpr std::size_t contactNumbers = 5 + maxHistory;
    static constexpr std::size_t contactIntegers[] = {0, 1};
    static constexpr std::size_t partner = 0;       // id of a particle, -1 = wall
    static constexpr std::size_t wall = 1;          // patch, -1 = pair

    static bool fits(std::size_t size)
    {
        return size >= restNumbers && (size - restNumbers)%contactNumbers == 0;
    }

    //- Of one that fits
    static std::size_t contacts(std::size_t size)
    {
        return (size - restNumbers)/contactNumbers;
    }

    //- What cannot be in it, "" if nothing. idI: whose it is; nWalls: wall patches then
    static const char* fault(const std::vector<double>& state, std::int64_t idI, int nWalls);
};

}
