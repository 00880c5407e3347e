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

#include "allowance.H"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <sstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::allowance::allowance(const std::string& text)
{
    std::istringstream is(text);
    for (std::string part; is >> part;)
    {
        const bool low = part[0] == '>';
        const bool high = part[0] == '<';

        if (low || high)
        {
            const bool closed = part.size() > 1 && part[1] == '=';
            (low ? hasLow_ : hasHigh_) = true;
            (low ? openLow_ : openHigh_) = !closed;
            (low ? low_ : high_) = std::atof(part.c_str() + 1 + closed);
        }
        else if (std::isdigit(part[0]))
        {
            single_.push_back(std::atof(part.c_str()));
        }
        else
        {
            words_.push_back(part);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::allowance::contains(const scalar value) const
{
    if (std::find(single_.begin(), single_.end(), value) != single_.end())
    {
        return true;
    }
    return
        (hasLow_ || hasHigh_ || single_.empty())
     && (!hasLow_ || (openLow_ ? value > low_ : value >= low_))
     && (!hasHigh_ || (openHigh_ ? value < high_ : value <= high_));
}


bool Foam::allowance::contains(const std::string& word) const
{
    return std::find(words_.begin(), words_.end(), word) != words_.end();
}


std::string Foam::allowance::listed(const std::string& text)
{
    std::istringstream is(text);
    std::string all;
    for (std::string part; is >> part;)
    {
        const std::size_t sign = std::strspn(part.c_str(), "<>=");
        if (sign)
        {
            part.insert(sign, " ");
        }
        all += (all.empty() ? "" : ", ") + part;
    }
    return all;
}


// ************************************************************************* //
