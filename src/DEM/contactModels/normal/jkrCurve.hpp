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

//- Energy over 4 F_C a0^2/R, zero at delta = 0: the integral of (s^6 - s^3) over s^4 - (2/3) s,
//  (2/5) s^10 - (2/3) s^7 + (1/6) s^4, less its value at s^3 = 2/3
inline double energy(double s)
{
    const double s3 = s*s*s;
    return s*s3*((0.4*s3 - 2.0/3.0)*s3 + 1.0/6.0) + 0.1*std::pow(2.0/3.0, 4.0/3.0);
}

//- s_c = 6^(-1/3)
inline constexpr double sC = 0.55032120814910444731;

//- delta_C R/a0^2 = 1/(2 6^(1/3)) = s_c/2
inline constexpr double neck = 0.5*sC;

//- s = (a/a0)^(1/2), the largest root, from q = (delta + delta_C) R/a0^2 >= 0.
//
//  With u = s - s_c the quartic is q = u^2 ((u + 2 s_c)^2 + 2 s_c^2): no double root is
//  left once the square is divided out, so full precision is kept up to the very end of the
//  neck. The start is a polynomial in w = q^(1/2) (error 2e-6 up to w = 3, i.e. 26 times the
//  equilibrium overlap); above, u (b + c u) = w, b = 6^(1/2) s_c, which has the right form in
//  both limits, times a fit of what it lacks (6e-6). One step of Halley's method, of third
//  order, then leaves round-off only.
template<class Real>
[[gnu::always_inline]] inline Real rootOf(const Real& qIn)
{
    const Real q = maximum(qIn, Real(1e-30));
    const Real w = squareRoot(q);
    const Real x = minimum(w, Real(3));
    const Real x2 = x*x;
    const Real x4 = x2*x2;
    const auto line = [&x](double a, double b) { return Real(a) + Real(b)*x; };
    const Real low =
        line(0.7418346868217973, -0.33318481538334316)
      + x2*line(0.25990372218808855, -0.2223548121819892);
    const Real middle =
        line(0.17618605733222503, -0.11445836428854247)
      + x2*line(0.05587780167782408, -0.019179163930019914);
    const Real high =
        line(0.004311250737535901, -0.0005658159729190609)
      + Real(3.2738544535252864e-05)*x2;
    Real u = x*(low + x4*(middle + x4*high));

    const auto large = w > Real(3);
    if (any(large))
    {
        constexpr double b = 2.449489742783178098*sC;
        constexpr double c = 0.93;
        const Real inverse =
            Real(1)/(Real(b) + squareRoot(Real(b*b) + Real(4*c)*w));
        const Real z = b*inverse;       // in (0, 1/2]
        const Real lacks =
            Real(0.964367848053) + z*(Real(0.204483702143) + z*(Real(-0.0554813068713)
          + z*(Real(-0.341532012632) + z*(Real(0.683256508106) + z*(Real(-2.45534270705)
          + z*Real(1.53425464037))))));
        u = select(large, Real(2)*w*inverse*lacks, u);
    }

    // f = u^2 B - q, f' = 2 u D, f'' = 2 (D + u (3 v + u)),  D = B + u v
    const Real v = u + Real(2*sC);
    const Real B = v*v + Real(2*sC*sC);
    const Real D = B + u*v;
    const Real f = u*u*B - q;
    const Real slope = Real(2)*u*D;
    const Real bend = Real(2)*(D + u*(Real(3)*v + u));
    u = u - Real(2)*f*slope/(Real(2)*slope*slope - f*bend);

    return u + Real(sC);
}

}
}
