// SPDX-License-Identifier: GPL-3.0-or-later
//
// Room for new spheres at a moment, and spheres that enter within a particle step.
#include "clouds.hpp"
#include "contacts/ContactRecord.hpp"
#include "contacts/PackedState.hpp"
#include "foundation/Fields.hpp"

using dem::Vec3;
using scene::Law;
using scene::near;
using scene::sphere;

namespace
{

constexpr double r = 1e-6;
const dem::Box everywhere{Vec3::Constant(-1e-4), Vec3::Constant(1e-4)};

//- Runs a scene in which `late` enters after `delay`: in one particle step, or in two of which
//  the second begins with it
std::vector<dem::Particle> run
(
    bool atOnce, const std::vector<dem::Particle>& there, const dem::Particle& late,
    double delay, double dt, dem::StepReport& report
)
{
    const Law law = scene::stickyLaw();
    dem::System system(law.table(), {});
    system.setWalls(scene::floor());
    system.keepGasExchange(true);
    for (const dem::Particle& p : there) system.add(p);
    const auto load = [&]
    {
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            system.setGasLoad(i, scene::breeze(system.particle(i), 0));
        }
    };
    if (!atOnce)
    {
        load();
        report.add(system.advance(delay));
    }
    system.add(late, atOnce ? delay : 0);
    load();
    report.add(system.advance(atOnce ? dt : dt - delay));
    return scene::sorted(system);
}

void compare
(
    const std::vector<dem::Particle>& there, const dem::Particle& late, double touches
)
{
    dem::StepReport one, two;
    const double delay = 3.3e-6, dt = 1e-5;
    const auto a = run(true, there, late, delay, dt, one);
    const auto b = run(false, there, late, delay, dt, two);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        EXPECT_EQ(a[i].id, b[i].id);
        EXPECT_LT((a[i].x - b[i].x).norm(), 1e-13) << a[i].id;
        EXPECT_LT((a[i].v - b[i].v).norm(), 1e-6) << a[i].id;
    }
    EXPECT_EQ(one.touches, two.touches);
    EXPECT_EQ(double(one.touches), touches);
}

}


TEST(entrance, overlapWithWallsAndSpheres)
{
    const Law law;
    dem::System system(law.table(), {});
    system.setWalls(scene::floor());
    system.add(sphere(law, 1, r, Vec3(0, 0, 5e-6)));
    const dem::Entrance entrance = system.entrance(everywhere, 0, r, 0);
    std::string wall;
    EXPECT_TRUE(near(entrance.overlap(Vec3(0, 0, 0.8e-6), r, 0, wall), 0.2e-6, 1e-18));
    EXPECT_EQ(wall, "floor");
    EXPECT_TRUE(near(entrance.overlap(Vec3(0, 0, 6.5e-6), r, 0, wall), 0.5e-6, 1e-18));
    EXPECT_EQ(wall, "");
    EXPECT_TRUE(near(entrance.overlap(Vec3(0, 0, 2.5e-6), r, 0, wall), -0.5e-6, 1e-18));
    EXPECT_LT(entrance.overlap(Vec3(1, 0, 0.01), r, 0, wall), 0);
    // beyond the wall
    EXPECT_GT(entrance.overlap(Vec3(0, 0, -1e-6), r, 0, wall), 1.9e-6);
}


TEST(entrance, othersAreWhereTheyAreByThen)
{
    const Law law;
    dem::System system(law.table(), {});
    system.add(sphere(law, 1, r, Vec3(-8e-6, 0, 0), Vec3(1, 0, 0)));
    dem::Entrance entrance = system.entrance(everywhere, 1e-5, r, 2);
    std::string wall;
    EXPECT_LT(entrance.overlap(Vec3::Zero(), r, 0, wall), 0);
    EXPECT_TRUE(near(entrance.overlap(Vec3::Zero(), r, 8e-6, wall), 2*r, 1e-15));

    // one that enters is in the way of the next, at its moment and where it flies
    const Vec3 x(0, 2e-5, 0);
    EXPECT_LT(entrance.overlap(x, r, 1e-6, wall), 0);
    entrance.enter(x, Vec3(2, 0, 0), r, 1e-6);
    EXPECT_TRUE(near(entrance.overlap(x, r, 1e-6, wall), 2*r, 1e-15));
    EXPECT_TRUE(near(entrance.overlap(x, r, 1.5e-6, wall), r, 1e-15));
    EXPECT_LT(entrance.overlap(x, r, 3e-6, wall), 0);
    EXPECT_TRUE(near(entrance.overlap(x + Vec3(1e-5, 0, 0), r, 6e-6, wall), 2*r, 1e-15));
}


TEST(entrance, asIfAllHadBeenLookedAt)
{
    const Law law;
    scene::Random random(7);
    dem::System system(law.table(), {});
    dem::Periodic periodic;
    periodic.low = Vec3::Constant(-5e-5);
    periodic.length = Vec3(1e-4, 0, 1e-4);
    system.setPeriodic(periodic);
    for (int i = 0; i < 3000; ++i)
    {
        const double radius = random.uniform(0.2e-6, 2e-6);
        const Vec3 x = random.inBox(5e-5), v = i%2 ? random.inBox(3) : Vec3(Vec3::Zero());
        system.add(sphere(law, i, radius, x, v));
        if (i%2) continue;
        // at rest
        dem::RestState rest;
        rest.inContact = rest.resting = true;
        std::vector<double> state{double(dem::PackedState::version)};
        dem::pack(rest, state);
        system.unpackState(std::size_t(i), state);
        ASSERT_TRUE(system.resting(std::size_t(i)));
    }
    const double dt = 2e-6;
    const dem::Box box{Vec3(-5e-5, -2e-5, -5e-5), Vec3(-4e-5, 2e-5, 5e-5)};
    const dem::Entrance entrance = system.entrance(box, dt, 1e-6, 1);
    int blocked = 0;
    for (int k = 0; k < 2000; ++k)
    {
        const Vec3 u = random.inBox(0.5) + Vec3::Constant(0.5);
        const Vec3 x = box.low + u.cwiseProduct(box.high - box.low);
        const double radius = random.uniform(0.2e-6, 1e-6), delay = random.uniform(0, dt);
        double largest = -1e300;
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            const dem::Particle& p = system.particle(i);
            const double distance = periodic.nearest(p.x + delay*p.v - x).norm();
            largest = std::max(largest, radius + p.radius - distance);
        }
        std::string wall;
        const double found = entrance.overlap(x, radius, delay, wall);
        EXPECT_EQ(found >= 0, largest >= 0);
        if (largest < 0) continue;
        ++blocked;
        EXPECT_TRUE(near(found, largest, 1e-18));
    }
    EXPECT_GT(blocked, 100);
    EXPECT_LT(blocked, 1900);
}


TEST(entrance, fliesForTheRestOfTheStep)
{
    const Law law = scene::stickyLaw();
    compare({}, sphere(law, 5, r, Vec3(0, 0, 5e-5), Vec3(1, 0, 0)), 0);
}


TEST(entrance, meetsWhatIsInItsWay)
{
    const Law law = scene::stickyLaw();
    const dem::Particle other = sphere(law, 3, r, Vec3(4e-6, 0.3e-6, 5e-5));
    compare({other}, sphere(law, 5, r, Vec3(0, 0, 5e-5), Vec3(1.5, 0, 0)), 1);
    compare({other}, sphere(law, 1, r, Vec3(0, 0, 5e-5), Vec3(1.5, 0, 0)), 1);
}


TEST(entrance, meetsTheWall)
{
    const Law law = scene::stickyLaw();
    compare({}, sphere(law, 5, r, Vec3(0, 0, 3e-6), Vec3(0, 0, -1)), 1);
}


TEST(entrance, nothingMeetsItBefore)
{
    // the other one has crossed its place by then
    const Law law = scene::stickyLaw();
    const dem::Particle other = sphere(law, 3, r, Vec3(-3e-6, 0, 5e-5), Vec3(3, 0, 0));
    compare({other}, sphere(law, 5, r, Vec3(0, 0, 5e-5)), 0);
}


TEST(entrance, amongOthersThatCollide)
{
    const Law law = scene::stickyLaw();
    const std::vector<dem::Particle> there = scene::rain(law, 30, 6e-6, 11);
    dem::StepReport one, two;
    const dem::Particle late = sphere(law, 1000, r, Vec3(0, 0, 1.6e-5), Vec3(0, 0, -2));
    const auto a = run(true, there, late, 2e-6, 6e-6, one);
    const auto b = run(false, there, late, 2e-6, 6e-6, two);
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        EXPECT_LT((a[i].x - b[i].x).norm(), 1e-9) << a[i].id;
    }
    EXPECT_GT(one.touches, 5);
    EXPECT_NEAR(double(one.touches), double(two.touches), 1);
}


TEST(entrance, hitsACakeAtRest)
{
    // the same in one particle step and in two, for those whom it wakes and for the rim
    struct Result
    {
        std::vector<dem::Particle> particles;
        dem::StepReport report;
        std::vector<bool> resting, inContact;
        std::vector<Vec3> impulses;
    };
    const Vec3 pull(0, 0, -1e-13);
    const double delays[2] = {0.5e-7, 2e-7}, dt = 2.5e-7;
    const auto run = [&](bool atOnce)
    {
        const Law law = scene::stickyLaw();
        dem::System system(law.table(), {});
        system.setWalls(scene::floor());
        system.keepGasExchange(true);
        for (const dem::Particle& p : scene::rain(law, 60, 3e-6, 11)) system.add(p);
        const auto load = [&]
        {
            for (std::size_t i = 0; i < system.size(); ++i)
            {
                dem::GasLoad g;
                g.Su = pull;
                system.setGasLoad(i, g);
            }
        };
        load();
        for (int k = 0; k < 300; ++k) system.advance(1e-6);
        Vec3 top = Vec3::Zero();
        int atRest = 0;
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            const dem::Particle& p = system.particle(i);
            const Vec3 at = p.x + Vec3(0, 0, p.radius);
            if (system.resting(i) && at.z() > top.z()) top = at;
            atRest += system.resting(i);
        }
        EXPECT_GT(atRest, 50);
        // the second one enters when the first has woken some of the rim
        const Vec3 x = top + Vec3(0, 0, 1.2*r);
        const dem::Particle late[2] =
        {
            sphere(law, 5000, r, x, Vec3(0, 0, -8)),
            sphere(law, 5001, r, x + Vec3(2.1*r, 0, 0), Vec3(0, 0, -1))
        };
        Result result;
        double now = 0;
        for (int k = 0; k < 2; ++k)
        {
            if (!atOnce) result.report.add(system.advance(delays[k] - now));
            now = delays[k];
            system.add(late[k], atOnce ? now : 0);
            load();
        }
        result.report.add(system.advance(atOnce ? dt : dt - now));
        result.particles = scene::sorted(system);
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            result.resting.push_back(system.resting(i));
            result.inContact.push_back(system.inContact(i));
            result.impulses.push_back(system.gasExchange(i).impulse);
        }
        return result;
    };
    const Result a = run(true), b = run(false);
    EXPECT_GT(a.report.repeats, 0);
    EXPECT_GT(a.report.wakes, 1);
    EXPECT_EQ(a.report.islands, 1);
    EXPECT_EQ(a.report.wakes, b.report.wakes);
    EXPECT_EQ(a.report.touches, b.report.touches);
    EXPECT_EQ(a.resting, b.resting);
    EXPECT_EQ(a.inContact, b.inContact);
    for (std::size_t i = 0; i < a.particles.size(); ++i)
    {
        EXPECT_LT((a.particles[i].x - b.particles[i].x).norm(), 1e-9) << i;
        const std::int64_t id = a.particles[i].id;
        const double flown = id < 5000 ? dt : dt - delays[id - 5000];
        EXPECT_LT((a.impulses[i] - flown*pull).norm(), 1e-7*flown*pull.norm()) << i;
    }
}


TEST(entrance, whatTheGasGivesAddsUp)
{
    const Law law = scene::stickyLaw();
    const double dt = 1e-5, delay = 4e-6;
    dem::System system(law.table(), {});
    system.keepGasExchange(true);
    system.add(sphere(law, 1, r, Vec3::Zero(), Vec3(2, 0, 0)));
    // so near that they are one island
    system.add(sphere(law, 2, r, Vec3(9e-6, 2.01e-6, 0)), delay);
    for (std::size_t i = 0; i < 2; ++i) system.setGasLoad(i, {1e-10, Vec3(0.5, 0.1, 0)});
    const double mass = system.particle(0).mass;
    const Vec3 before = mass*(system.particle(0).v + system.particle(1).v);
    EXPECT_EQ(system.advance(dt).islands, 1);
    const Vec3 after = mass*(system.particle(0).v + system.particle(1).v);
    const Vec3 given = system.gasExchange(0).impulse + system.gasExchange(1).impulse;
    EXPECT_LT((after - before - given).norm(), 1e-9*before.norm());
    for (std::size_t i = 0; i < 2; ++i)
    {
        const double z = 1e-10*(i ? dt - delay : dt)/mass;
        EXPECT_NEAR(system.gasExchange(i).memory, std::exp(-z), 1e-9);
        EXPECT_NEAR(system.gasExchange(i).response/(mass*(1 - std::exp(-z))), 1, 1e-6);
    }
}


TEST(entrance, wrongDelayIsRefused)
{
    const Law law;
    dem::System system(law.table(), {});
    for (const double wrong : {double(INFINITY), double(NAN)})
    {
        EXPECT_THROW(system.add(sphere(law, 1, r, Vec3::Zero()), wrong), dem::inputError);
    }
    system.add(sphere(law, 1, r, Vec3::Zero()), 1e-5);
    EXPECT_THROW(system.advance(1e-5), dem::inputError);
    system.advance(2e-5);
}
