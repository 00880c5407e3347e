// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many-particle scenes for tests that compare one run with another, bit by bit.
#pragma once

#include "scene.hpp"

#include <algorithm>

namespace scene
{

//- Polystyrene with every part of the contact law, softened
inline Law stickyLaw()
{
    Law law;
    law.friction = 0.3;
    law.adhesionHysteresis = 0.4;
    law.twisting = true;
    law.softening.ratio = 0.01;
    return law;
}

//- Dust that rains on a floor: it collides in flight, sticks, slides and comes to rest.
//  Sizes 0.6 to 2 um, in a column half wide; ids are neither dense nor sorted.
inline std::vector<dem::Particle> rain(const Law& law, int n, double half, unsigned seed)
{
    Random random(seed);
    std::vector<dem::Particle> particles;
    while (int(particles.size()) < n)
    {
        const double r = random.uniform(0.3e-6, 1e-6);
        Vec3 x = random.inBox(half);
        x.z() = random.uniform(2e-6, 2e-6 + 2*half);
        bool free = true;
        for (const dem::Particle& p : particles)
        {
            free = free && (p.x - x).norm() > 1.05*(p.radius + r);
        }
        if (!free) continue;
        const Vec3 v = Vec3(0, 0, -0.8) + random.inBox(0.6);
        const int k = int(particles.size());
        particles.push_back
        (
            sphere(law, std::int64_t(7*((k*37)%n) + 3), r, x, v, random.inBox(1e5))
        );
    }
    return particles;
}

//- Stokes drag in air that blows along the floor and down to it, by id
inline dem::GasLoad breeze(const dem::Particle& p, double time)
{
    const double mu = 1.8e-5;
    dem::GasLoad g;
    g.Sp = 6*formula::pi*mu*p.radius;
    g.Uc = Vec3(0.1*std::sin(1e6*time + double(p.id)), 0.05, -0.2);
    g.SpOmega = 8*formula::pi*mu*p.radius*p.radius*p.radius;
    g.omegaC = Vec3(0, 1e3, 0);
    return g;
}

inline void load(dem::System& system)
{
    for (std::size_t i = 0; i < system.size(); ++i)
    {
        system.setGasLoad(i, breeze(system.particle(i), system.time()));
    }
}

//- The particles in order of id
inline std::vector<dem::Particle> sorted(const dem::System& system)
{
    std::vector<dem::Particle> p;
    for (std::size_t i = 0; i < system.size(); ++i) p.push_back(system.particle(i));
    std::sort
    (
        p.begin(), p.end(),
        [](const dem::Particle& a, const dem::Particle& b) { return a.id < b.id; }
    );
    return p;
}

inline bool same(const dem::Particle& a, const dem::Particle& b)
{
    return a.id == b.id && a.x == b.x && a.v == b.v && a.omega == b.omega;
}

}
