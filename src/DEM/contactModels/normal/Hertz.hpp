// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hertz: elastic spheres without adhesion.
//
//     F_N = (4/3) E R^(1/2) delta^(3/2),       a = (R delta)^(1/2)
//     eta_N = 2 (5/6)^(1/2) beta (S_n m)^(1/2),  S_n = 2 E (R delta)^(1/2)
//     beta = |ln e|/(ln^2 e + pi^2)^(1/2)
//     energy (2/5) F_N delta
//
// E [Pa] effective modulus, R [m], m [kg] effective radius and mass, delta [m] overlap,
// e [-] restitution, reproduced exactly at every speed.
// Source: Haervig et al. 2017, eq. 5-13 (with the square root on 5/6 that some prints lose).
// Valid: gamma = 0; delta << R.
// Keyword: normal { model Hertz; restitution 0.86; }  (or dampingCoefficient, see JKR)
// Proof: tests/unit/DEM/contactLaws.cpp, tests/verification/DEM/convergence.cpp
#pragma once

#include "contactModels/contactModel/ContactEnergy.hpp"
#include "contactModels/contactModel/ContactScale.hpp"
#include "contactModels/contactModel/NormalResponse.hpp"
#include "contactModels/contactModel/PartInput.hpp"
#include "contactModels/contactModel/Real.hpp"
#include "contactModels/normal/ellipticContact.hpp"
#include "timeIntegration/contactPeriod.hpp"

namespace dem
{
namespace normal
{

struct Hertz
{
    static constexpr const char* model = "Hertz";
    static constexpr bool elastic = true;
    static constexpr bool atDistance = false;
    static constexpr TaborRange tabor = {0, 1e300};
    static constexpr double slidingShare = 0;      // of F_C, in the sliding limit
    static constexpr int nConstants = 3;
    static constexpr int nHistory = 0;

    static std::vector<PartKeyword> keywords()
    {
        return PartInput::dashpot();
    }

    struct Parameters { double beta; };

    static Parameters read(const PartInput& input) { return {input.dampingRatio()}; }

    //- Of the sphere on a plane that stands for an elliptic contact [m]
    static double effectiveRadius(const ellipticContact::Shape& s)
    {
        return s.R*ellipticContact::stiffnessFactor(s.y);
    }
    static double pullOff(const Parameters&, const PairConstants&, double) { return 0; }
    static double reach(const Parameters&, const PairConstants&, double) { return 0; }
    static double equilibriumRadius(const Parameters&, const PairConstants&, double)
    {
        return 0;
    }
    static double loadingStiffness(const Parameters&, const PairConstants&, double)
    {
        return 0;
    }

    //- eta_T/eta_N = (S_t/S_n)^(1/2) (Haervig et al. 2017, eq. 16)
    static double tangentialDampingRatio(const PairConstants& p)
    {
        return std::sqrt(8*p.G/(2*p.E));
    }

    static void prepare(const Parameters& p, const ContactScale& s, double* c)
    {
        c[0] = s.R;
        c[1] = 4.0/3.0*s.pair.E;
        c[2] = 2*std::sqrt(5.0/6.0)*p.beta*std::sqrt(2*s.pair.E*s.m);
    }

    //- Contact begins at overlap = -touchDistance [m]
    static double touchDistance(const Parameters&, const PairConstants&) { return 0; }

    //- Radius and stiffness that the contact will have at its stiffest, for the contact step
    static ElasticBound bound
    (
        const Parameters&, const ContactScale& s, double overlap, double speed, const double*
    )
    {
        return hertzianBound(s, 0, overlap, speed);
    }

    template<class Real>
    [[gnu::always_inline]] static NormalResponse<Real> evaluate(const Real* c, const Real& overlap, Real*)
    {
        const Real d = maximum(overlap, Real(0));
        const Real a = squareRoot(c[0]*d);
        return {c[1]*a*d, c[2]*squareRoot(a), a, Real(0), overlap, Real(0)};
    }

    static NormalEnergy energy(const double* c, double overlap, const double*)
    {
        const double d = std::max(overlap, 0.0);
        return {0.4*c[1]*std::sqrt(c[0]*d)*d*d};
    }
};

}
}
