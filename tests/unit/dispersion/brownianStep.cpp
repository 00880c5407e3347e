// SPDX-License-Identifier: GPL-3.0-or-later
//
// Place and velocity that Brownian motion adds in one step have the joint distribution of the
// Ornstein-Uhlenbeck process, for any step; the long-time diffusivity is kT/Sp.
#include "brownianStep.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const double m = 3e-19, Sp = 2e-12, kT = 4e-21, tau = m/Sp;

struct increments
{
    vector x, v;
};

// The flight with a constant force from rest, and the kick
increments step(unsigned id, unsigned k, double h)
{
    const brownianStep noise(kT, {{id, 0, k, 0}});
    const vector b(noise.force(m, Sp, h)/m);
    const double z = h/tau, p1 = -tau*std::expm1(-z);
    const double p2 = z < 1e-3 ? h*h*(0.5 - z/6 + z*z/24) : tau*(h - p1);
    return {p2*b, p1*b + noise.kick(m, Sp, h)};
}

}

// Chandrasekhar 1943
TEST(brownianStep, jointDistribution)
{
    const int n = 200000;
    for (const double z : {1e-4, 0.02, 0.09, 0.11, 1.0, 10.0, 999.0})
    {
        double xx = 0, xv = 0, vv = 0, mean = 0;
        for (unsigned i = 0; i < n; ++i)
        {
            const increments d(step(i, 1, z*tau));
            xx += (d.x & d.x)/(3.0*n);
            xv += (d.x & d.v)/(3.0*n);
            vv += (d.v & d.v)/(3.0*n);
            mean += d.x.y()/n;
        }
        const double e = std::exp(-z), r = -std::expm1(-z);
        const double f =
            z < 0.05 ? z*z*z*(2.0/3 - z/2 + 7*z*z/30 - z*z*z/12) : 2*z - 3 + 4*e - e*e;
        const double X = kT/m*tau*tau*f, V = kT/m*r*(2 - r);
        EXPECT_NEAR(xx/X, 1, 0.008) << z;
        EXPECT_NEAR(vv/V, 1, 0.008) << z;
        EXPECT_NEAR(xv/std::sqrt(X*V), kT/m*tau*r*r/std::sqrt(X*V), 0.006) << z;
        EXPECT_NEAR(mean/std::sqrt(X), 0, 0.01) << z;
    }
}

// The series and the closed forms meet
TEST(brownianStep, continuous)
{
    const double h = 0.1*tau;
    const increments a(step(5, 3, h*(1 - 1e-9))), b(step(5, 3, h*(1 + 1e-9)));
    EXPECT_NEAR(mag(a.x - b.x)/mag(a.x), 0, 1e-8);
    EXPECT_NEAR(mag(a.v - b.v)/mag(a.v), 0, 1e-8);
}

// Steps of changing length from rest: the variances at the end of ten are those of one
TEST(brownianStep, chain)
{
    const int n = 100000;
    const double h[] = {0.1, 3, 0.02, 0.5, 1, 0.3, 7, 0.1, 0.1, 0.6};
    double xx = 0, xv = 0, vv = 0, z = 0;
    for (const double part : h) z += part;
    for (unsigned i = 0; i < n; ++i)
    {
        vector x(Zero), v(Zero);
        for (unsigned k = 0; k < 10; ++k)
        {
            const increments d(step(i, k, h[k]*tau));
            x += -tau*std::expm1(-h[k])*v + d.x;
            v = std::exp(-h[k])*v + d.v;
        }
        xx += (x & x)/(3.0*n);
        xv += (x & v)/(3.0*n);
        vv += (v & v)/(3.0*n);
    }
    const double e = std::exp(-z);
    EXPECT_NEAR(xx/(kT/m*tau*tau*(2*z - 3 + 4*e - e*e)), 1, 0.011);
    EXPECT_NEAR(xv/(kT/m*tau*(1 - e)*(1 - e)), 1, 0.02);
    EXPECT_NEAR(vv/(kT/m), 1, 0.011);
}

// In contact: the impulse over h is that of the noise, 2 kT Sp h
TEST(brownianStep, meanForce)
{
    const int n = 200000;
    const double h = 20*tau;
    double sum = 0;
    for (unsigned i = 0; i < n; ++i)
    {
        const brownianStep noise(kT, {{i, 0, 1, 0}});
        sum += magSqr(h*noise.meanForce(Sp, h))/(3.0*n);
    }
    EXPECT_NEAR(sum/(2*kT*Sp*h), 1, 0.008);
}

// Steps so long that the thermal velocity is left out: diffusivity kT/Sp
TEST(brownianStep, longSteps)
{
    const int n = 50000;
    const double h = 2000*tau;
    double xx = 0;
    for (unsigned i = 0; i < n; ++i)
    {
        vector x(Zero), v(Zero);
        for (unsigned k = 0; k < 4; ++k)
        {
            const increments d(step(i, k, h));
            x += tau*v + d.x;
            v = d.v;
        }
        xx += (x & x)/(3.0*n);
    }
    EXPECT_NEAR(xx/(2*kT/Sp*4*h), 1, 0.012);
}

// No drag, no noise
TEST(brownianStep, vacuum)
{
    const brownianStep noise(kT, {{1, 0, 1, 0}});
    EXPECT_EQ(mag(noise.force(m, 0, 1)), 0);
    EXPECT_EQ(mag(noise.kick(m, 0, 1)), 0);
}
