// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a scene does not need costs nothing: CPU time per contact and bytes per contact of the
// settled bed (tests/benchmarks/settledBed) with parts and features left out.
//
//   sceneCost NX NY STEPS           writes a CSV
#include "DEM.hpp"
#include "contactModels/contactModel/ContactLaw.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace
{

constexpr double radius = 5e-6, density = 1000, cell = 28*radius;

struct Scene
{
    const char* name;
    const char* normal = "JKR";
    bool sliding = true, rolling = true, twisting = true;
    bool materials = false, sizes = false, gas = false, ledger = false;
};

struct Cost { double ns; int constants, history; };

Cost run(const Scene& scene, int nx, int ny, int steps)
{
    dem::ContactSettings s;
    s.normal = {scene.normal, {{"restitution", 0.7}}};
    if (scene.sliding) s.tangential = {"springDashpotSlider", {{"friction", 0.3}}};
    if (scene.rolling) s.rolling = {"springSlider", {{"criticalAngle", 0.0085}}};
    if (scene.twisting) s.twisting = {"springDashpotSlider", {}};
    dem::ReducedStiffness soft;
    soft.ratio = 0.026;
    const double gamma = 0.05;
    dem::TimeSettings time;
    time.restTolerance = 0;
    time.energyLedger = scene.ledger;
    dem::System system
    (
        dem::MaterialTable
        (
            {
                {"dust", density, 3.8e9, 0.33, gamma},
                {"ash", density, 1.3*3.8e9, 0.25, 0.8*gamma},
                {"floor", 0, 3.8e9, 0.33, gamma}
            },
            s, {}, soft
        ),
        time
    );
    dem::Walls walls;
    walls.patches.push_back({"floor", 2});
    walls.planes.push_back({dem::Vec3::Zero(), dem::Vec3::UnitZ(), 0});
    system.setWalls(walls);
    dem::Periodic periodic;
    periodic.length = dem::Vec3(nx*cell, ny*cell, 0);
    system.setPeriodic(periodic);

    std::ifstream file("bed.xyz");
    std::vector<dem::Vec3> one;
    for (double x, y, z; file >> x >> y >> z;)
    {
        dem::Vec3 p = 1e-6*dem::Vec3(x, y, z);
        for (int d = 0; d < 2; ++d) p[d] -= cell*std::floor(p[d]/cell);
        one.push_back(p);
    }
    std::int64_t id = 0;
    dem::GasLoad drag;
    drag.Sp = 3*M_PI*1.8e-5*2*radius;
    for (int i = 0; i < nx; ++i)
    {
        for (int j = 0; j < ny; ++j)
        {
            for (const dem::Vec3& p : one)
            {
                const double r = scene.sizes ? radius*(1 + 0.003*std::sin(double(id))) : radius;
                const int material = scene.materials ? int(id%2) : 0;
                system.add
                (
                    {id, material, r, density*4/3*M_PI*r*r*r, p + dem::Vec3(i*cell, j*cell, 0)}
                );
                if (scene.gas) system.setGasLoad(std::size_t(id), drag);
                ++id;
            }
        }
    }
    const double m = density*4/3*M_PI*radius*radius*radius;
    const double step =
        system.materials().figures(0, 0, radius, radius, m, m, 0.01).period/time.stepsPerContact;
    system.advance(0.1*steps*step);
    const std::clock_t start = std::clock();
    const dem::StepReport report = system.advance(steps*step);
    const double cpu = double(std::clock() - start)/CLOCKS_PER_SEC;
    const dem::ContactLaw& law = *system.materials().laws()[0];
    return {1e9*cpu/double(report.contactUpdates), law.nConstants(), law.nHistory()};
}

}


int main(int argc, char** argv)
{
    if (argc < 4) return 1;
    const int nx = std::atoi(argv[1]), ny = std::atoi(argv[2]), steps = std::atoi(argv[3]);
    std::vector<Scene> scenes(11);
    scenes[0].name = "all_resistances";
    scenes[1].name = "no_twisting";
    scenes[1].twisting = false;
    scenes[2].name = "no_rolling";
    scenes[2].rolling = false;
    scenes[3].name = "frictionless";
    scenes[3].sliding = scenes[3].twisting = false;
    scenes[4].name = "normal_force_only";
    scenes[4].sliding = scenes[4].rolling = scenes[4].twisting = false;
    scenes[5].name = "DMT_instead_of_JKR";
    scenes[5].normal = "DMT";
    scenes[6].name = "two_materials";
    scenes[6].materials = true;
    scenes[7].name = "many_sizes";
    scenes[7].sizes = true;
    scenes[8].name = "two_materials_many_sizes";
    scenes[8].materials = scenes[8].sizes = true;
    scenes[9].name = "gas_drag";
    scenes[9].gas = true;
    scenes[10].name = "energy_ledger";
    scenes[10].ledger = true;

    // rounds one after the other, so that a slow moment of the machine meets all alike
    constexpr int rounds = 3;
    std::vector<std::vector<double>> times(scenes.size());
    std::vector<Cost> last(scenes.size());
    for (int k = 0; k < rounds; ++k)
    {
        for (std::size_t i = 0; i < scenes.size(); ++i)
        {
            last[i] = run(scenes[i], nx, ny, steps);
            times[i].push_back(last[i].ns);
        }
    }
    double whole = 0;
    std::printf("scene,time_over_all_resistances,constants_B,history_B\n");
    for (std::size_t i = 0; i < scenes.size(); ++i)
    {
        std::sort(times[i].begin(), times[i].end());
        const double median = times[i][rounds/2];
        if (i == 0) whole = median;
        std::printf
        (
            "%s,%.3f,%d,%d\n", scenes[i].name, median/whole, 8*last[i].constants,
            8*last[i].history
        );
    }
    return 0;
}
