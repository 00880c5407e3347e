// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who is found to meet whom within a particle step, and how components of several ranks are
// joined, without moving anything.
#include "system/IslandFinder.hpp"

#include "clouds.hpp"

#include <map>
#include <set>

using dem::Vec3;
using scene::sphere;

namespace
{

constexpr double r = 1e-6, dt = 1e-4;

//- A finder with all that it looks at
struct Scene
{
    scene::Law law;
    dem::ParticleStore store;
    dem::WallSearch walls{dem::Walls{}};
    dem::Periodic periodic;
    dem::Communicator communicator;
    std::unique_ptr<dem::IslandFinder> finder;

    std::size_t add(std::int64_t id, const Vec3& x, const Vec3& v = Vec3::Zero())
    {
        return store.add(sphere(law, id, r, x, v), 0);
    }

    void rest(std::size_t i)
    {
        store.rest[i].resting = store.rest[i].inContact = true;
        store.changed(i);
    }

    void find(bool islands = true)
    {
        finder = std::make_unique<dem::IslandFinder>(store, walls, periodic, communicator, islands);
        finder->begin(dt);
        while (!finder->settled(dt)) {}
    }

    //- Ids by component
    std::map<std::int64_t, std::set<std::int64_t>> islands() const
    {
        std::map<std::int64_t, std::set<std::int64_t>> result;
        for (std::size_t k = 0; k < finder->crowd().size(); ++k)
        {
            result[finder->labels()[k].component].insert
            (
                store.particles[finder->crowd()[k]].id
            );
        }
        return result;
    }
};

using Islands = std::map<std::int64_t, std::set<std::int64_t>>;

dem::Shown shown(std::int64_t id, double x, double speed)
{
    dem::Shown s;
    const double reach = r + speed*dt;
    s.id = id;
    s.box = {Vec3(x - reach, -reach, -reach), Vec3(x + reach, reach, reach)};
    s.path.x = Vec3(x, 0, 0);
    s.path.size = r;
    s.path.corridor = {Vec3::Zero(), speed*dt, 0, 0};
    s.component.id = id;
    s.component.mass = double(id);
    s.component.momentum = double(id)*Vec3(1, 0, 0);
    s.component.unit = id;
    return s;
}

}


TEST(islandFinder, thoseWhoMeetAndNobodyElse)
{
    Scene s;
    s.add(5, Vec3::Zero(), Vec3(1, 0, 0));
    s.add(3, Vec3(50*r, 0, 0));
    s.add(8, Vec3(0, 400*r, 0), Vec3(1, 0, 0));      // beside it, on a path of its own
    s.add(9, Vec3(-40*r, 0, 0), Vec3(-1, 0, 0));
    s.find();
    EXPECT_EQ(s.islands(), (Islands{{3, {3, 5}}}));
    EXPECT_EQ(s.finder->alone(), (std::vector<std::size_t>{2, 3}));
    for (const dem::Label& l : s.finder->labels())
    {
        EXPECT_TRUE(l.active);
        EXPECT_FALSE(l.alone);
        EXPECT_FALSE(l.shared);
        EXPECT_EQ(l.home, 0);
        // equal masses
        EXPECT_TRUE(scene::near(l.crowd.velocity, Vec3(0.5, 0, 0), 1e-15));
        EXPECT_TRUE(scene::close(l.crowd.speed, 0.5, 1e-9));
    }
}


TEST(islandFinder, whoIsHitMayHitOthers)
{
    // nobody's own path meets the third, but the second may be shot at it
    Scene s;
    s.add(0, Vec3::Zero(), Vec3(1, 0, 0));
    s.add(1, Vec3(20*r, 0, 0));
    s.add(2, Vec3(40*r, 3*r, 0));
    s.add(3, Vec3(1, 0, 0));
    s.find();
    EXPECT_EQ(s.islands(), (Islands{{0, {0, 1, 2}}}));
    const dem::Path& second = s.finder->path(1);
    EXPECT_TRUE(second.joint);
    EXPECT_LE(second.hit, 18*r);
    EXPECT_GT(second.hit, 0);
}


TEST(islandFinder, aTryThatWasTooNarrowFindsMore)
{
    Scene s;
    s.add(0, Vec3::Zero(), Vec3(1, 0, 0));
    s.add(1, Vec3(20*r, 0, 0));
    s.add(2, Vec3(0, 400*r, 0));
    s.find();
    EXPECT_EQ(s.islands(), (Islands{{0, {0, 1}}}));
    s.finder->widen(1, 6);      // it turns out to have been that fast
    while (!s.finder->settled(dt)) {}
    EXPECT_EQ(s.islands(), (Islands{{0, {0, 1, 2}}}));
}


TEST(islandFinder, whatRestsIsAWallUntilSomebodyComes)
{
    Scene s;
    const std::size_t resting = s.add(1, Vec3::Zero());
    s.rest(resting);
    s.add(2, Vec3(0, 0, 30*r));
    s.find();
    EXPECT_TRUE(s.islands().empty());
    s.store.particles[1].v = Vec3(0, 0, -1);
    s.find();
    EXPECT_EQ(s.islands(), (Islands{{1, {1, 2}}}));
    EXPECT_EQ(s.finder->labels()[0].crowd.velocity, Vec3(0, 0, 0));
}


TEST(islandFinder, ofACakeOnlyWhatIsHitAndWhatThatTouches)
{
    // a row at rest, hit at one end: the first may wake, the second is the rim, the third is
    // seen; the others are not looked at
    Scene s;
    const std::vector<std::int64_t> row{10, 11, 12, 13, 14};
    for (std::size_t k = 0; k < row.size(); ++k) s.rest(s.add(row[k], Vec3(0, 0, -2*r*double(k))));
    s.add(1, Vec3(0, 0, 3.99*r), Vec3(0, 0, -0.02));    // it touches at the end
    s.find();
    EXPECT_EQ(s.islands(), (Islands{{1, {1, 10, 11}}}));
    EXPECT_TRUE(s.finder->path(0).open);
    EXPECT_FALSE(s.finder->path(1).open);
    EXPECT_FALSE(s.finder->path(1).joint);
    const std::vector<dem::Seen> seen = s.finder->seen();
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen[0].particle, 2u);
    EXPECT_EQ(seen[0].component, 1);

    // the rim turns out to wake: what it can meet comes in
    s.finder->open(1);
    while (!s.finder->settled(dt)) {}
    EXPECT_EQ(s.islands().begin()->second.count(12), 1u);
    EXPECT_TRUE(s.finder->path(1).joint);
    EXPECT_FALSE(s.finder->path(2).open);
}


TEST(islandFinder, twoWhoHitFarApartAreTwoIslands)
{
    Scene s;
    for (int k = 0; k < 20; ++k) s.rest(s.add(100 + k, Vec3(2*r*k, 0, 0)));
    s.add(1, Vec3(0, 0, 3.99*r), Vec3(0, 0, -0.02));
    s.add(2, Vec3(38*r, 0, 3.99*r), Vec3(0, 0, -0.02));
    s.find();
    EXPECT_EQ(s.islands(), (Islands{{1, {1, 100, 101}}, {2, {2, 118, 119}}}));
}


TEST(islandFinder, anAggregateIsOneAndAlone)
{
    Scene s;
    for (int k = 0; k < 3; ++k)
    {
        s.add(4 + k, Vec3(2*r*k, 0, 0));
        s.store.rest[std::size_t(k)].aggregate = 4;
        s.store.rest[std::size_t(k)].members = 3;
        s.store.changed(std::size_t(k));
    }
    s.find();
    EXPECT_EQ(s.islands(), (Islands{{4, {4, 5, 6}}}));
    EXPECT_TRUE(s.finder->labels()[0].alone);
    s.add(9, Vec3(-30*r, 0, 0), Vec3(1, 0, 0));
    s.find();
    EXPECT_EQ(s.islands(), (Islands{{4, {4, 5, 6, 9}}}));
    EXPECT_FALSE(s.finder->labels()[0].alone);
}


TEST(islandFinder, throughThePeriod)
{
    Scene s;
    s.periodic.length = Vec3(60*r, 0, 0);
    s.add(0, Vec3(5*r, 0, 0), Vec3(-1, 0, 0));
    s.add(1, Vec3(50*r, 0, 0));
    s.find();
    EXPECT_EQ(s.islands(), (Islands{{0, {0, 1}}}));
}


TEST(islandFinder, withoutIslandsAllAreOne)
{
    Scene s;
    s.add(7, Vec3::Zero(), Vec3(1, 0, 0));
    s.add(2, Vec3(1, 0, 0));
    s.find(false);
    EXPECT_EQ(s.islands(), (Islands{{2, {2, 7}}}));
    EXPECT_TRUE(scene::close(s.finder->path(1).corridor.width(dt), 1e-3*r + 1.2*dt, 1e-9));
}


TEST(islandFinder, componentsOfSeveralRanksBecomeOne)
{
    // 4 | 2 | 9 in a row, of three ranks; 11 and 12 are far away
    const double speed = 0.1;
    std::vector<std::vector<dem::Shown>> byRank
    {
        {shown(4, 0, speed), shown(12, -30*r, speed)}, {shown(2, 15*r, speed)},
        {shown(9, 30*r, speed), shown(11, 1, speed)}
    };
    dem::Ties ties;
    const dem::JoinedComponents joined(byRank, ties, dt, {});
    for (const std::int64_t id : {4, 2, 9})
    {
        ASSERT_TRUE(joined.find(id)) << id;
        EXPECT_EQ(joined.find(id)->id, 2);
        EXPECT_EQ(joined.find(id)->home, 1);
        EXPECT_EQ(joined.find(id)->mass, 15);
        EXPECT_EQ(joined.find(id)->unit, -1);
        EXPECT_TRUE(joined.find(id)->shared);
    }
    EXPECT_FALSE(joined.find(11));
    EXPECT_FALSE(joined.find(12));
    EXPECT_FALSE(joined.find(77));
    EXPECT_LE(byRank[0][0].path.hitNext, dt);
    EXPECT_GT(byRank[2][1].path.hitNext, dt);
}


TEST(islandFinder, whoHasBeenTiedOverRanksStaysSo)
{
    // as within a rank, though their ways, when set anew, lead past each other
    dem::Ties ties;
    std::vector<std::vector<dem::Shown>> wide{{shown(4, 0, 0.1)}, {shown(2, 15*r, 0.1)}};
    const dem::JoinedComponents first(wide, ties, dt, {});
    ASSERT_EQ(ties.size(), 1u);
    std::vector<std::vector<dem::Shown>> narrow{{shown(4, 0, 0)}, {shown(2, 15*r, 0)}};
    dem::Ties none;
    EXPECT_FALSE(dem::JoinedComponents(narrow, none, dt, {}).find(4));
    // 4 has become a part of 1 on its own rank
    narrow[0][0].component.id = 1;
    const dem::JoinedComponents second(narrow, ties, dt, {});
    ASSERT_TRUE(second.find(2));
    EXPECT_EQ(second.find(2)->id, 1);
    EXPECT_TRUE(second.find(1)->shared);
    EXPECT_EQ(ties.size(), 1u);
}
