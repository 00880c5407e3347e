// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contacts on curved walls: the effective radius against a numerical solution, and the curvature
// that is measured on triangles.
#include "ContactBench.hpp"
#include "ellipse.hpp"
#include "scene.hpp"

#include <cmath>
#include <functional>

using dem::Vec3;
using dem::WallCurvature;
using scene::close;
using scene::Law;

namespace
{

constexpr double r = 1e-6;

//- Effective radius over r
double radius(const std::string& normal, const WallCurvature& k)
{
    Law law;
    law.normal = normal;
    if (normal == "Hertz") law.gamma = 0;
    return law.table().wallRadius(0, 1, k, r)/r;
}

WallCurvature wire(double ratio) { return {1/(ratio*r), 0}; }

}


TEST(ellipticContact, pullOffAgainstTheLeastEnergy)
{
    // the ratio of the relative radii from 1 to 0.002, wires and saddles
    for (const double ratio : {1e6, 20.0, 5.0, 1.0, 0.5, 0.25, 0.1, 0.02, 0.003})
    {
        SCOPED_TRACE(ratio);
        const double exact = ellipse::pullOff(1, ratio/(1 + ratio));
        EXPECT_TRUE(close(radius("JKR", wire(ratio)), exact, 1e-4));
        EXPECT_EQ(radius("simplifiedJKR", wire(ratio)), radius("JKR", wire(ratio)));
    }
    for (const double saddle : {2.0, 0.8})
    {
        // convex one way, hollow the other: 1/r + 1/R and 1/r - 1/(2 R)
        const WallCurvature k{1/(saddle*r), -0.5/(saddle*r)};
        SCOPED_TRACE(saddle);
        const double R1 = 1/(1 - 0.5/saddle), R2 = 1/(1 + 1/saddle);
        EXPECT_TRUE(close(radius("JKR", k), R1*ellipse::pullOff(R1, R2), 1e-4));
    }
}


TEST(ellipticContact, pullOffOfThinWires)
{
    // the figures of the header, over a flat wall's
    struct { double ratio, jkr, derjaguin; } rows[] =
    {
        {20, 0.9759, std::sqrt(20.0/21)}, {5, 0.9126, std::sqrt(5.0/6)},
        {1, 0.7045, std::sqrt(1.0/2)}, {0.5, 0.5721, std::sqrt(1.0/3)},
        {0.25, 0.4389, std::sqrt(1.0/5)}
    };
    for (const auto& row : rows)
    {
        EXPECT_NEAR(radius("JKR", wire(row.ratio)), row.jkr, 1e-4);
        EXPECT_TRUE(close(radius("DMT", wire(row.ratio)), row.derjaguin, 1e-14));
    }
}


TEST(ellipticContact, hertzianStiffness)
{
    for (const double ratio : {1e6, 5.0, 1.0, 0.5, 0.1, 0.01, 0.002})
    {
        SCOPED_TRACE(ratio);
        const double lambda = ratio/(1 + ratio), stiffness = ellipse::hertz(1, lambda);
        EXPECT_TRUE
        (
            close(radius("Hertz", wire(ratio)), std::sqrt(lambda)*stiffness*stiffness, 5e-5)
        );
    }
}


TEST(ellipticContact, limits)
{
    for (const char* normal : {"JKR", "simplifiedJKR", "DMT", "Hertz"})
    {
        SCOPED_TRACE(normal);
        // flat: the number itself; and a wire of infinite radius comes to it
        EXPECT_EQ(radius(normal, {}), 1);
        EXPECT_TRUE(close(radius(normal, wire(1e7)), 1, 1e-7));
        // balls and hollows are no ellipse
        EXPECT_TRUE(close(radius(normal, {1/(3*r), 1/(3*r)}), 0.75, 1e-14));
        EXPECT_TRUE(close(radius(normal, {-1/(3*r), -1/(3*r)}), 1.5, 1e-14));
        EXPECT_EQ
        (
            radius(normal, {2/r, -0.3/r}), radius(normal, {-0.3/r, 2/r})
        );
        double last = 1;
        for (double ratio = 1e3; ratio > 2e-3; ratio /= 3)
        {
            const double now = radius(normal, wire(ratio));
            EXPECT_LT(now, last);
            last = now;
        }
        EXPECT_LT(last, 0.2);
    }
}


TEST(ellipticContact, figuresAndRollingYield)
{
    Law law;
    law.criticalAngle = 0.01;
    const dem::MaterialTable table = law.table();
    const WallCurvature k = wire(0.5);
    const double m = law.mass(r), R = table.wallRadius(0, 1, k, r);
    const auto f = table.figures(0, 1, r, -1, m, 0, 1, k);
    const auto flat = table.figures(0, 1, r, -1, m, 0, 1);
    EXPECT_TRUE(close(f.pullOff, flat.pullOff*R/r, 1e-14));
    EXPECT_TRUE(close(f.a0, flat.a0*std::pow(R/r, 2.0/3.0), 1e-14));
    EXPECT_EQ(table.figures(0, 1, r, -1, m, 0, 1, WallCurvature()).pullOff, flat.pullOff);

    // it rolls as on the plane: yields at the same angle, with the moment of its own F_C
    for (const bool hysteresis : {false, true})
    {
        law.criticalAngle = hysteresis ? -1 : 0.01;
        law.adhesionHysteresis = hysteresis ? 0.4 : -1;
        const bench::ContactBench contact(law);
        double c[dem::maxConstants];
        contact.law().prepare
        (
            contact.table().pairInLaw(0, 1), {contact.table().constants(0, 1), R, m, r}, c
        );
        const double xi = hysteresis ? f.a0/12*0.4 : 0.01*r;
        EXPECT_TRUE(close(contact.law().rollingYield(c, r).moment, 4*f.pullOff*xi, 1e-13));
    }
}


TEST(ellipticContact, reachInAHollow)
{
    const Law law;
    dem::Walls walls = scene::floor();
    const double flat = law.contact(r, -1).deltaC();
    EXPECT_TRUE(close(law.table().reach(0, r, walls), flat, 1e-14));
    walls.patches[0].curvature = WallCurvature{-0.5/r, -0.5/r};     // R = 2 r
    EXPECT_TRUE(close(law.table().reach(0, r, walls), flat*std::cbrt(2.0), 1e-12));
    walls.patches[0].curvature = wire(1);
    EXPECT_TRUE(close(law.table().reach(0, r, walls), flat, 1e-14));
}


TEST(ellipticContact, whatDoesNotFitIsRefused)
{
    const Law law;
    const auto add = [&](const WallCurvature& k)
    {
        dem::System system(law.table(), {});
        dem::Walls walls = scene::floor();
        walls.patches[0].curvature = k;
        system.setWalls(walls);
        system.add(scene::sphere(law, 1, r, Vec3(0, 0, 2*r)));
    };
    EXPECT_NO_THROW(add({-0.89/r, 0}));
    EXPECT_NO_THROW(add({990/r, 0}));
    for (const WallCurvature& k : {WallCurvature{-0.91/r, 0}, {0, -2/r}, {1100/r, 0}})
    {
        try
        {
            add(k);
            ADD_FAILURE() << k.k1 << " " << k.k2 << " was accepted";
        }
        catch (const dem::inputError& e)
        {
            EXPECT_EQ(e.keyword, "patchCurvature/floor");
        }
    }
}


// * * * * * * * * * * * * * * Curvature of Triangles  * * * * * * * * * * * * * * //

namespace
{

//- The surface x(u, v), u from 0 to nu and v from 0 to nv, in two triangles a square; the particles
//  are on the side of x_u times x_v. closed: u = nu is u = 0
dem::Walls mesh(int nu, int nv, bool closed, const std::function<Vec3(int, int)>& x)
{
    dem::Walls walls;
    walls.patches = {{"patch", 0}};
    const auto at = [&](int u, int v) { return x(closed ? u%nu : u, v); };
    for (int u = 0; u < nu; ++u)
    {
        for (int v = 0; v < nv; ++v)
        {
            const Vec3 a = at(u, v), b = at(u + 1, v), c = at(u + 1, v + 1), d = at(u, v + 1);
            if ((u + v)%2)
            {
                walls.triangles.push_back({a, b, c, 0});
                walls.triangles.push_back({a, c, d, 0});
            }
            else
            {
                walls.triangles.push_back({a, b, d, 0});
                walls.triangles.push_back({b, c, d, 0});
            }
        }
    }
    return walls;
}

//- A cylinder about z, seen from outside (or inside), whose corners are off by a part of a facet
dem::Walls cylinder(int n, double R, bool inside, double jitter = 0, double bumps = 0)
{
    scene::Random random(5);
    std::vector<double> angle(std::size_t(n*11)), height(angle.size()), out(angle.size());
    for (std::size_t k = 0; k < angle.size(); ++k)
    {
        angle[k] = random.uniform(-jitter, jitter);
        height[k] = random.uniform(-jitter, jitter);
        out[k] = 1 + random.uniform(-bumps, bumps);
    }
    return mesh(n, 10, true, [=](int u, int v)
    {
        const std::size_t k = std::size_t(11*u + v);
        const double facet = 2*formula::pi/n;
        const double t = (inside ? -1 : 1)*facet*(u + angle[k]);
        return Vec3
        (
            out[k]*R*std::cos(t), out[k]*R*std::sin(t), R*facet*(v + height[k])
        );
    });
}

}


TEST(measuredCurvature, cylinders)
{
    for (const int n : {8, 12, 16, 24, 90})
    {
        for (const bool inside : {false, true})
        {
            SCOPED_TRACE((inside ? "inside " : "outside ") + std::to_string(n));
            const auto m = dem::measureCurvature(cylinder(n, 5e-5, inside), 0);
            EXPECT_TRUE(m.trusted());
            // a chord is shorter than its arc
            const double arc = formula::pi/n/std::sin(formula::pi/n);
            EXPECT_TRUE(close(m.curvature.k1, (inside ? -1 : 1)*arc/5e-5, 1e-6));
            EXPECT_EQ(m.curvature.k2, 0);
        }
    }
    const auto uneven = dem::measureCurvature(cylinder(24, 5e-5, false, 0.3), 0);
    EXPECT_TRUE(uneven.trusted());
    EXPECT_TRUE(close(uneven.curvature.k1, 1/5e-5, 0.03));
    EXPECT_EQ(uneven.curvature.k2, 0);
    EXPECT_FALSE(dem::measureCurvature(cylinder(24, 5e-5, false, 0, 0.05), 0).trusted());
}


TEST(measuredCurvature, prismsAndPlanesAreFlat)
{
    for (const int n : {4, 6, 7})
    {
        const auto m = dem::measureCurvature(cylinder(n, 5e-5, false), 0);
        EXPECT_TRUE(m.trusted());
        EXPECT_TRUE(m.curvature.flat());
        EXPECT_TRUE(close(m.edged, 1, 1e-12));
    }
    const auto plane = dem::measureCurvature
    (
        mesh(7, 9, false, [](int u, int v) { return Vec3(0.3*u, 0.1*u + 0.7*v, 1 + 0.2*v); }), 0
    );
    EXPECT_TRUE(plane.trusted());
    EXPECT_TRUE(plane.curvature.flat());
    EXPECT_EQ(plane.edged, 0);
    EXPECT_TRUE(dem::measureCurvature(scene::floor(), 0).curvature.flat());
}


TEST(measuredCurvature, ballsSaddlesAndMixtures)
{
    const double R = 2e-4;
    const auto height = [=](double k1, double k2)
    {
        // a small part, about its top
        return mesh(40, 40, false, [=](int u, int v)
        {
            const double h = 0.01*R, x = h*(u - 20), y = h*(v - 20);
            return Vec3(x, y, -0.5*(k1*x*x + k2*y*y));
        });
    };
    const auto ball = dem::measureCurvature(height(1/R, 1/R), 0);
    EXPECT_TRUE(ball.trusted());
    EXPECT_TRUE(close(ball.curvature.k1, 1/R, 0.05));
    EXPECT_TRUE(close(ball.curvature.k2, 1/R, 0.05));
    const auto saddle = dem::measureCurvature(height(1/R, -0.5/R), 0);
    EXPECT_TRUE(saddle.trusted());
    EXPECT_TRUE(close(saddle.curvature.k1, 1/R, 0.05));
    EXPECT_TRUE(close(saddle.curvature.k2, -0.5/R, 0.05));

    // half of it flat: no one curvature
    const auto half = dem::measureCurvature
    (
        mesh(40, 10, false, [=](int u, int v)
        {
            const double t = 0.1*std::max(u - 20, 0);
            const double back = 0.1*std::min(u - 20, 0);
            return Vec3(R*(back + std::sin(t)), 0.1*R*v, R*std::cos(t));
        }), 0
    );
    EXPECT_FALSE(half.trusted());
}


TEST(derivedCurvature, ofAnalyticShapes)
{
    const Law law;
    const auto curvature = [&](const std::function<void(dem::Walls&)>& shapes)
    {
        dem::Walls walls;
        walls.patches = {{"shape", 1}};
        shapes(walls);
        dem::System system(law.table(), {});
        system.setWalls(walls);
        return system.walls().patches[0].curvature;
    };
    const Vec3 o = Vec3::Zero(), z = Vec3::UnitZ();
    const auto rod = curvature([&](auto& w) { w.cylinders = {{o, z, 0.5, false, 0}}; });
    ASSERT_TRUE(rod.has_value());
    EXPECT_EQ(rod->k1, 2);
    EXPECT_EQ(rod->k2, 0);
    EXPECT_EQ(curvature([&](auto& w) { w.cylinders = {{o, z, 0.5, true, 0}}; })->k1, -2);
    EXPECT_EQ(curvature([&](auto& w) { w.spheres = {{o, 0.5, false, 0}}; })->k2, 2);
    // one that is given stays, and unlike shapes have none together
    EXPECT_EQ
    (
        curvature([&](auto& w)
        {
            w.cylinders = {{o, z, 0.5, false, 0}};
            w.patches[0].curvature = WallCurvature();
        })->k1, 0
    );
    EXPECT_FALSE
    (
        curvature([&](auto& w)
        {
            w.cylinders = {{o, z, 0.5, false, 0}};
            w.planes = {{o, z, 0}};
        }).has_value()
    );
}
