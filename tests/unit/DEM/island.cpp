// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rooms of an island (src/DEM/island), each on its own.
#include "scene.hpp"

#include "island/Boundary.hpp"
#include "island/Island.hpp"
#include "island/eventTimes.hpp"
#include "island/shareOfGas.hpp"

using dem::Vec3;
using scene::close;
using scene::Law;
using scene::near;
using scene::sphere;

namespace
{

constexpr double r = 1e-6;

Law hertz()
{
    Law law;
    law.normal = "Hertz";
    law.gamma = 0;
    law.restitution = 1;
    return law;
}

//- A state and what the rooms share
struct Rooms
{
    Law law;
    dem::MaterialTable table;
    dem::WallSearch walls;
    dem::Periodic periodic;
    dem::Environment env;
    dem::Contacts contacts{env};
    dem::IslandState state;

    Rooms
    (
        const Law& l, const std::vector<dem::Particle>& particles,
        const dem::TimeSettings& time = {}, const dem::Walls& w = {}
    )
    :
        law(l), table(l.table()), walls(w), env{table, time, walls, periodic}
    {
        contacts.setUp(state.contacts);
        for (const dem::Particle& p : particles)
        {
            state.particles.push_back(p);
            state.gas.emplace_back();
            state.reach.push_back(table.reach(p.material, p.radius, w));
            state.rest.emplace_back();
            state.impulse.push_back(Vec3::Zero());
        }
        state.contacts.stored.resize(particles.size());
        dem::setBodies(state);
        contacts.resumeAll(state);
    }

    //- All in reach of all and of all surfaces, over dt
    void find(dem::Candidates& c, double dt = 1)
    {
        std::vector<int> surfaces;
        walls.query(Vec3::Constant(-1), Vec3::Constant(1), surfaces);
        c.clear();
        for (std::size_t i = 0; i < state.particles.size(); ++i)
        {
            c.addParticle({});
            c.addSurfaces(surfaces);
        }
        c.find(state, dt, {});
        c.refresh(state, {});
    }
};

//- Two along x with this gap of the surfaces, that approach each other at v
std::vector<dem::Particle> two(const Law& law, double gap, double v)
{
    return
    {
        sphere(law, 3, r, Vec3(0, 0, 0), Vec3(0.5*v, 0, 0)),
        sphere(law, 8, r, Vec3(2*r + gap, 0, 0), Vec3(-0.5*v, 0, 0))
    };
}

}


TEST(island, aCopyOfTheStateIsAPlaceToComeBackTo)
{
    const Law law;
    Rooms rooms(law, two(law, -1e-9, 0.1));
    rooms.contacts.begin(rooms.state, {{0, 1, -1, Vec3::Zero(), 0}});
    dem::Forces forces(rooms.env);
    dem::Propagator propagator;
    propagator.begin(rooms.state);
    dem::StepReport report;
    forces.evaluate(rooms.state, {}, report);
    const dem::IslandState before = rooms.state;
    const auto step = [&](double h)
    {
        propagator.drift(rooms.state, h, false);
        forces.evaluate(rooms.state, {h, h, 0}, report);
        rooms.state.phase.owed = h;
        propagator.complete(rooms.state);
        return dem::vec(rooms.state.bodies[0].v);
    };
    const Vec3 first = step(1e-9);
    rooms.state = before;
    EXPECT_NE(step(2e-9), first);
    rooms.state = before;
    EXPECT_EQ(step(1e-9), first);
    EXPECT_NE(first.x(), 0.05);
}


TEST(propagator, aConstantForceWithDragIsExact)
{
    const Law law;
    Rooms rooms(law, {sphere(law, 1, r, Vec3::Zero(), Vec3(0.3, 0, 0))});
    const double m = rooms.state.particles[0].mass, tau = 1e-6, h = 3e-6, F = 1e-9;
    rooms.state.gas[0].Sp = m/tau;
    rooms.state.gas[0].Uc = Vec3(1, 2, 0);
    dem::Propagator propagator;
    propagator.begin(rooms.state);
    rooms.state.loads[0].f[0] = F;
    propagator.drift(rooms.state, h, false);
    rooms.state.loads[0].f[0] = F;
    rooms.state.phase.owed = h;
    propagator.complete(rooms.state);
    const double e = std::exp(-h/tau), end = 1 + F*tau/m;
    const dem::Body& b = rooms.state.bodies[0];
    EXPECT_TRUE(close(b.v[0], end + (0.3 - end)*e, 1e-12));
    EXPECT_TRUE(close(b.v[1], 2*(1 - e), 1e-12));
    EXPECT_TRUE(close(b.x[0], end*h + (0.3 - end)*tau*(1 - e), 1e-12));
    // the gas gave what the contact force did not
    EXPECT_TRUE(close(rooms.state.impulse[0].x(), m*(b.v[0] - 0.3) - F*h, 1e-10));
}


TEST(propagator, velocitiesAreThoseOfTheStepsEndWhenComplete)
{
    const Law law;
    Rooms rooms(law, {sphere(law, 1, r, Vec3::Zero())});
    const double m = rooms.state.particles[0].mass, h = 1e-7, F = 1e-9;
    dem::Propagator propagator;
    propagator.begin(rooms.state);
    rooms.state.loads[0].f[1] = F;
    propagator.drift(rooms.state, h, false);
    EXPECT_EQ(rooms.state.loads[0].f[1], 0);
    rooms.state.loads[0].f[1] = 3*F;
    rooms.state.phase.owed = h;
    propagator.complete(rooms.state);
    EXPECT_TRUE(close(rooms.state.bodies[0].v[1], 2*F*h/m, 1e-14));
    propagator.complete(rooms.state);
    EXPECT_TRUE(close(rooms.state.bodies[0].v[1], 2*F*h/m, 1e-14));
}


TEST(contacts, whatIsPutToRestComesBackWithItsHistory)
{
    const Law law = []{ Law l; l.friction = 0.3; return l; }();
    Rooms rooms(law, two(law, -1e-9, 0));
    dem::IslandState& state = rooms.state;
    rooms.contacts.begin(state, {{0, 1, -1, Vec3::Zero(), 0}});
    dem::ContactList& list = state.contacts.lists[0].pairs;
    ASSERT_EQ(list.size(), 1u);
    for (std::size_t h = 0; h < list.history.size(); ++h) list.history[h][0] = 1 + double(h);
    state.rest[0].resting = true;
    rooms.contacts.putToRest(state);
    EXPECT_EQ(list.size(), 1u);     // one of them is awake
    state.rest[1].resting = true;
    const int version = state.contacts.version[1];
    rooms.contacts.putToRest(state);
    EXPECT_EQ(list.size(), 0u);
    ASSERT_EQ(state.contacts.stored[0].size(), 1u);
    EXPECT_EQ(state.contacts.stored[0][0].record.idJ, 8);
    EXPECT_GT(state.contacts.version[1], version);

    // the higher partner wakes: found by who holds it
    state.rest[1].resting = false;
    const auto resumed = rooms.contacts.resume(state, {1});
    ASSERT_EQ(resumed.size(), 1u);
    EXPECT_EQ(resumed[0].i, 0);
    EXPECT_EQ(resumed[0].j, 1);
    ASSERT_EQ(list.size(), 1u);
    EXPECT_TRUE(state.contacts.stored[0].empty());
    for (std::size_t h = 0; h < list.history.size(); ++h)
    {
        EXPECT_EQ(list.history[h][0], 1 + double(h));
    }
}


TEST(contacts, thoseMarkedEndAndAreNamed)
{
    const Law law;
    std::vector<dem::Particle> row;
    for (int k = 0; k < 4; ++k) row.push_back(sphere(law, k, r, Vec3(2*k*r, 0, 0)));
    Rooms rooms(law, row);
    dem::IslandState& state = rooms.state;
    std::vector<dem::Touch> touches;
    for (int k = 0; k < 3; ++k) touches.push_back({k, k + 1, -1, Vec3::Zero(), 0});
    rooms.contacts.begin(state, touches);
    dem::ContactList& list = state.contacts.lists[0].pairs;
    list.ended[0] = list.ended[2] = 1;
    const auto ended = rooms.contacts.end(state);
    ASSERT_EQ(ended.size(), 2u);
    EXPECT_EQ(ended[0].i, 2);
    EXPECT_EQ(ended[1].i, 0);
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list.i[0], 1);
}


TEST(candidates, aTouchIsReportedOnceAndAgainAfterTheParting)
{
    const Law law;
    Rooms rooms(law, two(law, 1e-9, 1));
    dem::Candidates candidates(rooms.env);
    rooms.find(candidates);
    EXPECT_TRUE(candidates.meet(rooms.state).empty());
    rooms.state.bodies[0].x[0] += 2e-9;
    rooms.state.phase.fastest = 1;
    candidates.follow(rooms.state, 2e-9, {});
    const auto touches = candidates.meet(rooms.state);
    ASSERT_EQ(touches.size(), 1u);
    EXPECT_EQ(touches[0].i, 0);
    EXPECT_EQ(touches[0].j, 1);
    EXPECT_TRUE(candidates.meet(rooms.state).empty());
    candidates.parted(rooms.state, {{0, 1}});
    EXPECT_EQ(candidates.meet(rooms.state).size(), 1u);
}


TEST(candidates, theWallWithTheNormalOfBeforeContinuesTheContact)
{
    const Law law;
    dem::Walls walls = scene::floor();
    walls.planes.push_back({Vec3::Zero(), Vec3::UnitX(), 0});
    Rooms rooms(law, {sphere(law, 1, r, Vec3(r, 0, 1.001*r))}, {}, walls);
    dem::Candidates candidates(rooms.env);
    rooms.find(candidates);
    std::vector<dem::WallHit> hits;
    const auto continues = [&](const Vec3& n)
    {
        return candidates.walls().continues(rooms.state, 0, 0, n.normalized(), hits);
    };
    const dem::WallHit* hit = continues(Vec3(-0.2, 0, -1));
    ASSERT_TRUE(hit);
    EXPECT_TRUE(near(hit->n, Vec3(0, 0, -1), 1e-12));
    hit = continues(Vec3(-1, 0, -0.2));
    ASSERT_TRUE(hit);
    EXPECT_TRUE(near(hit->n, Vec3(-1, 0, 0), 1e-12));
    EXPECT_FALSE(continues(Vec3(0, 1, 0)));
}


TEST(boundary, whatRestsGoesOnToLoad)
{
    // 0 rests on the floor, pressed in and held by nothing; 1, awake, touches it
    const Law law;
    const double overlap = 2e-9;
    Rooms rooms
    (
        law,
        {
            sphere(law, 1, r, Vec3(0, 0, r - overlap)), sphere(law, 2, r, Vec3(2*r, 0, r - overlap))
        },
        {}, scene::floor()
    );
    dem::IslandState& state = rooms.state;
    dem::Candidates candidates(rooms.env);
    rooms.find(candidates);
    rooms.contacts.begin(state, {{0, -1, 0, Vec3(0, 0, -1), overlap}});
    dem::Forces forces(rooms.env);
    dem::StepReport report;
    forces.evaluate(state, {}, report);
    const double load = state.loads[0].f[2];
    EXPECT_NE(load, 0);

    state.rest[0].resting = true;
    state.awake = {1};
    rooms.contacts.putToRest(state);
    rooms.contacts.begin(state, {{0, 1, -1, Vec3::Zero(), 0}});
    dem::Boundary boundary(rooms.env, rooms.contacts);
    boundary.begin(state);
    boundary.find(state, candidates.walls());
    ASSERT_EQ(boundary.list(), std::vector<int>{0});
    state.loads[0] = {};
    boundary.load(state);
    EXPECT_TRUE(close(state.loads[0].f[2], load, 1e-12));
}


TEST(stepControl, aFlightEndsAtTheTouch)
{
    const Law law = hertz();
    const double gap = 1e-7, v = 2;
    Rooms rooms(law, two(law, gap, v));
    dem::Candidates candidates(rooms.env);
    rooms.find(candidates);
    EXPECT_TRUE(close(dem::timeToTouchInFlight(rooms.env, rooms.state, candidates), gap/v, 1e-6));
    dem::StepControl control(rooms.env);
    dem::Propagator propagator;
    dem::StepReport report;
    propagator.begin(rooms.state);
    control.begin(rooms.state, candidates, {1});
    const dem::Step step = control.next(rooms.state, propagator, candidates, report);
    EXPECT_TRUE(step.flight);
    EXPECT_TRUE(close(step.h, gap/v, 1e-6));
    EXPECT_EQ(report.contactSteps, 0);
    control.took(rooms.state, step);
    EXPECT_TRUE(close(control.left(), 1 - gap/v, 1e-12));
}


TEST(stepControl, withAContactStepsAreEqualPartsOfThePeriod)
{
    const Law law;
    dem::TimeSettings time;
    time.stepsPerContact = 80;
    const formula::Contact c = law.contact(r, r);
    Rooms rooms(law, two(law, -c.delta0(), 0), time);
    rooms.contacts.begin(rooms.state, {{0, 1, -1, Vec3::Zero(), 0}});
    rooms.state.contacts.lists[0].pairs.overlap[0] = c.delta0();
    dem::Candidates candidates(rooms.env);
    rooms.find(candidates);
    dem::StepControl control(rooms.env);
    dem::Propagator propagator;
    dem::StepReport report;
    propagator.begin(rooms.state);
    const double m = rooms.state.particles[0].mass;
    const double period = rooms.table.figures(0, 0, r, r, m, m, 0).period, dt = 10.3*period;
    control.begin(rooms.state, candidates, {dt});
    const dem::Step step = control.next(rooms.state, propagator, candidates, report);
    EXPECT_FALSE(step.flight);
    EXPECT_EQ(report.contactSteps, 1);
    const double parts = dt/step.h;
    EXPECT_TRUE(near(parts, std::round(parts), 1e-6));
    // the stiffness grows with (a0^2 + R delta)^(1/2), and delta_0 = a0^2/(3 R)
    EXPECT_TRUE(close(step.h, period/80*std::pow(0.75, 0.25), 2e-3));
}


TEST(stabilitySums, oneContactIsStableBelowTwoOverItsFrequency)
{
    const Law law;
    Rooms rooms(law, two(law, -1e-9, 0));
    rooms.contacts.begin(rooms.state, {{0, 1, -1, Vec3::Zero(), 0}});
    dem::ContactBound b{};
    b.stiffness = 3;
    dem::StabilitySums sums;
    sums.reset(2);
    sums.add({0, 1}, b);
    const double omega = std::sqrt(3*2/law.mass(r));
    EXPECT_TRUE(close(sums.most(rooms.state).bound(), 2/omega, 1e-12));
    // a second one on the same particle counts for it
    sums.add({0, -1}, b);
    EXPECT_TRUE(close(sums.most(rooms.state).bound(), 2/(omega*std::sqrt(1.5)), 1e-12));
}


TEST(restCriteria, quietIsWhatMovesAndPullsLittle)
{
    dem::WeakestContact weakest;
    EXPECT_FALSE(dem::quietGain({0, 0, 0}, weakest, r, 1, 1));     // holds on to nothing
    weakest.any = true;
    weakest.pullOff = 1e-6;
    weakest.neck = 1e-9;
    weakest.yield = {0, 5e-15};
    const auto gain = [&](double energy, double force, double torque)
    {
        return dem::quietGain({energy, force, torque}, weakest, r, 1, 60).value_or(0);
    };
    EXPECT_EQ(gain(0.9e-16, 0.9e-7, 1.9e-14), 60);
    EXPECT_EQ(gain(4e-15, 0.9e-7, 1.9e-14), 2);     // rocks: 30 windows
    EXPECT_EQ(gain(6e-15, 0.9e-7, 1.9e-14), 0);
    EXPECT_EQ(gain(0.9e-16, 1.1e-7, 1.9e-14), 0);
    EXPECT_EQ(gain(0.9e-16, 0.9e-7, 2.1e-14), 0);
    EXPECT_FALSE(dem::overloads(Vec3(4.9e-7, 0, 0), Vec3(0, 4.9e-13, 0), 1e-6, r, 1));
    EXPECT_TRUE(dem::overloads(Vec3(5.1e-7, 0, 0), Vec3::Zero(), 1e-6, r, 1));
    EXPECT_TRUE(dem::overloads(Vec3::Zero(), Vec3(0, 5.1e-13, 0), 1e-6, r, 1));
    EXPECT_TRUE(close(weakest.wakeForce(1, r), 1e-9, 1e-12));      // no rolling spring
    weakest.yield.moment = 1e-13;
    EXPECT_TRUE(close(weakest.wakeForce(2, r), 2e-8, 1e-12));
}


TEST(restCriteria, whatItsHoldsCannotBearRollsOff)
{
    const dem::Vec3 down(0, 0, -1), x(1, 0, 0), none = dem::Vec3::Zero();
    // a sphere of radius 2 on the ground: F r + T against the strength, a tenth of grace
    const dem::Hold ground{2*down, down, 10};
    EXPECT_FALSE(dem::rollsOff({}, 100*x, none));
    EXPECT_FALSE(dem::rollsOff({ground}, 5.4*x, none));
    EXPECT_TRUE(dem::rollsOff({ground}, 5.6*x, none));
    EXPECT_TRUE(dem::rollsOff({ground}, 3*x, Vec3(0, 5.2, 0)));
    EXPECT_FALSE(dem::rollsOff({ground}, 3*x, Vec3(0, -5.2, 0)));
    EXPECT_FALSE(dem::rollsOff({ground}, 100*down, Vec3(0, 0, 100)));   // presses, twists
    // the second contact is beside or behind the first: it rolls over the line through both
    const dem::Hold beside{Vec3(0, 1, -2), down, 10}, behind{Vec3(-1, 0, -2), down, 10};
    EXPECT_FALSE(dem::rollsOff({ground, beside}, 10.9*x, none));
    EXPECT_TRUE(dem::rollsOff({ground, beside}, 11.1*x, none));
    EXPECT_FALSE(dem::rollsOff({ground, behind}, 1000*x, none));
    EXPECT_FALSE(dem::rollsOff({ground, beside, behind}, 1000*x, none));
}


TEST(flyingClusters, theyHoldOnToNothing)
{
    const Law law;
    std::vector<dem::Particle> row;
    for (int k = 0; k < 4; ++k) row.push_back(sphere(law, k, r, Vec3(2*k*r, 0, r)));
    Rooms rooms(law, row, {}, scene::floor());
    const Vec3 none = Vec3::Zero();
    rooms.contacts.begin
    (
        rooms.state, {{0, 1, -1, none, 0}, {2, 3, -1, none, 0}, {3, -1, 0, Vec3(0, 0, -1), 0}}
    );
    dem::FlyingClusters flying;
    flying.begin(rooms.state);
    flying.find(rooms.state);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(flying.flies(k), k < 2) << k;
    int clusters = 0;
    flying.each
    (
        rooms.state, rooms.periodic,
        [&](const std::vector<int>& members, const dem::RigidAggregate&)
        {
            ++clusters;
            EXPECT_EQ(members, (std::vector<int>{0, 1}));
        }
    );
    EXPECT_EQ(clusters, 1);
}


TEST(energyAccount, theWorkOfTheGasIsWhatAFlightGains)
{
    const Law law;
    dem::TimeSettings time;
    time.energyLedger = true;
    Rooms rooms(law, {sphere(law, 1, r, Vec3::Zero(), Vec3(0.1, 0, 0))}, time);
    dem::GasLoad& gas = rooms.state.gas[0];
    gas.Sp = rooms.state.particles[0].mass/1e-6;
    gas.Uc = Vec3(0, 1, 0);
    dem::EnergyAccount account(rooms.env);
    dem::EnergyLedger ledger;
    dem::Propagator propagator;
    propagator.begin(rooms.state);
    account.open(rooms.state, 1e-6, ledger);
    propagator.drift(rooms.state, 1e-6, false);
    account.drifted(rooms.state, ledger);
    rooms.state.phase.owed = 1e-6;
    propagator.complete(rooms.state);
    account.close(rooms.state, 1e-6, ledger);
    const double m = rooms.state.particles[0].mass, e = std::exp(-1.0);
    const double change = 0.5*m*((1 - e)*(1 - e) + 0.01*(e*e - 1));
    EXPECT_TRUE(close(ledger.kinetic, change, 1e-12));
    EXPECT_TRUE(close(ledger.gas, change, 1e-12));
    account.rested(2*change, ledger);
    EXPECT_TRUE(near(ledger.residual(), 0, 1e-12*change));
    EXPECT_TRUE(close(ledger.rest, 2*change, 1e-15));
}


TEST(shareOfGas, aFollowerWouldStopWithinItsRadius)
{
    const Law law;
    Rooms rooms(law, {sphere(law, 1, r, Vec3::Zero(), Vec3(0, 0, -1))});
    dem::GasLoad& gas = rooms.state.gas[0];
    const Vec3 n(0, 0, -1);
    const double m = rooms.state.particles[0].mass;
    gas.Sp = m/(0.9*r);
    EXPECT_TRUE(dem::follows(rooms.state, 0, n));
    gas.Su = Vec3(0, 0, -0.6*gas.Sp);       // driven by a force
    EXPECT_FALSE(dem::follows(rooms.state, 0, n));
    gas.Su = Vec3::Zero();
    gas.Sp = m/(1.1*r);
    EXPECT_FALSE(dem::follows(rooms.state, 0, n));
}
