// SPDX-License-Identifier: GPL-3.0-or-later
//
// JKR: adhesive spheres with a neck.
//
//     delta = (a0^2/R)(A^2 - (2/3) A^(1/2)),   F_N = 4 F_C (A^3 - A^(3/2)),   A = a/a0
//     a0 = (9 pi gamma R^2/E)^(1/3),           F_C = 3 pi R gamma
//     energy 4 F_C (a0^2/R) ((2/5) A^5 - (2/3) A^(7/2) + (1/6) A^2 + (1/10) (2/3)^(4/3))
//     eta_N = alpha (m k_N)^(1/2), k_N = (4/3) E a;   eta_T = eta_N
//
// Contact starts at delta = 0 (F_N = -(8/9) F_C), necks, and ends at
// delta = -delta_C = -a0^2/(2 6^(1/3) R); to form again delta must exceed 0. Holds F_C
// under load control. gamma [J/m2] is the energy of one surface (W = 2 gamma).
// alpha = 5^(1/2) |ln e|/(ln^2 e + pi^2)^(1/2) from the restitution e that the pair would
// have without adhesion (exact), or alpha itself by dampingCoefficient.
// Source: Chen, Liu & Li 2019, eq. 1a, 5, 6.
// Valid: Tabor number above about 3. gamma = 0 is Hertz (chosen automatically).
// Keyword: normal { model JKR; restitution 0.86; }  or  { model JKR; dampingCoefficient 0.1; }
// Proof: tests/unit/DEM/contactLaws.cpp, tests/verification/DEM/jkrCollision.cpp
#pragma once

#include "contactModels/contactModel/ContactEnergy.hpp"
#include "contactModels/contactModel/ContactScale.hpp"
#include "contactModels/contactModel/NormalResponse.hpp"
#include "contactModels/contactModel/PartInput.hpp"
#include "contactModels/normal/ellipticContact.hpp"
#include "contactModels/normal/jkrCurve.hpp"
#include "timeIntegration/contactPeriod.hpp"

namespace dem
{
namespace normal
{

struct JKR
{
    static constexpr const char* model = "JKR";
    static constexpr bool elastic = true;
    static constexpr bool atDistance = false;
    static constexpr TaborRange tabor = {3, 1e300};
    static constexpr double slidingShare = 2;      // of F_C, in the sliding limit
    static constexpr int nConstants = 5;
    static constexpr int nHistory = 0;

    static std::vector<PartKeyword> keywords()
    {
        return PartInput::dashpot();
    }

    struct Parameters { double alpha; };

    static Parameters read(const PartInput& input)
    {
        return {std::sqrt(5.0)*input.dampingRatio()};
    }

    //- Of the sphere on a plane that stands for an elliptic contact [m]
    static double effectiveRadius(const ellipticContact::Shape& s)
    {
        return s.R*ellipticContact::pullOffFactor(s.y);
    }
    static double pullOff(const Parameters&, const PairConstants& c, double R)
    {
        return 3*M_PI*R*c.gamma;
    }
    static double equilibriumRadius(const Parameters&, const PairConstants& c, double R)
    {
        return std::cbrt(9*M_PI*c.gamma*R*R/c.E);
    }
    //- dF_N/d(delta) at A = 1 [N/m]
    static double loadingStiffness(const Parameters& p, const PairConstants& c, double R)
    {
        return 1.2*c.E*equilibriumRadius(p, c, R);
    }
    //- delta_C [m]
    static double reach(const Parameters& p, const PairConstants& c, double R)
    {
        const double a0 = equilibriumRadius(p, c, R);
        return jkrCurve::neck*a0*a0/R;
    }
    static double tangentialDampingRatio(const PairConstants&) { return 1; }

    static void prepare(const Parameters& p, const ContactScale& s, double* c)
    {
        const double a0 = equilibriumRadius(p, s.pair, s.R);
        c[0] = s.R/(a0*a0);
        c[1] = 4*pullOff(p, s.pair, s.R);
        c[2] = a0;
        c[3] = p.alpha*std::sqrt(s.m*4.0/3.0*s.pair.E*a0);
        c[4] = s.pair.strengthFactor()/4;
    }

    static double touchDistance(const Parameters&, const PairConstants&) { return 0; }
    static ElasticBound bound
    (
        const Parameters& p, const ContactScale& s, double overlap, double speed, const double*
    )
    {
        return hertzianBound
        (
            s, equilibriumRadius(p, s.pair, s.R), overlap, speed
        );
    }

    template<class Real>
    [[gnu::always_inline]] static NormalResponse<Real> evaluate(const Real* c, const Real& overlap, Real*)
    {
        const Real q = overlap*c[0] + Real(jkrCurve::neck);
        const Real s = jkrCurve::rootOf(q);
        const Real s3 = s*s*s;
        return {c[1]*(s3*s3 - s3), c[3]*s, c[2]*s*s, s3, q, c[1]*c[4]};
    }

    static NormalEnergy energy(const double* c, double overlap, const double*)
    {
        const double s = jkrCurve::rootOf(overlap*c[0] + jkrCurve::neck);
        return {c[1]/c[0]*jkrCurve::energy(s)};
    }
};

}
}
