// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vector.hpp"

#include <cstddef>
#include <cstdint>

namespace dem
{

//- Particles that can meet each other within one particle step, as one
struct Component
{
    std::int64_t id = 0;        // lowest of its particles
    double mass = 0;            // [kg]
    Vec3 momentum = Vec3::Zero();
    double speed = 0;           // fastest member's bound, beyond velocity() [m/s]
    bool active = false;        // some member is awake
    bool shared = false;        // spans ranks
    int home = 0;               // rank that moves it
    std::int64_t unit = -1;     // particle or rigid aggregate that it consists of; -1 = several
    bool pushed = false;        // contacts can push some member off its path
    bool held = false;          // by a wall or what rests
    std::size_t count = 0;      // members on this rank

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.id);
        f(s.mass);
        f(s.momentum);
        f(s.active);
        f(s.unit);
        f(s.pushed);
        f(s.held);
    }

    void add(const Component& other)
    {
        mass += other.mass;
        momentum += other.momentum;
        active = active || other.active;
        if (unit != other.unit) unit = -1;
        pushed = pushed || other.pushed;
        held = held || other.held;
    }

    Vec3 velocity() const { return held ? Vec3(Vec3::Zero()) : Vec3(momentum/mass); }

    //- One particle or rigid aggregate that nothing pushes off its path
    bool alone() const { return unit >= 0 && !pushed; }
};

}
