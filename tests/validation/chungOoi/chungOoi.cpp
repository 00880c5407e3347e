// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two glass spheres of 10 mm radius meet at +-10 m/s without damping (Chung & Ooi 2011,
// test 1): force at the overlaps of the published loading curve. See run.
#include "scene.hpp"

#include <fstream>
#include <iostream>
#include <sstream>

int main(int argc, char** argv)
{
    if (argc != 3)
    {
        std::cerr << "usage: tests PUBLISHED.csv LOADING.csv\n";
        return 1;
    }

    std::vector<std::pair<double, double>> published;   // m, N
    std::ifstream in(argv[1]);
    for (std::string line; std::getline(in, line);)
    {
        std::istringstream s(line);
        double overlap, force;
        char comma;
        if (s >> overlap >> comma >> force) published.emplace_back(1e-6*overlap, 1e3*force);
    }

    // E = 48 GPa, nu = 0.2, rho = 2800 kg/m3
    const dem::MaterialTable table
    (
        {{"glass", 2800, 48e9, 0.2, 0}},
        {{"Hertz", {{"restitution", 1}}}, {}, {}, {}, {}, {}}, {}, {}
    );
    dem::TimeSettings time;
    time.stepsPerContact = 200;
    time.restTolerance = 0;
    dem::System system(table, time);
    const double r = 10e-3, mass = 2800*4.0/3.0*formula::pi*r*r*r;
    system.add({1, 0, r, mass, dem::Vec3(-r, 0, 0), dem::Vec3(10, 0, 0)});
    system.add({2, 0, r, mass, dem::Vec3(r, 0, 0), dem::Vec3(-10, 0, 0)});

    std::ofstream out(argv[2]);
    out << "overlap_m,force_N\n";
    std::vector<std::pair<double, double>> loading{{0, 0}};
    double peak = 0;
    for (int k = 0; k < 4000 && (k == 0 || system.inContact(0)); ++k)
    {
        system.advance(2e-8);
        for (const dem::ContactView& c : system.contacts())
        {
            if (c.overlap <= loading.back().first) continue;
            loading.emplace_back(c.overlap, -c.force.x());
            out << c.overlap << ',' << -c.force.x() << '\n';
        }
        peak = std::max(peak, loading.back().second);
    }

    double worst = 0;
    for (const auto& p : published)
    {
        // beyond the greatest overlap reached: compare there
        std::size_t k = 1;
        while (k + 1 < loading.size() && loading[k].first < p.first) ++k;
        const auto &a = loading[k - 1], &b = loading[k];
        const double share = (p.first - a.first)/(b.first - a.first);
        worst = std::max(worst, std::fabs(a.second + share*(b.second - a.second) - p.second));
    }
    std::cout
        << "worst_force_over_peak " << worst/peak << "\n"
        << "peak_force_kN " << 1e-3*peak << "\n"
        << "peak_overlap_um " << 1e6*loading.back().first << "\n";
    return published.size() < 10;
}
