// SPDX-License-Identifier: GPL-3.0-or-later
//
// Aggregates that are at rest inside and fly as one body.
#include "scene.hpp"

#include "timeIntegration/RigidAggregate.hpp"
#include "timeIntegration/freeFlight.hpp"

using dem::Vec3;
using scene::close;
using scene::Law;
using scene::near;

namespace
{

constexpr double density = 1000;

dem::Particle sphere(std::int64_t id, double r, const Vec3& x)
{
    return {id, 0, r, density*4/3*formula::pi*r*r*r, x};
}

//- The motion of a body with velocity V of the centre of mass and spin omega
void spin(std::vector<dem::Particle>& p, const Vec3& V, const Vec3& omega)
{
    double M = 0;
    Vec3 X = Vec3::Zero();
    for (const auto& q : p)
    {
        M += q.mass;
        X += q.mass*q.x;
    }
    X /= M;
    for (auto& q : p)
    {
        q.v = V + omega.cross(q.x - X);
        q.omega = omega;
    }
}

struct Sums
{
    Vec3 momentum = Vec3::Zero(), angular = Vec3::Zero();
    double energy = 0;

    explicit Sums(const std::vector<dem::Particle>& p)
    {
        for (const auto& q : p)
        {
            const double I = 0.4*q.mass*q.radius*q.radius;
            momentum += q.mass*q.v;
            angular += q.mass*q.x.cross(q.v) + I*q.omega;
            energy += 0.5*(q.mass*q.v.squaredNorm() + I*q.omega.squaredNorm());
        }
    }
};

std::vector<dem::Particle> threeUnequal()
{
    return
    {
        sphere(0, 1e-6, Vec3(0, 0, 0)), sphere(1, 2e-6, Vec3(3e-6, 0, 0)),
        sphere(2, 1.5e-6, Vec3(3e-6, 3.5e-6, 0))
    };
}

}


TEST(rigidAggregate, dumbbellTurnsEvenly)
{
    const double r = 1e-6, omega = 2e5, h = 1.3e-5;
    std::vector<dem::Particle> p{sphere(0, r, Vec3(-r, 0, 0)), sphere(1, r, Vec3(r, 0, 0))};
    spin(p, Vec3(0.1, 0, -0.2), Vec3(0, 0, omega));
    const std::vector<dem::GasLoad> gas(2);
    std::vector<Vec3> impulse;
    dem::RigidAggregate body(p, gas, {});
    // the contact holds the spheres on their circles
    EXPECT_TRUE(close(body.contactForce(0).x(), p[0].mass*omega*omega*r, 1e-12));
    body.fly(h, impulse);
    const Vec3 arm(r*std::cos(omega*h), r*std::sin(omega*h), 0);
    EXPECT_TRUE(near(p[1].x, h*Vec3(0.1, 0, -0.2) + arm, 1e-12*r));
    EXPECT_TRUE(near(p[0].x, h*Vec3(0.1, 0, -0.2) - arm, 1e-12*r));
    EXPECT_EQ(impulse[0].norm(), 0);
}


TEST(rigidAggregate, tumblingKeepsMomentumAndEnergy)
{
    std::vector<dem::Particle> p = threeUnequal();
    spin(p, Vec3(1, 0.5, 0), Vec3(1e5, 2e5, -5e4));
    const Sums before(p);
    const std::vector<dem::GasLoad> gas(3);
    std::vector<Vec3> impulse;
    for (int k = 0; k < 20; ++k) dem::RigidAggregate(p, gas, {}).fly(1e-5, impulse);
    const Sums after(p);
    EXPECT_TRUE(near(after.momentum, before.momentum, 1e-12*before.momentum.norm()));
    EXPECT_TRUE(near(after.angular, before.angular, 1e-9*before.angular.norm()));
    EXPECT_TRUE(close(after.energy, before.energy, 1e-4));
    // still the same body
    EXPECT_TRUE(close((p[0].x - p[1].x).norm(), 3e-6, 1e-10));
    EXPECT_TRUE(close((p[2].x - p[1].x).norm(), 3.5e-6, 1e-10));
}


TEST(rigidAggregate, equalDragIsExact)
{
    // two alike in an even stream: the centre moves as a single sphere does
    const double r = 1e-6;
    for (const double s : {1e2, 1e5, 1e8})
    {
        SCOPED_TRACE(s);
        std::vector<dem::Particle> p{sphere(0, r, Vec3(-r, 0, 0)), sphere(1, r, Vec3(r, 0, 0))};
        spin(p, Vec3(0, 0, 1), Vec3(0, 1e5, 0));
        std::vector<dem::GasLoad> gas(2);
        for (auto& g : gas)
        {
            g.Sp = s*p[0].mass;
            g.Uc = Vec3(2, 0, 0);
            g.Su = p[0].mass*Vec3(0, 0, -9.81);
        }
        dem::Particle one = p[0];
        one.x = Vec3::Zero();
        one.v = Vec3(0, 0, 1);
        const double h = 2e-5;
        dem::fly(one, gas[0], h);
        const Vec3 start = p[0].mass*(p[0].v + p[1].v);
        std::vector<Vec3> impulse;
        dem::RigidAggregate(p, gas, {}).fly(h, impulse);
        EXPECT_TRUE(near(0.5*(p[0].x + p[1].x), one.x, 1e-9*one.x.norm()));
        EXPECT_TRUE(near(0.5*(p[0].v + p[1].v), one.v, 1e-9*one.v.norm()));
        EXPECT_TRUE
        (
            near(impulse[0] + impulse[1], p[0].mass*(p[0].v + p[1].v) - start, 1e-12*start.norm())
        );
        // drag on the ends stops the spin: (2 m r^2 + 2 I) domega/dt = -2 Sp r^2 omega
        const double rate = s*r*r/(r*r + 0.4*r*r);
        EXPECT_TRUE(near(p[0].omega.y(), 1e5*std::exp(-rate*h), 1e-3*1e5));
    }
}


TEST(rigidAggregate, stuckPairFliesLikeTheContactSteps)
{
    // two spheres meet off centre and stick; then they fly as one body, as they do when every
    // contact step is taken
    Law law;
    law.friction = 0.3;
    law.criticalAngle = 0.0085;
    law.rollingDamping = 0;
    law.twisting = true;
    law.restitution = 0.3;
    const double r = 1e-6;
    const auto run = [&](double tolerance, bool restart, dem::StepReport& report)
    {
        dem::TimeSettings time;
        time.restTolerance = tolerance;
        auto system = std::make_unique<dem::System>(law.table(), time);
        system->add({0, 0, r, law.mass(r), Vec3(0, 0, 0), Vec3(0.05, 0, 0)});
        system->add({1, 0, r, law.mass(r), Vec3(2.1*r, 0.7*r, 0), Vec3(-0.05, 0, 0.02)});
        for (int k = 0; k < 30; ++k)
        {
            if (restart && k == 17)
            {
                auto next = std::make_unique<dem::System>(law.table(), time);
                for (std::size_t i = 0; i < 2; ++i) next->add(system->particle(i));
                for (std::size_t i = 0; i < 2; ++i) next->unpackState(i, system->packState(i));
                system = std::move(next);
            }
            report.add(system->advance(1e-6));
        }
        return system;
    };
    dem::StepReport resting, exact, again;
    const auto a = run(1, false, resting), b = run(0, false, exact), c = run(1, true, again);
    EXPECT_GT(resting.aggregateFlights, 5);
    EXPECT_EQ(exact.aggregateFlights, 0);
    EXPECT_LT(resting.contactSteps, exact.contactSteps);
    EXPECT_FALSE(a->resting(0));
    for (std::size_t i = 0; i < 2; ++i)
    {
        EXPECT_TRUE(near(a->particle(i).x, b->particle(i).x, 2e-3*r));
        EXPECT_EQ(a->particle(i).x, c->particle(i).x);
        EXPECT_EQ(a->particle(i).v, c->particle(i).v);
    }
    const Vec3 momentum = a->particle(0).v + a->particle(1).v;
    EXPECT_TRUE(near(momentum, Vec3(0, 0, 0.02), 1e-12));
    EXPECT_EQ(resting.touches, exact.touches);
}


TEST(rigidAggregate, wakesWhereItIsMet)
{
    // an aggregate at rest inside meets a wall, and another is left by one of its members
    Law law;
    law.restitution = 0.3;
    law.friction = 0.3;
    law.criticalAngle = 0.0085;
    const double r = 1e-6;
    dem::TimeSettings time;
    dem::System system(law.table(), time);
    dem::Walls walls;
    walls.patches.push_back({"floor", 1});
    walls.planes.push_back({Vec3(0, 0, -2e-5), Vec3::UnitZ(), 0});
    system.setWalls(walls);
    for (int k = 0; k < 2; ++k)
    {
        const double x = 4e-5*k, drop = k ? 0 : -0.3;
        system.add({2*k, 0, r, law.mass(r), Vec3(x, 0, 0), Vec3(0.02, 0, drop)});
        system.add({2*k + 1, 0, r, law.mass(r), Vec3(x + 2.02*r, 0, 0), Vec3(-0.02, 0, drop)});
    }
    dem::StepReport report;
    for (int k = 0; k < 40; ++k) report.add(system.advance(1e-6));
    EXPECT_GT(report.aggregateFlights, 0);
    EXPECT_EQ(report.flyingAtRest, 4);
    system.remove({0, 0, 0, 1});
    report = system.advance(1e-6);
    EXPECT_EQ(report.flyingAtRest, 2);
    EXPECT_EQ(report.freeFlights, 0);       // it looks for its partner in an island
    EXPECT_EQ(system.advance(1e-6).freeFlights, 1);
    report = {};
    for (int k = 0; k < 60; ++k) report.add(system.advance(1e-6));
    // the other has come down to the floor
    EXPECT_GT(report.touches, 0);
    EXPECT_LT(system.particle(0).x.z(), -1.7e-5);
}
