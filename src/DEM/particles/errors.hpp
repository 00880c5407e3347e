// SPDX-License-Identifier: GPL-3.0-or-later
// The two ways in which the library refuses to go on. It never prints and never exits.
#pragma once

#include <stdexcept>
#include <string>

namespace dem
{

//- Wrong input. The caller knows where the keyword was read and adds file and line.
struct inputError : std::runtime_error
{
    std::string keyword;    // the offending keyword, e.g. "normal/restitution"
    std::string reason;     // what is wrong, with the value given
    std::string allowed;    // what would be accepted

    inputError(std::string keywordIn, std::string reasonIn, std::string allowedIn)
    :
        std::runtime_error
        (
            keywordIn + ": " + reasonIn + " (allowed: " + allowedIn + ")"
        ),
        keyword(std::move(keywordIn)),
        reason(std::move(reasonIn)),
        allowed(std::move(allowedIn))
    {}
};

//- A state that must not be integrated further (NaN, an overlap that no contact law
//  covers). The message names particle, contact and time.
struct numericalError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

}
