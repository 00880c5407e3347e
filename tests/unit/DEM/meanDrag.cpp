// SPDX-License-Identifier: GPL-3.0-or-later
//
// The linear flight in place of that with Schiller-Naumann's drag: stopping distance, speed on the
// way against the closed form, terminal velocity.
#include "scene.hpp"
#include "timeIntegration/meanDrag.hpp"

using dem::Vec3;

namespace
{

struct Sphere
{
    double d, m, Sp, tau;

    explicit Sphere(double diameter)
    :
        d(diameter), m(2650*M_PI/6*d*d*d), Sp(3*M_PI*1.8e-5*d), tau(m/Sp)
    {}

    double share(double slip) const { return 0.15*std::pow(1.2*slip*d/1.8e-5, 0.687); }

    double drag(double slip) const { return Sp*(1 + share(slip)); }

    //- One particle step; returns the evaluations of the drag
    int step(Vec3& x, Vec3& v, const Vec3& F, double h) const
    {
        const dem::MeanDrag mean = dem::meanDrag
        (
            v, F, m, h, drag(v.norm()), [this](double slip) { return drag(slip); }
        );
        dem::Particle p{1, 0, d/2, m, x, v};
        dem::GasLoad g;
        g.Sp = mean.Sp;
        g.Su = mean.force;
        dem::fly(p, g, h);
        x = p.x;
        v = p.v;
        return mean.evaluations;
    }

    //- v(t) without other forces: v^-n + a = (1 + a) v0^-n... with a = share per v^n
    double speed(double v0, double t) const
    {
        const double n = 0.687, a = share(1);
        return std::pow((std::pow(v0, -n) + a)*std::exp(n*t/tau) - a, -1/n);
    }

    //- Integral of m dv/Sp(v)
    double stoppingDistance(double v0) const
    {
        const int n = 200000;
        double x = 0;
        for (int i = 0; i < n; ++i) x += m*v0/n/drag(v0*(i + 0.5)/n);
        return x;
    }

    double stopped(double v0, double ratio) const
    {
        Vec3 x = Vec3::Zero(), v(0, v0, 0);
        for (int i = 0; i*ratio < 40; ++i) step(x, v, Vec3::Zero(), ratio*tau);
        return x[1];
    }
};

const std::pair<double, double> shots[] = {{20e-6, 10}, {100e-6, 10}, {100e-6, 50}};

}


TEST(meanDrag, stoppingDistance)
{
    for (const auto& [d, v0] : shots)
    {
        const Sphere s(d);
        const double exact = s.stoppingDistance(v0);
        for (const double ratio : {0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0})
        {
            EXPECT_NEAR(s.stopped(v0, ratio)/exact, 1, 2e-3) << d << ' ' << v0 << ' ' << ratio;
        }
        // second order
        const double coarse = s.stopped(v0, 0.02)/exact - 1;
        const double fine = s.stopped(v0, 0.005)/exact - 1;
        EXPECT_NEAR(fine/coarse, 1.0/16, 0.01) << d << ' ' << v0;
    }
}


TEST(meanDrag, speedOnTheWay)
{
    for (const auto& [d, v0] : shots)
    {
        const Sphere s(d);
        for (const double ratio : {0.05, 0.5, 1.0, 3.0})
        {
            Vec3 x = Vec3::Zero(), v(v0, 0, 0);
            s.step(x, v, Vec3::Zero(), ratio*s.tau);
            const double exact = s.speed(v0, ratio*s.tau);
            EXPECT_NEAR(v[0]/v0, exact/v0, 2e-3) << d << ' ' << v0 << ' ' << ratio;
        }
    }
}


TEST(meanDrag, terminalVelocityIsReachedAndNotPassed)
{
    for (const double d : {20e-6, 100e-6, 200e-6, 500e-6})
    {
        const Sphere s(d);
        const Vec3 F(0, 0, -9.81*s.m);
        double terminal = 9.81*s.tau;
        for (int i = 0; i < 500; ++i) terminal = std::sqrt(terminal*9.81*s.m/s.drag(terminal));

        // from rest, and from above
        for (const double start : {0.0, 3.0})
        {
            for (double ratio = 0.1; ratio < 1e4; ratio *= 1.7)
            {
                Vec3 x = Vec3::Zero(), v(0, 0, -start*terminal);
                for (int i = 0; i < 20 || i*ratio < 40; ++i)
                {
                    s.step(x, v, F, ratio*s.tau);
                    const double passed = (-v[2]/terminal - 1)*(start > 1 ? -1 : 1);
                    ASSERT_LT(passed, 1e-10) << d << ' ' << start << ' ' << ratio << ' ' << i;
                }
                ASSERT_NEAR(-v[2]/terminal, 1, 1e-12) << d << ' ' << start << ' ' << ratio;
            }
        }
    }
}


TEST(meanDrag, constantDragIsExact)
{
    const Sphere s(50e-6);
    const Vec3 w(3, -1, 2), F = s.m*Vec3(1, 2, -9.81);
    for (const double ratio : {1e-3, 1.0, 1e3})
    {
        const dem::MeanDrag mean = dem::meanDrag
        (
            w, F, s.m, ratio*s.tau, s.Sp, [&s](double) { return s.Sp; }
        );
        EXPECT_EQ(mean.Sp, s.Sp);
        EXPECT_EQ(mean.force, F);
        EXPECT_EQ(mean.evaluations, 1);
    }
}


TEST(meanDrag, slipAcrossTheForce)
{
    // Thrown sideways, against short steps. One Sp bends no path that turns as it slows down: the
    // place is second order, the velocity what it should be in any step.
    const Sphere s(200e-6);
    const Vec3 F(0, 0, -9.81*s.m);
    const double time = 0.4*s.tau;
    const auto after = [&](int steps)
    {
        Vec3 x = Vec3::Zero(), v(8, 0, 1);
        for (int i = 0; i < steps; ++i) s.step(x, v, F, time/steps);
        return std::make_pair(x, v);
    };
    const auto exact = after(20000);
    const auto coarse = after(20), fine = after(80), one = after(1);
    const double ratio = (fine.first - exact.first).norm()/(coarse.first - exact.first).norm();
    EXPECT_NEAR(ratio, 1.0/16, 0.01);
    EXPECT_LT((one.second - exact.second).norm(), 0.01*exact.second.norm());
}
