// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collisions under JKR with its neck: energy lost per collision, sticking boundary over the
// damping, and the exact relation between damping and adhesionless restitution.
#include "impact.hpp"

using scene::close;
using scene::near;
using scene::Law;

namespace
{

constexpr double r = 1e-6;

//- Energy that the neck keeps: -F from delta = 0 (A^(3/2) = 2/3) to -delta_C (A^(3/2) = 1/6),
//  in closed form: 4 F_C (a0^2/R) [(2/5) A^5 - (2/3) A^(7/2) + A^2/6]
double neckEnergy(const formula::Contact& c)
{
    const auto primitive = [](double A)
    {
        return 0.4*std::pow(A, 5) - 2.0/3.0*std::pow(A, 3.5) + A*A/6;
    };
    const double A1 = std::pow(2.0/3.0, 2.0/3.0), Ac = std::pow(1.0/6.0, 2.0/3.0);
    return 4*c.pullOff()*c.a0()*c.a0()/c.R*(primitive(Ac) - primitive(A1));
}

//- A* = (E/(rho v^2))^(-1/3) (gamma/(rho v^2 r))^(5/6)
double adhesionNumber(const Law& law, double v)
{
    const double p = law.density*v*v;
    return std::pow(law.E/p, -1.0/3.0)*std::pow(law.gamma/(p*r), 5.0/6.0);
}

//- Speed at a given 1/A*: A* falls as 1/v
double speedAt(const Law& law, double inverse)
{
    return inverse*adhesionNumber(law, 1);
}

}


TEST(jkrCollision, undampedLossIsTheNeckEnergyAtEverySpeed)
{
    Law law;
    law.restitution = 1;
    const formula::Contact c = law.contact(r, -1);
    const double loss = neckEnergy(c);
    // the same by quadrature of the force
    double sum = 0;
    const int n = 20000;
    for (int k = 0; k < n; ++k)
    {
        // finer towards the end of the neck, where the slope is infinite
        const double x = (k + 0.5)/n;
        const double overlap = -c.deltaC()*(1 - x*x);
        sum -= formula::normal("JKR", c, overlap, 1).force*c.deltaC()*2*x/n;
    }
    EXPECT_TRUE(close(loss, sum, 1e-7));

    const double critical = std::sqrt(2*loss/c.m);
    std::printf("speed_over_critical,loss_over_neckEnergy\n");
    for (const double factor : {1.02, 1.2, 2.0, 5.0, 10.0})
    {
        SCOPED_TRACE(scene::text(factor) + " critical speeds");
        const double v = factor*critical;
        const scene::Impact i = scene::impact(law, r, v, 400);
        ASSERT_TRUE(i.left);
        const double lost = 0.5*c.m*(v*v - i.v.z()*i.v.z());
        std::printf("%g,%.6f\n", factor, lost/loss);
        // second order: a small share of the kinetic energy, which is factor^2 losses
        EXPECT_TRUE(close(lost, loss, 1e-3 + 2e-4*factor*factor));
    }
    EXPECT_FALSE(scene::impact(law, r, 0.98*critical, 400).left);

    // 1/A* = 3.279 without damping
    const double exact = 1/adhesionNumber(law, critical);
    EXPECT_NEAR(exact, 3.279, 1e-3);
    const double found = scene::stickingSpeed
    (
        0.8*critical, 1.2*critical, 1e-6,
        [&](double v) { return scene::impact(law, r, v, 400).left; }
    );
    std::printf("critical 1/A* = %.5f, closed form %.5f\n", 1/adhesionNumber(law, found), exact);
    EXPECT_TRUE(close(found, critical, 5e-4));
}


TEST(jkrCollision, pairAndSizeDoNotMatter)
{
    // e depends on alpha and A* only: at 1/A* = 6 for very different spheres
    Law law;
    std::vector<double> e;
    for (const double factor : {0.25, 1.0, 500.0})
    {
        for (const double stiffness : {2.71e8, 1e10, 1e12})
        {
            Law other = law;
            other.E = stiffness;
            const double size = factor*1e-6;
            const double p = other.density;
            const double v = 6*std::pow(other.E/p, -1.0/3.0)*std::pow(other.gamma/(p*size), 5.0/6.0);
            const scene::Impact i = scene::impact(other, size, v, 50);
            ASSERT_TRUE(i.left);
            e.push_back(i.restitution);
        }
    }
    for (const double value : e) EXPECT_TRUE(close(value, e[0], 1e-8));
}


TEST(jkrCollision, restitutionOverSpeedAndDamping)
{
    // e(alpha, 1/A*) against the independent integration
    std::printf("restitution0,inverseAdhesionNumber,e,exact\n");
    for (const double e0 : {0.95, 0.86, 0.5})
    {
        for (const double inverse : {8.0, 20.0, 100.0})
        {
            Law law;
            law.restitution = e0;
            const double v = speedAt(law, inverse);
            const double exact =
                formula::collide("JKR", law.contact(r, -1), v, e0).restitution;
            const double coarse = scene::impact(law, r, v, 50).restitution;
            const double fine = scene::impact(law, r, v, 400).restitution;
            std::printf("%g,%g,%.6f,%.6f\n", e0, inverse, coarse, exact);
            EXPECT_TRUE(near(coarse, exact, 4e-3));
            EXPECT_TRUE(near(fine, exact, 4e-4));
        }
    }
}


TEST(jkrCollision, stickingBoundaryOverDamping)
{
    std::printf("alpha,critical_inverseAdhesionNumber,exact\n");
    for (const double alpha : {0.0, 0.05, 0.2, 0.5, 1.0})
    {
        SCOPED_TRACE("alpha " + scene::text(alpha));
        Law law;
        law.dampingCoefficient = alpha;
        // the restitution that belongs to alpha: beta = alpha/5^(1/2)
        const double b = alpha/std::sqrt(5.0);
        law.restitution = std::exp(-formula::pi*b/std::sqrt(1 - b*b));
        const formula::Contact c = law.contact(r, -1);
        const double exact = scene::stickingSpeed
        (
            speedAt(law, 3), speedAt(law, 60), 1e-6,
            [&](double v)
            {
                return formula::collide("JKR", c, v, law.restitution).restitution > 0;
            }
        );
        const double found = scene::stickingSpeed
        (
            speedAt(law, 3), speedAt(law, 60), 1e-5,
            [&](double v) { return scene::impact(law, r, v, 200).left; }
        );
        std::printf
        (
            "%g,%.5f,%.5f\n", alpha, 1/adhesionNumber(law, found), 1/adhesionNumber(law, exact)
        );
        EXPECT_TRUE(close(found, exact, 2e-3));
    }
}


TEST(jkrCollision, restitutionWithoutAdhesionIsTheOneGiven)
{
    // alpha(e) is exact: Hertz reproduces e at every speed, JKR where adhesion is negligible
    for (const double e : {0.1, 0.3, 0.5, 0.86, 0.98, 1.0})
    {
        for (const double v : {0.01, 1.0, 50.0})
        {
            Law law;
            law.normal = "Hertz";
            law.gamma = 0;
            law.restitution = e;
            SCOPED_TRACE("e " + scene::text(e) + " at " + scene::text(v));
            EXPECT_TRUE(near(formula::collide("Hertz", law.contact(r, -1), v, e).restitution, e, 1e-6));
            EXPECT_TRUE(near(scene::impact(law, r, v, 50).restitution, e, 5e-4));
            EXPECT_TRUE(near(scene::impact(law, r, v, 400).restitution, e, 6e-6));
        }
        Law law;
        law.restitution = e;
        law.gamma = 1e-7;
        EXPECT_TRUE(near(scene::impact(law, r, 10, 400).restitution, e, 1e-3));
    }
}
