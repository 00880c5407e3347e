// SPDX-License-Identifier: GPL-3.0-or-later
//
// The universal JKR curve in scaled units: with A = a/a0 and s = A^(1/2),
//
//     delta R/a0^2 = A^2 - (2/3) A^(1/2) = s^4 - (2/3) s
//     F_N/(4 F_C)  = A^3 - A^(3/2)       = s^6 - s^3            (compressive positive)
//
// a0 = (9 pi gamma R^2/E)^(1/3), F_C = 3 pi R gamma. The curve ends, under displacement
// control, where its slope vanishes: s_c^3 = 1/6, delta_C = a0^2/(2 6^(1/3) R).
// Source: Chen, Liu & Li 2019, eq. 1a; Johnson, Kendall & Roberts 1971.
#pragma once

#include "contactModels/contactModel/Real.hpp"

namespace dem
{
namespace jkrCurve
{

//- s_c = 6^(-1/3)
inline constexpr double sC = 0.55032120814910444731;

//- delta_C R/a0^2 = 1/(2 6^(1/3)) = s_c/2
inline constexpr double neck = 0.5*sC;

//- s = (a/a0)^(1/2), the largest root, from q = (delta + delta_C) R/a0^2 >= 0.
//
//  With u = s - s_c the quartic is q = u^2 ((u + 2 s_c)^2 + 2 s_c^2): no double root is
//  left once the square is divided out, so Newton steps on it keep full precision up to
//  the very end of the neck. The start is exact in both limits and 4 % off between.
template<class Real>
[[gnu::always_inline]] inline Real rootOf(const Real& qIn)
{
    const Real q = maximum(qIn, Real(1e-30));
    const Real w = squareRoot(q);

    // u (b + c u) = w, b = sqrt(6) s_c
    constexpr double b = 2.449489742783178098*sC;
    constexpr double c = 0.93;
    Real u = (2*w)/(Real(b) + squareRoot(Real(b*b) + Real(4*c)*w));

    for (int k = 0; k < 3; ++k)
    {
        const Real v = u + Real(2*sC);
        const Real B = v*v + Real(2*sC*sC);
        // Newton on f(u) = u^2 B - q, f' = 2 u (B + u v)
        u = u - (u*u*B - q)/(2*u*(B + u*v));
    }

    return u + Real(sC);
}

}
}
