// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sphere pulled off slowly (load control) from a face, an edge and a corner of a
// triangulated wall and from another sphere lets go at the law's pull-off force.
#include "scene.hpp"

#include <memory>

using scene::close;
using scene::Law;
using scene::sphere;
using dem::Vec3;

namespace
{

constexpr double r = 1e-6;

//- The cube [-2r, 0]^3, particles outside
dem::Walls cube()
{
    dem::Walls walls;
    walls.patches = {{"cube", 1}};
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const double side : {-1.0, 1.0})
        {
            Vec3 n = Vec3::Zero(), u = Vec3::Zero();
            n[axis] = side;
            u[(axis + 1)%3] = 1;
            const Vec3 v = n.cross(u);
            const auto at = [&](const Vec3& corner) { return Vec3(r*(corner - Vec3::Ones())); };
            walls.triangles.push_back({at(n - u - v), at(n + u - v), at(n + u + v), 0});
            walls.triangles.push_back({at(n - u - v), at(n + u + v), at(n - u + v), 0});
        }
    }
    return walls;
}

double lawPullOff(const Law& law, const formula::Contact& c)
{
    if (law.normal == "DMT") return 4*formula::pi*c.R*c.gamma;
    if (law.normal == "simplifiedJKR") return 8.0/9.0*c.pullOff();
    return c.pullOff();
}

double equilibriumOverlap(const Law& law, const formula::Contact& c)
{
    if (law.normal == "DMT") return std::pow(std::cbrt(3*formula::pi*c.gamma*c.R*c.R/c.E), 2)/c.R;
    return c.delta0();
}

//- Force at which `one` lets go when pulled by a force that grows along n (its partner, if
//  there is one, is pulled the other way)
double measured
(
    dem::System& system, const Law& law, const formula::Contact& c, const Vec3& n
)
{
    const double expected = lawPullOff(law, c);
    const double period =
        2*formula::pi*std::sqrt(c.m*c.a0()*c.a0()/(3.6*c.pullOff()*c.R));
    double force = 0;
    while (force < 1.2*expected)
    {
        // quickly up to 0.9, then slowly
        force += (force < 0.9*expected ? 5e-3 : 1e-4)*expected;
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            dem::GasLoad g;
            g.Su = (i ? -force : force)*n;
            system.setGasLoad(i, g);
        }
        system.advance(period);
        if (!system.inContact(0)) return force/expected;
    }
    return 1e300;
}

dem::TimeSettings neverRests()
{
    dem::TimeSettings time;
    time.restTolerance = 0;
    return time;
}

}


TEST(pullOff, fromFaceEdgeAndCorner)
{
    struct Place { const char* name; Vec3 foot, n; };
    const Place places[] =
    {
        {"face", Vec3(-0.3, -0.9, 0)*r, Vec3(0, 0, 1)},
        {"diagonal of a face", Vec3(-1, -1, 0)*r, Vec3(0, 0, 1)},
        {"edge", Vec3(-0.7, 0, 0)*r, Vec3(0, 1, 1)/std::sqrt(2.0)},
        {"edge, to one side", Vec3(-0.7, 0, 0)*r, Vec3(0, 0.3, 1).normalized()},
        {"corner", Vec3(0, 0, 0), Vec3(1, 1, 1)/std::sqrt(3.0)},
        {"corner, to one side", Vec3(0, 0, 0), Vec3(0.2, 0.5, 1).normalized()}
    };
    for (const char* normal : {"JKR", "simplifiedJKR", "DMT"})
    {
        for (const double chi : {1.0, 0.01})
        {
            Law law;
            law.normal = normal;
            law.friction = 0.3;
            law.adhesionHysteresis = 0.4;
            law.twisting = true;
            law.restitution = 0.5;
            law.softening.ratio = chi;
            const formula::Contact c = law.contact(r, -1);
            for (const Place& p : places)
            {
                SCOPED_TRACE(std::string(normal) + ", " + p.name + ", chi " + scene::text(chi));
                dem::System system(law.table(), neverRests());
                system.setWalls(cube());
                system.add
                (
                    sphere(law, 1, r, p.foot + (r - equilibriumOverlap(law, c))*p.n)
                );
                const double found = measured(system, law, c, p.n);
                EXPECT_TRUE(close(found, 1, 0.01));
            }
        }
    }
}


TEST(pullOff, ofAPair)
{
    for (const char* normal : {"JKR", "simplifiedJKR", "DMT"})
    {
        for (const double rj : {1.0*r, 5.0*r})
        {
            SCOPED_TRACE(std::string(normal) + " 1:" + scene::text(rj/r));
            Law law;
            law.normal = normal;
            law.restitution = 0.5;
            const formula::Contact c = law.contact(r, rj);
            const Vec3 n = Vec3(1, 2, 2)/3;
            dem::System system(law.table(), neverRests());
            system.add(sphere(law, 1, r, (r + rj - equilibriumOverlap(law, c))*n));
            system.add(sphere(law, 2, rj, Vec3::Zero()));
            EXPECT_TRUE(close(measured(system, law, c, n), 1, 0.01));
        }
    }
}


TEST(pullOff, displacementControlReachesTheNecksEnd)
{
    // drawn apart at constant slow speed by two heavy spheres: the tension passes F_C and
    // falls to (5/9) F_C where the contact ends, at -delta_C
    Law law;
    law.restitution = 1;
    const formula::Contact c = law.contact(r, r);
    dem::System system(law.table(), neverRests());
    // fast enough to keep its speed against the attraction
    const double v = 1e2*std::sqrt(2*c.pullOff()*c.deltaC()/c.m);
    system.add(sphere(law, 1, r, Vec3::Zero(), Vec3(-v/2, 0, 0)));
    system.add(sphere(law, 2, r, Vec3(2*r - c.delta0(), 0, 0), Vec3(v/2, 0, 0)));
    const double path = c.delta0() + c.deltaC();
    double last = 0, greatest = 0, lastForce = 0;
    for (int k = 0; k < 2000; ++k)
    {
        system.advance(path/v*1.05/2000);
        const auto contacts = system.contacts();
        if (contacts.empty()) break;
        last = contacts[0].overlap;
        lastForce = contacts[0].force.x();
        greatest = std::max(greatest, lastForce);
    }
    EXPECT_TRUE(system.contacts().empty());
    EXPECT_TRUE(close(last, -c.deltaC(), 3e-3));
    EXPECT_TRUE(close(greatest, c.pullOff(), 1e-5));
    // the last steps of the neck have an infinite slope
    EXPECT_GT(lastForce, 5.0/9.0*c.pullOff());
    EXPECT_LT(lastForce, 0.65*c.pullOff());
}
