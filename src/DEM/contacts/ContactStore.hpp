// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contacts of an island as a value: those that are integrated, in flat columns by law, and
// those that are not (between two at rest, or outside of a run), as records by lower particle.
// How they get from one to the other: island/Contacts.hpp
#pragma once

#include "contactModels/contactModel/ContactLaw.hpp"
#include "contacts/ContactList.hpp"
#include "contacts/ContactRecord.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace dem
{

//- The bound of a contact, which holds up to this overlap and between these speeds
struct KnownBound
{
    ContactBound bound;
    double overlap;             // [m]
    double slowest, fastest;    // [m/s]
};

//- What is the same for all the life of a contact in a list
struct ContactEntry
{
    int materialJ;
    double neck;        // the contact ends at overlap -neck [m]
    double edge;        // overlap about which steps are graded [m]
    double pullOff;     // [N]
    RollingYield yield;
    double a0, R, m;
    double turning;     // (r_i/I_i + r_j/I_j)/2 [1/(kg m)]

    std::optional<KnownBound> known;    // in dense islands
};

//- A contact that is not in a list
struct StoredContact
{
    int j;              // local partner, -1 = wall
    ContactRecord record;
};

struct ContactStore
{
    struct Lists { ContactList pairs, walls; };

    std::vector<Lists> lists;               // by law
    std::vector<ContactEntry> entries;      // by tag
    std::vector<int> freeTags;

    std::vector<std::vector<StoredContact>> stored;
    std::vector<std::vector<int>> holders;  // of stored pair contacts, by higher partner
    std::vector<int> version;               // by particle: grows with each change of what is
                                            // stored of it

    bool anyListed() const
    {
        for (const Lists& l : lists)
        {
            if (l.pairs.size() || l.walls.size()) return true;
        }
        return false;
    }

    const ContactEntry& entry(const ContactList& list, std::size_t k) const
    {
        return entries[std::size_t(list.tag[k])];
    }

    //- f(law, list, k) for each contact in a list
    template<class F>
    void each(F&& f) const
    {
        for (std::size_t l = 0; l < lists.size(); ++l)
        {
            for (const ContactList* list : {&lists[l].pairs, &lists[l].walls})
            {
                for (std::size_t k = 0; k < list->size(); ++k) f(l, *list, k);
            }
        }
    }
};

//- The particles of contact k; the second is -1 on a wall
struct Partners { int i, j; };

inline Partners partners(const ContactList& list, std::size_t k)
{
    return {list.i[k], list.isWall() ? -1 : list.j[k]};
}

}
