// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/finite.hpp"
#include "particles/vector.hpp"

namespace dem
{

//- Gas and body force on one particle, frozen for one particle step:
//      force = Sp (Uc - v) + Su   [N],     torque = SpOmega (omegaC - omega)   [N m]
struct GasLoad
{
    double Sp = 0;              // [kg/s] >= 0; relaxation time tau_p = m/Sp
    Vec3 Uc = Vec3::Zero();     // gas velocity at the particle [m/s]
    Vec3 Su = Vec3::Zero();     // [N]
    double SpOmega = 0;         // [N m s] >= 0; Stokes: 8 pi mu r^3
    Vec3 omegaC = Vec3::Zero(); // half the gas vorticity [rad/s]
    double apart = 1;           // of drag beside that of its flying cluster, see ClusterDrag [-]

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.Sp);
        f(s.Uc);
        f(s.Su);
        f(s.SpOmega);
        f(s.omegaC);
        f(s.apart);
    }

    bool finite() const
    {
        return
            isFinite(Sp) && isFinite(SpOmega) && isFinite(Uc) && isFinite(Su)
         && isFinite(omegaC) && isFinite(apart);
    }
};

}
