// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polystyrene spheres on a wall, the set of Haervig et al. 2017 (physics.md, section 5):
// rebound, contact time and sticking speed of simplifiedJKR, real and softened.
#include "impact.hpp"

using scene::close;
using scene::Law;

namespace
{

constexpr double r = 0.635e-6;

Law polystyrene(double chi = 1)
{
    Law law;    // E 271 MPa, gamma 0.11 J/m2, rho 1026 kg/m3, e 0.86
    law.normal = "simplifiedJKR";
    law.softening.ratio = chi;
    return law;
}

double sticking(const Law& law, double steps, double guess, double width = 1e-6)
{
    return scene::stickingSpeed
    (
        0.7*guess, 1.4*guess, width,
        [&](double v) { return scene::impact(law, r, v, steps).left; }
    );
}

//- The same from the independent integration
double exactSticking(const Law& law, double guess, double width = 1e-7)
{
    const formula::Contact c = law.contact(r, -1);
    return scene::stickingSpeed
    (
        0.7*guess, 1.4*guess, width,
        [&](double v)
        {
            return formula::collide(law.normal, c, v, law.restitution).restitution > 0;
        }
    );
}

}


TEST(pslRebound, effectiveRestitution)
{
    struct Point { double v, e; };
    const Point points[] = {{3, 0.4834}, {5, 0.7186}, {10, 0.8111}, {20, 0.8410}};
    const Law law = polystyrene();
    std::printf("speed_mps,restitution,exact,steps\n");
    for (const Point& p : points)
    {
        SCOPED_TRACE(scene::text(p.v) + " m/s");
        const double exact =
            formula::collide("simplifiedJKR", law.contact(r, -1), p.v, 0.86).restitution;
        EXPECT_TRUE(close(exact, p.e, 1e-4));
        const scene::Impact i = scene::impact(law, r, p.v, 50);
        ASSERT_TRUE(i.left);
        std::printf("%g,%.6f,%.6f,%d\n", p.v, i.restitution, exact, int(i.steps));
        EXPECT_TRUE(close(i.restitution, exact, 5e-4));
        const double fine = scene::impact(law, r, p.v, 400).restitution;
        EXPECT_TRUE(close(fine, exact, 1e-5));
    }
}


TEST(pslRebound, contactTime)
{
    const Law law = polystyrene();
    const formula::Collision exact =
        formula::collide("simplifiedJKR", law.contact(r, -1), 5, 0.86);
    EXPECT_TRUE(close(exact.time, 18.749e-9, 1e-4));
    EXPECT_TRUE(close(scene::impact(law, r, 5, 50).time, exact.time, 1e-3));
    EXPECT_TRUE(close(scene::impact(law, r, 5, 400).time, exact.time, 2e-5));
}


TEST(pslRebound, stickingSpeed)
{
    const Law law = polystyrene();
    const double exact = exactSticking(law, 2.4);
    EXPECT_TRUE(close(exact, 2.4005, 1e-4));
    const double coarse = sticking(law, 50, 2.4), fine = sticking(law, 400, 2.4);
    std::printf("sticking speed: 50 steps %.6f, 400 steps %.6f, exact %.6f m/s\n", coarse, fine, exact);
    EXPECT_TRUE(close(coarse, exact, 5e-4));
    EXPECT_TRUE(close(fine, exact, 5e-6));
}


TEST(pslRebound, softeningIsExact)
{
    // with steps scaled alike, rebound and sticking speed are the same to round-off, and
    // times grow as chi^(-2/5)
    for (const double chi : {0.1, 0.01, 1e-3})
    {
        SCOPED_TRACE("chi " + scene::text(chi));
        for (const double v : {3.0, 5.0, 10.0, 20.0})
        {
            // no contact law covers overlaps of the size of the radius
            const Law law = polystyrene(chi);
            const dem::ContactFigures f =
                law.table().figures(0, 1, r, -1, law.mass(r), 0, v);
            if (f.impactOverlap > 0.6*r) continue;
            const scene::Impact real = scene::impact(polystyrene(), r, v, 50);
            const scene::Impact soft = scene::impact(polystyrene(chi), r, v, 50);
            ASSERT_TRUE(soft.left);
            EXPECT_EQ(soft.steps, real.steps);
            EXPECT_TRUE(close(soft.restitution, real.restitution, 1e-9));
            EXPECT_TRUE(close(soft.time*std::pow(chi, 0.4), real.time, 1e-9));
        }
        EXPECT_TRUE
        (
            close
            (
                sticking(polystyrene(chi), 50, 2.4, 1e-10),
                sticking(polystyrene(), 50, 2.4, 1e-10), 1e-9
            )
        );
    }

    // the exponent itself, over three decades
    const double t1 = scene::impact(polystyrene(1), r, 3, 50).time;
    const double t2 = scene::impact(polystyrene(1e-3), r, 3, 50).time;
    EXPECT_NEAR(std::log(t2/t1)/std::log(1e-3), -0.4, 1e-4);
}


TEST(pslRebound, everyNormalLawIsSoftenedExactly)
{
    for (const char* normal : {"Hertz", "simplifiedJKR", "JKR", "DMT"})
    {
        Law real = polystyrene(), soft = polystyrene(0.01);
        real.normal = soft.normal = normal;
        if (real.normal == "Hertz") real.gamma = soft.gamma = 0;
        const scene::Impact a = scene::impact(real, r, 15, 50);
        const scene::Impact b = scene::impact(soft, r, 15, 50);
        SCOPED_TRACE(normal);
        ASSERT_TRUE(a.left && b.left);
        EXPECT_TRUE(close(b.restitution, a.restitution, 1e-9));
        EXPECT_TRUE(close(b.time*std::pow(0.01, 0.4), a.time, 1e-9));
    }
}


TEST(pslRebound, stickingLimitOfSoftness)
{
    // lambda_crit = c(e) Ad^(5/2), Ad = 3 gamma/(rho v^2 r), lambda = E/(rho v^2) with E
    // and v at the sticking limit: exponent 5/2, c(0.86) = 0.633, c(0.3) = 147.2
    struct Constant { double e, c, guess; };
    for (const Constant k : {Constant{0.86, 0.633, 2.4}, Constant{0.3, 147.2, 14.8}})
    {
        SCOPED_TRACE("e " + scene::text(k.e));
        std::vector<double> logAd, logLambda;
        for (const double factor : {1.0, 8.0, 64.0})
        {
            Law law = polystyrene();
            law.restitution = k.e;
            law.E *= factor;
            // v_c grows as gamma^(5/6) E^(-1/3)
            const double v = sticking(law, 400, k.guess*std::pow(factor, -1.0/3.0), 1e-8);
            logAd.push_back(std::log(3*law.gamma/(law.density*v*v*r)));
            logLambda.push_back(std::log(law.E/(law.density*v*v)));
        }
        for (std::size_t j = 1; j < logAd.size(); ++j)
        {
            const double exponent =
                (logLambda[j] - logLambda[0])/(logAd[j] - logAd[0]);
            EXPECT_NEAR(exponent, 2.5, 1e-4);
        }
        const double c = std::exp(logLambda[0] - 2.5*logAd[0]);
        std::printf("c(%g) = %.5g\n", k.e, c);
        EXPECT_TRUE(close(c, k.c, 1e-3));   // as many digits as are quoted
    }
}
