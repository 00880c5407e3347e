// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a part of a contact law reads its numbers.
#pragma once

#include "contactModels/contactModel/PartKeyword.hpp"
#include "materials/ContactSettings.hpp"

#include <string>
#include <vector>

namespace dem
{

//- Numbers of one part, with checks. `kind` is normal, tangential, rolling or twisting.
class PartInput
{
public:

    //- Errors: inputError on a keyword that is not in `known`
    PartInput
    (
        std::string kind,
        const PartSettings& settings,
        std::vector<PartKeyword> known
    );

    //- What dampingRatio() reads
    static std::vector<PartKeyword> dashpot();

    bool has(const std::string& keyword) const;

    //- Errors: inputError where missing or outside its range
    double get(const std::string& keyword) const;

    double getOr(const std::string& keyword, double otherwise) const;

    //- One of its words. Errors: inputError where missing or another
    std::string word(const std::string& keyword) const;

    //- beta of the dashpot, from `restitution` in (0, 1] or `dampingCoefficient` alpha
    //  (beta = alpha/sqrt(5)); exactly one of the two must be given.
    double dampingRatio() const;

    const std::string& kind() const { return kind_; }

private:

    const PartKeyword* row(const std::string& keyword) const;

    std::string kind_;
    const PartSettings& settings_;
    std::vector<PartKeyword> known_;
};

}
