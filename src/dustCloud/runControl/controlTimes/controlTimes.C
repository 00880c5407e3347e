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
#include "controlTimes.H"

#include "ITstream.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- <prefix>Control and its <prefix>Interval
static void checkControl
(
    const dictionary& dict,
    const std::string& prefix,
    const scalar lastTime
)
{
    const word keyword(prefix + "Control");
    const word interval(prefix + "Interval");
    const entry* e = dict.findEntry(keyword, keyType::LITERAL);
    word control("timeStep");
    if (e && e->isStream() && e->stream().size() == 1 && e->stream()[0].isWord())
    {
        control = e->stream()[0].wordToken();
    }

    using controlTimes::number;
    if (control == "cpuTime" || control == "clockTime")
    {
        number(dict, interval, ">=1e-3 <=1e15", 1);
    }
    else if (control == "runTime" || control.find("adjustable") == 0)
    {
        // OpenFOAM counts the intervals since the start
        const scalar s = number(dict, interval, ">=1e-15 <=1e15", GREAT);
        if (lastTime/s > 2e9)
        {
            dustProperties::error
            (
                dict,
                interval,
                "is " + Foam::name(s) + " s, for times up to "
              + Foam::name(lastTime) + " s",
                "a number >= " + Foam::name(lastTime/2e9) + ", <= 1e15"
            );
        }
    }
    else if (control == "timeStep" || control == "writeTime")
    {
        number(dict, interval, ">=1 <=2147483647", 1, true);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::controlTimes::number
(
    const dictionary& dict,
    const word& keyword,
    const std::string& range,
    const scalar fallback,
    const bool whole
)
{
    const entry* e = dict.findEntry(keyword, keyType::LITERAL);
    if (!e)
    {
        return fallback;
    }
    const string allowed
    (
        (whole ? "a whole number " : "a number ") + allowance::listed(range)
    );
    if
    (
        !e->isStream() || e->stream().size() != 1
     || !e->stream()[0].isNumber()
     || !dem::isFinite(e->stream()[0].number())
    )
    {
        dustProperties::error(dict, keyword, "is not a number", allowed);
    }
    const scalar value = e->stream()[0].number();
    if
    (
        !allowance(range).contains(value)
     || (whole && value != std::floor(value))
    )
    {
        dustProperties::error
        (
            dict, keyword, "is " + Foam::name(value), allowed
        );
    }
    return value;
}


void Foam::controlTimes::check(const dictionary& controlDict)
{
    number(controlDict, "maxCo", ">=1e-6 <=1e6", 1);
    number(controlDict, "maxDeltaT", ">=1e-15 <=1e15", 1);
    const scalar last =
        mag(number(controlDict, "startTime", ">=-1e15 <=1e15", 0))
      + mag(number(controlDict, "endTime", ">=-1e15 <=1e15", 0));

    checkControl(controlDict, "write", last);
    if (controlDict.found("secondaryWriteControl"))
    {
        checkControl(controlDict, "secondaryWrite", last);
    }

    const dictionary* functionsPtr = controlDict.findDict("functions");
    if (!functionsPtr)
    {
        return;
    }
    for (const entry& f : *functionsPtr)
    {
        if (f.isDict())
        {
            checkControl(f.dict(), "write", last);
            checkControl(f.dict(), "execute", last);
            checkControl(f.dict(), "output", last);
        }
    }
}


// ************************************************************************* //
