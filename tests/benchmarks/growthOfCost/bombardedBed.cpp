// SPDX-License-Identifier: GPL-3.0-or-later
//
// One particle lands on N resting ones every 5 us: CPU time of a particle step of 1 us, and the
// memory of a resting particle.
//
//   bombardedBed deep N STEPS      a bed five layers deep
//   bombardedBed screen N STEPS    a deposit one layer thick
//   bombardedBed memory N          only the bed: bytes that each particle has added
//
// The bed is cubic, its spheres a little closer than where JKR's force is 0, on a plane, made as
// if it had come to rest there; it is as wide as N wants. They land on eight by eight of its
// spheres in the middle, whatever N is.
#include "DEM.hpp"

#include "contacts/ContactRecord.hpp"
#include "contacts/PackedState.hpp"
#include "foundation/Fields.hpp"
#include "clouds.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include <malloc.h>

namespace
{

constexpr double r = 2e-6, speed = 0.5;

//- What the packed state of one at rest says
std::vector<double> resting(const std::vector<dem::ContactRecord>& contacts, double pullOff)
{
    dem::RestState rest;
    rest.inContact = rest.resting = true;
    rest.wakeForce = 0.01*pullOff;
    rest.pullOff = pullOff;
    std::vector<double> state{double(dem::PackedState::version)};
    dem::pack(rest, state);
    for (const dem::ContactRecord& c : contacts) dem::pack(c, state);
    return state;
}

class Bed
{
public:

    Bed(int n, int layers)
    :
        system_(law_.table(), dem::TimeSettings{}),
        layers_(layers),
        edge_(std::max(1, int(std::lround(std::sqrt(double(n)/layers)))))
    {
        system_.setWalls(scene::floor());
        const double m = scene::sphere(law_, 0, r, dem::Vec3::Zero()).mass;
        const auto pair = system_.materials().figures(0, 0, r, r, m, m, 0);
        const auto wall = system_.materials().figures(0, 1, r, 0, m, 0, 0);
        pitch_ = 2*r - pair.delta0;
        ground_ = r - wall.delta0;
        pullOff_ = pair.pullOff;
    }

    dem::System& system() { return system_; }
    int size() const { return edge_*edge_*layers_; }

    void make()
    {
        for (int k = 0; k < size(); ++k) system_.add(scene::sphere(law_, k, r, at(k)));
        for (int k = 0; k < size(); ++k) system_.unpackState(std::size_t(k), resting(contacts(k), pullOff_));
    }

    //- The next one, high enough to be above those that have landed there
    void drop()
    {
        const auto place = [&](double ratio)
        {
            const double share = ratio*landed_ - std::floor(ratio*landed_);
            return pitch_*(0.5*(edge_ - 1) + 8*(share - 0.5));
        };
        const dem::Vec3 x
        (
            place(0.7548776662466927), place(0.5698402909980532),
            ground_ + pitch_*(layers_ + 5)
        );
        system_.add(scene::sphere(law_, size() + landed_, r, x, dem::Vec3(0, 0, -speed)));
        ++landed_;
    }

private:

    dem::Vec3 at(int k) const
    {
        return
        {
            pitch_*(k%edge_), pitch_*(k/edge_%edge_), ground_ + pitch_*(k/edge_/edge_)
        };
    }

    std::vector<dem::ContactRecord> contacts(int k) const
    {
        std::vector<dem::ContactRecord> result;
        const auto add = [&](std::int64_t j, int wall)
        {
            dem::ContactRecord c{j, wall, {0, 0, 0}, {}};
            if (wall >= 0) c.n[2] = -1;
            result.push_back(c);
        };
        const int i = k%edge_, j = k/edge_%edge_, l = k/edge_/edge_;
        if (l == 0) add(-1, 0);
        if (i + 1 < edge_) add(k + 1, -1);
        if (j + 1 < edge_) add(k + edge_, -1);
        if (l + 1 < layers_) add(k + edge_*edge_, -1);
        return result;
    }

    scene::Law law_ = scene::stickyLaw();
    dem::System system_;
    int layers_, edge_, landed_ = 0;
    double pitch_ = 0, ground_ = 0, pullOff_ = 0;
};

}


int main(int argc, char** argv)
{
    if (argc < 3) return 1;
    const std::string what = argv[1];
    Bed bed(std::atoi(argv[2]), what == "screen" ? 1 : 5);
    const auto before = mallinfo2();
    bed.make();
    const auto after = mallinfo2();
    dem::System& system = bed.system();
    const double bytes =
        double(after.uordblks + after.hblkhd - before.uordblks - before.hblkhd)/bed.size();
    for (int k = 0; k < 5; ++k) system.advance(1e-6);
    if (what == "memory" || argc < 4)
    {
        std::printf("particles %d bytesEach %.0f\n", bed.size(), bytes);
        return 0;
    }

    const int steps = std::atoi(argv[3]);
    dem::StepReport report, last;
    std::clock_t cpu = 0;
    for (int k = 0; k < steps; ++k)
    {
        if (k%5 == 0) bed.drop();
        const std::clock_t start = std::clock();
        last = system.advance(1e-6);
        cpu += std::clock() - start;
        report.add(last);
    }
    std::printf
    (
        "particles %d bytesEach %.0f steps %d cpu_s_per_step %.5g touches %ld wakes %ld "
        "repeats %ld contactUpdates %ld resting %ld\n",
        bed.size(), bytes, steps, double(cpu)/CLOCKS_PER_SEC/steps, long(report.touches),
        long(report.wakes), long(report.repeats), long(report.contactUpdates),
        long(last.resting)
    );
    return 0;
}
