// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/IslandState.hpp"

#include "particles/errors.hpp"
#include "particles/finite.hpp"

#include <sstream>

namespace dem
{

Vec3 acceleration(const IslandState& state, int i)
{
    const std::size_t k = std::size_t(i);
    if (state.rest[k].resting) return Vec3::Zero();
    const GasLoad& g = state.gas[k];
    const Body& b = state.bodies[k];
    return (vec(state.loads[k].f) + g.Sp*(g.Uc - vec(b.v)) + g.Su)*b.invM;
}


double accelerationBound(const IslandState& state, int i)
{
    const std::size_t k = std::size_t(i);
    if (state.rest[k].resting) return 0;
    const GasLoad& g = state.gas[k];
    const Body& b = state.bodies[k];
    return (g.Sp*(g.Uc - vec(b.v)) + g.Su).norm()*b.invM;
}


void setBodies(IslandState& state)
{
    const std::size_t n = state.particles.size();
    state.bodies.resize(n);
    state.motion.assign(n, Motion{});
    state.loads.assign(n, Load{});
    state.awake.clear();
    for (std::size_t i = 0; i < n; ++i)
    {
        const Particle& p = state.particles[i];
        Body& b = state.bodies[i];
        Motion& m = state.motion[i];
        for (int d = 0; d < 3; ++d)
        {
            b.x[d] = p.x[d];
            b.v[d] = m.v[d] = p.v[d];
            b.w[d] = m.w[d] = p.omega[d];
        }
        b.r = p.radius;
        b.invM = m.invM = 1/p.mass;
        b.invI = m.invI = 1/inertia(p);
        if (!state.rest[i].resting) state.awake.push_back(int(i));
    }
}


void fail
(
    const IslandState& state, const std::string& what, int i, int j, double time
)
{
    std::ostringstream s;
    const Particle& p = state.particles[std::size_t(i)];
    const Body& b = state.bodies[std::size_t(i)];
    s.precision(9);
    s   << "The contact of particle " << p.id << " with ";
    if (j < 0) s << "a wall";
    else s << "particle " << state.particles[std::size_t(j)].id;
    s   << " " << what << " at time " << time << " s: position ("
        << b.x[0] << " " << b.x[1] << " " << b.x[2] << ") m, velocity ("
        << b.v[0] << " " << b.v[1] << " " << b.v[2] << ") m/s, radius "
        << p.radius << " m";
    throw numericalError(s.str());
}


void checkFinite(const IslandState& state, double time)
{
    for (std::size_t i = 0; i < state.particles.size(); ++i)
    {
        const Particle& p = state.particles[i];
        if (!isFinite(p.x) || !isFinite(p.v) || !isFinite(p.omega))
        {
            fail(state, "is not finite", int(i), -1, time);
        }
    }
}

}
