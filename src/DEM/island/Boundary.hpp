// SPDX-License-Identifier: GPL-3.0-or-later
//
// Particles at rest in contact with one that is awake: what their contacts with others at rest
// gave to them, these go on giving.
#pragma once

#include "island/Contacts.hpp"
#include "island/WallCandidates.hpp"

#include <vector>

namespace dem
{

class Boundary
{
public:

    Boundary(const Environment& environment, const Contacts& contacts)
    :
        env_(environment),
        contacts_(contacts)
    {}

    //- At the start of a run
    void begin(const IslandState& state);

    //- Who is on the boundary now
    void find(const IslandState& state, const WallCandidates& walls);

    //- The loads of those, but for what the listed contacts give
    void load(IslandState& state) const
    {
        for (const int i : list_) state.loads[std::size_t(i)] = frozen_[std::size_t(i)];
    }

    const std::vector<int>& list() const { return list_; }


private:

    Load storedLoad(const IslandState& state, int i, const WallCandidates& walls);
    Load storedLoad
    (
        const IslandState& state, int lower, const StoredContact& s, bool ofLower,
        const WallCandidates& walls
    );

    const Environment& env_;
    const Contacts& contacts_;
    std::vector<int> list_;
    std::vector<Load> frozen_;      // by particle: sum over its stored contacts
    std::vector<int> version_;      // of the contacts that frozen_ is of
    std::vector<char> marked_;      // scratch, all 0 between calls
    ContactList scratch_;
};

}
