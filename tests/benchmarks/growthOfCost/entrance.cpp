// SPDX-License-Identifier: GPL-3.0-or-later
//
// CPU time per new sphere that asks for room and enters, with n spheres there of which the new
// ones of a particle step are a hundredth: as in a duct that is filled in a hundred steps.
//     entrance N
#include "scene.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>

using dem::Vec3;

int main(int, char** argv)
{
    const int n = std::atoi(argv[1]);
    const int side = int(std::ceil(std::cbrt(double(n))));
    const double r = 4e-6, apart = 40e-6, dt = 1e-5;
    const scene::Law law;
    dem::System system(law.table(), {});
    for (int i = 0; i < n; ++i)
    {
        const Vec3 x(i/side/side + 1, i/side%side, i%side);
        system.add(scene::sphere(law, i, r, apart*x, Vec3(1, 0, 0)));
    }

    // new ones at x = 0, at most 2 r of the lattice's plane away
    scene::Random random(1);
    const dem::Box inlet{Vec3(0, 0, 0), Vec3(r, side*apart, side*apart)};
    const int fresh = std::max(n/100, 1), repeats = std::max(1, 100000/n);
    long asked = 0, free = 0;
    const std::clock_t start = std::clock();
    for (int k = 0; k < repeats; ++k)
    {
        dem::Entrance entrance = system.entrance(inlet, dt, r, 1);
        for (int i = 0; i < fresh; ++i)
        {
            const Vec3 x(r, inlet.high[1]*random.uniform(), inlet.high[2]*random.uniform());
            const double delay = dt*i/fresh;
            std::string wall;
            ++asked;
            if (entrance.overlap(x, r, delay, wall) >= 0) continue;
            ++free;
            entrance.enter(x, Vec3(1, 0, 0), r, delay);
        }
    }
    const double seconds = double(std::clock() - start)/CLOCKS_PER_SEC;
    std::printf
    (
        "spheres %d asked %ld free %ld us_per_sphere %.4g\n", n, asked, free,
        1e6*seconds/double(asked)
    );
    return free > 0 ? 0 : 1;
}
