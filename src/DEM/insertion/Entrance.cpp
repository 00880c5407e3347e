// SPDX-License-Identifier: GPL-3.0-or-later
#include "insertion/Entrance.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

Entrance::Entrance
(
    const std::vector<Particle>& particles, const WallSearch& walls, const Periodic& periodic,
    const Box& box, double dt, double largest, double fastest
)
:
    walls_(walls),
    periodic_(periodic),
    dt_(dt)
{
    const Vec3 middle = box.middle(), half = 0.5*(box.high - box.low);
    double radius = largest;
    for (const Particle& p : particles)
    {
        // the box about its path reaches one of the spheres that may enter
        const Vec3 d = periodic.nearest(p.x + 0.5*dt*p.v - middle);
        const double around = p.radius + largest;
        const Vec3 reach = (half + 0.5*dt*p.v.cwiseAbs()).array() + around;
        if ((d.cwiseAbs().array() > reach.array()).any()) continue;
        spheres_.push_back({p.x, p.v, p.radius, 0});
        radius = std::max(radius, p.radius);
        fastest = std::max(fastest, p.v.norm());
    }
    width_ = std::max(2*radius + dt*fastest, 1e-300);

    std::vector<Sphere> near;
    near.swap(spheres_);
    for (const Sphere& s : near) keep(s);
}


std::int64_t Entrance::key(std::int64_t i, std::int64_t j, std::int64_t k)
{
    // different cells may share a key: distances decide
    return (i*73856093) ^ (j*19349663) ^ (k*83492791);
}


void Entrance::keep(const Sphere& s)
{
    const Vec3 middle = periodic_.wrapped(s.x + 0.5*(dt_ - s.start)*s.v);
    cells_.emplace(key(cell(middle[0]), cell(middle[1]), cell(middle[2])), spheres_.size());
    spheres_.push_back(s);
}


void Entrance::enter(const Vec3& x, const Vec3& v, double radius, double delay)
{
    keep({x, v, radius, delay});
}


double Entrance::amongSpheres(const Vec3& x, double radius, double delay) const
{
    // A path that comes near x has its middle within one cell of it; of images, too
    double largest = -1e300;
    const auto look = [&](const Vec3& at)
    {
        const std::int64_t i = cell(at[0]), j = cell(at[1]), k = cell(at[2]);
        for (int n = 0; n < 27; ++n)
        {
            const auto range =
                cells_.equal_range(key(i + n/9 - 1, j + n/3%3 - 1, k + n%3 - 1));
            for (auto s = range.first; s != range.second; ++s)
            {
                const Sphere& o = spheres_[s->second];
                const Vec3 there = o.x + std::max(delay - o.start, 0.0)*o.v;
                const double distance = periodic_.nearest(there - x).norm();
                largest = std::max(largest, radius + o.radius - distance);
            }
        }
    };
    look(x);
    if (!periodic_.on()) return largest;
    for (int n = 0; n < 27; ++n)
    {
        const Vec3 shift
        (
            (n/9 - 1)*periodic_.length[0], (n/3%3 - 1)*periodic_.length[1],
            (n%3 - 1)*periodic_.length[2]
        );
        if (shift.squaredNorm() > 0) look(x + shift);
    }
    return largest;
}


double Entrance::overlap
(
    const Vec3& x, double radius, double delay, std::string& wall
) const
{
    wall.clear();
    double largest = amongSpheres(x, radius, delay);

    // far walls do not matter: three radii will do
    const double range = 3*radius;
    std::vector<int> surfaces;
    std::vector<WallHit> hits;
    walls_.query(x.array() - range, x.array() + range, surfaces);
    walls_.hits(x, range, surfaces.data(), surfaces.size(), hits);
    for (const WallHit& h : hits)
    {
        if (radius - h.distance <= largest) continue;
        largest = radius - h.distance;
        wall = walls_.walls().patchName(h.patch);
    }
    return largest;
}

}
