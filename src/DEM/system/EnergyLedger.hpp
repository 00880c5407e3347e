// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the mechanical energy went, over the steps that were added up: all in J, with
// timeIntegration { energyLedger on; } only.
//
//     residual = kinetic + normal + springs + released + dashpots + yield + plastic + rest
//              - gas - springGain - stiffening
//
// What does not close is the error of the contact steps: kinetic energy comes from the
// motion, stored energies from the closed forms of the laws, dissipated ones from powers by
// quadrature. Only what a spring loses at its limit (yield) is the difference of
// the work on it and its energy.
// A spring whose stiffness k follows the contact radius is not conservative: at a held
// displacement xi its energy grows by xi^2 dk/2 and nobody has paid for it (springGain); so
// does the rolling displacement of unequal spheres, or on a wall, that slip adds to. Springs
// that keep their force instead (cohesivePlastic) lose as much.
// Proof: tests/verification/DEM/{energyLedger,matrix}.cpp
#pragma once

namespace dem
{

struct EnergyLedger
{
    double kinetic = 0;     // change, translation and spin
    double normal = 0;      // change of what normal forces store, elastic and adhesive
    double springs = 0;     // change of what sliding, rolling and twisting springs store
    double released = 0;    // was stored when a contact ended (neck, springs)
    double dashpots = 0;    // dissipated
    double yield = 0;       // dissipated by sliding, rolling and twisting at their limits
    double plastic = 0;     // work that flattened contacts
    double rest = 0;        // kinetic energy removed by rest
    double gas = 0;         // work done by gas and body forces
    double springGain = 0;  // given by the springs of the laws themselves
    double stiffening = 0;  // change of stored energy as chi was changed (system/Stiffening.hpp)

    double residual() const
    {
        return
            kinetic + normal + springs + released + dashpots + yield + plastic + rest
          - gas - springGain - stiffening;
    }

    void add(const EnergyLedger& o)
    {
        kinetic += o.kinetic;
        normal += o.normal;
        springs += o.springs;
        released += o.released;
        dashpots += o.dashpots;
        yield += o.yield;
        plastic += o.plastic;
        rest += o.rest;
        gas += o.gas;
        springGain += o.springGain;
        stiffening += o.stiffening;
    }
};

}
