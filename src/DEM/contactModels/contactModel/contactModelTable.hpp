// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of the parts of a contact law and the keywords they take: what an input reader
// needs to refuse unknown words with the list of known ones.
#pragma once

#include "contactModels/contactModel/PartKeyword.hpp"
#include "materials/ContactSettings.hpp"

#include <string>
#include <vector>

namespace dem
{

struct PartEntry
{
    std::string kind;                       // normal | tangential | rolling | twisting
    std::string model;                      // keyword, file name and class name
    std::vector<PartKeyword> keywords;      // all that it reads
};

//- Every part that can be chosen
const std::vector<PartEntry>& contactModelTable();

//- What is left of an elastic law at zero surface energy: Hertz, and nothing resists rolling
ContactSettings withoutAdhesion(ContactSettings settings);

//- Hertz without a dashpot, and nothing else
ContactSettings mirrorSettings();

}
