// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/StiffestStep.hpp"

#include "timeIntegration/freeFlight.hpp"

#include <algorithm>

namespace dem
{

void StiffestStep::begin(const IslandState& state, double dt)
{
    speed_.reset();
    step_ = freeSpeed_ = 0;
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        const FlightFactors f(state.gas[k].Sp*state.bodies[k].invM, dt);
        freeSpeed_ = std::max
        (
            freeSpeed_, vec(state.bodies[k].v).norm() + accelerationBound(state, i)*f.p1
        );
    }
}


void StiffestStep::note(const IslandState& state, double longestStep)
{
    const double speed = std::max(state.phase.fastest, freeSpeed_);
    if (speed_ && speed <= *speed_) return;
    speed_ = speed;
    step_ = shortestPeriod(state, speed)*longestStep;
}


//- Of the lightest of each material, with each other and the walls
double StiffestStep::shortestPeriod(const IslandState& state, double speed) const
{
    const MaterialTable& materials = env_.materials;
    double shortest = 1e300;
    std::vector<const Particle*> lightest(materials.materials().size(), nullptr);
    for (const Particle& p : state.particles)
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
            const ContactFigures figures = materials.figures
            (
                p->material, q->material, p->radius, q->radius, p->mass, q->mass, 2*speed
            );
            shortest = std::min(shortest, figures.period);
        }
        for (const WallPatch& w : env_.walls.walls().patches)
        {
            const ContactFigures figures = materials.figures
            (
                p->material, w.material, p->radius, -1, p->mass, 0, speed,
                w.curvature.value_or(WallCurvature())
            );
            shortest = std::min(shortest, figures.period);
        }
    }
    return shortest;
}

}
