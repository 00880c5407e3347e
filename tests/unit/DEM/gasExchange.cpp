// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the gas gives to a particle, and what it would have given in a faster gas: in flight,
// held, at rest for a part of a step, as a member of a cluster.
#include "clouds.hpp"
#include "timeIntegration/freeFlight.hpp"

using scene::close;
using scene::Law;
using scene::near;
using scene::sphere;
using dem::Vec3;

namespace
{

std::unique_ptr<dem::System> systemOf(const Law& law, double restTolerance)
{
    dem::TimeSettings time;
    time.restTolerance = restTolerance;
    auto system = std::make_unique<dem::System>(law.table(), time);
    system->keepGasExchange(true);
    return system;
}

dem::GasLoad wind(double Sp, const Vec3& Uc)
{
    dem::GasLoad g;
    g.Sp = Sp;
    g.Uc = Uc;
    return g;
}

}


TEST(gasExchange, responseOfAFlightIsItsDerivative)
{
    const Law law;
    const double r = 1e-6, m = law.mass(r), dt = 1e-4;
    for (const double z : {1e-3, 1.0, 30.0})
    {
        double impulse[2], response = 0;
        for (int k = 0; k < 2; ++k)
        {
            const auto system = systemOf(law, 1);
            system->add(sphere(law, 1, r, Vec3::Zero(), Vec3(0.1, 0, 0)));
            system->setGasLoad(0, wind(z*m/dt, Vec3(1 + k, 0, 0)));
            system->advance(dt);
            impulse[k] = system->gasExchange(0).impulse.x();
            response = system->gasExchange(0).response;
            EXPECT_TRUE(close(system->gasExchange(0).memory, std::exp(-z), 1e-12));
            EXPECT_FALSE(system->gasExchange(0).held);
        }
        EXPECT_TRUE(close(impulse[1] - impulse[0], response, 1e-12));
        EXPECT_TRUE(close(response, -m*std::expm1(-z), 1e-12));
    }
}


TEST(gasExchange, atRestTheGasGivesWhatItHoldsAgainst)
{
    // from landing to rest within one step, in a wind that presses: all of Sp (Uc dt - path)
    const Law law = scene::stickyLaw();
    const double r = 1e-6, m = law.mass(r), dt = 1e-4;
    const dem::GasLoad g = wind(0.01*m/1e-6, Vec3(0.01, 0, -0.01));
    const auto system = systemOf(law, 1);
    system->setWalls(scene::floor());
    system->add(sphere(law, 1, r, Vec3(0, 0, 1.001*r), Vec3(0, 0, -0.2)));
    bool rested = false;
    for (int step = 0; step < 20; ++step)
    {
        const bool before = system->resting(0);
        const Vec3 from = system->particle(0).x;
        system->setGasLoad(0, g);
        system->advance(dt);
        const dem::GasExchange& e = system->gasExchange(0);
        const Vec3 path = system->particle(0).x - from;
        EXPECT_TRUE(near(e.impulse, g.Sp*(dt*g.Uc - path), 2e-3*g.Sp*dt*g.Uc.norm()));
        EXPECT_TRUE(e.held);
        EXPECT_TRUE(close(e.response, g.Sp*dt, 1e-12));
        EXPECT_EQ(e.memory, 1);
        if (before)
        {
            EXPECT_EQ(e.impulse, Vec3(dt*(g.Sp*g.Uc + g.Su)));
            rested = true;
        }
    }
    EXPECT_TRUE(rested);
}


TEST(gasExchange, aClusterRespondsWithItsWholeMass)
{
    const Law law = scene::stickyLaw();
    const double r = 1e-6, m = law.mass(r), dt = 1e-5;
    const auto system = systemOf(law, 1);
    system->add(sphere(law, 1, r, Vec3::Zero(), Vec3(0.05, 0, 0)));
    system->add(sphere(law, 2, r, Vec3(2.0005*r, 0, 0)));
    double Sp[2] = {3*m/dt, 1*m/dt};
    for (int step = 0; step < 400; ++step)
    {
        Vec3 before = Vec3::Zero(), after = Vec3::Zero(), given = Vec3::Zero();
        for (std::size_t i = 0; i < 2; ++i)
        {
            before += m*system->particle(i).v;
            system->setGasLoad(i, wind(Sp[i], Vec3(0, 0.1, 0)));
        }
        system->advance(dt);
        for (std::size_t i = 0; i < 2; ++i)
        {
            after += m*system->particle(i).v;
            given += system->gasExchange(i).impulse;
        }
        EXPECT_TRUE(near(after - before, given, 1e-12*m*0.1));
    }
    ASSERT_TRUE(system->inContact(0) && system->inContact(1));
    const double Z = (Sp[0] + Sp[1])*dt/(2*m);
    const dem::GasExchange e[2] = {system->gasExchange(0), system->gasExchange(1)};
    EXPECT_FALSE(e[0].held || e[1].held);
    EXPECT_TRUE(close(e[0].response + e[1].response, -2*m*std::expm1(-Z), 1e-12));
    EXPECT_TRUE(close(e[0].response/e[1].response, Sp[0]/Sp[1], 1e-12));
}


TEST(gasExchange, lightGasBearsLessOfWhatPullsAClusterApart)
{
    // gas that pulls the members of a pair in opposite directions, and along
    const Law law = scene::stickyLaw();
    const double r = 1e-6, m = law.mass(r), dt = 1e-5;
    const double Sp[2] = {30*m/dt, 10*m/dt};
    const Vec3 gas[2] = {Vec3(-1e-3, 2e-3, 0), Vec3(1e-3, 2e-3, 0)};
    const Vec3 weight(0, 0, -10*m);
    Vec3 given[2][2];
    for (int light = 0; light < 2; ++light)
    {
        const auto system = systemOf(law, 1);
        system->add(sphere(law, 1, r, Vec3::Zero(), Vec3(0.005, 0, 0)));
        system->add(sphere(law, 2, r, Vec3(2.0005*r, 0, 0)));
        for (int step = 0; step < 400; ++step)
        {
            for (std::size_t i = 0; i < 2; ++i)
            {
                dem::GasLoad g = wind(Sp[i], gas[i]);
                g.Su = weight;
                // the lightest gas about any of them counts
                g.apart = light && i == 0 ? 0.1 : 1;
                system->setGasLoad(i, g);
            }
            system->advance(dt);
        }
        EXPECT_TRUE(system->inContact(0) && system->inContact(1));
        for (std::size_t i = 0; i < 2; ++i) given[light][i] = system->gasExchange(i).impulse;
    }
    const double scale = given[0][0].norm();
    EXPECT_TRUE(near(given[1][0] + given[1][1], given[0][0] + given[0][1], 1e-9*scale));
    const Vec3 drag[2] = {given[0][0] - dt*weight, given[0][1] - dt*weight};
    const Vec3 beside = drag[0] - 0.75*(drag[0] + drag[1]);
    EXPECT_GT(beside.norm(), 0.5*scale);
    EXPECT_TRUE(near(given[1][0] - given[0][0], -0.9*beside, 1e-6*scale));
}


TEST(gasExchange, aKickIsMomentumAndWorkOfTheGas)
{
    const Law law;
    dem::TimeSettings time;
    time.energyLedger = true;
    dem::System system(law.table(), time);
    const double r = 1e-6, m = law.mass(r);
    system.add(sphere(law, 1, r, Vec3::Zero(), Vec3(1, 0, 0)));
    system.kick(0, m*Vec3(1, 0, 0));
    EXPECT_TRUE(close(system.particle(0).v.x(), 2, 1e-15));
    const dem::StepReport report = system.advance(1e-6);
    EXPECT_TRUE(close(report.energy.gas, 1.5*m, 1e-12));
    EXPECT_TRUE(close(report.energy.kinetic, 1.5*m, 1e-12));
}
