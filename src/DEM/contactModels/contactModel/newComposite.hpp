// SPDX-License-Identifier: GPL-3.0-or-later
//
// The combinations of one normal law with every sliding, rolling and twisting part. Each
// normal law compiles its own in normal/<law>.cpp, so that a build can share the work.
#pragma once

#include "contactModels/contactModel/Composite.hpp"
#include "contactModels/rolling/springSlider.hpp"
#include "contactModels/tangential/springDashpotSlider.hpp"
#include "contactModels/twisting/springDashpotSlider.hpp"

namespace dem
{

//- The names in `s` are known and can be combined: the table has been asked before
template<class Normal>
std::unique_ptr<ContactLaw> newComposite(const ContactSettings& s)
{
    using Sliding = tangential::springDashpotSlider;
    using Roll = rolling::springSlider;
    using Twist = twisting::springDashpotSlider;

    const bool t = s.tangential.model != none::model;
    const bool r = s.rolling.model != none::model;
    const bool w = s.twisting.model != none::model;

    if (t && r && w) return std::make_unique<Composite<Normal, Sliding, Roll, Twist>>();
    if (t && r) return std::make_unique<Composite<Normal, Sliding, Roll, none>>();
    if (t && w) return std::make_unique<Composite<Normal, Sliding, none, Twist>>();
    if (t) return std::make_unique<Composite<Normal, Sliding, none, none>>();
    if (r) return std::make_unique<Composite<Normal, none, Roll, none>>();
    return std::make_unique<Composite<Normal, none, none, none>>();
}

}
