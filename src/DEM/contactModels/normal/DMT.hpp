// SPDX-License-Identifier: GPL-3.0-or-later
//
// DMT: Hertz with a constant attraction, for small stiff particles (Tabor number < 0.1).
//
//     F_N = (4/3) E R^(1/2) delta^(3/2) - 4 pi R gamma,    a = (R delta)^(1/2)
//     energy (8/15) E R^(1/2) delta^(5/2) - 4 pi R gamma delta
//
// Starts and ends at delta = 0; pull-off force 4 pi R gamma (W = 2 gamma). Damping as Hertz.
// Rolling grows with (a/a0)^(3/2), a0^3 = 3 pi gamma R^2/E the equilibrium radius.
// Sliding limit mu (F_N + 4 pi R gamma): Coulomb's law on the Hertzian pressure.
// Source: Derjaguin, Muller & Toporov 1975.
// Keyword: normal { model DMT; restitution 0.86; }
// Proof: tests/unit/DEM/contactLaws.cpp
#pragma once

#include "contactModels/normal/Hertz.hpp"

namespace dem
{
namespace normal
{

struct DMT
{
    static constexpr const char* model = "DMT";
    static constexpr bool elastic = true;
    static constexpr bool atDistance = false;
    static constexpr TaborRange tabor = {0, 0.1};
    static constexpr double slidingShare = 1;      // of F_C, in the sliding limit
    static constexpr int nConstants = Hertz::nConstants + 3;
    static constexpr int nHistory = 0;

    static std::vector<PartKeyword> keywords() { return Hertz::keywords(); }

    using Parameters = Hertz::Parameters;
    static Parameters read(const PartInput& input) { return Hertz::read(input); }

    //- Of the sphere on a plane that stands for an elliptic contact [m]
    static double effectiveRadius(const ellipticContact::Shape& s)
    {
        return s.R;
    }
    static double pullOff(const Parameters&, const PairConstants& c, double R)
    {
        return 4*M_PI*R*c.gamma;
    }
    static double reach(const Parameters&, const PairConstants&, double) { return 0; }
    static double equilibriumRadius(const Parameters&, const PairConstants& c, double R)
    {
        return std::cbrt(3*M_PI*c.gamma*R*R/c.E);
    }
    //- dF_N/d(delta) at equilibrium [N/m]
    static double loadingStiffness(const Parameters& p, const PairConstants& c, double R)
    {
        return 2*c.E*equilibriumRadius(p, c, R);
    }
    static double tangentialDampingRatio(const PairConstants& p)
    {
        return Hertz::tangentialDampingRatio(p);
    }

    static void prepare(const Parameters& p, const ContactScale& s, double* c)
    {
        Hertz::prepare(p, s, c);
        c[3] = pullOff(p, s.pair, s.R);
        c[4] = 1/equilibriumRadius(p, s.pair, s.R);
        c[5] = s.pair.strengthFactor();
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
    [[gnu::always_inline]] static NormalResponse<Real> evaluate(const Real* c, const Real& overlap, Real* h)
    {
        NormalResponse<Real> r = Hertz::evaluate(c, overlap, h);
        const Real A = r.radius*c[4];
        r.elastic = r.elastic - c[3];
        r.strength = A*squareRoot(A);
        r.pullOff = c[3]*c[5];
        return r;
    }

    static NormalEnergy energy(const double* c, double overlap, const double* h)
    {
        return {Hertz::energy(c, overlap, h).stored - c[3]*std::max(overlap, 0.0)};
    }
};

}
}
