// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sphere thrown along a plane under gravity slides until it rolls with 5/7 of its speed.
#include "scene.hpp"

using scene::close;
using scene::near;
using scene::Law;
using dem::Vec3;

TEST(slipToRoll, fiveSevenths)
{
    for (const double tilt : {0.0, 0.3})    // direction of the throw in the plane
    {
        for (const bool triangles : {false, true})
        {
            SCOPED_TRACE((triangles ? "triangles, " : "plane, ") + scene::text(tilt));
            Law law;
            law.normal = "Hertz";
            law.gamma = 0;
            law.restitution = 0.5;
            law.friction = 0.3;
            const double r = 0.5e-3, g = 9.81, v0 = 0.1;
            const formula::Contact c = law.contact(r, -1);
            // starts where Hertz carries its weight
            const double overlap =
                std::pow(0.75*c.m*g/(c.E*std::sqrt(r)), 2.0/3.0);

            dem::TimeSettings time;
            time.restTolerance = 0;
            dem::System system(law.table(), time);
            dem::Walls walls = scene::floor();
            if (triangles)
            {
                walls.planes.clear();
                for (int i = -1; i < 8; ++i)
                {
                    for (int j = -4; j < 4; ++j)
                    {
                        const Vec3 x(i, j, 0), a(1, 0, 0), b(0, 1, 0);
                        walls.triangles.push_back({x*r, (x + a)*r, (x + a + b)*r, 0});
                        walls.triangles.push_back({x*r, (x + a + b)*r, (x + b)*r, 0});
                    }
                }
            }
            system.setWalls(walls);
            const Vec3 way(std::cos(tilt), std::sin(tilt), 0);
            system.add(scene::sphere(law, 1, r, Vec3(0, 0, r - overlap), v0*way));
            dem::GasLoad weight;
            weight.Su = Vec3(0, 0, -g*c.m);

            // sliding: v = v0 - mu g t, r omega = (5/2) mu g t; rolling from 2 v0/(7 mu g)
            const double rolls = 2*v0/(7*law.friction*g);
            const double dt = rolls/20;
            for (int k = 1; k <= 40; ++k)
            {
                system.setGasLoad(0, weight);
                system.advance(dt);
                const dem::Particle& p = system.particle(0);
                const double t = k*dt;
                const double v = t < rolls ? v0 - law.friction*g*t : 5.0/7.0*v0;
                const double w = t < rolls ? 2.5*law.friction*g*t/r : v/r;
                // the sliding spring is loaded first: mu m g/(8 G a) over the sliding
                // distance, and rings where rolling begins
                const double slack = k < 19 || k > 24 ? 1e-3 : 2e-2;
                ASSERT_TRUE(near(p.v, v*way, slack*v0)) << "t/t_roll " << t/rolls;
                ASSERT_TRUE(near(p.omega*r, w*r*Vec3::UnitZ().cross(way), slack*v0));
            }
            EXPECT_TRUE(close(system.particle(0).v.norm(), 5.0/7.0*v0, 1e-3));
        }
    }
}


TEST(slipToRoll, backspinAndSideSpin)
{
    // angular momentum about the line of contact is kept: m r v + I omega, in both directions,
    // so the final speed is (5/7) v0 + (2/7) r (omega0 x n)
    Law law;
    law.normal = "Hertz";
    law.gamma = 0;
    law.restitution = 0.5;
    law.friction = 0.3;
    const double r = 0.5e-3, g = 9.81;
    const formula::Contact c = law.contact(r, -1);
    const double overlap = std::pow(0.75*c.m*g/(c.E*std::sqrt(r)), 2.0/3.0);
    scene::Random random(3);
    for (int k = 0; k < 4; ++k)
    {
        Vec3 v0 = random.inBox(0.1), w0 = random.inBox(0.2)/r;
        v0.z() = 0;
        w0.z() = 0;
        dem::TimeSettings time;
        time.restTolerance = 0;
        dem::System system(law.table(), time);
        system.setWalls(scene::floor());
        system.add(scene::sphere(law, 1, r, Vec3(0, 0, r - overlap), v0, w0));
        dem::GasLoad weight;
        weight.Su = Vec3(0, 0, -g*c.m);
        for (int step = 0; step < 60; ++step)
        {
            system.setGasLoad(0, weight);
            system.advance(2e-3);
        }
        const Vec3 expected =
            5.0/7.0*v0 + 2.0/7.0*r*w0.cross(Vec3::UnitZ());
        EXPECT_TRUE(near(system.particle(0).v, expected, 1e-3*(v0.norm() + r*w0.norm())));
    }
}
