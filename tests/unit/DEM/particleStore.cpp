// SPDX-License-Identifier: GPL-3.0-or-later
//
// The particles of a rank: indices, ids, rest and the packed state, without anything that moves.
#include "foundation/Fields.hpp"
#include "particles/errors.hpp"
#include "system/ParticleStore.hpp"

#include "clouds.hpp"

#include <limits>

using dem::ParticleStore;
using dem::Vec3;
using scene::sphere;

namespace
{

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

ParticleStore storeOf(int n)
{
    const scene::Law law;
    ParticleStore store;
    for (int k = 0; k < n; ++k) store.add(sphere(law, 10*k, 1e-6, Vec3(k, 0, 0)), 1e-9*k);
    return store;
}

dem::ContactRecord contact(std::int64_t idJ, int wall)
{
    dem::ContactRecord c{idJ, wall, {0, 0, -1}, {}};
    for (int h = 0; h < dem::maxHistory; ++h) c.history[h] = 0.5*h;
    return c;
}

std::string refusal(const std::function<void()>& what)
{
    try { what(); }
    catch (const dem::inputError& e) { return e.keyword + ": " + e.reason + "; " + e.allowed; }
    return "";
}

}


TEST(particleStore, removingKeepsOrderAndColumnsTogether)
{
    ParticleStore store = storeOf(6);
    for (std::size_t i = 0; i < 6; ++i)
    {
        store.gas[i].Sp = double(i);
        store.rest[i].quietTime = double(i);
        store.exchange[i].response = double(i);
        store.contacts[i].resize(i);
    }
    store.remove({1, 0, 0, 1});
    ASSERT_EQ(store.size(), 4u);
    const std::size_t left[] = {1, 2, 4, 5};
    for (std::size_t k = 0; k < 4; ++k)
    {
        const std::size_t i = left[k];
        EXPECT_EQ(store.particles[k].id, std::int64_t(10*i));
        EXPECT_EQ(store.indexOf.at(std::int64_t(10*i)), k);
        EXPECT_EQ(store.gas[k].Sp, double(i));
        EXPECT_EQ(store.rest[k].quietTime, double(i));
        EXPECT_EQ(store.exchange[k].response, double(i));
        EXPECT_EQ(store.reach[k], 1e-9*double(i));
        EXPECT_EQ(store.contacts[k].size(), i);
    }
    EXPECT_EQ(store.indexOf.size(), 4u);
    // an id that has gone is free again
    EXPECT_EQ(store.add(sphere(scene::Law(), 0, 1e-6, Vec3::Zero()), 0), 4u);
}


TEST(particleStore, refusesWhatMakesNoSenseAndStaysAsItWas)
{
    ParticleStore store = storeOf(2);
    const auto p = [](std::int64_t id, const Vec3& x, const Vec3& v)
    {
        return sphere(scene::Law(), id, 1e-6, x, v);
    };
    const Vec3 none = Vec3::Zero();
    EXPECT_THROW(store.add(p(10, none, none), 0), dem::inputError);
    EXPECT_THROW(store.add(p(-1, none, none), 0), dem::inputError);
    EXPECT_THROW(store.add(p(3, Vec3(notANumber, 0, 0), none), 0), dem::inputError);
    EXPECT_THROW(store.add(p(3, none, Vec3(0, infinite, 0)), 0), dem::inputError);
    EXPECT_THROW(store.checked(2), dem::inputError);
    EXPECT_EQ(store.size(), 2u);
    EXPECT_EQ(store.indexOf.size(), 2u);

    for (const double wrong : {notANumber, infinite})
    {
        const Vec3 bad(0, wrong, 0);
        EXPECT_THROW(store.setMotion(1, bad, none, none), dem::inputError);
        EXPECT_THROW(store.setMotion(1, none, bad, none), dem::inputError);
        EXPECT_THROW(store.setMotion(1, none, none, bad), dem::inputError);
    }
    EXPECT_EQ(store.particles[1].x, Vec3(1, 0, 0));
    EXPECT_EQ(store.rest[1].wakeForce, 0);
}


TEST(particleStore, whatRestsWakesByItsLoadAndByAHand)
{
    ParticleStore store = storeOf(1);
    EXPECT_TRUE(store.awake(0));
    store.rest[0].resting = true;
    store.rest[0].wakeForce = 1e-9;
    EXPECT_FALSE(store.awake(0));
    store.gas[0].Su = Vec3(0, 0, 0.99e-9);
    EXPECT_FALSE(store.awake(0));
    store.gas[0].Su = Vec3(0, 0, 1.01e-9);
    EXPECT_TRUE(store.awake(0));
    store.gas[0].Su = Vec3::Zero();
    store.rest[0].aggregate = 3;
    EXPECT_TRUE(store.flies(0));
    EXPECT_TRUE(store.awake(0));
    store.rest[0].aggregate = -1;
    EXPECT_FALSE(store.awake(0));
    store.setMotion(0, Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
    EXPECT_TRUE(store.awake(0));
}


TEST(particleStore, stateComesBackWithItsContacts)
{
    ParticleStore from = storeOf(1), to = storeOf(1);
    EXPECT_TRUE(from.packState(0).empty());
    from.rest[0] = {true, true, 1e-6, {1, 2, 3}, 4, 5, -1, 0, {6, 7, 8}};
    from.contacts[0] = {contact(20, -1), contact(-1, 1), contact(-1, 0)};
    const auto state = from.packState(0);
    EXPECT_TRUE(to.unpackState(0, state, {}, 2).empty());
    EXPECT_EQ(to.packState(0), state);
    EXPECT_EQ(to.contacts[0][1].wall, 1);
    EXPECT_EQ(to.rest[0].pullOff, 5);

    // patch 0 is gone, patch 1 is now 0
    EXPECT_EQ(to.unpackState(0, state, {-1, 0}, 1), std::vector<int>{0});
    ASSERT_EQ(to.contacts[0].size(), 2u);
    EXPECT_EQ(to.contacts[0][1].wall, 0);
    EXPECT_TRUE(to.awake(0));
}


TEST(particleStore, stateOfAnotherVersionOrLengthIsRefused)
{
    ParticleStore store = storeOf(1);
    store.rest[0].inContact = true;
    store.contacts[0] = {contact(-1, 0)};
    const auto state = store.packState(0);
    const auto unpacking = [&](const std::vector<double>& s)
    {
        return refusal([&] { store.unpackState(0, s, {}, 1); });
    };
    EXPECT_EQ(unpacking(state), "");
    EXPECT_EQ(state[0], 2);

    auto later = state;
    later[0] = 3;
    EXPECT_NE(unpacking(later).find("version 3"), std::string::npos) << unpacking(later);
    // as it was written before it had a version: begins with whether the particle touches
    const std::vector<double> first(state.begin() + 1, state.end());
    EXPECT_NE(unpacking(first).find("version 1"), std::string::npos) << unpacking(first);

    auto shorter = state;
    shorter.pop_back();
    EXPECT_NE(unpacking(shorter).find("per contact"), std::string::npos);
    EXPECT_NE(unpacking({2, 0, 0}).find("per contact"), std::string::npos);
    // a wall that is not there
    EXPECT_NE(refusal([&] { store.unpackState(0, state, {}, 0); }).find("wall patch 0"), std::string::npos);
}


TEST(particleStore, aHandMovesItInsideThePeriod)
{
    const scene::Law law;
    dem::System system(law.table(), {});
    dem::Periodic periodic;
    periodic.low = Vec3(-1, 0, 0);
    periodic.length = Vec3(4, 0, 0);
    system.setPeriodic(periodic);
    system.add(sphere(law, 1, 1e-6, Vec3::Zero()));
    system.setMotion(0, Vec3(9, 5, -7), Vec3(1, 2, 3), Vec3::Zero());
    EXPECT_EQ(system.particle(0).x, Vec3(1, 5, -7));
    EXPECT_EQ(system.particle(0).v, Vec3(1, 2, 3));
    EXPECT_THROW(system.setMotion(0, Vec3(infinite, 0, 0), Vec3::Zero(), Vec3::Zero()), dem::inputError);
    EXPECT_EQ(system.particle(0).x, Vec3(1, 5, -7));
}
