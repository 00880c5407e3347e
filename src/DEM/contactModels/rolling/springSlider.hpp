// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rolling: a spring in the contact plane whose displacement is capped.
//
//     M_r = k_r xi + eta_R v_L,   k_r = 4 F_C (a/a0)^(3/2) [N],   |xi| <= xi_crit
//
// xi [m] rolling displacement, with the rate
//     v_L = R (omega_i - omega_j) x n + (1/2)((r_i - r_j)/(r_i + r_j)) v_S,
// n from i to j (wall: r_j -> infinity). xi_crit = (a0/12) adhesionHysteresis (H17, eq. 18,
// Krijt et al.) or criticalAngle R (C19, eq. 3c); F_C, a0 of the unsoftened contact, only
// a/a0 from the softened one. eta_R [N s] is rollingDamping, default 0.
// Without adhesion (F_C = 0) there is no resistance.
// Source: Haervig et al. 2017, eq. 18; Chen, Liu & Li 2019, eq. 3c.
// Keyword: rolling { model springSlider; criticalAngle 0.0085; }
//     or   rolling { model springSlider; adhesionHysteresis 0.4; }
// Proof: tests/unit/DEM/contactLaws.cpp, tests/verification/DEM/rollingYield.cpp
#pragma once

#include "contactModels/contactModel/ContactScale.hpp"
#include "contactModels/contactModel/NormalResponse.hpp"
#include "contactModels/contactModel/PartInput.hpp"
#include "contactModels/contactModel/Real.hpp"
#include "particles/errors.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{
namespace rolling
{

struct springSlider
{
    static constexpr const char* model = "springSlider";
    static constexpr bool on = true;
    static constexpr bool elasticOnly = true;   // it is a property of the elastic neck
    static constexpr bool bends = false;
    static constexpr int nConstants = 3;
    static constexpr int nHistory = 3;

    static std::vector<PartKeyword> keywords()
    {
        return
        {
            {
                "criticalAngle", "rad", "or adhesionHysteresis", 0, 1, {},
                "rolling angle at which it begins to roll off"
            },
            {
                "adhesionHysteresis", "-", "or criticalAngle", 0, 10, {},
                "of the work of adhesion, which gives the critical angle"
            },
            {
                "rollingDamping", "N s", "0", 0, 1e6, {},
                "moment over the rolling velocity"
            }
        };
    }

    struct Parameters
    {
        double criticalAngle = 0;       // [rad]; 0 = use the hysteresis
        double adhesionHysteresis = 0;  // delta gamma/gamma [-]
        double rollingDamping = 0;      // eta_R [N s]
    };

    static Parameters read(const PartInput& input)
    {
        if (input.has("criticalAngle") == input.has("adhesionHysteresis"))
        {
            throw inputError
            (
                "rolling/criticalAngle",
                input.has("criticalAngle")
              ? "given together with adhesionHysteresis" : "missing",
                "either criticalAngle [rad] or adhesionHysteresis [-]"
            );
        }
        return
        {
            input.getOr("criticalAngle", 0),
            input.getOr("adhesionHysteresis", 0),
            input.getOr("rollingDamping", 0)
        };
    }

    static void prepare
    (
        const Parameters& p,
        const ContactScale& s,
        const ResistanceScale& r,
        double* c
    )
    {
        c[0] = p.criticalAngle > 0      // xi_crit/R
          ? p.criticalAngle
          : p.adhesionHysteresis*r.a0/(12*s.rollingRadius());
        c[1] = p.rollingDamping;
        c[2] = r.a0;
    }

    //- k_r = 4 F_C (a/a0)^(3/2) [N], a^2 = a0^2 + R delta
    static double stiffness(const double* c, double R, double overlap, double pullOff)
    {
        const double growth =
            c[2] > 0 ? 1 + std::max(overlap, 0.0)*R/(c[2]*c[2]) : 1;
        return 4*pullOff*std::sqrt(growth*std::sqrt(growth));
    }

    //- eta_R [N s]
    template<class Real>
    [[gnu::always_inline]] static Real damping(const Real* c) { return c[1]; }

    //- 4 F_C xi_crit [N m]
    static double yield(const double* c, double R, double pullOff)
    {
        return 4*pullOff*c[0]*R;
    }

    //- M per xi [N]; the spring's energy is k_r xi^2/(2 R)
    template<class Real>
    [[gnu::always_inline]] static Real stiffness(const NormalResponse<Real>& normal)
    {
        return Real(4)*normal.pullOff*normal.strength;
    }
    //- Moment at which it yields [N m]
    template<class Real>
    static Real limit(const Real* c, const Real& R, const NormalResponse<Real>& normal)
    {
        return stiffness(normal)*c[0]*R;
    }

    //- Whether xi is beyond the critical displacement
    template<class Real>
    [[gnu::always_inline]] static auto yields
    (
        const Real* c, const Real& R, const NormalResponse<Real>&, const V3<Real>& xi
    )
    {
        return dot(xi, xi) > c[0]*R*(c[0]*R);
    }

    //- Share of xi that is left there
    template<class Real>
    [[gnu::always_inline]] static Real cut
    (
        const Real* c, const Real& R, const NormalResponse<Real>&, const V3<Real>& xi
    )
    {
        return c[0]*R/squareRoot(maximum(dot(xi, xi), Real(1e-290)));
    }
};

}
}
