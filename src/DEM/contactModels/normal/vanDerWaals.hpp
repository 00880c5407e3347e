// SPDX-License-Identifier: GPL-3.0-or-later
//
// van der Waals: attraction that begins before contact, and Hertz in contact.
//
//     F_N = -A_H R/(6 z^2)                  gap z = -delta, from `range` down to z0
//     F_N = -A_H R/(6 z0^2)                 z0 > z > 0
//     F_N = (4/3) E R^(1/2) delta^(3/2) - A_H R/(6 z0^2)     in contact, a = (R delta)^(1/2)
//     energy: minus the integral of F_N from `range` on
//
// z0 [m] is the cut-off distance of the Hamaker force. Its constant A_H [J] is not a keyword
// but follows from the surface energy gamma [J/m2] of the pair,
//     A_H = 24 pi gamma z0^2,  so that the pull-off force is F_C = 4 pi R gamma as for DMT;
// who has A_H gives surfaceEnergy A_H/(24 pi z0^2). Energy to part: about 2 F_C z0.
// Begins and ends at the gap `range` [m], where the force is (z0/range)^2 F_C. Damping,
// sliding and rolling act in contact only, as for DMT.
// A reduced stiffness stretches z0 and range by gamma/gamma_mod = chi^(-2/5), as all overlaps
// grow: rebound and sticking speed are then unchanged exactly.
// Source: Hamaker 1937; Israelachvili, Intermolecular and Surface Forces, eq. 17.7.
// Valid: Tabor number below about 0.1; range >> z0 (0.165 to 0.4 nm).
// Keyword: normal { model vanDerWaals; restitution 0.86; cutOff 4e-10; range 1e-8; }
// Proof: tests/unit/DEM/vanDerWaals.cpp, tests/verification/vanDerWaals
#pragma once

#include "contactModels/normal/DMT.hpp"
#include "particles/errors.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{
namespace normal
{

struct vanDerWaals
{
    static constexpr const char* model = "vanDerWaals";
    static constexpr bool elastic = true;
    static constexpr bool atDistance = true;
    static constexpr TaborRange tabor = DMT::tabor;
    static constexpr double slidingShare = DMT::slidingShare;
    static constexpr int nConstants = DMT::nConstants + 2;
    static constexpr int nHistory = 0;

    static std::vector<PartKeyword> keywords()
    {
        std::vector<PartKeyword> all = PartInput::dashpot();
        all.push_back
        ({
            "cutOff", "m", "", 1e-12, 1e-3, {},
            "smallest gap, where the attraction is largest"
        });
        all.push_back
        ({
            "range", "m", "", 1e-12, 1e-3, {},
            "gap beyond which nothing attracts, above cutOff"
        });
        return all;
    }

    struct Parameters
    {
        Hertz::Parameters hertz;
        double cutOff;          // z0 [m], before stretching
        double range;           // [m], before stretching
    };

    static Parameters read(const PartInput& input)
    {
        const Parameters p
        {
            Hertz::read(input),
            input.get("cutOff"),
            input.get("range")
        };
        if (!(p.range > p.cutOff))
        {
            throw inputError
            (
                "normal/range", "is not above the cutOff", "a distance beyond the cutOff [m]"
            );
        }
        return p;
    }

    //- How much longer than real distances are [-]
    static double stretch(const PairConstants& c)
    {
        return c.gamma > 0 ? c.realGamma/c.gamma : 1;
    }

    //- Of the sphere on a plane that stands for an elliptic contact [m]
    static double effectiveRadius(const ellipticContact::Shape& s)
    {
        return s.R;
    }
    static double pullOff(const Parameters& p, const PairConstants& c, double R)
    {
        return DMT::pullOff(p.hertz, c, R);
    }
    static double touchDistance(const Parameters& p, const PairConstants& c)
    {
        return p.range*stretch(c);
    }
    static double reach(const Parameters& p, const PairConstants& c, double)
    {
        return touchDistance(p, c);
    }
    static double equilibriumRadius(const Parameters& p, const PairConstants& c, double R)
    {
        return DMT::equilibriumRadius(p.hertz, c, R);
    }
    static double loadingStiffness(const Parameters& p, const PairConstants& c, double R)
    {
        return DMT::loadingStiffness(p.hertz, c, R);
    }
    static double tangentialDampingRatio(const PairConstants& c)
    {
        return DMT::tangentialDampingRatio(c);
    }

    static void prepare(const Parameters& p, const ContactScale& s, double* c)
    {
        DMT::prepare(p.hertz, s, c);
        c[6] = p.cutOff*stretch(s.pair);
        c[7] = touchDistance(p, s.pair);
    }

    //- The attraction falls off with the slope 2 F_C/z0, and a fast particle must not step
    //  across the distance over which it changes, nor must it until the next look
    static ElasticBound bound
    (
        const Parameters& p, const ContactScale& s, double overlap, double speed,
        const double* history
    )
    {
        ElasticBound b = DMT::bound(p.hertz, s, overlap, speed, history);
        const double z0 = p.cutOff*stretch(s.pair);
        const double near = std::max(z0, 0.5*std::fabs(overlap));
        b.stiffness = std::max
        (
            b.stiffness + 2*pullOff(p, s.pair, s.R)/z0, s.m*speed*speed/(near*near)
        );
        return b;
    }

    template<class Real>
    [[gnu::always_inline]] static NormalResponse<Real> evaluate
    (
        const Real* c, const Real& overlap, Real* h
    )
    {
        NormalResponse<Real> r = DMT::evaluate(c, overlap, h);
        const Real q = c[6]/maximum(c[6], -overlap);
        r.elastic = r.elastic + (Real(1) - q*q)*c[3];
        r.remaining = overlap + c[7];
        return r;
    }

    static NormalEnergy energy(const double* c, double overlap, const double* h)
    {
        const double z0 = c[6], z = std::max(z0, -overlap);
        return
        {
            Hertz::energy(c, overlap, h).stored
          - c[3]*(z0*z0*(1/z - 1/c[7]) + std::max(z0 + overlap, 0.0))
        };
    }
};

}
}
