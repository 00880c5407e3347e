// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed-form flight against the exact solution in quadruple precision, and the box around it.
#include "scene.hpp"
#include "timeIntegration/freeFlight.hpp"

using scene::close;
using scene::near;
using dem::Vec3;

namespace
{

//- phi_k(z) = sum over n of (-z)^n/(n + k)!, by series with halving in long double
struct Exact { long double e, p1, p2; };

Exact exact(long double s, long double h)
{
    const long double z = s*h;
    if (z > 1)
    {
        const long double e = std::exp(-z);
        const long double p1 = h*(1 - e)/z;
        return {e, p1, (h - p1)/s};
    }
    long double e = 0, f1 = 0, f2 = 0, term = 1;
    for (int n = 0; n < 40; ++n)
    {
        e += term;
        f1 += term/(n + 1);
        f2 += term/((n + 1.0L)*(n + 2));
        term *= -z/(n + 1);
    }
    return {e, h*f1, h*h*f2};
}

}


TEST(freeFlight, factorsForEveryRelaxationTime)
{
    // tau/h from 1e-8 to 1e8, and no drag at all
    const double h = 1e-4;
    double worst = 0;
    for (double decade = -8; decade <= 8; decade += 0.01)
    {
        const double s = std::pow(10.0, -decade)/h;
        const dem::FlightFactors f(s, h);
        const Exact x = exact(s, h);
        worst = std::max(worst, std::fabs(f.e - double(x.e)));
        worst = std::max(worst, std::fabs(f.p1/double(x.p1) - 1));
        worst = std::max(worst, std::fabs(f.p2/double(x.p2) - 1));
    }
    EXPECT_LT(worst, 2e-14);
    const dem::FlightFactors vacuum(0, h);
    EXPECT_EQ(vacuum.e, 1);
    EXPECT_EQ(vacuum.p1, h);
    EXPECT_EQ(vacuum.p2, 0.5*h*h);
}


TEST(freeFlight, motionUnderDragAndForce)
{
    // v = U + (v0 - U) e^(-t/tau), x = x0 + U t + (v0 - U) tau (1 - e^(-t/tau)),
    // U = Uc + Su/Sp; spin likewise
    dem::Particle start{1, 0, 5e-6, 5e-13, Vec3(1e-3, 2e-3, -1e-3), Vec3(1, -2, 0.5)};
    start.omega = Vec3(100, 200, -300);
    for (const double ratio : {1e-6, 1e-3, 0.03, 1.0, 40.0, 1e3, 1e6})
    {
        SCOPED_TRACE("tau/h = " + scene::text(ratio));
        const double h = 1e-4, tau = ratio*h;
        dem::GasLoad g;
        g.Sp = start.mass/tau;
        g.Uc = Vec3(0.3, 0.1, -1);
        g.Su = g.Sp*Vec3(0.1, -0.05, 0.2);
        const double inertia = 0.4*start.mass*start.radius*start.radius;
        g.SpOmega = inertia/tau;
        g.omegaC = Vec3(-50, 20, 10);

        dem::Particle p = start;
        const Vec3 impulse = dem::fly(p, g, h);

        const long double k = 1/static_cast<long double>(ratio);
        const double e = double(std::exp(-k)), oneMinus = double(-std::expm1(-k));
        const Vec3 U = g.Uc + g.Su/g.Sp;
        const Vec3 v = U + (start.v - U)*e;
        EXPECT_TRUE(near(p.v, v, 1e-14*3));
        const Exact f = exact(k, 1);
        const Vec3 dx = h*(start.v*double(f.p1) + double(k*f.p2)*U);
        EXPECT_TRUE(near(p.x - start.x, dx, 1e-12*h));
        EXPECT_TRUE(near(p.omega, g.omegaC + (start.omega - g.omegaC)*e, 1e-11));
        EXPECT_TRUE
        (
            near(impulse, -start.mass*oneMinus*(start.v - U), 1e-13*start.mass*3)
        );
    }

    // without gas and force: straight on, spin kept
    dem::Particle p = start;
    EXPECT_EQ(dem::fly(p, {}, 1e-3), Vec3::Zero());
    EXPECT_TRUE(near(p.x, start.x + 1e-3*start.v, 1e-18));
    EXPECT_EQ(p.v, start.v);
    EXPECT_EQ(p.omega, start.omega);
    // gravity alone: a parabola
    dem::GasLoad weight;
    weight.Su = Vec3(0, 0, -9.81*start.mass);
    p = start;
    dem::fly(p, weight, 2.0);
    EXPECT_TRUE(near(p.x, start.x + 2*start.v + Vec3(0, 0, -0.5*9.81*4), 1e-13));
    EXPECT_TRUE(near(p.v, start.v + Vec3(0, 0, -9.81*2), 1e-13));
}


TEST(freeFlight, twoHalvesMakeOneWhole)
{
    scene::Random random(11);
    for (int k = 0; k < 200; ++k)
    {
        const double h = 1e-3;
        dem::Particle p{1, 0, 1e-6, 1e-15, Vec3::Zero(), random.inBox(1), random.inBox(1e3)};
        dem::GasLoad g;
        g.Sp = p.mass/h*random.logUniform(1e-6, 1e6);
        g.Uc = random.inBox(1);
        g.Su = random.inBox(1e-11);
        dem::Particle q = p;
        const Vec3 whole = dem::fly(p, g, h);
        const Vec3 halves = dem::fly(q, g, 0.3*h) + dem::fly(q, g, 0.7*h);
        const double scale = (p.v.norm() + 1 + g.Su.norm()/g.Sp);
        EXPECT_TRUE(near(p.x, q.x, 1e-13*scale*h));
        EXPECT_TRUE(near(p.v, q.v, 1e-13*scale));
        EXPECT_TRUE(near(whole, halves, 1e-13*scale*p.mass));
    }
}


TEST(freeFlight, boxHoldsThePath)
{
    scene::Random random(12);
    int turned = 0;
    for (int k = 0; k < 2000; ++k)
    {
        const double h = 1e-3;
        dem::Particle p{1, 0, 1e-6, 1e-15, random.inBox(1e-3), random.inBox(1)};
        dem::GasLoad g;
        g.Sp = k%4 ? p.mass/h*random.logUniform(1e-4, 1e4) : 0;
        g.Uc = random.inBox(1);
        g.Su = k%3 ? Vec3(random.inBox(2*p.mass/h)) : Vec3(Vec3::Zero());
        Vec3 low, high;
        dem::flightBox(p, g, h, low, high);
        Vec3 sampledLow = p.x, sampledHigh = p.x;
        for (int step = 1; step <= 400; ++step)
        {
            dem::Particle q = p;
            dem::fly(q, g, h*step/400);
            sampledLow = sampledLow.cwiseMin(q.x);
            sampledHigh = sampledHigh.cwiseMax(q.x);
        }
        const double slack = 1e-12*h;
        ASSERT_TRUE((low.array() <= sampledLow.array() + slack).all());
        ASSERT_TRUE((high.array() >= sampledHigh.array() - slack).all());
        // and is no larger than the path, but for what falls between two samples
        const double path = (high - low).maxCoeff();
        ASSERT_LT((sampledLow - low).maxCoeff(), 0.02*path + slack);
        ASSERT_LT((high - sampledHigh).maxCoeff(), 0.02*path + slack);
        dem::Particle end = p;
        dem::fly(end, g, h);
        for (int d = 0; d < 3; ++d) turned += p.v[d]*end.v[d] < 0;
    }
    EXPECT_GT(turned, 200);
}
