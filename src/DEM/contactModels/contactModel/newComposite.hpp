// SPDX-License-Identifier: GPL-3.0-or-later
//
// The combinations of one normal law with every sliding, rolling and twisting part. Each
// normal law compiles its own in normal/<law>.cpp, so that a build can share the work.
// To add a part: write its header, name it in newComposite() below and in
// contactModelTable.cpp, and add a test.
#pragma once

#include "contactModels/contactModel/Composite.hpp"
#include "contactModels/rolling/bending.hpp"
#include "contactModels/rolling/springSlider.hpp"
#include "contactModels/tangential/springDashpotSlider.hpp"
#include "contactModels/twisting/cappedSpring.hpp"
#include "contactModels/twisting/springDashpotSlider.hpp"
#include "particles/errors.hpp"

namespace dem
{

template<class Part> struct Chosen { using type = Part; };

//- f(Chosen<Part>()) of that one of the parts whose name is `model`
template<class... Parts, class F>
std::unique_ptr<ContactLaw> choose(const std::string& model, const F& f)
{
    std::unique_ptr<ContactLaw> law;
    ((model == Parts::model ? void(law = f(Chosen<Parts>())) : void()), ...);
    return law;
}

//- The law of these parts. Errors: inputError where they cannot be combined
template<class Normal, class Tangential, class Rolling, class Twisting>
std::unique_ptr<ContactLaw> newCombination()
{
    if constexpr (combines<Normal, Tangential, Rolling, Twisting>)
    {
        return std::make_unique<Composite<Normal, Tangential, Rolling, Twisting>>();
    }
    else if constexpr (!Normal::elastic && Rolling::elasticOnly)
    {
        throw inputError
        (
            "rolling/model",
            std::string(Rolling::model) + " with normal model " + Normal::model
          + ", to which it does not belong",
            "none, or rolling { model bending; ... }"
        );
    }
    else if constexpr (Twisting::limitedBySliding)
    {
        throw inputError
        (
            "twisting/model",
            std::string(Twisting::model)
          + " without a tangential model, whose limit it needs",
            "none, or tangential { model springDashpotSlider; ... }"
        );
    }
    else
    {
        throw inputError
        (
            "twisting/model",
            std::string(Twisting::model) + " without the bending whose limit it needs",
            "none, or rolling { model bending; ... }"
        );
    }
}

//- The names in `s` are known: the table has been asked before
template<class Normal>
std::unique_ptr<ContactLaw> newComposite(const ContactSettings& s)
{
    return choose<none, tangential::springDashpotSlider>(s.tangential.model, [&](auto t)
    {
        return choose<none, rolling::springSlider, rolling::bending>(s.rolling.model, [&](auto r)
        {
            return choose<none, twisting::springDashpotSlider, twisting::cappedSpring>
            (
                s.twisting.model,
                [&](auto w)
                {
                    return newCombination
                    <
                        Normal, typename decltype(t)::type, typename decltype(r)::type,
                        typename decltype(w)::type
                    >();
                }
            );
        });
    });
}

}
