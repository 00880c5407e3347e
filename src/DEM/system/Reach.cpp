// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/Reach.hpp"

#include "timeIntegration/freeFlight.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

namespace
{

constexpr double speedMargin = 1.2;
constexpr double leastPath = 1e-3;      // [radii]
constexpr std::int64_t restingBody = -2;

// Two of one rigid body do not push each other before one of them is pushed
double together(const Path& a, const Path& b)
{
    return a.rigid == b.rigid && a.rigid != -1 ? std::min(a.hit, b.hit) : 0;
}

}


Path Reach::own(std::size_t i, double dt) const
{
    const Particle& p = store_.particles[i];
    const RestState& rest = store_.rest[i];
    Path path;
    // as if it had come along the way that it enters on; or gone on, without the touch at which
    // it stands
    const double delay = store_.delay(i);
    path.x = p.x - delay*p.v;
    path.size = p.radius + store_.reach[i];
    if (!store_.awake(i))
    {
        path.corridor = {Vec3::Zero(), 0, 0, 0};
        path.rigid = restingBody;
        path.held = true;
        path.open = false;
        return path;
    }
    const GasLoad& g = store_.gas[i];
    const Vec3 force = g.Sp*(g.Uc - p.v) + g.Su;
    if (store_.flies(i))
    {
        // along with the centre of mass; the rest bends its path
        const Vec3 held(rest.force[0], rest.force[1], rest.force[2]);
        const Vec3 arm(rest.arm[0], rest.arm[1], rest.arm[2]);
        const Vec3 turning = p.omega.cross(arm);
        const double pull = ((force + held)/p.mass - p.omega.cross(turning)).norm();
        const double round = p.omega.norm()*arm.norm();
        path.rigid = rest.aggregate;
        path.own = p.v - turning;
        path.bend = std::min(2*arm.norm(), round*dt) + 0.5*pull*dt*dt + leastPath*p.radius;
        path.gain = round + pull*dt;
    }
    else
    {
        const FlightFactors f(g.Sp/p.mass, dt);
        const double pull = force.norm()/p.mass;
        path.own = p.v;
        path.bend = 0.5*pull*dt*dt;
        path.gain = pull*f.p1;
        if (rest.inContact || !store_.contacts[i].empty()) path.pushedFromStart();
    }
    if (delay < 0) path.pushedFromStart();
    path.corridor = {path.own, path.bend, 0, 0};
    return path;
}


Corridor Reach::pushed(std::size_t i, const Path& p, const Crowd& crowd, double dt) const
{
    const double least = leastPath*store_.particles[i].radius;
    const double fastest = speedMargin*crowd.speed;
    const double beyond = (p.own - crowd.velocity).norm() + p.gain;
    const Corridor off = early({p.own, p.bend + least, p.hit, fastest + beyond});
    const Corridor about = early({crowd.velocity, least, 0, fastest});
    return off.width(dt) < about.width(dt) ? off : about;
}


Corridor Reach::anywhere(std::size_t i, double fastest) const
{
    return early({Vec3::Zero(), leastPath*store_.particles[i].radius, 0, speedMargin*fastest});
}


//- Who stands behind, and what rests about it, begins earlier than the step: off the middle of
//  its corridor, and pushed
Corridor Reach::early(Corridor corridor) const
{
    corridor.near += 3*store_.behind*corridor.away;
    return corridor;
}


Box Reach::box(std::size_t i, const Path& p, double dt) const
{
    Box b;
    double around = p.size;
    if (p.joint || store_.flies(i) || !store_.awake(i))
    {
        const Vec3 end = p.x + dt*p.corridor.v;
        b = {p.x.cwiseMin(end), p.x.cwiseMax(end)};
        around += p.corridor.width(dt);
    }
    else
    {
        const double flown = dt + std::max(-store_.delay(i), 0.0);
        flightBox(store_.particles[i], store_.gas[i], flown, b.low, b.high);
    }
    return {b.low.array() - around, b.high.array() + around};
}


bool Reach::wallWithin(const Box& b) const
{
    static thread_local std::vector<int> surfaces;
    walls_.query(b.low, b.high, surfaces);
    return !surfaces.empty();
}


double meetingTime(const Path& a, const Path& b, double dt, const Periodic& periodic)
{
    const Corridor &ca = a.corridor, &cb = b.corridor;
    Vec3 d = periodic.nearest(b.x - a.x);
    const Vec3 u = cb.v - ca.v;
    const double square = u.squaredNorm();
    const double nearest = square > 0 ? std::min(std::max(-d.dot(u)/square, 0.0), dt) : 0;
    const double sizes = a.size + b.size;
    const double most = sizes + ca.width(dt) + cb.width(dt);
    if ((d + nearest*u).squaredNorm() > most*most) return 1e300;

    // |d + u t| = R + k t between the times when they can be pushed
    const double times[4] =
    {
        0, std::min(std::min(ca.from, cb.from), dt), std::min(std::max(ca.from, cb.from), dt), dt
    };
    for (int piece = 0; piece < 3; ++piece)
    {
        const double start = times[piece], length = times[piece + 1] - start;
        const Vec3 apart = d + start*u;
        const double R = sizes + ca.width(start) + cb.width(start);
        const double C = apart.squaredNorm() - R*R;
        if (C <= 0) return std::max(start, together(a, b));
        const double k = (ca.from <= start ? ca.away : 0) + (cb.from <= start ? cb.away : 0);
        const double A = square - k*k, B = apart.dot(u) - R*k;
        const double root = B*B - A*C;
        const double q = root < 0 ? -1 : std::sqrt(root) - B;
        if (q > 0 && C <= q*length) return std::max(start + C/q, together(a, b));
    }
    return 1e300;
}


bool meet(Path& a, Path& b, double dt, const Periodic& periodic)
{
    const double time = meetingTime(a, b, dt, periodic);
    a.hitNext = std::min(a.hitNext, time);
    b.hitNext = std::min(b.hitNext, time);
    if (time > dt && !(a.rigid >= 0 && a.rigid == b.rigid)) return false;
    if (a.rigid != restingBody) b.openNext = true;
    if (b.rigid != restingBody) a.openNext = true;
    return true;
}

}
