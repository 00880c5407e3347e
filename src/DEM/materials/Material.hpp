// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dem
{

//- One material as the user states it. There are no default values.
struct Material
{
    std::string name;
    double density;         // [kg/m3]; 0 where the material is a wall's only
    double youngsModulus;   // E_i [Pa] > 0, the real one, before any softening
    double poissonRatio;    // nu_i [-] in (-1, 0.5]
    double surfaceEnergy;   // gamma_i [J/m2] >= 0, energy of ONE surface; 0 = no adhesion
};

}
