// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a contact begins, ends, is put away while both partners rest, and comes back. What began
// and ended in a step is returned, in the order in which it did: who else keeps books of contacts
// (Candidates, Rest) is told by that.
#pragma once

#include "island/Environment.hpp"
#include "island/IslandState.hpp"

#include <vector>

namespace dem
{

//- Two surfaces that have met
struct Touch
{
    int i, j;           // j = -1: a wall
    int patch;          // of the wall; -1 = pair
    Vec3 n;             // from i into the wall (wall only)
    double overlap;     // [m] (wall only)
};

//- What a contact step has changed
struct Changes
{
    std::vector<Touch> began;
    std::vector<Partners> ended;

    bool any() const { return !began.empty() || !ended.empty(); }
};

class Contacts
{
public:

    explicit Contacts(const Environment& environment) : env_(environment) {}

    //- Empty lists, one of each kind per law
    void setUp(ContactStore& store) const;

    //- Constants of a contact in its law
    void constants
    (
        const IslandState& state, int i, int j, int patch, int materialJ, double* c
    ) const;

    //- Begin these contacts
    void begin(IslandState& state, const std::vector<Touch>& touches) const;

    //- Contact k with a wall, of this law, goes on with this patch, with all that it remembers;
    //  false, and nothing is done: that has another law
    bool handOver(IslandState& state, std::size_t law, std::size_t k, int patch) const;

    //- End those that their law has marked
    std::vector<Partners> end(IslandState& state) const;

    //- Put what is stored, but not between two at rest, into the lists: of all particles at the
    //  start of a run, and of those that were woken. Returned: the pairs.
    std::vector<Partners> resumeAll(IslandState& state) const;
    std::vector<Partners> resume(IslandState& state, const std::vector<int>& woken) const;

    //- Store what is between two at rest, and at the end of a run all, by partner and normal
    void putToRest(IslandState& state) const;
    void storeAll(IslandState& state) const;


private:

    ContactEntry entry
    (
        const IslandState& state, int i, int j, int patch, double* constants
    ) const;
    ContactList& begin
    (
        IslandState& state, int i, int j, int patch, const ContactRecord* record
    ) const;
    void remove(ContactStore& store, ContactList& list, std::size_t k) const;
    void store(IslandState& state, const ContactList& list, std::size_t k) const;
    void resume(IslandState& state, std::size_t i, std::vector<Partners>& resumed) const;

    const Environment& env_;
};

}
