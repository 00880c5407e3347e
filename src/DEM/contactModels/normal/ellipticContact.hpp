// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sphere on a curved wall touches it in an ellipse. It is computed as a sphere on a plane
// whose radius R is chosen so that what matters most of each law is kept.
//
//     1/R_1 = 1/r + k_1, 1/R_2 = 1/r + k_2     k [1/m] principal curvatures of the wall; on a
//                                              wire of radius R_w: 1/R_w and 0
//     R_e = (R_1 R_2)^(1/2),   lambda = R_2/R_1,   y = ln^2 lambda
//
//     JKR, simplifiedJKR     R = R_e g(y)    pull-off force 3 pi R gamma of the ellipse
//     DMT, vanDerWaals       R = R_e         pull-off force 4 pi R_e gamma, exact (Derjaguin)
//     Hertz                  R = R_e h(y)    force (4/3) E R^(1/2) delta^(3/2), exact
//     cohesivePlastic        R = R_e         area 2 pi R_e delta of the flattened spot, exact
//
// g: contact in an ellipse of axes a, b, under the pressure (A + B x^2/a^2 + C y^2/b^2)
// /(1 - x^2/a^2 - y^2/b^2)^(1/2), which makes the surfaces fit (Johnson & Greenwood 2005); a and b
// where elastic plus surface energy is least (Giudici, Vella & Griffiths 2024): the energy release
// rate G along the edge (a cos t, b sin t) meets  int G cos^2(t) dt = int G sin^2(t) dt = pi W.
// J & G have G = W at the ends of the axes only. An edge free to take any shape (G = W all along
// it, tests/tools/DEM/freeEdge.hpp) holds 1e-4 more than the ellipse at R_w = r/2, 4e-4 at r/4.
// g and h are fitted for lambda from 7.5e-4 to 1: g to 5e-6, h to 2e-5 of itself.
//
//     wire R_w/r                          20      5       1       0.5     0.25    0.11
//     pull-off force over a flat wall's   0.9759  0.9126  0.7045  0.5721  0.4389  0.3050
//       by J & G's criterion              0.9758  0.9119  0.6967  0.5565  0.4142  0.2722
//     JKR with this R, of the ellipse's (else exact):
//       stiffness, high loads             -0.01 % -0.1 %  -1.2 %  -2.9 %  -6.0 %  -11 %
//       delta_0                           +0.01 % +0.1 %  +0.9 %  +2.2 %  +4.7 %  +9.4 %
//       delta_C                            0.00 % +0.03 % +0.4 %  +1.1 %  +2.4 %  +5.2 %
//       work to separate from delta_0     +0.01 % +0.1 %  +0.7 %  +1.7 %  +3.6 %  +7.3 %
//     DMT with R_e: its repulsion         -0.01 % -0.1 %  -1.0 %  -2.4 %  -5.1 %  -9.8 %
//
// Sliding, rolling and twisting see a round spot, and a sphere rolls as on the plane; the
// limit of sliding goes with the forces and is as good as they are. Rolling yields at
// xi_crit = criticalAngle r, or (a0/12) adhesionHysteresis with the a0 of this R.
// A flat wall is no limit of these formulas but R = r itself.
// Source: Johnson & Greenwood 2005, J. Phys. D 38, 1042; Giudici, Vella & Griffiths 2024,
// arXiv:2407.00378; Johnson, Contact Mechanics, ch. 4 (Hertz); Derjaguin 1934.
// Valid: lambda >= 1e-3; R_1 <= 10 r (checked where a particle is added).
// Proof: tests/unit/DEM/ellipticContact.cpp, tests/verification/DEM/curvedWalls.cpp
#pragma once

#include <cmath>

namespace dem
{
namespace ellipticContact
{

//- Relative curvatures 1/R_1 <= 1/R_2 as mean and shape of the ellipse
struct Shape
{
    double R;   // R_e [m]
    double y;   // ln^2(R_2/R_1)

    Shape(double inverse1, double inverse2)
    :
        R(1/std::sqrt(inverse1*inverse2)),
        y(0)
    {
        const double x = std::log(inverse2/inverse1);
        y = x*x;
    }
};

//- g: pull-off force over 3 pi R_e gamma
inline double pullOffFactor(double y)
{
    return
        (1 + y*(0.0352296 + y*0.000130982))
       /(1 + y*(0.0430384 + y*0.000215555));
}

//- h: Hertzian stiffness over (4/3) E R_e^(1/2), squared
inline double stiffnessFactor(double y)
{
    return
        (1 + y*(0.0652069 + y*(0.00117492 + y*8.47963e-6)))
       /(1 + y*(0.0235566 - y*0.000103647));
}

}
}
