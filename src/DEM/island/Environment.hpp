// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contactModels/contactModel/ContactLaw.hpp"
#include "materials/MaterialTable.hpp"
#include "neighbourSearch/Periodic.hpp"
#include "timeIntegration/TimeSettings.hpp"
#include "walls/WallSearch.hpp"

namespace dem
{

//- What all islands live in
struct Environment
{
    const MaterialTable& materials;
    TimeSettings time;
    const WallSearch& walls;
    const Periodic& periodic;

    const ContactLaw& law(std::size_t l) const { return *materials.laws()[l]; }
    int wallMaterial(int patch) const
    {
        return walls.walls().patches[std::size_t(patch)].material;
    }
    bool mirrors(int patch) const { return wallMaterial(patch) == mirror; }
};

}
