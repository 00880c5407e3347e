// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/IslandFinder.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

IslandFinder::IslandFinder
(
    const ParticleStore& store, const WallSearch& walls, const Periodic& periodic,
    const Communicator& communicator, bool islands
)
:
    store_(store),
    periodic_(periodic),
    communicator_(communicator),
    reach_(store, walls, periodic),
    exchange_(communicator),
    islands_(islands),
    grid_(boxes_),
    sets_(0)
{}


void IslandFinder::addToCrowd(std::size_t i)
{
    if (crowded_[i]) return;
    crowded_[i] = 1;
    crowd_.push_back(i);
}


void IslandFinder::begin(double dt)
{
    const std::size_t n = store_.size();
    paths_.resize(n);
    boxes_.resize(n);
    crowd_.clear();
    crowded_.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
        Path& p = paths_[i] = reach_.own(i, dt);
        boxes_[i] = reach_.box(i, p, dt);
        if (!store_.awake(i)) continue;
        p.held = reach_.wallWithin(boxes_[i]);
        if (p.held) p.pushedFromStart();
    }
    if (islands_) findPairs(dt);
}


//- Nothing new can come of them
bool IslandFinder::known(std::size_t i, std::size_t j)
{
    return i == j || (paths_[i].hit == 0 && paths_[j].hit == 0 && sets_.together(i, j));
}


void IslandFinder::findPairs(double dt)
{
    const std::size_t n = store_.size();
    grid_.build(periodic_);
    sets_ = DisjointSets(n);
    grid_.pairs([&](int i, int j)
    {
        const std::size_t a = std::size_t(i), b = std::size_t(j);
        if (known(a, b) || !meet(paths_[a], paths_[b], dt, periodic_)) return;
        sets_.join(a, b);
        crowded_[a] = crowded_[b] = 1;
    });
    for (std::size_t i = 0; i < n; ++i)
    {
        crowded_[i] = crowded_[i] || paths_[i].pushed || store_.flies(i);
        if (crowded_[i]) crowd_.push_back(i);
    }
}


bool IslandFinder::settled(double dt)
{
    if (!islands_)
    {
        oneIsland();
        return true;
    }
    label(dt);
    std::vector<std::size_t> wider = widened(dt);
    if (!communicator_.any(!wider.empty())) return true;
    ask(std::move(wider), dt);
    return false;
}


//- A component of one
Component IslandFinder::alone(std::size_t i) const
{
    const Path& p = paths_[i];
    Component c;
    c.id = store_.particles[i].id;
    c.mass = store_.particles[i].mass;
    c.momentum = c.mass*p.own;
    c.active = store_.awake(i);
    c.home = communicator_.rank();
    c.unit = store_.flies(i) ? store_.rest[i].aggregate : c.id;
    c.pushed = p.pushed;
    c.held = p.held;
    return c;
}


//- The components of this rank; returns, for each of the crowd, which is its own
std::vector<std::size_t> IslandFinder::collect()
{
    components_.clear();
    std::vector<std::size_t> componentOf(crowd_.size());
    ofRoot_.resize(std::max(ofRoot_.size(), store_.size()), 0);
    for (std::size_t k = 0; k < crowd_.size(); ++k)
    {
        const std::size_t i = crowd_[k];
        std::size_t& of = ofRoot_[sets_.find(i)];
        const Component one = alone(i);
        if (!of)
        {
            components_.emplace_back();
            of = components_.size();
            components_.back().id = one.id;
            components_.back().home = one.home;
            components_.back().unit = one.unit;
        }
        componentOf[k] = of - 1;
        Component& c = components_[of - 1];
        c.add(one);
        c.id = std::min(c.id, one.id);
        ++c.count;
    }
    for (const std::size_t i : crowd_) ofRoot_[sets_.find(i)] = 0;
    return componentOf;
}


//- Everybody joins the same components in the same way
void IslandFinder::joinOverRanks
(
    const std::vector<std::size_t>& shown, const std::vector<std::size_t>& ofShown, double dt
)
{
    std::vector<Shown> mine;
    for (std::size_t m = 0; m < shown.size(); ++m)
    {
        mine.push_back({boxes_[shown[m]], paths_[shown[m]], components_[ofShown[m]]});
    }
    auto everybody = exchange_.everybody(mine);
    const JoinedComponents joined(everybody, dt, periodic_);
    for (std::size_t m = 0; m < shown.size(); ++m)
    {
        double& hit = paths_[shown[m]].hitNext;
        hit = std::min(hit, everybody[std::size_t(communicator_.rank())][m].path.hitNext);
    }
    for (Component& c : components_)
    {
        if (const Component* all = joined.find(c.id)) c = *all;
    }
}


//- How fast they are beyond the velocity of their component
void IslandFinder::setSpeeds(const std::vector<std::size_t>& componentOf)
{
    for (std::size_t k = 0; k < crowd_.size(); ++k)
    {
        const Particle& particle = store_.particles[crowd_[k]];
        const Path& p = paths_[crowd_[k]];
        Component& c = components_[componentOf[k]];
        // contacts can turn spin into speed
        const double beyond = std::sqrt
        (
            (p.own - c.velocity()).squaredNorm()
          + 0.4*particle.omega.squaredNorm()*particle.radius*particle.radius
        );
        c.speed = std::max(c.speed, beyond + std::max(p.gain, p.least));
    }
    if (communicator_.parallel()) exchange_.shareFastest(components_);
}


//- Label the components of particles that can meet
void IslandFinder::label(double dt)
{
    std::vector<std::size_t> shown;
    if (communicator_.parallel()) shown = exchange_.reachOthers(boxes_);
    for (const std::size_t i : shown) addToCrowd(i);

    const std::vector<std::size_t> componentOf = collect();
    std::size_t largest = 1;
    for (const Component& c : components_) largest = std::max(largest, c.count);
    outside_ = store_.size() - std::min(store_.size(), largest);

    if (communicator_.parallel())
    {
        std::vector<std::size_t> at(store_.size());
        for (std::size_t k = 0; k < crowd_.size(); ++k) at[crowd_[k]] = componentOf[k];
        std::vector<std::size_t> ofShown;
        for (const std::size_t i : shown) ofShown.push_back(at[i]);
        joinOverRanks(shown, ofShown, dt);
    }
    setSpeeds(componentOf);

    labels_.resize(crowd_.size());
    for (std::size_t k = 0; k < crowd_.size(); ++k)
    {
        const Component& c = components_[componentOf[k]];
        labels_[k] = {c.id, {c.velocity(), c.speed}, c.active, c.shared, c.alone(), c.home};
    }
}


//- Those whom others can push farther than they were searched for, made as wide as that
std::vector<std::size_t> IslandFinder::widened(double dt)
{
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < crowd_.size(); ++k)
    {
        const std::size_t i = crowd_[k];
        const Label& of = labels_[k];
        Path& p = paths_[i];
        // in few stages, so that it ends soon
        if (p.hitNext <= dt) p.hit = std::min(p.hit, std::floor(32*p.hitNext/dt)*dt/32);
        if (!of.active || of.alone) continue;
        const Corridor wider = reach_.pushed(i, p, of.crowd, dt);
        const Corridor& c = p.corridor;
        if
        (
            p.joint && c.v == wider.v && c.near >= wider.near && c.from <= wider.from
         && c.away >= wider.away
        ) continue;
        p.joint = true;
        p.corridor = wider;
        boxes_[i] = reach_.box(i, p, dt);
        grid_.changed(int(i));
        p.held = p.held || reach_.wallWithin(boxes_[i]);
        result.push_back(i);
    }
    return result;
}


//- Whom the widened can meet now. Of every pair that is news, one partner is widened, and one
//  is outside the largest set or can be pushed earlier: the fewer of them are asked.
void IslandFinder::ask(std::vector<std::size_t> asked, double dt)
{
    const std::size_t n = store_.size();
    if (outside_ < asked.size())
    {
        std::vector<std::size_t> count(n), others;
        for (std::size_t i = 0; i < n; ++i) ++count[sets_.find(i)];
        const std::size_t largest =
            std::size_t(std::max_element(count.begin(), count.end()) - count.begin());
        for (std::size_t i = 0; i < n && others.size() < asked.size(); ++i)
        {
            if (sets_.find(i) != largest || paths_[i].hit > 0) others.push_back(i);
        }
        if (others.size() < asked.size()) asked.swap(others);
    }
    for (const std::size_t i : asked)
    {
        grid_.overlapping(boxes_[i], [&](int other)
        {
            const std::size_t j = std::size_t(other);
            if (known(i, j) || !meet(paths_[i], paths_[j], dt, periodic_)) return;
            sets_.join(i, j);
            addToCrowd(i);
            addToCrowd(j);
        });
    }
}


//- Everything in one island, on the rank of the lowest id: what a conventional DEM code does
void IslandFinder::oneIsland()
{
    const std::size_t n = store_.size();
    double lowest = 1e300, fastest = 0;
    for (const Particle& p : store_.particles) lowest = std::min(lowest, double(p.id));
    for (const Path& p : paths_)
    {
        fastest = std::max(fastest, p.own.norm() + std::max(p.gain, p.least));
    }
    const double first = -communicator_.max(-lowest);
    const double home = communicator_.max(first == lowest ? communicator_.rank() : -1);
    fastest = communicator_.max(fastest);
    for (std::size_t i = 0; i < n; ++i)
    {
        addToCrowd(i);
        paths_[i].joint = true;
        paths_[i].corridor = reach_.anywhere(i, fastest);
    }
    const Label all
    {
        std::int64_t(first), {Vec3::Zero(), 0}, true, communicator_.parallel(), false, int(home)
    };
    labels_.assign(n, all);
}


void IslandFinder::widen(std::size_t i, double outran)
{
    Path& p = paths_[i];
    p.pushedFromStart();
    p.least = std::max(p.least, outran + (p.corridor.v - p.own).norm());
}

}
