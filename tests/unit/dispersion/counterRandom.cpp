// SPDX-License-Identifier: GPL-3.0-or-later
//
// Philox-4x32-10 against the published vectors; neighbours are unrelated.
#include "counterRandom.H"

#include <gtest/gtest.h>

using Foam::counterRandom;

// Random123, file kat_vectors
TEST(counterRandom, publishedVectors)
{
    const counterRandom::counter zero{{0, 0, 0, 0}}, ones{{~0u, ~0u, ~0u, ~0u}};
    const counterRandom::counter pi{{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}};

    EXPECT_EQ(counterRandom::words(zero, {{0, 0}}),
        (counterRandom::counter{{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}}));
    EXPECT_EQ(counterRandom::words(ones, {{~0u, ~0u}}),
        (counterRandom::counter{{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}}));
    EXPECT_EQ(counterRandom::words(pi, {{0xa4093822, 0x299f31d0}}),
        (counterRandom::counter{{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}}));
}

// Mean, variance, kurtosis, and correlation with the neighbour in each word
TEST(counterRandom, normals)
{
    const int n = 400000;
    double sum = 0, sum2 = 0, sum4 = 0, product[5] = {};
    for (unsigned i = 0; i < n; ++i)
    {
        const double g = counterRandom::normals({{i, 1, 7, 0}}, {{2, 0}})[0];
        sum += g/n;
        sum2 += g*g/n;
        sum4 += g*g*g*g/n;
        const double near[] =
        {
            counterRandom::normals({{i + 1, 1, 7, 0}}, {{2, 0}})[0],
            counterRandom::normals({{i, 2, 7, 0}}, {{2, 0}})[0],
            counterRandom::normals({{i, 1, 8, 0}}, {{2, 0}})[0],
            counterRandom::normals({{i, 1, 7, 1}}, {{2, 0}})[0],
            counterRandom::normals({{i, 1, 7, 0}}, {{2, 1}})[0]
        };
        for (int k = 0; k < 5; ++k)
        {
            product[k] += g*near[k]/n;
        }
    }
    const double error = 1/std::sqrt(n);
    EXPECT_NEAR(sum, 0, 4*error);
    EXPECT_NEAR(sum2, 1, 4*std::sqrt(2)*error);
    EXPECT_NEAR(sum4, 3, 4*std::sqrt(96)*error);
    for (const double p : product)
    {
        EXPECT_NEAR(p, 0, 4*error);
    }
}
