// SPDX-License-Identifier: GPL-3.0-or-later
//
// Oblique impacts of the kind of Chung & Ooi 2011 (tests 2, 4 and 5) against closed forms:
// elastic normal impact, gross sliding with and without spin, angular momentum.
#include "impact.hpp"

using scene::close;
using scene::near;
using scene::Law;
using dem::Vec3;

namespace
{

//- Elastic sphere of aluminium oxide on a wall
Law oxide()
{
    Law law;
    law.normal = "Hertz";
    law.gamma = 0;
    law.restitution = 1;
    law.E = 1/(2*(1 - 0.23*0.23)/3.8e11);
    law.nu = 0.23;
    law.density = 4000;
    law.friction = 0.092;
    return law;
}

constexpr double r = 2.5e-3;

}


TEST(obliqueImpact, normalImpactOnAPlane)
{
    // test 2: peak force and overlap of a Hertzian impact, and its time
    for (const double v : {0.2, 3.9})
    {
        const Law law = oxide();
        const formula::Contact c = law.contact(r, -1);
        dem::TimeSettings time;
        time.stepsPerContact = 200;
        time.restTolerance = 0;
        dem::System system(law.table(), time);
        system.setWalls(scene::floor());
        system.add(scene::sphere(law, 1, r, Vec3(0, 0, r), Vec3(0, 0, -v)));
        const double peak = std::pow(15*c.m*v*v/(16*c.E*std::sqrt(r)), 0.4);
        const double integral =
            0.4*std::sqrt(formula::pi)*std::tgamma(0.4)/std::tgamma(0.9);
        const double duration = 2*integral*peak/v;
        double overlap = 0, force = 0, ended = 0;
        for (int k = 1; k <= 1100 && ended == 0; ++k)
        {
            system.advance(duration/1000);
            for (const dem::ContactView& v : system.contacts())
            {
                overlap = std::max(overlap, v.overlap);
                force = std::max(force, v.force.z());
            }
            if (!system.inContact(0)) ended = k*duration/1000;
        }
        EXPECT_TRUE(close(overlap, peak, 1e-4));
        EXPECT_TRUE(close(force, 4.0/3.0*c.E*std::sqrt(r)*std::pow(peak, 1.5), 1e-4));
        EXPECT_TRUE(close(ended, duration, 2e-3));
        EXPECT_TRUE(close(system.particle(0).v.z(), v, 1e-4));
    }
}


TEST(obliqueImpact, grossSliding)
{
    // tests 4 and 5: where it slides all the time, the tangential impulse is mu times the
    // normal one: v_t' = v_t - 2 mu v_n, r omega' = 5 mu v_n
    const Law law = oxide();
    const double mu = law.friction, speed = 3.9;
    for (const double degrees : {50.0, 60.0, 70.0, 80.0, 85.0})
    {
        SCOPED_TRACE(degrees);
        const double angle = degrees*formula::pi/180;
        const double vn = speed*std::cos(angle), vt = speed*std::sin(angle);
        // Maw, Barber & Fawcett: slides throughout where tan(angle) > mu (7 - kappa')
        ASSERT_GT(vt/vn, 7*mu);
        const scene::Impact i = scene::impact
        (
            law, r, Vec3(vt, 0, -vn), Vec3::Zero(), 200
        );
        ASSERT_TRUE(i.left);
        EXPECT_TRUE(close(i.v.z(), vn, 2e-3));
        EXPECT_TRUE(near(i.v.x(), vt - 2*mu*vn, 3e-3*mu*vn));
        EXPECT_TRUE(near(r*i.omega.y(), 5*mu*vn, 1e-2*mu*vn));
        EXPECT_EQ(i.v.y(), 0);
        EXPECT_EQ(i.omega.x(), 0);
        EXPECT_EQ(i.omega.z(), 0);
    }
}


TEST(obliqueImpact, grossSlidingWithDamping)
{
    // the friction of gross sliding is mu (F_N + what the law adds) of the elastic force,
    // whatever the dashpots do: v_t' = v_t - (mu/m) times its time integral
    for (const char* normal : {"Hertz", "DMT", "simplifiedJKR", "JKR"})
    {
        for (const double e : {0.8, 0.5})
        {
            SCOPED_TRACE(std::string(normal) + " restitution " + scene::text(e));
            Law law;
            law.normal = normal;
            law.gamma = law.normal == "Hertz" ? 0 : 1e-3;
            law.restitution = e;
            law.friction = 0.1;
            const double radius = 1e-5, vn = 1, vt = 5;
            const formula::Contact c = law.contact(radius, -1);
            const double offset =
                law.normal == "DMT" ? 4*formula::pi*c.R*c.gamma : 2*c.pullOff();
            const double end = formula::endOverlap(normal, c);
            formula::Ode<3> ode;    // overlap, closing speed, integral of the limit/(mu m)
            ode.rate = [&](double, const std::array<double, 3>& y)
            {
                const formula::Normal n =
                    formula::normal(normal, c, std::max(y[0], end), e);
                return std::array<double, 3>
                {
                    y[1], -(n.force + n.damping*y[1])/c.m, (n.force + offset)/c.m
                };
            };
            const double peak =
                std::pow(15.0/16.0*c.m*vn*vn/(c.E*std::sqrt(radius)), 0.4);
            ode.scale = {peak, vn, vn};
            std::array<double, 3> y{0, vn, 0};
            ode.solve
            (
                y, 0, 30*peak/vn, 1e-6*peak/vn,
                [&](const auto& z) { return z[1] < 0 && z[0] < end; }
            );
            const double exact = vt - law.friction*y[2];
            const double impulse = vt - exact;
            for (const double steps : {50.0, 200.0, 1000.0})
            {
                const scene::Impact i = scene::impact
                (
                    law, radius, Vec3(vt, 0, -vn), Vec3::Zero(), steps
                );
                // the springs must load first: 8 G a against the limit
                EXPECT_TRUE(near(i.v.x(), exact, (1e-3 + 0.2/steps)*impulse)) << steps;
            }
        }
    }
}


TEST(obliqueImpact, spinningSphereThatSlides)
{
    // test 6 kind: normal impact with spin: the wall throws it to the side
    const Law law = oxide();
    const double mu = law.friction, vn = 1;
    for (const double spin : {4.0, -4.0})    // r omega, in m/s
    {
        const scene::Impact i = scene::impact
        (
            law, r, Vec3(0, 0, -vn), Vec3(0, spin/r, 0), 200
        );
        const double way = spin > 0 ? 1 : -1;
        EXPECT_TRUE(near(i.v.x(), way*2*mu*vn, 3e-3*mu*vn));
        EXPECT_TRUE(near(r*i.omega.y(), spin - way*5*mu*vn, 1e-2*mu*vn));
    }
}


TEST(obliqueImpact, anyAngleKeepsTheAngularMomentumAtTheContact)
{
    // whatever the friction does, it acts at the contact: v_t + (2/5) r omega is kept
    Law law = oxide();
    law.restitution = 0.8;
    for (const double degrees : {5.0, 15.0, 30.0, 45.0, 60.0})
    {
        const double angle = degrees*formula::pi/180, speed = 3.9;
        const double vn = speed*std::cos(angle), vt = speed*std::sin(angle);
        const scene::Impact i = scene::impact
        (
            law, r, Vec3(vt, 0, -vn), Vec3::Zero(), 50
        );
        // torque r n x F_T: omega turns as if the contact were at r
        EXPECT_TRUE(near(i.v.x() + 0.4*r*i.omega.y(), vt, 1e-12*speed));
        EXPECT_LT(i.v.x(), vt);
        EXPECT_GT(i.omega.y(), 0);
    }
}
