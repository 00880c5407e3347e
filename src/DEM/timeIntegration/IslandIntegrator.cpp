// SPDX-License-Identifier: GPL-3.0-or-later
#include "timeIntegration/IslandIntegrator.hpp"

#include "neighbourSearch/DisjointSets.hpp"
#include "particles/errors.hpp"
#include "timeIntegration/RigidAggregate.hpp"
#include "timeIntegration/freeFlight.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dem
{

namespace
{

// Contact steps between two looks at the contact step and at rest
constexpr int stepsBetweenLooks = 4;
constexpr int stepsBetweenLooksDense = 64;

// Above this many candidates and contacts an island is dense: a single event is no longer
// worth a step of its own
constexpr std::size_t denseIsland = 256;

// Steps are graded, and loads foreseen, below this share of the stability bound: both are for
// accuracy, and the bound is that of equal steps
constexpr double refinedShare = 0.4;

// Time over which steps grow to their full length, over the period of the contact
constexpr double gradedShare = 1.0/16;

// Rest criterion (see the header)
constexpr double quietEnergy = 0.1;
constexpr double quietForce = 0.1;
constexpr double quietTorque = 0.02;
constexpr double wakeForce = 0.5;
constexpr double windowPeriods = 3;
constexpr double rockingWindows = 30;

// A stability bound below this share of the period of the contacts is not worth keeping to
constexpr double leastBound = 1e-5;

// Nothing passes through a particle unseen: the most that a pair that does not touch yet
// closes in a step [radii]
constexpr double mostPath = 0.05;

// Contacts that can be so deep before the next look are watched at every step [radii]
constexpr double deepOverlap = 0.85;

// Up to so many particles, all pairs are looked at for candidates
constexpr std::size_t fewParticles = 8;

// With more than so many, candidates are looked for close by, and again for those that get
// farther from the path they have on their own than this [radii]
constexpr std::size_t manyParticles = 32;
constexpr double roaming = 0.3;

// Old and new normals of one wall contact differ by less than 60 degrees
constexpr double sameNormal = 0.5;

Vec3 vec(const double* p) { return {p[0], p[1], p[2]}; }

Vec3 gasForceAtRest(const GasLoad& g) { return g.Sp*g.Uc + g.Su; }

}


IslandIntegrator::IslandIntegrator
(
    const MaterialTable& materials,
    const TimeSettings& time,
    const WallSearch& walls,
    const Periodic& periodic
)
:
    materials_(materials),
    time_(time),
    wallSearch_(walls),
    periodic_(periodic),
    lists_(materials.laws().size())
{
    for (std::size_t l = 0; l < lists_.size(); ++l)
    {
        const ContactLaw& law = *materials_.laws()[l];
        lists_[l].pairs.setUp(law.nConstants(), law.nHistory(), false);
        lists_[l].walls.setUp(law.nConstants(), law.nHistory(), true);
    }
}


void IslandIntegrator::clear()
{
    particles_.clear();
    gas_.clear();
    rest_.clear();
    impulse_.clear();
    reach_.clear();
    stored_.clear();
    roam_.clear();
    candidates_.clear();
    surfaceEnd_.clear();
    surfaces_.clear();
    for (LawLists& l : lists_)
    {
        l.pairs.clear();
        l.walls.clear();
    }
    entries_.clear();
    freeEntries_.clear();

    // by material and wall patch; the walls may have been set since the last island
    const auto& patches = wallSearch_.walls().patches;
    const int nMaterials = int(materials_.materials().size());
    wallTouch_.assign(std::size_t(nMaterials), std::vector<double>(patches.size()));
    for (int m = 0; m < nMaterials; ++m)
    {
        for (std::size_t p = 0; p < patches.size(); ++p)
        {
            wallTouch_[std::size_t(m)][p] = materials_.touchDistance(m, patches[p].material);
        }
    }
}


void IslandIntegrator::addParticle
(
    const Particle& p, const GasLoad& g, const RestState& rest, const Corridor& corridor
)
{
    particles_.push_back(p);
    roam_.push_back({corridor, true});
    gas_.push_back(g);
    rest_.push_back(rest);
    impulse_.push_back(Vec3::Zero());
    reach_.push_back(materials_.reach(p.material, p.radius, wallSearch_.walls()));
    stored_.emplace_back();
    surfaceEnd_.push_back(surfaces_.size());
}


void IslandIntegrator::addSurfaces(const std::vector<int>& surfaces)
{
    surfaces_.insert(surfaces_.end(), surfaces.begin(), surfaces.end());
    surfaceEnd_.back() = surfaces_.size();
}


void IslandIntegrator::addContact(int i, int j, const ContactRecord& record)
{
    stored_[std::size_t(i)].push_back({j, record});
}


std::vector<ContactRecord> IslandIntegrator::contacts(int i) const
{
    std::vector<ContactRecord> result;
    for (const Stored& s : stored_[std::size_t(i)]) result.push_back(s.record);
    return result;
}


// * * * * * * * * * * * * * * * * * Contacts * * * * * * * * * * * * * * * * * * * * * //

void IslandIntegrator::contactConstants
(
    int i, int j, int patch, int materialJ, double* c
) const
{
    const Particle& p = particles_[std::size_t(i)];
    const int mi = p.material;
    ContactScale scale{materials_.constants(mi, materialJ), p.radius, p.mass};
    if (j >= 0)
    {
        const Particle& q = particles_[std::size_t(j)];
        scale.R = p.radius*q.radius/(p.radius + q.radius);
        scale.m = p.mass*q.mass/(p.mass + q.mass);
    }
    else
    {
        scale.rolling = p.radius;
        scale.R = materials_.wallRadius
        (
            mi, materialJ, wallSearch_.walls().curvature(patch), p.radius
        );
    }
    materials_.laws()[std::size_t(materials_.lawIndex(mi, materialJ))]->prepare
    (
        materials_.pairInLaw(mi, materialJ), scale, c
    );
}


void IslandIntegrator::begin
(
    int i, int j, int patch, int candidate, const ContactRecord* record
)
{
    const Particle& p = particles_[std::size_t(i)];
    const bool wall = j < 0;
    const int mj =
        wall
      ? wallSearch_.walls().patches[std::size_t(patch)].material
      : particles_[std::size_t(j)].material;
    const int l = materials_.lawIndex(p.material, mj);
    const ContactLaw& law = *materials_.laws()[std::size_t(l)];
    const PairConstants& pair = materials_.constants(p.material, mj);

    const Body& bi = bodies_[std::size_t(i)];
    Entry e;
    e.boundSpeed = -1;
    e.candidate = candidate;
    e.materialJ = mj;
    if (wall)
    {
        e.R = materials_.wallRadius
        (
            p.material, mj, wallSearch_.walls().curvature(patch), p.radius
        );
        e.m = p.mass;
        e.turning = 0.5*bi.r*bi.invI;
    }
    else
    {
        const Particle& q = particles_[std::size_t(j)];
        e.R = p.radius*q.radius/(p.radius + q.radius);
        e.m = p.mass*q.mass/(p.mass + q.mass);
        const Body& bj = bodies_[std::size_t(j)];
        e.turning = 0.5*(bi.r*bi.invI + bj.r*bj.invI);
        candidates_[std::size_t(candidate)].touching = true;
    }
    const int pairInLaw = materials_.pairInLaw(p.material, mj);
    double constants[maxConstants];
    contactConstants(i, j, patch, mj, constants);
    e.neck = law.reach(pairInLaw, pair, e.R);
    // dashpots begin with the spot, which a neck keeps to its end
    e.edge = law.touchDistance(pairInLaw, pair) > 0 ? 0 : -e.neck;
    e.pullOff = law.pullOff(pairInLaw, pair, e.R);
    e.a0 = law.equilibriumRadius(pairInLaw, pair, e.R);
    e.yield = law.rollingYield(constants, wall ? p.radius : e.R);

    int tag;
    if (freeEntries_.empty())
    {
        tag = int(entries_.size());
        entries_.push_back(e);
    }
    else
    {
        tag = freeEntries_.back();
        freeEntries_.pop_back();
        entries_[std::size_t(tag)] = e;
    }

    ContactList& list =
        wall ? lists_[std::size_t(l)].walls : lists_[std::size_t(l)].pairs;
    list.append(i, wall ? patch : j, tag, constants, record ? record->history : nullptr);
    if (wall && record)
    {
        list.nx.back() = record->n[0];
        list.ny.back() = record->n[1];
        list.nz.back() = record->n[2];
    }
}


void IslandIntegrator::remove(ContactList& list, std::size_t k)
{
    const int tag = list.tag[k];
    const int candidate = entries_[std::size_t(tag)].candidate;
    if (candidate >= 0)
    {
        candidates_[std::size_t(candidate)].touching = false;
        near_.push_back({candidate, path_});
    }
    freeEntries_.push_back(tag);
    list.swap(k, list.size() - 1);
    list.popBack();
}


void IslandIntegrator::store(const ContactList& list, std::size_t k, bool wall)
{
    Stored s;
    s.j = wall ? -1 : list.j[k];
    s.record.idJ = wall ? -1 : particles_[std::size_t(s.j)].id;
    s.record.wall = wall ? list.j[k] : -1;
    for (double& n : s.record.n) n = 0;
    for (double& h : s.record.history) h = 0;
    if (wall)
    {
        s.record.n[0] = list.nx[k];
        s.record.n[1] = list.ny[k];
        s.record.n[2] = list.nz[k];
    }
    for (std::size_t h = 0; h < list.history.size(); ++h)
    {
        s.record.history[h] = list.history[h][k];
    }
    stored_[std::size_t(list.i[k])].push_back(s);
    frozenKnown_[std::size_t(list.i[k])] = 0;
    if (!wall)
    {
        holders_[std::size_t(s.j)].push_back(list.i[k]);
        frozenKnown_[std::size_t(s.j)] = 0;
    }
}


//- Who can touch whom within dt
void IslandIntegrator::findCandidates(double dt)
{
    const std::size_t n = particles_.size();
    const bool many = n > manyParticles;
    boxes_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        const Particle& p = particles_[i];
        const double margin = roaming*p.radius;
        Roam& roam = roam_[i];
        const Vec3 end = p.x + dt*roam.corridor.v;
        const double width = roam.corridor.width(dt);
        Vec3 low = p.x.cwiseMin(end), high = p.x.cwiseMax(end);
        roam.all = !many || width + (high - low).maxCoeff() <= margin;
        if (!roam.all)
        {
            low = high = p.x;
            if (!rest_[i].resting) flightBox(p, gas_[i], dt, low, high);
        }
        const double half = p.radius + reach_[i] + (roam.all ? width : margin);
        boxes_[i] = {low.array() - half, high.array() + half};
    }

    due_.clear();
    grid_.reset();
    if (n <= fewParticles)
    {
        for (std::size_t i = 0; i < n; ++i)
        {
            for (std::size_t j = i + 1; j < n; ++j)
            {
                const Box &a = boxes_[i], &b = boxes_[j];
                const Vec3 twice = periodic_.nearest(0.5*(b.low + b.high - a.low - a.high))*2;
                const Vec3 widths = a.high - a.low + b.high - b.low;
                if ((twice.array().abs() <= widths.array()).all()) addCandidate(int(i), int(j));
            }
        }
    }
    else
    {
        grid_ = std::make_unique<BoxGrid>(boxes_, periodic_);
        std::vector<std::vector<int>> partners(n);
        grid_->pairs([&](int i, int j) { partners[std::size_t(i)].push_back(j); });
        for (std::size_t i = 0; i < n; ++i)
        {
            std::vector<int>& of = partners[i];
            std::sort(of.begin(), of.end());
            if (periodic_.on()) of.erase(std::unique(of.begin(), of.end()), of.end());
            for (const int j : of) addCandidate(int(i), j);
        }
    }
    sorted_ = candidates_.size();
}


void IslandIntegrator::addCandidate(int i, int j)
{
    const int mi = particles_[std::size_t(i)].material;
    const int mj = particles_[std::size_t(j)].material;
    candidates_.push_back({i, j, false, materials_.touchDistance(mi, mj)});
    due_.push_back(0);
}


//- Look for more candidates of those that leave their boxes in a flight over `time`
void IslandIntegrator::keepInBoxes(double time)
{
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        if (roam_[k].all) continue;
        const Body& b = bodies_[k];
        const double half = b.r + reach_[k] + 0.5*skin_;
        Box path{vec(b.x), vec(b.x)};
        const auto fly = [&](double t)
        {
            Particle p = particles_[k];
            p.x = vec(b.x);
            p.v = vec(b.v);
            flightBox(p, gas_[k], t, path.low, path.high);
        };
        const auto around = [](const Box& box, double by)
        {
            return Box{box.low.array() - by, box.high.array() + by};
        };
        if (time > 0) fly(time);
        if (boxes_[k].contains(around(path, half))) continue;
        // as far, at least, as it flies in the time of a radius
        const double speed = vec(b.v).norm();
        fly(std::max(time, std::min(left_, b.r/std::max(speed, 1e-300))));
        widen(i, around(path, b.r + reach_[k] + roaming*b.r));
    }
}


//- Let particle i go along `path`, its surface included
void IslandIntegrator::widen(int i, const Box& path)
{
    const std::size_t k = std::size_t(i);
    Box& box = boxes_[k];
    box.include(path);
    grid_->changed(i);

    static thread_local std::vector<int> known, found;
    known.assign(1, i);
    found.clear();
    for (const Candidate& c : candidates_)
    {
        if (c.i == i) known.push_back(c.j);
        if (c.j == i) known.push_back(c.i);
    }
    std::sort(known.begin(), known.end());
    grid_->overlapping(box, [&](int j)
    {
        if (!std::binary_search(known.begin(), known.end(), j)) found.push_back(j);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const int j : found) addCandidate(std::min(i, j), std::max(i, j));
}


//- A stored contact is always among the candidates
int IslandIntegrator::findCandidate(int i, int j) const
{
    const auto end = candidates_.begin() + std::ptrdiff_t(sorted_);
    auto found = std::lower_bound
    (
        candidates_.begin(), end, Candidate{i, j, false, 0},
        [](const Candidate& a, const Candidate& b)
        {
            return a.i < b.i || (a.i == b.i && a.j < b.j);
        }
    );
    if (found == end || found->i != i || found->j != j)
    {
        found = std::find_if
        (
            end, candidates_.end(),
            [&](const Candidate& c) { return c.i == i && c.j == j; }
        );
    }
    if (found == candidates_.end())
    {
        fail("is farther than its law reaches", i, j, 0);
    }
    return int(found - candidates_.begin());
}


//- Put the stored contacts of particle i that are not between two at rest into the lists
void IslandIntegrator::activateStored(std::size_t i)
{
    std::size_t kept = 0;
    for (std::size_t s = 0; s < stored_[i].size(); ++s)
    {
        const Stored c = stored_[i][s];
        if (rest_[i].resting && (c.j < 0 || rest_[std::size_t(c.j)].resting))
        {
            stored_[i][kept++] = c;
            continue;
        }
        frozenKnown_[i] = 0;
        if (c.j >= 0)
        {
            auto& holders = holders_[std::size_t(c.j)];
            holders.erase(std::remove(holders.begin(), holders.end(), int(i)), holders.end());
            frozenKnown_[std::size_t(c.j)] = 0;
        }
        begin
        (
            int(i), c.j, c.record.wall, c.j >= 0 ? findCandidate(int(i), c.j) : -1,
            &c.record
        );
    }
    stored_[i].resize(kept);
}


void IslandIntegrator::activateStored()
{
    for (std::size_t i = 0; i < stored_.size(); ++i) activateStored(i);
}


//- End the contacts that evaluate() has marked; their load is taken back
bool IslandIntegrator::endMarked(StepReport& report)
{
    if (!ended_) return false;
    ended_ = false;
    if (exactEvents_) complete();
    bool any = false;
    std::vector<int> alone;     // at rest, with one contact less
    for (std::size_t l = 0; l < lists_.size(); ++l)
    {
        const ContactLaw& law = *materials_.laws()[l];
        for (const bool wall : {false, true})
        {
            ContactList& list = wall ? lists_[l].walls : lists_[l].pairs;
            for (std::size_t k = list.size(); k-- > 0;)
            {
                if (!list.ended[k]) continue;
                if (time_.energyLedger)
                {
                    const ContactEnergy e = energyOf(l, list, k);
                    report.energy.normal -= e.normal.stored;
                    report.energy.springs -= e.inSprings();
                    report.energy.released += e.normal.stored + e.inSprings();
                }
                if (wall)
                {
                    law.evaluateWalls
                    (
                        list, k, k + 1, bodies_.data(), loads_.data(), {0, -ahead_, 0}, -1
                    );
                }
                else
                {
                    law.evaluatePairs
                    (
                        list, k, k + 1, bodies_.data(), loads_.data(), {0, -ahead_, 0}, -1,
                        periodic_
                    );
                }
                const int partners[2] = {list.i[k], wall ? -1 : list.j[k]};
                remove(list, k);
                ++report.separations;
                any = true;
                for (const int p : partners)
                {
                    if (p >= 0 && rest_[std::size_t(p)].resting) alone.push_back(p);
                }
            }
        }
    }
    if (!alone.empty()) wake(alone, report);
    else if (any) findBoundary();
    return any;
}


//- Whether particle i, which meets a wall in the direction n, came there with the gas:
//  neither did its inertia carry it (it would stop within its radius) nor a force
bool IslandIntegrator::follows(const int i, const Vec3& n) const
{
    const Body& b = bodies_[std::size_t(i)];
    const GasLoad& g = gas_[std::size_t(i)];
    const double speed = vec(b.v).dot(n);
    return
        speed < particles_[std::size_t(i)].radius*g.Sp*b.invM
     && g.Su.dot(n) <= 0.5*g.Sp*speed;
}


//- Begin contacts where surfaces have met; their load is added
bool IslandIntegrator::form(StepReport& report)
{
    struct Sizes { std::size_t pairs, walls; };
    static thread_local std::vector<Sizes> before;
    before.clear();
    for (const LawLists& l : lists_) before.push_back({l.pairs.size(), l.walls.size()});

    bool any = false;
    const auto touches = [&](const Vec3& v, const Vec3& n)
    {
        const double speed = v.dot(n);
        ++report.touches;
        report.touchSpeed += speed;
        report.touchSpeedSquare += speed*speed;
    };
    for (Near& near : near_)
    {
        if (near.due > path_) continue;
        const Candidate& pair = candidates_[std::size_t(near.candidate)];
        if (pair.touching) continue;
        if (!meets(pair))
        {
            near.due = path_ + 0.5*gap(pair);
            continue;
        }
        if (exactEvents_) complete();
        begin(pair.i, pair.j, -1, near.candidate, nullptr);
        const Body& a = bodies_[std::size_t(pair.i)];
        const Body& b = bodies_[std::size_t(pair.j)];
        touches(vec(a.v) - vec(b.v), periodic_.nearest(vec(b.x) - vec(a.x)).normalized());
        any = true;
    }

    for (const int i : nearWalls_)
    {
        const auto& hits = hits_[std::size_t(i)];
        for (std::size_t k = 0; k < hits.size(); ++k)
        {
            const double r = particles_[std::size_t(i)].radius;
            if (hitTaken_[std::size_t(i)][k] || hits[k].distance > r + wallTouch(i, hits[k].patch))
            {
                continue;
            }
            if (exactEvents_) complete();
            begin(i, -1, hits[k].patch, -1, nullptr);
            const int law = materials_.lawIndex
            (
                particles_[std::size_t(i)].material,
                wallSearch_.walls().patches[std::size_t(hits[k].patch)].material
            );
            ContactList& list = lists_[std::size_t(law)].walls;
            list.nx.back() = hits[k].n.x();
            list.ny.back() = hits[k].n.y();
            list.nz.back() = hits[k].n.z();
            list.overlap.back() = r - hits[k].distance;
            hitTaken_[std::size_t(i)][k] = 1;
            touches(vec(bodies_[std::size_t(i)].v), hits[k].n);
            report.followerTouches += follows(i, hits[k].n);
            any = true;
        }
    }

    if (any)
    {
        findBoundary();
        for (std::size_t l = 0; l < lists_.size(); ++l)
        {
            const ContactLaw& law = *materials_.laws()[l];
            law.evaluatePairs
            (
                lists_[l].pairs, before[l].pairs, lists_[l].pairs.size(),
                bodies_.data(), loads_.data(), {0, 0, ahead_}, 1, periodic_
            );
            law.evaluateWalls
            (
                lists_[l].walls, before[l].walls, lists_[l].walls.size(),
                bodies_.data(), loads_.data(), {0, 0, ahead_}, 1
            );
            if (!time_.energyLedger) continue;
            for (std::size_t k = before[l].pairs; k < lists_[l].pairs.size(); ++k)
            {
                report.energy.normal += energyOf(l, lists_[l].pairs, k).normal.stored;
            }
            for (std::size_t k = before[l].walls; k < lists_[l].walls.size(); ++k)
            {
                report.energy.normal += energyOf(l, lists_[l].walls, k).normal.stored;
            }
        }
    }
    return any;
}


//- Loads are as they were: what the frozen contacts gave, they go on giving
void IslandIntegrator::wake(std::vector<int>& woken, StepReport& report)
{
    complete();
    std::sort(woken.begin(), woken.end());
    woken.erase(std::unique(woken.begin(), woken.end()), woken.end());
    for (const int i : woken)
    {
        RestState& rest = rest_[std::size_t(i)];
        rests(std::size_t(i), -elapsed_);
        rest.resting = false;
        rest.quietTime = 0;
        marked_[std::size_t(i)] = 1;
    }
    report.wakes += std::int64_t(woken.size());
    const std::size_t before = awake_.size();
    awake_.insert(awake_.end(), woken.begin(), woken.end());
    std::inplace_merge
    (
        awake_.begin(), awake_.begin() + std::ptrdiff_t(before), awake_.end()
    );
    flightStep_ = -1;

    static thread_local std::vector<int> holders;
    for (const int i : woken)
    {
        const std::size_t k = std::size_t(i);
        activateStored(k);
        holders.swap(holders_[k]);
        for (const int h : holders) activateStored(std::size_t(h));
        holders.clear();
        findNearSurfaces(i);
    }
    std::sort(nearWalls_.begin(), nearWalls_.end());
    for (std::size_t c = 0; c < candidates_.size(); ++c)
    {
        const Candidate& k = candidates_[c];
        const char i = marked_[std::size_t(k.i)], j = marked_[std::size_t(k.j)];
        if (!(i | j) || k.touching) continue;
        // with a partner that was awake before, it is there already
        const bool both = i && j;
        if (!both && !rest_[std::size_t(i ? k.j : k.i)].resting) continue;
        if (comesNear(int(c))) near_.push_back({int(c), due_[c]});
    }
    for (const int i : woken) marked_[std::size_t(i)] = 0;
    findBoundary();
    updateWalls();
}


//- Wake those at the boundary that are loaded too much
void IslandIntegrator::wakeLoaded(StepReport& report)
{
    woken_.clear();
    for (const int i : boundary_)
    {
        const std::size_t k = std::size_t(i);
        const double limit = time_.restTolerance*wakeForce*rest_[k].pullOff;
        const double r = bodies_[k].r;
        if
        (
            (vec(loads_[k].f) + gasForceAtRest(gas_[k])).squaredNorm() > limit*limit
         || vec(loads_[k].t).squaredNorm() > limit*limit*r*r
        ) woken_.push_back(i);
    }
    if (!woken_.empty()) wake(woken_, report);
}


//- Resting particles that share a contact with an awake one, and what rests on them
void IslandIntegrator::findBoundary()
{
    boundary_.clear();
    if (awake_.size() == particles_.size()) return;
    const auto look = [&](int i)
    {
        const std::size_t k = std::size_t(i);
        if (!rest_[k].resting || marked_[k]) return;
        marked_[k] = 1;
        boundary_.push_back(i);
        if (frozenKnown_[k]) return;
        frozen_[k] = storedLoad(i);
        frozenKnown_[k] = 1;
    };
    for (const LawLists& l : lists_)
    {
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            look(l.pairs.i[k]);
            look(l.pairs.j[k]);
        }
    }
    for (const int i : boundary_) marked_[std::size_t(i)] = 0;
}


//- Sum of the loads of the stored contacts of particle i
Load IslandIntegrator::storedLoad(int i)
{
    Load sum{};
    const auto add = [&](int lower, const Stored& s)
    {
        const bool wall = s.j < 0;
        const Particle& p = particles_[std::size_t(lower)];
        const int mj =
            wall
          ? wallSearch_.walls().patches[std::size_t(s.record.wall)].material
          : particles_[std::size_t(s.j)].material;
        const ContactLaw& law =
            *materials_.laws()[std::size_t(materials_.lawIndex(p.material, mj))];
        double c[maxConstants];
        contactConstants(lower, s.j, s.record.wall, mj, c);

        scratch_.setUp(law.nConstants(), law.nHistory(), wall);
        scratch_.append(0, wall ? s.record.wall : 1, 0, c, s.record.history);
        const Body bodies[2] =
        {
            bodies_[std::size_t(lower)], bodies_[std::size_t(wall ? lower : s.j)]
        };
        Load loads[2] = {};
        if (wall)
        {
            const Vec3 old = vec(s.record.n);
            std::vector<WallHit> hits;
            const std::size_t k = std::size_t(lower);
            const std::size_t first = k ? surfaceEnd_[k - 1] : 0;
            wallSearch_.hits
            (
                vec(bodies[0].x), bodies[0].r + reach_[k], surfaces_.data() + first,
                surfaceEnd_[k] - first, hits
            );
            double best = sameNormal;
            for (const WallHit& h : hits)
            {
                const double alike = h.n.dot(old);
                if (h.patch != s.record.wall || alike < best) continue;
                best = alike;
                scratch_.nx[0] = h.n[0];
                scratch_.ny[0] = h.n[1];
                scratch_.nz[0] = h.n[2];
                scratch_.overlap[0] = bodies[0].r - h.distance;
            }
            law.evaluateWalls(scratch_, 0, 1, bodies, loads, {}, 1);
        }
        else
        {
            law.evaluatePairs(scratch_, 0, 1, bodies, loads, {}, 1, periodic_);
        }
        const Load& mine = loads[lower == i ? 0 : 1];
        for (int d = 0; d < 3; ++d)
        {
            sum.f[d] += mine.f[d];
            sum.t[d] += mine.t[d];
        }
    };

    for (const Stored& s : stored_[std::size_t(i)]) add(i, s);
    for (const int h : holders_[std::size_t(i)])
    {
        for (const Stored& s : stored_[std::size_t(h)])
        {
            if (s.j == i) add(h, s);
        }
    }
    return sum;
}


// * * * * * * * * * * * * * * * * * Geometry * * * * * * * * * * * * * * * * * * * * * //

double IslandIntegrator::gap(const Candidate& c) const
{
    const Body& a = bodies_[std::size_t(c.i)];
    const Body& b = bodies_[std::size_t(c.j)];
    return periodic_.nearest(vec(b.x) - vec(a.x)).norm() - a.r - b.r - c.touch;
}


//- Whether the surfaces are where their contact begins
bool IslandIntegrator::meets(const Candidate& c) const
{
    const Body& a = bodies_[std::size_t(c.i)];
    const Body& b = bodies_[std::size_t(c.j)];
    const double sum = a.r + b.r + c.touch;
    return periodic_.nearest(vec(b.x) - vec(a.x)).squaredNorm() <= sum*sum;
}


//- Whether a pair is within the skin. Two particles close no more than twice the path of the
//  fastest, so most need not be looked at.
bool IslandIntegrator::comesNear(int candidate)
{
    double& due = due_[std::size_t(candidate)];
    const double horizon = path_ + 0.5*skin_;
    if (due <= horizon) due = path_ + 0.5*gap(candidates_[std::size_t(candidate)]);
    return due <= horizon;
}


double IslandIntegrator::wallTouch(int i, int patch) const
{
    return
        wallTouch_[std::size_t(particles_[std::size_t(i)].material)][std::size_t(patch)];
}


//- |dv/dt| of free flight can only fall from here on
double IslandIntegrator::accelerationBound(int i) const
{
    const std::size_t k = std::size_t(i);
    if (rest_[k].resting) return 0;
    const GasLoad& g = gas_[k];
    return
        (g.Sp*(g.Uc - vec(bodies_[k].v)) + g.Su).norm()*bodies_[k].invM;
}


bool IslandIntegrator::anyContact() const
{
    for (const LawLists& l : lists_)
    {
        if (l.pairs.size() || l.walls.size()) return true;
    }
    return false;
}


//- particles_ are where the bodies and their points began
void IslandIntegrator::noteOutran()
{
    if (elapsed_ <= 0) return;
    for (std::size_t k = 0; k < bodies_.size(); ++k)
    {
        const Corridor& c = roam_[k].corridor;
        const double off = (vec(bodies_[k].x) - particles_[k].x - elapsed_*c.v).norm();
        if (off > c.width(elapsed_)) outran_[k] = std::max(outran_[k], off/elapsed_);
    }
}


void IslandIntegrator::refreshNear()
{
    noteOutran();
    // enough for some steps, as fast as they are now
    skin_ = 0.2*smallest_;
    if (contactStep_ > 0)
    {
        skin_ = std::min(skin_, std::max(200*fastest_*contactStep_, 1e-3*smallest_));
    }
    refreshed_ = path_;
    keepInBoxes(0);
    near_.clear();
    for (std::size_t c = 0; c < candidates_.size(); ++c)
    {
        if (due_[c] > path_ + 0.5*skin_) continue;
        const Candidate& k = candidates_[c];
        if (k.touching) continue;
        if (rest_[std::size_t(k.i)].resting && rest_[std::size_t(k.j)].resting) continue;
        if (comesNear(int(c))) near_.push_back({int(c), due_[c]});
    }

    nearWalls_.clear();
    nearSurfaces_.resize(particles_.size());
    hits_.resize(particles_.size());
    hitTaken_.resize(particles_.size());
    for (const int i : awake_) findNearSurfaces(i);
    updateWalls();
}


//- Wall surfaces within the skin of an awake particle
void IslandIntegrator::findNearSurfaces(int i)
{
    const std::size_t k = std::size_t(i);
    nearSurfaces_[k].clear();
    hits_[k].clear();
    const double range = particles_[k].radius + reach_[k] + skin_;
    for (std::size_t s = k ? surfaceEnd_[k - 1] : 0; s < surfaceEnd_[k]; ++s)
    {
        if (wallSearch_.within(surfaces_[s], vec(bodies_[k].x), range))
        {
            nearSurfaces_[k].push_back(surfaces_[s]);
        }
    }
    if (!nearSurfaces_[k].empty()) nearWalls_.push_back(i);
}


//- Find where the awake particles meet the walls now and give that to their contacts
void IslandIntegrator::updateWalls()
{
    bool any = false;
    for (const int i : nearWalls_)
    {
        const std::size_t k = std::size_t(i);
        wallSearch_.hits
        (
            vec(bodies_[k].x), particles_[k].radius + reach_[k] + 0.5*skin_,
            nearSurfaces_[k].data(), nearSurfaces_[k].size(), hits_[k]
        );
        hitTaken_[k].assign(hits_[k].size(), 0);
        any = any || !hits_[k].empty();
    }

    for (LawLists& l : lists_)
    {
        ContactList& list = l.walls;
        for (std::size_t k = 0; k < list.size(); ++k)
        {
            const std::size_t i = std::size_t(list.i[k]);
            const Vec3 old(list.nx[k], list.ny[k], list.nz[k]);
            int best = -1;
            double alike = sameNormal;
            for (std::size_t c = 0; any && c < hits_[i].size(); ++c)
            {
                const double cosine = old.dot(hits_[i][c].n);
                if
                (
                    !hitTaken_[i][c] && hits_[i][c].patch == list.j[k]
                 && cosine > alike
                )
                {
                    alike = cosine;
                    best = int(c);
                }
            }
            const double r = particles_[i].radius;
            if (best < 0)
            {
                // nothing of this wall is within reach any more
                const Entry& e = entries_[std::size_t(list.tag[k])];
                list.overlap[k] = -(1 + 1e-6)*e.neck - 1e-9*r;
                continue;
            }
            const WallHit& hit = hits_[i][std::size_t(best)];
            hitTaken_[i][std::size_t(best)] = 1;
            list.nx[k] = hit.n.x();
            list.ny[k] = hit.n.y();
            list.nz[k] = hit.n.z();
            list.overlap[k] = r - hit.distance;
        }
    }
}


// * * * * * * * * * * * * * * * * * Stepping * * * * * * * * * * * * * * * * * * * * * //

void IslandIntegrator::setFlight(double h)
{
    if (h == flightStep_) return;
    flightStep_ = h;
    flight_.resize(particles_.size());
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        const GasLoad& g = gas_[k];
        const FlightFactors f(g.Sp*bodies_[k].invM, h);
        const Vec3 b = (g.Sp*g.Uc + g.Su)*bodies_[k].invM;
        const FlightFactors spin(g.SpOmega*bodies_[k].invI, h);
        const Vec3 driven = f.p1*b, drivenSpin = (1 - spin.e)*g.omegaC;
        flight_[k] =
        {
            f.e, f.p1, f.p2, f.p1 - f.p2/h, f.p2/h,
            spin.e, spin.p1 - spin.p2/h, spin.p2/h,
            {b[0], b[1], b[2]}, {driven[0], driven[1], driven[2]},
            {drivenSpin[0], drivenSpin[1], drivenSpin[2]}
        };
    }
}


//- Add the loads of all contacts; loads_ holds what else there is
bool IslandIntegrator::evaluate(const SpringStep& step, StepReport& report)
{
    for (const int i : boundary_) loads_[std::size_t(i)] = frozen_[std::size_t(i)];
    bool ended = false;
    for (std::size_t l = 0; l < lists_.size(); ++l)
    {
        const ContactLaw& law = *materials_.laws()[l];
        LawLists& lists = lists_[l];
        const std::size_t nPairs = lists.pairs.size(), nWalls = lists.walls.size();
        if (nPairs)
        {
            ended |= law.evaluatePairs
            (
                lists.pairs, 0, nPairs, bodies_.data(), loads_.data(), step, 1, periodic_
            );
        }
        if (nWalls)
        {
            ended |= law.evaluateWalls
            (
                lists.walls, 0, nWalls, bodies_.data(), loads_.data(), step, 1
            );
        }
        report.contactUpdates += std::int64_t(nPairs + nWalls);
    }
    return ended;
}


//- What is owed of the last kick, the first kick of a step of h, and the flight over it;
//  loads become zero. Returns the largest |v|^2.
template<bool gas>
double IslandIntegrator::drift(double h)
{
    if constexpr (gas)
    {
        complete();
        setFlight(h);
    }
    // velocity and spin side by side, as Load, Motion and Body have them
    typedef double Quad __attribute__((vector_size(32), may_alias));
    typedef double Octet __attribute__((vector_size(64), may_alias));
    typedef double LooseOctet __attribute__((vector_size(64), may_alias, aligned(32)));
    // not by value, which without AVX has another ABI
    const auto velocity = [](const Octet& o, Quad& v)
    {
        v = __builtin_shufflevector(o, o, 0, 1, 2, 3);
        v[3] = 0;
    };
    const double kick = 0.5*(owed_ + h), half = 0.5*h;
    double fastest = 0;
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        Body& b = bodies_[k];
        Load& l = loads_[k];
        Motion& m = motion_[k];
        double square;
        if constexpr (gas)
        {
            const Flight& f = flight_[k];
            const Octet before = reinterpret_cast<LooseOctet&>(b.v);
            // 1/m and 1/I, which are the fourths; those of Load are zero
            const Octet perLoad =
                __builtin_shufflevector(before, before, 3, 3, 3, 3, 7, 7, 7, 7);
            const Octet change = perLoad*reinterpret_cast<Octet&>(l);
            const Octet kept{f.e, f.e, f.e, 1, f.eSpin, f.eSpin, f.eSpin, 1};
            const Octet early
            {
                f.early, f.early, f.early, 0, f.earlySpin, f.earlySpin, f.earlySpin, 0
            };
            const Octet late{f.late, f.late, f.late, 0, f.lateSpin, f.lateSpin, f.lateSpin, 0};
            const Octet driven
            {
                f.driven[0], f.driven[1], f.driven[2], 0,
                f.drivenSpin[0], f.drivenSpin[1], f.drivenSpin[2], 0
            };
            const Octet kicked = kept*before + driven + early*change;
            reinterpret_cast<Octet&>(m) = kicked;
            const Octet after = kicked + late*change;
            reinterpret_cast<LooseOctet&>(b.v) = after;
            Quad v, a, u, predicted;
            velocity(before, v);
            velocity(change, a);
            velocity(kicked, u);
            velocity(after, predicted);
            const Quad b4{f.b[0], f.b[1], f.b[2], 0};
            reinterpret_cast<Quad&>(b.x) += f.p1*v + f.p2*(b4 + a);
            const Quad given = mass(k)*(u - v) - 0.5*h*reinterpret_cast<Quad&>(l.f);
            for (int d = 0; d < 3; ++d) impulse_[k][d] += given[d];
            const Quad squares = v*v, later = predicted*predicted;
            square = 0;
            for (int d = 0; d < 3; ++d) square += std::max(squares[d], later[d]);
        }
        else
        {
            Octet moving = reinterpret_cast<Octet&>(m);
            const Octet perLoad =
                __builtin_shufflevector(moving, moving, 3, 3, 3, 3, 7, 7, 7, 7);
            const Octet change = perLoad*reinterpret_cast<Octet&>(l);
            moving += kick*change;
            reinterpret_cast<Octet&>(m) = moving;
            reinterpret_cast<LooseOctet&>(b.v) = moving + half*change;
            Quad v;
            velocity(moving, v);
            reinterpret_cast<Quad&>(b.x) += h*v;
            square = v[0]*v[0] + v[1]*v[1] + v[2]*v[2];
        }
        l = Load{};
        fastest = std::max(fastest, square);
    }
    owed_ = 0;
    return fastest;
}


//- Of the second kick of a step of h, for which the flight is set
IslandIntegrator::Push IslandIntegrator::pushOf(std::size_t k, double h) const
{
    const Body& b = bodies_[k];
    if (vacuum_) return {0.5*h*b.invM, 0.5*h*b.invI};
    return {flight_[k].late*b.invM, flight_[k].lateSpin*b.invI};
}


//- Add half of the coming change of the loads to the predicted velocities
void IslandIntegrator::foresee(double h)
{
    if (previousStep_ > 0)
    {
        const double share = 0.5*h/previousStep_;
        for (const int i : awake_)
        {
            const std::size_t k = std::size_t(i);
            Body& b = bodies_[k];
            const Push push = pushOf(k, h);
            for (int d = 0; d < 3; ++d)
            {
                b.v[d] += share*push.v*(lastLoads_[k].f[d] - previousLoads_[k].f[d]);
                b.w[d] += share*push.w*(lastLoads_[k].t[d] - previousLoads_[k].t[d]);
            }
        }
    }
    previousLoads_.swap(lastLoads_);
    previousStep_ = h;
}


//- One step of h but for its second kick, after which one of `next` is expected
void IslandIntegrator::step(double h, double next, StepReport& report)
{
    prepareSprings(h);
    if (time_.energyLedger)
    {
        complete();
        openLedger(h, report.energy);
    }
    if (refined_) lastLoads_ = loads_;
    const double fastest = vacuum_ ? drift<false>(h) : drift<true>(h);
    if (time_.energyLedger) report.energy.gas += kinetic(motion_);
    fastest_ = std::sqrt(fastest);
    path_ += fastest_*h;
    elapsed_ += h;
    if (2*(path_ - refreshed_) > 0.5*skin_) refreshNear();
    else updateWalls();
    if (refined_) foresee(h);
    const double ahead = springLead_*next;
    ended_ = evaluate({h, h - ahead_, ahead}, report);
    ahead_ = ahead;
    owed_ = h;
    if (time_.energyLedger)
    {
        complete();
        closeLedger(h, report.energy);
        if (anyContact())
        {
            report.maxStepOverBound = std::max(report.maxStepOverBound, h/boundNow());
        }
    }
}


//- The second kick of the last step: velocities are those at the end of the step
void IslandIntegrator::complete()
{
    if (owed_ == 0) return;
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        Body& b = bodies_[k];
        const Load& l = loads_[k];
        Motion& m = motion_[k];
        const Push push = pushOf(k, owed_);
        for (int d = 0; d < 3; ++d)
        {
            b.v[d] = m.v[d] += push.v*l.f[d];
            b.w[d] = m.w[d] += push.w*l.t[d];
        }
        if (vacuum_) continue;
        // what the gas has taken of the kick
        for (int d = 0; d < 3; ++d) impulse_[k][d] += (push.v*mass(k) - 0.5*owed_)*l.f[d];
    }
    owed_ = 0;
}


double IslandIntegrator::inertia(std::size_t i) const
{
    const Particle& p = particles_[i];
    return 0.4*p.mass*p.radius*p.radius;
}


// * * * * * * * * * * * * * * * * Energy ledger  * * * * * * * * * * * * * * * * * * * //

ContactEnergy IslandIntegrator::energyOf
(
    std::size_t law, const ContactList& list, std::size_t k
) const
{
    return materials_.laws()[law]->energy(list, k, bodies_.data(), ahead_, periodic_);
}


//- Power of the normal dashpot in the middle of a step [W]: it is too curved where it begins
//  for the trapezoidal rule. Of an oscillation w the path over h gives a velocity that is
//  too large by (w h)^2/8, the mean of the velocities one that is as much too small.
double IslandIntegrator::dashpotBetween
(
    std::size_t law, const ContactList& list, std::size_t k,
    const ContactEnergy& before, const ContactEnergy& after, double h
) const
{
    double c[maxConstants], history[maxHistory];
    for (std::size_t a = 0; a < list.constants.size(); ++a) c[a] = list.constants[a][k];
    for (std::size_t a = 0; a < list.history.size(); ++a) history[a] = list.history[a][k];
    const double overlap =
        0.5*(before.overlap + after.overlap) + h/8*(before.closing - after.closing);
    const double closing =
        0.5*(after.overlap - before.overlap)/h + 0.25*(before.closing + after.closing);
    return
        materials_.laws()[law]->normalResponse(c, overlap, history).damping
       *closing*closing;
}


//- Of those awake [J], at the velocities `v` and `w` of a Body or Motion
template<class Moving>
double IslandIntegrator::kinetic(const std::vector<Moving>& moving) const
{
    double sum = 0;
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        const Moving& m = moving[k];
        sum += 0.5*(mass(k)*vec(m.v).squaredNorm() + inertia(k)*vec(m.w).squaredNorm());
    }
    return sum;
}


//- Take down the energies before a step of h
void IslandIntegrator::openLedger(double h, EnergyLedger& ledger)
{
    ledger.kinetic -= kinetic(bodies_);
    kicked_.resize(particles_.size());
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        const Body& b = bodies_[k];
        for (int d = 0; d < 3; ++d)
        {
            kicked_[k].v[d] = b.v[d] + 0.5*h*b.invM*loads_[k].f[d];
            kicked_[k].w[d] = b.w[d] + 0.5*h*b.invI*loads_[k].t[d];
        }
    }
    ledger.gas -= kinetic(kicked_);

    energies_.resize(entries_.size());
    for (std::size_t l = 0; l < lists_.size(); ++l)
    {
        for (const ContactList* list : {&lists_[l].pairs, &lists_[l].walls})
        {
            for (std::size_t k = 0; k < list->size(); ++k)
            {
                energies_[std::size_t(list->tag[k])] = energyOf(l, *list, k);
            }
        }
    }
}


//- Add up what the step of h has done. Gas and body forces work in the flight only.
void IslandIntegrator::closeLedger(double h, EnergyLedger& ledger)
{
    ledger.kinetic += kinetic(bodies_);
    for (std::size_t l = 0; l < lists_.size(); ++l)
    {
        const double sign = materials_.laws()[l]->elastic() ? 1 : -1;
        for (const ContactList* list : {&lists_[l].pairs, &lists_[l].walls})
        {
            for (std::size_t k = 0; k < list->size(); ++k)
            {
                const ContactEnergy& before = energies_[std::size_t(list->tag[k])];
                const ContactEnergy after = energyOf(l, *list, k);
                ledger.normal += after.normal.stored - before.normal.stored;
                ledger.plastic += after.normal.plastic - before.normal.plastic;
                ledger.dashpots +=
                    0.5*h*(before.dashpots + after.dashpots)
                  + h/6
                   *(
                        before.normalDashpot + after.normalDashpot
                      + 4*dashpotBetween(l, *list, k, before, after, h)
                    );
                for (int s = 0; s < 3; ++s)
                {
                    const SpringEnergy& a = before.springs[s];
                    const SpringEnergy& b = after.springs[s];
                    const double change = b.stored() - a.stored();
                    const double gain =
                        0.25*sign*(a.square + b.square)*(b.stiffness - a.stiffness)
                      + 0.5*h*(a.gain + b.gain);
                    ledger.springs += change;
                    ledger.springGain += gain;
                    if (a.yields || b.yields)
                    {
                        ledger.yield += 0.5*h*(a.input + b.input) + gain - change;
                    }
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * * Stepping * * * * * * * * * * * * * * * * * * * * * //

//- Let the springs be ahead for a coming step h; loads are unchanged
void IslandIntegrator::prepareSprings(double h)
{
    const double ahead = springLead_*h;
    if (ahead == ahead_) return;
    complete();
    const SpringStep step{0, -ahead_, ahead};
    for (std::size_t l = 0; l < lists_.size(); ++l)
    {
        const ContactLaw& law = *materials_.laws()[l];
        if (!law.needsSpin()) continue;
        LawLists& lists = lists_[l];
        law.evaluatePairs
        (
            lists.pairs, 0, lists.pairs.size(), bodies_.data(), loads_.data(), step, 0,
            periodic_
        );
        law.evaluateWalls
        (
            lists.walls, 0, lists.walls.size(), bodies_.data(), loads_.data(), step, 0
        );
    }
    ahead_ = ahead;
}


//- The acceleration of a particle as last evaluated [m/s2]
Vec3 IslandIntegrator::acceleration(int i) const
{
    const std::size_t k = std::size_t(i);
    if (rest_[k].resting) return Vec3::Zero();
    const GasLoad& g = gas_[k];
    return (vec(loads_[k].f) + g.Sp*(g.Uc - vec(bodies_[k].v)) + g.Su)*bodies_[k].invM;
}


//- One contact at its stiffest, from an overlap [m] and a speed of approach [m/s]
ContactBound IslandIntegrator::contactBound
(
    std::size_t l, const ContactList& list, std::size_t k, double overlap, double speed
) const
{
    const Entry& e = entries_[std::size_t(list.tag[k])];
    const int mi = particles_[std::size_t(list.i[k])].material;
    double c[maxConstants], history[maxHistory];
    for (std::size_t m = 0; m < list.constants.size(); ++m) c[m] = list.constants[m][k];
    for (std::size_t m = 0; m < list.history.size(); ++m) history[m] = list.history[m][k];
    return materials_.laws()[l]->bound
    (
        materials_.pairInLaw(mi, e.materialJ),
        {materials_.constants(mi, e.materialJ), e.R, e.m}, c, history, e.turning, overlap, speed
    );
}


void IslandIntegrator::addToSums(const ContactList& list, std::size_t k, const ContactBound& b)
{
    for (const int p : {list.i[k], list.isWall() ? -1 : list.j[k]})
    {
        if (p < 0) continue;
        Sums& s = sums_[std::size_t(p)];
        s.stiffness += b.stiffness;
        s.damping += b.damping;
        s.rolling += b.rolling;
        s.rollingDamping += b.rollingDamping;
        s.twisting += b.twisting;
        s.twistingDamping += b.twistingDamping;
    }
}


//- No mode is faster than the fastest of these sums
IslandIntegrator::Sums IslandIntegrator::mostOfSums() const
{
    Sums most;
    for (const LawLists& l : lists_)
    {
        for (const bool wall : {false, true})
        {
            const ContactList& list = wall ? l.walls : l.pairs;
            for (std::size_t k = 0; k < list.size(); ++k)
            {
                Sums both;
                for (const int p : {list.i[k], wall ? -1 : list.j[k]})
                {
                    if (p < 0) continue;
                    const Sums& s = sums_[std::size_t(p)];
                    const Body& body = bodies_[std::size_t(p)];
                    const double turns = bodies_[std::size_t(p)].r*body.invI;
                    both.stiffness += s.stiffness*body.invM;
                    both.damping += s.damping*body.invM;
                    both.twisting += s.twisting*body.invI;
                    both.twistingDamping += s.twistingDamping*body.invI;
                    most.rolling = std::max(most.rolling, s.rolling*turns);
                    most.rollingDamping =
                        std::max(most.rollingDamping, s.rollingDamping*turns);
                }
                most.stiffness = std::max(most.stiffness, both.stiffness);
                most.damping = std::max(most.damping, both.damping);
                most.twisting = std::max(most.twisting, both.twisting);
                most.twistingDamping = std::max(most.twistingDamping, both.twistingDamping);
            }
        }
    }
    return most;
}


double IslandIntegrator::boundOf(const Sums& most)
{
    return stabilityBound
    (
        most.stiffness + most.rolling + most.twisting,
        most.damping + most.rollingDamping + most.twistingDamping
    );
}


//- Stability bound of the contacts as they are, with nothing foreseen [s]
double IslandIntegrator::boundNow()
{
    sums_.assign(particles_.size(), {});
    for (std::size_t l = 0; l < lists_.size(); ++l)
    {
        for (const ContactList* list : {&lists_[l].pairs, &lists_[l].walls})
        {
            for (std::size_t k = 0; k < list->size(); ++k)
            {
                addToSums(*list, k, contactBound(l, *list, k, list->overlap[k], 0));
            }
        }
    }
    return boundOf(mostOfSums());
}


//- The longest contact step over the shortest period: the bound of one contact is 2/omega
double IslandIntegrator::longestStep() const
{
    return std::min(1/time_.stepsPerContact, time_.boundShare/M_PI);
}


//- The contact step that the contacts need as they are now and until the next look; watches
//  them as well. See contactPeriod.hpp.
double IslandIntegrator::contactStep(double time, StepReport& report)
{
    const int looks = exactEvents_ ? stepsBetweenLooks : stepsBetweenLooksDense;
    deep_ = false;
    double shortest = 1e300, path = 1e300, slipTime = 1e30, turnTime = 1e30;
    sums_.assign(particles_.size(), {});
    accelerations_.resize(particles_.size());
    strongest_ = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i)
    {
        accelerations_[i] = acceleration(int(i));
        strongest_ = std::max(strongest_, accelerations_[i].squaredNorm());
    }
    strongest_ = std::sqrt(strongest_);
    for (std::size_t l = 0; l < lists_.size(); ++l)
    {
        for (const bool wall : {false, true})
        {
            const ContactList& list = wall ? lists_[l].walls : lists_[l].pairs;
            for (std::size_t k = 0; k < list.size(); ++k)
            {
                const std::size_t i = std::size_t(list.i[k]);
                const Body& bi = bodies_[i];
                Entry& e = entries_[std::size_t(list.tag[k])];

                double smaller = bi.r;
                Vec3 n, v = vec(bi.v), a = accelerations_[i];
                if (wall) n = Vec3(list.nx[k], list.ny[k], list.nz[k]);
                else
                {
                    const Body& bj = bodies_[std::size_t(list.j[k])];
                    n = periodic_.nearest(vec(bj.x) - vec(bi.x)).normalized();
                    v -= vec(bj.v);
                    a -= accelerations_[std::size_t(list.j[k])];
                    smaller = std::min(smaller, bj.r);
                }
                const double speed = std::fabs(v.dot(n));
                if (!std::isfinite(speed) || !std::isfinite(list.overlap[k]))
                {
                    fail("is not finite", int(i), wall ? -1 : list.j[k], time);
                }
                if (list.overlap[k] > 0.9*smaller)
                {
                    fail
                    (
                        "has an overlap of " + std::to_string(list.overlap[k]/smaller)
                      + " radii, more than any contact law covers",
                        int(i), wall ? -1 : list.j[k], time
                    );
                }
                report.maxOverlapOverDiameter = std::max
                (
                    report.maxOverlapOverDiameter, list.overlap[k]/(2*smaller)
                );

                const auto boundAt = [&](double overlap, double at)
                {
                    return contactBound(l, list, k, overlap, at);
                };
                const auto depthOf = [&](const ContactBound& b) { return b.radius*b.radius/e.R; };
                // what presses may make it faster, and so stiffer, before the next look; a
                // load that stays, by a T/(2 pi) at most
                const double periods = looks*longestStep();
                const double ahead = exactEvents_ ? periods : std::min(periods, 0.25);
                const auto gain = [&](const ContactBound& b)
                {
                    return std::max(0.0, a.dot(n))*ahead*b.period;
                };
                ContactBound b;
                double gained;
                if (exactEvents_)
                {
                    b = boundAt(list.overlap[k], speed);
                    gained = gain(b);
                    const double depth = depthOf(b);
                    if (e.m*gained*(gained + speed) > 0.01*b.stiffness*depth*depth)
                    {
                        b = boundAt(list.overlap[k], speed + gained);
                    }
                }
                else
                {
                    // of many contacts most are as they were: what was found with some
                    // margin goes on being right
                    gained = e.boundSpeed < 0 ? 0 : gain(e.bound);
                    const double fast = speed + gained;
                    if
                    (
                        !(fast <= e.boundSpeed) || list.overlap[k] > e.boundOverlap
                     || fast < e.slowest
                    )
                    {
                        b = boundAt(list.overlap[k], 1.25*fast);
                        const double depth = depthOf(b);
                        const double gentle = 0.1*depth*std::sqrt(b.stiffness/e.m);
                        e.boundSpeed = std::max(1.25*fast, gentle);
                        e.boundOverlap = list.overlap[k] + 0.05*depth;
                        e.slowest = 1.25*fast > gentle ? 0.5*fast : -1;
                        e.bound = boundAt(e.boundOverlap, e.boundSpeed);
                        gained = gain(e.bound);
                    }
                    b = e.bound;
                }

                // no deeper than laws cover, unseen
                const double closing = looks*(speed + gained);
                if (closing > 0) path = std::min(path, 0.3*smaller/closing);
                deep_ =
                    deep_
                 || list.overlap[k] + closing*b.period*longestStep()
                  > deepOverlap*smaller;
                shortest = std::min(shortest, b.period);
                slipTime = std::min(slipTime, b.slipTime);
                turnTime = std::min(turnTime, b.turnTime);
                addToSums(list, k, b);
            }
        }
    }
    if (shortest == 1e300) return shortest;

    const Sums most = mostOfSums();
    bound_ = boundOf(most);
    period_ = shortest;
    double h = shortest/time_.stepsPerContact;
    if (bound_ < leastBound*shortest)
    {
        const int i = awake_.empty() ? 0 : awake_[0];
        std::ostringstream what;
        what << "is in an island whose dashpots are stable below a step of " << bound_
             << " s only, " << bound_/shortest
             << " of a contact's period (rollingDamping, twistingDamping)";
        fail(what.str(), i, -1, time);
    }
    h = std::min({h, time_.boundShare*bound_, path});
    h = std::min(h, meetingStep(h, looks));

    // what springs without a dashpot lack, see contactPeriod.hpp
    const double lacks = std::max
    ({
        0.0, h*h*most.stiffness/8 - slipTime/h, h*h*(most.rolling + most.twisting)/8 - turnTime/h
    });
    springLead_ = 0.5 - std::min(lacks, 0.5);
    return h;
}


//- h, or shorter where particles that do not touch yet would pass through each other, or
//  meet within a dense island faster than its contacts so far allow
double IslandIntegrator::meetingStep(double h, int looks) const
{
    double fastest = 0;
    for (const int i : awake_)
    {
        fastest = std::max(fastest, vec(bodies_[std::size_t(i)].v).norm());
    }
    const double path = mostPath*smallest_;     // a quarter of the skin
    if (exactEvents_ && fastest*h <= path) return h;

    double shortest = h;
    const double window = looks*h;
    const auto meet = [&](double gap, double closing, double period)
    {
        if (closing*h > path) shortest = std::min(shortest, path/closing);
        if (!exactEvents_ && gap < closing*window)
        {
            shortest = std::min(shortest, period/time_.stepsPerContact);
        }
    };
    for (std::size_t k = 0; k < candidates_.size(); ++k)
    {
        const Candidate& c = candidates_[k];
        if (due_[k] - path_ > fastest*window || c.touching) continue;
        const Body& a = bodies_[std::size_t(c.i)];
        const Body& b = bodies_[std::size_t(c.j)];
        const double closing = (vec(a.v) - vec(b.v)).norm();
        if (closing*window <= 0) continue;
        const double g = gap(c);
        if (g > closing*window) continue;
        const double period =
            exactEvents_ ? 1e300
          : materials_.figures
            (
                particles_[std::size_t(c.i)].material, particles_[std::size_t(c.j)].material,
                a.r, b.r, 1/a.invM, 1/b.invM, closing
            ).period;
        meet(g, closing, period);
    }
    std::size_t first = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i)
    {
        const Body& b = bodies_[i];
        const double speed = vec(b.v).norm();
        if (surfaceEnd_[i] > first && speed*window > path)
        {
            for (std::size_t s = first; s < surfaceEnd_[i]; ++s)
            {
                const double range = b.r + reach_[i] + speed*window;
                // one within reach is watched step by step
                if
                (
                    !wallSearch_.within(surfaces_[s], vec(b.x), range)
                 || wallSearch_.within(surfaces_[s], vec(b.x), b.r + reach_[i] + 0.5*skin_)
                ) continue;
                shortest = std::min(shortest, std::max(path/speed, 1e-3*h));
                break;
            }
        }
        first = surfaceEnd_[i];
    }
    return shortest;
}


//- The contact step of the stiffest contact that could come about
double IslandIntegrator::stiffestStep(double speed) const
{
    double shortest = 1e300;
    std::vector<const Particle*> lightest(materials_.materials().size(), nullptr);
    for (const Particle& p : particles_)
    {
        const Particle*& s = lightest[std::size_t(p.material)];
        if (!s || p.mass < s->mass) s = &p;
    }
    for (const Particle* p : lightest)
    {
        if (!p) continue;
        for (const Particle* q : lightest)
        {
            if (!q) continue;
            shortest = std::min
            (
                shortest,
                materials_.figures
                (
                    p->material, q->material, p->radius, q->radius, p->mass, q->mass,
                    2*speed
                ).period
            );
        }
        for (const WallPatch& w : wallSearch_.walls().patches)
        {
            shortest = std::min
            (
                shortest,
                materials_.figures
                (
                    p->material, w.material, p->radius, -1, p->mass, 0, speed,
                    w.curvature.value_or(WallCurvature())
                ).period
            );
        }
    }
    return shortest*longestStep();
}


//- Earliest time at which a new contact could begin
double IslandIntegrator::timeToTouch(bool contact) const
{
    double shortest = 1e300;
    // whether what contacts press together can meet within a contact step
    const auto soon = [&](double g, double closing)
    {
        return g < (std::max(closing, 0.0) + 2*strongest_*contactStep_)*contactStep_;
    };
    const auto pair = [&](const Candidate& c)
    {
        if
        (
            c.touching
         || (rest_[std::size_t(c.i)].resting && rest_[std::size_t(c.j)].resting)
        ) return;
        const Body& a = bodies_[std::size_t(c.i)];
        const Body& b = bodies_[std::size_t(c.j)];
        const Vec3 d = periodic_.nearest(vec(b.x) - vec(a.x));
        const double distance = d.norm();
        const double g = std::max
        ({
            distance - a.r - b.r - c.touch,
            gapResolution(vec(a.x), a.r), gapResolution(vec(b.x), b.r)
        });
        const double closing = (vec(a.v) - vec(b.v)).dot(d)/std::max(distance, 1e-290);
        double bound = 0;
        if (!contact) bound = accelerationBound(c.i) + accelerationBound(c.j);
        else if (soon(g, closing))
        {
            bound = (acceleration(c.i) - acceleration(c.j)).dot(d)/std::max(distance, 1e-290);
        }
        shortest = std::min(shortest, closingTime(g, closing, std::max(bound, 0.0)));
    };

    if (contact)
    {
        for (const Near& n : near_) pair(candidates_[std::size_t(n.candidate)]);
        for (const int i : nearWalls_)
        {
            const std::size_t k = std::size_t(i);
            for (std::size_t c = 0; c < hits_[k].size(); ++c)
            {
                if (hitTaken_[k][c]) continue;
                const WallHit& hit = hits_[k][c];
                const double g = hit.distance - bodies_[k].r - wallTouch(i, hit.patch);
                const double closing = vec(bodies_[k].v).dot(hit.n);
                const double bound = soon(g, closing) ? acceleration(i).dot(hit.n) : 0;
                shortest = std::min
                (
                    shortest, closingTime(g, closing, std::max(bound, 0.0))
                );
            }
        }
    }
    else
    {
        for (const Candidate& c : candidates_) pair(c);
        for (const int i : awake_)
        {
            const std::size_t k = std::size_t(i);
            const std::size_t first = k ? surfaceEnd_[k - 1] : 0;
            shortest = std::min
            (
                shortest,
                wallSearch_.timeToTouch
                (
                    vec(bodies_[k].x), vec(bodies_[k].v), accelerationBound(i),
                    bodies_[k].r, wallTouch_[std::size_t(particles_[k].material)],
                    surfaces_.data() + first, surfaceEnd_[k] - first
                )
            );
        }
    }
    return shortest;
}


//- A step of at most h, graded as the header says; end: time after which a contact ends, if
//  within that step, else 1e300
double IslandIntegrator::gradedStep(double h, double& end) const
{
    const double tau = gradedShare*time_.stepsPerContact*h;
    const double first = 0.25*h*h/tau;
    const double far = 2*(fastest_*std::max(h, tau) + strongest_*h*h);
    double graded = h;
    end = 1e300;
    for (const LawLists& l : lists_)
    {
        for (const bool wall : {false, true})
        {
            const ContactList& list = wall ? l.walls : l.pairs;
            for (std::size_t k = 0; k < list.size(); ++k)
            {
                const Entry& e = entries_[std::size_t(list.tag[k])];
                const double left = std::max(list.overlap[k] + e.neck, 0.0);
                const double inside = list.overlap[k] - e.edge;
                // most contacts are nowhere near
                if (std::min(left, std::fabs(inside)) > far) continue;
                const Body& bi = bodies_[std::size_t(list.i[k])];
                double opening, parting;    // [m/s], [m/s2]
                if (wall)
                {
                    const Vec3 n(list.nx[k], list.ny[k], list.nz[k]);
                    opening = -vec(bi.v).dot(n);
                    parting = -acceleration(list.i[k]).dot(n);
                }
                else
                {
                    const Body& bj = bodies_[std::size_t(list.j[k])];
                    const Vec3 n = periodic_.nearest(vec(bj.x) - vec(bi.x)).normalized();
                    opening = (vec(bj.v) - vec(bi.v)).dot(n);
                    parting = (acceleration(list.j[k]) - acceleration(list.i[k])).dot(n);
                }
                end = std::min(end, closingTime(left, opening, std::max(parting, 0.0)));
                if (opening == 0) continue;
                const double t = std::fabs(inside/opening);
                const double even = h*std::sqrt(t/tau);
                const bool nears = inside*opening > 0;
                // not shorter than places can tell
                const double least =
                    16*2.2e-16*vec(bi.x).lpNorm<Eigen::Infinity>()/std::fabs(opening);
                graded = std::min
                (
                    graded,
                    std::max(least, !nears ? even + first : t > first ? even - first : t + first)
                );
            }
        }
    }
    if (!refined_) graded = h;
    if (end >= graded) end = 1e300;
    return graded;
}


// * * * * * * * * * * * * * * * * * * Rest * * * * * * * * * * * * * * * * * * * * * * //

void IslandIntegrator::checkRest(double elapsed, StepReport& report)
{
    if (time_.restTolerance <= 0) return;

    weakest_.assign(particles_.size(), {1e300, 1e300, {0, 0}});
    double window = 0;
    for (const LawLists& l : lists_)
    {
        for (const bool wall : {false, true})
        {
            const ContactList& list = wall ? l.walls : l.pairs;
            for (std::size_t k = 0; k < list.size(); ++k)
            {
                const Entry& e = entries_[std::size_t(list.tag[k])];
                // delta_C = a0^2/(2 6^(1/3) R), also for laws without a neck
                const double delta = 0.27516*e.a0*e.a0/e.R;
                const int partners[2] = {list.i[k], wall ? -1 : list.j[k]};
                for (const int p : partners)
                {
                    if (p < 0) continue;
                    Weakest& w = weakest_[std::size_t(p)];
                    if (e.pullOff < w.pullOff) w = {e.pullOff, delta, e.yield};
                }
                if (e.pullOff > 0)
                {
                    // T_n at A = 1: k_N = 3.6 F_C R/a0^2
                    window = std::max
                    (
                        window,
                        2*M_PI*std::sqrt(e.m*e.a0*e.a0/(3.6*e.pullOff*e.R))
                    );
                }
            }
        }
    }
    window_ = window *= windowPeriods;

    findFlying();
    forFlying([&](const std::vector<int>& members, RigidAggregate& body)
    {
        for (std::size_t m = 0; m < members.size(); ++m)
        {
            const std::size_t k = std::size_t(members[m]);
            const Vec3 v = body.velocityBeyond(m), omega = body.spinBeyond(m);
            judge
            (
                k, 0.5*(mass(k)*v.squaredNorm() + inertia(k)*omega.squaredNorm()),
                (vec(loads_[k].f) - body.contactForce(m)).norm(),
                (vec(loads_[k].t) - body.contactTorque(m)).norm(), elapsed
            );
        }
    });

    bool due = false;
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        if (flies_[k]) continue;
        const Body& b = bodies_[k];
        const Vec3 v = vec(b.v), omega = vec(b.w);
        judge
        (
            k, 0.5*(mass(k)*v.squaredNorm() + inertia(k)*omega.squaredNorm()),
            (vec(loads_[k].f) + gas_[k].Sp*(gas_[k].Uc - v) + gas_[k].Su).norm(),
            vec(loads_[k].t).norm(), elapsed
        );
        due = due || (window > 0 && rest_[k].quietTime >= window);
    }
    if (!due) return;
    prepareSprings(0);

    // who is quiet and holds on to a wall or to one at rest, by quiet ones if need be
    const auto quiet = [&](int i)
    {
        const RestState& rest = rest_[std::size_t(i)];
        return
            !rest.resting && !flies_[std::size_t(i)]
         && rest.quietTime > 0 && rest.quietTime >= window;
    };
    DisjointSets clusters(particles_.size());
    for (const LawLists& l : lists_)
    {
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            const int i = l.pairs.i[k], j = l.pairs.j[k];
            if (quiet(i) && quiet(j)) clusters.join(std::size_t(i), std::size_t(j));
        }
    }
    std::vector<char> held(particles_.size(), 0);   // by root
    const auto hold = [&](int i)
    {
        if (quiet(i)) held[clusters.find(std::size_t(i))] = 1;
    };
    for (const LawLists& l : lists_)
    {
        for (std::size_t k = 0; k < l.walls.size(); ++k) hold(l.walls.i[k]);
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            const int i = l.pairs.i[k], j = l.pairs.j[k];
            if (rest_[std::size_t(i)].resting) hold(j);
            if (rest_[std::size_t(j)].resting) hold(i);
        }
    }

    std::size_t kept = 0;
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        if (!quiet(i) || !held[clusters.find(k)])
        {
            awake_[kept++] = i;
            continue;
        }
        Body& b = bodies_[k];
        const double energy =
            0.5*(mass(k)*vec(b.v).squaredNorm() + inertia(k)*vec(b.w).squaredNorm());
        report.energyRemovedByRest += energy;
        if (time_.energyLedger)
        {
            report.energy.kinetic -= energy;
            report.energy.rest += energy;
        }
        for (int d = 0; d < 3; ++d) b.v[d] = b.w[d] = 0;
        for (double& v : motion_[k].v) v = 0;
        for (double& w : motion_[k].w) w = 0;
        RestState& rest = rest_[k];
        rests(k, elapsed_);
        rest.resting = true;
        const Vec3 gasForce = gasForceAtRest(gas_[k]);
        for (int d = 0; d < 3; ++d) rest.force[d] = gasForce[d];
        rest.pullOff = weakest_[k].pullOff;
        rest.wakeForce = wakeForceOf(k);
        ++report.sleeps;
    }
    if (kept == awake_.size()) return;
    awake_.resize(kept);

    for (LawLists& l : lists_)
    {
        for (const bool wall : {false, true})
        {
            ContactList& list = wall ? l.walls : l.pairs;
            for (std::size_t k = list.size(); k-- > 0;)
            {
                if
                (
                    !rest_[std::size_t(list.i[k])].resting
                 || (!wall && !rest_[std::size_t(list.j[k])].resting)
                ) continue;
                store(list, k, wall);
                const int candidate = entries_[std::size_t(list.tag[k])].candidate;
                remove(list, k);
                // it still touches: only a wake brings it back
                if (candidate >= 0) candidates_[std::size_t(candidate)].touching = true;
            }
        }
    }
    near_.erase
    (
        std::remove_if
        (
            near_.begin(), near_.end(),
            [&](const Near& n)
            {
                const Candidate& k = candidates_[std::size_t(n.candidate)];
                return
                    k.touching
                 || (
                        rest_[std::size_t(k.i)].resting && rest_[std::size_t(k.j)].resting
                    );
            }
        ),
        near_.end()
    );
    nearWalls_.erase
    (
        std::remove_if
        (
            nearWalls_.begin(), nearWalls_.end(),
            [&](int i) { return rest_[std::size_t(i)].resting; }
        ),
        nearWalls_.end()
    );
    findBoundary();
}


//- Particle k rests from `since` on: run() adds the whole of its step to the impulse of the gas
void IslandIntegrator::rests(std::size_t k, double since)
{
    impulse_[k] -= since*gasForceAtRest(gas_[k]);
}


//- Change of the load from outside that wakes particle k [N]
double IslandIntegrator::wakeForceOf(std::size_t k) const
{
    const Weakest& w = weakest_[k];
    const double rolls = w.yield.moment/bodies_[k].r;
    return
        time_.restTolerance*wakeForceChange
       *(rolls > 0 ? std::min(w.pullOff, rolls) : w.pullOff);
}


//- How long particle k has been quiet, by its energy [J] and what is out of balance on it
void IslandIntegrator::judge
(
    std::size_t k, double energy, double force, double torque, double elapsed
)
{
    const Weakest& w = weakest_[k];
    const double tolerance = time_.restTolerance;
    double& quiet = rest_[k].quietTime;
    const double small = tolerance*quietEnergy*w.pullOff*w.delta;
    if
    (
        !(w.pullOff > 0 && w.pullOff < 1e300)
     || force >= tolerance*quietForce*w.pullOff
     || torque >= tolerance*std::max(quietTorque*w.pullOff*bodies_[k].r, w.yield.moment)
     || energy >= std::max(small, tolerance*w.yield.energy)
    ) quiet = 0;
    else quiet += energy < small ? elapsed : elapsed/rockingWindows;
}


//- Clusters of awake particles that hold on to nothing
void IslandIntegrator::findFlying()
{
    const std::size_t n = particles_.size();
    flying_.clear();
    flies_.assign(n, 0);
    DisjointSets clusters(n);
    std::vector<char>& loose = flies_;
    for (const LawLists& l : lists_)
    {
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            const std::size_t i = std::size_t(l.pairs.i[k]), j = std::size_t(l.pairs.j[k]);
            if (!rest_[i].resting && !rest_[j].resting) clusters.join(i, j);
        }
    }
    std::vector<char> held(n, 0);   // by root
    for (const LawLists& l : lists_)
    {
        for (std::size_t k = 0; k < l.walls.size(); ++k)
        {
            held[clusters.find(std::size_t(l.walls.i[k]))] = 1;
        }
        for (std::size_t k = 0; k < l.pairs.size(); ++k)
        {
            const std::size_t i = std::size_t(l.pairs.i[k]), j = std::size_t(l.pairs.j[k]);
            if (rest_[i].resting != rest_[j].resting)
            {
                held[clusters.find(rest_[i].resting ? j : i)] = 1;
            }
            else loose[i] = loose[j] = 1;
        }
    }
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        loose[k] = loose[k] && !held[clusters.find(k)];
        if (loose[k]) flying_.push_back({int(clusters.find(k)), i});
    }
    std::sort(flying_.begin(), flying_.end());
}


//- f(members, body) for each of these clusters
template<class F>
void IslandIntegrator::forFlying(F&& f)
{
    std::vector<int> members;
    std::vector<Particle> particles;
    std::vector<GasLoad> gas;
    for (std::size_t first = 0, last; first < flying_.size(); first = last)
    {
        members.clear();
        particles.clear();
        gas.clear();
        last = first;
        for (; last < flying_.size() && flying_[last].first == flying_[first].first; ++last)
        {
            const int i = flying_[last].second;
            const std::size_t k = std::size_t(i);
            Particle p = particles_[k];
            p.x = vec(bodies_[k].x);
            p.v = vec(bodies_[k].v);
            p.omega = vec(bodies_[k].w);
            members.push_back(i);
            particles.push_back(p);
            gas.push_back(gas_[k]);
        }
        RigidAggregate body(particles, gas, periodic_);
        f(members, body);
    }
}


//- Clusters that have been quiet go on as rigid aggregates
void IslandIntegrator::freezeFlying(StepReport& report)
{
    if (!time_.islands || time_.restTolerance <= 0 || window_ <= 0) return;
    bool due = false;
    for (const int i : awake_) due = due || rest_[std::size_t(i)].quietTime >= window_;
    if (!due) return;

    findFlying();
    forFlying([&](const std::vector<int>& members, RigidAggregate& body)
    {
        std::int64_t lowest = particles_[std::size_t(members[0])].id;
        for (const int i : members)
        {
            if (rest_[std::size_t(i)].quietTime < window_) return;
            lowest = std::min(lowest, particles_[std::size_t(i)].id);
        }
        const double energy = body.stiffen();
        report.energyRemovedByRest += energy;
        if (time_.energyLedger)
        {
            report.energy.kinetic -= energy;
            report.energy.rest += energy;
        }
        for (std::size_t m = 0; m < members.size(); ++m)
        {
            const std::size_t k = std::size_t(members[m]);
            const Vec3 v = body.velocity(m), omega = body.spin();
            const Vec3 force = body.contactForce(m), arm = body.arm(m);
            RestState& rest = rest_[k];
            for (int d = 0; d < 3; ++d)
            {
                bodies_[k].v[d] = v[d];
                bodies_[k].w[d] = omega[d];
                rest.force[d] = force[d];
                rest.arm[d] = arm[d];
            }
            rest.resting = true;
            rest.aggregate = lowest;
            rest.members = int(members.size());
            rest.pullOff = weakest_[k].pullOff;
            rest.wakeForce = wakeForceOf(k);
            ++report.sleeps;
        }
    });
}


void IslandIntegrator::fail
(
    const std::string& what, int i, int j, double time
) const
{
    std::ostringstream s;
    const Particle& p = particles_[std::size_t(i)];
    const Body& b = bodies_[std::size_t(i)];
    s.precision(9);
    s   << "The contact of particle " << p.id << " with ";
    if (j < 0) s << "a wall";
    else s << "particle " << particles_[std::size_t(j)].id;
    s   << " " << what << " at time " << time << " s: position ("
        << b.x[0] << " " << b.x[1] << " " << b.x[2] << ") m, velocity ("
        << b.v[0] << " " << b.v[1] << " " << b.v[2] << ") m/s, radius "
        << p.radius << " m";
    throw numericalError(s.str());
}


std::vector<GasExchange> IslandIntegrator::gasExchange(double dt) const
{
    const std::size_t n = particles_.size();
    DisjointSets clusters(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        for (const Stored& s : stored_[i]) if (s.j >= 0) clusters.join(i, std::size_t(s.j));
    }
    std::vector<double> drag(n, 0), inertia(n, 0);     // by root
    std::vector<char> held(n, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t root = clusters.find(i);
        drag[root] += gas_[i].Sp;
        inertia[root] += mass(i);
        if (rest_[i].resting && rest_[i].aggregate < 0) held[root] = 1;
        for (const Stored& s : stored_[i]) if (s.j < 0) held[root] = 1;
    }

    std::vector<GasExchange> result(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t root = clusters.find(i);
        GasExchange& e = result[i];
        e.impulse = impulse_[i];
        e.held = held[root];
        const FlightFactors f(e.held ? 0 : drag[root]/inertia[root], dt);
        e.response = gas_[i].Sp*f.p1;
        e.memory = f.e;
    }
    return result;
}


void IslandIntegrator::run(double dt, double time, StepReport& report)
{
    const std::size_t n = particles_.size();
    bodies_.resize(n);
    motion_.assign(n, Motion{});
    ahead_ = owed_ = contactStep_ = window_ = 0;
    refined_ = false;
    flies_.assign(n, 0);
    loads_.assign(n, Load{});
    outran_.assign(n, 0);
    awake_.clear();
    smallest_ = 1e300;
    flightStep_ = -1;
    vacuum_ = true;
    for (const GasLoad& g : gas_)
    {
        vacuum_ = vacuum_ && g.Sp == 0 && g.SpOmega == 0 && g.Su.isZero(0);
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        const Particle& p = particles_[i];
        Body& b = bodies_[i];
        for (int d = 0; d < 3; ++d)
        {
            b.x[d] = p.x[d];
            b.v[d] = motion_[i].v[d] = p.v[d];
            b.w[d] = motion_[i].w[d] = p.omega[d];
        }
        b.r = p.radius;
        b.invM = motion_[i].invM = 1/p.mass;
        b.invI = motion_[i].invI = 1/inertia(i);
        smallest_ = std::min(smallest_, p.radius);
        if (!rest_[i].resting) awake_.push_back(int(i));
    }

    findCandidates(dt);
    frozen_.resize(n);
    frozenKnown_.assign(n, 0);
    marked_.assign(n, 0);
    holders_.resize(n);
    for (auto& h : holders_) h.clear();
    activateStored();
    for (std::size_t i = 0; i < n; ++i)
    {
        for (const Stored& s : stored_[i])
        {
            if (s.j >= 0) holders_[std::size_t(s.j)].push_back(int(i));
        }
    }
    for (Candidate& c : candidates_)
    {
        if (!rest_[std::size_t(c.i)].resting) continue;
        for (const Stored& s : stored_[std::size_t(c.i)])
        {
            if (s.j == c.j) c.touching = true;
        }
    }

    // No particle can be faster in this step, but for contact forces
    double speedBound = 0;
    for (const int i : awake_)
    {
        const std::size_t k = std::size_t(i);
        const FlightFactors f(gas_[k].Sp*bodies_[k].invM, dt);
        speedBound = std::max
        (
            speedBound, vec(bodies_[k].v).norm() + accelerationBound(i)*f.p1
        );
    }
    fastest_ = speedBound;
    exactEvents_ = candidates_.size() < denseIsland;
    path_ = elapsed_ = 0;
    left_ = dt;
    refreshNear();
    woken_.clear();
    for (std::size_t i = 0; i < n; ++i)
    {
        if (rest_[i].resting && wakes(rest_[i], gas_[i])) woken_.push_back(int(i));
    }
    if (woken_.empty())
    {
        findBoundary();
        updateWalls();
    }
    else wake(woken_, report);
    ended_ = evaluate({}, report);
    endMarked(report);
    form(report);

    // Step of new contacts, at the greatest speed so far: contacts can add to the bound
    double topSpeed = -1, stiffest = 0;
    const auto noteSpeed = [&]
    {
        const double speed = std::max(fastest_, speedBound);
        if (speed <= topSpeed) return;
        topSpeed = speed;
        stiffest = stiffestStep(topSpeed);
    };
    const int lookInterval = exactEvents_ ? stepsBetweenLooks : stepsBetweenLooksDense;
    // an event is passed by at most this part of a step: its error is of second order too
    const double overshoot = std::min(1e-3, 0.05/time_.stepsPerContact);
    previousStep_ = 0;
    double t = 0, h = 0, sinceLook = 0;
    int looked = lookInterval, shortened = 0;
    std::int64_t flights = 0;
    while (t < dt && !awake_.empty())
    {
        const double left = left_ = dt - t;
        double now;
        if (!time_.islands)
        {
            if (looked >= lookInterval)
            {
                complete();
                noteSpeed();
                h = std::min(stiffest, contactStep(time + t, report));
                h = left/std::ceil(left/h*(1 - 1e-12));
                looked = 0;
            }
            now = left < 1.5*h ? left : h;
            ++report.contactSteps;
            ++looked;
            sinceLook += now;
        }
        else if (anyContact())
        {
            if (looked >= lookInterval)
            {
                // equal steps up to the end of the particle step
                complete();
                const double allowed = contactStep(time + t, report);
                if (exactEvents_ || !(h <= allowed && allowed < 1.05*h))
                {
                    h = left/std::ceil(left/allowed*(1 - 1e-12));
                }
                contactStep_ = h;
                const bool refined = exactEvents_ && h < refinedShare*bound_;
                if (!refined || !refined_) previousStep_ = 0;
                refined_ = refined;
                if (skin_ > 4*200*fastest_*h && skin_ > 4e-3*smallest_) refreshNear();
                looked = 0;
            }
            now = left < 1.5*h ? left : h;
            if (exactEvents_ && shortened < 3)
            {
                double end;
                now = std::min(now, gradedStep(h, end));
                if (2*(path_ + fastest_*now - refreshed_) > 0.5*skin_) refreshNear();
                const double event = std::min(timeToTouch(true), end);
                if (event < now)
                {
                    // a little beyond, so that it has happened
                    now = std::min(now, std::max(event*(1 + 1e-9), overshoot*h));
                    ++shortened;
                    looked = lookInterval;
                }
                else shortened = 0;
            }
            else
            {
                // where events crowd, one is passed; a touch by no more than a step of the
                // stiffest contact that can begin
                if (shortened > 0)
                {
                    if (2*(path_ + fastest_*now - refreshed_) > 0.5*skin_) refreshNear();
                    const double touch = timeToTouch(true);
                    if (touch < now)
                    {
                        noteSpeed();
                        now = std::min(now, std::max(touch*(1 + 1e-9), stiffest));
                        looked = lookInterval;
                    }
                }
                shortened = 0;
            }
            ++report.contactSteps;
            ++looked;
            sinceLook += now;
        }
        else
        {
            // Near a touch go on by small parts of the contact step that would follow
            keepInBoxes(left);
            now = timeToTouch(false);
            if (now < 1e-6*smallest_/std::max({fastest_, speedBound, 1e-300}))
            {
                noteSpeed();
                const double path = mostPath*smallest_/std::max(topSpeed, 1e-300);
                now = std::max(now, overshoot*std::min(stiffest, path));
            }
            now = std::min(now, left);
            looked = lookInterval;
            sinceLook = 0;
            if (++flights > 10000000)
            {
                fail("is approached in too many steps", awake_[0], -1, time + t);
            }
        }

        if (4*fastest_*now > skin_) keepInBoxes(now);
        const bool flown = !anyContact();
        step(now, std::min(h, left - now), report);
        t = now < left ? t + now : dt;

        // what begins after a flight must not act over all of it
        if (exactEvents_ || flown) complete();
        wakeLoaded(report);
        bool event = endMarked(report);
        event = form(report) || event;
        if (event)
        {
            previousStep_ = 0;
            if (exactEvents_) looked = lookInterval;
        }
        if (deep_) looked = lookInterval;
        if (looked >= lookInterval && sinceLook > 0)
        {
            complete();
            checkRest(sinceLook, report);
            sinceLook = 0;
        }
    }

    complete();

    // steps in the shortest contact, as taken
    if (anyContact())
    {
        contactStep(time + dt, report);
        if (h > 0)
        {
            report.minStepsPerContact = std::min(report.minStepsPerContact, period_/h);
            report.maxStepOverBound = std::max(report.maxStepOverBound, h/bound_);
        }
    }

    for (std::size_t i = 0; i < n; ++i) if (rest_[i].resting) rests(i, -dt);

    noteOutran();
    prepareSprings(0);
    freezeFlying(report);
    for (LawLists& l : lists_)
    {
        for (std::size_t k = 0; k < l.pairs.size(); ++k) store(l.pairs, k, false);
        for (std::size_t k = 0; k < l.walls.size(); ++k) store(l.walls, k, true);
    }
    for (auto& s : stored_)
    {
        std::stable_sort
        (
            s.begin(), s.end(),
            [](const Stored& a, const Stored& b)
            {
                return
                    std::lexicographical_compare
                    (
                        &a.record.idJ, &a.record.idJ + 1, &b.record.idJ, &b.record.idJ + 1
                    )
                 || (
                        a.record.idJ == b.record.idJ
                     && std::lexicographical_compare
                        (
                            a.record.n, a.record.n + 3, b.record.n, b.record.n + 3
                        )
                    );
            }
        );
    }
    for (RestState& r : rest_) r.inContact = false;
    for (std::size_t i = 0; i < n; ++i)
    {
        for (const Stored& s : stored_[i])
        {
            rest_[i].inContact = true;
            if (s.j >= 0) rest_[std::size_t(s.j)].inContact = true;
        }
        Particle& p = particles_[i];
        const Body& b = bodies_[i];
        p.x = vec(b.x);
        p.v = vec(b.v);
        p.omega = vec(b.w);
        if (!p.x.allFinite() || !p.v.allFinite() || !p.omega.allFinite())
        {
            fail("is not finite", int(i), -1, time + dt);
        }
    }
}

}
