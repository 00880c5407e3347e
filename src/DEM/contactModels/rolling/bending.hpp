// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bending: a rotational spring with a cap, of the strength that the attraction gives.
//
//     K_theta = R F_c/2 [N m/rad],   |M| <= B_max = b_f (F_c/2) (R F_c/K'_R)^(1/2)
//
// The angle of the spring is xi/R with the rolling displacement xi [m] of springSlider.hpp,
// so M = (F_c/2) xi and |xi| <= b_f (R F_c/K'_R)^(1/2). F_c [N] is the pull-off force, with
// the build-up of a law that hardens; K'_R [N/m] the stiffness of the normal law when it is
// loaded: K_R of cohesivePlastic, the slope at the equilibrium of elastic laws (1.2 E a0 for
// both JKR, 2 E a0 for DMT and vanDerWaals). Both are those of the unsoftened contact, or
// with reducedStiffness { resistance scaled; } of the softened one: K'_R = s_f K_R.
// The spring is 1/8 of the JKR rolling stiffness: not interchangeable with springSlider.
// b_f [-] is bendingFactor, eta_R [N s] rollingDamping (M = ... + eta_R v_L), default 0.
// Without attraction (F_c = 0) there is no resistance.
// Source: Walton 2004 (SAE 2004-01-2329), bending moment.
// Keyword: rolling { model bending; bendingFactor 1; }
// Proof: tests/unit/DEM/bending.cpp, tests/verification/cohesivePlastic
#pragma once

#include "contactModels/contactModel/ContactScale.hpp"
#include "contactModels/contactModel/NormalResponse.hpp"
#include "contactModels/contactModel/PartInput.hpp"
#include "contactModels/contactModel/Real.hpp"

namespace dem
{
namespace rolling
{

struct bending
{
    static constexpr const char* model = "bending";
    static constexpr bool on = true;
    static constexpr bool elasticOnly = false;
    static constexpr bool bends = true;
    static constexpr int nConstants = 2;
    static constexpr int nHistory = 3;

    static std::vector<PartKeyword> keywords()
    {
        return
        {
            {
                "bendingFactor", "-", "", 0, 1000, {},
                "factor of the largest bending moment"
            },
            {
                "rollingDamping", "N s", "0", 0, 1e6, {},
                "moment over the rolling velocity"
            }
        };
    }

    struct Parameters
    {
        double factor = 0;          // b_f [-]
        double rollingDamping = 0;  // eta_R [N s]
    };

    static Parameters read(const PartInput& input)
    {
        return
        {
            input.get("bendingFactor"),
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
        c[0] = r.stiffness > 0 ? p.factor*std::sqrt(s.R/r.stiffness) : 0;
        c[1] = p.rollingDamping;
    }

    //- K_theta/R [N]
    static double stiffness(const double*, double, double, double pullOff)
    {
        return 0.5*pullOff;
    }

    //- eta_R [N s]
    template<class Real>
    [[gnu::always_inline]] static Real damping(const Real* c) { return c[1]; }

    //- B_max [N m] of a contact that has not been loaded before
    static double yield(const double* c, double, double pullOff)
    {
        return 0.5*pullOff*c[0]*std::sqrt(pullOff);
    }

    //- Share of xi that is kept where K_theta has grown: the moment stays
    template<class Real>
    [[gnu::always_inline]] static Real kept(const NormalResponse<Real>& normal)
    {
        return normal.pullOffBefore/maximum(normal.pullOff, Real(1e-290));
    }

    //- B_max [N m]
    template<class Real>
    [[gnu::always_inline]] static Real limit
    (
        const Real* c, const Real&, const NormalResponse<Real>& normal
    )
    {
        return stiffness(normal)*c[0]*squareRoot(normal.pullOff);
    }

    //- M per xi [N]; the spring's energy is F_c xi^2/(4 R)
    template<class Real>
    [[gnu::always_inline]] static Real stiffness(const NormalResponse<Real>& normal)
    {
        return Real(0.5)*normal.pullOff;
    }

    //- Whether xi is beyond what B_max holds
    template<class Real>
    [[gnu::always_inline]] static auto yields
    (
        const Real* c, const Real&, const NormalResponse<Real>& normal, const V3<Real>& xi
    )
    {
        return dot(xi, xi) > c[0]*c[0]*normal.pullOff;
    }

    //- Share of xi that is left there
    template<class Real>
    [[gnu::always_inline]] static Real cut
    (
        const Real* c, const Real&, const NormalResponse<Real>& normal, const V3<Real>& xi
    )
    {
        return squareRoot(c[0]*c[0]*normal.pullOff/maximum(dot(xi, xi), Real(1e-290)));
    }
};

}
}
