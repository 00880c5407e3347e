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

#include "controlKeywords.H"

#include <algorithm>
#include <cctype>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const wordList ofControlDict
({
    "FoamFile", "application", "startFrom", "startTime", "stopAt", "endTime",
    "deltaT", "adjustTimeStep", "maxCo", "maxDeltaT", "maxWallTime",
    "writeControl", "writeInterval", "writeFrequency", "purgeWrite",
    "secondaryWriteControl", "secondaryWriteInterval", "secondaryPurgeWrite",
    "writeFormat", "writePrecision", "writeVersion", "writeCompression",
    "timeFormat", "timePrecision", "graphFormat", "runTimeModifiable",
    "beginTime", "libs", "functions", "profiling", "fileHandler",
    "printExecutionFormat", "DebugSwitches", "InfoSwitches",
    "OptimisationSwitches", "DimensionedConstants", "DimensionSets"
});


static std::string lower(std::string s)
{
    std::transform
    (
        s.begin(),
        s.end(),
        s.begin(),
        [](const unsigned char c) { return char(std::tolower(c)); }
    );
    return s;
}


//- Equal but for one letter that is missing, added, another, or exchanged with
//  its neighbour
static bool oneMistake(const std::string& a, const std::string& b)
{
    const std::size_t n = std::min(a.size(), b.size());
    std::size_t i = 0;
    while (i < n && a[i] == b[i])
    {
        ++i;
    }
    const auto restEqual = [&](const std::size_t fromA, const std::size_t fromB)
    {
        return
            fromA <= a.size() && fromB <= b.size()
         && a.compare(fromA, std::string::npos, b, fromB, std::string::npos)
         == 0;
    };
    return
        restEqual(i + 1, i)
     || restEqual(i, i + 1)
     || restEqual(i + 1, i + 1)
     || (
            i + 1 < n
         && a[i] == b[i + 1]
         && a[i + 1] == b[i]
         && restEqual(i + 2, i + 2)
        );
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::controlKeywords::mistaken
(
    const std::string& given,
    const std::string& meant
)
{
    const std::string a(lower(given)), b(lower(meant));
    return given != meant && (a == b || oneMistake(a, b));
}


void Foam::controlKeywords::check(const dictionary& dict, const wordList& known)
{
    wordList others;
    for (const entry& e : dict)
    {
        const word& keyword = e.keyword();
        if (known.found(keyword))
        {
            continue;
        }
        for (const word& meant : known)
        {
            if (mistaken(keyword, meant))
            {
                dustProperties::error
                (
                    dict,
                    keyword,
                    "is not read by OpenFOAM or dustFoam",
                    meant + "; a variable of your own needs a name that is not"
                    " mistaken for it"
                );
            }
        }
        others.append(keyword);
    }

    if (others.size())
    {
        Info<< "In " << dict.dictName() << ", not read by OpenFOAM or"
            << " dustFoam:";
        for (const word& keyword : others)
        {
            Info<< ' ' << keyword;
        }
        Info<< nl << endl;
    }
}


void Foam::controlKeywords::check(const dictionary& controlDict)
{
    check(controlDict, ofControlDict);
}


// ************************************************************************* //
