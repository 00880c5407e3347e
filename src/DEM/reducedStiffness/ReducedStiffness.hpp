// SPDX-License-Identifier: GPL-3.0-or-later
//
// Softer particles with the same adhesive rebound.
//
//     E_mod = chi E,   gamma_mod = chi^(2/5) gamma        (Haervig et al. 2017)
//
// keep e_eff(v), the sticking speed and v(t chi^(2/5)) exactly; contact times and overlaps
// grow as chi^(-2/5), forces shrink as chi^(2/5). Rolling, sliding and twisting keep the
// strength of the unsoftened particle (F_C, xi_crit and contact radius at chi = 1).
// How soft: advice/adviseRatio.hpp.
#pragma once

namespace dem
{

struct ReducedStiffness
{
    //- chi = E_mod/E [-] in (0, 1]; 1 = off
    double ratio = 1;

    //- gamma_mod = gamma chi^(2/5) if true, gamma if false (studies only)
    bool scaleSurfaceEnergy = true;

    //- Rolling, sliding and twisting strength from the softened contact if true: yields
    //  too early by chi^(1/5) to chi^(2/5) (studies only)
    bool scaleResistance = false;

    //- chi^(2/5) or 1, by which the surface energy of the normal law is multiplied
    double surfaceEnergyFactor() const;
};

}
