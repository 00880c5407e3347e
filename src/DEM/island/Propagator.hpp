// SPDX-License-Identifier: GPL-3.0-or-later
//
// How loads reach velocities. One contact step, v_n -> v_n+1:
//     x_n+1 = x_n + p1 v_n + p2 (b + F_n/m)              (freeFlight.hpp; b: gas, gravity)
//     v_h = e v_n + p1 b + (p1 - p2/h) F_n/m
//     F_n+1 from x_n+1 and the predictor v_h + (p2/h) F*/m,  F* = F_n
//     v_n+1 = v_h + (p2/h) F_n+1/m
// i.e. exact in the drag for a contact force that changes linearly, at any tau_p/h; without
// drag velocity Verlet (p1 = h, p2 = h^2/2). Of second order, damping included, where the
// force is smooth. Refined steps take F* = F_n + (F_n - F_n-1)/2: with F_n dashpots take too
// much, with the whole extrapolation as much too little.
//
// Between steps the velocities of the bodies are the predictor, and the last kick is owed:
// complete() is the only way to the velocities at a step's end.
#pragma once

#include "island/IslandState.hpp"

#include <optional>
#include <vector>

namespace dem
{

class Propagator
{
public:

    //- At the start of a run
    void begin(const IslandState& state);

    //- What is owed of the last kick, the first kick of a step of h, and the flight over it;
    //  loads become zero. refined: they are kept for foresee()
    void drift(IslandState& state, double h, bool refined);

    //- Add half of the coming change of the loads to the predicted velocities
    void foresee(IslandState& state, double h);

    //- The second kick of the last step, if it is owed: velocities are those at its end
    void complete(IslandState& state) const
    {
        if (state.phase.owed != 0) secondKick(state);
    }

    //- Loads have jumped: they do not tell what comes
    void forgetLoads() { previousStep_.reset(); }

    //- Others are awake than before
    void awakeChanged() { flightStep_.reset(); }


private:

    //- Flight over one h, per particle
    struct Flight
    {
        double e, p1, p2, early, late;
        double eSpin, earlySpin, lateSpin;
        double b[3];                        // [m/s2]
        double driven[3], drivenSpin[3];    // what the gas adds over h [m/s], [rad/s]
    };

    //- What a force and a torque make of the second kick [s/kg], [s/(kg m2)]
    struct Push { double v, w; };

    void setFlight(const IslandState& state, double h);
    template<bool gas> double fly(IslandState& state, double h);
    void secondKick(IslandState& state) const;
    Push pushOf(const IslandState& state, std::size_t k, double h) const;

    bool vacuum_ = false;                           // no gas force on any particle
    std::vector<Flight> flight_;
    std::optional<double> flightStep_;              // h that flight_ is made for [s]
    std::vector<Load> previousLoads_, lastLoads_;   // of refined steps
    std::optional<double> previousStep_;            // [s] from previousLoads_ to lastLoads_
};

}
