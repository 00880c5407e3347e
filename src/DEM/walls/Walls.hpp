// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walls that particles touch: triangulated patches and analytic shapes.
//
// A sphere has ONE contact per smooth surface: of the triangles within reach the nearest
// point counts, and further points count only where they belong to another surface, i.e.
// where the way to them crosses an edge sharper than the feature angle or their normals
// differ by more than it. So a diagonal or a coplanar edge is not felt, a convex edge or
// corner is felt once, a concave corner gives one contact per side.
#pragma once

#include "particles/vector.hpp"
#include "walls/WallCurvature.hpp"

#include <optional>
#include <string>
#include <vector>

namespace dem
{

struct WallTriangle
{
    Vec3 a, b, c;   // [m]; the particles are on the side of (b - a) x (c - a)
    int patch;
};

struct WallPlane    { Vec3 point; Vec3 normal; int patch; };                // normal to the gas
struct WallCylinder { Vec3 point; Vec3 axis; double radius; bool inside; int patch; };
struct WallSphere   { Vec3 centre; double radius; bool inside; int patch; };

//- Instead of a material: the patch is a mirror, e.g. a plane of symmetry. What touches it turns
//  round there without friction, adhesion or loss, and is not held by it
inline constexpr int mirror = -1;

struct WallPatch
{
    std::string name;
    int material;       // index into MaterialTable::materials(), or mirror

    //- What contacts adhere by, all over the patch. Not given: that of its shapes, where they
    //  are analytic and alike; else flat
    std::optional<WallCurvature> curvature = {};
};

//- Wall description, plain data; the search structure is the System's own
struct Walls
{
    std::vector<WallPatch> patches;
    std::vector<WallTriangle> triangles;    // in an order that does not depend on ranks
    std::vector<WallPlane> planes;
    std::vector<WallCylinder> cylinders;    // infinite; inside: the particles are within
    std::vector<WallSphere> spheres;
    double featureAngle = 30;               // [deg] an edge sharper than this is a feature
    bool reportImpacts = false;             // list StepReport::wallImpacts

    const std::string& patchName(int patch) const { return patches[std::size_t(patch)].name; }
    bool mirrors(int patch) const { return patches[std::size_t(patch)].material == mirror; }
    const WallCurvature& curvature(int patch) const
    {
        static constexpr WallCurvature flat;
        const auto& given = patches[std::size_t(patch)].curvature;
        return given ? *given : flat;
    }
    bool empty() const;
};

}
