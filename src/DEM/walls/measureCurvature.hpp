// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curvature of a triangulated patch from the angles between neighbouring facets.
//
//     K = sum over the edges of a facet (1/2) phi l e e^T/area     [1/m]
//
// phi is the angle by which the surface bends at an edge (convex positive), l and e its length
// and direction; half of each edge belongs to either facet. The principal curvatures are the
// eigenvalues of K that do not belong to the normal (it bends across an edge, so their
// directions change places), of the mean over the facets about each, twice: snapped meshes have
// large and small angles in turn. On a cylinder of n facets about (pi/n)/sin(pi/n)/R, R that of the
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
    static constexpr double sharpest = 50;      // [deg]

    WallCurvature curvature;    // the medians over the area; flat if no facet shows any
    double share = 1;           // of the area that has it within the tolerance
    double edged = 0;           // of the area, facets with an edge sharper than that angle

    //- Whether it may stand for the patch
    bool trusted() const { return share >= leastShare; }
};

//- Sharper edges (as of a cylinder of less than 8 facets) tell nothing: their facets are flat
MeasuredCurvature measureCurvature(const Walls& walls, int patch);

}
