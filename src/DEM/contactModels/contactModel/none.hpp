// SPDX-License-Identifier: GPL-3.0-or-later
//
// The empty part: no constants, no history, no arithmetic.
#pragma once

#include "contactModels/contactModel/PartInput.hpp"

namespace dem
{

struct none
{
    static constexpr const char* model = "none";
    static constexpr bool on = false;
    static constexpr bool elasticOnly = false;
    static constexpr bool bends = false;
    static constexpr bool limitedBySliding = false;
    static constexpr bool limitedByBending = false;
    static constexpr int nConstants = 0;
    static constexpr int nHistory = 0;

    static std::vector<PartKeyword> keywords() { return {}; }

    struct Parameters {};
    static Parameters read(const PartInput&) { return {}; }
};

}
