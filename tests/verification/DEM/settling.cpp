// SPDX-License-Identifier: GPL-3.0-or-later
//
// Settling under drag and weight in the System against the exact solution, for relaxation
// times from far below to far above the particle step; the way to a wall in many pieces.
#include "scene.hpp"

using scene::close;
using scene::near;
using scene::Law;
using scene::sphere;
using dem::Vec3;

namespace
{

//- v and x of m dv/dt = Sp (Uc - v) + m g at time t, in long double
struct Exact { Vec3 v, x; };

Exact exact(const Vec3& v0, const Vec3& terminal, double tau, double t)
{
    const long double k = static_cast<long double>(t)/tau;
    const long double gone = -std::expm1(-k);
    // t - tau (1 - e^(-t/tau)), by its series where it is small
    long double lag = t - tau*gone;
    if (k < 1e-3L) lag = t*k*(0.5L - k/6 + k*k/24);
    const double v = double(gone), x = double(lag);
    return {v0 + (terminal - v0)*v, v0*(tau*v) + terminal*x};
}

}


TEST(settling, exactForEveryRelaxationTime)
{
    const Law law;
    const double r = 2.5e-6, dt = 1e-4;
    const Vec3 g(0, 0, -9.81), Uc(0.2, 0, 0.01), v0(1, -0.5, 0.3);
    for (double decade = -4; decade <= 4; decade += 1)
    {
        const double tau = dt*std::pow(10.0, decade);
        SCOPED_TRACE("tau/dt = " + scene::text(tau/dt));
        dem::System system(law.table(), {});
        system.keepGasExchange(true);
        const dem::Particle start = sphere(law, 1, r, Vec3::Zero(), v0);
        system.add(start);
        dem::GasLoad load;
        load.Sp = start.mass/tau;
        load.Uc = Uc;
        load.Su = start.mass*g;
        const Vec3 terminal = Uc + tau*g;
        const int steps = 100;
        Vec3 impulse = Vec3::Zero();
        for (int k = 0; k < steps; ++k)
        {
            system.setGasLoad(0, load);
            system.advance(dt);
            impulse += system.gasExchange(0).impulse;
        }
        const Exact e = exact(v0, terminal, tau, steps*dt);
        const double speed = v0.norm() + terminal.norm();
        EXPECT_TRUE(near(system.particle(0).v, e.v, 1e-13*speed));
        EXPECT_TRUE(near(system.particle(0).x, e.x, 1e-12*speed*steps*dt));
        EXPECT_TRUE(near(impulse, start.mass*(e.v - v0), 1e-12*speed*start.mass));
    }
}


TEST(settling, nextToAnotherAsInTheOpen)
{
    // in an island with another particle in reach, but without a touch, flight is cut into
    // pieces and must stay exact
    const Law law;
    const double r = 2.5e-6, dt = 1e-4;
    for (const double ratio : {1e-3, 0.1, 1.0, 100.0})
    {
        SCOPED_TRACE("tau/dt = " + scene::text(ratio));
        const double tau = ratio*dt;
        dem::System system(law.table(), {});
        system.setWalls(scene::floor());
        const Vec3 v0(0.5, 0, -0.02);
        const dem::Particle start = sphere(law, 1, r, Vec3(0, 0, 30*r), v0);
        system.add(start);
        system.add(sphere(law, 2, r, Vec3(2.002*r, 0, 30*r), v0));
        dem::GasLoad load;
        load.Sp = start.mass/tau;
        load.Su = start.mass*Vec3(0, 0, -9.81);
        const Vec3 terminal = load.Su/load.Sp;
        dem::StepReport report;
        double t = 0;
        for (int k = 0; k < 4; ++k)
        {
            for (std::size_t i = 0; i < 2; ++i) system.setGasLoad(i, load);
            report.add(system.advance(dt));
            t += dt;
            const Exact e = exact(v0, terminal, tau, t);
            if (start.x.z() + e.x.z() < 1.001*r) break;
            EXPECT_TRUE(near(system.particle(0).x, start.x + e.x, 1e-11*v0.norm()*t));
            EXPECT_TRUE(near(system.particle(0).v, e.v, 1e-11*v0.norm()));
        }
        EXPECT_GT(report.islands, 0);
        EXPECT_EQ(report.contactSteps, 0);
    }
}


TEST(settling, touchesTheFloorWhenItShould)
{
    // Hertz, elastic: it comes back with the speed it had at touch; from the height that it
    // then reaches the moment and speed of touch follow
    Law law;
    law.gamma = 0;
    law.restitution = 1;
    const double r = 2.5e-6;
    for (const double dt : {1e-6, 1e-4, 1e-2})
    {
        SCOPED_TRACE("dt " + scene::text(dt));
        dem::TimeSettings time;
        time.stepsPerContact = 400;
        dem::System system(law.table(), time);
        system.setWalls(scene::floor());
        const double h0 = 40e-6;
        system.add(sphere(law, 1, r, Vec3(0, 0, r + h0)));
        dem::GasLoad weight;
        weight.Su = Vec3(0, 0, -9.81*law.mass(r));
        // falls for (2 h/g)^(1/2) and rises again as long
        const double fall = std::sqrt(2*h0/9.81);
        const double end = 1.7*fall;
        int steps = int(std::ceil(end/dt));
        for (int k = 0; k < steps; ++k)
        {
            system.setGasLoad(0, weight);
            system.advance(end/steps);
        }
        const double since = end - fall, vTouch = 9.81*fall;
        const double z = r + vTouch*since - 0.5*9.81*since*since;
        // but for the time in contact, some 1e-7 s, and the loss of 400 steps
        EXPECT_TRUE(near(system.particle(0).x.z(), z, 2e-3*h0));
        EXPECT_TRUE(near(system.particle(0).v.z(), vTouch - 9.81*since, 2e-3*vTouch));
    }
}
