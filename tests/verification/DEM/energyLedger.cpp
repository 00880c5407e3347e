// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy ledger of single collisions: it closes with the square of the step, its parts
// are what closed forms say, and without the keyword it is not kept.
#include "impact.hpp"

using dem::Vec3;
using scene::Law;

namespace
{

constexpr double r = 1e-6;

//- From just above the floor until it has left again or swings in the well
dem::EnergyLedger collide(const Law& law, const Vec3& v, double steps, bool keep = true)
{
    dem::TimeSettings time;
    time.stepsPerContact = steps;
    time.restTolerance = 0;
    time.energyLedger = keep;
    dem::System system(law.table(), time);
    system.setWalls(scene::floor());
    system.add(scene::sphere(law, 1, r, Vec3(0, 0, 1.001*r), v, Vec3(2e5, -1e5, 3e5)));
    const dem::ContactFigures f =
        law.table().figures(0, 1, r, -1, law.mass(r), 0, -v.z());
    double period = f.impactTime;
    if (f.a0 > 0)
    {
        period += 2*formula::pi*std::sqrt(f.m*f.a0*f.a0/(3.6*f.pullOff*f.R));
    }
    return system.advance(1e-3*r/-v.z() + 2*period).energy;
}

double energy(const Law& law, const Vec3& v) { return 0.5*law.mass(r)*v.squaredNorm(); }

}


TEST(energyLedger, closesWithTheSquareOfTheStep)
{
    std::printf("law,restitution,resistances,residual at 50,100,200,400 steps,order\n");
    for (const char* normal : {"Hertz", "simplifiedJKR", "JKR", "DMT"})
    {
        for (const double e : {1.0, 0.7})
        {
            for (const bool resists : {false, true})
            {
                Law law;
                law.normal = normal;
                law.restitution = e;
                if (law.normal == "Hertz") law.gamma = 0;
                if (resists)
                {
                    law.friction = 0.3;
                    law.adhesionHysteresis = 0.4;
                    law.twisting = true;
                }
                const Vec3 v(3, 1, -8);
                std::vector<double> residual;
                for (const double steps : {50, 100, 200, 400})
                {
                    // mean over impacts a little different, so that none vanishes by chance
                    double sum = 0;
                    for (int k = -4; k <= 4; ++k)
                    {
                        const double n = steps*(1 + 0.02*k);
                        sum += std::pow(collide(law, v, n).residual(), 2);
                    }
                    residual.push_back(std::sqrt(sum/9)/energy(law, v));
                }
                const double order = std::log2(residual[2]/residual[3]);
                std::printf
                (
                    "%s,%g,%d,%.2e,%.2e,%.2e,%.2e,%.2f\n", normal, e, resists, residual[0],
                    residual[1], residual[2], residual[3], order
                );
                SCOPED_TRACE
                (
                    std::string(normal) + " restitution " + scene::text(e)
                  + (resists ? " all resistances" : "")
                );
                EXPECT_LT(residual[0], 2e-3);
                EXPECT_LT(residual[3], 4e-5);
                // sliding begins and ends within a step: a first order of some 1e-5
                if (!resists)
                {
                    EXPECT_GT(order, 1.8);
                }
            }
        }
    }
}


TEST(energyLedger, partsAreWhatTheyShouldBe)
{
    // Hertz with a dashpot: 1 - e^2 of the kinetic energy along the normal
    Law law;
    law.normal = "Hertz";
    law.gamma = 0;
    law.restitution = 0.6;
    const Vec3 v(0, 0, -5);
    dem::EnergyLedger l = collide(law, v, 400);
    EXPECT_TRUE(scene::close(l.dashpots, (1 - 0.36)*energy(law, v), 1e-4));
    EXPECT_TRUE(scene::near(l.normal, 0, 1e-12*energy(law, v)));
    EXPECT_EQ(l.springs + l.yield + l.plastic + l.springGain + l.rest, 0);
    // the difference of two energies
    EXPECT_TRUE(scene::near(l.gas, 0, 1e-15*energy(law, v)));

    // JKR without one: the neck takes the integral of F_N from 0 to -delta_C
    law = Law();
    law.restitution = 1;
    l = collide(law, v, 400);
    const formula::Contact c = law.contact(r, -1);
    double work = 0;
    const int n = 20000;
    for (int k = 0; k < n; ++k)
    {
        // the slope at the end is infinite: points denser there
        const double s0 = double(k)/n, s1 = double(k + 1)/n, s = 0.5*(s0 + s1);
        work += formula::normal("JKR", c, -c.deltaC()*(1 - s*s), 1).force
               *c.deltaC()*(s1*s1 - s0*s0);
    }
    EXPECT_TRUE(scene::close(l.released, -work, 1e-5));
    EXPECT_TRUE(scene::close(l.kinetic, work, 1e-3));

    // gas: a force over a path, without contact
    dem::TimeSettings time;
    time.energyLedger = true;
    dem::System system(law.table(), time);
    system.setWalls(scene::floor());
    system.add(scene::sphere(law, 1, r, Vec3(0, 0, 1.5*r), Vec3(0.1, 0, 0)));
    dem::GasLoad g;
    g.Su = Vec3(1e-9, 0, 0);
    system.setGasLoad(0, g);
    const dem::EnergyLedger flight = system.advance(1e-7).energy;
    EXPECT_TRUE(scene::close(flight.gas, 1e-9*system.particle(0).x.x(), 1e-9));
    EXPECT_TRUE(scene::near(flight.residual(), 0, 1e-12*flight.gas));
}


TEST(energyLedger, isOffUnlessAskedFor)
{
    const dem::EnergyLedger l = collide(Law(), Vec3(0, 0, -5), 50, false);
    EXPECT_EQ(l.kinetic, 0);
    EXPECT_EQ(l.dashpots, 0);
    EXPECT_EQ(l.released, 0);
}
