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

#include "foundation/Sum.hpp"

namespace dem
{

struct EnergyLedger
{
    Sum kinetic;        // change, translation and spin
    Sum normal;         // change of what normal forces store, elastic and adhesive
    Sum springs;        // change of what sliding, rolling and twisting springs store
    Sum released;       // was stored when a contact ended (neck, springs)
    Sum dashpots;       // dissipated
    Sum yield;          // dissipated by sliding, rolling and twisting at their limits
    Sum plastic;        // work that flattened contacts
    Sum rest;           // kinetic energy removed by rest
    Sum gas;            // work done by gas and body forces
    Sum springGain;     // given by the springs of the laws themselves
    Sum stiffening;     // change of stored energy as chi was changed (system/Stiffening.hpp)

    double residual() const
    {
        return
            kinetic + normal + springs + released + dashpots + yield + plastic + rest
          - gas - springGain - stiffening;
    }

    EnergyLedger& operator+=(const EnergyLedger& o)
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
        return *this;
    }

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.kinetic);
        f(s.normal);
        f(s.springs);
        f(s.released);
        f(s.dashpots);
        f(s.yield);
        f(s.plastic);
        f(s.rest);
        f(s.gas);
        f(s.springGain);
        f(s.stiffening);
    }
};

}
