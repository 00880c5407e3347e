// SPDX-License-Identifier: GPL-3.0-or-later
// What the user chooses for the contact of two materials, as names and numbers.
// Which keywords a part takes is the part's own business: see contactModels/.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace dem
{

//- One part of a contact law: model name and its numbers, e.g. {"JKR", {{"restitution", 0.86}}},
//  and words, e.g. {{"unloading", "initial"}}
struct PartSettings
{
    std::string model = "none";
    std::map<std::string, double> values;
    std::map<std::string, std::string> words = {};
};

struct ContactSettings
{
    PartSettings normal;        // Hertz | simplifiedJKR | JKR | DMT | vanDerWaals | cohesivePlastic
    PartSettings tangential;    // springDashpotSlider | none
    PartSettings rolling;       // springSlider | bending | none
    PartSettings twisting;      // springDashpotSlider | cappedSpring | none

    //- Replaces 1/E = sum (1 - nu^2)/E_i [Pa]; still the real value, before softening
    std::optional<double> effectiveYoungsModulus;
    //- Replaces sqrt(gamma_i gamma_j) [J/m2]
    std::optional<double> surfaceEnergy;
};

}
