// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether there is room for new spheres at given places and moments of the next particle step.
//
//     Entrance entrance(box, dt, ...);
//     for (new spheres, in order of their moments)
//         if (entrance.overlap(x, r, delay, wall) < 0) entrance.enter(x, v, r, delay);
//
// Particles are taken to move on by their velocity until then, new ones from the moment on at
// which they enter: who finds room does not depend on where particle steps begin and end. The
// particles are looked at once, the places of those near the box kept in a grid: each question
// costs the same whatever the number of particles.
// Proof: tests/unit/DEM/entrance.cpp
#pragma once

#include "neighbourSearch/BoxGrid.hpp"
#include "neighbourSearch/Periodic.hpp"
#include "particles/Particle.hpp"
#include "walls/WallSearch.hpp"

#include <string>
#include <unordered_map>
#include <vector>

namespace dem
{

class Entrance
{
public:

    //- New spheres, none of more than `largest` radius [m], at most `fastest` [m/s], may be at
    //  the places in the box within the next dt [s]; particles: at least all whose way in that
    //  time comes near. The walls are not copied.
    Entrance
    (
        const std::vector<Particle>& particles, const WallSearch& walls,
        const Periodic& periodic, const Box& box, double dt, double largest, double fastest
    );

    //- Largest overlap [m] of a sphere at x, `delay` [s] after the start of the step, with a
    //  wall or a particle; negative = free. wall: which patch it is, "" = a particle
    double overlap(const Vec3& x, double radius, double delay, std::string& wall) const;

    //- The sphere enters: the next ones find it in their way
    void enter(const Vec3& x, const Vec3& v, double radius, double delay);


private:

    struct Sphere
    {
        Vec3 x;
        Vec3 v;
        double radius;
        double start;   // when it is at x [s]
    };

    std::int64_t cell(double x) const { return std::int64_t(std::floor(x/width_)); }
    static std::int64_t key(std::int64_t i, std::int64_t j, std::int64_t k);
    void keep(const Sphere& s);
    double amongSpheres(const Vec3& x, double radius, double delay) const;

    const WallSearch& walls_;
    const Periodic periodic_;
    const double dt_;
    double width_ = 0;              // of a cell: no path with its sphere is longer
    std::vector<Sphere> spheres_;
    std::unordered_multimap<std::int64_t, std::size_t> cells_;     // by the middle of the path
};

}
