// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/Forces.hpp"

namespace dem
{

inline bool Forces::add
(
    IslandState& state, std::size_t law, ContactList& list, std::size_t begin,
    std::size_t end, const SpringStep& step, double sign
) const
{
    if (begin == end) return false;
    if (list.isWall())
    {
        return env_.law(law).evaluateWalls
        (
            list, begin, end, state.bodies.data(), state.loads.data(), step, sign
        );
    }
    return env_.law(law).evaluatePairs
    (
        list, begin, end, state.bodies.data(), state.loads.data(), step, sign, env_.periodic
    );
}


bool Forces::evaluate(IslandState& state, const SpringStep& step, StepReport& report) const
{
    bool ended = false;
    std::vector<ContactStore::Lists>& lists = state.contacts.lists;
    for (std::size_t l = 0; l < lists.size(); ++l)
    {
        ContactList &pairs = lists[l].pairs, &walls = lists[l].walls;
        const std::size_t nPairs = pairs.size(), nWalls = walls.size();
        ended |= add(state, l, pairs, 0, nPairs, step, 1);
        ended |= add(state, l, walls, 0, nWalls, step, 1);
        report.contactUpdates += std::int64_t(nPairs + nWalls);
    }
    state.phase.ahead = step.after;
    return ended;
}


void Forces::moveSprings(IslandState& state, double ahead) const
{
    const SpringStep step{0, -state.phase.ahead, ahead};
    std::vector<ContactStore::Lists>& lists = state.contacts.lists;
    for (std::size_t l = 0; l < lists.size(); ++l)
    {
        if (!env_.law(l).needsSpin()) continue;
        add(state, l, lists[l].pairs, 0, lists[l].pairs.size(), step, 0);
        add(state, l, lists[l].walls, 0, lists[l].walls.size(), step, 0);
    }
    state.phase.ahead = ahead;
}


void Forces::noteSizes(const IslandState& state)
{
    sizes_.clear();
    for (const ContactStore::Lists& l : state.contacts.lists)
    {
        sizes_.push_back({l.pairs.size(), l.walls.size()});
    }
}


void Forces::addNew(IslandState& state) const
{
    const SpringStep step{0, 0, state.phase.ahead};
    for (std::size_t l = 0; l < sizes_.size(); ++l)
    {
        ContactStore::Lists& lists = state.contacts.lists[l];
        add(state, l, lists.pairs, sizes_[l].pairs, lists.pairs.size(), step, 1);
        add(state, l, lists.walls, sizes_[l].walls, lists.walls.size(), step, 1);
    }
}


void Forces::takeBackEnded(IslandState& state) const
{
    const SpringStep step{0, -state.phase.ahead, 0};
    for (std::size_t l = 0; l < state.contacts.lists.size(); ++l)
    {
        ContactStore::Lists& lists = state.contacts.lists[l];
        for (ContactList* list : {&lists.pairs, &lists.walls})
        {
            for (std::size_t k = list->size(); k-- > 0;)
            {
                if (!list->ended[k]) continue;
                add(state, l, *list, k, k + 1, step, -1);
                list->ended[k] = 1;     // whatever was found now
            }
        }
    }
}

}
