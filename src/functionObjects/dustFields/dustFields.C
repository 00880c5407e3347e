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

#include "dustFields.H"
#include "functionKeywords.H"
#include "dustCloud.H"
#include "dustSnapshot.H"
#include "nearestWallFaces.H"

#include "addToRunTimeSelectionTable.H"

#include <unordered_set>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(dustFields, 0);
    addToRunTimeSelectionTable(functionObject, dustFields, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::volScalarField Foam::functionObjects::dustFields::field
(
    const word& name,
    const dimensionSet& dimensions,
    const scalar value
) const
{
    return volScalarField
    (
        IOobject
        (
            name,
            time_.timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar(name, dimensions, value)
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::dustFields::dustFields
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::dustFields::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    functionKeywords::check(dict);
    cloudName_ = functionKeywords::cloud(dict, mesh_);
    return true;
}


bool Foam::functionObjects::dustFields::write()
{
    const dustCloud& cloud = mesh_.lookupObject<dustCloud>(cloudName_);

    // What is deposited the master knows; where the parcels are, each rank
    DynamicList<scalar> ids;
    DynamicList<label> patches;
    DynamicList<point> centres;
    DynamicList<scalar> radii;
    for (const auto& p : cloud.snapshot().particles)
    {
        if (p.patch >= 0)
        {
            ids.append(scalar(p.id));
            patches.append(p.patch);
            centres.append(p.x);
            radii.append(0.5*p.d);
        }
    }
    Pstream::scatter(ids);
    Pstream::scatter(patches);
    Pstream::scatter(centres);
    Pstream::scatter(radii);

    std::unordered_set<int64_t> deposited;
    for (const scalar id : ids)
    {
        deposited.insert(int64_t(id));
    }

    volScalarField concentration(field("dustConcentration", dimDensity, 0));
    volScalarField porosity(field("depositPorosity", dimless, 1));
    volScalarField thickness(field("depositThickness", dimLength, 0));

    for (const dustParcel& p : cloud)
    {
        const scalar volume = mesh_.V()[p.cell()];
        if (deposited.count(p.id()))
        {
            porosity[p.cell()] -= p.volume()/volume;
        }
        else
        {
            concentration[p.cell()] += p.mass()/volume;
        }
    }

    const nearestWallFaces nearest(mesh_, patches, centres);
    forAll(radii, i)
    {
        if (nearest.face[i] >= 0)
        {
            scalar& highest =
                thickness.boundaryFieldRef()[patches[i]][nearest.face[i]];
            highest = max(highest, nearest.distance[i] + radii[i]);
        }
    }

    concentration.write();
    porosity.write();
    thickness.write();
    return true;
}


// ************************************************************************* //
