// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simplified JKR: the JKR force, but contact starts AND ends at delta = 0.
//
//     F_N and energy as JKR for delta >= 0;  holds at most (8/9) F_C
//     eta_N = 2 (5/6)^(1/2) beta (S_n m)^(1/2),  S_n = 2 E (R delta)^(1/2)
//     sliding: S_t = 8 G (R delta)^(1/2), eta_T = 2 (5/6)^(1/2) beta (S_t m)^(1/2)
//
// Undamped it never sticks: not interchangeable with JKR.
// Source: Haervig et al. 2017, eq. 5-13, 16.
// Keyword: normal { model simplifiedJKR; restitution 0.86; }
// Proof: tests/unit/DEM/contactLaws.cpp, tests/verification/DEM/pslRebound.cpp
#pragma once

#include "contactModels/normal/Hertz.hpp"
#include "contactModels/normal/JKR.hpp"

namespace dem
{
namespace normal
{

struct simplifiedJKR
{
    static constexpr const char* model = "simplifiedJKR";
    static constexpr bool elastic = true;
    static constexpr bool atDistance = false;
    static constexpr TaborRange tabor = JKR::tabor;
    static constexpr double slidingShare = JKR::slidingShare;
    static constexpr int nConstants = 5;
    static constexpr int nHistory = 0;

    static std::vector<PartKeyword> keywords() { return Hertz::keywords(); }

    using Parameters = Hertz::Parameters;
    static Parameters read(const PartInput& input) { return Hertz::read(input); }

    static double effectiveRadius(const ellipticContact::Shape& s)
    {
        return JKR::effectiveRadius(s);
    }
    static double pullOff(const Parameters&, const PairConstants& c, double R)
    {
        return JKR::pullOff({}, c, R);
    }
    static double reach(const Parameters&, const PairConstants&, double) { return 0; }
    static double equilibriumRadius(const Parameters&, const PairConstants& c, double R)
    {
        return JKR::equilibriumRadius({}, c, R);
    }
    static double loadingStiffness(const Parameters&, const PairConstants& c, double R)
    {
        return JKR::loadingStiffness({}, c, R);
    }
    static double tangentialDampingRatio(const PairConstants& p)
    {
        return Hertz::tangentialDampingRatio(p);
    }

    static void prepare(const Parameters& p, const ContactScale& s, double* c)
    {
        const double a0 = equilibriumRadius(p, s.pair, s.R);
        c[0] = s.R/(a0*a0);
        c[1] = 4*pullOff(p, s.pair, s.R);
        c[2] = s.R;
        c[3] = 2*std::sqrt(5.0/6.0)*p.beta*std::sqrt(2*s.pair.E*s.m);
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
        const Real d = maximum(overlap, Real(0));
        const Real s = jkrCurve::rootOf(d*c[0] + Real(jkrCurve::neck));
        const Real s3 = s*s*s;
        const Real a = squareRoot(c[2]*d);
        return {c[1]*(s3*s3 - s3), c[3]*squareRoot(a), a, s3, overlap, c[1]*c[4]};
    }

    static NormalEnergy energy(const double* c, double overlap, const double* h)
    {
        return JKR::energy(c, std::max(overlap, 0.0), h);
    }
};

}
}
