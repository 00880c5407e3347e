// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/GasLoad.hpp"

#include <algorithm>

namespace dem
{

//- Drag of a cluster that flies, and how the gas has to bear it. To a gas that changes about all
//  of it the cluster answers as a whole (GasExchange::response); what one member gets beside
//  its part of the sum, S_i/sum(S) of it, goes on through the bonds as long as the gas flows so.
//  Gas that is carried along would not: of
//
//      D_i - S_i/sum(S) sum(D),   D_i the impulse of drag on member i
//
//  (sum 0, so that momentum is kept) it gives the share `apart`, the least of all members,
//      (1 - e^-a)/a,   a: Sp dt of the dust there over the mass of the gas
//  which is 1 where the gas is heavy. With all of it, gas between the members swings by the
//  factor a from one gas step to the next.
struct ClusterDrag
{
    double Sp = 0;
    Vec3 drag = Vec3::Zero();
    double apart = 1;

    void add(const GasLoad& g, const Vec3& impulse, double dt)
    {
        Sp += g.Sp;
        drag += impulse - dt*g.Su;
        apart = std::min(apart, g.apart);
    }

    //- What the gas gives to a member, of its impulse
    Vec3 given(const GasLoad& g, const Vec3& impulse, double dt) const
    {
        if (apart >= 1 || !(Sp > 0)) return impulse;
        return impulse - (1 - apart)*(impulse - dt*g.Su - g.Sp/Sp*drag);
    }
};

}
