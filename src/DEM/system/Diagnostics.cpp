// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/Diagnostics.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"
#include "foundation/Fields.hpp"

#include <algorithm>

namespace dem
{

Diagnostics::Partners Diagnostics::remotePartners() const
{
    Partners result;
    if (!communicator_.parallel()) return result;

    std::vector<double> wanted;
    for (const auto& list : store_.contacts)
    {
        for (const ContactRecord& c : list)
        {
            if (c.wall < 0 && !store_.indexOf.count(c.idJ)) wanted.push_back(double(c.idJ));
        }
    }
    const auto asked = communicator_.allGather(wanted);
    std::vector<std::vector<double>> answers(std::size_t(communicator_.size()));
    for (int r = 0; r < communicator_.size(); ++r)
    {
        for (const double id : asked[std::size_t(r)])
        {
            const auto found = store_.indexOf.find(std::int64_t(id));
            if (found == store_.indexOf.end()) continue;
            pack(store_.particles[found->second], answers[std::size_t(r)]);
        }
    }
    for (const auto& from : communicator_.exchange(answers))
    {
        for (const Particle& p : unpackAll<Particle>(from)) result.emplace(p.id, p);
    }
    return result;
}


double Diagnostics::wallOverlap(std::size_t i, const ContactRecord& c) const
{
    const Particle& p = store_.particles[i];
    const Vec3 normal(c.n[0], c.n[1], c.n[2]);
    std::vector<WallHit> hits;
    std::vector<int> surfaces;
    const double range = p.radius + store_.reach[i];
    walls_.query(p.x.array() - range, p.x.array() + range, surfaces);
    walls_.hits(p.x, range*(1 + 1e-6), surfaces.data(), surfaces.size(), hits);
    double best = -2, overlap = 0;
    for (const WallHit& h : hits)
    {
        const double alike = h.n.dot(normal);
        if (h.patch == c.wall && alike > best)
        {
            best = alike;
            overlap = p.radius - h.distance;
        }
    }
    return overlap;
}


ContactView Diagnostics::view(std::size_t i, const ContactRecord& c, const Particle* j) const
{
    const Particle& p = store_.particles[i];
    const bool wall = !j;
    const Particle& q = wall ? p : *j;
    const Walls& walls = walls_.walls();
    const int mj = wall ? walls.patches[std::size_t(c.wall)].material : q.material;
    const PairConstants& pair = materials_.constants(p.material, mj);
    const ContactLaw& law = *materials_.laws()[std::size_t(materials_.lawIndex(p.material, mj))];
    const double R =
        wall
      ? materials_.wallRadius(p.material, mj, walls.curvature(c.wall), p.radius)
      : p.radius*q.radius/(p.radius + q.radius);
    const double m = wall ? p.mass : p.mass*q.mass/(p.mass + q.mass);
    double constants[maxConstants];
    const int pairInLaw = materials_.pairInLaw(p.material, mj);
    law.prepare(pairInLaw, {pair, R, m, wall ? p.radius : R}, constants);

    // the kernels work on a copy of the history
    Body bodies[2] = {};
    Load loads[2] = {};
    for (int k = 0; k < 2; ++k)
    {
        const Particle& a = k ? q : p;
        std::copy(a.x.data(), a.x.data() + 3, bodies[k].x);
        std::copy(a.v.data(), a.v.data() + 3, bodies[k].v);
        std::copy(a.omega.data(), a.omega.data() + 3, bodies[k].w);
        bodies[k].r = a.radius;
    }
    ContactList list;
    list.setUp(law.nConstants(), law.nHistory(), wall);
    list.append(0, wall ? c.wall : 1, 0, constants, c.history);

    ContactView v;
    v.idI = p.id;
    v.idJ = wall ? -1 : q.id;
    v.wall = c.wall;
    if (wall)
    {
        v.normal = Vec3(c.n[0], c.n[1], c.n[2]);
        v.overlap = wallOverlap(i, c);
        list.nx[0] = c.n[0];
        list.ny[0] = c.n[1];
        list.nz[0] = c.n[2];
        list.overlap[0] = v.overlap;
        law.evaluateWalls(list, 0, 1, bodies, loads, {}, 1);
    }
    else
    {
        const Vec3 d = periodic_.nearest(q.x - p.x);
        v.normal = d.normalized();
        v.overlap = p.radius + q.radius - d.norm();
        law.evaluatePairs(list, 0, 1, bodies, loads, {}, 1, periodic_);
    }
    v.point = p.x + (p.radius - 0.5*v.overlap)*v.normal;
    v.force = Vec3(loads[0].f[0], loads[0].f[1], loads[0].f[2]);
    double history[maxHistory];
    std::copy(c.history, c.history + maxHistory, history);
    const NormalResponse<double> normal = law.normalResponse(constants, v.overlap, history);
    v.contactRadius = normal.radius;
    v.pullOff = law.elastic() ? law.pullOff(pairInLaw, pair, R) : normal.pullOff;
    v.resting = store_.rest[i].resting;
    return v;
}


void Diagnostics::eachContact
(
    const std::function<void(std::size_t i, std::size_t k, const Particle* j)>& f
) const
{
    const Partners remote = remotePartners();
    for (std::size_t i = 0; i < store_.size(); ++i)
    {
        for (std::size_t k = 0; k < store_.contacts[i].size(); ++k)
        {
            const ContactRecord& c = store_.contacts[i][k];
            if (c.wall >= 0)
            {
                f(i, k, nullptr);
                continue;
            }
            const auto local = store_.indexOf.find(c.idJ);
            const auto there = remote.find(c.idJ);
            // else its partner has left the system
            if (local != store_.indexOf.end()) f(i, k, &store_.particles[local->second]);
            else if (there != remote.end()) f(i, k, &there->second);
        }
    }
}


double Diagnostics::overlap(std::size_t i, const ContactRecord& c, const Particle* j) const
{
    if (!j) return wallOverlap(i, c);
    const Particle& p = store_.particles[i];
    return p.radius + j->radius - periodic_.nearest(j->x - p.x).norm();
}


std::vector<ContactView> Diagnostics::contacts() const
{
    std::vector<ContactView> result;
    eachContact([&](std::size_t i, std::size_t k, const Particle* j)
    {
        const ContactRecord& c = store_.contacts[i][k];
        if (j || !walls_.walls().mirrors(c.wall)) result.push_back(view(i, c, j));
    });
    return result;
}


std::vector<double> Diagnostics::adhesionMargins() const
{
    ClusterGraph graph;
    for (std::size_t i = 0; i < store_.size(); ++i)
    {
        if (!store_.rest[i].inContact) continue;
        const Particle& p = store_.particles[i];
        const GasLoad& g = store_.gas[i];
        graph.nodes.push_back({p.id, p.mass, g.Sp*(g.Uc - p.v) + g.Su});
    }
    for (const ContactView& c : contacts()) graph.bonds.push_back({c.idI, c.idJ, c.pullOff});
    return clusterMargins(graph.gathered(communicator_));
}


std::vector<ClusterLabel> Diagnostics::clusters() const
{
    ClusterGraph graph;
    for (std::size_t i = 0; i < store_.size(); ++i)
    {
        for (const ContactRecord& c : store_.contacts[i])
        {
            const bool wall = c.wall >= 0;
            if (wall && walls_.walls().mirrors(c.wall)) continue;
            graph.bonds.push_back({store_.particles[i].id, wall ? -1 : c.idJ, 0});
        }
    }
    const auto labels = clusterLabels(graph.everywhere(communicator_));

    std::vector<ClusterLabel> result;
    for (const Particle& p : store_.particles)
    {
        const auto found = labels.find(p.id);
        result.push_back(found == labels.end() ? ClusterLabel{p.id, false} : found->second);
    }
    return result;
}

}
