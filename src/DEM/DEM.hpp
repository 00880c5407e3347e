// SPDX-License-Identifier: GPL-3.0-or-later
// All that the gas coupling may include of the DEM library.
#pragma once

#include "advice/adviseRatio.hpp"
#include "contactModels/contactModel/contactModelTable.hpp"
#include "contacts/PackedState.hpp"
#include "foundation/Fields.hpp"
#include "materials/MaterialTable.hpp"
#include "particles/errors.hpp"
#include "reducedStiffness/ReducedStiffness.hpp"
#include "system/System.hpp"
#include "timeIntegration/meanDrag.hpp"
#include "walls/measureCurvature.hpp"
