// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who moves and who rests, and that those at rest are found, against looking at all of them.
#include "system/RestIndex.hpp"

#include "clouds.hpp"

#include <set>

using dem::Vec3;

namespace
{

//- The same by looking at all
struct Plain
{
    std::vector<char> rests;
    std::vector<Vec3> x;
    std::vector<double> size;

    std::set<std::size_t> near(const dem::Box& box, const dem::Periodic& periodic) const
    {
        std::set<std::size_t> found;
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            if (!rests[i]) continue;
            dem::periodicImages(dem::Box{x[i].array() - size[i], x[i].array() + size[i]}, periodic,
                [&](const dem::Box& image) { if (image.overlaps(box)) found.insert(i); });
        }
        return found;
    }
};

void compare(const dem::RestIndex& index, const Plain& plain, const dem::Periodic& periodic, scene::Random& random)
{
    std::vector<std::size_t> awake;
    for (std::size_t i = 0; i < plain.x.size(); ++i)
    {
        EXPECT_EQ(index.resting(i), bool(plain.rests[i]));
        if (!plain.rests[i]) awake.push_back(i);
    }
    EXPECT_EQ(index.awake(), awake);
    EXPECT_EQ(index.nResting(), plain.x.size() - awake.size());
    EXPECT_EQ(index.anyAwake(), !awake.empty());
    for (int k = 0; k < 20; ++k)
    {
        const Vec3 low = Vec3(0.5, 0.5, 0.5) + random.inBox(0.6);
        const dem::Box box{low, low + Vec3(0.2, 0.02, 0.1)};
        std::set<std::size_t> found;
        index.near(box, periodic, [&](std::size_t i)
        {
            EXPECT_TRUE(plain.rests[i]);
            found.insert(i);
        });
        for (const std::size_t i : plain.near(box, periodic)) EXPECT_TRUE(found.count(i)) << i;
    }
}

}


TEST(restIndex, findsAllAtRestWhateverComesGoesAndIsRemoved)
{
    for (const bool periodicBox : {false, true})
    {
        dem::Periodic periodic;
        if (periodicBox) periodic.length = Vec3(1, 1, 0);
        scene::Random random(4);
        dem::RestIndex index;
        Plain plain;
        for (int round = 0; round < 30; ++round)
        {
            for (int k = 0; k < 40; ++k)
            {
                index.add();
                plain.rests.push_back(0);
                plain.x.push_back(Vec3(0.5, 0.5, 0.5) + random.inBox(0.5));
                plain.size.push_back(random.uniform(1e-3, 2e-2));
            }
            for (std::size_t i = 0; i < plain.x.size(); ++i)
            {
                const double lot = random.uniform(0, 1);
                if (lot < 0.3)
                {
                    // where it rests already, or elsewhere
                    if (lot < 0.1) plain.x[i] = Vec3(0.5, 0.5, 0.5) + random.inBox(0.5);
                    index.rests(i, plain.x[i], plain.size[i]);
                    plain.rests[i] = 1;
                }
                else if (lot < 0.5)
                {
                    index.moves(i);
                    plain.rests[i] = 0;
                    plain.x[i] = Vec3(0.5, 0.5, 0.5) + random.inBox(0.5);
                }
            }
            compare(index, plain, periodic, random);
            std::vector<char> marked(plain.x.size());
            Plain left;
            for (std::size_t i = 0; i < marked.size(); ++i)
            {
                marked[i] = random.uniform(0, 1) < (round == 20 ? 1.1 : 0.2);
                if (marked[i]) continue;
                left.rests.push_back(plain.rests[i]);
                left.x.push_back(plain.x[i]);
                left.size.push_back(plain.size[i]);
            }
            index.remove(marked);
            plain = left;
            compare(index, plain, periodic, random);
        }
    }
}


TEST(restIndex, manyAtOnePlaceAndOneVeryFarAway)
{
    dem::RestIndex index;
    for (std::size_t i = 0; i < 50; ++i)
    {
        index.add();
        index.rests(i, i == 49 ? Vec3(1e9, 0, 0) : Vec3(1e-6, 0, 0), 1e-6);
    }
    int found = 0;
    index.near({Vec3::Zero(), Vec3::Zero()}, {}, [&](std::size_t) { ++found; });
    EXPECT_EQ(found, 49);
    for (std::size_t i = 0; i < 50; ++i) index.moves(i);
    EXPECT_EQ(index.nResting(), 0u);
}
