// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shortest period of a contact, from which the contact step is made.
//
//     T = 2 pi min( (m/k_N)^(1/2), (m_T/k_T)^(1/2), (I/k_theta)^(1/2) )
//     k_N = 2 E a,   k_T = 8 G a,  m_T = (2/7) m,   k_theta = 4 F_C R (a/a0)^(3/2)
//     a^2 = a0^2 + R delta*,  delta*^(5/2) = delta^(5/2) + (15/16) m v^2/(E R^(1/2))
//
// delta* is the overlap that a Hertzian contact at overlap delta and approach speed v will
// reach. 2 E a is the Hertzian slope, above the JKR one (1.2 E a0 at A = 1), and the dashpots
// of the laws (below critical) lengthen the period; so T is a lower bound for one contact.
// The explicit scheme is stable for steps below T/pi; z contacts on one particle shorten
// that by about sqrt(z).
#pragma once

#include "materials/MaterialTable.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

//- Hertz peak overlap [m] at speed v: (15/16 m v^2/(E R^(1/2)))^(2/5)
inline double impactOverlap(double E, double R, double m, double v)
{
    return std::pow(15.0/16.0*m*v*v/(E*std::sqrt(R)), 0.4);
}

inline double contactPeriod
(
    const PairConstants& p,
    double R,
    double m,
    double a0,
    double overlap,
    double approachSpeed,
    bool sliding
)
{
    const double d = std::max(overlap, 0.0);
    const double v = std::max(approachSpeed, 0.0);
    const double deltaStar = std::pow
    (
        d*d*std::sqrt(d) + 15.0/16.0*m*v*v/(p.E*std::sqrt(R)), 0.4
    );
    // a floor for contacts that are neither adhesive nor in motion
    const double a =
        std::sqrt(std::max(a0*a0 + R*deltaStar, 1e-12*R*R));
    double square = m/(2*p.E*a);
    if (sliding) square = std::min(square, 2.0/7.0*m/(8*p.G*a));
    return 2*M_PI*std::sqrt(square);
}

//- 2 pi (I/k_theta)^(1/2) for the rolling mode; strength = 4 F_C [N], inertia 1/I the sum of
//  both particles' 1/I
inline double rollingPeriod(double strength, double R, double invInertia, double growth)
{
    return
        strength > 0
      ? 2*M_PI/std::sqrt(strength*R*growth*invInertia)
      : 1e300;
}

}
