// SPDX-License-Identifier: GPL-3.0-or-later
//
// Twisting: a spring as stiff as that of bending, capped by a part of the bending moment.
//
//     M_t = -K_phi xi - eta_Q omega_T,   K_phi = K_theta = R F_c/2 [N m/rad]
//     |M_t| <= t_f B_max
//
// xi [rad] twist, omega_T = (omega_i - omega_j).n [rad/s]; F_c and B_max of
// rolling/bending.hpp, which it needs. t_f [-] is twistingFactor, eta_Q [N m s]
// twistingDamping, default 0: then a twist below the cap swings for ever.
// Source: Walton 2004 (SAE 2004-01-2329), twisting moment.
// Keyword: twisting { model cappedSpring; twistingFactor 0.5; }
// Proof: tests/unit/DEM/bending.cpp, tests/verification/cohesivePlastic
#pragma once

#include "contactModels/contactModel/ContactScale.hpp"
#include "contactModels/contactModel/NormalResponse.hpp"
#include "contactModels/contactModel/PartInput.hpp"
#include "contactModels/contactModel/Real.hpp"

namespace dem
{
namespace twisting
{

struct cappedSpring
{
    static constexpr const char* model = "cappedSpring";
    static constexpr bool on = true;
    static constexpr bool limitedBySliding = false;
    static constexpr bool limitedByBending = true;
    static constexpr int nConstants = 3;
    static constexpr int nHistory = 1;

    static std::vector<PartKeyword> keywords()
    {
        return
        {
            {
                "twistingFactor", "-", "", 0, 1000, {},
                "largest twisting moment over that of bending"
            },
            {
                "twistingDamping", "N m s", "0", 0, 1e6, {},
                "moment over the rate of twist"
            }
        };
    }

    struct Parameters
    {
        double factor = 0;      // t_f [-]
        double damping = 0;     // eta_Q [N m s]
    };

    static Parameters read(const PartInput& input)
    {
        return
        {
            input.get("twistingFactor"),
            input.getOr("twistingDamping", 0)
        };
    }

    static void prepare
    (
        const Parameters& p,
        const ContactScale& s,
        const ResistanceScale&,
        double* c
    )
    {
        c[0] = 0.5*s.R;
        c[1] = p.factor;
        c[2] = p.damping;
    }

    //- K_phi [N m/rad]; the spring's energy is K_phi xi^2/2
    template<class Real>
    [[gnu::always_inline]] static Real stiffness
    (
        const Real* c, const Real&, const Real& pullOff, const TwistingBase<Real>&
    )
    {
        return c[0]*pullOff;
    }
    //- eta_Q [N m s]
    static double damping(const double* c, double, const TwistingBase<double>&) { return c[2]; }

    //- Share of xi that is kept where K_phi has grown: the moment stays
    template<class Real>
    [[gnu::always_inline]] static Real kept(const NormalResponse<Real>& normal)
    {
        return normal.pullOffBefore/maximum(normal.pullOff, Real(1e-290));
    }

    //- Moment at which it yields [N m]
    static double limit
    (
        const double* c, const NormalResponse<double>&, const TwistingBase<double>& bending
    )
    {
        return c[1]*bending.limit;
    }

    //- Moment on i along n [N m]
    template<class Real>
    [[gnu::always_inline]] static Real evaluate
    (
        const Real* c,
        const NormalResponse<Real>& normal,
        const TwistingBase<Real>& bending,
        const Real& twist,              // moved on this step [rad]
        const Real& twistRate,
        Real& xi
    )
    {
        const Real k = stiffness(c, normal.radius, normal.pullOff, bending);
        xi = xi + twist;
        const Real cap = c[1]*bending.limit;
        const Real most = cap/maximum(k, Real(1e-290));
        xi = maximum(-most, minimum(most, xi));
        return Real(-1)*(k*xi + c[2]*twistRate);
    }
};

}
}
