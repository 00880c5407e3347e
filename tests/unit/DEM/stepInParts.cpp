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


// Two collisions that stand at two moments, in one island: each goes on from its own, and nobody waits
TEST(stepInParts, twoCollisionsOfOneIslandGoOnFromMomentsOfTheirOwn)
{
    const double first = 2e-6, second = 0.7e-6, rest = 4e-6;
    const scene::Law law = dust();
    std::vector<dem::Particle> at
    {
        // about to collide at -first, and at -second
        sphere(law, 1, r, Vec3(0, 0, 50*r), Vec3(1, 0, 0)),
        sphere(law, 2, r, Vec3(2.0001*r, 0.2*r, 50*r), Vec3(-1, 0.2, 0)),
        sphere(law, 3, r, Vec3(0, 6*r, 50*r), Vec3(1, -0.1, 0)),
        sphere(law, 4, r, Vec3(2.0001*r, 6.3*r, 50*r), Vec3(-1.5, 0, 0))
    };
    const auto run = [&](const std::vector<dem::Particle>& particles, bool behind)
    {
        auto system = std::make_unique<dem::System>(law.table(), dem::TimeSettings{});
        system->keepGasExchange(true);
        for (std::size_t i = 0; i < particles.size(); ++i)
        {
            system->add(particles[i], !behind ? 0 : i < 2 ? -first : -second);
        }
        EXPECT_EQ(system->advance(behind ? rest : rest + first).touches, 2);
        return system;
    };

    const auto parts = run(at, true);
    std::vector<dem::Particle> earlier = at;
    for (const std::size_t i : {2, 3}) earlier[i].x -= (first - second)*earlier[i].v;
    const auto whole = run(earlier, false);
    for (std::size_t i = 0; i < at.size(); ++i)
    {
        // to the error of contact steps, which fall elsewhere
        EXPECT_LE((parts->particle(i).x - whole->particle(i).x).norm(), 1e-5*r) << i;
        EXPECT_LE((parts->particle(i).v - whole->particle(i).v).norm(), 1e-5) << i;
    }
}


// What the gas gives to one that stands behind is that of all parts
TEST(stepInParts, theGasGivesInAllParts)
{
    const scene::Law law = dust();
    dem::System system(law.table(), dem::TimeSettings{});
    system.keepGasExchange(true);
    const double delays[4] = {-2e-6, -2e-6, -0.7e-6, 1.3e-6};
    for (int i = 0; i < 4; ++i)
    {
        const Vec3 x((i % 2)*2.0001*r, (i/2)*6*r, 50*r);
        system.add(sphere(law, i, r, x, Vec3(i % 2 ? -1 : 1, 0, 0)), delays[i]);
        dem::GasLoad load;
        load.Sp = 2e-9;
        load.Uc = Vec3(0, 3, 0);
        system.setGasLoad(std::size_t(i), load);
    }
    system.advance(4e-6);
    Vec3 given = Vec3::Zero(), momentum = Vec3::Zero();
    for (std::size_t i = 0; i < system.size(); ++i)
    {
        given += system.gasExchange(i).impulse;
        momentum += system.particle(i).mass*system.particle(i).v;
    }
    EXPECT_GT(momentum.y(), 1e-14);
    EXPECT_LE((given - momentum).norm(), 1e-9*momentum.norm());
}
