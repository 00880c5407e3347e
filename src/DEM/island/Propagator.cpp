// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/Propagator.hpp"

#include "timeIntegration/freeFlight.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

void Propagator::begin(const IslandState& state)
{
    flightStep_.reset();
    previousStep_.reset();
    vacuum_ = true;
    for (const GasLoad& g : state.gas)
    {
        vacuum_ = vacuum_ && g.Sp == 0 && g.SpOmega == 0 && g.Su.isZero(0);
    }
}


void Propagator::setFlight(const IslandState& state, double h)
{
    flightStep_ = h;
    flight_.resize(state.particles.size());
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        const GasLoad& g = state.gas[k];
        const FlightFactors f(g.Sp*state.bodies[k].invM, h);
        const Vec3 b = (g.Sp*g.Uc + g.Su)*state.bodies[k].invM;
        const FlightFactors spin(g.SpOmega*state.bodies[k].invI, h);
        const Vec3 driven = f.p1*b, drivenSpin = (1 - spin.e)*g.omegaC;
        flight_[k] =
        {
            f.e, f.p1, f.p2, f.p1 - f.p2/h, f.p2/h,
            spin.e, spin.p1 - spin.p2/h, spin.p2/h,
            {b[0], b[1], b[2]}, {driven[0], driven[1], driven[2]},
            {drivenSpin[0], drivenSpin[1], drivenSpin[2]}
        };
    }
}


//- Returns the largest |v|^2
template<bool gas>
double Propagator::fly(IslandState& state, double h)
{
    // velocity and spin side by side, as Load, Motion and Body have them
    typedef double Quad __attribute__((vector_size(32), may_alias));
    typedef double Octet __attribute__((vector_size(64), may_alias));
    typedef double LooseOctet __attribute__((vector_size(64), may_alias, aligned(32)));
    // not by value, which without AVX has another ABI
    const auto velocity = [](const Octet& o, Quad& v)
    {
        v = __builtin_shufflevector(o, o, 0, 1, 2, 3);
        v[3] = 0;
    };
    const double kick = 0.5*(state.phase.owed + h), half = 0.5*h;
    double fastest = 0;
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        Body& b = state.bodies[k];
        Load& l = state.loads[k];
        Motion& m = state.motion[k];
        double square;
        if constexpr (gas)
        {
            const Flight& f = flight_[k];
            const Octet before = reinterpret_cast<LooseOctet&>(b.v);
            // 1/m and 1/I, which are the fourths; those of Load are zero
            const Octet perLoad =
                __builtin_shufflevector(before, before, 3, 3, 3, 3, 7, 7, 7, 7);
            const Octet change = perLoad*reinterpret_cast<Octet&>(l);
            const Octet kept{f.e, f.e, f.e, 1, f.eSpin, f.eSpin, f.eSpin, 1};
            const Octet early
            {
                f.early, f.early, f.early, 0, f.earlySpin, f.earlySpin, f.earlySpin, 0
            };
            const Octet late{f.late, f.late, f.late, 0, f.lateSpin, f.lateSpin, f.lateSpin, 0};
            const Octet driven
            {
                f.driven[0], f.driven[1], f.driven[2], 0,
                f.drivenSpin[0], f.drivenSpin[1], f.drivenSpin[2], 0
            };
            const Octet kicked = kept*before + driven + early*change;
            reinterpret_cast<Octet&>(m) = kicked;
            const Octet after = kicked + late*change;
            reinterpret_cast<LooseOctet&>(b.v) = after;
            Quad v, a, u, predicted;
            velocity(before, v);
            velocity(change, a);
            velocity(kicked, u);
            velocity(after, predicted);
            const Quad b4{f.b[0], f.b[1], f.b[2], 0};
            reinterpret_cast<Quad&>(b.x) += f.p1*v + f.p2*(b4 + a);
            const Quad given =
                state.particles[k].mass*(u - v) - 0.5*h*reinterpret_cast<Quad&>(l.f);
            for (int d = 0; d < 3; ++d) state.impulse[k][d] += given[d];
            const Quad squares = v*v, later = predicted*predicted;
            square = 0;
            for (int d = 0; d < 3; ++d) square += std::max(squares[d], later[d]);
        }
        else
        {
            Octet moving = reinterpret_cast<Octet&>(m);
            const Octet perLoad =
                __builtin_shufflevector(moving, moving, 3, 3, 3, 3, 7, 7, 7, 7);
            const Octet change = perLoad*reinterpret_cast<Octet&>(l);
            moving += kick*change;
            reinterpret_cast<Octet&>(m) = moving;
            reinterpret_cast<LooseOctet&>(b.v) = moving + half*change;
            Quad v;
            velocity(moving, v);
            reinterpret_cast<Quad&>(b.x) += h*v;
            square = v[0]*v[0] + v[1]*v[1] + v[2]*v[2];
        }
        l = Load{};
        fastest = std::max(fastest, square);
    }
    return fastest;
}


void Propagator::drift(IslandState& state, double h, bool refined)
{
    if (refined) lastLoads_ = state.loads;
    double square;
    if (vacuum_) square = fly<false>(state, h);
    else
    {
        complete(state);
        if (flightStep_ != h) setFlight(state, h);
        square = fly<true>(state, h);
    }
    state.phase.owed = 0;
    state.phase.fastest = std::sqrt(square);
    state.phase.elapsed += h;
}


Propagator::Push Propagator::pushOf(const IslandState& state, std::size_t k, double h) const
{
    const Body& b = state.bodies[k];
    if (vacuum_) return {0.5*h*b.invM, 0.5*h*b.invI};
    return {flight_[k].late*b.invM, flight_[k].lateSpin*b.invI};
}


void Propagator::foresee(IslandState& state, double h)
{
    if (previousStep_)
    {
        const double share = 0.5*h / *previousStep_;
        for (const int i : state.awake)
        {
            const std::size_t k = std::size_t(i);
            Body& b = state.bodies[k];
            const Push push = pushOf(state, k, h);
            for (int d = 0; d < 3; ++d)
            {
                b.v[d] += share*push.v*(lastLoads_[k].f[d] - previousLoads_[k].f[d]);
                b.w[d] += share*push.w*(lastLoads_[k].t[d] - previousLoads_[k].t[d]);
            }
        }
    }
    previousLoads_.swap(lastLoads_);
    previousStep_ = h;
}


void Propagator::secondKick(IslandState& state) const
{
    const double owed = state.phase.owed;
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        Body& b = state.bodies[k];
        const Load& l = state.loads[k];
        Motion& m = state.motion[k];
        const Push push = pushOf(state, k, owed);
        for (int d = 0; d < 3; ++d)
        {
            b.v[d] = m.v[d] += push.v*l.f[d];
            b.w[d] = m.w[d] += push.w*l.t[d];
        }
        if (vacuum_) continue;
        // what the gas has taken of the kick
        for (int d = 0; d < 3; ++d)
        {
            state.impulse[k][d] += (push.v*state.particles[k].mass - 0.5*owed)*l.f[d];
        }
    }
    state.phase.owed = 0;
}

}
