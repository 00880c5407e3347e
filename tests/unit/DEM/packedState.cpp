// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a restart file can hold and a particle cannot.
#include "DEM.hpp"

#include "contacts/ContactRecord.hpp"
#include "foundation/Fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using dem::PackedState;

namespace
{

//- At rest on wall 1, in contact with particle 9
std::vector<double> sound()
{
    std::vector<double> s(PackedState::restNumbers + 2*PackedState::contactNumbers, 0.0);
    s[0] = PackedState::version;
    s[1] = s[2] = 1;
    s[PackedState::aggregate] = -1;
    double* c = s.data() + PackedState::restNumbers;
    c[PackedState::partner] = -1;
    c[PackedState::wall] = 1;
    c[2] = 0.6;
    c[4] = -0.8;
    c += PackedState::contactNumbers;
    c[PackedState::partner] = 9;
    c[PackedState::wall] = -1;
    return s;
}

std::string with(std::size_t i, double value)
{
    std::vector<double> s = sound();
    s.at(i) = value;
    return PackedState::fault(s, 5, 2);
}

constexpr std::size_t wallContact = PackedState::restNumbers;
constexpr std::size_t pairContact = PackedState::restNumbers + PackedState::contactNumbers;

}


TEST(packedState, what_a_run_writes_is_sound)
{
    EXPECT_STREQ(PackedState::fault({}, 5, 0), "");
    EXPECT_STREQ(PackedState::fault(sound(), 5, 2), "");
}


TEST(packedState, has_whole_contacts_only)
{
    std::vector<double> s = sound();
    s.pop_back();
    EXPECT_STRNE(PackedState::fault(s, 5, 2), "");
    EXPECT_STRNE(PackedState::fault({1, 2, 3}, 5, 2), "");
}


TEST(packedState, every_number_must_be_finite)
{
    for (std::size_t i = 0; i < sound().size(); ++i)
    {
        for (const double value : {double(NAN), double(INFINITY), -1e300})
        {
            EXPECT_NE(with(i, value), "") << "number " << i << " = " << value;
        }
    }
}


TEST(packedState, partners_exist_and_have_higher_ids)
{
    EXPECT_NE(with(wallContact + PackedState::wall, 2), "");        // there are two
    EXPECT_EQ(with(wallContact + PackedState::wall, 0), "");
    EXPECT_NE(with(wallContact + PackedState::partner, 9), "");     // with both
    EXPECT_NE(with(wallContact + PackedState::wall, 0.5), "");
    EXPECT_NE(with(wallContact + 2, 0.7), "");                      // normal of length 1.06
    EXPECT_NE(with(pairContact + PackedState::partner, 5), "");     // with itself
    EXPECT_NE(with(pairContact + PackedState::partner, -1), "");    // with nothing
    EXPECT_EQ(with(pairContact + PackedState::partner, 6), "");
}


TEST(packedState, flags_and_aggregates_are_as_they_can_be)
{
    EXPECT_NE(with(0, PackedState::version - 1), "");
    EXPECT_NE(with(1, 2), "");
    EXPECT_NE(with(2, -1), "");
    EXPECT_NE(with(3, -1e-9), "");
    EXPECT_NE(with(PackedState::aggregate, 5), "");     // of no members
    EXPECT_NE(with(PackedState::aggregate, -2), "");
    EXPECT_NE(with(10, -1), "");
}


TEST(packedState, the_numbers_are_where_the_fields_of_the_structs_put_them)
{
    dem::RestState rest;
    rest.resting = true;
    rest.quietTime = 0.25;
    rest.aggregate = 77;
    rest.members = 3;
    dem::ContactRecord contact{};
    contact.idJ = 12;
    contact.wall = 4;

    std::vector<double> s{PackedState::version};
    dem::pack(rest, s);
    ASSERT_EQ(s.size(), PackedState::restNumbers);
    EXPECT_EQ(s[1], 0);
    EXPECT_EQ(s[2], 1);
    EXPECT_EQ(s[3], 0.25);
    EXPECT_EQ(s[PackedState::aggregate], 77);
    EXPECT_EQ(s[PackedState::aggregate + 1], 3);

    dem::pack(contact, s);
    ASSERT_EQ(s.size(), PackedState::restNumbers + PackedState::contactNumbers);
    EXPECT_EQ(s[PackedState::restNumbers + PackedState::partner], 12);
    EXPECT_EQ(s[PackedState::restNumbers + PackedState::wall], 4);
}
