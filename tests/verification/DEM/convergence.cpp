// SPDX-License-Identifier: GPL-3.0-or-later
//
// Order of convergence in the contact step, 20 to 1000 steps per contact, against an
// independent integration of high order; error and run time as a table (convergence.csv).
//
// The scheme is of second order for every law, though the forces are not smooth: the dashpot
// of all laws but JKR, proportional to overlap^(1/4), and the end of JKR's neck have an
// infinite slope, and the force jumps by F_C at touch and at the end. With equal steps these
// give the orders 5/4, 3/2 and 1; the integrator grades its steps there (see its header).
#include "impact.hpp"

#include <chrono>
#include <fstream>

using scene::Law;
using dem::Vec3;

namespace
{

constexpr double r = 1e-6;

const double stepCounts[] = {20, 35, 50, 100, 200, 500, 1000};

//- After an impact on a wall with a sliding spring that holds
struct Oblique
{
    double normalSpeed, tangentialSpeed, spin;  // after
};

Oblique exactOblique(const Law& law, double vn, double vt, double spin)
{
    const formula::Contact c = law.contact(r, -1);
    const double inertia = 0.4*c.m*r*r;
    const bool jkr = law.normal == "JKR";
    const double end = formula::endOverlap(law.normal, c);
    const double ratio = std::sqrt(8*c.G/(2*c.E));
    formula::Ode<5> ode;    // overlap, closing speed, tangential speed, spin, spring
    ode.rate = [&](double, const std::array<double, 5>& y)
    {
        const formula::Normal n =
            formula::normal(law.normal, c, std::max(y[0], end), law.restitution);
        const double eta = (jkr ? 1 : ratio)*n.damping;
        const double slip = y[2] - r*y[3];
        const double force = law.friction > 0 ? -8*c.G*n.radius*y[4] - eta*slip : 0;
        return std::array<double, 5>
        {
            y[1], -(n.force + n.damping*y[1])/c.m, force/c.m, -r*force/inertia, slip
        };
    };
    const double peak = std::pow(15.0/16.0*c.m*vn*vn/(c.E*std::sqrt(r)), 0.4) + c.delta0();
    ode.scale = {peak, vn, vn, vn/r, peak};
    std::array<double, 5> y{0, vn, vt, spin, 0};
    const double time = 3*peak/vn;
    ode.solve(y, 0, 10*time, 1e-6*time, [&](const auto& z) { return z[1] < 0 && z[0] < end; });
    return {-y[1], y[2], y[3]};
}

Law lawOf(const std::string& normal, double restitution)
{
    Law law;
    law.normal = normal;
    law.restitution = restitution;
    // friction that always holds; without 2 F_C in its limit it cannot at first touch
    if (normal == "JKR" || normal == "simplifiedJKR") law.friction = 10;
    if (normal == "Hertz") law.gamma = 0;
    return law;
}

//- Slope of log(error) over log(steps) between two rows
double order(const std::vector<double>& errors, std::size_t first, std::size_t last)
{
    return
       -std::log(errors[last]/errors[first])
       /std::log(stepCounts[last]/stepCounts[first]);
}

}


TEST(convergence, orderOfEveryLaw)
{
    std::ofstream csv("convergence.csv");
    csv << "law,restitution,steps,error_normal,error_tangential,runTime_ratio\n";
    const double vn = 8, vt = 3, spin = -2e5;
    for (const char* normal : {"Hertz", "simplifiedJKR", "JKR", "DMT"})
    {
        for (const double e : {1.0, 0.7})
        {
            SCOPED_TRACE(std::string(normal) + " restitution " + scene::text(e));
            const Law law = lawOf(normal, e);
            const Oblique exact = exactOblique(law, vn, vt, spin);
            std::vector<double> errorN, errorT, seconds;
            scene::impact(law, r, 1.0, 100);    // so that the first row is timed alike
            for (const double steps : stepCounts)
            {
                // mean over impacts a little different, so that no error vanishes by chance
                double sumN = 0, sumT = 0;
                const int samples = 9;
                const auto start = std::chrono::steady_clock::now();
                for (int k = 0; k < samples; ++k)
                {
                    const double s = steps*(1 + 0.02*k);
                    const scene::Impact i = scene::impact
                    (
                        law, r, Vec3(vt, 0, -vn), Vec3(0, spin, 0), s
                    );
                    ASSERT_TRUE(i.left);
                    sumN += std::pow(i.v.z() - exact.normalSpeed, 2);
                    sumT += std::pow(i.v.x() - exact.tangentialSpeed, 2);
                }
                seconds.push_back
                (
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()
                );
                errorN.push_back(std::sqrt(sumN/samples)/vn);
                errorT.push_back(std::sqrt(sumT/samples)/vn);
                csv << normal << ',' << e << ',' << steps << ',' << errorN.back() << ','
                    << errorT.back() << ',' << seconds.back()/seconds[0] << '\n';
                std::printf
                (
                    "%s,%g,%g,%.3e,%.3e,%.2f\n", normal, e, steps, errorN.back(),
                    errorT.back(), seconds.back()/seconds[0]
                );
            }
            // from 50 steps on, and from 200 on
            const double first = order(errorN, 2, 6), last = order(errorN, 4, 6);
            std::printf("# %s %g: order %.2f, at last %.2f", normal, e, first, last);
            // undamped, parts of unlike sign make the error small at 50 steps by chance
            EXPECT_GT(first, e == 1 ? 1.8 : 1.9);
            EXPECT_GT(last, 1.9);
            EXPECT_LT(errorN[2], 3e-4);     // at 50 steps, where users run
            EXPECT_LT(errorN[6], 1e-6);

            if (law.friction > 0)
            {
                const double tangential = order(errorT, 0, 6);
                std::printf(", tangential %.2f", tangential);
                EXPECT_GT(tangential, 1.9);
                EXPECT_LT(errorT[2], 4e-4);
            }
            std::printf("\n");
        }
    }
}


TEST(convergence, losslessImpactsGainNothingByThemselves)
{
    // what an impact gains or loses by the error of its steps is of second order; on average over
    // many, which add up, it must be of a higher one
    const Law law = lawOf("Hertz", 1);
    struct Gain { double mean, rms; };
    const auto gain = [&](double steps)
    {
        double sum = 0, square = 0;
        int touches = 0;
        for (int run = 0; run < 10; ++run)
        {
            dem::TimeSettings time;
            time.restTolerance = 0;
            time.stepsPerContact = steps;
            dem::System system(law.table(), time);
            dem::Walls walls = scene::floor();
            walls.planes.push_back({Vec3(0, 0, 10*r), -Vec3::UnitZ(), 0});
            system.setWalls(walls);
            const double v = 0.5 + 0.15*run;
            system.add(scene::sphere(law, 1, r, Vec3(0, 0, 5*r), Vec3(0.1, 0, v)));
            double before = v*v;
            // 0.37 ways between the walls: it touches at any phase of a particle step
            for (int k = 0; k < 800; ++k)
            {
                touches += int(system.advance(0.37*8*r/v).touches);
                if (system.inContact(0)) continue;
                const double after = std::pow(system.particle(0).v.z(), 2);
                const double share = after/before - 1;
                sum += share;
                square += share*share;
                before = after;
            }
        }
        return Gain{sum/touches, std::sqrt(square/touches)};
    };
    const Gain coarse = gain(50), fine = gain(100);
    std::printf
    (
        "# gain per impact: %.2e, rms %.2e at 50 steps, %.2e, rms %.2e at 100\n",
        coarse.mean, coarse.rms, fine.mean, fine.rms
    );
    EXPECT_LT(std::fabs(coarse.mean), 5e-6);
    EXPECT_LT(coarse.rms, 4e-5);
    EXPECT_LT(fine.rms, 0.35*coarse.rms);
    EXPECT_LT(std::fabs(fine.mean), 0.15*std::fabs(coarse.mean));
}
