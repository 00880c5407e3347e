// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vector.hpp"

namespace dem
{

//- What the gas gave to one particle in the last particle step, and what it would have given
//  in a gas faster by dU:  impulse + response dU
struct GasExchange
{
    //- Drag and Su, contact impulses not included [N s]. Of one at rest: of the load that it
    //  rests under; what holds it takes that. In a flying cluster: ClusterDrag
    Vec3 impulse = Vec3::Zero();

    //- d(impulse)/dUc [kg]
    //      in free flight      m (1 - e^-z),                       z = Sp dt/m
    //      in a flying cluster Sp dt (1 - e^-Z)/Z (the cluster's mass shares in it),
    //                          Z = sum(Sp) dt/sum(m)
    //      held                Sp dt
    double response = 0;

    //- Share of a change of velocity at the step's start that is left at its end [-]:
    //  e^-z, e^-Z; held: 1 (impulses add up)
    double memory = 1;

    //- By a wall or by what rests
    bool held = false;

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.impulse);
        f(s.response);
        f(s.memory);
        f(s.held);
    }
};

}
