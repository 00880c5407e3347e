// SPDX-License-Identifier: GPL-3.0-or-later
//
// A dilute cloud of spheres flying in all directions in a periodic box (solid fraction
// 1e-4, 1.5 m/s): CPU time per simulated millisecond, nearly all of it without a contact.
//
//   freeCloud write N FILE          write it as a LAMMPS data file (units micro)
//   freeCloud run N TIME_s [exact]  move it over TIME in particle steps of 20 us
#include "DEM.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <random>

namespace
{

constexpr double radius = 5e-6, density = 1000, speed = 1.5;

double boxOf(int n) { return std::cbrt(n*4/3*M_PI*radius*radius*radius/1e-4); }

}


int main(int argc, char** argv)
{
    if (argc < 4) return 1;
    const int n = std::atoi(argv[2]);
    const double length = boxOf(n);

    dem::ContactSettings s;
    s.normal = {"JKR", {{"dampingCoefficient", 0.178}}};
    s.tangential = {"springDashpotSlider", {{"friction", 0.3}}};
    s.rolling = {"springSlider", {{"criticalAngle", 0.0085}}};
    s.twisting = {"springDashpotSlider", {}};
    dem::TimeSettings time;
    time.islands = argc < 5;
    dem::System system
    (
        dem::MaterialTable({{"dust", density, 3.8e9, 0.33, 0.05}}, s, {}, {}), time
    );
    dem::Periodic periodic;
    periodic.length = dem::Vec3::Constant(length);
    system.setPeriodic(periodic);

    // on a jittered lattice, so that none overlap
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    const int edge = int(std::ceil(std::cbrt(double(n))));
    const double pitch = length/edge;
    const double m = density*4/3*M_PI*radius*radius*radius;
    std::FILE* file = std::strcmp(argv[1], "write") ? nullptr : std::fopen(argv[3], "w");
    if (file)
    {
        std::fprintf(file, "free cloud\n\n%d atoms\n1 atom types\n\n", n);
        for (const char* axis : {"x", "y", "z"})
        {
            std::fprintf(file, "0 %.9g %slo %shi\n", 1e6*length, axis, axis);
        }
        std::fprintf(file, "\nAtoms\n\n");
    }
    std::vector<dem::Vec3> velocities;
    for (int k = 0; k < n; ++k)
    {
        const double room = pitch - 2.02*radius;
        dem::Vec3 x(k%edge, k/edge%edge, k/edge/edge), v;
        x *= pitch;
        for (int d = 0; d < 3; ++d) x[d] += 1.01*radius + room*uniform(random);
        do
        {
            for (int d = 0; d < 3; ++d) v[d] = 2*uniform(random) - 1;
        } while (v.norm() > 1 || v.norm() < 0.01);
        v *= speed/v.norm();
        velocities.push_back(v);
        if (file)
        {
            std::fprintf
            (
                file, "%d 1 10 1 %.12g %.12g %.12g\n", k + 1, 1e6*x[0], 1e6*x[1], 1e6*x[2]
            );
        }
        else
        {
            system.add({k, 0, radius, m, x, v});
        }
    }
    if (file)
    {
        std::fprintf(file, "\nVelocities\n\n");
        for (int k = 0; k < n; ++k)
        {
            const dem::Vec3& v = velocities[std::size_t(k)];
            std::fprintf(file, "%d %.12g %.12g %.12g 0 0 0\n", k + 1, v[0], v[1], v[2]);
        }
        std::fclose(file);
        return 0;
    }

    const double total = std::atof(argv[3]);
    const int steps = std::max(1, int(std::lround(total/2e-5)));
    const std::clock_t start = std::clock();
    dem::StepReport report;
    for (int k = 0; k < steps; ++k) report.add(system.advance(total/steps));
    const double cpu = double(std::clock() - start)/CLOCKS_PER_SEC;
    double energy = 0;
    for (std::size_t i = 0; i < system.size(); ++i)
    {
        energy += system.particle(i).v.squaredNorm();
    }
    std::printf
    (
        "particles %d touches %ld separations %ld energy %.9g cpu_s %.4g cpu_s_per_ms %.5g\n",
        n, long(report.touches), long(report.separations),
        energy/n/(speed*speed), cpu, cpu/(1e3*total)
    );
    return 0;
}
