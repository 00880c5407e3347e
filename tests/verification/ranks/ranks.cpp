// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same scene on several ranks and on one, bit by bit. See run.
#include "clouds.hpp"
#include "contacts/clusterMargins.hpp"

#include <map>

using dem::Communicator;
using dem::Vec3;

namespace
{

Communicator world() { return Communicator(MPI_COMM_WORLD); }

//- How the particles are scattered; none respects space
enum Scatter { byId, oneRankHasAll, mixed, byPlace };

int ownerOf(const dem::Particle& p, Scatter scatter, int size, int step = 0)
{
    switch (scatter)
    {
        case byId: return int(p.id%size);
        case oneRankHasAll: return size - 1;
        case byPlace: return p.x.x() > 0 ? size - 1 : 0;
        default:
            return scene::Random(unsigned(p.id) + 977u*unsigned(step)).below(size);
    }
}

//- Serial reference and scattered run side by side
class SideBySide
{
public:

    SideBySide(const scene::Law& law, const std::vector<dem::Particle>& dust, Scatter scatter)
    :
        law_(law),
        serial_(std::make_unique<dem::System>(law.table(), dem::TimeSettings())),
        parts_(std::make_unique<dem::System>(law.table(), dem::TimeSettings(), world())),
        scatter_(scatter)
    {
        serial_->keepGasExchange(true);
        parts_->keepGasExchange(true);
        serial_->setWalls(scene::floor());
        parts_->setWalls(scene::floor());
        for (const dem::Particle& p : dust)
        {
            serial_->add(p);
            if (mine(p, 0)) parts_->add(p);
        }
    }

    bool mine(const dem::Particle& p, int step) const
    {
        return ownerOf(p, scatter_, world().size(), step) == world().rank();
    }

    void advance(double dt, bool loaded = true)
    {
        if (loaded)
        {
            scene::load(*serial_);
            scene::load(*parts_);
        }
        report.add(serial_->advance(dt));
        own.add(parts_->advance(dt));
    }

    //- Every particle of this rank is where the serial run has it
    bool same() const
    {
        std::map<std::int64_t, std::size_t> at;
        for (std::size_t i = 0; i < serial_->size(); ++i) at[serial_->particle(i).id] = i;
        bool result = true;
        for (std::size_t i = 0; i < parts_->size(); ++i)
        {
            const std::size_t k = at[parts_->particle(i).id];
            const bool equal =
                scene::same(parts_->particle(i), serial_->particle(k))
             && parts_->gasExchange(i).impulse == serial_->gasExchange(k).impulse
             && parts_->gasExchange(i).response == serial_->gasExchange(k).response
             && parts_->resting(i) == serial_->resting(k)
             && parts_->inContact(i) == serial_->inContact(k);
            EXPECT_TRUE(equal) << "particle " << parts_->particle(i).id
                << " of rank " << world().rank();
            result = result && equal;
        }
        return !world().any(!result);
    }

    //- Give every particle to another rank, with all that is remembered of it
    void scatterAgain(int step)
    {
        std::vector<std::vector<double>> to(std::size_t(world().size()));
        std::vector<char> gone(parts_->size(), 0);
        for (std::size_t i = 0; i < parts_->size(); ++i)
        {
            const dem::Particle& p = parts_->particle(i);
            const int owner = ownerOf(p, scatter_, world().size(), step);
            if (owner == world().rank()) continue;
            const auto state = parts_->packState(i);
            auto& d = to[std::size_t(owner)];
            d.insert(d.end(), {double(p.id), p.radius, p.mass, double(state.size())});
            for (const Vec3* v : {&p.x, &p.v, &p.omega}) d.insert(d.end(), v->data(), v->data() + 3);
            d.insert(d.end(), state.begin(), state.end());
            gone[i] = 1;
        }
        parts_->remove(gone);
        for (const auto& d : world().exchange(to))
        {
            for (std::size_t k = 0; world().parallel() && k < d.size();)
            {
                dem::Particle p{std::int64_t(d[k]), 0, d[k + 1], d[k + 2], Vec3::Zero()};
                const std::size_t n = std::size_t(d[k + 3]);
                p.x = Vec3(d[k + 4], d[k + 5], d[k + 6]);
                p.v = Vec3(d[k + 7], d[k + 8], d[k + 9]);
                p.omega = Vec3(d[k + 10], d[k + 11], d[k + 12]);
                k += 13;
                const std::size_t i = parts_->add(p);
                parts_->unpackState
                (
                    i, {d.begin() + std::ptrdiff_t(k), d.begin() + std::ptrdiff_t(k + n)}
                );
                k += n;
            }
        }
    }

    //- Counts over all ranks
    double sum(double mine) const
    {
        double total = 0;
        for (const auto& d : world().allGather({mine})) total += d[0];
        return total;
    }

    const dem::System& serial() const { return *serial_; }
    dem::System& parts() { return *parts_; }
    dem::System& serial() { return *serial_; }

    dem::StepReport report, own;

private:

    scene::Law law_;
    std::unique_ptr<dem::System> serial_, parts_;
    Scatter scatter_;
};

//- Contacts in an order that does not depend on ranks
std::map<std::pair<std::int64_t, std::int64_t>, dem::ContactView>
byIds(const std::vector<dem::ContactView>& contacts)
{
    std::map<std::pair<std::int64_t, std::int64_t>, dem::ContactView> result;
    for (const auto& c : contacts) result[{c.idI, c.idJ}] = c;
    return result;
}

}


TEST(ranks, communicatorExchanges)
{
    const Communicator c = world();
    const int size = c.size(), rank = c.rank();
    ASSERT_EQ(c.parallel(), size > 1);

    // messages of different length to everybody, empty ones too
    std::vector<std::vector<double>> to(static_cast<std::size_t>(size));
    for (int r = 0; r < size; ++r)
    {
        to[std::size_t(r)].assign(std::size_t((rank + 2*r)%3), 10*rank + r);
    }
    const auto from = c.exchange(to);
    ASSERT_EQ(from.size(), std::size_t(size));
    for (int r = 0; r < size; ++r)
    {
        EXPECT_EQ
        (
            from[std::size_t(r)],
            std::vector<double>(std::size_t((r + 2*rank)%3), 10*r + rank)
        );
    }

    std::vector<double> mine(std::size_t(rank + 1), rank);
    const auto all = c.allGather(mine);
    ASSERT_EQ(all.size(), std::size_t(size));
    for (int r = 0; r < size; ++r)
    {
        EXPECT_EQ(all[std::size_t(r)], std::vector<double>(std::size_t(r + 1), r));
    }
    const auto gathered = c.gather(mine);
    for (int r = 0; r < size; ++r)
    {
        const auto& g = gathered[std::size_t(r)];
        EXPECT_EQ(g, rank == 0 ? all[std::size_t(r)] : std::vector<double>());
    }
    EXPECT_EQ(c.max(rank - 5.5), size - 6.5);
    EXPECT_TRUE(c.any(rank == size - 1));
    EXPECT_FALSE(c.any(false));
}


TEST(ranks, rainOnAFloor)
{
    for (const Scatter scatter : {byId, oneRankHasAll, mixed, byPlace})
    {
        SCOPED_TRACE("scatter " + std::to_string(scatter));
        const scene::Law law = scene::stickyLaw();
        SideBySide run(law, scene::rain(law, 80, 6e-6, 71), scatter);
        for (int step = 0; step < 40; ++step)
        {
            run.advance(1e-6);
            ASSERT_TRUE(run.same()) << "step " << step;
        }
        // what was done is the same, whoever did it
        EXPECT_EQ(run.sum(double(run.own.contactSteps)), double(run.report.contactSteps));
        EXPECT_EQ(run.sum(double(run.own.islands)), double(run.report.islands));
        EXPECT_EQ(run.sum(double(run.own.touches)), double(run.report.touches));
        EXPECT_EQ(run.sum(double(run.own.sleeps)), double(run.report.sleeps));
        EXPECT_EQ(run.sum(double(run.own.resting)), double(run.report.resting));
        EXPECT_GT(run.report.touches, 50);
        EXPECT_GT(run.report.sleeps, 0);

        // contacts: the same, each on the rank that owns its lower id
        const auto whole = byIds(run.serial().contacts());
        const auto parts = run.parts().contacts();
        EXPECT_EQ(run.sum(double(parts.size())), double(whole.size()));
        EXPECT_GT(whole.size(), 30u);
        int across = 0;
        std::map<std::int64_t, bool> here;
        for (std::size_t i = 0; i < run.parts().size(); ++i) here[run.parts().particle(i).id] = true;
        for (const dem::ContactView& v : parts)
        {
            EXPECT_TRUE(here.count(v.idI));
            across += v.idJ >= 0 && !here.count(v.idJ);
            const auto found = whole.find({v.idI, v.idJ});
            ASSERT_NE(found, whole.end());
            EXPECT_EQ(v.force, found->second.force);
            EXPECT_EQ(v.overlap, found->second.overlap);
        }
        const double everywhere = run.sum(across);
        EXPECT_TRUE(!world().parallel() || scatter != byId || everywhere > 0);

        // clusters and margins
        std::map<std::int64_t, dem::ClusterLabel> label;
        const auto labels = run.serial().clusters();
        for (std::size_t i = 0; i < labels.size(); ++i)
        {
            label[run.serial().particle(i).id] = labels[i];
        }
        const auto own = run.parts().clusters();
        for (std::size_t i = 0; i < own.size(); ++i)
        {
            const dem::ClusterLabel& l = label[run.parts().particle(i).id];
            EXPECT_EQ(own[i].root, l.root);
            EXPECT_EQ(own[i].onWall, l.onWall);
        }
        const auto margins = run.parts().adhesionMargins();
        const auto expected = run.serial().adhesionMargins();
        EXPECT_EQ(margins, world().rank() == 0 ? expected : std::vector<double>());
    }
}


TEST(ranks, particlesChangeHandsOnTheWay)
{
    const scene::Law law = scene::stickyLaw();
    SideBySide run(law, scene::rain(law, 80, 6e-6, 72), mixed);
    for (int step = 0; step < 40; ++step)
    {
        if (step%3 == 2) run.scatterAgain(step);
        run.advance(1e-6);
        ASSERT_TRUE(run.same()) << "step " << step;
    }
    EXPECT_GT(run.report.sleeps, 0);
    EXPECT_EQ(run.sum(double(run.own.touches)), double(run.report.touches));
}


TEST(ranks, collisionsInFlightAcrossRanks)
{
    // fast and far apart: long steps, islands that span ranks without a contact between them
    const scene::Law law = scene::stickyLaw();
    SideBySide run(law, scene::rain(law, 60, 40e-6, 73), byId);
    for (int step = 0; step < 12; ++step)
    {
        run.advance(2e-5, step%2);
        ASSERT_TRUE(run.same()) << "step " << step;
    }
    EXPECT_GT(run.report.touches, 20);
    EXPECT_GT(run.report.freeFlights, 0);
}


TEST(ranks, clusterGraphsJoin)
{
    // a chain whose links lie on all ranks in turn
    dem::ClusterGraph g;
    const Communicator c = world();
    const int n = 12;
    for (int k = 0; k < n; ++k)
    {
        if (k%c.size() != c.rank()) continue;
        g.nodes.push_back({k, 1, Vec3(1, 0, 0)});
        g.bonds.push_back({k, k + 1 < n ? k + 1 : -1, 24});
    }
    const dem::ClusterGraph all = g.everywhere(c);
    ASSERT_EQ(all.nodes.size(), std::size_t(n));
    const auto margins = dem::clusterMargins(all);
    for (int k = 0; k < n; ++k)
    {
        // the last one stands on the wall: sphere k carries those below k, too
        EXPECT_TRUE(scene::close(margins[std::size_t(k)], 24.0/(k + 1), 1e-12));
    }
    EXPECT_EQ(g.gathered(c).nodes.size(), c.rank() == 0 ? std::size_t(n) : 0u);
}


int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    ::testing::InitGoogleTest(&argc, argv);
    int failed = RUN_ALL_TESTS();
    int any = 0;
    MPI_Allreduce(&failed, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return any;
}
