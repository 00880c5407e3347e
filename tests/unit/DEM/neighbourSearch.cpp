// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who is near whom: box pairs, connected sets, clusters and the load on their contacts.
#include "contacts/clusterMargins.hpp"
#include "neighbourSearch/BoxGrid.hpp"
#include "neighbourSearch/DisjointSets.hpp"
#include "scene.hpp"

#include <set>

using scene::close;
using scene::near;
using dem::ClusterGraph;
using dem::Vec3;

namespace
{

using Pairs = std::set<std::pair<int, int>>;

bool overlap(const dem::Box& a, const dem::Box& b, const Vec3& shift)
{
    for (int d = 0; d < 3; ++d)
    {
        if (a.low[d] > b.high[d] + shift[d] || b.low[d] + shift[d] > a.high[d]) return false;
    }
    return true;
}

}


TEST(boxGrid, againstBruteForce)
{
    for (const int n : {0, 1, 2, 5, 16, 17, 40, 300, 2000})
    {
        for (int kind = 0; kind < 4; ++kind)
        {
            SCOPED_TRACE(std::to_string(n) + " boxes, kind " + std::to_string(kind));
            scene::Random random(unsigned(10*n + kind));
            std::vector<dem::Box> boxes;
            for (int k = 0; k < n; ++k)
            {
                // alike; of very different sizes; in a plane; all in a heap
                const double half =
                    kind == 1 ? random.logUniform(1e-4, 0.3)
                  : random.uniform(0.5, 1)*std::cbrt(1.0/(n + 1));
                Vec3 middle = random.inBox(1);
                if (kind == 2) middle.z() = 0.25;
                if (kind == 3) middle *= 0.01;
                boxes.push_back({middle.array() - half, middle.array() + half});
            }
            Pairs found, expected;
            dem::BoxGrid(boxes).pairs
            (
                [&](int i, int j)
                {
                    ASSERT_LT(i, j);
                    ASSERT_TRUE(found.emplace(i, j).second) << "twice: " << i << " " << j;
                }
            );
            for (int i = 0; i < n; ++i)
            {
                for (int j = i + 1; j < n; ++j)
                {
                    if (overlap(boxes[std::size_t(i)], boxes[std::size_t(j)], Vec3::Zero()))
                    {
                        expected.emplace(i, j);
                    }
                }
            }
            ASSERT_EQ(found, expected);
        }
    }
}


TEST(boxGrid, touchingAndPointBoxes)
{
    // boxes that share a face only, on a lattice whose planes are cell borders
    std::vector<dem::Box> boxes;
    for (int i = 0; i < 4; ++i)
    {
        for (int j = 0; j < 4; ++j)
        {
            for (int k = 0; k < 4; ++k)
            {
                boxes.push_back({Vec3(i, j, k), Vec3(i + 1, j + 1, k + 1)});
            }
        }
    }
    std::size_t found = 0;
    dem::BoxGrid(boxes).pairs([&](int, int) { ++found; });
    // neighbours in a 4 x 4 x 4 lattice, diagonals included: (3*4 - 2)^3 - 64 over 2
    EXPECT_EQ(found, (1000u - 64u)/2);

    // points, many of them the same
    boxes.assign(30, {Vec3(1, 2, 3), Vec3(1, 2, 3)});
    found = 0;
    dem::BoxGrid(boxes).pairs([&](int, int) { ++found; });
    EXPECT_EQ(found, 30u*29/2);
}


TEST(boxGrid, periodicAgainstBruteForce)
{
    for (int axes = 1; axes < 8; ++axes)
    {
        SCOPED_TRACE(axes);
        dem::Periodic periodic;
        periodic.low = Vec3(-1, -2, 0.5);
        for (int d = 0; d < 3; ++d)
        {
            if (axes & (1 << d)) periodic.length[d] = 2 + 0.5*d;
        }
        scene::Random random(50u + unsigned(axes));
        std::vector<dem::Box> boxes;
        for (int k = 0; k < 400; ++k)
        {
            Vec3 middle;
            for (int d = 0; d < 3; ++d)
            {
                const double length = periodic.length[d] > 0 ? periodic.length[d] : 2;
                middle[d] = periodic.low[d] + random.uniform(0, length);
            }
            const double half = random.logUniform(0.01, 0.2);
            boxes.push_back({middle.array() - half, middle.array() + half});
        }
        Pairs found, expected;
        dem::BoxGrid(boxes, periodic).pairs([&](int i, int j) { found.emplace(i, j); });
        for (int i = 0; i < 400; ++i)
        {
            for (int j = i + 1; j < 400; ++j)
            {
                bool meets = false;
                for (int image = 0; image < 27; ++image)
                {
                    const Vec3 shift
                    (
                        (image%3 - 1)*periodic.length.x(),
                        (image/3%3 - 1)*periodic.length.y(),
                        (image/9 - 1)*periodic.length.z()
                    );
                    meets = meets
                     || overlap(boxes[std::size_t(i)], boxes[std::size_t(j)], shift);
                }
                if (meets) expected.emplace(i, j);
            }
        }
        EXPECT_EQ(found, expected);

        // some grow after the grid was made, to one side as well
        std::vector<dem::Box> grown = boxes;
        dem::BoxGrid grid(grown, periodic);
        for (int i = 0; i < 400; ++i)
        {
            if (random.below(10)) continue;
            grown[std::size_t(i)].low.array() -= 0.05;
            grown[std::size_t(i)].high.array() += 0.2;
            grid.changed(i);
        }
        for (int i = 0; i < 400; i += 7)
        {
            std::set<int> partners, all;
            grid.overlapping(grown[std::size_t(i)], [&](int j) { partners.insert(j); });
            for (int j = 0; j < 400; ++j)
            {
                for (int image = 0; image < 27; ++image)
                {
                    const Vec3 shift
                    (
                        (image%3 - 1)*periodic.length.x(),
                        (image/3%3 - 1)*periodic.length.y(),
                        (image/9 - 1)*periodic.length.z()
                    );
                    if (overlap(grown[std::size_t(i)], grown[std::size_t(j)], shift)) all.insert(j);
                }
            }
            EXPECT_EQ(partners, all);
        }

        // the nearest image is the nearest of all images
        for (int k = 0; k < 200; ++k)
        {
            const Vec3 a = boxes[std::size_t(k)].low, b = boxes[std::size_t(k + 1)].low;
            const Vec3 d = periodic.nearest(periodic.wrapped(a) - periodic.wrapped(b));
            for (int e = 0; e < 3; ++e)
            {
                const double L = periodic.length[e];
                if (L > 0)
                {
                    EXPECT_LE(std::fabs(d[e]), 0.5*L*(1 + 1e-14));
                    const double turns = (a[e] - b[e] - d[e])/L;
                    EXPECT_TRUE(near(turns, std::round(turns), 1e-12));
                }
                else EXPECT_EQ(d[e], a[e] - b[e]);
            }
        }
    }
}


TEST(disjointSets, againstBruteForce)
{
    scene::Random random(21);
    const int n = 200;
    for (int links : {0, 10, 100, 150, 1000})
    {
        dem::DisjointSets sets(n);
        std::vector<int> label(n);
        for (int i = 0; i < n; ++i) label[std::size_t(i)] = i;
        for (int k = 0; k < links; ++k)
        {
            const int a = random.below(n), b = random.below(n);
            sets.join(std::size_t(a), std::size_t(b));
            const int low = std::min(label[std::size_t(a)], label[std::size_t(b)]);
            const int high = std::max(label[std::size_t(a)], label[std::size_t(b)]);
            for (int& l : label) if (l == high) l = low;
        }
        // the root is the lowest member
        for (int i = 0; i < n; ++i)
        {
            ASSERT_EQ(sets.find(std::size_t(i)), std::size_t(label[std::size_t(i)]));
        }
    }
}


// * * * * * * * * * * * * * * * * * * Clusters * * * * * * * * * * * * * * * * * * * * * //

TEST(clusters, labels)
{
    ClusterGraph g;
    for (const std::int64_t id : {2, 3, 5, 7, 11, 13}) g.nodes.push_back({id, 1, Vec3::Zero()});
    g.bonds = {{5, 7, 1}, {3, 11, 1}, {7, 11, 1}, {3, -1, 1}, {2, 13, 1}};
    const auto labels = dem::clusterLabels(g);
    EXPECT_EQ(labels.size(), 6u);
    for (const std::int64_t id : {3, 5, 7, 11})
    {
        EXPECT_EQ(labels.at(id).root, 3);
        EXPECT_TRUE(labels.at(id).onWall);
    }
    for (const std::int64_t id : {2, 13})
    {
        EXPECT_EQ(labels.at(id).root, 2);
        EXPECT_FALSE(labels.at(id).onWall);
    }
}


TEST(clusterMargins, chainOnAWall)
{
    // a wall, then spheres 1 to 4: each contact carries all that hangs beyond it
    ClusterGraph g;
    const Vec3 f(3e-9, 0, 4e-9);    // 5 nN each
    for (int k = 1; k <= 4; ++k) g.nodes.push_back({k, 1e-15, f});
    g.bonds = {{1, -1, 2e-6}, {1, 2, 1e-6}, {2, 3, 1e-6}, {3, 4, 1e-6}};
    const std::vector<double> m = dem::clusterMargins(g);
    ASSERT_EQ(m.size(), 4u);
    EXPECT_TRUE(close(m[0], 2e-6/20e-9, 1e-12));
    EXPECT_TRUE(close(m[1], 1e-6/15e-9, 1e-12));
    EXPECT_TRUE(close(m[2], 1e-6/10e-9, 1e-12));
    EXPECT_TRUE(close(m[3], 1e-6/5e-9, 1e-12));
}


TEST(clusterMargins, twoChainsShareTheirRoot)
{
    // sphere 10 on a wall carries the chains 11-12 and 20-21, whose forces partly cancel
    ClusterGraph g;
    g.nodes =
    {
        {10, 1, Vec3(0, 0, 1)}, {11, 1, Vec3(2, 0, 0)}, {12, 1, Vec3(2, 0, 0)},
        {20, 1, Vec3(-1, 0, 0)}, {21, 1, Vec3(-3, 4, 0)}
    };
    g.bonds = {{10, -1, 50}, {10, 11, 8}, {11, 12, 8}, {10, 20, 10}, {20, 21, 10}};
    const std::vector<double> m = dem::clusterMargins(g);
    ASSERT_EQ(m.size(), 5u);
    EXPECT_TRUE(close(m[0], 50/Vec3(0, 4, 1).norm(), 1e-12));
    EXPECT_TRUE(close(m[1], 8/4.0, 1e-12));
    EXPECT_TRUE(close(m[2], 8/2.0, 1e-12));
    EXPECT_TRUE(close(m[3], 10/std::sqrt(32.0), 1e-12));
    EXPECT_TRUE(close(m[4], 10/5.0, 1e-12));
}


TEST(clusterMargins, ringTakesTheShortestWay)
{
    // a ring of six with one foot on the wall: both halves hang on their own side
    ClusterGraph g;
    for (int k = 0; k < 6; ++k) g.nodes.push_back({k, 1, Vec3(1, 0, 0)});
    for (int k = 0; k < 5; ++k) g.bonds.push_back({k, k + 1, 12});
    g.bonds.push_back({0, 5, 12});
    g.bonds.push_back({0, -1, 60});
    const std::vector<double> m = dem::clusterMargins(g);
    ASSERT_EQ(m.size(), 6u);
    EXPECT_TRUE(close(m[0], 60.0/6, 1e-12));
    // the far one hangs on either of its neighbours: loads 3, 2, 1 on one side, 2, 1 on the other
    std::multiset<int> loads;
    for (std::size_t k = 1; k < 6; ++k)
    {
        EXPECT_TRUE(near(12/m[k], std::round(12/m[k]), 1e-12));
        loads.insert(int(std::lround(12/m[k])));
    }
    EXPECT_EQ(loads, (std::multiset<int>{1, 1, 2, 2, 3}));
}


TEST(clusterMargins, twoFeetShareNothing)
{
    // two spheres, both on the wall and touching: each stands on its own foot
    ClusterGraph g;
    g.nodes = {{1, 1, Vec3(1, 0, 0)}, {2, 1, Vec3(0, 2, 0)}};
    g.bonds = {{1, -1, 6}, {2, -1, 6}, {1, 2, 1}};
    const std::vector<double> m = dem::clusterMargins(g);
    ASSERT_EQ(m.size(), 2u);
    EXPECT_TRUE(close(m[0], 6, 1e-12));
    EXPECT_TRUE(close(m[1], 3, 1e-12));

    // of two contacts with walls the stronger one counts
    g.bonds.push_back({1, -1, 9});
    EXPECT_TRUE(close(dem::clusterMargins(g)[0], 9, 1e-12));
}


TEST(clusterMargins, flyingPairCarriesTheDifferenceOfAccelerations)
{
    // masses m1, m2, forces F1, F2: the contact carries |m1 F2 - m2 F1|/(m1 + m2)
    ClusterGraph g;
    const Vec3 F1(1, 2, 0), F2(-3, 0, 5);
    g.nodes = {{4, 2, F1}, {9, 3, F2}};
    g.bonds = {{4, 9, 7}};
    std::vector<double> m = dem::clusterMargins(g);
    ASSERT_EQ(m.size(), 1u);
    EXPECT_TRUE(close(m[0], 7/((2*F2 - 3*F1).norm()/5), 1e-12));

    // pulled alike: nothing pulls them apart
    g.nodes[1].force = 1.5*F1;
    m = dem::clusterMargins(g);
    ASSERT_EQ(m.size(), 1u);
    EXPECT_GE(m[0], 1e15);

    // free spheres have no contact and no margin
    g.bonds.clear();
    EXPECT_TRUE(dem::clusterMargins(g).empty());
    EXPECT_TRUE(dem::clusterMargins({}).empty());
}
