// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curvature of a triangulated patch from the angles between neighbouring facets.
//
//     K = sum over the edges of a facet (1/2) phi l e e^T/area     [1/m]
//
// phi is the angle by which the surface bends at an edge (convex positive), l and e its length
// and direction; half of each edge belongs to either facet. The principal curvatures are the
// eigenvalues of K that do not belong to the normal (it bends across an edge, so their
// directions change places). On a cylinder of n facets about (pi/n)/sin(pi/n)/R, R that of the
// circle through its corners.
// Source: Cohen-Steiner & Morvan 2003, restricted normal cycle.
// Proof: tests/unit/DEM/ellipticContact.cpp
#pragma once

#include "walls/WallCurvature.hpp"

namespace dem
{

struct Walls;

//- What the triangles of a patch tell of its curvature
struct MeasuredCurvature
{
    static constexpr double tolerance = 0.15;   // of the curvature, from facet to facet
    static constexpr double leastShare = 0.8;

    WallCurvature curvature;    // the medians over the area; flat if no facet shows any
    double share = 1;           // of the area that has it within the tolerance
    double edged = 0;           // of the area, facets with an edge sharper than featureAngle

    //- Whether it may stand for the patch
    bool trusted() const { return share >= leastShare; }
};

//- Edges sharper than walls.featureAngle (as of a cylinder of less than 12 facets) tell nothing:
//  their facets are flat
MeasuredCurvature measureCurvature(const Walls& walls, int patch);

}
