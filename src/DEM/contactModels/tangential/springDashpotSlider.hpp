// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sliding: spring, dashpot and slider in the contact plane.
//
//     F_T = -k_T xi - eta_T v_S,    k_T = 8 G a,    |F_T| <= mu |F_N + 2 F_C|
//
// xi [m] is the sliding displacement, v_S [m/s] the slip velocity of the two surfaces,
// G [Pa] the effective shear modulus, a [m] the radius that the normal law gives, eta_T the
// dashpot that the normal law gives, mu [-] the friction coefficient, F_N the elastic normal
// force, F_C the pull-off force of the unsoftened contact (its share, 2 here, is the normal
// law's slidingShare). Where the limit is reached the stored displacement is cut back too, so
// that F_T keeps its direction and unloads at once.
// Source: Haervig et al. 2017, eq. 16 (dashpot); Chen, Liu & Li 2019.
// Keyword: tangential { model springDashpotSlider; friction 0.3; }
// Proof: tests/unit/DEM/contactLaws.cpp, tests/verification/DEM/slipToRoll.cpp
#pragma once

#include "contactModels/contactModel/ContactScale.hpp"
#include "contactModels/contactModel/NormalResponse.hpp"
#include "contactModels/contactModel/PartInput.hpp"
#include "contactModels/contactModel/Real.hpp"

namespace dem
{
namespace tangential
{

struct springDashpotSlider
{
    static constexpr const char* model = "springDashpotSlider";
    static constexpr bool on = true;
    static constexpr int nConstants = 3;
    static constexpr int nHistory = 3;

    static std::vector<PartKeyword> keywords()
    {
        return {{"friction", "-", "", 0, 10, {}, "coefficient of friction"}};
    }

    struct Parameters { double friction = 0; };

    static Parameters read(const PartInput& input)
    {
        return {input.get("friction")};
    }

    static void prepare
    (
        const Parameters& p,
        const ContactScale& s,
        double dampingRatio,    // eta_T/eta_N
        double* c
    )
    {
        c[0] = 8*s.pair.G;
        c[1] = dampingRatio;
        c[2] = p.friction;
    }

    //- k_T [N/m] at contact radius a; the spring's energy is k_T xi^2/2
    template<class Real>
    [[gnu::always_inline]] static Real stiffness(const Real* c, const Real& a)
    {
        return c[0]*a;
    }

    //- eta_T [N s/m] with the dashpot of the normal law
    template<class Real>
    [[gnu::always_inline]] static Real damping(const Real* c, const Real& etaN)
    {
        return c[1]*etaN;
    }

    //- Share of xi that is kept where k_T has grown: the force stays
    template<class Real>
    [[gnu::always_inline]] static Real kept(const Real*, const NormalResponse<Real>& normal)
    {
        return normal.radiusKept;
    }

    //- mu |F_N + 2 F_C| [N]; pressed = F_N + 2 F_C
    template<class Real>
    [[gnu::always_inline]] static Real limit(const Real* c, const Real& pressed)
    {
        return c[2]*magnitude(pressed);
    }

    //- Force on i [N] below the limit
    template<class Real>
    [[gnu::always_inline]] static V3<Real> trial
    (
        const Real* c,
        const NormalResponse<Real>& normal,
        const V3<Real>& slipVelocity,
        const V3<Real>& xi
    )
    {
        return
            (-stiffness(c, normal.radius))*xi - damping(c, normal.damping)*slipVelocity;
    }

    //- Whether such a force is beyond the limit
    template<class Real>
    [[gnu::always_inline]] static auto slides(const V3<Real>& trial, const Real& limit)
    {
        return dot(trial, trial) > limit*limit;
    }

    //- Force on i [N]; xi is cut back at the limit
    template<class Real>
    [[gnu::always_inline]] static V3<Real> evaluate
    (
        const Real* c,
        const Real& limit,              // [N]
        const NormalResponse<Real>& normal,
        const V3<Real>& slipVelocity,
        V3<Real>& xi
    )
    {
        const V3<Real> F = trial(c, normal, slipVelocity, xi);
        const auto beyond = slides(F, limit);
        const Real size = squareRoot(maximum(dot(F, F), Real(1e-290)));
        const Real stored =
            stiffness(c, normal.radius)*squareRoot(maximum(dot(xi, xi), Real(1e-290)));
        const auto longer = select(beyond, stored, Real(0)) > limit;
        xi = select(longer, limit/maximum(stored, Real(1e-290)), Real(1))*xi;
        return select(beyond, limit/size, Real(1))*F;
    }
};

}
}
