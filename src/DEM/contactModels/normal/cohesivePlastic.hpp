// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cohesive plastic: yields when it is loaded for the first time, springs back more stiffly,
// and attracts with a force that grows with the load it has borne.
//
//     F_N = F_R - F_c,       F_c = F_c0 + c_f F_Rmax,      F_Rmax = K_R delta_max
//     F_R = max(0, F_Rmax - K_2 (delta_max - delta))       (= K_R delta where delta = delta_max)
//     K_R = 4 pi Y R s_f,    K_2 = max(K_R, ...)
//       unloading initial:   2 E' a          slope of a Hertzian contact of radius a
//       unloading average:   (4/3) E' a      its force over its overlap
//       restitution e:       K_R/e^2         (without attraction it rebounds with e v)
//     energy F_R^2/(2 K_2) - F_c delta;  plastic work (1/2) F_Rmax delta_max (1 - K_R/K_2 + c_f)
//
// a^2 = 2 R delta_max is the flattened spot, E' = s_f^(5/4) E. Contact begins at delta = 0
// and ends there, and forgets; delta_max is its history. K_2 >= K_R, else it would create
// energy: up to delta = 2 (pi Y/E)^2 R (initial; 9/4 of that with average) it is elastic.
// No dashpot unless dampingRatio zeta [-] is given: eta_N = 2 zeta (m K_R)^(1/2), eta_T = eta_N.
// Sliding: k_T = 8 s_f^(5/4) G a; friction presses with F_N + F_c. Springs that stiffen as
// a and F_c grow keep their force, not their displacement: that creates no energy either.
//
//     yieldStrength Y [Pa]; the spot carries the pressure 2 Y
//     attraction F_c0 [N], the same for all sizes, or attractionPerRadius F_c0/R [N/m] (with
//         the energy gamma of one surface: 3 pi gamma as JKR, 4 pi gamma as DMT)
//     attractionBuildUp c_f [-], 0 to below 1;  softening s_f [-], 1 (default) = real stiffness
//
// Softening: s_f with F_c0 s_f^(1/2) leaves e(v), sticking speed and v(t s_f^(1/2)) exactly
// as they are; F_c0 is taken as given, so s_f alone lets it stick at higher speeds. The
// reduced stiffness of elastic laws (chi) does not apply and is refused; surfaceEnergy has no
// part in this law and may be 0.
// Source: Walton 2004 (SAE 2004-01-2329), normal force; Walton & Braun 1986 for restitution.
// Keyword: normal { model cohesivePlastic; yieldStrength 1e8; unloading initial;
//              attraction 5e-8; attractionBuildUp 0.1; }
// Proof: tests/unit/DEM/cohesivePlastic.cpp, tests/verification/cohesivePlastic
#pragma once

#include "contactModels/contactModel/ContactEnergy.hpp"
#include "contactModels/contactModel/ContactScale.hpp"
#include "contactModels/contactModel/NormalResponse.hpp"
#include "contactModels/contactModel/PartInput.hpp"
#include "contactModels/contactModel/Real.hpp"
#include "contactModels/normal/ellipticContact.hpp"
#include "particles/errors.hpp"
#include "timeIntegration/contactPeriod.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{
namespace normal
{

struct cohesivePlastic
{
    static constexpr const char* model = "cohesivePlastic";
    static constexpr bool elastic = false;
    static constexpr bool atDistance = false;
    static constexpr TaborRange tabor = {0, 1e300};
    static constexpr double slidingShare = 1;      // of F_C, in the sliding limit
    static constexpr int nConstants = 7;
    static constexpr int nHistory = 1;

    static std::vector<PartKeyword> keywords()
    {
        return
        {
            {
                "yieldStrength", "Pa", "", 1, 1e14, {},
                "Y; the flattened spot carries the pressure 2 Y"
            },
            {
                "unloading", "-", "or restitution", 0, 0, {"initial", "average"},
                "slope of unloading, as the Hertzian contact of the spot"
            },
            {
                "restitution", "-", "or unloading", 0.01, 1, {},
                "of impacts without attraction; gives the slope of unloading"
            },
            {
                "attraction", "N", "or attractionPerRadius", 0, 1e3, {},
                "pull-off force of a contact that was never pressed"
            },
            {
                "attractionPerRadius", "N/m", "or attraction", 0, 1e6, {},
                "the same over the effective radius"
            },
            {
                "attractionBuildUp", "-", "", 0, 0.99, {},
                "share of the largest force that is added to the attraction"
            },
            {
                "softening", "-", "1", 1e-9, 1, {},
                "of the stiffness; 1 is the real one"
            },
            {
                "dampingRatio", "-", "0", 0, 1, {},
                "of a dashpot beside the spring"
            }
        };
    }

    struct Parameters
    {
        double yieldStrength;       // Y [Pa]
        double slope;               // K_2/(E' a) [-]; 0 = by restitution
        double ratio;               // K_2/K_R at least [-]
        double attraction;          // F_c0 [N]
        double attractionPerRadius; // F_c0/R [N/m]
        double buildUp;             // c_f [-]
        double softening;           // s_f [-]
        double dampingRatio;        // zeta [-]
    };

    static Parameters read(const PartInput& input)
    {
        const auto either = [&](const char* a, const char* b, const char* allowed)
        {
            if (input.has(a) != input.has(b)) return;
            throw inputError
            (
                std::string("normal/") + a,
                input.has(a)
              ? std::string("given together with ") + b
              : std::string("missing, needed by model ") + model,
                allowed
            );
        };
        either("unloading", "restitution", "either unloading (initial average) or restitution");
        either
        (
            "attraction", "attractionPerRadius",
            "either attraction [N] or attractionPerRadius [N/m]"
        );

        Parameters p;
        p.yieldStrength = input.get("yieldStrength");
        p.slope = 0;
        p.ratio = 1;
        if (input.has("unloading"))
        {
            p.slope =
                input.word("unloading") == "initial" ? 2 : 4.0/3.0;
        }
        else
        {
            const double e = input.get("restitution");
            p.ratio = 1/(e*e);
        }
        p.attraction = input.getOr("attraction", 0);
        p.attractionPerRadius = input.getOr("attractionPerRadius", 0);
        p.buildUp = input.get("attractionBuildUp");
        p.softening = input.getOr("softening", 1);
        p.dampingRatio = input.getOr("dampingRatio", 0);
        return p;
    }

    //- Of the sphere on a plane that stands for an elliptic contact [m]
    static double effectiveRadius(const ellipticContact::Shape& s)
    {
        return s.R;
    }
    static double pullOff(const Parameters& p, const PairConstants&, double R)
    {
        return p.attraction + p.attractionPerRadius*R;
    }
    static double touchDistance(const Parameters&, const PairConstants&) { return 0; }
    static double reach(const Parameters&, const PairConstants&, double) { return 0; }
    static double tangentialDampingRatio(const PairConstants&) { return 1; }

    //- K_R [N/m]
    static double loadingStiffness(const Parameters& p, const PairConstants& c, double R)
    {
        return 4*M_PI*p.yieldStrength*R*(c.softened ? p.softening : 1);
    }

    //- Of the contact that is only loaded by its own attraction [m]
    static double equilibriumRadius(const Parameters& p, const PairConstants& c, double R)
    {
        return std::sqrt(2*R*pullOff(p, c, R)/loadingStiffness(p, c, R));
    }

    //- By which E and G are softened: K_2/K_R at given impact stays as it is
    static double shearFactor(const Parameters& p) { return std::pow(p.softening, 1.25); }

    static void prepare(const Parameters& p, const ContactScale& s, double* c)
    {
        const double K = loadingStiffness(p, s.pair, s.R);
        c[0] = K;
        c[1] = pullOff(p, s.pair, s.R);
        c[2] = p.buildUp;
        c[3] = p.slope*s.pair.E*shearFactor(p);
        c[4] = p.ratio*K;
        c[5] = 2*s.R;
        c[6] = 2*p.dampingRatio*std::sqrt(s.m*K);
    }

    //- Loading with K_R (1 - c_f) against F_c0 is the farthest that it can come
    static ElasticBound bound
    (
        const Parameters& p, const ContactScale& s, double overlap, double speed,
        const double* history
    )
    {
        const double K = loadingStiffness(p, s.pair, s.R);
        const double loading = (1 - p.buildUp)*K;
        const double middle = pullOff(p, s.pair, s.R)/loading;
        const double off = std::max(overlap, 0.0) - middle;
        const double reached =
            middle + std::sqrt(off*off + s.m*speed*speed/loading);
        const double most = std::max(reached, history[0]);
        // a floor for contacts that are neither adhesive nor in motion
        const double a = std::max(std::sqrt(2*s.R*most), 1e-6*s.R);
        return
        {
            a,
            std::max(p.ratio*K, p.slope*s.pair.E*shearFactor(p)*a),
            p.buildUp*K*most
        };
    }

    //- Without attraction
    static Impact impact(const Parameters& p, const ContactScale& s, double speed)
    {
        const double K = loadingStiffness(p, s.pair, s.R);
        const double overlap = speed*std::sqrt(s.m/K);
        const double a = std::sqrt(2*s.R*overlap);
        const double K2 = std::max(p.ratio*K, p.slope*s.pair.E*shearFactor(p)*a);
        // two quarters of a period, and the flattened part after the spring-back
        const double quarters = 0.5*M_PI*(std::sqrt(s.m/K) + std::sqrt(s.m/K2));
        const double flat = std::sqrt(s.m/K)*(1 - K/K2)*std::sqrt(K2/K);
        return {overlap, speed > 0 ? quarters + flat : 0};
    }

    //- h[0] is delta_max [m]
    template<class Real>
    [[gnu::always_inline]] static NormalResponse<Real> evaluate
    (
        const Real* c, const Real& overlap, Real* h
    )
    {
        const Real d = maximum(overlap, Real(0));
        const Real before = h[0];
        h[0] = maximum(before, d);
        const Real a = squareRoot(c[5]*h[0]);
        const Real unloading = maximum(c[4], c[3]*a);
        const Real most = c[0]*h[0];
        const Real repulsion = maximum(most - unloading*(h[0] - d), Real(0));
        const Real pullOff = c[1] + c[2]*most;
        return
        {
            repulsion - pullOff, c[6], a, Real(0), overlap,
            pullOff, c[1] + c[2]*c[0]*before,
            squareRoot(before/maximum(h[0], Real(1e-290)))
        };
    }

    //- Unloading gives back F_R^2/(2 K_2) and costs F_c delta
    static NormalEnergy energy(const double* c, double overlap, const double* h)
    {
        const double d = std::max(overlap, 0.0);
        const double unloading = std::max(c[4], c[3]*std::sqrt(c[5]*h[0]));
        const double most = c[0]*h[0];
        const double repulsion = std::max(most - unloading*(h[0] - d), 0.0);
        return
        {
            0.5*repulsion*repulsion/unloading - (c[1] + c[2]*most)*d,
            0.5*most*h[0]*(1 - c[0]/unloading + c[2])
        };
    }
};

}
}
