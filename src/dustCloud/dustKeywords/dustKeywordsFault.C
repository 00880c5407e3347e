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

#include "allowance.H"
#include "dustKeywords.H"

#include "ITstream.H"
#include "Switch.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What the tokens of an entry look like
static std::string text(const ITstream& is)
{
    std::ostringstream os;
    for (const token& t : is)
    {
        OSstream out(os, "text");
        out.precision(10);
        os << (os.str().empty() ? "" : " ");
        out << t;
    }
    return os.str();
}


//- A finite number. Of the bits: comparing what is none could trap
static bool finite(const token& t)
{
    return t.isNumber() && dem::isFinite(t.number());
}


static bool isWord(const ITstream& is)
{
    return is.size() == 1 && (is[0].isWord() || is[0].isString());
}


static std::string givenWord(const ITstream& is)
{
    return is[0].isWord() ? is[0].wordToken() : is[0].stringToken();
}


//- What is wrong with what should be a number; empty: nothing
static std::string faultOfNumber
(
    const ITstream& is,
    const bool whole,
    const allowance& allowed
)
{
    const std::string given = "is '" + text(is) + "', ";

    if (is.size() > 1 && is[0].isNumber())
    {
        return given + "more than one number";
    }
    if (is.size() != 1 || !finite(is[0]))
    {
        return given + "not a number";
    }
    if (whole && !is[0].isLabel())
    {
        return given + "not a whole number that can be counted to";
    }
    return allowed.contains(is[0].number()) ? "" : "is " + text(is);
}


//- The same of three numbers
static std::string faultOfVector
(
    const ITstream& is,
    const allowance& allowed
)
{
    bool three = is.size() == 5;
    for (label i = 1; three && i < 4; ++i)
    {
        three = finite(is[i]);
    }
    if
    (
        !three
     || is[0] != token(token::BEGIN_LIST)
     || is[4] != token(token::END_LIST)
    )
    {
        return "is '" + text(is) + "', not three numbers in parentheses";
    }
    for (label i = 1; i < 4; ++i)
    {
        if (!allowed.contains(is[i].number()))
        {
            return "is " + text(is);
        }
    }
    return "";
}


//- The same of one number or more, in parentheses
static std::string faultOfNumbers
(
    const ITstream& is,
    const allowance& allowed
)
{
    const label last = is.size() - 1;
    if
    (
        last < 1
     || is[0] != token(token::BEGIN_LIST)
     || is[last] != token(token::END_LIST)
    )
    {
        return "is '" + text(is) + "', not a list of numbers in parentheses";
    }
    for (label i = 1; i < last; ++i)
    {
        const std::string wrong =
            faultOfNumber(ITstream("", tokenList(1, is[i])), false, allowed);
        if (!wrong.empty())
        {
            return wrong;
        }
    }
    return last < 2 ? "is empty" : "";
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::dustKeywords::fault(const ITstream& is, const row& r)
{
    const allowance allowed(r.allowed);
    const std::string given = "is '" + text(is) + "', ";

    if (is.empty())
    {
        return "has no value";
    }
    if (isWord(is) && allowed.contains(givenWord(is)))
    {
        return "";
    }

    switch (r.kind)
    {
        case number:
        case integer:
        {
            return faultOfNumber(is, r.kind == integer, allowed);
        }
        case vector:
        {
            return faultOfVector(is, allowed);
        }
        case numbers:
        {
            return faultOfNumbers(is, allowed);
        }
        case flag:
        {
            const bool known =
                is.size() == 1
             && (
                    (is[0].isLabel() && (is[0].labelToken() & ~1) == 0)
                 || (isWord(is) && Switch(givenWord(is), true).valid())
                );
            return known ? "" : given + "not a switch";
        }
        case name:
        {
            if (!isWord(is))
            {
                return given + "not one word";
            }
            return
                allowed.words().empty()
              ? ""
              : "unknown value '" + givenWord(is) + "'";
        }
        case block:
        case model:
        {
            return given + "not a dictionary";
        }
        default:
        {
            return "";
        }
    }
}


// ************************************************************************* //
