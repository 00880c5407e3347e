// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/IslandExchange.hpp"

#include "foundation/Fields.hpp"

#include <algorithm>

namespace dem
{

JoinedComponents::JoinedComponents
(
    std::vector<std::vector<Shown>>& shown, Ties& ties, double dt, const Periodic& periodic
)
{
    std::unordered_map<std::int64_t, std::int64_t> componentOf;     // by particle
    std::vector<Box> boxes;
    std::vector<Shown*> all;
    std::vector<int> ranks;
    for (int r = 0; r < int(shown.size()); ++r)
    {
        for (Shown& s : shown[std::size_t(r)])
        {
            s.component.home = r;
            components_[s.component.id] = s.component;
            componentOf[s.id] = s.component.id;
            boxes.push_back(s.box);
            all.push_back(&s);
            ranks.push_back(r);
        }
    }
    for (const auto& t : ties) join(componentOf.at(t.first), componentOf.at(t.second));
    BoxGrid(boxes).pairs
    (
        [&](int i, int j)
        {
            if (ranks[std::size_t(i)] == ranks[std::size_t(j)]) return;
            Shown &a = *all[std::size_t(i)], &b = *all[std::size_t(j)];
            if (!meet(a.path, b.path, dt, periodic)) return;
            if (join(a.component.id, b.component.id)) ties.push_back({a.id, b.id});
        }
    );
}


std::int64_t JoinedComponents::root(std::int64_t id) const
{
    for (auto p = parent_.find(id); p != parent_.end(); p = parent_.find(id)) id = p->second;
    return id;
}


//- Returns whether they have been two
bool JoinedComponents::join(std::int64_t a, std::int64_t b)
{
    a = root(a);
    b = root(b);
    if (a == b) return false;
    const std::int64_t low = std::min(a, b), high = std::max(a, b);
    parent_[high] = low;
    Component& to = components_[low];
    to.add(components_[high]);
    to.shared = true;
    return true;
}


const Component* JoinedComponents::find(std::int64_t id) const
{
    const auto found = components_.find(root(id));
    return found != components_.end() && found->second.shared ? &found->second : nullptr;
}


std::vector<Box> IslandExchange::domains(const Box& mine) const
{
    std::vector<double> numbers;
    pack(mine.low, numbers);
    pack(mine.high, numbers);
    std::vector<Box> result;
    for (const auto& d : communicator_.allGather(numbers))
    {
        result.push_back({{d[0], d[1], d[2]}, {d[3], d[4], d[5]}});
    }
    return result;
}


std::vector<std::vector<Shown>> IslandExchange::everybody(const std::vector<Shown>& mine) const
{
    std::vector<double> numbers;
    for (const Shown& s : mine) pack(s, numbers);
    std::vector<std::vector<Shown>> result;
    for (const auto& from : communicator_.allGather(numbers))
    {
        result.push_back(unpackAll<Shown>(from));
    }
    return result;
}


void IslandExchange::shareFastest(std::vector<Component>& components) const
{
    std::map<std::int64_t, double> fastest;
    std::vector<double> mine;
    for (const Component& c : components)
    {
        if (c.shared) mine.insert(mine.end(), {double(c.id), c.speed});
    }
    for (const auto& from : communicator_.allGather(mine))
    {
        for (std::size_t k = 0; k < from.size(); k += 2)
        {
            double& speed = fastest[std::int64_t(from[k])];
            speed = std::max(speed, from[k + 1]);
        }
    }
    for (Component& c : components) if (c.shared) c.speed = fastest[c.id];
}


std::vector<Member> IslandExchange::exchange
(
    const std::vector<std::vector<Member>>& toRank
) const
{
    std::vector<std::vector<double>> numbers(toRank.size());
    for (std::size_t r = 0; r < toRank.size(); ++r)
    {
        for (const Member& m : toRank[r]) pack(m, numbers[r]);
    }
    std::vector<Member> result;
    for (const auto& from : communicator_.exchange(numbers))
    {
        for (Member& m : unpackAll<Member>(from)) result.push_back(std::move(m));
    }
    return result;
}

}
