/*---------------------------------------------------------------------------*\
    dustFoam: adhesive dust in ventilation ducts
-------------------------------------------------------------------------------
License
    This file is part of dustFoam.

    dustFoam is free software: you can redistribute it and/or modify it under
    the terms of the GNU General Public License as published by the Free
    Software Foundation, either version 3 of the License, or (at your option)
    any later version.

    dustFoam is distributed in the hope that it will be useful, but WITHOUT ANY
    WARRANTY; without even the implied warranty of MERCHANTABILITY or FITNESS
    FOR A PARTICULAR PURPOSE.  See the GNU General Public License for more
    details.

    You should have received a copy of the GNU General Public License along
    with dustFoam.  If not, see <http://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/


// First: includes DEM.hpp
#include "dustProperties.H"

#include "sizeCheck.H"

#include "ITstream.H"
#include "scalarField.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Smallest part of a distribution that may lie between its bounds: of less,
//  what is drawn is not what the numbers say, to the last digit of a scalar
static const scalar leastShare = 1e-6;


static void refuseShare
(
    const dictionary& numbers,
    const word& keyword,
    const scalar share
)
{
    dustProperties::error
    (
        numbers,
        keyword,
        "between minValue and maxValue lies a share of " + Foam::name(share)
      + " of the distribution",
        "a share of " + Foam::name(leastShare)
      + " or more: bounds where the particles are"
    );
}


static void checkBounds(const dictionary& numbers)
{
    scalar low, high;
    if
    (
        numbers.readIfPresent("minValue", low)
     && numbers.readIfPresent("maxValue", high)
     && !(low < high)
    )
    {
        dustProperties::error
        (
            numbers,
            "maxValue",
            "is " + Foam::name(high) + ", minValue " + Foam::name(low),
            "minValue < maxValue"
        );
    }
}


static void checkNormal
(
    const dictionary& numbers,
    const scalar low,
    const scalar high
)
{
    scalar mean, width;
    if
    (
        numbers.readIfPresent("expectation", mean)
     && numbers.readIfPresent("variance", width)
    )
    {
        const scalar share =
            0.5*(std::erf((high - mean)/width) - std::erf((low - mean)/width));
        if (share < leastShare)
        {
            refuseShare(numbers, "expectation", share);
        }
    }
}


static void checkExponential
(
    const dictionary& numbers,
    const scalar low,
    const scalar high
)
{
    // Of exp(-lambda d) something must be left at minValue, and it must differ
    // from that at maxValue
    const scalar lambda = numbers.get<scalar>("lambda");
    const scalar least = 1e-9/(high - low);
    const scalar most = 600/low;
    if (lambda < least || lambda > most)
    {
        dustProperties::error
        (
            numbers,
            "lambda",
            "is " + Foam::name(lambda) + " 1/m, for sizes of "
          + Foam::name(low) + " to " + Foam::name(high) + " m",
            Foam::name(least) + " to " + Foam::name(most) + " 1/m"
        );
    }
}


//- Of the Weibull distribution from minValue on
static void checkRosinRammler
(
    const dictionary& numbers,
    const scalar low,
    const scalar high
)
{
    scalar d;
    if (numbers.readIfPresent("d", d))
    {
        // Not pow: it may overflow
        const scalar x = numbers.get<scalar>("n")*std::log((high - low)/d);
        const scalar share = -std::expm1(-std::exp(min(x, scalar(600))));
        if (share < leastShare || x > 600)
        {
            refuseShare(numbers, "d", x > 600 ? 0 : share);
        }
    }
}


//- By mass: what lies outside the bounds is drawn again
static void checkMassRosinRammler
(
    const dictionary& numbers,
    const scalar low,
    const scalar high
)
{
    scalar d;
    if (!numbers.readIfPresent("d", d))
    {
        return;
    }
    const scalar n = numbers.get<scalar>("n");
    const label nParts = 10000;
    const scalar step = std::log(high/low)/nParts;
    scalar share = 0;
    for (label i = 0; i < nParts; ++i)
    {
        // Number of particles per logarithm of the diameter
        const scalar x = std::log(low/d) + (i + 0.5)*step;
        const scalar f = (n + 3)*x - std::exp(min(n*x, scalar(600)));
        share += step*n*std::exp(max(f - std::lgamma(3/n + 1), scalar(-600)));
    }
    if (share < leastShare)
    {
        refuseShare(numbers, "d", share);
    }
}


static void checkMultiNormal
(
    const dictionary& numbers,
    const scalar low,
    const scalar high
)
{
    if
    (
        !numbers.found("expectation")
     || !numbers.found("variance")
     || !numbers.found("strength")
    )
    {
        return;
    }
    const scalarList mean(numbers.lookup("expectation"));
    const scalarList width(numbers.lookup("variance"));
    const scalarList strength(numbers.lookup("strength"));
    for (const word keyword : {"variance", "strength"})
    {
        const label size = (keyword == "variance" ? width : strength).size();
        if (size != mean.size())
        {
            dustProperties::error
            (
                numbers,
                keyword,
                "has " + Foam::name(size) + " numbers, expectation "
              + Foam::name(mean.size()),
                "one for each expectation"
            );
        }
    }
    if (sum(strength) <= 0)
    {
        dustProperties::error
        (
            numbers, "strength", "is 0 for all", "above 0 for one or more"
        );
    }

    // As OpenFOAM draws: places between the bounds, kept by lot. The share that
    // is kept
    const auto density = [&](const scalar x)
    {
        scalar p = 0;
        forAll(mean, i)
        {
            p += strength[i]*std::exp(-0.5*sqr((x - mean[i])/width[i]));
        }
        return p;
    };
    scalar most = 0;
    for (const scalar m : mean)
    {
        most = max(most, density(m));
    }
    const label nParts = 10000;
    scalar kept = 0;
    for (label i = 0; i < nParts; ++i)
    {
        kept += density(low + (i + 0.5)/nParts*(high - low))/most/nParts;
    }
    const scalar least = 1e-3;
    if (kept < least)
    {
        dustProperties::error
        (
            numbers,
            "expectation",
            "of sizes between minValue and maxValue a share of "
          + Foam::name(kept) + " is as frequent as the most frequent one",
            Foam::name(least) + " or more: bounds where the particles are"
        );
    }
}


//- `((d weight) (d weight))`, perhaps with a number before it. False: it is not.
static bool readPoints
(
    const ITstream& is,
    scalarList& diameters,
    scalarList& weights
)
{
    const label first = is.size() && is[0].isLabel();
    const label n = (is.size() - first - 2)/4;
    if
    (
        is.size() != first + 2 + 4*n
     || is[first] != token(token::BEGIN_LIST)
     || is[is.size() - 1] != token(token::END_LIST)
    )
    {
        return false;
    }
    diameters.setSize(n);
    weights.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        const label k = first + 1 + 4*i;
        if
        (
            is[k] != token(token::BEGIN_LIST)
         || !is[k + 1].isNumber() || !dem::isFinite(is[k + 1].number())
         || !is[k + 2].isNumber() || !dem::isFinite(is[k + 2].number())
         || is[k + 3] != token(token::END_LIST)
        )
        {
            return false;
        }
        diameters[i] = is[k + 1].number();
        weights[i] = is[k + 2].number();
    }
    return true;
}


//- What is wrong with points and weights; empty: nothing
static string faultOfPoints
(
    const scalarList& diameters,
    const scalarList& weights,
    const bool line
)
{
    bool any = false;
    forAll(diameters, i)
    {
        const scalar d = diameters[i];
        const scalar w = weights[i];
        const string point("has (" + Foam::name(d) + " " + Foam::name(w) + ")");
        if (d < 1e-10 || d > 1)
        {
            return point + ", a diameter of " + Foam::name(d) + " m";
        }
        if (w != 0 && (w < 1e-12 || w > 1e12))
        {
            return point + ", a weight of " + Foam::name(w);
        }
        any = any || w > 0;
        if (i && !(d > diameters[i - 1]))
        {
            return point + " after a diameter of " + Foam::name(diameters[i - 1]);
        }
        // Of a line that hardly slopes OpenFOAM finds no point
        if
        (
            line && i && w != weights[i - 1]
         && mag(w - weights[i - 1]) < 1e-9*w
        )
        {
            return
                point + ", whose weight differs from the one before in the last"
                " digits";
        }
    }
    return any ? "" : "has no weight above 0";
}


static void checkPoints(const word& model, const dictionary& numbers)
{
    const word keyword("distribution");
    const bool line = model == "general";
    const string allowed
    (
        string("((d weight) (d weight) ...), ")
      + (line ? "two or more" : "one or more")
      + ", diameters of 1e-10 to 1 m, ascending, weights 0 or 1e-12 to 1e12,"
        " not all of them 0"
    );
    scalarList diameters, weights;
    const ITstream& is =
        numbers.lookupEntry(keyword, keyType::LITERAL).stream();
    if (!readPoints(is, diameters, weights))
    {
        dustProperties::error
        (
            numbers, keyword, "is not a list of pairs of numbers", allowed
        );
    }
    const string wrong
    (
        diameters.size() < (line ? 2 : 1)
      ? "has " + Foam::name(diameters.size()) + " points"
      : faultOfPoints(diameters, weights, line)
    );
    if (!wrong.empty())
    {
        dustProperties::error(numbers, keyword, wrong, allowed);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::sizeCheck::check(const word& model, const dictionary& numbers)
{
    if (model == "general" || model == "binned")
    {
        checkPoints(model, numbers);
        return;
    }
    checkBounds(numbers);

    const scalar low = numbers.lookupOrDefault<scalar>("minValue", 0);
    const scalar high = numbers.lookupOrDefault<scalar>("maxValue", 0);
    if (model == "normal")
    {
        checkNormal(numbers, low, high);
    }
    else if (model == "exponential")
    {
        checkExponential(numbers, low, high);
    }
    else if (model == "RosinRammler")
    {
        checkRosinRammler(numbers, low, high);
    }
    else if (model == "massRosinRammler")
    {
        checkMassRosinRammler(numbers, low, high);
    }
    else if (model == "multiNormal")
    {
        checkMultiNormal(numbers, low, high);
    }
}


// ************************************************************************* //
