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

#include "depositionVelocity.H"
#include "functionKeywords.H"
#include "dustCloud.H"
#include "dustSnapshot.H"

#include "wallPolyPatch.H"
#include "addToRunTimeSelectionTable.H"

#include <limits>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(depositionVelocity, 0);
    addToRunTimeSelectionTable(functionObject, depositionVelocity, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::functionObjects::depositionVelocity::counts
Foam::functionObjects::depositionVelocity::now() const
{
    const labelList none(classes_.size() + 1, 0);
    counts c
    {
        time_.value(),
        none,
        List<labelList>(mesh_.boundaryMesh().size(), none)
    };
    const dustCloud& cloud = mesh_.lookupObject<dustCloud>(cloudName_);
    for (const auto& p : cloud.snapshot().particles)
    {
        ++(p.patch < 0 ? c.airborne : c.deposited[p.patch])[classes_.of(p.d)];
    }
    return c;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::depositionVelocity::depositionVelocity
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
        "depositionVelocity",
        "time_s,patch,dLow_m,dHigh_m,airborne,deposited,velocity_mps"
    )
{
    read(dict);
    // Solvers without dust build the functions of the case, too
    if (mesh_.foundObject<dustCloud>(cloudName_))
    {
        before_ = now();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::depositionVelocity::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    functionKeywords::check(dict, {"diameters"});
    cloudName_ = functionKeywords::cloud(dict, mesh_);
    classes_.read(dict);
    return true;
}


bool Foam::functionObjects::depositionVelocity::write()
{
    const counts c(now());
    const scalar volume = gSum(mesh_.V().field());

    label outside = c.airborne.last();
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label patchi = pp.index();
        outside += c.deposited[patchi].last();
        if (!isA<wallPolyPatch>(pp))
        {
            continue;
        }
        const scalar area = gSum(mesh_.magSf().boundaryField()[patchi]);
        for (label i = 0; i < classes_.size(); ++i)
        {
            const scalar come =
                c.deposited[patchi][i] - before_.deposited[patchi][i];
            const scalar dose =
                0.5*(before_.airborne[i] + c.airborne[i])/volume
               *area*(c.time - before_.time);

            file_.row
            (
                c.time,
                pp.name(),
                classes_.low(i),
                classes_.high(i),
                c.airborne[i],
                c.deposited[patchi][i],
                dose > 0
              ? come/dose
              : std::numeric_limits<scalar>::quiet_NaN()
            );
        }
    }
    if (outside)
    {
        Info<< name() << ": " << outside << " particles are in none of the "
            << "classes of diameters" << endl;
    }
    before_ = c;
    return true;
}


// ************************************************************************* //
