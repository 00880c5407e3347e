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

#include "adhesionMargin.H"
#include "functionKeywords.H"
#include "dustCloud.H"
#include "dustSnapshot.H"
#include "addToRunTimeSelectionTable.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(adhesionMargin, 0);
    addToRunTimeSelectionTable(functionObject, adhesionMargin, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::adhesionMargin::adhesionMargin
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    file_
    (
        runTime,
        name,
        "adhesionMargin",
        "time_s,min,p01,p50,limit,violations"
    )
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::adhesionMargin::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    functionKeywords::check(dict);
    cloudName_ = functionKeywords::cloud(dict, mesh_);
    return true;
}


bool Foam::functionObjects::adhesionMargin::write()
{
    const dustCloud& cloud = mesh_.lookupObject<dustCloud>(cloudName_);

    // Sorted
    const std::vector<double>& margins = cloud.snapshot().margins;

    if (margins.empty())
    {
        return true;
    }

    const auto percentile = [&margins](const scalar share)
    {
        const std::size_t n = margins.size();
        return margins[std::min(n - 1, std::size_t(share*scalar(n)))];
    };
    const scalar limit = cloud.marginLimit();

    file_.row
    (
        time_.value(),
        margins.front(),
        percentile(0.01),
        percentile(0.5),
        limit,
        std::lower_bound(margins.begin(), margins.end(), limit)
      - margins.begin()
    );

    return true;
}


// ************************************************************************* //
