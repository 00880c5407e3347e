// SPDX-License-Identifier: GPL-3.0-or-later
//
// Twisting: spring, dashpot and slider about the line of centres.
//
//     M_t = -k_Q xi - eta_Q omega_T,   k_Q = k_T a^2/2,  eta_Q = eta_T a^2/2
//     |M_t| <= (3 pi/16) a F_S,crit,   F_S,crit = mu |F_N + 2 F_C| of the sliding part
//
// xi [rad] twist, omega_T = (omega_i - omega_j).n [rad/s]. The radius in the limit is that of
// the unsoftened contact. Needs a sliding part.
// Source: Chen, Liu & Li 2019; Marshall 2009.
// Keyword: twisting { model springDashpotSlider; }
// Proof: tests/unit/DEM/contactLaws.cpp
#pragma once

#include "contactModels/contactModel/ContactScale.hpp"
#include "contactModels/contactModel/NormalResponse.hpp"
#include "contactModels/contactModel/PartInput.hpp"
#include "contactModels/contactModel/Real.hpp"

namespace dem
{
namespace twisting
{

struct springDashpotSlider
{
    static constexpr const char* model = "springDashpotSlider";
    static constexpr bool on = true;
    static constexpr bool limitedBySliding = true;
    static constexpr bool limitedByBending = false;
    static constexpr int nConstants = 1;
    static constexpr int nHistory = 1;

    static std::vector<PartKeyword> keywords() { return {}; }

    struct Parameters {};
    static Parameters read(const PartInput&) { return {}; }

    static void prepare
    (
        const Parameters&,
        const ContactScale&,
        const ResistanceScale& r,
        double* c
    )
    {
        c[0] = 3*M_PI/16*r.radiusFactor;
    }

    //- k_Q [N m/rad] at contact radius a; the spring's energy is k_Q xi^2/2
    template<class Real>
    [[gnu::always_inline]] static Real stiffness
    (
        const Real*, const Real& a, const Real&, const TwistingBase<Real>& sliding
    )
    {
        return Real(0.5)*a*a*sliding.stiffness;
    }
    //- eta_Q [N m s]
    static double damping(const double*, double a, const TwistingBase<double>& sliding)
    {
        return 0.5*a*a*sliding.damping;
    }

    //- Share of xi that is kept where k_Q has grown: the moment stays
    template<class Real>
    [[gnu::always_inline]] static Real kept(const NormalResponse<Real>& normal)
    {
        return normal.radiusKept*normal.radiusKept*normal.radiusKept;
    }

    //- Moment at which it yields [N m]
    static double limit
    (
        const double* c, const NormalResponse<double>& normal,
        const TwistingBase<double>& sliding
    )
    {
        return c[0]*normal.radius*sliding.limit;
    }

    //- Moment on i along n [N m]
    template<class Real>
    [[gnu::always_inline]] static Real evaluate
    (
        const Real* c,
        const NormalResponse<Real>& normal,
        const TwistingBase<Real>& sliding,
        const Real& twist,              // moved on this step [rad]
        const Real& twistRate,
        Real& xi
    )
    {
        const Real half = Real(0.5)*normal.radius*normal.radius;
        const Real k = half*sliding.stiffness;
        const Real dash = half*sliding.damping*twistRate;
        xi = xi + twist;
        const Real trial = k*xi + dash;
        const Real cap = c[0]*normal.radius*sliding.limit;
        const auto slides = magnitude(trial) > cap;
        if (!any(slides)) return -trial;

        const Real held = maximum(-cap, minimum(cap, trial));
        const Real limit = cap/maximum(k, Real(1e-290));
        xi = maximum(-limit, minimum(limit, xi));
        return -held;
    }
};

}
}
