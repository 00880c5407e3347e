// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contact step: from the shortest period of a contact for accuracy, and from the
// stability bound of the scheme.
//
//     T = 2 pi min( (m/k_N)^(1/2), (m_T/k_T)^(1/2), (1/(k_r c_I))^(1/2) )
//     k_N = 2 E a,   k_T = 8 G a,  m_T = (2/7) m,   k_r = 4 F_C (a/a0)^(3/2)
//     c_I = (r_i/I_i + r_j/I_j)/2: rolling is v_L = (r_i omega_i - r_j omega_j) x n/2 + ...
//     a^2 = a0^2 + R delta*,  delta*^(5/2) = delta^(5/2) + (15/16) m v^2/(E R^(1/2))
//
// delta* is the overlap that a Hertzian contact at overlap delta and approach speed v will
// reach. 2 E a is the Hertzian slope, above the JKR one (1.2 E a0 at A = 1); so T is a lower
// bound for one contact. A normal law of another kind gives its own k_N.
//
// The bound. A linear mode of frequency omega and decay c (x" = -omega^2 x - c x') goes through
// one step of the scheme (island/Propagator.hpp) with the factors lambda of
//     lambda^3 + (W + 3/2 K - 2) lambda^2 + (1 - 2 K) lambda + K/2 = 0,  W = (omega h)^2, K = c h
// all within the unit circle (Jury) if, and only if, W + 4 K < 4. The springs of sliding,
// rolling and twisting move with the predicted velocities and give
//     2 lambda (lambda - 1)^2 + ((1/2 + s) W lambda + (1/2 - s) W + K (lambda - 1)) (3 lambda - 1) = 0
// which for s = 0 grows by W^2/4 - 2 K a step (energy): undamped it is stable at no step.
// s >= W/4 - K/W is what it lacks; then it is stable for W/2 + K < 1. So with stiffness k and
// damping c of a contact, springs counted twice, the step is stable below
//     h_b = 2/(C + (W + C^2)^(1/2))
//     W = max (S_i/m_i + S_j/m_j) + max P_i r_i/I_i + max (Q_i/I_i + Q_j/I_j)
// over particles i and contacts ij (wall: i only), S_i the sum over all contacts of particle i
// of max(k_N, 7 k_T), P_i of 2 k_r, Q_i of 2 k_phi; C likewise from max(eta_N, (7/2) eta_T),
// eta_R and the twisting dashpot. For, if the mass of a particle is shared out to its contacts
// in proportion to their stiffness, no mode of the whole is faster than the fastest of a
// contact alone (Irons); rolling, which is not symmetric, by its row sums (Gershgorin). For
// the normal mode of one contact alone it is exact. Drag only damps, and moves in closed form.
//
// It is that of equal steps, and of contacts as they are: a step from the touch, at the share s
// of the bound at delta*, goes s (32/15)^(1/2) delta* deep, and leaves the contact at
// s^(5/4) (32/15)^(1/8) of the bound that it then has: beyond it from s = 0.927 on. Such a
// collision gains energy, each one anew.
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

//- What the contact step is made of, for one contact at its stiffest
struct ContactBound
{
    double period;              // shortest, T above [s]
    double radius;              // a [m]
    double stiffness;           // max(k_N, 7 k_T) [N/m]
    double damping;             // max(eta_N, (7/2) eta_T) [N s/m]
    double rolling = 0;             // 2 k_r [N]
    double rollingDamping = 0;      // eta_R [N s]
    double twisting = 0;            // 2 k_phi [N m]
    double twistingDamping = 0;     // [N m s]
    double slipTime = 1e30;         // eta_T/k_T [s]
    double turnTime = 1e30;         // the same of rolling and twisting [s]
};

//- h_b [s] of the largest sums W [1/s2] and C [1/s]
inline double stabilityBound(double W, double C)
{
    return 2/(C + std::sqrt(W + C*C));
}

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
