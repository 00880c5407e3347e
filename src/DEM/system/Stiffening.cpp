// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/Stiffening.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"
#include "foundation/Fields.hpp"
#include "neighbourSearch/BoxGrid.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace dem
{

namespace
{

// So much of an overlap may be missing [-] without waking those at rest: 0.001 F_C at equilibrium
constexpr double met = 1e-3;

//- Overlap [m] on the branch that a load can hold at which the law gives a force [N]; none: there
//  is none. start: of about the right size [m]; least: the contact has ended below that
std::optional<double> overlapFor
(
    const ContactLaw& law, const double* c, double force, double start, double least
)
{
    const auto missing = [&](double overlap)
    {
        double history[maxHistory] = {};
        return law.normalResponse(c, overlap, history).elastic - force;
    };
    double high = start, low = start;
    for (int k = 0; missing(high) < 0; ++k)
    {
        if (k == 60) return {};
        low = high;
        high *= 2;
    }
    // downwards in steps that cannot pass the branch by
    while (missing(low) > 0)
    {
        high = low;
        low -= 0.02*start;
        if (low < least) return {};
    }
    for (int k = 0; k < 100 && high - low > 1e-15*start; ++k)
    {
        const double middle = 0.5*(low + high);
        (missing(middle) > 0 ? high : low) = middle;
    }
    return 0.5*(low + high);
}

}


const ContactLaw& Stiffening::law(const Contact& c) const
{
    const int material = store_.particles[c.i].material;
    return *materials_.laws()[std::size_t(materials_.lawIndex(material, c.materialJ))];
}


std::vector<Stiffening::Contact> Stiffening::find() const
{
    const Diagnostics diagnostics(store_, materials_, walls_, periodic_, communicator_);
    const Walls& walls = walls_.walls();
    std::vector<Contact> result;
    diagnostics.eachContact([&](std::size_t i, std::size_t k, const Particle* j)
    {
        const Particle& p = store_.particles[i];
        const ContactRecord& record = store_.contacts[i][k];
        Contact c;
        c.i = i;
        c.k = k;
        c.wall = !j;
        c.j = j ? *j : p;
        c.materialJ = j ? j->material : walls.patches[std::size_t(record.wall)].material;
        c.R = j
          ? p.radius*j->radius/(p.radius + j->radius)
          : materials_.wallRadius
            (
                p.material, c.materialJ, walls.curvature(record.wall), p.radius
            );
        c.m = j ? p.mass*j->mass/(p.mass + j->mass) : p.mass;
        c.n = j
          ? Vec3(periodic_.nearest(j->x - p.x).normalized())
          : Vec3(record.n[0], record.n[1], record.n[2]);
        c.before = c.after = diagnostics.overlap(i, record, j);
        c.awake = !store_.rest[i].resting;
        result.push_back(c);
    });

    // one that is awake is enough, whichever of the two has the contact
    const std::unordered_set<std::int64_t> awake = awakePartners(result);
    for (Contact& c : result) c.awake = c.awake || (!c.wall && awake.count(c.j.id) > 0);
    return result;
}


//- Those with whom contacts of this rank are, and who are awake, also on other ranks
std::unordered_set<std::int64_t> Stiffening::awakePartners
(
    const std::vector<Contact>& contacts
) const
{
    std::unordered_set<std::int64_t> result;
    std::vector<double> elsewhere;
    const auto awake = [&](std::int64_t id)
    {
        const auto found = store_.indexOf.find(id);
        return found != store_.indexOf.end() && !store_.rest[found->second].resting;
    };
    for (const Contact& c : contacts)
    {
        if (c.wall) continue;
        if (awake(c.j.id)) result.insert(c.j.id);
        else if (!store_.indexOf.count(c.j.id)) elsewhere.push_back(double(c.j.id));
    }
    std::vector<std::vector<double>> answers;
    for (const std::vector<double>& from : communicator_.allGather(elsewhere))
    {
        answers.emplace_back();
        for (const double id : from)
        {
            if (awake(std::int64_t(id))) answers.back().push_back(id);
        }
    }
    for (const std::vector<double>& from : communicator_.exchange(answers))
    {
        for (const double id : from) result.insert(std::int64_t(id));
    }
    return result;
}


//- Find the overlap that it should have, and whether it keeps its force
void Stiffening::aim(Contact& c, const MaterialTable& now) const
{
    const int material = store_.particles[c.i].material;
    const int pair = materials_.pairInLaw(material, c.materialJ);
    const PairConstants& before = materials_.constants(material, c.materialJ);
    const PairConstants& after = now.constants(material, c.materialJ);
    const double rolling = c.wall ? store_.particles[c.i].radius : c.R;
    const ContactLaw& l = law(c);
    double cb[maxConstants], ca[maxConstants], history[maxHistory] = {};
    l.prepare(pair, {before, c.R, c.m, rolling}, cb);
    l.prepare(pair, {after, c.R, c.m, rolling}, ca);

    const NormalResponse<double> was = l.normalResponse(cb, c.before, history);
    const double a0 = l.equilibriumRadius(pair, after, c.R);
    c.size = a0 > 0 ? a0*a0/(3*c.R) : std::fabs(c.before);
    const double further = l.normalResponse(cb, c.before + 1e-4*c.size, history).elastic;
    const bool collides = c.awake && was.elastic > l.pullOff(pair, before, c.R);
    if (was.radius > 0 && further >= was.elastic && !collides)
    {
        const std::optional<double> found = overlapFor
        (
            l, ca, was.elastic, c.size, -l.reach(pair, after, c.R)
        );
        c.similar = !found;
        if (found) c.after = *found;
    }
    if (!c.similar) return;

    const double touch = l.touchDistance(pair, before);
    double factor = std::pow(before.chi/after.chi, 0.4);
    if (touch > 0 && !(was.radius > 0)) factor = l.touchDistance(pair, after)/touch;
    else if (a0 > 0) factor = std::pow(a0/l.equilibriumRadius(pair, before, c.R), 2);
    c.after = c.before*factor;
}


Gap Stiffening::gap(const Contact& c) const
{
    const Particle& p = store_.particles[c.i];
    const double distance = p.radius + c.j.radius - c.before;
    return {p.id, c.wall ? -1 : c.j.id, c.n, distance, c.before - c.after, p.mass, c.j.mass};
}


ContactEnergy Stiffening::energy
(
    const Contact& c, const MaterialTable& table, double overlap, const double* history
) const
{
    const Particle& p = store_.particles[c.i];
    const ContactLaw& l = law(c);
    double constants[maxConstants];
    l.prepare
    (
        table.pairInLaw(p.material, c.materialJ),
        {table.constants(p.material, c.materialJ), c.R, c.m, c.wall ? p.radius : c.R}, constants
    );
    Body bodies[2] = {};
    bodies[0].r = p.radius;
    bodies[1].r = c.j.radius;
    for (int d = 0; d < 3; ++d) bodies[1].x[d] = (p.radius + c.j.radius - overlap)*c.n[d];
    ContactList list;
    list.setUp(l.nConstants(), l.nHistory(), c.wall);
    list.append(0, c.wall ? -1 : 1, 0, constants, history);
    if (c.wall)
    {
        list.nx[0] = c.n[0];
        list.ny[0] = c.n[1];
        list.nz[0] = c.n[2];
        list.overlap[0] = overlap;
    }
    return l.energy(list, 0, bodies, 0, Periodic());
}


//- Springs and energies. Returned: particles of all ranks whose overlaps are not as they should be
std::unordered_set<std::int64_t> Stiffening::takeOver
(
    const std::vector<Contact>& contacts, const Ways& ways, const MaterialTable& now,
    Restiffened& r
)
{
    std::vector<double> wake;
    for (const Contact& c : contacts)
    {
        double* history = store_.contacts[c.i][c.k].history;
        const ContactEnergy before = energy(c, materials_, c.before, history);
        const ContactEnergy aimed = energy(c, now, c.after, history);
        double factors[3];
        for (int s = 0; s < 3; ++s)
        {
            const double old = before.springs[s].stiffness, stiff = aimed.springs[s].stiffness;
            factors[s] = old > 0 && stiff > 0 ? old/stiff : 1;
            if (c.similar) factors[s] = std::sqrt(factors[s]);
        }
        law(c).scaleSprings(factors, history);

        const Gap g = gap(c);
        const double overlap = c.before - opened(g, ways.at(g.i), c.wall ? c.n : ways.at(g.j));
        const ContactEnergy after = energy(c, now, overlap, history);
        r.normal += after.normal.stored - before.normal.stored;
        r.springs += after.inSprings() - before.inSprings();
        const double off =
            std::fabs(overlap - c.after)/std::max({std::fabs(c.after), c.size, 1e-300});
        r.misfit = std::max(r.misfit, off);
        if (off > met)
        {
            wake.push_back(double(store_.particles[c.i].id));
            wake.push_back(double(c.j.id));
        }
        ++r.contacts;
        r.similar += c.similar;
    }
    std::unordered_set<std::int64_t> result;
    for (const std::vector<double>& from : communicator_.allGather(wake))
    {
        for (const double id : from) result.insert(std::int64_t(id));
    }
    return result;
}


//- Particles to their places, and what else depends on chi
void Stiffening::move
(
    const Ways& ways, const std::unordered_set<std::int64_t>& wake, const MaterialTable& now,
    Restiffened& r
)
{
    for (std::size_t i = 0; i < store_.size(); ++i)
    {
        Particle& p = store_.particles[i];
        RestState& rest = store_.rest[i];
        store_.reach[i] = now.reach(p.material, p.radius, walls_.walls());
        const auto way = ways.find(p.id);
        if (way != ways.end())
        {
            p.x = periodic_.wrapped(p.x + way->second);
            r.farthest = std::max(r.farthest, way->second.norm());
        }
        if (rest.resting)
        {
            const double factor =
                now.constants(p.material, p.material).gammaFactor
               /materials_.constants(p.material, p.material).gammaFactor;
            rest.pullOff *= factor;
            rest.wakeForce *= std::min(factor, 1.0);
        }
        // of a rigid body, arms and contact forces are known as they were
        const bool wakes = rest.resting && wake.count(p.id) > 0;
        if (wakes || store_.flies(i)) rest.wakeForce = -1;
        r.woken += wakes;
        store_.changed(i);
    }
}


//- Deepest overlap of particle i at x with walls that it has no contact with [m]; 0: none
double Stiffening::unheldOverlap(std::size_t i, const Vec3& x) const
{
    const Particle& p = store_.particles[i];
    std::vector<WallHit> hits;
    std::vector<int> surfaces;
    const double range = (p.radius + store_.reach[i])*(1 + 1e-6);
    walls_.query(x.array() - range, x.array() + range, surfaces);
    walls_.hits(x, range, surfaces.data(), surfaces.size(), hits);
    for (const ContactRecord& c : store_.contacts[i])
    {
        const Vec3 normal(c.n[0], c.n[1], c.n[2]);
        auto held = hits.end();
        for (auto h = hits.begin(); h != hits.end(); ++h)
        {
            if (h->patch != c.wall) continue;
            if (held == hits.end() || h->n.dot(normal) > held->n.dot(normal)) held = h;
        }
        if (held != hits.end()) hits.erase(held);
    }
    double deepest = 0;
    for (const WallHit& h : hits) deepest = std::max(deepest, p.radius - h.distance);
    return deepest;
}


//- Those who came to touch others by being set aside
void Stiffening::lookAround
(
    const std::vector<Gap>& gaps, const Ways& ways, Restiffened& r
) const
{
    const auto way = [&](std::int64_t id)
    {
        const auto found = ways.find(id);
        return found == ways.end() ? Vec3(Vec3::Zero()) : found->second;
    };
    const auto note = [&](std::int64_t i, std::int64_t j, double was, double is, double radius)
    {
        // those who are set aside together overlap as before
        if (!(is > 0 && is - was > 1e-9*radius)) return;
        r.add(is/(2*radius), i, j);
    };
    std::set<std::pair<std::int64_t, std::int64_t>> touching;
    for (const Gap& g : gaps) touching.insert(std::minmax(g.i, g.j));

    std::vector<double> packed;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < store_.size(); ++i)
    {
        const Particle& p = store_.particles[i];
        boxes.push_back({p.x.array() - p.radius, p.x.array() + p.radius});
        if (!ways.count(p.id)) continue;
        pack(p, packed);
        const double was = unheldOverlap(i, p.x - way(p.id));
        note(p.id, -1, was, unheldOverlap(i, p.x), p.radius);
    }
    const BoxGrid grid(boxes, periodic_);
    for (const std::vector<double>& from : communicator_.allGather(packed))
    {
        for (const Particle& q : unpackAll<Particle>(from))
        {
            if (boxes.empty()) break;
            grid.overlapping({q.x.array() - q.radius, q.x.array() + q.radius}, [&](int k)
            {
                const Particle& p = store_.particles[std::size_t(k)];
                const auto pair = std::minmax(p.id, q.id);
                if (p.id == q.id || touching.count(pair)) return;
                const Vec3 d = periodic_.nearest(q.x - p.x);
                const double sum = p.radius + q.radius;
                const double was = sum - (d - way(q.id) + way(p.id)).norm();
                note(pair.first, pair.second, was, sum - d.norm(), std::min(p.radius, q.radius));
            });
        }
    }
}


Restiffened Stiffening::ofAllRanks(const Restiffened& mine) const
{
    Restiffened all;
    for (const std::vector<double>& v : communicator_.allGather
    ({
        double(mine.contacts), double(mine.similar), mine.normal, mine.springs, mine.farthest,
        mine.misfit, double(mine.woken), mine.newOverlap, double(mine.newI), double(mine.newJ)
    }))
    {
        all.contacts += std::int64_t(v[0]);
        all.similar += std::int64_t(v[1]);
        all.normal += v[2];
        all.springs += v[3];
        all.farthest = std::max(all.farthest, v[4]);
        all.misfit = std::max(all.misfit, v[5]);
        all.woken += std::int64_t(v[6]);
        all.add(v[7], std::int64_t(v[8]), std::int64_t(v[9]));
    }
    return all;
}


Restiffened Stiffening::to(double chi)
{
    MaterialTable now = materials_;
    now.setRatio(chi);
    Restiffened mine;
    std::vector<Contact> contacts = find();
    std::vector<double> packed;
    for (Contact& c : contacts)
    {
        aim(c, now);
        pack(gap(c), packed);
    }
    std::vector<Gap> gaps;
    for (const std::vector<double>& from : communicator_.allGather(packed))
    {
        for (const Gap& g : unpackAll<Gap>(from)) gaps.push_back(g);
    }
    const Ways ways = setAside(gaps);
    move(ways, takeOver(contacts, ways, now, mine), now, mine);
    lookAround(gaps, ways, mine);
    materials_ = std::move(now);
    return ofAllRanks(mine);
}

}
