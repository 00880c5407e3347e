// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "materials/MaterialTable.hpp"

namespace dem
{

//- What the constants of one contact are made from
struct ContactScale
{
    const PairConstants& pair;
    double R;               // effective radius [m]; flat wall: r_i
    double m;               // effective mass [kg]; wall: m_i

    //- R of the rolling velocity [m]: on a curved wall r_i, where R is less; 0: R
    double rolling = 0;

    double rollingRadius() const { return rolling > 0 ? rolling : R; }
};

//- The original strength of a contact, as the resistances use it (PairConstants::limits)
struct ResistanceScale
{
    double a0;              // equilibrium radius of the unsoftened contact [m]
    double radiusFactor;    // a of the limits over a of the softened contact [-]
    double stiffness;       // K'_R, of the normal law when it is loaded [N/m]
};

}
