// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vector.hpp"

#include <cstdint>

namespace dem
{

//- A sphere
struct Particle
{
    std::int64_t id;        // unique over all ranks and for ever, >= 0
    int material;           // index into MaterialTable::materials()
    double radius;          // [m]
    double mass;            // [kg]
    Vec3 x;                 // centre [m]
    Vec3 v = Vec3::Zero();      // [m/s]
    Vec3 omega = Vec3::Zero();  // spin [rad/s]

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.id);
        f(s.material);
        f(s.radius);
        f(s.mass);
        f(s.x);
        f(s.v);
        f(s.omega);
    }

    //- Of translation and spin [J]
    double kineticEnergy() const
    {
        return 0.5*mass*(v.squaredNorm() + 0.4*radius*radius*omega.squaredNorm());
    }
};

}
