// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loads that contacts give to their partners, and the phase of their springs, which may be
// ahead of the loads by a part of a step (contactPeriod.hpp).
#pragma once

#include "island/Environment.hpp"
#include "island/IslandState.hpp"
#include "system/StepReport.hpp"

namespace dem
{

class Forces
{
public:

    explicit Forces(const Environment& environment) : env_(environment) {}

    //- Add the loads of all contacts in lists; springs are then `step.after` ahead. Returns
    //  whether some have come to their end.
    bool evaluate(IslandState& state, const SpringStep& step, StepReport& report) const;

    //- Let the springs be ahead by this [s]; loads are unchanged. Velocities as at the step's end
    void moveSprings(IslandState& state, double ahead) const;

    //- Take down how long the lists are: what comes then is new
    void noteSizes(const IslandState& state);

    //- Add the loads of the new contacts
    void addNew(IslandState& state) const;

    //- Take back the loads of those that have come to their end
    void takeBackEnded(IslandState& state) const;

    //- f(law, list, k) for each new contact
    template<class F>
    void eachNew(const IslandState& state, F&& f) const
    {
        for (std::size_t l = 0; l < sizes_.size(); ++l)
        {
            const ContactStore::Lists& lists = state.contacts.lists[l];
            for (std::size_t k = sizes_[l].pairs; k < lists.pairs.size(); ++k)
            {
                f(l, lists.pairs, k);
            }
            for (std::size_t k = sizes_[l].walls; k < lists.walls.size(); ++k)
            {
                f(l, lists.walls, k);
            }
        }
    }


private:

    struct Sizes { std::size_t pairs, walls; };

    //- Of contacts [begin, end) of a list, times sign
    bool add
    (
        IslandState& state, std::size_t law, ContactList& list, std::size_t begin,
        std::size_t end, const SpringStep& step, double sign
    ) const;

    const Environment& env_;
    std::vector<Sizes> sizes_;
};

}
