// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is packed comes back, member by member, and nothing else is touched.
#include "foundation/Fields.hpp"
#include "system/IslandExchange.hpp"

#include <gtest/gtest.h>

#include <cmath>

using dem::Vec3;

namespace
{

//- Every number of it different and none the default
template<class T>
T numbered(double first)
{
    std::vector<double> numbers(dem::fieldCount<T>());
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = first + double(k);
    const double* from = numbers.data();
    return dem::unpack<T>(from);
}

template<class T>
std::vector<double> packed(const T& value)
{
    std::vector<double> numbers;
    dem::pack(value, numbers);
    return numbers;
}

}


TEST(fields, numbersComeBackInTheirOrder)
{
    const dem::Particle p = numbered<dem::Particle>(2);
    EXPECT_EQ(dem::fieldCount<dem::Particle>(), 13u);
    EXPECT_EQ(p.id, 2);
    EXPECT_EQ(p.material, 3);
    EXPECT_EQ(p.radius, 4);
    EXPECT_EQ(p.mass, 5);
    EXPECT_EQ(p.x, Vec3(6, 7, 8));
    EXPECT_EQ(p.v, Vec3(9, 10, 11));
    EXPECT_EQ(p.omega, Vec3(12, 13, 14));
    EXPECT_EQ(packed(p).front(), 2);
    EXPECT_EQ(packed(p).back(), 14);
}


TEST(fields, everyMemberIsListed)
{
    // a member that is left out of the list makes the struct larger than its numbers
    const std::size_t number = sizeof(double);
    EXPECT_EQ(sizeof(dem::GasLoad), dem::fieldCount<dem::GasLoad>()*number);
    EXPECT_EQ(sizeof(dem::ContactRecord), (dem::fieldCount<dem::ContactRecord>())*number);
    EXPECT_EQ(sizeof(dem::Particle), dem::fieldCount<dem::Particle>()*number);
    EXPECT_EQ(sizeof(dem::GasExchange), dem::fieldCount<dem::GasExchange>()*number);
    // two flags share the room of a number
    EXPECT_EQ(sizeof(dem::RestState), (dem::fieldCount<dem::RestState>() - 1)*number);
}


TEST(fields, aMemberWithContactsIsTheSameAfterTheJourney)
{
    dem::Member m;
    m.p = numbered<dem::Particle>(1);
    m.gas = numbered<dem::GasLoad>(100);
    m.rest = numbered<dem::RestState>(200);
    m.exchange = numbered<dem::GasExchange>(300);
    m.contacts = {numbered<dem::ContactRecord>(400), numbered<dem::ContactRecord>(500)};
    m.contacts[1].history[3] = -0.0;
    m.contacts[1].history[4] = 5e-324;
    m.corridor = {Vec3(1, 2, 3), 4, 5, 6};
    m.pushed = true;
    m.outran = 7;
    m.component = (std::int64_t(1) << 52) + 1;
    m.owner = 3;
    m.index = 12;

    std::vector<double> numbers = packed(m);
    dem::pack(dem::Member(), numbers);
    const std::vector<dem::Member> back = dem::unpackAll<dem::Member>(numbers);
    ASSERT_EQ(back.size(), 2u);
    EXPECT_EQ(packed(back[0]), packed(m));
    EXPECT_EQ(back[0].component, m.component);
    EXPECT_EQ(back[0].index, 12u);
    EXPECT_TRUE(back[0].pushed);
    ASSERT_EQ(back[0].contacts.size(), 2u);
    EXPECT_TRUE(std::signbit(back[0].contacts[1].history[3]));
    EXPECT_EQ(back[0].contacts[1].history[4], 5e-324);
    EXPECT_EQ(back[0].corridor.away, 6);
    EXPECT_TRUE(back[1].contacts.empty());
    EXPECT_FALSE(back[1].pushed);
}
