// SPDX-License-Identifier: GPL-3.0-or-later
//
// When a force along the wall rolls a stuck sphere away: F_yield = 4 F_C xi_crit/r for the
// proper rules of reduced stiffness, less for the naive ones; symmetry; and that nothing
// builds up in the springs of a bonded pair that turns as one body.
#include "scene.hpp"

#include <cstdlib>

using scene::close;
using scene::near;
using scene::Law;
using dem::Vec3;

namespace
{

constexpr double r = 0.635e-6;

Law rollingLaw(bool angle, const dem::ReducedStiffness& softening)
{
    Law law;
    law.friction = 10;      // it shall roll, not slide
    law.restitution = 0.3;
    if (angle) law.criticalAngle = 0.0085;
    else law.adhesionHysteresis = 0.4;
    law.softening = softening;
    // a tenth of the critical damping of rolling, 2 ((7/5) m r k_r)^(1/2), in a static test
    const formula::Contact c = law.contact(r, -1, true);
    law.rollingDamping = 0.2*std::sqrt(1.4*c.m*r*4*c.pullOff());
    return law;
}

//- F_yield of the original contact [N]
double realYield(const Law& law)
{
    const formula::Contact c = law.contact(r, -1, true);
    const double critical =
        law.criticalAngle > 0 ? law.criticalAngle*r : law.adhesionHysteresis*c.a0()/12;
    return 4*c.pullOff()*critical/r;
}

//- Path of a stuck sphere under a force that is brought up slowly and then stays, over the
//  greatest elastic displacement xi_crit
double path(const Law& law, const Vec3& force)
{
    const formula::Contact soft = law.contact(r, -1), real = law.contact(r, -1, true);
    dem::TimeSettings time;
    time.stepsPerContact = 20;
    time.restTolerance = 0;
    dem::System system(law.table(), time);
    system.setWalls(scene::floor());
    const double z = r - soft.delta0();
    system.add(scene::sphere(law, 1, r, Vec3(0, 0, z)));

    const double period =
        2*formula::pi*std::sqrt(1.4*real.m*r/(4*real.pullOff()));
    const int ramp = 200, hold = 600;   // 10 and 30 rolling periods
    for (int k = 1; k <= ramp + hold; ++k)
    {
        dem::GasLoad g;
        g.Su = std::min(1.0, double(k)/ramp)*force;
        system.setGasLoad(0, g);
        system.advance(period/20);
    }
    EXPECT_TRUE(system.inContact(0));
    const double critical = realYield(law)*r/(4*real.pullOff());
    Vec3 moved = system.particle(0).x - Vec3(0, 0, z);
    moved.z() = 0;
    return moved.norm()/critical;
}

}


TEST(rollingYield, staticYield)
{
    struct Rule
    {
        const char* name;
        bool angle, scaleGamma, scaleResistance;
        double exponent;    // F_yield over that of the original: chi^exponent
    };
    const Rule rules[] =
    {
        {"hysteresis", false, true, false, 0},
        {"critical angle", true, true, false, 0},
        {"hysteresis, all scaled", false, true, true, 0.2},
        {"critical angle, all scaled", true, true, true, 0.4},
        {"hysteresis, E alone", false, false, true, -1.0/3.0}
    };
    std::printf("rule,chi,yield_over_original,path_below,static,path_above\n");
    for (const Rule& rule : rules)
    {
        for (const double chi : {1.0, 0.1, 0.01})
        {
            if (chi == 1 && rule.exponent != 0) continue;
            SCOPED_TRACE(std::string(rule.name) + ", chi " + scene::text(chi));
            const Law law =
                rollingLaw(rule.angle, {chi, rule.scaleGamma, rule.scaleResistance});
            const double yield = realYield(law)*std::pow(chi, rule.exponent);
            // where it stays below yield: the rolling spring at 0.95 xi_crit is the mean of
            // the path of the centre and of r times the angle, which differ by the slip s
            const formula::Contact soft = law.contact(r, -1), real = law.contact(r, -1, true);
            const double critical =
                !rule.angle && rule.scaleResistance ? soft.a0()/real.a0() : 1;
            const double slide =
                0.95*yield/(8*soft.G*soft.a0())*4*real.pullOff()/(realYield(law)*r);
            const double expected = 0.95*critical + 0.5*slide;
            // the plain sum of torques: r F = M_y
            const double below = path(law, Vec3(0.95*yield, 0, 0));
            const double above = path(law, Vec3(1.05*yield, 0, 0));
            std::printf
            (
                "%s,%g,%.4f,%.4f,%.4f,%.1f\n", rule.name, chi, std::pow(chi, rule.exponent),
                below, expected, above
            );
            EXPECT_TRUE(close(below, expected, 0.02));
            EXPECT_GT(above, 4*expected);
        }
    }
}


TEST(rollingYield, theSameInEveryDirection)
{
    const Law law = rollingLaw(false, {0.01, true, false});
    const double yield = realYield(law);
    const double along = path(law, Vec3(1.2*yield, 0, 0));
    for (const Vec3& way : {Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0.6, -0.8, 0)})
    {
        EXPECT_TRUE(close(path(law, 1.2*yield*way), along, 1e-6));
    }
}


TEST(rollingYield, spinReversal)
{
    // the mirror image of an impact with spin is the impact with the spin reversed
    for (const char* normal : {"JKR", "simplifiedJKR"})
    {
        Law law = rollingLaw(false, {0.1, true, false});
        law.normal = normal;
        law.friction = 0.3;
        law.twisting = true;
        const auto run = [&](double sign)
        {
            dem::TimeSettings time;
            time.restTolerance = 0;
            dem::System system(law.table(), time);
            system.setWalls(scene::floor());
            // mirrored in the plane y = 0: v_y, omega_x and omega_z change sign
            system.add
            (
                scene::sphere
                (
                    law, 1, r, Vec3(0, 0, 1.001*r), Vec3(0.7, sign*0.4, -2),
                    Vec3(sign*2e6, 3e6, sign*1e6)
                )
            );
            for (int k = 0; k < 50; ++k) system.advance(1e-8);
            EXPECT_TRUE(system.inContact(0));
            return system.particle(0);
        };
        const dem::Particle a = run(1), b = run(-1);
        const Vec3 mirrored(b.x.x(), -b.x.y(), b.x.z());
        EXPECT_TRUE(near(mirrored, a.x, 1e-9*r));
        EXPECT_TRUE(near(Vec3(-b.omega.x(), b.omega.y(), -b.omega.z()), a.omega, 1e-9*4e6));
        EXPECT_GT(a.omega.norm(), 0);
    }
}


TEST(rollingYield, aBondedPairTurnsAsOneBody)
{
    // Two spheres bonded at a neck that carries the centrifugal force turn about their
    // middle, across and along the line of centres: no spring may wind up. The spins that
    // match the surfaces are d/(2r) times the turn across the line, for an overlap is lost.
    const char* isLong = std::getenv("DUSTFOAM_LONG");
    const double turns = isLong && std::string(isLong) == "1" ? 10000 : 200;
    Law law;
    law.friction = 0.3;
    law.adhesionHysteresis = 0.4;
    law.twisting = true;
    law.restitution = 0.5;
    law.softening.ratio = 0.01;
    const formula::Contact c = law.contact(r, r);
    const double mass = law.mass(r);

    for (const bool along : {false, true})
    {
        SCOPED_TRACE(along ? "along the line of centres" : "across");
        // centrifugal force m Omega^2 r = 0.02 F_C
        const double Omega = std::sqrt(0.02*c.pullOff()/(mass*r));
        // overlap at which the neck carries that force, by bisection
        double low = 0, high = c.delta0();
        for (int k = 0; k < 100; ++k)
        {
            const double o = 0.5*(low + high), d = 2*r - o;
            const double needed = along ? 0 : mass*Omega*Omega*d/2;
            (formula::normal("JKR", c, o, 1).force < -needed ? low : high) = o;
        }
        const double d = 2*r - low;
        const Vec3 n = Vec3(1, 2, -2)/3;
        const Vec3 axis = along ? n : Vec3(Vec3(2, 1, 2)/3);
        const Vec3 orbit = Omega*axis;
        const Vec3 spin = along ? orbit : Vec3(orbit*d/(2*r));

        dem::TimeSettings time;
        time.stepsPerContact = 20;
        time.restTolerance = 0;
        dem::System system(law.table(), time);
        const Vec3 x = 0.5*d*n;
        system.add(scene::sphere(law, 1, r, -x, -orbit.cross(x), spin));
        system.add(scene::sphere(law, 2, r, x, orbit.cross(x), spin));

        const double turn = 2*formula::pi/Omega;
        for (int k = 0; k < 20; ++k) system.advance(turns/20*turn);
        const dem::Particle a = system.particle(0), b = system.particle(1);
        const Vec3 line = (b.x - a.x).normalized();
        // still bonded at the same distance, turning at the same rate about the same axis
        EXPECT_TRUE(close((b.x - a.x).norm(), d, 1e-3*low/d + 1e-6));
        EXPECT_TRUE(near(a.omega, spin, 1e-3*spin.norm()));
        EXPECT_TRUE(near(b.omega, spin, 1e-3*spin.norm()));
        if (!along)
        {
            const Vec3 rate = line.cross(b.v - a.v)/d;
            EXPECT_TRUE(near(rate, orbit, 1e-3*Omega));
            EXPECT_TRUE(near(line.dot(axis), 0, 1e-3));
        }
        else EXPECT_TRUE(near(line, n, 1e-3));
        EXPECT_TRUE(near((a.x + b.x)/2, Vec3::Zero(), 1e-6*r));

        // forces across the line of centres: none
        const auto contacts = system.contacts();
        ASSERT_EQ(contacts.size(), 1u);
        const Vec3 f = contacts[0].force, m = contacts[0].normal;
        EXPECT_LT((f - f.dot(m)*m).norm(), 1e-3*c.pullOff());
    }
}
