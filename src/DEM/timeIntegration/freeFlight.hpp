// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motion under a force that is linear in the velocity, in closed form:
//
//     dv/dt = b - s v,    s = Sp/m [1/s],  b = (Sp Uc + Su)/m [m/s2]
//     v(h) = e^-z v + b h phi_1(z),   x(h) = x + v h phi_1(z) + b h^2 phi_2(z),   z = s h
//     phi_1 = (1 - e^-z)/z,  phi_2 = (1 - phi_1)/z
//
// Exact for every tau_p/h, from vacuum (z = 0) to tau_p << h.
#pragma once

#include "particles/GasLoad.hpp"
#include "particles/Particle.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

struct FlightFactors
{
    double e;   // e^-z
    double p1;  // h phi_1 [s]
    double p2;  // h^2 phi_2 [s2]

    FlightFactors(double s, double h)
    {
        const double z = s*h;
        e = std::exp(-z);
        if (z < 0.02)
        {
            // series; the closed form of phi_2 would lose digits
            p1 = h*(1 - z/2*(1 - z/3*(1 - z/4*(1 - z/5*(1 - z/6)))));
            p2 = h*h*(0.5 - z/6*(1 - z/4*(1 - z/5*(1 - z/6*(1 - z/7)))));
        }
        else
        {
            p1 = -std::expm1(-z)/s;
            p2 = (h - p1)/s;
        }
    }
};

//- Move x, v, omega over h; returns the impulse that the gas gave [N s]
inline Vec3 fly(Particle& p, const GasLoad& g, double h)
{
    const FlightFactors f(g.Sp/p.mass, h);
    const Vec3 b = (g.Sp*g.Uc + g.Su)/p.mass;
    const Vec3 v = f.e*p.v + f.p1*b;
    p.x += f.p1*p.v + f.p2*b;
    const Vec3 impulse = p.mass*(v - p.v);
    p.v = v;
    if (g.SpOmega > 0)
    {
        const double inertia = 0.4*p.mass*p.radius*p.radius;
        const double decay = std::exp(-g.SpOmega/inertia*h);
        p.omega = g.omegaC + decay*(p.omega - g.omegaC);
    }
    return impulse;
}

//- The box of the centre's path over h
inline void flightBox
(
    const Particle& p, const GasLoad& g, double h, Vec3& low, Vec3& high
)
{
    Particle q = p;
    fly(q, g, h);
    low = p.x.cwiseMin(q.x);
    high = p.x.cwiseMax(q.x);

    // a component whose velocity changes sign turns at t with v(t) = 0
    const double s = g.Sp/p.mass;
    const Vec3 b = (g.Sp*g.Uc + g.Su)/p.mass;
    for (int d = 0; d < 3; ++d)
    {
        if (p.v[d]*q.v[d] < 0)
        {
            // e^-st = b/(b - s v)  =>  s t = log1p(-s v/b)
            const double ratio = -p.v[d]/b[d];
            const double t = s > 0 ? std::log1p(s*ratio)/s : ratio;
            const FlightFactors f(s, std::min(std::max(t, 0.0), h));
            const double turn = p.x[d] + f.p1*p.v[d] + f.p2*b[d];
            low[d] = std::min(low[d], turn);
            high[d] = std::max(high[d], turn);
        }
    }
}

}
