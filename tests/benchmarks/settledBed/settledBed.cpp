// SPDX-License-Identifier: GPL-3.0-or-later
//
// A settled adhesive bed, periodic in x and y, on a plane: contact updates per CPU second.
//
//   settledBed write NX NY FILE     write the bed as a LAMMPS data file (units micro)
//   settledBed run NX NY STEPS [mixed]
//                                   take about STEPS contact steps with nothing at rest;
//                                   mixed: several sizes and materials
//   settledBed rest NX NY           let it come to rest, then time steps of the resting bed
//
// bed.xyz holds 2,000 spheres of radius 5 um in a cell of 28 radii (um), chi = 0.026.
#include "DEM.hpp"
#include "contactModels/contactModel/ContactLaw.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace
{

constexpr double radius = 5e-6, density = 1000, cell = 28*radius;
constexpr double chi = 0.026, youngsModulus = 3.8e9, gammaReal = 0.05;

std::vector<dem::Vec3> bed(int nx, int ny)
{
    std::ifstream file("bed.xyz");
    std::vector<dem::Vec3> one, all;
    for (double x, y, z; file >> x >> y >> z;)
    {
        dem::Vec3 p = 1e-6*dem::Vec3(x, y, z);
        p.x() -= cell*std::floor(p.x()/cell);
        p.y() -= cell*std::floor(p.y()/cell);
        one.push_back(p);
    }
    for (int i = 0; i < nx; ++i)
    {
        for (int j = 0; j < ny; ++j)
        {
            for (const dem::Vec3& p : one) all.push_back(p + dem::Vec3(i*cell, j*cell, 0));
        }
    }
    return all;
}

void write(int nx, int ny, const char* name)
{
    const auto x = bed(nx, ny);
    double top = 0;
    for (const auto& p : x) top = std::max(top, p.z());
    std::FILE* f = std::fopen(name, "w");
    std::fprintf(f, "settled bed\n\n%zu atoms\n1 atom types\n\n", x.size());
    std::fprintf
    (
        f, "0 %.9g xlo xhi\n0 %.9g ylo yhi\n-1 %.9g zlo zhi\n\nAtoms\n\n",
        nx*cell*1e6, ny*cell*1e6, top*1e6 + 20
    );
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        const dem::Vec3 p = 1e6*x[k];
        std::fprintf
        (
            f, "%zu 1 10 1 %.12g %.12g %.12g\n", k + 1, p.x(), p.y(), p.z()
        );
    }
    std::fclose(f);
}

dem::MaterialTable materials()
{
    dem::ContactSettings s;
    s.normal = {"JKR", {{"dampingCoefficient", 0.178}}};
    s.tangential = {"springDashpotSlider", {{"friction", 0.3}}};
    s.rolling = {"springSlider", {{"criticalAngle", 0.0085}}};
    s.twisting = {"springDashpotSlider", {}};
    dem::ReducedStiffness soft;
    soft.ratio = chi;
    return dem::MaterialTable
    (
        {
            {"dust", density, youngsModulus, 0.33, gammaReal},
            {"ash", 1.2*density, 1.3*youngsModulus, 0.25, 0.8*gammaReal},
            {"floor", 0, youngsModulus, 0.33, gammaReal}
        },
        s, {}, soft
    );
}

}


int main(int argc, char** argv)
{
    if (argc < 4) return 1;
    const std::string what = argv[1];
    const int nx = std::atoi(argv[2]), ny = std::atoi(argv[3]);
    if (what == "write") { write(nx, ny, argv[4]); return 0; }
    const bool mixed = argc > 5 && std::string(argv[5]) == "mixed";

    dem::TimeSettings time;
    time.restTolerance = what == "rest" ? 1 : 0;
    dem::System system(materials(), time);
    dem::Walls walls;
    walls.patches.push_back({"floor", 2});
    walls.planes.push_back({dem::Vec3::Zero(), dem::Vec3::UnitZ(), 0});
    system.setWalls(walls);
    dem::Periodic periodic;
    periodic.length = dem::Vec3(nx*cell, ny*cell, 0);
    system.setPeriodic(periodic);

    std::int64_t id = 0;
    for (const dem::Vec3& x : bed(nx, ny))
    {
        // sizes within 0.3 % leave the contacts as they are: more would break the packing
        const double r = mixed ? radius*(1 + 0.003*std::sin(double(id))) : radius;
        const int material = mixed && id%2 ? 1 : 0;
        const double rho = material ? 1.2*density : density;
        system.add({id, material, r, rho*4/3*M_PI*r*r*r, x});
        ++id;
    }

    const double m = density*4/3*M_PI*radius*radius*radius;
    const double step =
        system.materials().figures(0, 0, radius, radius, m, m, 0).period
       /time.stepsPerContact;

    if (what == "rest")
    {
        // settle, then time the resting bed
        for (int k = 0; k < 400; ++k) system.advance(1e-6);
        const std::clock_t start = std::clock();
        dem::StepReport report;
        for (int k = 0; k < 10; ++k) report.add(system.advance(1e-5));
        const double cpu = double(std::clock() - start)/CLOCKS_PER_SEC;
        std::printf
        (
            "resting %ld of %zu contactUpdates %ld cpu_s_per_ms %.4g\n",
            long(report.resting), system.size(), long(report.contactUpdates), cpu/0.1
        );
        return 0;
    }

    const int steps = std::atoi(argv[4]);
    system.advance(0.1*steps*step);     // warm
    const std::clock_t start = std::clock();
    const dem::StepReport report = system.advance(steps*step);
    const double cpu = double(std::clock() - start)/CLOCKS_PER_SEC;
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    const dem::ContactLaw& law = *system.materials().laws()[0];
    std::printf
    (
        "particles %zu contactUpdates %ld cpu_s %.4g updates_per_s %.5g memory "
        "peak %.0f B per particle; contact: %d constants, %d history values, %zu B in the kernel\n",
        system.size(), long(report.contactUpdates), cpu, report.contactUpdates/cpu,
        1024.0*double(usage.ru_maxrss)/double(system.size()),
        law.nConstants(), law.nHistory(), 8*std::size_t(law.nConstants() + law.nHistory() + 1) + 13
    );
    return 0;
}
