// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the contacts of a sphere with the walls.
//
// On a triangulated surface a contact is a local minimum of the distance from the centre to
// the surface: a nearest point on an edge or a corner counts only if no triangle that shares
// it comes nearer. So diagonals and coplanar edges are not felt and convex edges are felt
// once. Of minima whose normals lie within the feature angle (a faceted concave surface)
// only the nearest is kept: one contact per smooth surface.
#pragma once

#include "walls/Walls.hpp"

#include <array>
#include <vector>

namespace dem
{

//- One touching or nearby surface
struct WallHit
{
    Vec3 n;             // unit vector from the centre to the wall
    double distance;    // from the centre [m]
    int patch;
};

class WallSearch
{
public:

    //- Errors: inputError on degenerate triangles, patches out of range
    explicit WallSearch(Walls walls);

    const Walls& walls() const { return walls_; }

    //- Surfaces (triangles and shapes) that the box reaches
    void query(const Vec3& low, const Vec3& high, std::vector<int>& surfaces) const;

    //- Whether a surface comes within range of x
    bool within(int surface, const Vec3& x, double range) const;

    //- Contacts within range of x among the surfaces; nearest first
    void hits
    (
        const Vec3& x, double range, const int* surfaces, std::size_t nSurfaces,
        std::vector<WallHit>& result
    ) const;

    //- Shortest time [s] in which a centre moving from x with v could come within radius +
    //  touch[patch] of a surface, if its acceleration stays below bound [m/s2]
    double timeToTouch
    (
        const Vec3& x, const Vec3& v, double bound, double radius,
        const std::vector<double>& touch, const int* surfaces, std::size_t nSurfaces
    ) const;

private:

    struct Topology
    {
        std::array<int, 3> vertex;
        Vec3 normal;
    };

    struct Node
    {
        Vec3 low, high;
        int left, right;    // children; left < 0: leaf of order_[first, last)
        int first, last;
    };

    int build(int first, int last);
    int patchOf(int surface) const;
    WallHit shapeHit(int shape, const Vec3& x) const;
    double nearest(int surface, const Vec3& x, Vec3& point, int& feature) const;

    Walls walls_;
    std::vector<Topology> topology_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
    std::vector<Vec3> centre_;
    double cosFeature_;
};

//- Time after which a gap could close: gap - c t - K t^2/2 >= 0, c the closing speed, K a
//  bound of its rate of change. Never too late for surfaces that are convex from outside.
double closingTime(double gap, double closingSpeed, double bound);

//- What the gap of a sphere is known to [m]; what is nearer than that touches within the
//  time that this takes
inline double gapResolution(const Vec3& x, double radius)
{
    return 16*2.2e-16*(x.lpNorm<Eigen::Infinity>() + radius);
}

}
