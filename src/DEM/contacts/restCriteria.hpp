// SPDX-License-Identifier: GPL-3.0-or-later
//
// When a particle falls asleep and when it wakes. F_C and delta_C are pull-off force and neck of
// the weakest of its contacts as softened, all times restTolerance.
//
// Asleep, and then a fixed boundary for those awake, when for a whole window (3 normal periods) it
// has had
//     kinetic energy < 0.1 F_C delta_C,  |force| < 0.1 F_C,
//     |torque| < max(0.02 F_C r, M_y)     (M_y: rolling yields)
// and when it holds on to a wall, directly or by particles at rest. (One that rocks, with less
// energy than would let it roll, has no damping: it counts as quiet after 30 windows.) What rolls
// on at a contact that yields does not fall asleep, however slow and even its motion; nor does a
// cluster on one or two contacts whose gas load has more moment about them than 1.1 M, with
// M = max(M_y, 0.01 F_C r) of each. It wakes when |force| > F_C/2 or |torque| > F_C r/2, what its
// resting neighbours give to it included; when a contact of it ends; or when the gas force on it
// has changed by 0.1 min(F_C, M/r).
// A cluster that flies is judged by its motion beyond that of a rigid body of the same momentum
// and angular momentum; at the end of the particle step it may become a RigidAggregate.
#pragma once

#include "contacts/ContactRecord.hpp"
#include "contacts/ContactStore.hpp"
#include "particles/GasLoad.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace dem
{

//- Share of the weakest pull-off force, or moment that rolls over the radius, by which the load
//  on a particle at rest may change
inline constexpr double wakeForceChange = 0.1;

//- Whether a resting particle must wake because its gas load has changed, or because it was
//  moved from outside (negative wakeForce)
inline bool wakes(const RestState& rest, const GasLoad& gas)
{
    if (rest.wakeForce < 0) return true;
    const Vec3 now = gas.Sp*gas.Uc + gas.Su;
    const Vec3 then(rest.force[0], rest.force[1], rest.force[2]);
    return (now - then).squaredNorm() > rest.wakeForce*rest.wakeForce;
}

//- Moment at which a contact begins to roll [N m], as far as rest tells: not less than 0.01 F_C r
inline double rollingStrength(double yield, double pullOff, double radius)
{
    return std::max(yield, 0.01*pullOff*radius);
}

//- A contact that holds a cluster
struct Hold
{
    Vec3 at;            // [m], from the origin of the moment below
    Vec3 normal;
    double bears;       // rollingStrength [N m]
};

//- So many can let go together
inline constexpr std::size_t mostHolds = 2;

//- Whether a load from outside, its moment about the origin [N m], has more moment about one
//  contact, across its normal, or about the line through two, than these can bear. More hold at
//  any load.
inline bool rollsOff(const std::vector<Hold>& holds, const Vec3& force, const Vec3& moment)
{
    if (holds.empty() || holds.size() > mostHolds) return false;
    const Vec3 about = moment - holds[0].at.cross(force);
    const bool line = holds.size() == 2 && holds[0].at != holds[1].at;
    const Vec3 axis = line ? (holds[1].at - holds[0].at).normalized() : holds[0].normal;
    const double along = about.dot(axis);
    return
        (line ? std::fabs(along) : (about - along*axis).norm())
      > (1 + wakeForceChange)*(line ? holds[0].bears + holds[1].bears : holds[0].bears);
}

//- Weakest contact of a particle
struct WeakestContact
{
    bool any = false;
    double pullOff = 0;         // [N]
    double neck = 0;            // delta_C [m]
    RollingYield yield = {0, 0};

    void add(const ContactEntry& e)
    {
        if (any && !(e.pullOff < pullOff)) return;
        // delta_C = a0^2/(2 6^(1/3) R), also for laws without a neck
        *this = {true, e.pullOff, 0.27516*e.a0*e.a0/e.R, e.yield};
    }

    //- Change of the load from outside that wakes a particle of this radius [m], in [N]
    double wakeForce(double tolerance, double radius) const
    {
        const double rolls = rollingStrength(yield.moment, pullOff, radius)/radius;
        return tolerance*wakeForceChange*std::min(pullOff, rolls);
    }
};

//- T_n of a contact at A = 1: k_N = 3.6 F_C R/a0^2 [s]; 0 without adhesion
inline double normalPeriod(const ContactEntry& e)
{
    if (!(e.pullOff > 0)) return 0;
    return 2*M_PI*std::sqrt(e.m*e.a0*e.a0/(3.6*e.pullOff*e.R));
}

//- The motion of a particle and what is out of balance on it
struct Unrest
{
    double energy;      // kinetic [J]
    double force;       // [N]
    double torque;      // [N m]
};

//- By how much the time for which a particle has been quiet grows over `elapsed` [s]; none: it is
//  not quiet
inline std::optional<double> quietGain
(
    const Unrest& u, const WeakestContact& weakest, double radius, double tolerance,
    double elapsed
)
{
    constexpr double quietEnergy = 0.1, quietForce = 0.1, quietTorque = 0.02;
    constexpr double rockingWindows = 30;
    const double small = tolerance*quietEnergy*weakest.pullOff*weakest.neck;
    const RollingYield& yield = weakest.yield;
    if
    (
        !weakest.any || !(weakest.pullOff > 0)
     || u.force >= tolerance*quietForce*weakest.pullOff
     || u.torque >= tolerance*std::max(quietTorque*weakest.pullOff*radius, yield.moment)
     || u.energy >= std::max(small, tolerance*yield.energy)
    ) return {};
    return u.energy < small ? elapsed : elapsed/rockingWindows;
}

//- Whether force and torque wake a particle at rest, pullOff [N] as it fell asleep
inline bool overloads
(
    const Vec3& force, const Vec3& torque, double pullOff, double radius, double tolerance
)
{
    constexpr double wakeForce = 0.5;
    const double limit = tolerance*wakeForce*pullOff;
    return
        force.squaredNorm() > limit*limit
     || torque.squaredNorm() > limit*limit*radius*radius;
}

}
