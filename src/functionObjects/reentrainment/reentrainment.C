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

#include "reentrainment.H"
#include "functionKeywords.H"
#include "dustCloud.H"
#include "dustSnapshot.H"

#include "wallPolyPatch.H"
#include "addToRunTimeSelectionTable.H"

#include <algorithm>
#include <limits>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(reentrainment, 0);
    addToRunTimeSelectionTable(functionObject, reentrainment, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<Foam::functionObjects::reentrainment::particle>
Foam::functionObjects::reentrainment::now() const
{
    std::vector<particle> all;
    const dustCloud& cloud = mesh_.lookupObject<dustCloud>(cloudName_);
    for (const auto& p : cloud.snapshot().particles)
    {
        all.push_back({p.id, classes_.of(p.d), p.patch});
    }
    return all;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::reentrainment::reentrainment
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    timeBefore_(runTime.value()),
    file_
    (
        runTime,
        name,
        "reentrainment",
        "time_s,patch,dLow_m,dHigh_m,deposited,left,moved,rate_ps"
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

bool Foam::functionObjects::reentrainment::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    functionKeywords::check(dict, {"diameters"});
    cloudName_ = functionKeywords::cloud(dict, mesh_);
    classes_.read(dict);
    return true;
}


bool Foam::functionObjects::reentrainment::write()
{
    const std::vector<particle> all(now());
    const label classes = classes_.size();

    // By patch and class, those outside of all last
    const List<labelList> none
    (
        mesh_.boundaryMesh().size(),
        labelList(classes + 1, 0)
    );
    List<labelList> lay(none), left(none), moved(none), deposited(none);

    label outside = 0;
    for (const particle& p : all)
    {
        outside += p.sizeClass == classes;
        if (p.patch >= 0)
        {
            ++deposited[p.patch][p.sizeClass];
        }
    }
    auto is = all.begin();
    for (const particle& was : before_)
    {
        if (was.patch < 0)
        {
            continue;
        }
        ++lay[was.patch][was.sizeClass];
        is = std::find_if
        (
            is,
            all.end(),
            [&](const particle& p) { return p.id >= was.id; }
        );
        if (is == all.end() || is->id != was.id || is->patch < 0)
        {
            ++left[was.patch][was.sizeClass];
        }
        else if (is->patch != was.patch)
        {
            ++moved[was.patch][was.sizeClass];
        }
    }
    if (outside)
    {
        Info<< name() << ": " << outside << " particles are in none of the "
            << "classes of diameters" << endl;
    }

    const scalar dt = time_.value() - timeBefore_;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!isA<wallPolyPatch>(pp))
        {
            continue;
        }
        for (label i = 0; i < classes; ++i)
        {
            const scalar dose = dt*lay[pp.index()][i];
            file_.row
            (
                time_.value(),
                pp.name(),
                classes_.low(i),
                classes_.high(i),
                deposited[pp.index()][i],
                left[pp.index()][i],
                moved[pp.index()][i],
                dose > 0
              ? left[pp.index()][i]/dose
              : std::numeric_limits<scalar>::quiet_NaN()
            );
        }
    }
    before_ = all;
    timeBefore_ = time_.value();
    return true;
}


// ************************************************************************* //
