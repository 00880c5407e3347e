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

#include "contactSteps.H"

#include "IOstreams.H"

#include <chrono>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

typedef std::chrono::steady_clock wallClock;

static constexpr scalar interval = 10;      // between two messages [s]
static constexpr scalar perLook = 1e5;      // at the clock: it takes time, too
static constexpr scalar hour = 3600;

static const wallClock::time_point start = wallClock::now();
static scalar done = 0;         // contact steps
static scalar end = 0;          // at most until then; 0: not known
static scalar looked = 0;       // at the clock, after so many steps
static scalar said = 0;         // at that moment [s]


static scalar seconds()
{
    return
        std::chrono::duration<scalar>(wallClock::now() - start).count();
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::contactSteps::taken(const scalar n)
{
    done += n;
    if (done < looked + perLook)
    {
        return;
    }
    looked = done;
    const scalar now = seconds();
    if (now > said + interval)
    {
        said = now;
        Info<< "    ... " << done << " contact steps";
        if (end > done)
        {
            Info<< " of at most " << end;
        }
        Info<< " in " << now << " s" << endl;
    }
}


void Foam::contactSteps::ahead(const scalar most)
{
    end = done + most;
    Info<< "Contact steps ahead: at most " << most;
    if (done > 0)
    {
        const scalar time = most*seconds()/done;
        Info<< ", " << time << " s";
        if (time > hour)
        {
            Info<< nl << "    Warning: this may take " << time/hour
                << " h. Fewer stepsPerContact, velocities, angles or chi, or"
                << " a duration shorten it";
        }
    }
    Info<< endl;
}


// ************************************************************************* //
