// SPDX-License-Identifier: GPL-3.0-or-later
//
// The floating-point traps that OpenFOAM sets, as long as it lives: what computes with NaN
// before it is refused ends the test program by SIGFPE.
#pragma once

#include <cfenv>

struct FloatingTraps
{
    FloatingTraps() { feenableexcept(traps); }
    ~FloatingTraps()
    {
        std::feclearexcept(FE_ALL_EXCEPT);
        fedisableexcept(traps);
    }

    FloatingTraps(const FloatingTraps&) = delete;

    static constexpr int traps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
};
