// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "island/IslandState.hpp"
#include "particles/GasExchange.hpp"

#include <vector>

namespace dem
{

//- What the gas gave to each particle in a run of dt that has ended
std::vector<GasExchange> shareOfGas(const IslandState& state, double dt);

//- Whether particle i, which meets a wall in the direction n, came there with the gas: neither
//  did its inertia carry it (it would stop within its radius) nor a force
bool follows(const IslandState& state, int i, const Vec3& n);

}
