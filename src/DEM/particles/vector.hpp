// SPDX-License-Identifier: GPL-3.0-or-later
// The vector type of the DEM library: three doubles, [m], [m/s], ... as said where used.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace dem
{
using Vec3 = Eigen::Vector3d;
}
