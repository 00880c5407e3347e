// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is it a number? Asked of the bits: where floating-point traps are on (as OpenFOAM sets
// them), comparing or subtracting what is not a number ends the program before the message.
#pragma once

#include "particles/vector.hpp"

#include <cstdint>
#include <cstring>

namespace dem
{

//- Neither NaN nor infinite (IEEE 754: not all of the eleven exponent bits are set)
inline bool isFinite(const double& x)
{
    static_assert(sizeof(double) == sizeof(std::uint64_t), "doubles of 64 bits");
    constexpr std::uint64_t exponent = std::uint64_t(0x7ff) << 52;
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    return (bits & exponent) != exponent;
}

inline bool isFinite(const Vec3& v)
{
    return isFinite(v.data()[0]) && isFinite(v.data()[1]) && isFinite(v.data()[2]);
}

}
