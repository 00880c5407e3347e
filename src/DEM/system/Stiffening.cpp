// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/Stiffening.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"
#include "foundation/Fields.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dem
{

namespace
{

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
        result.push_back(c);
    });
    return result;
}


//- Find the overlap that it should have; whether it keeps its force
bool Stiffening::aim(Contact& c, const MaterialTable& now) const
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
    const double size = a0 > 0 ? a0*a0/(3*c.R) : std::fabs(c.before);
    const double further = l.normalResponse(cb, c.before + 1e-4*size, history).elastic;
    const bool rests = store_.rest[c.i].resting;
    const bool collides = !rests && was.elastic > l.pullOff(pair, before, c.R);

    c.after = c.before*std::pow(before.chi/after.chi, 0.4);
    if (!(was.radius > 0) || further < was.elastic || collides) return false;
    const std::optional<double> found = overlapFor
    (
        l, ca, was.elastic, size, -l.reach(pair, after, c.R)
    );
    if (found) c.after = *found;
    return found.has_value();
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


//- Where contacts close rings: set right in turn until all agree
void Stiffening::agree(const std::vector<Gap>& gaps, Ways& ways)
{
    constexpr int sweeps = 200;
    double widest = 0;
    for (const Gap& g : gaps) widest = std::max(widest, std::fabs(g.open));
    for (int k = 0; k < sweeps; ++k)
    {
        double worst = 0;
        for (const Gap& g : gaps)
        {
            Vec3& wi = ways[g.i];
            const double open = g.j < 0 ? -wi.dot(g.n) : (ways[g.j] - wi).dot(g.n);
            const double missing = g.open - open;
            worst = std::max(worst, std::fabs(missing));
            if (g.j < 0) wi -= missing*g.n;
            else
            {
                wi -= 0.5*missing*g.n;
                ways[g.j] += 0.5*missing*g.n;
            }
        }
        if (worst <= 1e-9*widest) break;
    }
}


//- From walls (where there is none, from the lowest id) along contacts each particle follows the
//  one before
Stiffening::Ways Stiffening::solve(std::vector<Gap> gaps)
{
    std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b)
    {
        return a.i < b.i || (a.i == b.i && a.j < b.j);
    });
    Ways ways;
    std::unordered_map<std::int64_t, std::vector<const Gap*>> of;
    std::vector<std::int64_t> order, ids;
    const auto reach = [&](std::int64_t id, const Vec3& way)
    {
        if (ways.emplace(id, way).second) order.push_back(id);
    };
    for (const Gap& g : gaps)
    {
        if (g.j < 0) reach(g.i, -g.open*g.n);
        else
        {
            of[g.i].push_back(&g);
            of[g.j].push_back(&g);
        }
        ids.push_back(g.i);
    }
    const auto grow = [&](std::size_t first)
    {
        for (std::size_t k = first; k < order.size(); ++k)
        {
            const std::int64_t id = order[k];
            const Vec3 way = ways[id];
            for (const Gap* g : of[id])
            {
                if (g->i == id) reach(g->j, way + g->open*g->n);
                else reach(g->i, way - g->open*g->n);
            }
        }
    };
    grow(0);
    std::vector<std::size_t> flying;    // where in order each cluster without a wall begins
    for (const std::int64_t id : ids)
    {
        if (ways.count(id)) continue;
        flying.push_back(order.size());
        reach(id, Vec3::Zero());
        grow(flying.back());
    }

    agree(gaps, ways);

    // the centre of mass of what flies stays
    std::unordered_map<std::int64_t, double> mass;
    for (const Gap& g : gaps)
    {
        mass[g.i] = g.mi;
        if (g.j >= 0) mass[g.j] = g.mj;
    }
    flying.push_back(order.size());
    for (std::size_t f = 0; f + 1 < flying.size(); ++f)
    {
        Vec3 sum = Vec3::Zero();
        double total = 0;
        for (std::size_t k = flying[f]; k < flying[f + 1]; ++k)
        {
            sum += mass[order[k]]*ways[order[k]];
            total += mass[order[k]];
        }
        for (std::size_t k = flying[f]; k < flying[f + 1]; ++k) ways[order[k]] -= sum/total;
    }
    return ways;
}


//- Springs and energies
void Stiffening::takeOver
(
    const std::vector<Contact>& contacts, const Ways& ways, const MaterialTable& now,
    Restiffened& r
)
{
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
        }
        law(c).scaleSprings(factors, history);

        const Vec3 wi = ways.at(store_.particles[c.i].id);
        const double open = (c.wall ? Vec3(-wi) : Vec3(ways.at(c.j.id) - wi)).dot(c.n);
        const double overlap = c.before - open;
        const ContactEnergy after = energy(c, now, overlap, history);
        r.normal += after.normal.stored - before.normal.stored;
        r.springs += after.inSprings() - before.inSprings();
        r.misfit = std::max
        (
            r.misfit, std::fabs(overlap - c.after)/std::max(std::fabs(c.after), 1e-300)
        );
        ++r.contacts;
    }
}


//- Particles to their places, and what else depends on chi
void Stiffening::move(const Ways& ways, const MaterialTable& now, Restiffened& r)
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
        if (store_.flies(i)) rest.wakeForce = -1;
        store_.changed(i);
    }
}


Restiffened Stiffening::ofAllRanks(const Restiffened& mine) const
{
    Restiffened all;
    for (const std::vector<double>& v : communicator_.allGather
    ({
        double(mine.contacts), double(mine.similar), mine.normal, mine.springs, mine.farthest,
        mine.misfit
    }))
    {
        all.contacts += std::int64_t(v[0]);
        all.similar += std::int64_t(v[1]);
        all.normal += v[2];
        all.springs += v[3];
        all.farthest = std::max(all.farthest, v[4]);
        all.misfit = std::max(all.misfit, v[5]);
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
        if (!aim(c, now)) ++mine.similar;
        const Particle& p = store_.particles[c.i];
        pack(Gap{p.id, c.wall ? -1 : c.j.id, c.n, c.before - c.after, p.mass, c.j.mass}, packed);
    }
    std::vector<Gap> gaps;
    for (const std::vector<double>& from : communicator_.allGather(packed))
    {
        for (const Gap& g : unpackAll<Gap>(from)) gaps.push_back(g);
    }
    const Ways ways = solve(std::move(gaps));
    takeOver(contacts, ways, now, mine);
    move(ways, now, mine);
    materials_ = std::move(now);
    return ofAllRanks(mine);
}

}
