// SPDX-License-Identifier: GPL-3.0-or-later
//
// van der Waals contacts in motion. Prints lines `close NAME VALUE EXPECTED TOLERANCE`,
// `between NAME VALUE LOW HIGH` and `figure NAME VALUE`. With F = 4 pi R gamma, the
// attraction works F z0 (1 - z0/range) on the way from the range to the cut-off z0, and F z0
// from there to contact.
#include "DEM.hpp"

#include "contactFormulas.hpp"
#include "contactModels/contactModel/ContactLaw.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace
{

using dem::Vec3;
using formula::pi;

constexpr double z0 = 4e-10, range = 1e-8;
constexpr double radius = 0.5e-6, density = 2200, nu = 0.25;

void close(const std::string& name, double value, double expected, double tolerance)
{
    std::printf("close %s %.9g %.9g %g\n", name.c_str(), value, expected, tolerance);
}

void between(const std::string& name, double value, double low, double high)
{
    std::printf("between %s %.9g %.9g %.9g\n", name.c_str(), value, low, high);
}

struct Dust
{
    double gamma = 0.02, E = 4e10, e = 0.9, chi = 1;

    dem::MaterialTable table() const
    {
        dem::ContactSettings s;
        s.normal =
        {
            "vanDerWaals", {{"restitution", e}, {"cutOff", z0}, {"range", range}}, {}
        };
        dem::ReducedStiffness softening;
        softening.ratio = chi;
        return {{{"dust", density, 2*(1 - nu*nu)*E, nu, gamma}}, s, {}, softening};
    }

    double mass(double r) const { return density*4.0/3.0*pi*r*r*r; }
    double pullOff(double R) const { return 4*pi*R*gamma; }
    double force(double R, double overlap) const
    {
        const double z = std::max(z0, -overlap);
        return
            4.0/3.0*E*std::sqrt(R)*std::pow(std::max(overlap, 0.0), 1.5)
          - pullOff(R)*z0*z0/(z*z);
    }
};

dem::Walls floorWall()
{
    dem::Walls walls;
    walls.patches = {{"floor", 0}};
    walls.planes = {{Vec3::Zero(), Vec3::UnitZ(), 0}};
    return walls;
}

//- e of a sphere of radius r and a wall (rj < 0) or another sphere; 0 = stuck
double collide(const Dust& dust, double rj, double v, double steps)
{
    const double r = radius, stretch = std::pow(dust.chi, -0.4);
    const double share = rj > 0 ? std::pow(rj, 3)/(r*r*r + std::pow(rj, 3)) : 1;
    dem::TimeSettings time;
    time.stepsPerContact = steps;
    time.restTolerance = 0;
    dem::System system(dust.table(), time);
    const double gap = range*stretch;
    system.add
    ({
        0, 0, r, dust.mass(r), Vec3(0, 0, r + gap), Vec3(0, 0, -v*share)
    });
    if (rj > 0)
    {
        system.add
        ({
            1, 0, rj, dust.mass(rj), Vec3(0, 0, -rj), Vec3(0, 0, v*(1 - share))
        });
    }
    else system.setWalls(floorWall());

    const double R = rj > 0 ? r*rj/(r + rj) : r, m = dust.mass(r)*share;
    const double period =
        stretch*2*pi*std::sqrt(m/(2*dust.E*std::cbrt(3*pi*dust.gamma*R*R/dust.E)));
    const double dt = std::min(period, 0.2*gap/v);
    for (int k = 0; k < 2000; ++k)
    {
        if (system.advance(dt).separations)
        {
            return (system.particle(0).v.z() - (rj > 0 ? system.particle(1).v.z() : 0))/v;
        }
    }
    return 0;
}

//- The same by an integration of high order
double integrated(const Dust& dust, double R, double m, double v)
{
    const double beta = formula::beta(dust.e);
    formula::Ode<2> ode;
    ode.rate = [&](double, const std::array<double, 2>& y)
    {
        const double a = std::sqrt(R*std::max(y[0], 0.0));
        const double eta = 2*std::sqrt(5.0/6.0)*beta*std::sqrt(2*dust.E*a*m);
        return std::array<double, 2>{y[1], -(dust.force(R, y[0]) + eta*y[1])/m};
    };
    ode.scale = {z0, v};
    ode.tolerance = 1e-10;
    std::array<double, 2> y{-range, v};
    bool left = false;
    const double time = 20*range/v + 1e-7;
    ode.solve
    (
        y, 0, time, 1e-5*time,
        [&](const std::array<double, 2>& z)
        {
            left = z[1] < 0 && z[0] < -range;
            return left;
        }
    );
    return left ? -y[1]/v : 0;
}

void work()
{
    // at the law itself, in fine pieces
    const Dust dust;
    const dem::MaterialTable table = dust.table();
    const dem::ContactLaw& law = *table.laws()[0];
    const double R = radius;
    double c[dem::maxConstants], h[dem::maxHistory] = {};
    law.prepare(0, {table.constants(0, 0), R, dust.mass(R)}, c);
    double sum = 0;
    const int n = 200000;
    for (int k = 0; k < n; ++k)
    {
        // pieces grow with the gap
        const double a = range*std::pow(1e-4, double(k)/n);
        const double b = range*std::pow(1e-4, double(k + 1)/n);
        sum -= law.normalResponse(c, -std::sqrt(a*b), h).elastic*(a - b);
    }
    const double F = dust.pullOff(R);
    close("work_of_attraction", sum, F*z0*(2 - z0/range) - F*1e-4*range, 1e-6);
    close("force_at_contact", -law.normalResponse(c, 0, h).elastic, F, 1e-14);
    close
    (
        "Hamaker_force_at_1_nm", -law.normalResponse(c, -1e-9, h).elastic,
        24*pi*dust.gamma*z0*z0*R/(6*1e-18), 1e-12
    );
}

void approach()
{
    // what a slow, a middling and a fast sphere have gained before they touch
    for (const double v : {0.01, 0.3, 10.0})
    {
        for (const double steps : {50.0, 400.0})
        {
            Dust dust;
            dem::TimeSettings time;
            time.stepsPerContact = steps;
            time.restTolerance = 0;
            dem::System system(dust.table(), time);
            system.setWalls(floorWall());
            const double m = dust.mass(radius), F = dust.pullOff(radius);
            system.add({0, 0, radius, m, Vec3(0, 0, radius + range), Vec3(0, 0, -v)});
            double gap = range, gained = 0, expected = 0;
            while (gap > 0)
            {
                const double speed = system.particle(0).v.norm();
                gained = 0.5*m*(speed*speed - v*v);
                expected =
                    gap > z0 ? F*z0*z0*(1/gap - 1/range)
                  : F*z0*(1 - z0/range) + F*(z0 - gap);
                system.advance(0.02*z0/speed);
                gap = system.particle(0).x.z() - radius;
            }
            close
            (
                "energy_gained_at_v=" + std::to_string(v).substr(0, 4)
              + (steps < 100 ? "_50_steps" : "_400_steps"),
                gained, expected, steps < 100 ? 5e-3 : 5e-4
            );
        }
    }
}

void collisions()
{
    for (const double rj : {-1.0, 0.5e-6, 2e-6})
    {
        const std::string at = rj < 0 ? "wall" : rj > radius ? "pair_1:4" : "pair";
        const double share = rj > 0 ? 1/(1 + std::pow(radius/rj, 3)) : 1;
        const double R = rj > 0 ? radius*rj/(radius + rj) : radius;
        Dust dust;
        const double m = dust.mass(radius)*share;

        // undamped: nothing is lost, at any speed
        Dust elastic = dust;
        elastic.e = 1;
        for (const double v : {0.05, 0.5, 5.0, 50.0})
        {
            const double e = collide(elastic, rj, v, 50);
            const double well = 2*dust.pullOff(R)*z0;
            between
            (
                "energy_error_undamped_" + at + "_v=" + std::to_string(v).substr(0, 4),
                0.5*m*v*v*(e*e - 1)/(0.5*m*v*v + well), -2e-3, 2e-3
            );
        }

        double low = 1e-3, high = 10;
        for (int k = 0; k < 30; ++k)
        {
            const double middle = std::sqrt(low*high);
            (integrated(dust, R, m, middle) > 0 ? high : low) = middle;
        }
        const double sticks = low;
        std::printf("figure stickingSpeed_%s %.6g\n", at.c_str(), sticks);
        for (const double f : {1.2, 2.0, 5.0, 20.0})
        {
            const double v = f*sticks;
            close
            (
                "restitution_" + at + "_v/v_s=" + std::to_string(f).substr(0, 4),
                collide(dust, rj, v, 50), integrated(dust, R, m, v), f < 1.5 ? 2e-2 : 5e-3
            );
        }
        low = 0.8*sticks;
        high = 1.25*sticks;
        for (int k = 0; k < 14; ++k)
        {
            const double middle = 0.5*(low + high);
            (collide(dust, rj, middle, 200) > 0 ? high : low) = middle;
        }
        close("stickingSpeed_" + at, low, sticks, 1e-3);

        // reduced stiffness: the same, as z0 and range are stretched along (exactly but for
        // the touch, which is met within 1e-7 radii)
        const double v = 2*sticks;
        const double original = collide(dust, rj, v, 50);
        for (const double chi : {0.1, 0.01})
        {
            Dust soft = dust;
            soft.chi = chi;
            close
            (
                "restitution_" + at + "_chi=" + std::to_string(chi).substr(0, 4),
                collide(soft, rj, v, 50), original, 1e-6
            );
        }
    }
}

void pullOff()
{
    // a sphere at rest on a wall, drawn off by a force that rises slowly
    Dust dust;
    dust.e = 0.3;
    const double m = dust.mass(radius), F = dust.pullOff(radius);
    dem::TimeSettings time;
    time.restTolerance = 0;
    dem::System system(dust.table(), time);
    system.setWalls(floorWall());
    const double a0 = std::cbrt(3*pi*dust.gamma*radius*radius/dust.E);
    system.add({0, 0, radius, m, Vec3(0, 0, radius - a0*a0/radius)});
    const double period = 2*pi*std::sqrt(m/(2*dust.E*a0));
    double held = 0;
    for (int k = 0; k < 4000; ++k)
    {
        const double f = 0.8 + 0.3*k/4000;
        dem::GasLoad load;
        load.Su = Vec3(0, 0, f*F);
        system.setGasLoad(0, load);
        system.advance(0.5*period);
        // beyond the cut-off the attraction only falls
        if (system.particle(0).x.z() > radius + z0) break;
        held = f;
    }
    close("pull_off_force_over_F_C", held, 1, 5e-3);
}

}


int main()
{
    work();
    approach();
    collisions();
    pullOff();
}
