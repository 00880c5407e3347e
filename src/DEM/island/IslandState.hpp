// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that changes while an island is moved, as a plain value: a copy of it is a place to come
// back to. Particles are in order of id and known by their index here.
#pragma once

#include "contacts/ContactList.hpp"
#include "contacts/ContactRecord.hpp"
#include "contacts/ContactStore.hpp"
#include "particles/GasLoad.hpp"
#include "particles/Particle.hpp"

#include <string>
#include <vector>

namespace dem
{

//- Velocities before the kick that still is to come (Propagator); otherwise as in Body
struct alignas(64) Motion
{
    double v[3], invM;      // [m/s], [1/kg]
    double w[3], invI;      // [rad/s], [1/(kg m2)]
};

//- Where in the run, and in a contact step, the state is
struct Phase
{
    double elapsed = 0;     // [s] of this run
    double left = 0;        // [s] of this run, when the present step began
    double owed = 0;        // [s] step of which the second kick is still to come
    double ahead = 0;       // [s] by which springs are ahead of the loads
    double fastest = 0;     // [m/s] of all, in the last step
};

struct IslandState
{
    // As loaded; places and velocities only before and after a run
    std::vector<Particle> particles;
    std::vector<GasLoad> gas;
    std::vector<double> reach;      // longest neck [m]

    std::vector<RestState> rest;
    std::vector<Vec3> impulse;      // that the gas gave [N s]
    std::vector<Body> bodies;
    std::vector<Motion> motion;
    std::vector<Load> loads;        // of contacts
    std::vector<int> awake;         // ascending
    ContactStore contacts;
    Phase phase;
};

inline Vec3 vec(const double* p) { return {p[0], p[1], p[2]}; }

inline double inertia(const Particle& p) { return 0.4*p.mass*p.radius*p.radius; }

inline Vec3 gasForceAtRest(const GasLoad& g) { return g.Sp*g.Uc + g.Su; }
inline Vec3 gasTorqueAtRest(const GasLoad& g) { return g.SpOmega*g.omegaC; }

//- The acceleration of a particle as last evaluated [m/s2]
Vec3 acceleration(const IslandState& state, int i);

//- |dv/dt| of free flight can only fall from here on [m/s2]
double accelerationBound(const IslandState& state, int i);

//- Make bodies of the particles, at the start of a run
void setBodies(IslandState& state);

//- The end of a state that cannot be integrated further: names the contact of i with j (-1: a
//  wall), the time [s], and place and velocity of i
[[noreturn]] void fail
(
    const IslandState& state, const std::string& what, int i, int j, double time
);

//- The same where a particle has a place or velocity that is not finite
void checkFinite(const IslandState& state, double time);

}
