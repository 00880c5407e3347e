// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where particles get to and when two can first meet, against closed forms.
#include "system/Reach.hpp"
#include "timeIntegration/freeFlight.hpp"

#include "clouds.hpp"

using dem::Corridor;
using dem::Path;
using dem::Vec3;
using scene::close;
using scene::near;

namespace
{

constexpr double r = 1e-6, dt = 1e-4;

Path flyer(const Vec3& x, const Vec3& v)
{
    Path p;
    p.x = x;
    p.size = r;
    p.own = v;
    p.corridor = {v, 0, 0, 0};
    return p;
}

double meeting(const Path& a, const Path& b, const dem::Periodic& periodic = {})
{
    return dem::meetingTime(a, b, dt, periodic);
}

}


TEST(reach, twoOnStraightPaths)
{
    const Path a = flyer(Vec3::Zero(), Vec3(1, 0, 0));
    const Path ahead = flyer(Vec3(20*r, 0, 0), Vec3(-1, 0, 0));
    EXPECT_TRUE(close(meeting(a, ahead), 18*r/2, 1e-12));
    EXPECT_TRUE(close(meeting(ahead, a), 18*r/2, 1e-12));
    // grazing: sqrt((2r)^2 - b^2) before the closest approach
    const Path aside = flyer(Vec3(20*r, 1.2*r, 0), Vec3::Zero());
    EXPECT_TRUE(close(meeting(a, aside), (20 - 1.6)*r, 1e-12));
    EXPECT_GT(meeting(a, flyer(Vec3(20*r, 2.001*r, 0), Vec3::Zero())), dt);
    // too far for this step, or flying away
    EXPECT_GT(meeting(a, flyer(Vec3(103*r, 0, 0), Vec3::Zero())), dt);
    EXPECT_LE(meeting(a, flyer(Vec3(101*r, 0, 0), Vec3::Zero())), dt);
    EXPECT_GT(meeting(a, flyer(Vec3(-3*r, 0, 0), Vec3::Zero())), dt);
    EXPECT_EQ(meeting(a, flyer(Vec3(1.9*r, 0, 0), Vec3::Zero())), 0);
}


TEST(reach, oneThatCanBePushedGetsAwayFromThenOn)
{
    const Path a = flyer(Vec3::Zero(), Vec3::Zero());
    Path b = flyer(Vec3(12*r, 0, 0), Vec3::Zero());
    EXPECT_GT(meeting(a, b), dt);
    b.corridor.from = 3e-5;
    b.corridor.away = 0.5;
    EXPECT_TRUE(close(meeting(a, b), 3e-5 + 10*r/0.5, 1e-12));
    Path c = a;
    c.corridor.near = 4*r;
    EXPECT_TRUE(close(meeting(c, b), 3e-5 + 6*r/0.5, 1e-12));
    c.corridor.near = 10.5*r;
    EXPECT_EQ(meeting(c, b), 0);
}


TEST(reach, thePartnerMayBeAnImage)
{
    dem::Periodic periodic;
    periodic.length = Vec3(30*r, 0, 0);
    const Path a = flyer(Vec3(2*r, 0, 0), Vec3(-1, 0, 0));
    const Path b = flyer(Vec3(27*r, 0, 0), Vec3::Zero());
    EXPECT_GT(meeting(a, b), dt);
    EXPECT_TRUE(close(meeting(a, b, periodic), 3*r, 1e-12));
}


TEST(reach, membersOfOneBodyBelongTogetherButDoNotPushEachOther)
{
    Path a = flyer(Vec3::Zero(), Vec3::Zero()), b = flyer(Vec3(1.99*r, 0, 0), Vec3::Zero());
    a.rigid = b.rigid = 7;
    EXPECT_TRUE(dem::meet(a, b, dt, {}));
    EXPECT_GT(a.hitNext, dt);
    // until one of them is hit
    a.hit = 2e-5;
    EXPECT_TRUE(dem::meet(a, b, dt, {}));
    EXPECT_EQ(b.hitNext, 2e-5);
    // two bodies do at once
    b.rigid = 8;
    EXPECT_TRUE(dem::meet(a, b, dt, {}));
    EXPECT_EQ(a.hitNext, 0);
}


TEST(reach, theBoxHoldsTheFlight)
{
    const scene::Law law;
    const dem::Periodic periodic;
    dem::WallSearch walls{scene::floor()};
    scene::Random random(4);
    for (int k = 0; k < 200; ++k)
    {
        dem::ParticleStore store;
        dem::Particle p = scene::sphere(law, k, r, random.inBox(1e-3), random.inBox(2));
        store.add(p, 1e-8);
        store.gas[0] = scene::breeze(p, 0);
        store.gas[0].Su = 1e-10*random.inBox(1);
        const dem::Reach reach(store, walls, periodic);
        const double step = random.logUniform(1e-8, 1e-3);
        const dem::Box box = reach.box(0, reach.own(0, step), step);
        for (int part = 0; part <= 20; ++part)
        {
            dem::Particle q = p;
            if (part) dem::fly(q, store.gas[0], step*part/20);
            EXPECT_TRUE((box.low.array() <= q.x.array() - r).all());
            EXPECT_TRUE((box.high.array() >= q.x.array() + r).all());
        }
    }
}


TEST(reach, pushedWithinTheNarrowerOfTwoCorridors)
{
    const scene::Law law;
    const dem::Periodic periodic;
    dem::WallSearch walls{dem::Walls{}};
    dem::ParticleStore store;
    store.add(scene::sphere(law, 1, r, Vec3::Zero(), Vec3(1, 0, 0)), 0);
    const dem::Reach reach(store, walls, periodic);
    Path p = reach.own(0, dt);
    // hit late: off its own path. hit at once, in a crowd that moves along: about the mean
    p.hit = 0.9*dt;
    EXPECT_EQ(reach.pushed(0, p, {Vec3(1, 0, 0), 1}, dt).from, 0.9*dt);
    p.hit = 0;
    const Corridor about = reach.pushed(0, p, {Vec3(0.5, 0, 0), 0.1}, dt);
    EXPECT_EQ(about.v, Vec3(0.5, 0, 0));
    EXPECT_TRUE(close(about.width(dt), 1e-3*r + 1.2*0.1*dt, 1e-12));
    // what rests stays
    store.rest[0].resting = true;
    const Path held = reach.own(0, dt);
    EXPECT_TRUE(held.held);
    EXPECT_EQ(held.corridor.width(dt), 0);
}
