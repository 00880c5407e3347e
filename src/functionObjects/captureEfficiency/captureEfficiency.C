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

#include "captureEfficiency.H"
#include "functionKeywords.H"
#include "dustCloud.H"
#include "dustSnapshot.H"

#include "wallPolyPatch.H"
#include "addToRunTimeSelectionTable.H"
#include "IOdictionary.H"
#include "OStringStream.H"

#include <limits>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(captureEfficiency, 0);
    addToRunTimeSelectionTable(functionObject, captureEfficiency, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::functionObjects::captureEfficiency::stateFile
(
    const IOobject::readOption r
) const
{
    return IOobject
    (
        name(),
        time_.timeName(),
        "uniform",
        time_,
        r,
        IOobject::NO_WRITE,
        false
    );
}


void Foam::functionObjects::captureEfficiency::readState()
{
    passed_ = labelList(classes_.size() + 1, 0);
    const dustCloud* cloud = mesh_.findObject<dustCloud>(cloudName_);
    const label before = cloud ? cloud->escaped().count : 0;

    IOobject io(stateFile(IOobject::MUST_READ));
    if (io.typeHeaderOk<IOdictionary>(true))
    {
        const IOdictionary state(io);
        if (state.get<scalarList>("diameters") != classes_.limits())
        {
            OStringStream then;
            then<< state.get<scalarList>("diameters");
            dustProperties::error
            (
                state,
                "diameters",
                "the classes of the function object " + name()
              + " were others, and what has passed cannot be told apart anew",
                then.str() + ", or without this file to count from now on"
            );
        }
        passed_ = state.get<labelList>("passed");
        if (cloud && state.lookupOrDefault("escaped", before) != before)
        {
            dustProperties::error
            (
                state,
                "escaped",
                Foam::name(state.get<label>("escaped")) + " had left, but "
              + Foam::name(before) + " have at time " + time_.timeName()
              + ": the file is of another time",
                "that of this time, or without this file to count from now on"
            );
        }
        return;
    }

    if (before)
    {
        WarningInFunction
            << name() << ": " << before << " particles have left before, of "
            << "which " << io.objectPath() << " does not tell: counted from "
            << "now on only" << endl;
    }
}


void Foam::functionObjects::captureEfficiency::writeState
(
    const dustCloud& cloud
) const
{
    IOdictionary state(stateFile(IOobject::NO_READ));
    state.add("diameters", classes_.limits());
    state.add("passed", passed_);
    state.add("escaped", cloud.escaped().count);
    state.regIOobject::write();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::captureEfficiency::captureEfficiency
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
        "captureEfficiency",
        "time_s,patch,dLow_m,dHigh_m,passed,captured,efficiency,low95,high95"
    ),
    penetration_
    (
        runTime,
        name + "Penetration",
        "penetration",
        "time_s,dLow_m,dHigh_m,passed,captured,penetration,low95,high95"
    )
{
    read(dict);
    readState();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::captureEfficiency::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    functionKeywords::check(dict, {"diameters"});
    cloudName_ = functionKeywords::cloud(dict, mesh_);

    classes_.read(dict);
    return true;
}


bool Foam::functionObjects::captureEfficiency::execute()
{
    const dustCloud& cloud = mesh_.lookupObject<dustCloud>(cloudName_);

    if (postProcess)
    {
        readState();
    }
    for (const scalar d : cloud.escapedInStep())
    {
        ++passed_[classes_.of(d)];
    }
    return true;
}


bool Foam::functionObjects::captureEfficiency::write()
{
    const dustCloud& cloud = mesh_.lookupObject<dustCloud>(cloudName_);
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label classes = classes_.size();

    List<labelList> captured(patches.size(), labelList(classes + 1, 0));
    label outside = passed_[classes];
    for (const auto& p : cloud.snapshot().particles)
    {
        const label i = classes_.of(p.d);
        outside += i == classes;
        if (p.patch >= 0)
        {
            ++captured[p.patch][i];
        }
    }
    if (outside)
    {
        Info<< name() << ": " << outside << " particles are in none of the "
            << "classes of diameters" << endl;
    }

    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    labelList capturedByAll(classes, 0);
    for (const polyPatch& pp : patches)
    {
        if (!isA<wallPolyPatch>(pp))
        {
            continue;
        }
        for (label i = 0; i < classes; ++i)
        {
            const label k = captured[pp.index()][i];
            const label n = k + passed_[i];
            const wilsonInterval interval(k, n, 1.959964);

            capturedByAll[i] += k;
            file_.row
            (
                time_.value(),
                pp.name(),
                classes_.low(i),
                classes_.high(i),
                passed_[i],
                k,
                n ? scalar(k)/n : nan,
                interval.low,
                interval.high
            );
        }
    }

    for (label i = 0; i < classes; ++i)
    {
        const label n = capturedByAll[i] + passed_[i];
        const wilsonInterval interval(passed_[i], n, 1.959964);

        penetration_.row
        (
            time_.value(),
            classes_.low(i),
            classes_.high(i),
            passed_[i],
            capturedByAll[i],
            n ? scalar(passed_[i])/n : nan,
            interval.low,
            interval.high
        );
    }

    if (time_.writeTime() && !postProcess)
    {
        writeState(cloud);
    }
    return true;
}


// ************************************************************************* //
