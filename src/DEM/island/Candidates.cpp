// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/Candidates.hpp"

#include <algorithm>

namespace dem
{

void Candidates::clear()
{
    corridors_.clear();
    walls_.clear();
}


void Candidates::addParticle(const Corridor& corridor)
{
    corridors_.push_back(corridor);
    walls_.addParticle();
}


void Candidates::find
(
    const IslandState& state, double dt, const std::vector<Partners>& resumed
)
{
    outran_.assign(state.particles.size(), 0);
    skin_ = {};
    smallest_ = 1e300;
    for (const Particle& p : state.particles) smallest_ = std::min(smallest_, p.radius);
    pairs_.find(state, corridors_, dt);
    pairs_.touching(state, resumed);
    pairs_.touchingAtRest(state);
}


void Candidates::refresh(IslandState& state, std::optional<double> contactStep)
{
    noteOutran(state);
    // enough for some steps, as fast as they are now
    skin_.width = 0.2*smallest_;
    if (contactStep)
    {
        const double way = 200*state.phase.fastest**contactStep;
        skin_.width = std::min(skin_.width, std::max(way, 1e-3*smallest_));
    }
    skin_.refreshed = skin_.path;
    pairs_.keepInBoxes(state, skin_, 0);
    pairs_.refresh(state, skin_);
    walls_.refresh(state, skin_.width);
    updateWalls(state);
}


void Candidates::look(IslandState& state, double h, std::optional<double> contactStep)
{
    if (!skin_.holds(state.phase.fastest*h)) refresh(state, contactStep);
}


void Candidates::follow(IslandState& state, double h, std::optional<double> contactStep)
{
    skin_.path += state.phase.fastest*h;
    if (skin_.holds()) updateWalls(state);
    else refresh(state, contactStep);
}


void Candidates::expect(const IslandState& state, double h)
{
    if (4*state.phase.fastest*h > skin_.width) pairs_.keepInBoxes(state, skin_, h);
}


std::vector<Touch> Candidates::meet(const IslandState& state)
{
    std::vector<Touch> touches;
    pairs_.meet(state, skin_, touches);
    walls_.meet(state, touches);
    return touches;
}


void Candidates::woken
(
    IslandState& state, const std::vector<int>& woken, const std::vector<Partners>& resumed
)
{
    pairs_.touching(state, resumed);
    walls_.woken(state, woken, skin_.width);
    pairs_.woken(state, woken, skin_);
    updateWalls(state);
}


void Candidates::asleep(const IslandState& state)
{
    pairs_.asleep(state);
    walls_.asleep(state);
}


void Candidates::noteOutran(const IslandState& state)
{
    const double elapsed = state.phase.elapsed;
    if (elapsed <= 0) return;
    for (std::size_t k = 0; k < state.bodies.size(); ++k)
    {
        const Corridor& c = corridors_[k];
        const double off =
            (vec(state.bodies[k].x) - state.particles[k].x - elapsed*c.v).norm();
        if (off > c.width(elapsed)) outran_[k] = std::max(outran_[k], off/elapsed);
    }
}

}
