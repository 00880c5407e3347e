// SPDX-License-Identifier: GPL-3.0-or-later
//
// Variance and diffusivity in homogeneous turbulence for any step; tracers that are evenly
// spread in a channel stay so.
#include "langevinStep.H"

#include <gtest/gtest.h>

#include <cfenv>
#include <vector>

using namespace Foam;

// Taylor 1921: <x^2> = 2 s^2 T^2 (t/T - 1 + exp(-t/T)) from the start on, for any step
TEST(langevinStep, homogeneous)
{
    turbulenceSeen gas;
    gas.s = 0.7;
    gas.TFar = 0.05;

    for (const double theta : {0.01, 0.1, 0.5, 1.0, 3.0, 10.0})
    {
        const double dt = theta*gas.TFar, s2 = gas.s*gas.s;
        const int n = 40000, steps = theta < 0.05 ? 200 : 20;
        double variance = 0, square = 0, lag = 0;
        for (unsigned i = 0; i < unsigned(n); ++i)
        {
            vector w, x(Zero), first;
            langevinStep::start({{i, 0, 0, 0}}, w);
            first = w;
            for (unsigned k = 1; k <= unsigned(steps); ++k)
            {
                const vector u = langevinStep::advance
                    (gas, {{i, 0, k, 0}}, x, Zero, Zero, 0, dt, w);
                x += u*dt;
                if (k == 1)
                {
                    lag += (first & w)/(3.0*n);
                }
            }
            variance += magSqr(gas.s*w)/(3.0*n);
            square += magSqr(x)/(3.0*n);
        }
        const double t = steps*theta;
        const double exact = 2*s2*gas.TFar*gas.TFar*(t - 1 + std::exp(-t));
        EXPECT_NEAR(variance/s2, 1, 0.02) << theta;
        EXPECT_NEAR(square/exact, 1, 0.02) << theta;
        EXPECT_NEAR(lag, std::exp(-theta), 0.015) << theta;
    }
}

// A step and its two halves have the same joint distribution of end and mean
TEST(langevinStep, covariances)
{
    turbulenceSeen gas;
    gas.s = 1;
    gas.TFar = 1;
    for (const double theta : {0.05, 0.2, 4.0})
    {
        double mm = 0, me = 0;
        const int n = 200000;
        for (unsigned i = 0; i < unsigned(n); ++i)
        {
            vector w(Zero);
            const vector u = langevinStep::advance
                (gas, {{i, 0, 0, 0}}, Zero, Zero, Zero, 0, theta, w);
            mm += magSqr(u)*theta*theta/(3.0*n);
            me += (u & w)*theta/(3.0*n);
        }
        const double e = std::exp(-theta);
        EXPECT_NEAR(mm/(2*theta - 3 + 4*e - e*e), 1, 0.01) << theta;
        EXPECT_NEAR(me/((1 - e)*(1 - e)), 1, 0.01) << theta;
    }
}

// Steps of any length: where there is no turbulence, or its gradients or the wall would have it
// divided without end. Floating-point traps are on, as in OpenFOAM
TEST(langevinStep, anyLength)
{
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
    turbulenceSeen still;
    still.s = 0;
    still.TFar = 1e-150;

    turbulenceSeen jet;
    jet.s = 1;
    jet.gradS = vector(3, -2, 1e3);
    jet.TFar = 1e-3;
    jet.reach = 1e-3;

    turbulenceSeen wall = jet;
    wall.n = vector(0, 1, 0);
    wall.along = vector(1, 0, 0);
    wall.y = 1e-4;
    wall.uTau = 10;
    wall.nu = 1.5e-5;

    for (const turbulenceSeen& gas : {still, jet, wall})
    {
        for (const double dt : {1e-9, 1e-3, 1.0, 5e7, 1e15})
        {
            for (const double tau : {0.0, 1e-5, 1e300})
            {
                vector w;
                langevinStep::start({{7, 0, 0, 0}}, w);
                const vector u = langevinStep::advance
                    (gas, {{7, 0, 1, 0}}, Zero, Zero, vector(1, -0.1, 0), tau, dt, w);
                // s where the gradient ends, or of the fits
                EXPECT_LE(mag(u), 10*(gas.s > 0 ? 10 + gas.s + mag(gas.gradS)*gas.reach : 0))
                    << dt << ' ' << tau;
                EXPECT_LE(mag(w), 100) << dt << ' ' << tau;
            }
        }
    }
    fedisableexcept(FE_ALL_EXCEPT);
}

// The derivatives of the fits and of the hand-over
TEST(turbulenceSeen, gradients)
{
    turbulenceSeen gas;
    gas.n = vector(0, 1, 0);
    gas.along = vector(1, 0, 0);
    gas.uTau = 0.3;
    gas.nu = 1.5e-5;
    gas.s = 0.45;
    gas.TFar = 0.02;
    gas.gradS = vector(0, -3, 0);
    const double unit = gas.nu/gas.uTau;

    for (const bool sheared : {false, true})
    for (const double yPlus : {0.3, 3.0, 12.0, 60.0, 99.0, 110.0, 150.0, 190.0, 250.0})
    {
        if (sheared)
        {
            gas.A = turbulenceSeen::sheared(vector(4, 0, 0), vector(0, 50, 0));
            gas.g = 0.7;
            gas.gradG = vector(0, 15, 0);
        }
        const double h = 1e-4*yPlus*unit;
        const auto at = [&](double y) { return gas.at(point(0, y, 0)); };
        const double y = yPlus*unit;
        const double divS = (at(y + h).S.yy() - at(y - h).S.yy())/(2*h);
        const double gradT = (at(y + h).T - at(y - h).T)/(2*h);
        EXPECT_NEAR(at(y).divS.y()/divS, 1, 1e-5) << yPlus;
        EXPECT_NEAR(at(y).gradT.y(), gradT, 1e-5*std::abs(gradT) + 1e-9) << yPlus;
    }
    for (const double edge : {100.0, 200.0})
    {
        const auto below = gas.at(point(0, (edge - 1e-7)*unit, 0));
        const auto above = gas.at(point(0, (edge + 1e-7)*unit, 0));
        EXPECT_NEAR(mag(below.S - above.S)/mag(above.S), 0, 1e-6);
        EXPECT_NEAR(below.T/above.T, 1, 1e-6);
    }
}

// In a log layer the shares of k are those that the fits have at y+ = 100, and their sum is k
TEST(turbulenceSeen, shear)
{
    turbulenceSeen gas;
    gas.s = 2;
    gas.g = 1;
    gas.A = turbulenceSeen::sheared(vector(0, 0, -3), vector(7, 0, 0));
    const tensor S = gas.at(Zero).S;
    const turbulenceSeen::wallFits log(100);
    EXPECT_NEAR(S.zz()/S.xx(), log.s1/log.s2, 1e-12);
    EXPECT_NEAR(S.yy()/S.xx(), log.s3/log.s2, 1e-12);
    EXPECT_NEAR(tr(S & S), 3*sqr(gas.s), 1e-12);
    EXPECT_NEAR(S.xx()/gas.s, 0.77, 0.005);

    // k is kept in between, too, to 1.5 %
    gas.g = 0.5;
    const tensor half = gas.at(Zero).S;
    EXPECT_NEAR(tr(half & half)/(3*sqr(gas.s)), 1, 0.015);
}

namespace
{

//- Channel of half width 400 wall units between reflecting walls; returns the concentration
//  over its mean in bins of y+
std::vector<double> channel
(
    const std::vector<double>& edges, double dtPlus, double time, int n
)
{
    const double half = 400;
    turbulenceSeen gas;
    gas.n = vector(0, 1, 0);
    gas.along = vector(1, 0, 0);
    gas.uTau = 1;
    gas.nu = 1;
    gas.TFar = 45;
    std::vector<double> count(edges.size() - 1, 0.0);
    double samples = 0;

    for (unsigned i = 0; i < unsigned(n); ++i)
    {
        // Evenly spread at the start, stratified
        double y = half*(i + 0.5)/n;
        vector w;
        langevinStep::start({{i, 0, 0, 0}}, w);

        const unsigned steps = unsigned(time/dtPlus);
        for (unsigned k = 1; k <= steps; ++k)
        {
            // k falls from the log layer's value towards the middle. Not where a step
            // leads past the middle: what is seen has no bend there
            const double slope = dtPlus < 50 ? -0.6/half : 0;
            gas.origin = point(0, y, 0);
            gas.y = y;
            gas.s = 1.5 + slope*y;
            gas.gradS = vector(0, slope, 0);
            const vector u = langevinStep::advance
                (gas, {{i, 0, k, 0}}, gas.origin, Zero, Zero, 0, dtPlus, w);
            y += u.y()*dtPlus;
            if (y < 0)
            {
                y = -y;
                w.y() = -w.y();
            }
            if (y > half)
            {
                y = 2*half - y;
                w.y() = -w.y();
            }
            if (2*k > steps)
            {
                ++samples;
                for (std::size_t b = 0; b + 1 < edges.size(); ++b)
                {
                    count[b] += y >= edges[b] && y < edges[b + 1];
                }
            }
        }
    }
    for (std::size_t b = 0; b + 1 < edges.size(); ++b)
    {
        count[b] *= half/(edges[b + 1] - edges[b])/samples;
    }
    return count;
}

}

TEST(langevinStep, wellMixed)
{
    const std::vector<double> edges
    {
        0, 5, 10, 20, 30, 40, 60, 80, 100, 120, 150, 180, 200, 250, 300, 350, 400
    };
    for (const double dtPlus : {5.0, 10.0, 100.0})
    {
        const auto c = channel(edges, dtPlus, 4000, 24000);
        for (std::size_t b = 0; b < c.size(); ++b)
        {
            std::printf("dt+ %g: y+ %g to %g: %.3f\n", dtPlus, edges[b], edges[b + 1], c[b]);
            EXPECT_NEAR(c[b], 1, 0.05) << dtPlus << ' ' << edges[b];
        }
    }
}
