// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/Contacts.hpp"

#include <algorithm>

namespace dem
{

namespace
{

//- Other constants for contact k
void setConstants(ContactList& list, std::size_t k, const double* c)
{
    for (std::size_t a = 0; a < list.constants.size(); ++a)
    {
        std::vector<double>& column = list.constants[a];
        list.same[a] = column.size() == 1 || (list.same[a] && column[k] == c[a]);
        column[k] = c[a];
    }
}

}


void Contacts::setUp(ContactStore& store) const
{
    store.lists.resize(env_.materials.laws().size());
    for (std::size_t l = 0; l < store.lists.size(); ++l)
    {
        const ContactLaw& law = env_.law(l);
        store.lists[l].pairs.setUp(law.nConstants(), law.nHistory(), false);
        store.lists[l].walls.setUp(law.nConstants(), law.nHistory(), true);
    }
}


void Contacts::constants
(
    const IslandState& state, int i, int j, int patch, int materialJ, double* c
) const
{
    const MaterialTable& materials = env_.materials;
    const Particle& p = state.particles[std::size_t(i)];
    const int mi = p.material;
    ContactScale scale{materials.constants(mi, materialJ), p.radius, p.mass};
    if (j >= 0)
    {
        const Particle& q = state.particles[std::size_t(j)];
        scale.R = p.radius*q.radius/(p.radius + q.radius);
        scale.m = p.mass*q.mass/(p.mass + q.mass);
    }
    else
    {
        scale.rolling = p.radius;
        scale.R = materials.wallRadius
        (
            mi, materialJ, env_.walls.walls().curvature(patch), p.radius
        );
    }
    env_.law(std::size_t(materials.lawIndex(mi, materialJ))).prepare
    (
        materials.pairInLaw(mi, materialJ), scale, c
    );
}


//- And the constants in its law
ContactEntry Contacts::entry
(
    const IslandState& state, int i, int j, int patch, double* c
) const
{
    const MaterialTable& materials = env_.materials;
    const Particle& p = state.particles[std::size_t(i)];
    const Body& bi = state.bodies[std::size_t(i)];
    ContactEntry e;
    if (j < 0)
    {
        e.materialJ = env_.wallMaterial(patch);
        e.R = materials.wallRadius
        (
            p.material, e.materialJ, env_.walls.walls().curvature(patch), p.radius
        );
        e.m = p.mass;
        e.turning = 0.5*bi.r*bi.invI;
    }
    else
    {
        const Particle& q = state.particles[std::size_t(j)];
        e.materialJ = q.material;
        e.R = p.radius*q.radius/(p.radius + q.radius);
        e.m = p.mass*q.mass/(p.mass + q.mass);
        const Body& bj = state.bodies[std::size_t(j)];
        e.turning = 0.5*(bi.r*bi.invI + bj.r*bj.invI);
    }
    const PairConstants& pair = materials.constants(p.material, e.materialJ);
    const ContactLaw& law =
        env_.law(std::size_t(materials.lawIndex(p.material, e.materialJ)));
    const int pairInLaw = materials.pairInLaw(p.material, e.materialJ);
    e.neck = law.reach(pairInLaw, pair, e.R);
    // dashpots begin with the spot, which a neck keeps to its end
    e.edge = law.touchDistance(pairInLaw, pair) > 0 ? 0 : -e.neck;
    e.pullOff = law.pullOff(pairInLaw, pair, e.R);
    e.a0 = law.equilibriumRadius(pairInLaw, pair, e.R);
    constants(state, i, j, patch, e.materialJ, c);
    e.yield = law.rollingYield(c, j < 0 ? p.radius : e.R);
    return e;
}


//- Returns the list that it is the last of
ContactList& Contacts::begin
(
    IslandState& state, int i, int j, int patch, const ContactRecord* record
) const
{
    ContactStore& store = state.contacts;
    const Particle& p = state.particles[std::size_t(i)];
    const bool wall = j < 0;
    double c[maxConstants];
    const ContactEntry e = entry(state, i, j, patch, c);
    const int l = env_.materials.lawIndex(p.material, e.materialJ);

    int tag;
    if (store.freeTags.empty())
    {
        tag = int(store.entries.size());
        store.entries.push_back(e);
    }
    else
    {
        tag = store.freeTags.back();
        store.freeTags.pop_back();
        store.entries[std::size_t(tag)] = e;
    }

    ContactStore::Lists& lists = store.lists[std::size_t(l)];
    ContactList& list = wall ? lists.walls : lists.pairs;
    list.append(i, wall ? patch : j, tag, c, record ? record->history : nullptr);
    if (wall && record)
    {
        list.nx.back() = record->n[0];
        list.ny.back() = record->n[1];
        list.nz.back() = record->n[2];
    }
    return list;
}


void Contacts::begin(IslandState& state, const std::vector<Touch>& touches) const
{
    for (const Touch& t : touches)
    {
        ContactList& list = begin(state, t.i, t.j, t.patch, nullptr);
        if (t.j >= 0) continue;
        list.nx.back() = t.n.x();
        list.ny.back() = t.n.y();
        list.nz.back() = t.n.z();
        list.overlap.back() = t.overlap;
    }
}


bool Contacts::handOver
(
    IslandState& state, std::size_t law, std::size_t k, int patch
) const
{
    ContactList& list = state.contacts.lists[law].walls;
    const int i = list.i[k];
    const int material = state.particles[std::size_t(i)].material;
    if (env_.materials.lawIndex(material, env_.wallMaterial(patch)) != int(law)) return false;
    double c[maxConstants];
    state.contacts.entries[std::size_t(list.tag[k])] = entry(state, i, -1, patch, c);
    setConstants(list, k, c);
    list.j[k] = patch;
    return true;
}


void Contacts::remove(ContactStore& store, ContactList& list, std::size_t k) const
{
    store.freeTags.push_back(list.tag[k]);
    list.swap(k, list.size() - 1);
    list.popBack();
}


std::vector<Partners> Contacts::end(IslandState& state) const
{
    std::vector<Partners> ended;
    for (ContactStore::Lists& lists : state.contacts.lists)
    {
        for (ContactList* list : {&lists.pairs, &lists.walls})
        {
            for (std::size_t k = list->size(); k-- > 0;)
            {
                if (!list->ended[k]) continue;
                ended.push_back(partners(*list, k));
                remove(state.contacts, *list, k);
            }
        }
    }
    return ended;
}


void Contacts::store(IslandState& state, const ContactList& list, std::size_t k) const
{
    ContactStore& store = state.contacts;
    const Partners p = partners(list, k);
    StoredContact s;
    s.j = p.j;
    s.record.idJ = p.j < 0 ? -1 : state.particles[std::size_t(p.j)].id;
    s.record.wall = p.j < 0 ? list.j[k] : -1;
    for (double& n : s.record.n) n = 0;
    for (double& h : s.record.history) h = 0;
    if (p.j < 0)
    {
        s.record.n[0] = list.nx[k];
        s.record.n[1] = list.ny[k];
        s.record.n[2] = list.nz[k];
    }
    for (std::size_t h = 0; h < list.history.size(); ++h)
    {
        s.record.history[h] = list.history[h][k];
    }
    store.stored[std::size_t(p.i)].push_back(s);
    ++store.version[std::size_t(p.i)];
    if (p.j < 0) return;
    store.holders[std::size_t(p.j)].push_back(p.i);
    ++store.version[std::size_t(p.j)];
}


void Contacts::resume
(
    IslandState& state, std::size_t i, std::vector<Partners>& resumed
) const
{
    ContactStore& store = state.contacts;
    std::vector<StoredContact>& stored = store.stored[i];
    std::size_t kept = 0;
    for (std::size_t s = 0; s < stored.size(); ++s)
    {
        const StoredContact c = stored[s];
        if (state.rest[i].resting && (c.j < 0 || state.rest[std::size_t(c.j)].resting))
        {
            stored[kept++] = c;
            continue;
        }
        ++store.version[i];
        if (c.j >= 0)
        {
            std::vector<int>& holders = store.holders[std::size_t(c.j)];
            holders.erase(std::remove(holders.begin(), holders.end(), int(i)), holders.end());
            ++store.version[std::size_t(c.j)];
            resumed.push_back({int(i), c.j});
        }
        begin(state, int(i), c.j, c.record.wall, &c.record);
    }
    stored.resize(kept);
}


std::vector<Partners> Contacts::resumeAll(IslandState& state) const
{
    ContactStore& store = state.contacts;
    const std::size_t n = state.particles.size();
    store.version.assign(n, 0);
    store.holders.resize(n);
    for (auto& h : store.holders) h.clear();
    std::vector<Partners> resumed;
    for (std::size_t i = 0; i < n; ++i) resume(state, i, resumed);
    for (std::size_t i = 0; i < n; ++i)
    {
        for (const StoredContact& s : store.stored[i])
        {
            if (s.j >= 0) store.holders[std::size_t(s.j)].push_back(int(i));
        }
    }
    return resumed;
}


std::vector<Partners> Contacts::resume(IslandState& state, const std::vector<int>& woken) const
{
    std::vector<Partners> resumed;
    std::vector<int> holders;
    for (const int i : woken)
    {
        const std::size_t k = std::size_t(i);
        resume(state, k, resumed);
        holders.swap(state.contacts.holders[k]);
        for (const int h : holders) resume(state, std::size_t(h), resumed);
        holders.clear();
    }
    return resumed;
}


void Contacts::putToRest(IslandState& state) const
{
    const auto resting = [&](int i) { return state.rest[std::size_t(i)].resting; };
    for (ContactStore::Lists& lists : state.contacts.lists)
    {
        for (ContactList* list : {&lists.pairs, &lists.walls})
        {
            for (std::size_t k = list->size(); k-- > 0;)
            {
                const Partners p = partners(*list, k);
                if (!resting(p.i) || (p.j >= 0 && !resting(p.j))) continue;
                store(state, *list, k);
                remove(state.contacts, *list, k);
            }
        }
    }
}


void Contacts::storeAll(IslandState& state) const
{
    state.contacts.each([&](std::size_t, const ContactList& list, std::size_t k)
    {
        store(state, list, k);
    });
    const auto before = [](const StoredContact& a, const StoredContact& b)
    {
        const ContactRecord &p = a.record, &q = b.record;
        return
            p.idJ < q.idJ
         || (p.idJ == q.idJ && std::lexicographical_compare(p.n, p.n + 3, q.n, q.n + 3));
    };
    for (auto& s : state.contacts.stored) std::stable_sort(s.begin(), s.end(), before);
}

}
