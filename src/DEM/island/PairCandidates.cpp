// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/PairCandidates.hpp"

#include "timeIntegration/freeFlight.hpp"

#include <algorithm>

namespace dem
{

namespace
{

// Up to so many particles, all pairs are looked at for candidates
constexpr std::size_t fewParticles = 8;

// With more than so many, candidates are looked for close by, and again for those that get
// farther from the path they have on their own than this [radii]
constexpr std::size_t manyParticles = 32;
constexpr double roaming = 0.3;

Box around(const Box& box, double by)
{
    return {box.low.array() - by, box.high.array() + by};
}

bool bothRest(const IslandState& state, const Candidate& c)
{
    return state.rest[std::size_t(c.i)].resting && state.rest[std::size_t(c.j)].resting;
}

}


void PairCandidates::setBoxes
(
    const IslandState& state, const std::vector<Corridor>& corridors, double dt
)
{
    const std::size_t n = state.particles.size();
    boxes_.resize(n);
    whole_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        const Particle& p = state.particles[i];
        const double margin = roaming*p.radius;
        const Corridor& corridor = corridors[i];
        const Vec3 end = p.x + dt*corridor.v;
        const double width = corridor.width(dt);
        Vec3 low = p.x.cwiseMin(end), high = p.x.cwiseMax(end);
        whole_[i] = n <= manyParticles || width + (high - low).maxCoeff() <= margin;
        if (!whole_[i])
        {
            low = high = p.x;
            if (!state.rest[i].resting) flightBox(p, state.gas[i], dt, low, high);
        }
        const double half = p.radius + state.reach[i] + (whole_[i] ? width : margin);
        boxes_[i] = {low.array() - half, high.array() + half};
    }
}


void PairCandidates::find
(
    const IslandState& state, const std::vector<Corridor>& corridors, double dt
)
{
    const std::size_t n = state.particles.size();
    setBoxes(state, corridors, dt);
    list_.clear();
    due_.clear();
    near_.clear();
    marked_.assign(n, 0);
    grid_.reset();
    if (n <= fewParticles)
    {
        for (std::size_t i = 0; i < n; ++i)
        {
            for (std::size_t j = i + 1; j < n; ++j)
            {
                const Box &a = boxes_[i], &b = boxes_[j];
                const Vec3 twice =
                    env_.periodic.nearest(0.5*(b.low + b.high - a.low - a.high))*2;
                const Vec3 widths = a.high - a.low + b.high - b.low;
                if ((twice.array().abs() <= widths.array()).all()) add(state, int(i), int(j));
            }
        }
    }
    else
    {
        grid_ = std::make_unique<BoxGrid>(boxes_, env_.periodic);
        std::vector<std::vector<int>> partners(n);
        grid_->pairs([&](int i, int j) { partners[std::size_t(i)].push_back(j); });
        for (std::size_t i = 0; i < n; ++i)
        {
            std::vector<int>& of = partners[i];
            std::sort(of.begin(), of.end());
            if (env_.periodic.on()) of.erase(std::unique(of.begin(), of.end()), of.end());
            for (const int j : of) add(state, int(i), j);
        }
    }
    sorted_ = list_.size();
}


void PairCandidates::add(const IslandState& state, int i, int j)
{
    const int mi = state.particles[std::size_t(i)].material;
    const int mj = state.particles[std::size_t(j)].material;
    list_.push_back({i, j, false, env_.materials.touchDistance(mi, mj)});
    due_.push_back(0);
}


void PairCandidates::keepInBoxes(const IslandState& state, const Skin& skin, double time)
{
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        if (whole_[k]) continue;
        const Body& b = state.bodies[k];
        const double half = b.r + state.reach[k] + 0.5*skin.width;
        Box path{vec(b.x), vec(b.x)};
        const auto fly = [&](double t)
        {
            Particle p = state.particles[k];
            p.x = vec(b.x);
            p.v = vec(b.v);
            flightBox(p, state.gas[k], t, path.low, path.high);
        };
        if (time > 0) fly(time);
        if (boxes_[k].contains(around(path, half))) continue;
        // as far, at least, as it flies in the time of a radius
        const double speed = vec(b.v).norm();
        fly(std::max(time, std::min(state.phase.left, b.r/std::max(speed, 1e-300))));
        widen(state, i, around(path, b.r + state.reach[k] + roaming*b.r));
    }
}


//- Let particle i go along `path`, its surface included
void PairCandidates::widen(const IslandState& state, int i, const Box& path)
{
    const std::size_t k = std::size_t(i);
    Box& box = boxes_[k];
    box.include(path);
    grid_->changed(i);

    static thread_local std::vector<int> known, found;
    known.assign(1, i);
    found.clear();
    for (const Candidate& c : list_)
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
    for (const int j : found) add(state, std::min(i, j), std::max(i, j));
}


std::size_t PairCandidates::find(const IslandState& state, int i, int j) const
{
    const auto end = list_.begin() + std::ptrdiff_t(sorted_);
    auto found = std::lower_bound
    (
        list_.begin(), end, Partners{i, j},
        [](const Candidate& a, const Partners& b)
        {
            return a.i < b.i || (a.i == b.i && a.j < b.j);
        }
    );
    if (found == end || found->i != i || found->j != j)
    {
        found = std::find_if
        (
            end, list_.end(), [&](const Candidate& c) { return c.i == i && c.j == j; }
        );
    }
    if (found == list_.end())
    {
        fail(state, "is farther than its law reaches", i, j, 0);
    }
    return std::size_t(found - list_.begin());
}


void PairCandidates::touching(const IslandState& state, const std::vector<Partners>& pairs)
{
    for (const Partners& p : pairs) list_[find(state, p.i, p.j)].touching = true;
}


void PairCandidates::touchingAtRest(const IslandState& state)
{
    for (Candidate& c : list_)
    {
        if (!state.rest[std::size_t(c.i)].resting) continue;
        for (const StoredContact& s : state.contacts.stored[std::size_t(c.i)])
        {
            if (s.j == c.j) c.touching = true;
        }
    }
}


void PairCandidates::parted
(
    const IslandState& state, const std::vector<Partners>& pairs, const Skin& skin
)
{
    for (const Partners& p : pairs)
    {
        if (p.j < 0) continue;
        const std::size_t c = find(state, p.i, p.j);
        list_[c].touching = false;
        near_.push_back({int(c), skin.path});
    }
}


bool PairCandidates::meets(const IslandState& state, const Candidate& c) const
{
    const Body& a = state.bodies[std::size_t(c.i)];
    const Body& b = state.bodies[std::size_t(c.j)];
    const double sum = a.r + b.r + c.touch;
    return env_.periodic.nearest(vec(b.x) - vec(a.x)).squaredNorm() <= sum*sum;
}


//- Whether a pair is within the skin. Two particles close no more than twice the path of the
//  fastest, so most need not be looked at.
bool PairCandidates::comesNear(const IslandState& state, std::size_t c, const Skin& skin)
{
    double& due = due_[c];
    const double horizon = skin.path + 0.5*skin.width;
    if (due <= horizon) due = skin.path + 0.5*gap(state, list_[c]);
    return due <= horizon;
}


void PairCandidates::refresh(const IslandState& state, const Skin& skin)
{
    near_.clear();
    for (std::size_t c = 0; c < list_.size(); ++c)
    {
        if (due_[c] > skin.path + 0.5*skin.width) continue;
        const Candidate& k = list_[c];
        if (k.touching || bothRest(state, k)) continue;
        if (comesNear(state, c, skin)) near_.push_back({int(c), due_[c]});
    }
}


void PairCandidates::woken
(
    const IslandState& state, const std::vector<int>& woken, const Skin& skin
)
{
    for (const int i : woken) marked_[std::size_t(i)] = 1;
    for (std::size_t c = 0; c < list_.size(); ++c)
    {
        const Candidate& k = list_[c];
        const char i = marked_[std::size_t(k.i)], j = marked_[std::size_t(k.j)];
        if (!(i | j) || k.touching) continue;
        // with a partner that was awake before, it is there already
        const bool both = i && j;
        if (!both && !state.rest[std::size_t(i ? k.j : k.i)].resting) continue;
        if (comesNear(state, c, skin)) near_.push_back({int(c), due_[c]});
    }
    for (const int i : woken) marked_[std::size_t(i)] = 0;
}


void PairCandidates::asleep(const IslandState& state)
{
    near_.erase
    (
        std::remove_if
        (
            near_.begin(), near_.end(),
            [&](const Near& n)
            {
                const Candidate& k = list_[std::size_t(n.candidate)];
                return k.touching || bothRest(state, k);
            }
        ),
        near_.end()
    );
}


void PairCandidates::meet
(
    const IslandState& state, const Skin& skin, std::vector<Touch>& touches
)
{
    for (Near& near : near_)
    {
        if (near.due > skin.path) continue;
        Candidate& pair = list_[std::size_t(near.candidate)];
        if (pair.touching) continue;
        if (!meets(state, pair))
        {
            near.due = skin.path + 0.5*gap(state, pair);
            continue;
        }
        pair.touching = true;
        touches.push_back({pair.i, pair.j, -1, Vec3::Zero(), 0});
    }
}

}
