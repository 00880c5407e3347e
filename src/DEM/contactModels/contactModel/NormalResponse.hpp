// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dem
{

//- What a normal law tells the other parts of a contact
template<class Real>
struct NormalResponse
{
    Real elastic;   // F_N [N], compressive positive, without damping
    Real damping;   // eta_N [N s/m]
    Real radius;    // radius that carries the sliding and twisting stiffness [m]
    Real strength;  // (a/a0)^(3/2) [-], the growth of the rolling stiffness with load
    Real remaining; // [m]; negative: the contact has ended
    Real pullOff;   // F_C of the unsoftened contact, as past loads have left it [N]

    // Laws that are not elastic only
    Real pullOffBefore = Real(0);   // at the last evaluation [N]
    Real radiusKept = Real(1);      // radius at the last evaluation over radius [-]
};

//- Tabor numbers for which a normal law holds [-]
struct TaborRange
{
    double least, most;
};

//- What the part that limits twisting tells it
template<class Real>
struct TwistingBase
{
    Real limit;                     // F_S,crit of sliding [N] or B_max of bending [N m]
    Real stiffness = Real(0);       // k_T of sliding [N/m]
    Real damping = Real(0);         // eta_T of sliding [N s/m]
};

//- Adhesionless restitution e -> beta = |ln e|/sqrt(ln^2 e + pi^2)
double dampingRatio(double restitution);

}
