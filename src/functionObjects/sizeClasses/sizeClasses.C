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

#include "dustProperties.H"
#include "sizeClasses.H"

#include "ITstream.H"
#include "OStringStream.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Why an entry is no list of finite numbers; empty: it is one
static string faultOfList(const entry* e)
{
    if (!e || !e->isStream())
    {
        return e ? "is a dictionary" : "is missing";
    }
    const ITstream& is = e->stream();
    label numbers = 0;
    for (const token& t : is)
    {
        if (t.isNumber() && dem::isFinite(t.number()))
        {
            ++numbers;
        }
        else if (!t.isPunctuation())
        {
            return "is not a list of numbers";
        }
    }
    const label others = is.size() - numbers;
    return
        others == 2 && is[is.size() - 1] == token(token::END_LIST)
      ? ""
      : "is not a list of numbers";
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sizeClasses::read(const dictionary& dict)
{
    const word keyword("diameters");
    const string allowed
    (
        "two or more limits of classes in m, in parentheses, ascending, the"
        " same for the whole run"
    );
    const string wrong(faultOfList(dict.findEntry(keyword, keyType::LITERAL)));
    if (!wrong.empty())
    {
        dustProperties::error(dict, keyword, wrong, allowed);
    }

    const scalarList limits(dict.get<scalarList>(keyword));
    bool ascending = limits.size() >= 2 && limits[0] >= 0;
    for (label i = 1; i < limits.size(); ++i)
    {
        ascending = ascending && limits[i] > limits[i - 1];
    }
    if (!ascending || (limits_.size() && limits != limits_))
    {
        OStringStream given;
        given<< "is " << limits << (ascending ? ", others than before" : "");
        dustProperties::error
        (
            dict,
            keyword,
            given.str(),
            allowed
        );
    }
    limits_ = limits;
}


Foam::label Foam::sizeClasses::of(const scalar d) const
{
    const label above = label
    (
        std::upper_bound(limits_.begin(), limits_.end(), d) - limits_.begin()
    );
    return above > 0 && above <= size() ? above - 1 : size();
}


// ************************************************************************* //
