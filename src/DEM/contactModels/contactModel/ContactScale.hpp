// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "materials/MaterialTable.hpp"

namespace dem
{

//- What the constants of one contact are made from
struct ContactScale
{
    const PairConstants& pair;
    double R;               // effective radius [m]; wall: r_i
    double m;               // effective mass [kg]; wall: m_i
};

//- The original strength of a contact, as the resistances use it (PairConstants::limits)
struct ResistanceScale
{
    double a0;              // equilibrium radius of the unsoftened contact [m]
    double radiusFactor;    // a of the limits over a of the softened contact [-]
    double stiffness;       // K'_R, of the normal law when it is loaded [N/m]
};

}
