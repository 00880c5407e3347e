// SPDX-License-Identifier: GPL-3.0-or-later
//
// When parcels are due: by their number, or by the mass of those before them, alone.
#include "injectionClock.H"

#include <gtest/gtest.h>

#include <vector>

using Foam::injectionClock;
using Foam::rateProfile;

namespace
{

injectionClock constant(double start, double rate, double end, int64_t total)
{
    return injectionClock(start, rate, rateProfile(), 1, 0, end, total);
}

injectionClock weighted(double rate, const rateProfile& profile)
{
    return injectionClock(0, rate, profile, 1, 0, 1e15, 1000000);
}

//- Numbers due in steps of dt up to the end, one after the other
std::vector<int64_t> taken(const injectionClock& clock, double dt, int steps)
{
    std::vector<int64_t> numbers;
    int64_t next = 0;
    for (int i = 1; i <= steps; ++i)
    {
        while (clock.dueBefore(next, double(next), clock.start() + i*dt)) numbers.push_back(next++);
    }
    return numbers;
}

}

TEST(injectionClock, momentsFollowFromNumbers)
{
    const injectionClock clock = constant(0.25, 8, 1e15, 1000);
    EXPECT_EQ(clock.due(0), 0.25);
    EXPECT_EQ(clock.due(4), 0.75);
    EXPECT_FALSE(clock.dueBefore(4, 4, 0.75));
    EXPECT_TRUE(clock.dueBefore(4, 4, 0.76));
    EXPECT_FALSE(clock.dueBefore(-1, -1, 1));
}

TEST(injectionClock, nobodyTwiceNobodyMissedWhateverTheStep)
{
    const injectionClock clock = constant(500, 1.6e5, 1e15, 600);
    const auto coarse = taken(clock, 4e-3, 1), fine = taken(clock, 1e-5, 400);
    EXPECT_EQ(coarse.size(), 600u);
    EXPECT_EQ(coarse, fine);
}

TEST(injectionClock, ends)
{
    // by number
    EXPECT_TRUE(constant(0, 10, 1e15, 7).has(6, 6));
    EXPECT_FALSE(constant(0, 10, 1e15, 7).has(7, 7));

    // by time: 0, 0.1, ... 0.6; the one at 0.7 would be the eighth
    EXPECT_TRUE(constant(0, 10, 0.7, 100).has(6, 6));
    EXPECT_FALSE(constant(0, 10, 0.7, 100).has(7, 7));
    EXPECT_FALSE(constant(3, 10, 3.7, 100).has(7, 7));
}

TEST(injectionClock, goesOnAtAnotherRate)
{
    injectionClock clock = constant(2, 100, 1e15, 100);
    clock.setDue(30, 2.5);
    EXPECT_NEAR(clock.due(30), 2.5, 1e-15);
    EXPECT_NEAR(clock.due(31), 2.51, 1e-15);

    // in the middle of a ramp the phase stays
    injectionClock ramp(0, 50, rateProfile({0, 10}, {0, 10}), 1, 0, 1e15, 1000);
    ramp.setDue(7, 2);
    EXPECT_NEAR(ramp.due(7), 2, 1e-14);
    EXPECT_NEAR(ramp.due(7 + 50*2.5), 3, 1e-14);
}

TEST(injectionClock, rampInClosedForm)
{
    // rate a t: t_n = sqrt(2 n/a), and constant from T on
    const double a = 1e7, T = 2e-3;
    const injectionClock clock = weighted(a*T, rateProfile({0, T}, {0, 1}));
    for (int n = 0; n <= 20; ++n) EXPECT_NEAR(clock.due(n), std::sqrt(2*n/a), 1e-17);
    EXPECT_NEAR(clock.due(30), T + 10/(a*T), 1e-17);

    // falling to nothing: the last one is never reached
    const injectionClock falls = weighted(a*T, rateProfile({0, T}, {1, 0}));
    for (int n = 0; n < 20; ++n) EXPECT_NEAR(falls.due(n), T*(1 - std::sqrt(1 - n/20.0)), 1e-16);
    EXPECT_TRUE(falls.has(19, 19));
    EXPECT_FALSE(falls.has(20, 20));
}

TEST(injectionClock, nothingWhileTheRateIsZero)
{
    // 0 until 1 s, 10/s for 1 s, 0 until 5 s, then 10/s again
    const rateProfile profile({0, 1, 1 + 1e-12, 2, 2 + 1e-12, 5, 5 + 1e-12}, {0, 0, 1, 1, 0, 0, 1});
    const injectionClock clock = weighted(10, profile);
    EXPECT_NEAR(clock.due(0), 1, 1e-11);
    EXPECT_NEAR(clock.due(9), 1.9, 1e-11);
    EXPECT_NEAR(clock.due(11), 5.1, 1e-11);
    EXPECT_FALSE(clock.dueBefore(0, 0, 0.99));
}

TEST(injectionClock, theInverseOfTheIntegral)
{
    const rateProfile profile({-1, 0.5, 0.75, 2}, {3, 0.1, 4, 0.5});
    double before = -1;
    for (double I = 0; I < 10; I += 0.01)
    {
        const double t = profile.inverse(I);
        EXPECT_NEAR(profile.integral(t), I, 1e-14*(1 + I));
        EXPECT_GT(t, before);
        before = t;
    }
}

TEST(injectionClock, byMassWithinOneParticle)
{
    // masses of 1 to 7 in turn, 100 per second that rise to 300
    const rateProfile profile({0, 1}, {1, 3});
    const injectionClock clock(0, 100, profile, 4, 0, 1e15, 1000000);
    double before = 0;
    for (int64_t k = 0; clock.dueBefore(k, before, 1.5); ++k)
    {
        const double mass = double(1 + k*5%7);
        const double due = 100*profile.integral(clock.due(before));
        EXPECT_NEAR(due, before, 1e-10);
        before += mass;
    }
    EXPECT_GE(before, 350 - 1e-4);
    EXPECT_LE(before, 350 + 7);
}
