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
// that by about sqrt(z). A normal law of another kind gives its own k_N.
#pragma once

#include "contactModels/contactModel/ContactScale.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

//- A contact at its stiffest
struct ElasticBound
{
    double radius;      // a [m]
    double stiffness;   // k_N [N/m]
    double buildUp = 0; // growth of the pull-off force by then [N]
};

//- A head-on impact without adhesion and damping
struct Impact
{
    double overlap;     // [m]
    double time;        // in contact [s]
};

//- Hertz peak overlap [m] at speed v: (15/16 m v^2/(E R^(1/2)))^(2/5)
inline double impactOverlap(double E, double R, double m, double v)
{
    return std::pow(15.0/16.0*m*v*v/(E*std::sqrt(R)), 0.4);
}

inline Impact hertzianImpact(double E, double R, double m, double v)
{
    const double overlap = impactOverlap(E, R, m, v);
    return {overlap, v > 0 ? 2.94327*overlap/v : 0};
}

inline ElasticBound hertzianBound
(
    const ContactScale& s, double a0, double overlap, double speed
)
{
    const double d = std::max(overlap, 0.0);
    const double deltaStar = std::pow
    (
        d*d*std::sqrt(d) + 15.0/16.0*s.m*speed*speed/(s.pair.E*std::sqrt(s.R)), 0.4
    );
    // a floor for contacts that are neither adhesive nor in motion
    const double a =
        std::sqrt(std::max(a0*a0 + s.R*deltaStar, 1e-12*s.R*s.R));
    return {a, 2*s.pair.E*a};
}

}
