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

// Before OpenFOAM's headers, whose macros would meddle with Eigen
#include "DEM.hpp"

#include "energyLedger.H"
#include "functionKeywords.H"
#include "dustCloud.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(energyLedger, 0);
    addToRunTimeSelectionTable(functionObject, energyLedger, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::energyLedger::energyLedger
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
        "energyLedger",
        "time_s,kinetic_J,normal_J,springs_J,released_J,dashpots_J,yield_J,"
        "plastic_J,rest_J,gas_J,springGain_J,stiffening_J,residual_J"
    )
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::energyLedger::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    functionKeywords::check(dict);
    cloudName_ = functionKeywords::cloud(dict, mesh_);
    return true;
}


bool Foam::functionObjects::energyLedger::write()
{
    const dustCloud& cloud = mesh_.lookupObject<dustCloud>(cloudName_);

    if (!cloud.keepsEnergyLedger())
    {
        FatalErrorInFunction
            << "Function object " << name() << " needs timeIntegration"
            << " { energyLedger on; } in the dictionary of cloud "
            << cloudName_ << exit(FatalError);
    }

    const dem::EnergyLedger e = cloud.energyLedger();

    file_.row
    (
        time_.value(),
        double(e.kinetic),
        double(e.normal),
        double(e.springs),
        double(e.released),
        double(e.dashpots),
        double(e.yield),
        double(e.plastic),
        double(e.rest),
        double(e.gas),
        double(e.springGain),
        double(e.stiffening),
        e.residual()
    );

    return true;
}


// ************************************************************************* //
