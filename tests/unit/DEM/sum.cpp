// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sum does not depend on the order of its parts.
#include "foundation/Fields.hpp"
#include "foundation/Sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

//- Of magnitudes that differ by 1e20, with their exact sum: each comes with its opposite but one
std::vector<double> parts(double last)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-10, 10);
    std::vector<double> all{last};
    for (int k = 0; k < 500; ++k)
    {
        const double x = std::pow(10, exponent(random));
        all.push_back(x);
        all.push_back(-x);
    }
    return all;
}

}


TEST(sum, whatRoundingTakesIsKept)
{
    dem::Sum sum;
    sum += 1e16;
    sum += 1;
    sum -= 1e16;
    EXPECT_EQ(double(sum), 1);

    sum = 3;
    EXPECT_EQ(double(sum), 3);
    sum += sum;
    EXPECT_EQ(double(sum), 6);
}


TEST(sum, theOrderDoesNotMatter)
{
    std::vector<double> all = parts(M_PI);
    std::mt19937 random(2);
    double spread = 0;
    for (int k = 0; k < 20; ++k)
    {
        std::shuffle(all.begin(), all.end(), random);
        dem::Sum sum;
        double plain = 0;
        for (const double x : all)
        {
            sum += x;
            plain += x;
        }
        EXPECT_EQ(double(sum), M_PI);
        spread = std::max(spread, std::fabs(plain - M_PI));
    }
    // doubles alone do not do
    EXPECT_GT(spread, 1e-8);
}


TEST(sum, sharesAddUpToTheWhole)
{
    std::vector<double> all = parts(M_E);
    for (const std::size_t ranks : {2u, 3u, 7u})
    {
        std::vector<dem::Sum> share(ranks);
        for (std::size_t k = 0; k < all.size(); ++k) share[k*k%ranks] += all[k];
        dem::Sum sum;
        for (const dem::Sum& s : share)
        {
            std::vector<double> numbers;
            dem::pack(s, numbers);
            EXPECT_EQ(numbers.size(), 2u);
            const double* from = numbers.data();
            sum += dem::unpack<dem::Sum>(from);
        }
        EXPECT_EQ(double(sum), M_E) << ranks;
    }
}
