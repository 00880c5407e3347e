// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/WallCandidates.hpp"

#include <algorithm>

namespace dem
{

namespace
{

// Old and new normals of one wall contact differ by less than 60 degrees
constexpr double sameNormal = 0.5;

}


void WallCandidates::clear()
{
    surfaceEnd_.clear();
    surfaces_.clear();

    // the walls may have been set since the last island
    const auto& patches = env_.walls.walls().patches;
    const int nMaterials = int(env_.materials.materials().size());
    touch_.assign(std::size_t(nMaterials), std::vector<double>(patches.size()));
    for (int m = 0; m < nMaterials; ++m)
    {
        for (std::size_t p = 0; p < patches.size(); ++p)
        {
            touch_[std::size_t(m)][p] = env_.materials.touchDistance(m, patches[p].material);
        }
    }
}


void WallCandidates::addSurfaces(const std::vector<int>& surfaces)
{
    surfaces_.insert(surfaces_.end(), surfaces.begin(), surfaces.end());
    surfaceEnd_.back() = surfaces_.size();
}


void WallCandidates::findNear(const IslandState& state, int i, double skin)
{
    const std::size_t k = std::size_t(i);
    nearSurfaces_[k].clear();
    hits_[k].clear();
    const double range = state.particles[k].radius + state.reach[k] + skin;
    for (std::size_t s = first(k); s < surfaceEnd_[k]; ++s)
    {
        if (env_.walls.within(surfaces_[s], vec(state.bodies[k].x), range))
        {
            nearSurfaces_[k].push_back(surfaces_[s]);
        }
    }
    if (!nearSurfaces_[k].empty()) near_.push_back(i);
}


void WallCandidates::refresh(const IslandState& state, double skin)
{
    const std::size_t n = state.particles.size();
    near_.clear();
    nearSurfaces_.resize(n);
    hits_.resize(n);
    taken_.resize(n);
    for (const int i : state.awake) findNear(state, i, skin);
}


void WallCandidates::woken
(
    const IslandState& state, const std::vector<int>& woken, double skin
)
{
    for (const int i : woken) findNear(state, i, skin);
    std::sort(near_.begin(), near_.end());
}


void WallCandidates::asleep(const IslandState& state)
{
    near_.erase
    (
        std::remove_if
        (
            near_.begin(), near_.end(),
            [&](int i) { return state.rest[std::size_t(i)].resting; }
        ),
        near_.end()
    );
}


//- Returns whether there are any
bool WallCandidates::findHits(const IslandState& state, double skin)
{
    bool any = false;
    for (const int i : near_)
    {
        const std::size_t k = std::size_t(i);
        env_.walls.hits
        (
            vec(state.bodies[k].x), state.particles[k].radius + state.reach[k] + 0.5*skin,
            nearSurfaces_[k].data(), nearSurfaces_[k].size(), hits_[k]
        );
        taken_[k].assign(hits_[k].size(), 0);
        any = any || !hits_[k].empty();
    }
    return any;
}


//- The place without a contact whose normal is most like that of contact k; -1: none
int WallCandidates::alike(const ContactList& list, std::size_t k, bool anyPatch) const
{
    const std::size_t i = std::size_t(list.i[k]);
    const Vec3 old(list.nx[k], list.ny[k], list.nz[k]);
    int best = -1;
    double most = sameNormal;
    for (std::size_t c = 0; c < hits_[i].size(); ++c)
    {
        const WallHit& hit = hits_[i][c];
        const double cosine = old.dot(hit.n);
        if (!taken_[i][c] && (anyPatch || hit.patch == list.j[k]) && cosine > most)
        {
            most = cosine;
            best = int(c);
        }
    }
    return best;
}


void WallCandidates::follow
(
    const IslandState& state, ContactList& list, std::size_t k, int hit
)
{
    const std::size_t i = std::size_t(list.i[k]);
    const WallHit& h = hits_[i][std::size_t(hit)];
    taken_[i][std::size_t(hit)] = 1;
    list.nx[k] = h.n.x();
    list.ny[k] = h.n.y();
    list.nz[k] = h.n.z();
    list.overlap[k] = state.particles[i].radius - h.distance;
}


void WallCandidates::followElsewhere(IslandState& state)
{
    const Contacts contacts(env_);
    for (const Lost& lost : lost_)
    {
        ContactList& list = state.contacts.lists[lost.law].walls;
        const std::size_t k = lost.k, i = std::size_t(list.i[k]);
        const int best = alike(list, k, true);
        if
        (
            best >= 0
         && contacts.handOver(state, lost.law, k, hits_[i][std::size_t(best)].patch)
        ) follow(state, list, k, best);
        else
        {
            // nothing of this wall is within reach any more
            const ContactEntry& e = state.contacts.entry(list, k);
            list.overlap[k] = -(1 + 1e-6)*e.neck - 1e-9*state.particles[i].radius;
        }
    }
}


void WallCandidates::update(IslandState& state, double skin)
{
    const bool any = findHits(state, skin);
    lost_.clear();
    for (std::size_t l = 0; l < state.contacts.lists.size(); ++l)
    {
        ContactList& list = state.contacts.lists[l].walls;
        for (std::size_t k = 0; k < list.size(); ++k)
        {
            const int best = any ? alike(list, k, false) : -1;
            if (best >= 0) follow(state, list, k, best);
            else lost_.push_back({l, k});
        }
    }
    if (!lost_.empty()) followElsewhere(state);
}


void WallCandidates::meet(const IslandState& state, std::vector<Touch>& touches)
{
    for (const int i : near_)
    {
        const std::size_t k = std::size_t(i);
        const double r = state.particles[k].radius;
        for (std::size_t c = 0; c < hits_[k].size(); ++c)
        {
            const WallHit& hit = hits_[k][c];
            if (taken_[k][c] || hit.distance > r + touch(state, i, hit.patch)) continue;
            taken_[k][c] = 1;
            touches.push_back({i, -1, hit.patch, hit.n, r - hit.distance});
        }
    }
}


const WallHit* WallCandidates::continues
(
    const IslandState& state, int i, int patch, const Vec3& n, std::vector<WallHit>& scratch
) const
{
    const std::size_t k = std::size_t(i);
    const Body& b = state.bodies[k];
    env_.walls.hits
    (
        vec(b.x), b.r + state.reach[k], surfaces_.data() + first(k),
        surfaceEnd_[k] - first(k), scratch
    );
    const WallHit* result = nullptr;
    double best = sameNormal;
    for (const WallHit& h : scratch)
    {
        const double alike = h.n.dot(n);
        if (h.patch != patch || alike < best) continue;
        best = alike;
        result = &h;
    }
    return result;
}


double WallCandidates::timeToTouch(const IslandState& state, int i) const
{
    const std::size_t k = std::size_t(i);
    const Body& b = state.bodies[k];
    return env_.walls.timeToTouch
    (
        vec(b.x), vec(b.v), accelerationBound(state, i), b.r,
        touch_[std::size_t(state.particles[k].material)], surfaces_.data() + first(k),
        surfaceEnd_[k] - first(k)
    );
}


bool WallCandidates::mayReach(const IslandState& state, int i, double way, double skin) const
{
    const std::size_t k = std::size_t(i);
    const Body& b = state.bodies[k];
    for (std::size_t s = first(k); s < surfaceEnd_[k]; ++s)
    {
        const double size = b.r + state.reach[k];
        // one within reach is watched step by step
        if
        (
            env_.walls.within(surfaces_[s], vec(b.x), size + way)
         && !env_.walls.within(surfaces_[s], vec(b.x), size + 0.5*skin)
        ) return true;
    }
    return false;
}

}
