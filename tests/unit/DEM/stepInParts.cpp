// SPDX-License-Identifier: GPL-3.0-or-later
//
// A particle step in parts: wherever it is cut, it comes out as it does in one, as a collision is
// not cut in two.
#include "clouds.hpp"

#include <memory>

using scene::near;
using scene::sphere;
using dem::Vec3;

namespace
{

constexpr double r = 1e-6, step = 4e-6;

scene::Law dust()
{
    scene::Law law;
    law.friction = 0.3;
    law.criticalAngle = 0.01;
    return law;
}

//- In gas, far from each other: some that rebound from a floor, pairs that collide
std::vector<dem::Particle> scattered(const scene::Law& law)
{
    std::vector<dem::Particle> particles;
    scene::Random random(11);
    for (int k = 0; k < 8; ++k)
    {
        const Vec3 x(200*r*k, 0, random.uniform(2, 30)*r);
        const Vec3 v(random.uniform(-4, 4), 1, -random.uniform(10, 20));
        particles.push_back(sphere(law, 2*k, r, x, v, 1e5*random.inBox(1)));
        const Vec3 y(200*r*k, 200*r, 100*r), towards(random.uniform(3, 10)*r, 0.5*r, 0);
        particles.push_back(sphere(law, 2*k + 1, r, y, Vec3(random.uniform(5, 10), 0, 0)));
        particles.push_back(sphere(law, 100 + k, r, y + towards, Vec3(-3, 1, 0), 1e5*random.inBox(1)));
    }
    return particles;
}

struct End
{
    std::vector<dem::Particle> particles;
    std::int64_t touches = 0, behind = 0;
};

std::unique_ptr<dem::System> start
(
    const scene::Law& law, const std::vector<dem::Particle>& particles,
    const dem::System* goesOn = nullptr
)
{
    dem::TimeSettings time;
    auto system = std::make_unique<dem::System>(law.table(), time);
    system->setWalls(scene::floor());
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        system->add(particles[i], goesOn ? -goesOn->behind(i) : 0);
        dem::GasLoad load;
        load.Sp = 1e-11*(1 + double(i));
        load.Uc = Vec3(1, 0, -2);
        system->setGasLoad(i, load);
        if (goesOn) system->unpackState(i, goesOn->packState(i));
    }
    return system;
}

//- parts(left) [s]; restarts: every part in a system of its own
template<class Parts>
End run(Parts&& parts, bool restarts = false)
{
    const scene::Law law = dust();
    auto system = start(law, scattered(law));
    End end;
    const auto take = [&]
    {
        end.particles.clear();
        for (std::size_t i = 0; i < system->size(); ++i) end.particles.push_back(system->particle(i));
    };
    for (double left = step; left > 0;)
    {
        const double part = std::min(parts(left), left);
        const bool begins = left == step;
        left = left - part < 1e-9*step ? 0 : left - part;
        end.touches += system->advance(part, left, begins).touches;
        for (std::size_t i = 0; i < system->size(); ++i) end.behind += system->behind(i) > 0;
        if (!restarts) continue;
        take();
        system = start(law, end.particles, system.get());
    }
    take();
    return end;
}

double apart(const End& a, const End& b)
{
    double most = 0;
    for (std::size_t i = 0; i < a.particles.size(); ++i)
    {
        most = std::max(most, (a.particles[i].x - b.particles[i].x).norm());
    }
    return most;
}

}


TEST(stepInParts, whereItIsCutMakesNoDifference)
{
    const End whole = run([](double left) { return left; });
    EXPECT_EQ(whole.touches, 16);
    EXPECT_EQ(whole.behind, 0);
    std::int64_t behind = 0;
    for (const int n : {2, 3, 7, 20, 61, 200, 997})
    {
        const End parts = run([n](double) { return step/n; });
        EXPECT_EQ(parts.touches, whole.touches) << n;
        EXPECT_LE(apart(parts, whole), 1e-6*r) << n;
        behind += parts.behind;
    }
    EXPECT_GT(behind, 20);
}


TEST(stepInParts, aRestartBetweenTwoPartsChangesNoBit)
{
    for (const int n : {7, 61, 200})
    {
        const auto parts = [n](double) { return step/n; };
        EXPECT_EQ(apart(run(parts, true), run(parts)), 0) << n;
    }
}
