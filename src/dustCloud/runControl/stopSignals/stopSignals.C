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

#include "dustCloudData.H"
#include "stopSignals.H"

#include "debug.H"

#include <csignal>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static volatile std::sig_atomic_t cameSignal = 0;

static void takeDown(int signal)
{
    cameSignal = signal;
}

} // End namespace Foam


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::stopSignals::watch()
{
    const int writeNow = debug::optimisationSwitch("writeNowSignal", -1);
    const int stopAtWriteNow =
        debug::optimisationSwitch("stopAtWriteNowSignal", -1);

    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGUSR1})
    {
        struct sigaction now;
        if
        (
            signal == writeNow || signal == stopAtWriteNow
         || sigaction(signal, nullptr, &now) != 0
         || now.sa_handler == SIG_IGN
        )
        {
            continue;
        }

        struct sigaction action = {};
        action.sa_handler = takeDown;
        action.sa_flags = SA_RESETHAND | SA_RESTART;
        sigemptyset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
}


int Foam::stopSignals::came()
{
    return cameSignal;
}


const char* Foam::stopSignals::name(const int signal)
{
    switch (signal)
    {
        case SIGTERM: return "SIGTERM";
        case SIGINT: return "SIGINT";
        case SIGHUP: return "SIGHUP";
        case SIGUSR1: return "SIGUSR1";
        default: return "a signal";
    }
}


// ************************************************************************* //
