// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "island/Island.hpp"

namespace dem { using IslandIntegrator = Island; }
