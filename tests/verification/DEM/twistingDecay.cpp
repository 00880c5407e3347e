// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bonded sphere that spins about its contact normal: below the limit the twist is a damped
// oscillation, I theta'' + eta_Q theta' + k_Q theta = 0 with k_Q = 4 G a0^3 and
// eta_Q = eta_N a0^2/2; above it the spin falls at the constant rate of the limit's moment,
// (3 pi/16) a0 mu 2 F_C (Marshall 2009; Chen, Liu & Li 2019).
#include "scene.hpp"

using dem::Vec3;
using scene::Law;

namespace
{

constexpr double r = 1e-6;

Law law()
{
    Law l;
    l.restitution = 0.5;
    l.friction = 0.3;
    l.twisting = true;
    return l;
}

//- Spin about the normal after each of the times, from the equilibrium of the contact
std::vector<double> spins(double spin, const std::vector<double>& times)
{
    dem::TimeSettings settings;
    settings.stepsPerContact = 200;
    settings.restTolerance = 0;
    const Law l = law();
    dem::System system(l.table(), settings);
    system.setWalls(scene::floor());
    const double z = r - l.contact(r, -1).delta0();
    system.add(scene::sphere(l, 1, r, Vec3(0, 0, z), Vec3::Zero(), Vec3(0, 0, spin)));
    std::vector<double> result;
    double now = 0;
    for (const double t : times)
    {
        system.advance(t - now);
        now = t;
        EXPECT_TRUE(scene::near(system.particle(0).x, Vec3(0, 0, z), 1e-9*r));
        result.push_back(system.particle(0).omega.z());
    }
    return result;
}

}


TEST(twistingDecay, belowTheLimitIsADampedOscillation)
{
    const Law l = law();
    const formula::Contact c = l.contact(r, -1);
    const double a = c.a0(), inertia = 0.4*c.m*r*r;
    const double k = 4*c.G*a*a*a;
    const double eta = formula::normal("JKR", c, c.delta0(), l.restitution).damping*a*a/2;
    const double decay = eta/(2*inertia);
    const double frequency = std::sqrt(k/inertia - decay*decay);
    const double limit = 3*formula::pi/16*a*l.friction*2*c.pullOff();
    const double spin = 0.5*limit/std::sqrt(k*inertia);

    std::vector<double> times;
    for (int n = 1; n <= 40; ++n) times.push_back(0.1*n*2*formula::pi/frequency);
    const std::vector<double> found = spins(spin, times);
    for (std::size_t n = 0; n < times.size(); ++n)
    {
        const double phase = frequency*times[n];
        const double exact =
            spin*std::exp(-decay*times[n])
           *(std::cos(phase) - decay/frequency*std::sin(phase));
        EXPECT_TRUE(scene::near(found[n], exact, 1e-3*spin)) << times[n];
    }
}


TEST(twistingDecay, aboveTheLimitIsAConstantMoment)
{
    const Law l = law();
    const formula::Contact c = l.contact(r, -1);
    const double a = c.a0(), inertia = 0.4*c.m*r*r;
    const double limit = 3*formula::pi/16*a*l.friction*2*c.pullOff();
    const double spin = 30*limit/std::sqrt(4*c.G*a*a*a*inertia);
    const double stop = spin*inertia/limit;
    const std::vector<double> times{0.25*stop, 0.5*stop, 0.9*stop};
    const std::vector<double> found = spins(spin, times);
    for (std::size_t n = 0; n < times.size(); ++n)
    {
        EXPECT_TRUE(scene::near(found[n], spin*(1 - times[n]/stop), 2e-3*spin));
    }
}
