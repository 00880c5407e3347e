// SPDX-License-Identifier: GPL-3.0-or-later
//
// The flight that is linear in the velocity and ends where the flight under a drag Sp(slip) ends:
//
//     m dw/dt = -Sp(|w|) w + F,    w = v - Uc,   over h, from w0
//
// The step is cut into sub-flights over which Sp changes little, most often one. In each, Sp solves
//
//     Sp = Sp(|w1 + g (w0 - w1)|),    w1 = e w0 + (1 - e) c,    c = F/Sp,    e = exp(-z),  z = Sp h/m
//     g = min((((1 - e^2)/(2 z))^(1/2) - e)/(1 - e),  e/(1 - e) |w1|/|c|)
//
// The first g gives the root mean square of a slip that decays to zero, and 1/2 for z = 0 (second
// order). The other one goes to zero with e^-z, such that no sub-flight of any length passes the
// terminal slip w_T as long as Sp grows with at most the first power of the slip (Stokes to Newton's
// drag): were w1 = w_T, then Sp(mean)/Sp(w_T) >= |mean|/|w_T| from below (<= from above) and c/w_T
// from w1 could both hold only for a greater g.
//
// Several sub-flights are handed over as the one linear flight with their end velocity and, along the
// change of velocity, their path. With r = (mean w - w1)/(w0 - w1), which Sp h/m = z alone decides,
//
//     r = 1/z - 1/(e^z - 1)    (1/2 for z = 0),    F' = Sp (w1 - e^-z w0)/(1 - e^-z)
//
// F' - F is the part of the drag that Sp w misses; it vanishes for constant Sp.
#pragma once

#include "timeIntegration/freeFlight.hpp"

namespace dem
{

struct MeanDrag
{
    double Sp;          // [kg/s]
    Vec3 force;         // F', body force that goes with it [N]
    int evaluations;    // of Sp(slip)
};

namespace meanDragDetail
{

//- Sub-flights are so short that Sp changes by at most this factor
constexpr double largestChange = 1.2;

//- Sp is found to this share: of the last sub-flight, of those before (whose errors decay)
constexpr double tolerance = 1e-11;
constexpr double looseTolerance = 1e-6;

inline Vec3 endSlip(const Vec3& w, const Vec3& F, double m, double h, double Sp)
{
    const FlightFactors f(Sp/m, h);
    return f.e*w + f.p1/m*F;
}

//- Slip at which a sub-flight takes its Sp
inline double meanSlip(const Vec3& w, const Vec3& F, double m, double h, double Sp)
{
    const double z = Sp*h/m;
    const FlightFactors f(Sp/m, h);
    const Vec3 end = f.e*w + f.p1/m*F;
    const double rest = -std::expm1(-z);    // 1 - e
    // its series: the closed form would lose digits
    const double decay = z < 1e-3 ? 0.5 - z/24 : (std::sqrt(rest*(1 + f.e)/(2*z)) - f.e)/rest;
    const double limit = Sp*f.e*end.norm(), forced = rest*F.norm();
    const double g = decay*forced <= limit ? decay : limit/forced;
    return (end + g*(w - end)).norm();
}

//- Sp = drag(mean slip), between low and high; secant, or bisection where that would leave them
template<class Drag>
double solve
(
    const Vec3& w, const Vec3& F, double m, double h,
    double low, double high, double error, const Drag& drag, int& evaluations
)
{
    if (low > high) std::swap(low, high);
    double a = 0, ga = 0;
    double b = 0.5*(low + high);
    for (int i = 0; i < 60; ++i)
    {
        const double there = drag(meanSlip(w, F, m, h, b));
        ++evaluations;
        const double gb = there - b;
        if (std::fabs(gb) <= error*b) return there;
        (gb > 0 ? low : high) = b;
        // the first time by substitution: the slope is small
        double next = i == 0 || ga == gb ? there : b - gb*(b - a)/(gb - ga);
        if (!(next >= low && next <= high)) next = 0.5*(low + high);
        a = b;
        ga = gb;
        b = next;
    }
    return b;
}

//- z > 0 with 1/z - 1/(e^z - 1) = r, 0 < r < 1/2. Newton from below: the function is convex.
inline double exponentOf(double r)
{
    double z = 1/r - 2;
    for (int i = 0; i < 50; ++i)
    {
        double value, slope;
        if (z < 0.05)
        {
            value = 0.5 - z/12 + z*z*z/720;
            slope = -1.0/12 + z*z/240;
        }
        else
        {
            // e^z overflows, and long since adds nothing
            const double g = z < 700 ? 1/std::expm1(z) : 0;
            value = 1/z - g;
            slope = -1/(z*z) + g*(1 + g);
        }
        const double dz = (r - value)/slope;
        z += dz;
        if (std::fabs(dz) <= 1e-13*z) break;
    }
    return z;
}

}


//- w: slip v - Uc at the start, F: all forces but the drag, Sp0 = drag(|w|)
template<class Drag>
MeanDrag meanDrag
(
    const Vec3& w0, const Vec3& F, double m, double h, double Sp0, const Drag& drag
)
{
    using namespace meanDragDetail;

    MeanDrag result{Sp0, F, 0};
    Vec3 w = w0;
    Vec3 path = Vec3::Zero();
    double Sp = Sp0;
    double z = 0;
    double left = h;
    double step = h;

    while (left > 0)
    {
        // As long as Sp hardly changes
        double end = Sp;
        for (int i = 0; i < 60; ++i)
        {
            end = drag(endSlip(w, F, m, step, Sp).norm());
            ++result.evaluations;
            if (std::max(Sp, end) <= largestChange*std::min(Sp, end)) break;
            step = std::min(0.5*step, m/std::max(Sp, end));
        }
        if (end != Sp)
        {
            const double margin = std::fabs(end - Sp);
            Sp = solve
            (
                w, F, m, step,
                std::max(0.0, std::min(Sp, end) - margin), std::max(Sp, end) + margin,
                step < left ? looseTolerance : tolerance, drag, result.evaluations
            );
        }
        if (step == h)
        {
            result.Sp = Sp;
            return result;
        }

        const FlightFactors f(Sp/m, step);
        path += f.p1*w + f.p2/m*F;
        w = f.e*w + f.p1/m*F;
        z += Sp*step/m;
        left -= step;
        if (left > 0)
        {
            Sp = drag(w.norm());
            ++result.evaluations;
            step = std::min(2*step, left);
        }
    }

    const Vec3 change = w0 - w;
    const double r = (path/h - w).dot(change)/change.squaredNorm();
    if (r > 1e-9 && r < 0.5 - 1e-9) z = exponentOf(r);
    result.Sp = z*m/h;
    result.force = result.Sp/-std::expm1(-z)*(w - std::exp(-z)*w0);
    return result;
}

}
