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

#include "deposition.H"
#include "functionKeywords.H"
#include "dustCloud.H"
#include "dustSnapshot.H"
#include "wallPolyPatch.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(deposition, 0);
    addToRunTimeSelectionTable(functionObject, deposition, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::deposition::deposition
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    file_(runTime, name, "deposition", "time_s,patch,count,mass_kg,coverage"),
    balance_(runTime, name, "balance", "injected,airborne,deposited,escaped")
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::deposition::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    functionKeywords::check(dict);
    cloudName_ = functionKeywords::cloud(dict, mesh_);
    return true;
}


bool Foam::functionObjects::deposition::write()
{
    const dustCloud& cloud = mesh_.lookupObject<dustCloud>(cloudName_);
    const dustSnapshot& state = cloud.snapshot();
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    List<dustCloud::tally> deposits(patches.size());
    scalarList projected(patches.size(), Zero);
    label airborne = 0;
    label deposited = 0;

    for (const auto& p : state.particles)
    {
        if (p.patch < 0)
        {
            ++airborne;
            continue;
        }
        ++deposited;
        ++deposits[p.patch].count;
        deposits[p.patch].mass += p.mass;
        projected[p.patch] += constant::mathematical::pi/4*sqr(p.d);
    }

    for (const polyPatch& pp : patches)
    {
        if (isA<wallPolyPatch>(pp))
        {
            const label i = pp.index();
            const scalar area = gSum(mesh_.magSf().boundaryField()[i]);

            file_.row
            (
                time_.value(),
                pp.name(),
                deposits[i].count,
                deposits[i].mass,
                area > 0 ? projected[i]/area : scalar(0)
            );
        }
    }

    balance_.restart();
    balance_.row
    (
        cloud.injected().count,
        airborne,
        deposited,
        cloud.escaped().count
    );

    return true;
}


// ************************************************************************* //
