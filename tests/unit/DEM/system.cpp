// SPDX-License-Identifier: GPL-3.0-or-later
//
// The DEM system as its users see it: collisions within a step, rest and wake, adding and
// removing, restart, what it refuses.
#include "clouds.hpp"
#include "contacts/ContactRecord.hpp"
#include "contacts/PackedState.hpp"
#include "floatingTraps.hpp"
#include "foundation/Fields.hpp"
#include "timeIntegration/freeFlight.hpp"

#include <set>

using scene::close;
using scene::near;
using scene::Law;
using scene::sphere;
using dem::Vec3;

namespace
{

dem::TimeSettings neverRests()
{
    dem::TimeSettings t;
    t.restTolerance = 0;
    return t;
}

Law elastic()
{
    Law law;
    law.normal = "Hertz";
    law.gamma = 0;
    law.restitution = 1;
    return law;
}

//- A sphere that has hit the floor and stuck, at rest
std::unique_ptr<dem::System> stuckSphere(const Law& law, double r, double restTolerance = 1)
{
    dem::TimeSettings time;
    time.restTolerance = restTolerance;
    auto system = std::make_unique<dem::System>(law.table(), time);
    system->setWalls(scene::floor());
    system->add(sphere(law, 1, r, Vec3(0, 0, 1.001*r), Vec3(0, 0, -0.2)));
    for (int k = 0; k < 200 && !system->resting(0); ++k) system->advance(1e-7);
    return system;
}

}


// * * * * * * * * * * * * * * * * Conservation * * * * * * * * * * * * * * * * * * * * //

TEST(system, whoHasReboundedFliesStraightOn)
{
    // Short and long flights after the touch: what is left of its load would act over all of them
    for (const char* normal : {"Hertz", "JKR", "DMT"})
    {
        Law law;
        law.normal = normal;
        if (law.normal == "Hertz") law.gamma = 0;
        law.friction = 0.3;
        Vec3 after[2];
        for (const bool inParts : {false, true})
        {
            dem::System system(law.table(), neverRests());
            system.setWalls(scene::floor());
            system.add(sphere(law, 1, 1e-6, Vec3(0, 0, 3e-6), Vec3(2, 1, -15)));
            const double all = 1e-3, first = 4e-7;
            const dem::StepReport report =
                inParts ? system.advance(first, all - first) : system.advance(all);
            EXPECT_EQ(report.separations, 1);
            after[inParts] = system.particle(0).v;
        }
        EXPECT_GT(after[0].z(), 10);
        EXPECT_TRUE(near(after[1], after[0], 1e-12)) << normal;
    }
}


TEST(system, momentumOfPairCollisionsIsKept)
{
    scene::Random random(31);
    for (const char* normal : {"Hertz", "simplifiedJKR", "JKR", "DMT"})
    {
        for (int k = 0; k < 20; ++k)
        {
            Law law = scene::stickyLaw();
            law.normal = normal;
            if (law.normal == "Hertz") law.gamma = 0;
            const double ri = random.logUniform(0.3e-6, 3e-6);
            const double rj = random.logUniform(0.3e-6, 3e-6);
            const Vec3 n = random.direction();
            const Vec3 gap = (1.01*(ri + rj))*n;
            const Vec3 v = n*random.logUniform(0.5, 10) + 0.3*random.inBox(1);

            dem::System system(law.table(), neverRests());
            system.keepGasExchange(true);
            system.add(sphere(law, 1, ri, Vec3::Zero(), v, random.inBox(1e6)));
            system.add(sphere(law, 2, rj, gap, Vec3::Zero(), random.inBox(1e6)));
            const auto momentum = [&]
            {
                Vec3 sum = Vec3::Zero();
                for (std::size_t i = 0; i < 2; ++i)
                {
                    sum += system.particle(i).mass*system.particle(i).v;
                }
                return sum;
            };
            const Vec3 before = momentum();
            const double exchanged = law.mass(ri)*v.norm();
            dem::StepReport report;
            for (int step = 0; step < 20; ++step) report.add(system.advance(2e-8));
            EXPECT_GE(report.touches, 1);
            EXPECT_GT((system.particle(1).v).norm(), 0);
            // round-off of every contact step
            EXPECT_TRUE(near(momentum(), before, 1e-15*double(report.contactSteps)*exchanged));
            EXPECT_EQ(system.gasExchange(0).impulse, Vec3::Zero());
        }
    }
}


TEST(system, gasImpulseIsTheGasShareOfTheMomentum)
{
    // in a flight and in a collision under drag and weight, contact impulses cancel:
    // total momentum changes by the gas impulses alone
    Law law = scene::stickyLaw();
    dem::System system(law.table(), neverRests());
    system.keepGasExchange(true);
    const double r = 1e-6;
    system.add(sphere(law, 1, r, Vec3(0, 0, 0), Vec3(1, 0.1, 0)));
    system.add(sphere(law, 2, r, Vec3(2.2*r, 0, 0)));
    const auto momentum = [&]
    {
        return Vec3(system.particle(0).mass*system.particle(0).v
              + system.particle(1).mass*system.particle(1).v);
    };
    int touched = 0;
    for (int step = 0; step < 30; ++step)
    {
        scene::load(system);
        const Vec3 before = momentum();
        touched += int(system.advance(5e-8).touches);
        const Vec3 given = system.gasExchange(0).impulse + system.gasExchange(1).impulse;
        EXPECT_GT(given.norm(), 0);
        EXPECT_TRUE(near(momentum() - before, given, 1e-13*momentum().norm()));
    }
    EXPECT_GE(touched, 1);
}


// * * * * * * * * * * * * * * Collisions within a step * * * * * * * * * * * * * * * * //

TEST(system, aLongStepMissesNoCollision)
{
    // a fast sphere with a small target 500 radii away, in one step
    const Law law = elastic();
    const double r = 1e-6, v = 1;
    for (const double offset : {0.0, 0.5, 1.0, 1.9})    // of r, off the line
    {
        dem::System system(law.table(), {});
        system.add(sphere(law, 1, r, Vec3::Zero(), Vec3(v, 0, 0)));
        system.add(sphere(law, 2, r, Vec3(500*r, offset*r, 0)));
        const dem::StepReport report = system.advance(2000*r/v);
        EXPECT_EQ(report.touches, 1);
        EXPECT_EQ(report.separations, 1);
        // frictionless and elastic: all momentum along the line of centres goes over
        const double s = offset/2, c = std::sqrt(1 - s*s);
        EXPECT_TRUE(near(system.particle(1).v, v*c*Vec3(c, s, 0), 2e-2*v));
        EXPECT_TRUE(near(system.particle(0).v, v*Vec3(1, 0, 0) - v*c*Vec3(c, s, 0), 2e-2*v));
    }
    // and a miss stays a miss, in closed form
    dem::System system(law.table(), {});
    system.add(sphere(law, 1, r, Vec3::Zero(), Vec3(v, 0, 0)));
    system.add(sphere(law, 2, r, Vec3(500*r, 2.01*r, 0)));
    EXPECT_EQ(system.advance(2000*r/v).touches, 0);
    EXPECT_EQ(system.particle(0).v, Vec3(v, 0, 0));
}


TEST(system, collisionsThatFollowFromCollisions)
{
    // Newton's cradle, spread out over a long step: each sphere passes its speed on
    const Law law = elastic();
    const double r = 1e-6, v = 0.5;
    const int n = 6;
    dem::System system(law.table(), {});
    for (int k = 0; k < n; ++k)
    {
        system.add
        (
            sphere(law, k, r, Vec3(40*r*k, 0, 0), k ? Vec3(Vec3::Zero()) : Vec3(v, 0, 0))
        );
    }
    const dem::StepReport report = system.advance(40*r*(n + 2)/v);
    EXPECT_EQ(report.touches, n - 1);
    for (int k = 0; k < n; ++k)
    {
        const Vec3 expected(k == n - 1 ? v : 0, 0, 0);
        EXPECT_TRUE(near(system.particle(std::size_t(k)).v, expected, 1e-2*v));
    }
    // the last one has left where the chain would: each collision saves one diameter
    EXPECT_GT(system.particle(n - 1).x.x(), 40*r*n);
}


TEST(system, aChainOfCollisionsInACrowd)
{
    // In an island of many, candidates are looked for near the path that each has on its own:
    // what is pushed off it must still meet all that is in its way. Equal spheres, undamped,
    // head-on: each hands all of its velocity on. Others stand aside.
    const Law law = elastic();
    const double r = 1e-6, v = 1;
    const int chain = 6, crowd = 60;
    for (const bool islands : {true, false})
    {
        dem::TimeSettings time;
        time.islands = islands;
        time.stepsPerContact = 100;
        dem::System system(law.table(), time);
        for (int k = 0; k < chain; ++k)
        {
            system.add(sphere(law, k, r, Vec3(6*r*k, 0, 0), k ? Vec3(0, 0, 0) : Vec3(v, 0, 0)));
        }
        for (int k = 0; k < crowd; ++k)
        {
            system.add(sphere(law, chain + k, r, Vec3(3*r*(k%12), 2.5*r*(1 + k/12), 0)));
        }
        const dem::StepReport report = system.advance(40*r/v);
        EXPECT_EQ(report.touches, chain - 1);
        EXPECT_TRUE(near(system.particle(0).v.x(), 0, 2e-3*v));
        EXPECT_TRUE(near(system.particle(chain - 1).v.x(), v, 2e-3*v));
        for (int k = 0; k < crowd; ++k)
        {
            EXPECT_EQ(system.particle(std::size_t(chain + k)).v.norm(), 0);
        }
    }
}


//- One flies alone, one enters within the step; told once, as they arrive, and only if asked for
TEST(system, impactsOnWallsAreTold)
{
    const double r = 1e-6;
    const Law law = scene::stickyLaw();
    for (const bool asked : {true, false})
    {
        dem::Walls walls = scene::floor();
        walls.reportImpacts = asked;
        dem::System system(law.table(), {});
        system.setWalls(walls);
        system.setTime(5);
        const Vec3 v0(0.1, 0, -0.5), v1(0, 0.2, -0.5);
        system.add(sphere(law, 7, r, Vec3(9*r, 0, 1.4*r), v0));
        system.add(sphere(law, 3, r, Vec3(0, 0, 1.5*r), v1), 2e-7);
        std::vector<dem::WallImpact> hits;
        for (int k = 0; k < 4; ++k)
        {
            const dem::StepReport report = system.advance(1e-6);
            hits.insert(hits.end(), report.wallImpacts.begin(), report.wallImpacts.end());
        }
        ASSERT_EQ(hits.size(), asked ? 2u : 0u);
        if (!asked) continue;
        EXPECT_EQ(hits[0].id, 7);
        EXPECT_EQ(hits[0].index, 0u);
        EXPECT_EQ(hits[0].v, v0);
        EXPECT_TRUE(near(hits[0].time, 5 + 0.8e-6, 1e-9));
        EXPECT_TRUE(near(hits[0].x.x(), 9*r + 0.08*r, 1e-3*r));
        EXPECT_EQ(hits[1].id, 3);
        EXPECT_EQ(hits[1].index, 1u);
        EXPECT_EQ(hits[1].v, v1);
        EXPECT_TRUE(near(hits[1].time, 5 + 1.2e-6, 1e-9));
        for (const dem::WallImpact& h : hits)
        {
            EXPECT_EQ(h.patch, 0);
            EXPECT_EQ(h.omega, Vec3::Zero());
            EXPECT_EQ(h.n, Vec3(0, 0, -1));
            EXPECT_TRUE(near(h.x.z(), r, 1e-3*r));
        }
    }
}


TEST(system, attractionOfASlowPartnerIsNotMissed)
{
    // a sphere carried by the gas only: at rest at first, it meets the wall within the step
    Law law = scene::stickyLaw();
    dem::System system(law.table(), {});
    system.setWalls(scene::floor());
    const double r = 1e-6;
    system.add(sphere(law, 1, r, Vec3(0, 0, 3*r)));
    dem::GasLoad g;
    g.Sp = law.mass(r)/1e-7;
    g.Uc = Vec3(0, 0, -0.1);
    system.setGasLoad(0, g);
    EXPECT_EQ(system.advance(1e-4).touches, 1);
    EXPECT_TRUE(system.inContact(0));
    EXPECT_GT(system.particle(0).x.z(), 0.85*r);
}


TEST(system, flightIsTheClosedForm)
{
    Law law;
    dem::System system(law.table(), {});
    system.keepGasExchange(true);
    dem::Particle p = sphere(law, 5, 2e-6, Vec3(1, 2, 3), Vec3(1, -1, 0.5), Vec3(1, 2, 3));
    system.add(p);
    const dem::GasLoad g = scene::breeze(p, 0);
    system.setGasLoad(0, g);
    const dem::StepReport report = system.advance(1e-3);
    const Vec3 impulse = dem::fly(p, g, 1e-3);
    EXPECT_EQ(report.freeFlights, 1);
    EXPECT_EQ(report.contactSteps, 0);
    EXPECT_TRUE(scene::same(system.particle(0), p));
    EXPECT_EQ(system.gasExchange(0).impulse, impulse);
    EXPECT_EQ(system.time(), 1e-3);
    system.setTime(7);
    system.advance(0.5);
    EXPECT_EQ(system.time(), 7.5);
}


TEST(system, anIslandKnowsNothingOfTheOthers)
{
    // the same two spheres and the same floor, alone and among many other islands
    const Law law = scene::stickyLaw();
    const double far = 1e-3;
    const auto run = [&](int others)
    {
        dem::System system(law.table(), {});
        system.setWalls(scene::floor());
        for (int k = 0; k < others; ++k)
        {
            const auto dust = scene::rain(law, 5, 4e-6, unsigned(60 + k));
            for (dem::Particle p : dust)
            {
                p.id += 1000*(k + 1);
                p.x.x() += far*(k + 1);
                system.add(p);
            }
        }
        for (dem::Particle p : scene::rain(law, 12, 5e-6, 59)) system.add(p);
        for (int step = 0; step < 30; ++step)
        {
            scene::load(system);
            system.advance(1e-6);
        }
        std::vector<dem::Particle> own = scene::sorted(system);
        own.resize(12);
        EXPECT_GT(system.contacts().size(), 0u);
        return own;
    };
    const auto alone = run(0), among = run(20);
    for (std::size_t i = 0; i < alone.size(); ++i)
    {
        EXPECT_TRUE(scene::same(alone[i], among[i])) << alone[i].id;
    }
}


TEST(system, withoutIslandsTheSamePhysics)
{
    // one step for all, that of the stiffest possible contact: the same collisions within
    // the error of the steps, and every particle takes every step
    const Law law = scene::stickyLaw();
    const double r = 1e-6;
    const auto run = [&](bool islands)
    {
        dem::TimeSettings time = neverRests();
        time.islands = islands;
        time.stepsPerContact = 200;
        dem::System system(law.table(), time);
        system.setWalls(scene::floor());
        // one bounces off the floor, two collide, one flies on its own
        system.add(sphere(law, 1, r, Vec3(0, 0, 1.5*r), Vec3(2, 0, -20)));
        system.add(sphere(law, 2, r, Vec3(50*r, 0, 40*r), Vec3(10, 1, 0), Vec3(0, 1e6, 0)));
        system.add(sphere(law, 3, 0.7*r, Vec3(53*r, 0.3*r, 40*r)));
        system.add(sphere(law, 4, r, Vec3(0, 300*r, 40*r), Vec3(1, 1, 0)));
        dem::StepReport report;
        for (int step = 0; step < 10; ++step) report.add(system.advance(5e-8));
        EXPECT_EQ(report.touches, 2);
        EXPECT_EQ(report.separations, 2);
        EXPECT_EQ(report.freeFlights > 0, islands);
        return scene::sorted(system);
    };
    const auto with = run(true), without = run(false);
    for (std::size_t i = 0; i < with.size(); ++i)
    {
        SCOPED_TRACE(with[i].id);
        EXPECT_TRUE(near(without[i].v, with[i].v, 5e-3*(with[i].v.norm() + 1)));
        EXPECT_TRUE(near(without[i].x, with[i].x, 5e-3*5e-7*20));
    }
    EXPECT_TRUE(near(without[3].x, with[3].x, 1e-12*300*r));
}


TEST(system, islandsMissNoCollision)
{
    // many that fly through each other, light and heavy, over a floor, through several
    // collisions in a particle step: the same touches as when all take every step
    Law law = scene::stickyLaw();
    law.E = 2e9;
    law.gamma = 0.01;
    const double r = 5e-6, edge = 30*r, dt = 5e-6;
    dem::Periodic periodic;
    periodic.length = Vec3(edge, edge, 0);
    const auto cloud = [&](unsigned seed)
    {
        scene::Random random(seed);
        std::vector<dem::Particle> particles;
        while (particles.size() < 60)
        {
            const double radius = particles.size()%10 ? r*random.uniform(0.5, 1.5) : 3*r;
            const Vec3 x = Vec3(0, 0, 0.5*edge + 3.2*r) + random.inBox(0.5*edge);
            bool free = true;
            for (const dem::Particle& p : particles)
            {
                free = free && periodic.nearest(p.x - x).norm() > 1.02*(p.radius + radius);
            }
            if (!free) continue;
            const std::int64_t id = std::int64_t(particles.size());
            particles.push_back(sphere(law, id, radius, x, random.inBox(1.5)));
        }
        return particles;
    };
    std::int64_t touches = 0;
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        SCOPED_TRACE(seed);
        const auto run = [&](bool islands, dem::StepReport& report)
        {
            dem::TimeSettings time = neverRests();
            time.islands = islands;
            dem::System system(law.table(), time);
            system.setPeriodic(periodic);
            system.setWalls(scene::floor());
            for (const dem::Particle& p : cloud(seed)) system.add(p);
            for (int step = 0; step < 6; ++step)
            {
                for (std::size_t i = 0; seed%2 && i < system.size(); ++i)
                {
                    dem::GasLoad wind;
                    wind.Sp = system.particle(i).mass/2e-4;
                    wind.Uc = Vec3(2, 0, 0);
                    system.setGasLoad(i, wind);
                }
                report.add(system.advance(dt));
            }
            std::vector<Vec3> x;
            for (std::size_t i = 0; i < system.size(); ++i) x.push_back(system.particle(i).x);
            return x;
        };
        dem::StepReport with, without;
        const auto a = run(true, with), b = run(false, without);
        EXPECT_EQ(with.touches, without.touches);
        EXPECT_EQ(with.separations, without.separations);
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            EXPECT_LT(periodic.nearest(a[i] - b[i]).norm(), 0.5*r) << i;
        }
        touches += without.touches;
    }
    EXPECT_GT(touches, 300);
}


// * * * * * * * * * * * * * * * * Rest and wake * * * * * * * * * * * * * * * * * * * * //

TEST(rest, aStuckSphereComesToRest)
{
    const double r = 1e-6;
    const Law law = scene::stickyLaw();
    const auto system = stuckSphere(law, r);
    ASSERT_TRUE(system->resting(0));
    EXPECT_TRUE(system->inContact(0));
    EXPECT_EQ(system->particle(0).v, Vec3::Zero());
    EXPECT_EQ(system->particle(0).omega, Vec3::Zero());
    // near its equilibrium: energy 0.1 F_C delta_0 and force 0.1 F_C were allowed
    const formula::Contact c = law.contact(r, -1);
    EXPECT_TRUE(near(r - system->particle(0).x.z(), c.delta0(), 0.6*c.delta0()));

    // at rest it costs nothing and does not move
    const Vec3 x = system->particle(0).x;
    const dem::StepReport report = system->advance(1e-3);
    EXPECT_EQ(report.contactSteps, 0);
    EXPECT_EQ(report.islands, 0);
    EXPECT_EQ(report.resting, 1);
    EXPECT_EQ(report.inContact, 1);
    EXPECT_EQ(system->particle(0).x, x);
}


//- One is thrown against a mirror, another lies on the floor and against the mirror, a third is
//  pressed to the mirror only
TEST(rest, aMirrorHoldsNothing)
{
    const double r = 1e-6;
    for (const double chi : {1.0, 0.01})
    {
        SCOPED_TRACE(scene::text(chi));
        Law law = scene::stickyLaw();
        law.softening.ratio = chi;
        dem::MaterialTable table = law.table();
        dem::Walls walls = scene::floor();
        walls.patches.push_back({"symmetry", dem::mirror});
        walls.planes.push_back({Vec3::Zero(), Vec3::UnitY(), 1});
        dem::System strict(table, {});
        EXPECT_THROW(strict.setWalls(walls), dem::inputError);
        table.addMirrors();
        dem::TimeSettings time;
        time.stepsPerContact = 200;
        dem::System system(table, time);
        system.setWalls(walls);
        const double deep = table.figures(0, 1, r, -1, law.mass(r), 0, 1).delta0;
        system.add(sphere(law, 1, r, Vec3(0, 3*r, 10*r), Vec3(0.1, -0.1, 0)));
        system.add(sphere(law, 2, r, Vec3(9*r, r - 1e-11, r - deep)));
        system.add(sphere(law, 3, r, Vec3(50*r, r - 1e-11, 10*r)));
        dem::GasLoad press;
        press.Sp = 1e-6;
        press.Su = Vec3(0, -1e-10, 0);
        system.setGasLoad(2, press);
        dem::StepReport all;
        for (int k = 0; k < 40; ++k) all.add(system.advance(1e-6));

        const dem::Particle& thrown = system.particle(0);
        EXPECT_EQ(thrown.v.x(), 0.1);
        EXPECT_TRUE(near(thrown.v.y(), 0.1, 1e-7));
        EXPECT_EQ(thrown.omega, Vec3::Zero());
        const double took = 4e-5 - (2*r + thrown.x.y() - r)/0.1;
        const double time0 =
            table.figures(0, dem::mirror, r, -1, law.mass(r), 0, 0.1).impactTime;
        EXPECT_TRUE(near(took, time0, 1e-3*time0));
        EXPECT_TRUE(system.resting(1));
        EXPECT_TRUE(system.inContact(2));
        EXPECT_FALSE(system.resting(2));

        // the floor is all that is told of
        EXPECT_EQ(all.followerTouches, 0);
        EXPECT_LT(all.maxOverlapOverDiameter, deep/r);
        EXPECT_EQ(system.contacts().size(), 1u);
        EXPECT_EQ(system.adhesionMargins().size(), 1u);
        EXPECT_FALSE(system.clusters()[0].onWall);
        EXPECT_TRUE(system.clusters()[1].onWall);
        EXPECT_FALSE(system.clusters()[2].onWall);
        EXPECT_EQ(system.wallNormal(1), Vec3(0, 0, -1));
        EXPECT_EQ(system.wallNormal(2), Vec3::Zero());
        EXPECT_EQ(system.setRatio(0.5).contacts, 3);
    }
}


TEST(rest, noToleranceNoRest)
{
    const Law law = scene::stickyLaw();
    const auto system = stuckSphere(law, 1e-6, 0);
    EXPECT_FALSE(system->resting(0));
    EXPECT_TRUE(system->inContact(0));
    EXPECT_GT(system->advance(1e-6).contactSteps, 0);
}


TEST(rest, wakesWhenHit)
{
    const Law law = scene::stickyLaw();
    const double r = 1e-6;
    const auto system = stuckSphere(law, r);
    ASSERT_TRUE(system->resting(0));
    // fast enough to load it with more than F_C
    system->add(sphere(law, 2, r, Vec3(0.3*r, 0, 4*r), Vec3(0, 0, -10)));
    // on its way it wakes nobody
    dem::StepReport report = system->advance(0.05e-6);
    EXPECT_EQ(report.wakes, 0);
    EXPECT_TRUE(system->resting(0));
    report = dem::StepReport();
    for (int k = 0; k < 10; ++k) report.add(system->advance(0.02e-6));
    EXPECT_GE(report.wakes, 1);
    EXPECT_GE(report.touches, 1);
    EXPECT_NE(system->particle(0).v, Vec3::Zero());
}


TEST(rest, wakesWhenTheGasForceChanges)
{
    const Law law = scene::stickyLaw();
    const double r = 1e-6;
    const formula::Contact c = law.contact(r, -1), real = law.contact(r, -1, true);
    // M_y/r of the original contact, or F_C as softened: the smaller counts
    const double yield = 4*real.pullOff()*(0.4*real.a0()/12)/r;
    const double wake = 0.1*std::min(c.pullOff(), yield);

    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, -0.6, 0.8)})
    {
        const auto system = stuckSphere(law, r);
        ASSERT_TRUE(system->resting(0));
        dem::GasLoad g;
        g.Su = 0.99*wake*direction;
        system->setGasLoad(0, g);
        EXPECT_EQ(system->advance(1e-7).wakes, 0);
        EXPECT_TRUE(system->resting(0));
        // drag counts with the gas velocity
        g.Sp = 1e-9;
        g.Uc = 0.02*wake/g.Sp*direction;
        system->setGasLoad(0, g);
        EXPECT_EQ(system->advance(1e-7).wakes, 1);
    }

    // a force above the pull-off force takes it away
    const auto system = stuckSphere(law, r);
    dem::GasLoad g;
    g.Su = Vec3(0, 0, 1.5*c.pullOff());
    system->setGasLoad(0, g);
    for (int k = 0; k < 20; ++k) system->advance(1e-7);
    EXPECT_FALSE(system->inContact(0));
    EXPECT_GT(system->particle(0).v.z(), 0);
}


TEST(rest, wakesWhenMovedFromOutside)
{
    const auto system = stuckSphere(scene::stickyLaw(), 1e-6);
    ASSERT_TRUE(system->resting(0));
    const Vec3 x = system->particle(0).x;
    system->setMotion(0, x, Vec3(0, 0, 5), Vec3::Zero());
    system->advance(1e-6);
    EXPECT_FALSE(system->resting(0));
    EXPECT_GT(system->particle(0).x.z(), x.z());
}


TEST(rest, wakingSpreadsAsFarAsTheLoad)
{
    // a stack of two at rest; the gas pulls at the lower one. A small pull wakes it alone; one
    // that tears it off the wall wakes the upper one as well
    const Law law = scene::stickyLaw();
    const double r = 1e-6;
    for (const double pull : {0.2, 3.0})   // a sudden load acts twofold
    {
        const auto system = stuckSphere(law, r);
        system->add(sphere(law, 2, r, Vec3(0, 0, 3.01*r), Vec3(0, 0, -0.2)));
        for (int k = 0; k < 400 && !(system->resting(0) && system->resting(1)); ++k)
        {
            system->advance(1e-7);
        }
        ASSERT_TRUE(system->resting(0) && system->resting(1));
        dem::GasLoad g;
        g.Su = Vec3(0, 0, pull*law.contact(r, -1).pullOff());
        system->setGasLoad(0, g);
        EXPECT_EQ(system->advance(1e-8).wakes, 1);
        EXPECT_FALSE(system->resting(0));
        EXPECT_TRUE(system->resting(1));
        for (int k = 0; k < 20; ++k) system->advance(1e-7);
        EXPECT_EQ(system->resting(1), pull < 1);
    }
}


TEST(rest, theRimForgetsWhatIsGone)
{
    // one at rest on the floor is hit; beside it, closer than a neck, is one that rested on what
    // is gone: it is not woken, and touches nothing any more
    const Law law = scene::stickyLaw();
    const double r = 1e-6;
    dem::System system(law.table(), {});
    system.setWalls(scene::floor());
    const double neck = system.materials().reach(0, r, system.walls());
    ASSERT_GT(neck, 0);
    system.add(sphere(law, 1, r, Vec3(0, 0, r)));
    system.add(sphere(law, 2, r, Vec3(2*r + 0.1*neck, 0, r)));
    system.add(sphere(law, 3, r, Vec3(-0.1*r, 0, 3.01*r), Vec3(0, 0, -1)));
    dem::RestState rest;
    rest.inContact = rest.resting = true;
    rest.wakeForce = rest.pullOff = 1e-3;
    const auto state = [&](const dem::ContactRecord& c)
    {
        std::vector<double> numbers{double(dem::PackedState::version)};
        dem::pack(rest, numbers);
        dem::pack(c, numbers);
        return numbers;
    };
    system.unpackState(0, state({-1, 0, {0, 0, -1}, {}}));
    system.unpackState(1, state({77, -1, {}, {}}));
    EXPECT_TRUE(system.inContact(1));

    const dem::StepReport report = system.advance(0.05e-6);
    EXPECT_EQ(report.touches, 1);
    EXPECT_EQ(report.wakes, 0);
    EXPECT_EQ(report.resting, 2);
    EXPECT_TRUE(system.resting(1));
    EXPECT_FALSE(system.inContact(1));
    EXPECT_EQ(report.inContact, 2);
}


TEST(rest, flagsAndCountsAreWhatContactsSay)
{
    // a rain that comes to rest and is hit again and again, so that much is rim
    const Law law = scene::stickyLaw();
    dem::System system(law.table(), {});
    system.setWalls(scene::floor());
    std::int64_t resting = 0;
    for (int k = 0; k < 120; ++k)
    {
        if (k%30 == 0)
        {
            for (dem::Particle p : scene::rain(law, 40, 6e-6, 41 + unsigned(k)))
            {
                p.id += 1000*k;
                p.x.z() += 30e-6;
                system.add(p);
            }
        }
        const dem::StepReport report = system.advance(1e-6);
        std::set<std::int64_t> bonded;
        for (const dem::ContactView& c : system.contacts())
        {
            bonded.insert(c.idI);
            bonded.insert(c.idJ);
        }
        std::int64_t rests = 0, touches = 0;
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            rests += system.resting(i);
            touches += system.inContact(i);
            ASSERT_EQ(system.inContact(i), bonded.count(system.particle(i).id) == 1) << k;
        }
        ASSERT_EQ(report.resting, rests);
        ASSERT_EQ(report.inContact, touches);
        resting = std::max(resting, rests);
    }
    EXPECT_GT(resting, 60);
}


TEST(rest, namesThoseWhomAStepMayHaveChanged)
{
    // as above; what awake() and moved() do not name is as it was, and that is most of it
    const Law law = scene::stickyLaw();
    dem::System system(law.table(), {});
    system.setWalls(scene::floor());
    std::size_t most = 0, largest = 0;
    for (int k = 0; k < 120; ++k)
    {
        if (k%30 == 0)
        {
            for (dem::Particle p : scene::rain(law, k ? 3 : 120, k ? 2e-6 : 10e-6, 41 + unsigned(k)))
            {
                p.id += 1000*k;
                p.x.z() += 30e-6;
                system.add(p);
            }
        }
        std::vector<std::size_t> awake;
        std::vector<std::vector<double>> before;
        std::vector<dem::Particle> there;
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            if (!system.resting(i)) awake.push_back(i);
            there.push_back(system.particle(i));
            before.push_back(system.packState(i));
        }
        ASSERT_EQ(system.awake(), awake) << k;

        system.advance(1e-6);
        std::set<std::size_t> moved(system.moved().begin(), system.moved().end());
        ASSERT_EQ(moved.size(), system.moved().size()) << k;
        for (const std::size_t i : awake) ASSERT_TRUE(moved.count(i)) << k;
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            if (moved.count(i)) continue;
            const dem::Particle& p = system.particle(i);
            ASSERT_EQ(p.x, there[i].x);
            ASSERT_EQ(p.v, there[i].v);
            ASSERT_EQ(p.omega, there[i].omega);
            ASSERT_EQ(system.packState(i), before[i]);
        }
        if (k > 60) most = std::max(most, moved.size());
        largest = system.size();
    }
    EXPECT_GT(most, 2u);
    EXPECT_LT(most, largest/2);
    system.remove(std::vector<char>(largest, 1));
    EXPECT_TRUE(system.moved().empty());
    EXPECT_TRUE(system.awake().empty());
}


// * * * * * * * * * * * * * Adding, removing, restarting * * * * * * * * * * * * * * * * //

TEST(system, removeClosesTheGapsAndEndsContacts)
{
    const Law law = scene::stickyLaw();
    dem::System system(law.table(), neverRests());
    const double r = 1e-6;
    const formula::Contact c = law.contact(r, r);
    for (int k = 0; k < 5; ++k)
    {
        system.add(sphere(law, 10 - k, r, Vec3((2*r - c.delta0())*k, 0, 0)));
    }
    system.advance(1e-9);
    EXPECT_EQ(system.contacts().size(), 4u);
    system.remove({0, 1, 0, 0, 0});
    ASSERT_EQ(system.size(), 4u);
    const std::int64_t ids[] = {10, 8, 7, 6};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(system.particle(i).id, ids[i]);
    EXPECT_EQ(system.contacts().size(), 2u);
    system.advance(1e-9);
    EXPECT_EQ(system.contacts().size(), 2u);
    EXPECT_FALSE(system.inContact(0));
    EXPECT_TRUE(system.inContact(1));
    // the id is free again
    system.add(sphere(law, 9, r, Vec3(0, 0, 1)));
    EXPECT_THROW(system.particle(5), dem::inputError);
}


TEST(system, restartIsExact)
{
    // run(2T) = run(T), packed into another system, run(T): to the last bit, with contacts,
    // springs and resting particles
    const Law law = scene::stickyLaw();
    const double dt = 1e-6;
    dem::System whole(law.table(), {});
    whole.setWalls(scene::floor());
    const auto dust = scene::rain(law, 60, 6e-6, 41);
    for (const dem::Particle& p : dust) whole.add(p);

    const int steps = 60;
    std::int64_t sleeps = 0, restingAtRestart = 0;
    std::unique_ptr<dem::System> parts;
    for (int step = 0; step < steps; ++step)
    {
        if (step%15 == 0)
        {
            dem::System& from = parts ? *parts : whole;
            auto next = std::make_unique<dem::System>(law.table(), dem::TimeSettings());
            next->setWalls(scene::floor());
            next->setTime(from.time());
            // in another order
            for (std::size_t k = from.size(); k-- > 0;) next->add(from.particle(k));
            for (std::size_t k = 0; k < from.size(); ++k)
            {
                next->unpackState(from.size() - 1 - k, from.packState(k));
            }
            EXPECT_EQ(next->contacts().size(), from.contacts().size());
            parts = std::move(next);
            for (std::size_t k = 0; k < parts->size(); ++k)
            {
                restingAtRestart += parts->resting(k);
            }
        }
        scene::load(whole);
        scene::load(*parts);
        sleeps += whole.advance(dt).sleeps;
        parts->advance(dt);
        const auto a = scene::sorted(whole), b = scene::sorted(*parts);
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            ASSERT_TRUE(scene::same(a[i], b[i])) << "particle " << a[i].id << " step " << step;
        }
    }
    // the scene has shown what it is for
    EXPECT_GT(sleeps, 0);
    EXPECT_GT(restingAtRestart, 0);
    EXPECT_GT(whole.contacts().size(), 20u);
}


TEST(system, wallsHaveOtherNumbersAfterARestart)
{
    // a sphere that touches the floor: the floor is another patch, or gone
    const Law law = scene::stickyLaw();
    dem::System system(law.table(), {});
    system.setWalls(scene::floor());
    system.add(sphere(law, 1, 1e-6, Vec3(0, 0, 0.999e-6)));
    system.advance(1e-7);
    ASSERT_EQ(system.contacts().size(), 1u);

    const auto restart = [&](const std::vector<int>& wallNow, std::vector<int>& gone)
    {
        auto next = std::make_unique<dem::System>(law.table(), dem::TimeSettings());
        dem::Walls walls = scene::floor();
        walls.patches.insert(walls.patches.begin(), walls.patches.front());
        next->setWalls(std::move(walls));
        next->add(system.particle(0));
        gone = next->unpackState(0, system.packState(0), wallNow);
        return next;
    };
    std::vector<int> gone;
    auto moved = restart({1}, gone);
    EXPECT_TRUE(gone.empty());
    ASSERT_EQ(moved->contacts().size(), 1u);
    EXPECT_EQ(moved->contacts()[0].wall, 1);

    auto ended = restart({-1}, gone);
    EXPECT_EQ(gone, std::vector<int>({0}));
    EXPECT_TRUE(ended->contacts().empty());
    EXPECT_THROW(restart({2}, gone), dem::inputError) << "there are two walls";
}


TEST(system, diagnosticsChangeNothing)
{
    const Law law = scene::stickyLaw();
    const auto run = [&](bool watched)
    {
        dem::System system(law.table(), {});
        system.setWalls(scene::floor());
        for (const dem::Particle& p : scene::rain(law, 40, 6e-6, 43)) system.add(p);
        for (int step = 0; step < 25; ++step)
        {
            scene::load(system);
            system.advance(1e-6);
            if (!watched) continue;
            system.contacts();
            system.clusters();
            system.adhesionMargins();
            std::string wall;
            const dem::Box box{Vec3::Constant(-1e-5), Vec3::Constant(1e-5)};
            system.entrance(box, 1e-6, 1e-6, 1).overlap(Vec3::Zero(), 1e-6, 0, wall);
            for (std::size_t i = 0; i < system.size(); ++i) system.packState(i);
        }
        return scene::sorted(system);
    };
    const auto a = run(false), b = run(true);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(scene::same(a[i], b[i]));
}


TEST(system, contactsAsDiagnosticsSeeThem)
{
    const Law law = scene::stickyLaw();
    const double r = 1e-6;
    dem::System system(law.table(), neverRests());
    system.setWalls(scene::floor());
    const formula::Contact wall = law.contact(r, -1), pair = law.contact(r, r);
    system.add(sphere(law, 4, r, Vec3(0, 0, r - wall.delta0())));
    system.add
    (
        sphere(law, 2, r, Vec3(0, 0, 3*r - wall.delta0() - 1.2*pair.delta0()))
    );
    system.advance(1e-13);
    const auto contacts = system.contacts();
    ASSERT_EQ(contacts.size(), 2u);
    for (const dem::ContactView& v : contacts)
    {
        if (v.wall >= 0)
        {
            EXPECT_EQ(v.idI, 4);
            EXPECT_EQ(v.idJ, -1);
            EXPECT_EQ(system.walls().patchName(v.wall), "floor");
            EXPECT_TRUE(near(v.normal, Vec3(0, 0, -1), 1e-12));
            EXPECT_TRUE(close(v.overlap, wall.delta0(), 1e-5));
            EXPECT_TRUE(close(v.pullOff, wall.pullOff(), 1e-12));
            EXPECT_TRUE(close(v.contactRadius, wall.a0(), 1e-5));
            EXPECT_TRUE(near(v.force.norm(), 0, 1e-4*wall.pullOff()));
        }
        else
        {
            EXPECT_EQ(v.idI, 2);    // the lower id
            EXPECT_EQ(v.idJ, 4);
            EXPECT_TRUE(near(v.normal, Vec3(0, 0, -1), 1e-12));
            EXPECT_TRUE(close(v.overlap, 1.2*pair.delta0(), 1e-5));
            EXPECT_TRUE(close(v.pullOff, pair.pullOff(), 1e-12));
            const double F = formula::normal("JKR", pair, v.overlap, 1).force;
            EXPECT_TRUE(close(v.force.z(), F, 1e-3));
        }
    }

    // two clusters, one on the wall
    system.add(sphere(law, 9, r, Vec3(1e-3, 0, 1e-3)));
    const auto clusters = system.clusters();
    ASSERT_EQ(clusters.size(), 3u);
    EXPECT_EQ(clusters[0].root, 2);
    EXPECT_EQ(clusters[1].root, 2);
    EXPECT_TRUE(clusters[0].onWall && clusters[1].onWall);
    EXPECT_EQ(clusters[2].root, 9);
    EXPECT_FALSE(clusters[2].onWall);

    // margins: the foot carries the load of both
    dem::GasLoad g;
    g.Su = Vec3(1e-9, 0, 0);
    system.setGasLoad(0, g);
    system.setGasLoad(1, g);
    auto margins = system.adhesionMargins();
    ASSERT_EQ(margins.size(), 2u);
    std::sort(margins.begin(), margins.end());
    EXPECT_TRUE(close(margins[0], wall.pullOff()/2e-9, 1e-9));
    EXPECT_TRUE(close(margins[1], pair.pullOff()/1e-9, 1e-9));
}


// * * * * * * * * * * * * * * * * * Refusals * * * * * * * * * * * * * * * * * * * * * * //

TEST(system, refusesLoadsThatAreNotFinite)
{
    const FloatingTraps traps;
    const Law law;
    dem::System system(law.table(), {});
    system.add(sphere(law, 4711, 1e-6, Vec3::Zero()));
    system.setTime(0.25);
    const double bad[] = {NAN, INFINITY};
    for (const double b : bad)
    {
        for (int field = 0; field < 5; ++field)
        {
            dem::GasLoad g;
            if (field == 0) g.Sp = b;
            if (field == 1) g.Uc.y() = b;
            if (field == 2) g.Su.z() = b;
            if (field == 3) g.SpOmega = b;
            if (field == 4) g.omegaC.x() = b;
            try
            {
                system.setGasLoad(0, g);
                ADD_FAILURE() << "field " << field << " was accepted";
            }
            catch (const dem::numericalError& e)
            {
                const std::string message = e.what();
                EXPECT_NE(message.find("4711"), std::string::npos) << message;
                EXPECT_NE(message.find("0.25"), std::string::npos) << message;
            }
        }
    }
    dem::GasLoad g;
    g.Sp = -1e-12;
    EXPECT_THROW(system.setGasLoad(0, g), dem::numericalError);
    EXPECT_THROW(system.advance(0), dem::inputError);
    EXPECT_THROW(system.advance(-1), dem::inputError);
    EXPECT_THROW(system.advance(NAN), dem::inputError);
}


TEST(system, refusesImpossibleParticlesAndSettings)
{
    const FloatingTraps traps;
    const Law law;
    dem::System system(law.table(), {});
    const dem::Particle good = sphere(law, 1, 1e-6, Vec3::Zero());
    system.add(good);
    const auto refused = [&](auto change)
    {
        dem::Particle p = good;
        p.id = 2;
        change(p);
        EXPECT_THROW(system.add(p), dem::inputError);
        EXPECT_EQ(system.size(), 1u);
    };
    refused([](dem::Particle& p) { p.id = 1; });
    refused([](dem::Particle& p) { p.id = -1; });
    refused([](dem::Particle& p) { p.radius = 0; });
    refused([](dem::Particle& p) { p.radius = -1e-6; });
    refused([](dem::Particle& p) { p.radius = NAN; });
    refused([](dem::Particle& p) { p.mass = 0; });
    refused([](dem::Particle& p) { p.mass = NAN; });
    refused([](dem::Particle& p) { p.material = 2; });
    refused([](dem::Particle& p) { p.material = -1; });
    refused([](dem::Particle& p) { p.x.x() = NAN; });
    refused([](dem::Particle& p) { p.v.y() = INFINITY; });
    refused([](dem::Particle& p) { p.omega.z() = NAN; });
    // a refused id may be used afterwards
    EXPECT_NO_THROW(system.add(sphere(law, 2, 1e-6, Vec3(1, 0, 0))));

    dem::TimeSettings t;
    t.stepsPerContact = 3;
    EXPECT_THROW(dem::System(law.table(), t), dem::inputError);
    t.stepsPerContact = NAN;
    EXPECT_THROW(dem::System(law.table(), t), dem::inputError);
    t = {};
    t.restTolerance = -1;
    EXPECT_THROW(dem::System(law.table(), t), dem::inputError);

    EXPECT_THROW(system.unpackState(0, std::vector<double>(5, 0.0)), dem::inputError);
}


TEST(system, refusesOverlapsThatNoLawCovers)
{
    // two spheres one inside the other: named, not integrated
    const Law law;
    dem::System system(law.table(), {});
    system.add(sphere(law, 77, 1e-6, Vec3::Zero()));
    system.add(sphere(law, 78, 1e-6, Vec3(0.2e-6, 0, 0)));
    try
    {
        system.advance(1e-9);
        ADD_FAILURE() << "was accepted";
    }
    catch (const dem::numericalError& e)
    {
        const std::string message = e.what();
        EXPECT_NE(message.find("77"), std::string::npos) << message;
        EXPECT_NE(message.find("78"), std::string::npos) << message;
        EXPECT_NE(message.find("time"), std::string::npos) << message;
    }
}
