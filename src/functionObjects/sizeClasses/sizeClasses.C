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

#include "OStringStream.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sizeClasses::read(const dictionary& dict)
{
    const scalarList limits(dict.get<scalarList>("diameters"));
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
            "diameters",
            given.str(),
            "two or more limits of classes in m, ascending, the same for the"
            " whole run"
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
