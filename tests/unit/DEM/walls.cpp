// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a sphere touches the walls: one contact per smooth surface.
#include "scene.hpp"
#include "walls/WallSearch.hpp"

#include <algorithm>

using scene::close;
using scene::near;
using dem::Vec3;
using dem::WallHit;
using dem::WallSearch;

namespace
{

std::vector<WallHit> hitsAt(const WallSearch& search, const Vec3& x, double range)
{
    std::vector<int> surfaces;
    search.query(x.array() - range, x.array() + range, surfaces);
    std::vector<WallHit> hits;
    search.hits(x, range, surfaces.data(), surfaces.size(), hits);
    return hits;
}

dem::Walls empty(int patches = 1)
{
    dem::Walls walls;
    for (int p = 0; p < patches; ++p) walls.patches.push_back({"p" + std::to_string(p), 1});
    return walls;
}

void quad
(
    dem::Walls& walls, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
    int patch = 0
)
{
    walls.triangles.push_back({a, b, c, patch});
    walls.triangles.push_back({a, c, d, patch});
}

//- A square grid in z = 0, n by n squares of size 1, normal +z
dem::Walls grid(int n, int patchesAlongX = 1)
{
    dem::Walls walls = empty(patchesAlongX);
    for (int i = 0; i < n; ++i)
    {
        for (int j = 0; j < n; ++j)
        {
            quad
            (
                walls, Vec3(i, j, 0), Vec3(i + 1, j, 0), Vec3(i + 1, j + 1, 0),
                Vec3(i, j + 1, 0), i*patchesAlongX/n
            );
        }
    }
    return walls;
}

//- The cube [-1, 1]^3, particles outside (or inside)
dem::Walls cube(bool inside)
{
    dem::Walls walls = empty(6);
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const double side : {-1.0, 1.0})
        {
            Vec3 n = Vec3::Zero(), u = Vec3::Zero();
            n[axis] = side;
            u[(axis + 1)%3] = 1;
            const Vec3 v = (inside ? -1.0 : 1.0)*n.cross(u);
            quad
            (
                walls, n - u - v, n + u - v, n + u + v, n - u + v,
                2*axis + (side > 0)
            );
        }
    }
    return walls;
}

//- A prism of n facets around the z axis, corners at radius 1
dem::Walls facets(int n, bool inside)
{
    dem::Walls walls = empty();
    for (int k = 0; k < n; ++k)
    {
        const double a = 2*formula::pi*k/n, b = 2*formula::pi*(k + 1)/n;
        // the last corner is the first one, to the last bit
        const Vec3 p(std::cos(a), std::sin(a), 0);
        const Vec3 q = k + 1 < n ? Vec3(std::cos(b), std::sin(b), 0) : Vec3(1, 0, 0);
        const Vec3 up(0, 0, 1);
        for (int layer = -2; layer < 2; ++layer)
        {
            const Vec3 low = layer*up, high = (layer + 1)*up;
            if (inside) quad(walls, q + low, p + low, p + high, q + high);
            else quad(walls, p + low, q + low, q + high, p + high);
        }
    }
    return walls;
}

}


TEST(wallSearch, flatFaceIsOneContactAnywhere)
{
    for (const int patches : {1, 4})
    {
        const WallSearch search(grid(4, patches));
        std::vector<Vec3> points;
        // over corners, diagonals, edges, and anywhere
        for (int i = 1; i < 16; ++i)
        {
            for (int j = 1; j < 16; ++j) points.emplace_back(0.25*i, 0.25*j, 0);
        }
        scene::Random random(1);
        for (int k = 0; k < 2000; ++k)
        {
            points.emplace_back(random.uniform(0.01, 3.99), random.uniform(0.01, 3.99), 0);
            const double x = random.uniform(0.01, 3.99);
            points.emplace_back(x, std::min(3.99, std::floor(x) + (x - std::floor(x))), 0);
        }
        for (Vec3 x : points)
        {
            for (const double height : {1e-6, 0.1, 0.4, 1.1})
            {
                x.z() = height;
                const auto hits = hitsAt(search, x, 1.2*height);
                ASSERT_EQ(hits.size(), 1u) << x.transpose();
                ASSERT_TRUE(near(hits[0].n, Vec3(0, 0, -1), 1e-9));
                ASSERT_TRUE(close(hits[0].distance, height, 1e-12));
                ASSERT_LE(std::abs(hits[0].patch - int(x.x()*patches/4)), x.x() == int(x.x()));
            }
        }
    }
}


TEST(wallSearch, backOfAFaceIsNotFelt)
{
    const WallSearch search(grid(2));
    EXPECT_TRUE(hitsAt(search, Vec3(0.7, 0.2, -0.1), 0.15).empty());
    EXPECT_TRUE(hitsAt(search, Vec3(1.3, 1.4, -0.1), 0.15).empty());
    EXPECT_EQ(hitsAt(search, Vec3(0.7, 0.2, 0.1), 0.15).size(), 1u);
}


TEST(wallSearch, convexBodyIsFeltOnce)
{
    // outside a cube: one contact, at the nearest point of the cube (each coordinate cut
    // back to [-1, 1]), be it on a face, an edge or a corner
    const WallSearch search(cube(false));
    scene::Random random(2);
    int kinds[4] = {};
    for (int k = 0; k < 20000; ++k)
    {
        const Vec3 x = random.inBox(1.5);
        const Vec3 nearest = x.cwiseMax(-1).cwiseMin(1);
        const double distance = (x - nearest).norm();
        if (distance < 1e-3) continue;
        int beyond = 0;
        for (int d = 0; d < 3; ++d) beyond += std::fabs(x[d]) > 1;
        ++kinds[beyond];
        const auto hits = hitsAt(search, x, 1.0001*distance);
        ASSERT_EQ(hits.size(), 1u) << x.transpose();
        ASSERT_TRUE(close(hits[0].distance, distance, 1e-12));
        ASSERT_TRUE(near(hits[0].n, (nearest - x)/distance, 1e-9));
        ASSERT_TRUE(hitsAt(search, x, 0.9999*distance).empty());

        // and never twice, however far it looks before the other side comes up
        ASSERT_EQ(hitsAt(search, x, std::min(1.3*distance, 1.9)).size(), 1u);
    }
    EXPECT_GT(kinds[1], 100);
    EXPECT_GT(kinds[2], 100);
    EXPECT_GT(kinds[3], 100);
}


TEST(wallSearch, concaveCornerHasOneContactPerSide)
{
    // inside a cube: one contact with each side within range
    const WallSearch search(cube(true));
    scene::Random random(3);
    int sizes[4] = {};
    for (int k = 0; k < 20000; ++k)
    {
        const Vec3 x = random.inBox(0.999);
        const double range = random.uniform(0.05, 0.9);
        std::vector<double> expected;
        for (int d = 0; d < 3; ++d)
        {
            for (const double side : {-1.0, 1.0})
            {
                const double distance = 1 - side*x[d];
                if (distance <= range) expected.push_back(distance);
            }
        }
        std::sort(expected.begin(), expected.end());
        if (expected.size() > 3) continue;
        ++sizes[expected.size()];
        const auto hits = hitsAt(search, x, range);
        ASSERT_EQ(hits.size(), expected.size()) << x.transpose() << " range " << range;
        for (std::size_t h = 0; h < hits.size(); ++h)
        {
            ASSERT_TRUE(close(hits[h].distance, expected[h], 1e-10));   // nearest first
        }
    }
    for (int n = 0; n < 4; ++n) EXPECT_GT(sizes[n], 50) << n << " contacts";
}


TEST(wallSearch, facetedCylinder)
{
    for (const int n : {16, 24, 48})    // facets meet at 22.5, 15 and 7.5 degrees
    {
        SCOPED_TRACE(std::to_string(n) + " facets");
        const double inner = std::cos(formula::pi/n);
        const WallSearch outside(facets(n, false)), inside(facets(n, true));
        scene::Random random(4);
        for (int k = 0; k < 3000; ++k)
        {
            // every fourth point lies over an edge, another fourth over the middle of a facet
            double angle = random.uniform(0, 2*formula::pi);
            if (k%4 == 0) angle = 2*formula::pi*random.below(n)/n;
            if (k%4 == 1) angle = 2*formula::pi*(random.below(n) + 0.5)/n;
            const double z = k%3 ? random.uniform(-1.2, 1.2) : 0;
            const Vec3 radial(std::cos(angle), std::sin(angle), 0);

            // outside: the nearest point of a convex polygon
            const double rOut = random.uniform(1.05, 1.5);
            const Vec3 x = rOut*radial + Vec3(0, 0, z);
            double shortest = 1e300;
            for (int f = 0; f < n; ++f)
            {
                const double a = 2*formula::pi*f/n, b = 2*formula::pi*(f + 1)/n;
                const Vec3 p(std::cos(a), std::sin(a), z), q(std::cos(b), std::sin(b), z);
                const double along =
                    std::min(1.0, std::max(0.0, (x - p).dot(q - p)/(q - p).squaredNorm()));
                shortest = std::min(shortest, (x - p - along*(q - p)).norm());
            }
            auto hits = hitsAt(outside, x, 1.05*shortest);
            ASSERT_EQ(hits.size(), 1u) << x.transpose();
            ASSERT_TRUE(close(hits[0].distance, shortest, 1e-9));

            // inside: the nearest facet's plane; the sphere touches two facets at an edge,
            // but a smooth surface is felt once
            const double rIn = random.uniform(0.3, 0.9);
            const Vec3 y = rIn*radial + Vec3(0, 0, z);
            double nearest = 1e300;
            for (int f = 0; f < n; ++f)
            {
                const double a = 2*formula::pi*(f + 0.5)/n;
                nearest = std::min
                (
                    nearest, inner - y.dot(Vec3(std::cos(a), std::sin(a), 0))
                );
            }
            hits = hitsAt(inside, y, 1.02*nearest);
            ASSERT_EQ(hits.size(), 1u) << y.transpose();
            ASSERT_TRUE(close(hits[0].distance, nearest, 1e-9));
            ASSERT_LT(hits[0].n.dot(radial), 1 + 1e-12);
            ASSERT_GT(hits[0].n.dot(radial), std::cos(2*formula::pi/n));
        }
    }
}


TEST(wallSearch, thinBaffle)
{
    // two coincident faces back to back, cut alike and cut by different diagonals
    for (const bool crossed : {false, true})
    {
        SCOPED_TRACE(crossed);
        dem::Walls walls = empty(2);
        const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
        quad(walls, a, b, c, d, 0);
        if (crossed) quad(walls, d, c, b, a, 1);
        else quad(walls, a, d, c, b, 1);
        const WallSearch search(walls);
        scene::Random random(5);
        for (int k = 0; k < 5000; ++k)
        {
            Vec3 x(random.uniform(-0.3, 1.3), random.uniform(-0.3, 1.3), 0);
            if (k%4 == 0) x.y() = x.x();
            if (k%4 == 1) x.y() = 1 - x.x();
            x.z() = random.uniform(0.02, 0.3)*(k%2 ? 1 : -1);
            const Vec3 nearest = x.cwiseMax(Vec3(0, 0, 0)).cwiseMin(Vec3(1, 1, 0));
            const double distance = (x - nearest).norm();
            const auto hits = hitsAt(search, x, 1.1*distance);
            ASSERT_EQ(hits.size(), 1u) << x.transpose();
            ASSERT_TRUE(close(hits[0].distance, distance, 1e-10));
            ASSERT_TRUE(near(hits[0].n, (nearest - x)/distance, 1e-8));
            if (nearest.x() == x.x() && nearest.y() == x.y())
            {
                ASSERT_EQ(hits[0].patch, x.z() > 0 ? 0 : 1) << x.transpose();
            }
        }
    }
}


TEST(wallSearch, ridgeAndValleyAroundTheFeatureAngle)
{
    // two planes that meet at an angle: a valley sharper than the feature angle has two
    // contacts, a smoother one has one; a ridge always has one
    for (const double degrees : {5.0, 20.0, 29.0, 31.0, 60.0, 90.0})
    {
        SCOPED_TRACE(scene::text(degrees));
        const double tilt = degrees*formula::pi/180;
        const double c = std::cos(tilt), s = std::sin(tilt);
        for (const double sign : {1.0, -1.0})   // valley, ridge
        {
            dem::Walls walls = empty();
            quad(walls, {-2, -2, 0}, {0, -2, 0}, {0, 2, 0}, {-2, 2, 0});
            const Vec3 far(2*c, 0, sign*2*s), y(0, 2, 0);
            quad(walls, -y, far - y, far + y, y);
            const WallSearch search(walls);
            // on the bisector, 0.1 away from both faces (or from the ridge)
            const Vec3 up = Vec3(-sign*s, 0, 1 + c).normalized();
            const Vec3 x = up*(sign > 0 ? 0.1/std::cos(tilt/2) : 0.1);
            const auto hits = hitsAt(search, x, 0.12);
            ASSERT_EQ(hits.size(), sign > 0 && degrees > 30 ? 2u : 1u);
            for (const WallHit& h : hits) EXPECT_TRUE(close(h.distance, 0.1, 1e-10));
        }
    }
}


TEST(wallSearch, analyticShapes)
{
    dem::Walls walls = empty(5);
    walls.planes = {{Vec3(0, 0, -5), Vec3(0, 0, 2), 0}};
    walls.cylinders =
    {
        {Vec3(0, 0, 7), Vec3(0, 0, 3), 4, true, 1},
        {Vec3(1, 0, 0), Vec3(0, 2, 0), 0.5, false, 2}
    };
    walls.spheres = {{Vec3(0, 2, 0), 0.25, false, 3}, {Vec3::Zero(), 6, true, 4}};
    const WallSearch search(walls);

    scene::Random random(6);
    for (int k = 0; k < 2000; ++k)
    {
        const Vec3 x = random.inBox(2.5);
        struct Expected { double distance; Vec3 n; };
        const Vec3 radial = Vec3(x.x(), x.y(), 0).normalized();
        const Vec3 rod = Vec3(1 - x.x(), 0, -x.z());
        const Vec3 ball = Vec3(0, 2, 0) - x;
        const Expected expected[5] =
        {
            {x.z() + 5, Vec3(0, 0, -1)},
            {4 - std::hypot(x.x(), x.y()), radial},
            {rod.norm() - 0.5, rod.normalized()},
            {ball.norm() - 0.25, ball.normalized()},
            {6 - x.norm(), x.normalized()}
        };
        const double range = random.uniform(0.5, 6);
        std::vector<bool> found(5, false);
        double last = -1e300;
        for (const WallHit& h : hitsAt(search, x, range))
        {
            ASSERT_GE(h.distance, last);
            last = h.distance;
            ASSERT_FALSE(found[std::size_t(h.patch)]);
            found[std::size_t(h.patch)] = true;
            ASSERT_TRUE(near(h.distance, expected[h.patch].distance, 1e-13));
            ASSERT_TRUE(near(h.n, expected[h.patch].n, 1e-12));
        }
        for (std::size_t p = 0; p < 5; ++p)
        {
            ASSERT_EQ(found[p], expected[p].distance <= range) << "shape " << p;
        }
    }
}


TEST(wallSearch, queryAgainstBruteForce)
{
    for (const int n : {1, 4, 5, 37, 1000})
    {
        dem::Walls walls = empty();
        scene::Random random(1000 + unsigned(n));
        for (int k = 0; k < n; ++k)
        {
            const Vec3 a = random.inBox(1);
            const double size = random.logUniform(1e-3, 1);
            walls.triangles.push_back
            ({
                a, a + random.inBox(size), a + random.inBox(size), 0
            });
        }
        const WallSearch search(walls);
        std::vector<int> found;
        std::size_t total = 0;
        for (int q = 0; q < 300; ++q)
        {
            const Vec3 middle = random.inBox(1.2);
            const double half = random.logUniform(1e-3, 1);
            const Vec3 low = middle.array() - half, high = middle.array() + half;
            search.query(low, high, found);
            std::vector<int> expected;
            for (int k = 0; k < n; ++k)
            {
                const auto& t = walls.triangles[std::size_t(k)];
                const Vec3 tLow = t.a.cwiseMin(t.b).cwiseMin(t.c);
                const Vec3 tHigh = t.a.cwiseMax(t.b).cwiseMax(t.c);
                if ((tLow.array() <= high.array()).all() && (tHigh.array() >= low.array()).all())
                {
                    expected.push_back(k);
                }
            }
            ASSERT_EQ(found, expected);
            total += expected.size();
        }
        EXPECT_GT(total, 0u);
    }
}


TEST(wallSearch, refusesImpossibleWalls)
{
    dem::Walls walls = empty();
    walls.triangles.push_back({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), 0});
    EXPECT_THROW(WallSearch{walls}, dem::inputError);
    walls.triangles = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), 1}};
    EXPECT_THROW(WallSearch{walls}, dem::inputError);
    walls.triangles.clear();
    walls.planes = {{Vec3::Zero(), Vec3::UnitZ(), -1}};
    EXPECT_THROW(WallSearch{walls}, dem::inputError);

    // a patch of a material that does not exist
    dem::System system(scene::Law().table(), {});
    dem::Walls floor = scene::floor();
    floor.patches[0].material = 2;
    EXPECT_THROW(system.setWalls(floor), dem::inputError);
}


TEST(wallSearch, timeToTouchIsNeverTooLate)
{
    // Spheres flying at constant speed or slowing down from it: by the time that the search
    // names, the sphere does not reach into any wall yet
    dem::Walls walls = cube(true);
    walls.patches.push_back({"more", 1});
    walls.cylinders = {{Vec3::Zero(), Vec3(0, 0, 1), 0.9, true, 6}};
    walls.spheres = {{Vec3(0.2, 0.1, 0.3), 0.2, false, 6}, {Vec3::Zero(), 1.2, true, 6}};
    const WallSearch search(walls);
    std::vector<int> all;
    search.query(Vec3::Constant(-2), Vec3::Constant(2), all);
    const std::vector<double> touch(walls.patches.size(), 0.0);

    scene::Random random(8);
    int useful = 0;
    for (int k = 0; k < 3000; ++k)
    {
        const double r = random.logUniform(1e-3, 0.1);
        const Vec3 x = random.inBox(0.6), v = random.inBox(1);
        const Vec3 a = (k%2)*random.inBox(2);
        const auto clearance = [&](const Vec3& y)
        {
            double gap = 1.2 - y.norm();
            gap = std::min(gap, 0.9 - std::hypot(y.x(), y.y()));
            gap = std::min(gap, (y - Vec3(0.2, 0.1, 0.3)).norm() - 0.2);
            for (int d = 0; d < 3; ++d) gap = std::min(gap, 1 - std::fabs(y[d]));
            return gap - r;
        };
        if (clearance(x) <= 0) continue;
        const double t = search.timeToTouch
        (
            x, v, a.norm(), r, touch, all.data(), all.size()
        );
        ASSERT_GT(t, 0);
        for (int step = 0; step <= 100; ++step)
        {
            const double s = std::min(t, 10.0)*step/100;
            ASSERT_GE(clearance(x + s*v + 0.5*s*s*a), -1e-12);
        }
        // and it is not uselessly early: several such leaps reach the wall
        double moved = t;
        Vec3 y = x, w = v;
        for (int leap = 0; leap < 30 && moved < 10; ++leap)
        {
            y += moved*w + 0.5*moved*moved*a;
            w += moved*a;
            if (clearance(y) < 1e-3*r) { ++useful; break; }
            moved = search.timeToTouch(y, w, a.norm(), r, touch, all.data(), all.size());
        }
    }
    EXPECT_GT(useful, 1500);
}


TEST(wallMotion, rollingOverADiagonalFeelsNothing)
{
    // a sticky sphere rolls over a triangulated floor, of one patch or of several, as over a plane
    scene::Law law;
    law.friction = 0.5;
    law.adhesionHysteresis = 1e-4;
    law.twisting = true;
    const double r = 1e-6;
    const formula::Contact c = law.contact(r, -1);

    const auto run = [&](int patches)
    {
        dem::TimeSettings time;
        time.restTolerance = 0;
        dem::System system(law.table(), time);
        dem::Walls walls = scene::floor();
        if (patches)
        {
            dem::Walls g = grid(6, patches);
            walls.planes.clear();
            walls.patches = g.patches;
            for (dem::WallTriangle t : g.triangles)
            {
                for (Vec3* p : {&t.a, &t.b, &t.c}) *p = (*p - Vec3(1, 1, 0))*r;
                walls.triangles.push_back(t);
            }
        }
        system.setWalls(walls);
        const Vec3 v(0.31, 0.17, 0);
        system.add
        (
            scene::sphere
            (
                law, 1, r, Vec3(0, 0, r - c.delta0()), v, Vec3(-v.y(), v.x(), 0)/r
            )
        );
        std::vector<dem::Particle> path;
        for (int k = 0; k < 400; ++k)
        {
            system.advance(2e-8);
            EXPECT_EQ(system.contacts().size(), 1u);
            path.push_back(system.particle(0));
        }
        return path;
    };
    const auto plane = run(0);
    for (const int patches : {1, 3})
    {
        SCOPED_TRACE(patches);
        const auto mesh = run(patches);
        // it has crossed diagonals and edges; the second patch begins at x = r
        EXPECT_GT(mesh.back().x.x(), 2*r);
        EXPECT_GT(mesh.back().x.y(), r);
        for (std::size_t k = 0; k < plane.size(); ++k)
        {
            ASSERT_TRUE(near(mesh[k].x, plane[k].x, 1e-11*r));
            ASSERT_TRUE(near(mesh[k].v, plane[k].v, 1e-10*0.3));
            ASSERT_TRUE(near(mesh[k].omega, plane[k].omega, 1e-10*0.3/r));
        }
    }
}


TEST(wallMotion, anImpactWhereTwoPatchesMeetKeepsItsEnergy)
{
    // lossless, and so oblique that another patch is nearest while it touches: at the joint of
    // two patches, and at the free edge of a baffle, which has one on either side
    scene::Law law;
    law.normal = "Hertz";
    law.gamma = 0;
    law.restitution = 1;
    const double r = 1e-6;
    const auto gain = [&](const dem::Walls& walls, const Vec3& x, const Vec3& v)
    {
        dem::TimeSettings time;
        time.restTolerance = 0;
        dem::System system(law.table(), time);
        system.setWalls(walls);
        system.add(scene::sphere(law, 1, r, x, v));
        const dem::StepReport report = system.advance(r/v.norm());
        EXPECT_EQ(report.touches, 1);
        EXPECT_EQ(report.separations, 1);
        return system.particle(0).v.squaredNorm()/v.squaredNorm() - 1;
    };
    dem::Walls floor = empty(2), baffle = empty(2);
    const double L = 4*r;
    quad(floor, {-L, -L, 0}, {0, -L, 0}, {0, L, 0}, {-L, L, 0}, 0);
    quad(floor, {0, -L, 0}, {L, -L, 0}, {L, L, 0}, {0, L, 0}, 1);
    quad(baffle, {-L, -L, 0}, {0, -L, 0}, {0, L, 0}, {-L, L, 0}, 0);
    quad(baffle, {-L, -L, 0}, {-L, L, 0}, {0, L, 0}, {0, -L, 0}, 1);
    for (int k = 0; k < 20; ++k)
    {
        // from 0 to 1 contact way before the joint; the contact lasts 0.04 r/(1 m/s)
        SCOPED_TRACE(k);
        const double before = 0.002*k*r;
        const Vec3 v(1, 0, -1), w(-1, 0, -1);
        const Vec3 above(-before - 0.1*r, 0.3*r, 1.1*r), beside(1.1*r, 0.3*r, before + 0.1*r);
        // the moment of the touch, from which steps are graded, may differ by round-off
        EXPECT_NEAR(gain(floor, above, v), gain(scene::floor(), above, v), 1e-7);
        EXPECT_NEAR(gain(baffle, beside, w), 0, 3e-4);
    }
}


TEST(wallMotion, wallIsAHugeSphere)
{
    // one oblique bounce off a plane, a huge particle and a huge round wall
    scene::Law law;
    law.normal = "JKR";
    law.friction = 0.3;
    law.adhesionHysteresis = 0.4;
    law.twisting = true;
    const double r = 1e-6, huge = 1e6*r;
    const auto bounce = [&](int kind)
    {
        dem::TimeSettings time;
        time.stepsPerContact = 100;
        dem::System system(law.table(), time);
        if (kind == 0) system.setWalls(scene::floor());
        const Vec3 below(0, 0, -huge);
        if (kind == 1)
        {
            dem::Walls walls;
            walls.patches = {{"ball", 1}};
            walls.spheres = {{below, huge, false, 0}};
            system.setWalls(walls);
        }
        system.add
        (
            scene::sphere(law, 1, r, Vec3(0, 0, 1.01*r), Vec3(4, 1, -12), Vec3(0, 0, 1e6))
        );
        if (kind == 2) system.add(scene::sphere(law, 2, huge, below));
        system.advance(3e-8);
        EXPECT_TRUE(system.contacts().empty());
        EXPECT_GT(system.particle(0).v.z(), 0);
        return system.particle(0);
    };
    const dem::Particle plane = bounce(0);
    for (const int kind : {1, 2})
    {
        SCOPED_TRACE(kind);
        const dem::Particle p = bounce(kind);
        // of the order r/huge, and the rounding of positions of the size of huge
        EXPECT_TRUE(near(p.v, plane.v, 2e-5*plane.v.norm()));
        EXPECT_TRUE(near(p.omega, plane.omega, 2e-5*plane.omega.norm()));
    }
}


TEST(wallMotion, flightInsideARoundWallEndsAtTheWall)
{
    // The gap to a round wall seen from inside closes faster and faster along a straight
    // path: past the axis the wall comes up at full speed
    scene::Law law;
    law.gamma = 0;
    law.restitution = 1;
    const double r = 1e-5, R = 1e-3, v = 1;
    for (const bool ball : {false, true})
    {
        for (const double offset : {0.0, 1e-9, 1e-4, 5e-4, 9e-4})
        {
            SCOPED_TRACE((ball ? "sphere " : "cylinder ") + scene::text(offset));
            dem::System system(law.table(), {});
            dem::Walls walls;
            walls.patches = {{"duct", 1}};
            if (ball) walls.spheres = {{Vec3::Zero(), R, true, 0}};
            else walls.cylinders = {{Vec3::Zero(), Vec3::UnitZ(), R, true, 0}};
            system.setWalls(walls);
            system.add(scene::sphere(law, 1, r, Vec3(0, offset, 0), Vec3(v, 0, 0)));

            // elastic and frictionless: chords of one length, so the speed and the offset
            // of the path from the axis stay what they were
            const dem::StepReport report = system.advance(5*R/v);
            EXPECT_LT(report.maxOverlapOverDiameter, 0.01);
            EXPECT_EQ(report.touches, offset < 1e-4 ? 3 : report.touches);
            EXPECT_GE(report.touches, 3);
            const dem::Particle& p = system.particle(0);
            EXPECT_TRUE(close(p.v.norm(), v, 1e-3));
            EXPECT_TRUE(near(p.x.cross(p.v).norm()/v, offset, 1e-3*R));
        }
    }
}
