// SPDX-License-Identifier: GPL-3.0-or-later
//
// One impact of a sphere on a flat wall, moved by the System as dustFoam moves it.
#pragma once

#include "scene.hpp"

#include <algorithm>

namespace scene
{

struct Impact
{
    bool left;              // rebounded
    double restitution;     // normal speed after over before, 0 = stuck
    double time;            // in contact [s]
    Vec3 v, omega;          // after [m/s], [rad/s]
    std::int64_t steps;
};

//- Sphere of radius r that begins to touch the plane z = 0 with v (v.z() < 0) and omega. If
//  it has not left after `patience` Hertzian and adhesive periods it has stuck: what does not
//  leave at its first return never does.
inline Impact impact
(
    const Law& law, double r, const Vec3& v, const Vec3& omega, double stepsPerContact,
    double patience = 4, bool sparing = true
)
{
    dem::TimeSettings time;
    time.stepsPerContact = stepsPerContact;
    time.restTolerance = 0;
    dem::System system(law.table(), time);
    system.setWalls(floor());
    system.add(sphere(law, 1, r, Vec3(0, 0, r), v, omega));

    const formula::Contact c = law.contact(r, -1);
    const double overlap =
        std::pow(15.0/16.0*c.m*v.z()*v.z()/(c.E*std::sqrt(c.R)), 0.4);
    double period = 2.94*overlap/std::fabs(v.z());
    if (c.gamma > 0)
    {
        period += 2*formula::pi*std::sqrt(c.m*c.a0()*c.a0()/(3.6*c.pullOff()*c.R));
    }
    Impact result{};
    double elapsed = 0;
    for (int k = 0; k < (sparing ? 1 : 8) && !result.left; ++k)
    {
        const double dt = patience*period;
        const dem::StepReport report = system.advance(dt);
        elapsed += dt;
        result.steps += report.contactSteps;
        result.left = !system.inContact(0) && report.separations > 0;
    }
    const dem::Particle& p = system.particle(0);
    result.v = p.v;
    result.omega = p.omega;
    if (result.left)
    {
        result.restitution = -p.v.z()/v.z();
        // it has flown on since it left
        const double end = r - formula::endOverlap(law.normal, c);
        result.time = elapsed - (p.x.z() - end)/p.v.z();
    }
    return result;
}

inline Impact impact(const Law& law, double r, double speed, double stepsPerContact)
{
    return impact(law, r, Vec3(0, 0, -speed), Vec3::Zero(), stepsPerContact);
}

//- Speed above which it rebounds, by bisection to a relative width
template<class Rebounds>
inline double stickingSpeed(double low, double high, double width, Rebounds rebounds)
{
    EXPECT_FALSE(rebounds(low)) << "rebounds at " << low << " m/s";
    EXPECT_TRUE(rebounds(high)) << "sticks at " << high << " m/s";
    while (high/low - 1 > width)
    {
        const double middle = std::sqrt(low*high);
        (rebounds(middle) ? high : low) = middle;
    }
    return std::sqrt(low*high);
}

}
