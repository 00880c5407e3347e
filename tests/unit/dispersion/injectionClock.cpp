// SPDX-License-Identifier: GPL-3.0-or-later
//
// When parcels are due: by their number alone.
#include "injectionClock.H"

#include <gtest/gtest.h>

#include <vector>

using Foam::injectionClock;

namespace
{

//- Numbers due in steps of dt up to the end, one after the other
std::vector<int64_t> taken(const injectionClock& clock, double dt, int steps)
{
    std::vector<int64_t> numbers;
    int64_t next = 0;
    for (int i = 1; i <= steps; ++i)
    {
        while (clock.dueBefore(next, clock.begin() + i*dt)) numbers.push_back(next++);
    }
    return numbers;
}

}

TEST(injectionClock, momentsFollowFromNumbers)
{
    const injectionClock clock(0.25, 8, 1e15, 1000);
    EXPECT_EQ(clock.due(0), 0.25);
    EXPECT_EQ(clock.due(4), 0.75);
    EXPECT_FALSE(clock.dueBefore(4, 0.75));
    EXPECT_TRUE(clock.dueBefore(4, 0.76));
    EXPECT_FALSE(clock.dueBefore(-1, 1));
}

TEST(injectionClock, nobodyTwiceNobodyMissedWhateverTheStep)
{
    const injectionClock clock(500, 1.6e5, 1e15, 600);
    const auto coarse = taken(clock, 4e-3, 1), fine = taken(clock, 1e-5, 400);
    EXPECT_EQ(coarse.size(), 600u);
    EXPECT_EQ(coarse, fine);
}

TEST(injectionClock, ends)
{
    // by number
    EXPECT_TRUE(injectionClock(0, 10, 1e15, 7).has(6));
    EXPECT_FALSE(injectionClock(0, 10, 1e15, 7).has(7));

    // by time: 0, 0.1, ... 0.6; the one at 0.7 would be the eighth
    EXPECT_TRUE(injectionClock(0, 10, 0.7, 100).has(6));
    EXPECT_FALSE(injectionClock(0, 10, 0.7, 100).has(7));
    EXPECT_FALSE(injectionClock(3, 10, 3.7, 100).has(7));
}

TEST(injectionClock, goesOnAtAnotherRate)
{
    const auto clock = injectionClock::from(30, 2.5, 100, 1e15, 100);
    EXPECT_NEAR(clock.due(30), 2.5, 1e-15);
    EXPECT_NEAR(clock.due(31), 2.51, 1e-15);
}
