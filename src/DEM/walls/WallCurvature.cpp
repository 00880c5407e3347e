// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls/WallCurvature.hpp"

#include "particles/errors.hpp"
#include "walls/Walls.hpp"

#include <sstream>
#include <string>

namespace dem
{

void deriveCurvature(Walls& walls)
{
    for (std::size_t p = 0; p < walls.patches.size(); ++p)
    {
        if (walls.patches[p].curvature) continue;
        bool any = false, alike = true;
        WallCurvature curvature;
        const auto add = [&](int patch, const WallCurvature& k)
        {
            if (patch != int(p)) return;
            alike = alike && (!any || (k.k1 == curvature.k1 && k.k2 == curvature.k2));
            any = true;
            curvature = k;
        };
        for (const WallTriangle& t : walls.triangles) add(t.patch, {});
        for (const WallPlane& s : walls.planes) add(s.patch, {});
        for (const WallCylinder& s : walls.cylinders)
        {
            add(s.patch, {(s.inside ? -1 : 1)/s.radius, 0});
        }
        for (const WallSphere& s : walls.spheres)
        {
            const double k = (s.inside ? -1 : 1)/s.radius;
            add(s.patch, {k, k});
        }
        if (any && alike && !curvature.flat()) walls.patches[p].curvature = curvature;
    }
}


void checkCurvature(const Walls& walls, double radius, std::int64_t id)
{
    constexpr double widest = 10;       // R_1/r
    constexpr double slimmest = 1e-3;   // R_2/R_1
    for (const WallPatch& p : walls.patches)
    {
        if (!p.curvature || p.curvature->flat()) continue;
        const double low = p.curvature->smaller(radius), high = p.curvature->larger(radius);
        const bool fits = low*radius >= 1/widest;
        if (fits && high*slimmest <= low) continue;

        std::ostringstream reason;
        reason
            << (id < 0 ? "a particle" : "particle " + std::to_string(id))
            << " with a diameter of " << 2*radius << " m "
            << (fits ? "meets a wall that is too slim for it" : "does not fit into its hollow")
            << " (principal curvatures " << p.curvature->k1 << " and " << p.curvature->k2
            << " 1/m)";
        throw inputError
        (
            "patchCurvature/" + p.name, reason.str(),
            fits
          ? "relative radii whose ratio is at least 0.001, or flat"
          : "a hollow of a radius of at least 1/0.9 of the particle's, or flat"
        );
    }
}

}
