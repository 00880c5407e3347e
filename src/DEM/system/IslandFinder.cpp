// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/IslandFinder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_set>

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
    addedGrid_(addedBoxes_),
    sets_(0)
{}


void IslandFinder::addToCrowd(std::size_t k)
{
    if (crowdAt_[k] >= 0) return;
    crowdAt_[k] = int(crowd_.size());
    crowd_.push_back(k);
    crowdParticles_.push_back(who_[k]);
}


void IslandFinder::begin(double dt)
{
    for (const std::size_t i : who_) slot_[i] = -1;
    slot_.resize(store_.size(), -1);
    who_ = store_.index.awake();
    if (!islands_)
    {
        who_.resize(store_.size());
        std::iota(who_.begin(), who_.end(), std::size_t(0));
    }
    ties_.clear();
    awake_ = who_.size();
    paths_.resize(awake_);
    boxes_.resize(awake_);
    addedBoxes_.clear();
    crowd_.clear();
    crowdParticles_.clear();
    crowdAt_.assign(awake_, -1);
    for (std::size_t k = 0; k < awake_; ++k)
    {
        const std::size_t i = who_[k];
        slot_[i] = int(k);
        Path& p = paths_[k] = reach_.own(i, dt);
        boxes_[k] = reach_.box(i, p, dt);
        if (!store_.awake(i)) continue;
        p.held = reach_.wallWithin(boxes_[k]);
        if (p.held) p.pushedFromStart();
    }
    if (islands_) findPairs(dt);
}


//- Nothing new can come of them
bool IslandFinder::known(std::size_t a, std::size_t b)
{
    return a == b || (paths_[a].hit == 0 && paths_[b].hit == 0 && sets_.together(a, b));
}


void IslandFinder::tie(std::size_t a, std::size_t b)
{
    sets_.join(a, b);
    addToCrowd(a);
    addToCrowd(b);
}


void IslandFinder::consider(std::size_t a, std::size_t b, double dt)
{
    if (!known(a, b) && meet(paths_[a], paths_[b], dt, periodic_)) tie(a, b);
}


//- Particle i, at rest, takes part
std::size_t IslandFinder::add(std::size_t i, const Path& path, double dt)
{
    const std::size_t k = who_.size();
    slot_[i] = int(k);
    who_.push_back(i);
    paths_.push_back(path);
    addedBoxes_.push_back(reach_.box(i, path, dt));
    crowdAt_.push_back(-1);
    sets_.add();
    return k;
}


//- Whom of those at rest k can meet
void IslandFinder::askResting(std::size_t k, double dt)
{
    store_.index.near(box(k), periodic_, [&](std::size_t i)
    {
        if (slot_[i] >= 0)
        {
            consider(k, std::size_t(slot_[i]), dt);
            return;
        }
        Path p = reach_.own(i, dt);
        if (meet(paths_[k], p, dt, periodic_)) tie(k, add(i, p, dt));
    });
}


void IslandFinder::findPairs(double dt)
{
    grid_.build(periodic_);
    sets_ = DisjointSets(awake_);
    grid_.pairs([&](int a, int b) { consider(std::size_t(a), std::size_t(b), dt); });
    for (std::size_t k = 0; k < awake_; ++k) askResting(k, dt);

    // in order
    for (std::size_t k = 0; k < awake_; ++k)
    {
        if (paths_[k].pushed || flies(k)) addToCrowd(k);
    }
    std::sort(crowd_.begin(), crowd_.end());
    for (std::size_t c = 0; c < crowd_.size(); ++c)
    {
        crowdAt_[crowd_[c]] = int(c);
        crowdParticles_[c] = who_[crowd_[c]];
    }
}


bool IslandFinder::settled(double dt)
{
    if (!islands_)
    {
        oneIsland();
        return true;
    }
    while (!label(dt)) {}
    std::vector<std::size_t> wider = widened(dt);
    if (!communicator_.any(!wider.empty())) return true;
    ask(std::move(wider), dt);
    return false;
}


std::vector<std::size_t> IslandFinder::alone() const
{
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < awake_; ++k) if (crowdAt_[k] < 0) result.push_back(who_[k]);
    return result;
}


//- A component of one
Component IslandFinder::single(std::size_t k) const
{
    const std::size_t i = who_[k];
    const Path& p = paths_[k];
    Component c;
    c.id = store_.particles[i].id;
    c.mass = store_.particles[i].mass;
    c.momentum = c.mass*p.own;
    c.active = store_.awake(i);
    c.home = communicator_.rank();
    c.unit = flies(k) ? store_.rest[i].aggregate : c.id;
    c.pushed = p.pushed;
    c.held = p.held;
    return c;
}


//- The components of this rank; returns, for each of the crowd, which is its own
std::vector<std::size_t> IslandFinder::collect()
{
    components_.clear();
    std::vector<std::size_t> componentOf(crowd_.size());
    ofRoot_.resize(std::max(ofRoot_.size(), who_.size()), 0);
    for (std::size_t k = 0; k < crowd_.size(); ++k)
    {
        std::size_t& of = ofRoot_[sets_.find(crowd_[k])];
        const Component one = single(crowd_[k]);
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
    for (const std::size_t k : crowd_) ofRoot_[sets_.find(k)] = 0;
    return componentOf;
}


//- Those whose boxes reach into the box of another rank's particles, or have done so and met
std::vector<std::size_t> IslandFinder::reachingOthers()
{
    Box all = store_.index.around();
    for (std::size_t k = 0; k < who_.size(); ++k) all.include(box(k));
    const std::vector<Box> domains = exchange_.domains(all);
    std::unordered_set<std::int64_t> tied;
    for (const auto& t : ties_) tied.insert({t.first, t.second});
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < who_.size(); ++k)
    {
        bool out = tied.count(store_.particles[who_[k]].id) > 0;
        for (int r = 0; r < communicator_.size() && !out; ++r)
        {
            out = r != communicator_.rank() && box(k).overlaps(domains[std::size_t(r)]);
        }
        if (out) result.push_back(k);
    }
    return result;
}


//- Those at rest on this rank whom one of another rank can meet take part, too
bool IslandFinder::addFor(Path& moving, const Box& box, double dt)
{
    bool any = false;
    store_.index.near(box, periodic_, [&](std::size_t i)
    {
        if (slot_[i] >= 0) return;      // if they meet, it is shown
        Path p = reach_.own(i, dt);
        if (!meet(moving, p, dt, periodic_)) return;
        addToCrowd(add(i, p, dt));
        any = true;
    });
    return any;
}


//- Everybody joins the same components in the same way. False: somebody is added, on some rank.
bool IslandFinder::joinOverRanks
(
    const std::vector<std::size_t>& shown, const std::vector<std::size_t>& ofShown, double dt
)
{
    std::vector<Shown> mine;
    for (std::size_t m = 0; m < shown.size(); ++m)
    {
        const std::size_t k = shown[m];
        mine.push_back
        (
            {store_.particles[who_[k]].id, box(k), paths_[k], components_[ofShown[m]]}
        );
    }
    auto everybody = exchange_.everybody(mine);
    const std::size_t rank = std::size_t(communicator_.rank());
    bool added = false;
    for (std::size_t r = 0; r < everybody.size(); ++r)
    {
        if (r == rank) continue;
        for (Shown& s : everybody[r])
        {
            if (s.path.open) added = addFor(s.path, s.box, dt) || added;
        }
    }
    if (communicator_.any(added)) return false;

    const JoinedComponents joined(everybody, ties_, dt, periodic_);
    for (std::size_t m = 0; m < shown.size(); ++m)
    {
        Path& p = paths_[shown[m]];
        const Path& found = everybody[rank][m].path;
        p.hitNext = std::min(p.hitNext, found.hitNext);
        p.openNext = p.openNext || found.openNext;
    }
    for (Component& c : components_)
    {
        if (const Component* all = joined.find(c.id)) c = *all;
    }
    rimElsewhere_.clear();
    for (std::size_t r = 0; r < everybody.size(); ++r)
    {
        if (r == rank) continue;
        for (const Shown& s : everybody[r])
        {
            if (s.path.open) continue;
            const Component* all = joined.find(s.component.id);
            const Component& of = all ? *all : s.component;
            rimElsewhere_.push_back({s.path, of.id, of.home});
        }
    }
    return true;
}


//- How fast they are beyond the velocity of their component
void IslandFinder::setSpeeds(const std::vector<std::size_t>& componentOf)
{
    for (std::size_t k = 0; k < crowd_.size(); ++k)
    {
        const Particle& particle = store_.particles[crowdParticles_[k]];
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


//- Label the components of particles that can meet. False: to be done again
bool IslandFinder::label(double dt)
{
    std::vector<std::size_t> shown;
    if (communicator_.parallel()) shown = reachingOthers();
    for (const std::size_t k : shown) addToCrowd(k);

    const std::vector<std::size_t> componentOf = collect();
    std::size_t largest = 1;
    for (const Component& c : components_) largest = std::max(largest, c.count);
    outside_ = who_.size() - std::min(who_.size(), largest);

    if (communicator_.parallel())
    {
        std::vector<std::size_t> ofShown;
        for (const std::size_t k : shown)
        {
            ofShown.push_back(componentOf[std::size_t(crowdAt_[k])]);
        }
        if (!joinOverRanks(shown, ofShown, dt)) return false;
    }
    setSpeeds(componentOf);

    labels_.resize(crowd_.size());
    for (std::size_t k = 0; k < crowd_.size(); ++k)
    {
        const Component& c = components_[componentOf[k]];
        labels_[k] = {c.id, {c.velocity(), c.speed}, c.active, c.shared, c.alone(), c.home};
    }
    return true;
}


//- Those whom others can push farther than they were searched for, made as wide as that
std::vector<std::size_t> IslandFinder::widened(double dt)
{
    std::vector<std::size_t> result;
    for (std::size_t c = 0; c < crowd_.size(); ++c)
    {
        const std::size_t k = crowd_[c];
        const Label& of = labels_[c];
        Path& p = paths_[k];
        p.open = p.open || p.openNext;
        if (!p.open) continue;
        // in few stages, so that it ends soon
        if (p.hitNext <= dt) p.hit = std::min(p.hit, std::floor(32*p.hitNext/dt)*dt/32);
        if (!of.active || of.alone) continue;
        const Corridor wider = reach_.pushed(who_[k], p, of.crowd, dt);
        const Corridor& now = p.corridor;
        if
        (
            p.joint && now.v == wider.v && now.near >= wider.near && now.from <= wider.from
         && now.away >= wider.away
        ) continue;
        p.joint = true;
        p.corridor = wider;
        box(k) = reach_.box(who_[k], p, dt);
        if (k < awake_) grid_.changed(int(k));
        p.held = p.held || reach_.wallWithin(box(k));
        result.push_back(k);
    }
    return result;
}


//- Whom the widened can meet now. Of every pair that is news, one partner is widened, and one
//  is outside the largest set or can be pushed earlier: the fewer of them are asked.
void IslandFinder::ask(std::vector<std::size_t> asked, double dt)
{
    addedGrid_.build(periodic_);
    for (const std::size_t k : asked) askResting(k, dt);
    const std::size_t n = who_.size();
    if (outside_ < asked.size())
    {
        std::vector<std::size_t> count(n), others;
        for (std::size_t k = 0; k < n; ++k) ++count[sets_.find(k)];
        const std::size_t largest =
            std::size_t(std::max_element(count.begin(), count.end()) - count.begin());
        for (std::size_t k = 0; k < n && others.size() < asked.size(); ++k)
        {
            if (sets_.find(k) != largest || paths_[k].hit > 0) others.push_back(k);
        }
        if (others.size() < asked.size()) asked.swap(others);
    }
    for (const std::size_t k : asked)
    {
        grid_.overlapping(box(k), [&](int other) { consider(k, std::size_t(other), dt); });
        addedGrid_.overlapping
        (
            box(k), [&](int other) { consider(k, awake_ + std::size_t(other), dt); }
        );
    }
}


std::vector<Seen> IslandFinder::seen() const
{
    std::vector<Seen> result;
    for (std::size_t c = 0; c < crowd_.size(); ++c)
    {
        const Path& p = paths_[crowd_[c]];
        const Label& of = labels_[c];
        if (!p.open) see({p, of.component, of.home}, result);
    }
    for (const Rim& rim : rimElsewhere_) see(rim, result);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}


void IslandFinder::see(const Rim& rim, std::vector<Seen>& result) const
{
    const Vec3& x = rim.path.x;
    const double size = rim.path.size;
    const Box around{x.array() - size, x.array() + size};
    store_.index.near(around, periodic_, [&](std::size_t i)
    {
        const Particle& p = store_.particles[i];
        const double reach = size + p.radius + store_.reach[i];
        if (periodic_.nearest(p.x - x).squaredNorm() > reach*reach) return;
        const int at = slot_[i] < 0 ? -1 : crowdAt_[std::size_t(slot_[i])];
        if (at >= 0 && labels_[std::size_t(at)].component == rim.component) return;
        result.push_back({i, rim.component, rim.home});
    });
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
        paths_[i].joint = paths_[i].open = true;
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
    Path& p = paths_[std::size_t(slot_[i])];
    p.pushedFromStart();
    p.least = std::max(p.least, outran + (p.corridor.v - p.own).norm());
}


void IslandFinder::open(std::size_t i)
{
    Path& p = paths_[std::size_t(slot_[i])];
    p.open = true;
    p.pushedFromStart();
}

}
