// SPDX-License-Identifier: GPL-3.0-or-later
//
// One keyword that a part of a contact law reads: what the part checks it with, what an
// input reader checks it with, and what is printed of it.
#pragma once

#include <string>
#include <vector>

namespace dem
{

struct PartKeyword
{
    std::string name;
    std::string unit;                   // "-" without one
    std::string fallback;               // what holds without it; empty: it must be given
    double low = 0, high = 0;           // both allowed; of a word: 0
    std::vector<std::string> words;     // allowed ones; of a number: none
    std::string meaning;                // one line
};

}
