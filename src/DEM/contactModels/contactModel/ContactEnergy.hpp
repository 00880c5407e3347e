// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energies of one contact, for the ledger (system/EnergyLedger.hpp).
#pragma once

namespace dem
{

//- Of the normal force [J]
struct NormalEnergy
{
    double stored;          // zero at touch; what the way out would give back
    double plastic = 0;     // work that has flattened the contact
};

//- Of one spring with the energy k xi^2/2
struct SpringEnergy
{
    double stiffness = 0;   // k, conjugate to xi
    double square = 0;      // |xi|^2
    double input = 0;       // power that the two bodies give to it [W]
    double gain = 0;        // power that its displacement takes from nowhere [W]
    bool yields = false;    // it is at its limit

    double stored() const { return 0.5*stiffness*square; }
};

struct ContactEnergy
{
    double overlap;             // [m]
    double closing;             // its rate [m/s]
    NormalEnergy normal;
    SpringEnergy springs[3];    // sliding, rolling, twisting
    double normalDashpot;       // power [W]
    double dashpots = 0;        // power of the other parts [W]

    double inSprings() const
    {
        return springs[0].stored() + springs[1].stored() + springs[2].stored();
    }
};

}
