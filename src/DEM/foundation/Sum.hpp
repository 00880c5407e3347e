// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sum that remembers what rounding takes from it,
//
//     s' = fl(s + x),   r' = r + (s + x - s'),   value = s + r,
//
// the second in parentheses exact (TwoSum: D. E. Knuth, The Art of Computer Programming 2,
// 3rd ed., 4.2.2, theorem B; summed up so: T. Ogita, S. M. Rump, S. Oishi, SIAM J. Sci.
// Comput. 26 (2005) 1955, algorithm 4.4). Its error is that of a number twice as long, so that
// the value is the same in whatever order, and on however many ranks, its parts are added.
// Proof: tests/unit/DEM/sum.cpp
#pragma once

namespace dem
{

class Sum
{
public:

    Sum() = default;
    Sum(double value) : sum_(value) {}

    operator double() const { return sum_ + rest_; }

    Sum& operator+=(double x)
    {
        const double sum = sum_ + x;
        const double added = sum - sum_;
        rest_ += (sum_ - (sum - added)) + (x - added);
        sum_ = sum;
        return *this;
    }

    Sum& operator-=(double x) { return *this += -x; }

    Sum& operator+=(const Sum& other)
    {
        const double rest = other.rest_;    // other may be this one
        *this += other.sum_;
        rest_ += rest;
        return *this;
    }

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.sum_);
        f(s.rest_);
    }

private:

    double sum_ = 0;
    double rest_ = 0;
};

}
