// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stability bound of the contact step (timeIntegration/contactPeriod.hpp), and what the
// stability map (tests/verification/stabilityMap) has found.
#include "contactModels/contactModel/ContactLaw.hpp"
#include "island/Island.hpp"

#include "scene.hpp"

using scene::Law;
using scene::near;
using scene::sphere;
using dem::Vec3;

namespace
{

double energy(const std::vector<dem::Particle>& particles)
{
    double sum = 0;
    for (const dem::Particle& p : particles)
    {
        sum +=
            0.5*p.mass*p.v.squaredNorm()
          + 0.2*p.mass*p.radius*p.radius*p.omega.squaredNorm();
    }
    return sum;
}

//- Largest kinetic energy over the first one in about `steps` steps at this share of the
//  bound, beneath System, which refuses shares above 1
double growth
(
    const Law& law, std::vector<dem::Particle> particles, double share, int steps,
    double stepsPerContact = 1
)
{
    const dem::MaterialTable table = law.table();
    dem::TimeSettings time;
    time.stepsPerContact = stepsPerContact;
    time.boundShare = share;
    time.restTolerance = 0;
    const dem::WallSearch walls((dem::Walls()));
    const dem::Periodic periodic;
    dem::Island island(table, time, walls, periodic);
    const double first = energy(particles);
    double most = first, now = 0;
    std::vector<std::vector<dem::ContactRecord>> contacts(particles.size());
    std::int64_t taken = 0;
    const double period = table.figures
    (
        0, 0, particles[0].radius, particles[1].radius, particles[0].mass,
        particles[1].mass, 0
    ).period;
    while (taken < steps && most < 1e6*first)
    {
        dem::StepReport report;
        island.clear();
        const int n = int(particles.size());
        for (int i = 0; i < n; ++i) island.addParticle(particles[std::size_t(i)], {}, {});
        for (int i = 0; i < n; ++i)
        {
            for (const dem::ContactRecord& r : contacts[std::size_t(i)])
            {
                island.addContact(i, int(r.idJ), r);
            }
        }
        // long, as the steps of one run are equal and end with it
        try { island.run({20*period, now}, report); }
        catch (const dem::numericalError&) { return 1e300; }
        now += 20*period;
        for (int i = 0; i < n; ++i)
        {
            particles[std::size_t(i)] = island.particle(i);
            contacts[std::size_t(i)] = island.contacts(i);
        }
        most = std::max(most, energy(particles));
        taken += std::max<std::int64_t>(report.contactSteps, 1);
    }
    return most/first;
}

//- Two of a material at the equilibrium of JKR, with a small relative velocity along `way`
std::vector<dem::Particle> held(const Law& law, const Vec3& way)
{
    const double r = 1e-6;
    const formula::Contact c = law.contact(r, r);
    const double omega = std::sqrt(1.2*c.E*c.a0()/c.m);
    const Vec3 v = 1e-3*c.delta0()*omega*way;
    return
    {
        sphere(law, 0, r, Vec3(0, 0, 0), 0.5*v),
        sphere(law, 1, r, Vec3(0, 0, 2*r - c.delta0()), -0.5*v)
    };
}

}


TEST(stability, theBoundHolds)
{
    // the bound takes the Hertzian slope 2 E a at the overlap delta_0, where that of JKR is
    // 1.2 E a0: (1.2/2.31)^(1/2) of it; the dashpot's share is that of the law
    for (const double e : {1.0, 0.5, 0.05})
    {
        Law law;
        law.restitution = e;
        EXPECT_LT(growth(law, held(law, Vec3(0, 0, 1)), 0.99, 4000), 2) << e;
        EXPECT_GT(growth(law, held(law, Vec3(0, 0, 1)), 1.5, 4000), 1e3) << e;
    }
}


TEST(stability, slidingSpringsWithoutDampingDoNotGrow)
{
    // by W^2/4 a step as they were: e^(2.5) in 1000 steps of 20 per period
    Law law;
    law.restitution = 1;
    law.friction = 10;
    EXPECT_LT(growth(law, held(law, Vec3(1, 0, 0)), 0.8, 4000, 20), 1.2);
    EXPECT_LT(growth(law, held(law, Vec3(1, 0, 0)), 0.99, 4000), 2);
}


TEST(stability, strongDashpotsShortenTheStep)
{
    Law law;
    law.restitution = 0.01;
    law.friction = 10;
    law.twisting = true;
    law.adhesionHysteresis = 1;
    law.rollingDamping = 1e-14;
    for (const Vec3& way : {Vec3(0, 0, 1), Vec3(1, 0, 0)})
    {
        EXPECT_LT(growth(law, held(law, way), 0.8, 2000, 10), 2);
    }
    // a light large sphere turns as easily as a small one
    std::vector<dem::Particle> unequal = held(law, Vec3(1, 0, 0));
    unequal[1].radius = 1e-4;
    unequal[1].x.z() =
        unequal[0].radius + unequal[1].radius
      - law.contact(unequal[0].radius, unequal[1].radius).delta0();
    EXPECT_LT(growth(law, unequal, 0.8, 2000, 10), 2);
}


TEST(stability, manyContactsOnALightSphere)
{
    Law law;
    law.restitution = 1;
    const int n = 400;
    const double r = 1e-6, large = 26e-6;
    const double m = law.mass(r);
    const auto run = [&](bool limited)
    {
        std::vector<dem::Particle> p{sphere(law, 0, large, Vec3::Zero())};
        p[0].mass = 0.2*m;
        const formula::Contact c = law.contact(r, large);
        for (int k = 0; k < n; ++k)
        {
            const double z = 1 - 2*(k + 0.5)/n, a = 2.399963229728653*k;
            const Vec3 way(std::sqrt(1 - z*z)*std::cos(a), std::sqrt(1 - z*z)*std::sin(a), z);
            p.push_back(sphere(law, k + 1, r, (large + r - c.delta0())*way));
        }
        p[0].v = Vec3(1e-3, 0, 0);
        return growth(law, p, limited ? 0.8 : 1e3, 1000, 10);
    };
    EXPECT_LT(run(true), 2);
    EXPECT_GT(run(false), 100);     // ten steps per period of one contact are too few
}


TEST(stability, whatSettlesInStiffDragIsStill)
{
    // a sphere that the wind holds against a wall: drag relaxes it in far less than a step
    Law law;
    law.restitution = 0.5;
    dem::TimeSettings time;
    time.restTolerance = 0;
    dem::System system(law.table(), time);
    system.keepGasExchange(true);
    system.setWalls(scene::floor());
    const double r = 1e-6;
    system.add(sphere(law, 1, r, Vec3(0, 0, r)));
    const double period =
        system.materials().figures(0, 1, r, -1, law.mass(r), 0, 0).period;
    dem::GasLoad gas;
    gas.Sp = law.mass(r)/(1e-4*period);
    gas.Uc = Vec3(0, 0, -1e-3);
    system.setGasLoad(0, gas);
    system.advance(20000*period);
    EXPECT_TRUE(near(system.particle(0).v, Vec3::Zero(), 1e-5*gas.Uc.norm()));
    // impulse of the gas: Sp (Uc t - path)
    const double path = system.particle(0).x.z() - r;
    EXPECT_TRUE
    (
        scene::close
        (
            system.gasExchange(0).impulse.z(), gas.Sp*(gas.Uc.z()*20000*period - path), 1e-6
        )
    );
}


TEST(stability, weightFromRestBouncesBack)
{
    // let go where it just touches: up again to the same height, at 1 g and at 1e5 g
    Law law;
    law.normal = "Hertz";
    law.gamma = 0;
    law.restitution = 1;
    for (const double g : {9.81, 9.81e5})
    {
        dem::TimeSettings time;
        time.stepsPerContact = 200;
        dem::System system(law.table(), time);
        system.setWalls(scene::floor());
        const double r = 1e-3, m = law.mass(r);
        system.add(sphere(law, 1, r, Vec3(0, 0, r*(1 + 1e-12))));
        dem::GasLoad gas;
        gas.Su = Vec3(0, 0, -m*g);
        system.setGasLoad(0, gas);
        const formula::Contact c = law.contact(r, -1);
        // deepest: (8/15) E R^(1/2) delta^(5/2) = m g delta
        const double deepest = std::pow(15*m*g/(8*c.E*std::sqrt(c.R)), 2.0/3);
        const double t = std::sqrt(deepest/g);
        double lowest = r, fastest = 0;
        for (int k = 0; k < 400; ++k)
        {
            system.advance(0.05*t);
            lowest = std::min(lowest, system.particle(0).x.z());
            fastest = std::max(fastest, std::fabs(system.particle(0).v.z()));
        }
        EXPECT_TRUE(scene::close(r - lowest, deepest, 0.02)) << g;
        // speed is greatest where the force is m g: m v^2/2 = (3/5) m g delta
        const double level = std::pow(0.75*m*g/(c.E*std::sqrt(c.R)), 2.0/3);
        EXPECT_TRUE(scene::close(fastest, std::sqrt(1.2*g*level), 0.02)) << g;
    }
}


TEST(stability, nothingPassesThroughASphere)
{
    // so soft that adhesion pulls one through the other, and so fast
    for (const double speed : {1e-3, 500.0})
    {
        Law law;
        law.normal = "DMT";
        law.restitution = 1;
        law.softening.ratio = 1e-6;
        dem::TimeSettings time;
        time.stepsPerContact = dem::TimeSettings::fewestStepsPerContact;
        dem::System system(law.table(), time);
        const double r = 1e-7;
        system.add(sphere(law, 1, r, Vec3(0, 0, 0)));
        system.add(sphere(law, 2, r, Vec3(0, 0, 2.01*r), Vec3(0, 0, -speed)));
        EXPECT_THROW(system.advance(1e-5), dem::numericalError) << speed;
    }
}


TEST(stability, nothingPassesWhatAContactFlingsAtIt)
{
    // A light sphere is pressed on a heavy one, both still, and flies off at a third within
    // the same particle step: nothing says so at its beginning
    Law law;
    law.normal = "Hertz";
    law.restitution = 1;
    const double r = 1e-6, overlap = 0.01*r;
    dem::Particle low = sphere(law, 1, r, Vec3(0, 0, 0));
    const dem::Particle light = sphere(law, 2, r, Vec3(0, 0, 2*r - overlap));
    dem::Particle high = sphere(law, 3, r, Vec3(0, 0, 24*r));
    low.mass = high.mass = 1e9*light.mass;
    const formula::Contact c = law.contact(r, r);
    // m v^2/2 = (8/15) E R^(1/2) delta^(5/2)
    const double v = std::sqrt(16.0/15*c.E*std::sqrt(c.R)*std::pow(overlap, 2.5)/light.mass);
    for (const bool islands : {true, false})
    {
        dem::TimeSettings time;
        time.islands = islands;
        dem::System system(law.table(), time);
        for (const dem::Particle& p : {low, light, high}) system.add(p);
        const dem::StepReport report = system.advance(30*r/v);
        EXPECT_EQ(report.touches, 2);
        EXPECT_TRUE(near(system.particle(1).v.z(), -v, 2e-3*v));
    }
}


TEST(stability, aTouchAfterAFlightIsNoBlow)
{
    // In an island of many (more than 256 pairs) nothing touches: it flies to the next touch in
    // one go. The adhesion that begins there must not act over that time.
    Law law;
    law.restitution = 1;
    const dem::MaterialTable table = law.table();
    const dem::WallSearch walls((dem::Walls()));
    const dem::Periodic periodic;
    const double r = 1e-6, v = 10;
    const auto after = [&](int others)
    {
        dem::Island island(table, {}, walls, periodic);
        std::vector<dem::Particle> particles
        {
            sphere(law, 0, r, Vec3(0, 0, 0), Vec3(0, 0, v)), sphere(law, 1, r, Vec3(0, 0, 5*r))
        };
        for (int k = 0; k < others; ++k)
        {
            particles.push_back(sphere(law, 2 + k, r, Vec3(10*(k + 1)*r, 0, 0)));
        }
        for (const dem::Particle& p : particles) island.addParticle(p, {}, {});
        dem::StepReport report;
        island.run({6*r/v}, report);
        EXPECT_EQ(report.touches, 1);
        EXPECT_EQ(report.separations, 1);
        return island.particle(1).v.z();
    };
    EXPECT_TRUE(near(after(28), after(0), 2e-3*v));
}


TEST(stability, whatHardlyMovesTouchesAtLast)
{
    // So slow that in a thousandth of a contact step no coordinate changes: where round-off
    // leaves a gap after the flight to the touch, the rest of it has to be passed all the same
    Law law;
    law.normal = "vanDerWaals";
    law.adjust = [](dem::ContactSettings& settings)
    {
        settings.normal.values["cutOff"] = 2.5e-10;
        settings.normal.values["range"] = 2.4e-9;
    };
    dem::TimeSettings time;
    time.stepsPerContact = 400;
    const double v = 1e-9, gap = 1e-13, touch = law.table().touchDistance(0, 0);
    for (int k = 0; k < 100; ++k)
    {
        const double r = (1 + 0.01*k)*1e-3;
        dem::System system(law.table(), time);
        system.add(sphere(law, 1, r, Vec3(0, 0, r + touch + gap), Vec3(0, 0, -v)));
        system.add(sphere(law, 2, 0.067*r, Vec3(0, 0, -0.067*r)));
        EXPECT_EQ(system.advance(1.001*gap/v).touches, 1) << k;
    }
}


TEST(stability, contactsPulledOpenFromRest)
{
    // Adhesion holds with F_C until the gas force F has pulled the sphere out of its overlap,
    // in a small part of the first step: m v^2/2 = F s - F_C overlap
    Law law;
    law.normal = "DMT";
    law.restitution = 1;
    const double r = 1e-6, overlap = 1e-7*r;
    dem::System system(law.table(), {});
    system.setWalls(scene::floor());
    system.add(sphere(law, 1, r, Vec3(0, 0, r - overlap)));
    const double force = 1.5*law.contact(r, -1).pullOff(), m = system.particle(0).mass;
    dem::GasLoad gas;
    gas.Su = Vec3(0, 0, force);
    system.setGasLoad(0, gas);
    system.advance(1e-9);
    const double s = system.particle(0).x.z() - (r - overlap);
    const double v = std::sqrt(2*(force*s - law.contact(r, -1).pullOff()*overlap)/m);
    EXPECT_FALSE(system.inContact(0));
    EXPECT_TRUE(scene::close(system.particle(0).v.z(), v, 1e-3));
}


TEST(stability, stepsThatAreRefused)
{
    const Law law;
    dem::TimeSettings time;
    time.stepsPerContact = 19.9;
    EXPECT_THROW(dem::System(law.table(), time), dem::inputError);
    time.stepsPerContact = 20;
    EXPECT_NO_THROW(dem::System(law.table(), time));
    time = {};
    for (const double share : {0.0, 1.01, std::nan("")})
    {
        time.boundShare = share;
        EXPECT_THROW(dem::System(law.table(), time), dem::inputError);
    }
    // a dashpot that no step worth taking is stable for
    Law strong;
    strong.adhesionHysteresis = 0.4;
    strong.rollingDamping = 1;
    dem::System system(strong.table(), {});
    system.add(sphere(strong, 1, 1e-6, Vec3(0, 0, 0)));
    system.add(sphere(strong, 2, 1e-6, Vec3(0, 0, 1.999e-6)));
    EXPECT_THROW(system.advance(1e-9), dem::numericalError);
}
