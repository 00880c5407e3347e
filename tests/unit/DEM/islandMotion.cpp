// SPDX-License-Identifier: GPL-3.0-or-later
//
// One island moved alone: as a rigid body where it is one, else by its contacts.
#include "system/IslandMotion.hpp"

#include "clouds.hpp"

using dem::Vec3;
using scene::sphere;

namespace
{

constexpr double r = 1e-6;

struct Scene
{
    scene::Law law = scene::stickyLaw();
    dem::MaterialTable materials = law.table();
    dem::TimeSettings time;
    dem::WallSearch walls{dem::Walls{}};
    dem::Periodic periodic;
    dem::IslandMotion motion{materials, time, walls, periodic};

    dem::Member member(std::int64_t id, const Vec3& x, const Vec3& v = Vec3::Zero()) const
    {
        dem::Member m;
        m.p = sphere(law, id, r, x, v);
        m.corridor = {Vec3::Zero(), 1, 0, 0};
        return m;
    }

    //- A pair at rest inside, that flies at v
    dem::IslandMembers pair(const Vec3& v) const
    {
        dem::IslandMembers island;
        for (int k = 0; k < 2; ++k)
        {
            dem::Member m = member(k, Vec3(1.9*r*k, 0, 0), v);
            m.rest.inContact = m.rest.resting = true;
            m.rest.aggregate = 0;
            m.rest.members = 2;
            m.rest.wakeForce = 1e-10;
            m.rest.pullOff = 1e-8;
            m.rest.arm[0] = (k - 0.5)*1.9*r;
            island.members.push_back(m);
        }
        island.members[0].contacts.push_back({1, -1, {}, {}});
        return island;
    }
};

Vec3 momentum(const dem::IslandMembers& island)
{
    Vec3 sum = Vec3::Zero();
    for (const dem::Member& m : island.members) sum += m.p.mass*m.p.v;
    return sum;
}

}


TEST(islandMotion, anUndisturbedPairFliesAsOne)
{
    Scene s;
    dem::IslandMembers island = s.pair(Vec3(1, 2, 0));
    s.motion.move(island, {1e-5}, true);
    EXPECT_EQ(island.report.aggregateFlights, 1);
    EXPECT_EQ(island.report.contactSteps, 0);
    EXPECT_FALSE(island.outran);
    EXPECT_TRUE(scene::near(island.members[0].p.x, 1e-5*Vec3(1, 2, 0), 1e-18));
    const Vec3 apart = island.members[1].p.x - island.members[0].p.x;
    EXPECT_TRUE(scene::near(apart, Vec3(1.9*r, 0, 0), 1e-18));
}


TEST(islandMotion, whoeverIsDisturbedMovesByItsContacts)
{
    const auto contactSteps = [](const std::function<void(dem::IslandMembers&)>& disturb)
    {
        Scene s;
        dem::IslandMembers island = s.pair(Vec3(1, 0, 0));
        disturb(island);
        s.motion.move(island, {1e-7}, true);
        EXPECT_EQ(island.report.aggregateFlights, 0);
        EXPECT_EQ(island.report.wakes, 2);
        return island.report.contactSteps;
    };
    // others may meet it; moved by a hand; the gas pulls it apart by more than it may
    EXPECT_GT(contactSteps([](dem::IslandMembers& i) { i.members[1].pushed = true; }), 0);
    EXPECT_GT(contactSteps([](dem::IslandMembers& i) { i.members[0].rest.wakeForce = -1; }), 0);
    EXPECT_GT(contactSteps([](dem::IslandMembers& i) { i.members[1].gas.Su = Vec3(3e-9, 0, 0); }), 0);
}


TEST(islandMotion, aCollisionKeepsMomentumAndTellsWhoLeftItsCorridor)
{
    Scene s;
    dem::IslandMembers island;
    island.members = {s.member(1, Vec3::Zero(), Vec3(8, 0, 0)), s.member(2, Vec3(2.5*r, r, 0))};
    dem::IslandMembers narrow = island;
    for (dem::Member& m : narrow.members) m.corridor = {m.p.v, 1e-3*r, 0, 0};
    const Vec3 before = momentum(island);
    s.motion.move(island, {1e-5}, true);
    EXPECT_EQ(island.report.touches, 1);
    EXPECT_EQ(island.report.islands, 1);
    EXPECT_FALSE(island.outran);
    EXPECT_TRUE(scene::near(momentum(island), before, 1e-10*before.norm()));

    s.motion.move(narrow, {1e-5}, true);
    EXPECT_TRUE(narrow.outran);
    EXPECT_FALSE(narrow.holdsFor(narrow.members));
    EXPECT_TRUE(island.holdsFor(narrow.members));
    EXPECT_FALSE(island.holdsFor({narrow.members[0]}));
}


TEST(islandMotion, whatWouldWakeTheRimEndsTheRun)
{
    // a row of three: one flies at the second; the third holds that, and is the rim
    const auto shoot = [](double speed, bool rim)
    {
        Scene s;
        dem::IslandMembers island;
        island.members =
        {
            s.member(1, Vec3::Zero(), Vec3(speed, 0, 0)), s.member(2, Vec3(2.1*r, 0, 0)),
            s.member(3, Vec3(4.0995*r, 0, 0)), s.member(4, Vec3(6.099*r, 0, 0))
        };
        for (std::size_t k = 1; k < 4; ++k)
        {
            dem::RestState& rest = island.members[k].rest;
            rest.inContact = rest.resting = true;
            rest.wakeForce = 1e-10;
            rest.pullOff = 1e-8;
        }
        island.members[1].contacts.push_back({3, -1, {}, {}});
        island.members[2].contacts.push_back({4, -1, {}, {}});
        island.members[2].contacts.push_back({77, -1, {}, {}});     // that is gone
        island.members[2].rim = rim;
        island.members[3].rim = island.members[3].seen = true;
        s.motion.move(island, {1e-6}, true);
        return island;
    };
    const dem::IslandMembers hit = shoot(2, true);
    EXPECT_TRUE(hit.outran);
    EXPECT_FALSE(hit.members[1].woke);
    EXPECT_TRUE(hit.members[2].woke);
    EXPECT_EQ(hit.members[2].p.x.x(), 4.0995*r);

    // what is no more is dropped; who is only looked at stays as it was
    for (const bool rim : {true, false})
    {
        const dem::IslandMembers missed = shoot(-2, rim);
        EXPECT_FALSE(missed.outran);
        ASSERT_EQ(missed.members[2].contacts.size(), 1u);
        EXPECT_EQ(missed.members[2].contacts[0].idJ, 4);
        EXPECT_TRUE(missed.members[2].rest.inContact);
        EXPECT_TRUE(missed.members[2].rest.resting);
        EXPECT_EQ(missed.members[2].p.x.x(), 4.0995*r);
    }
}
