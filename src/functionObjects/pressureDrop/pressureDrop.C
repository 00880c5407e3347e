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

#include "pressureDrop.H"
#include "functionKeywords.H"
#include "dustCloud.H"
#include "dustProperties.H"
#include "dustSnapshot.H"

#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(pressureDrop, 0);
    addToRunTimeSelectionTable(functionObject, pressureDrop, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::functionObjects::pressureDrop::patch
(
    const dictionary& dict,
    const word& keyword
) const
{
    const word patchName(dict.get<word>(keyword));
    const label patchi = mesh_.boundaryMesh().findPatchID(patchName);
    if (patchi < 0)
    {
        dustProperties::error
        (
            dict,
            keyword,
            "there is no patch '" + patchName + "'",
            dustProperties::listed(mesh_.boundaryMesh().names())
        );
    }
    return patchi;
}


Foam::scalar Foam::functionObjects::pressureDrop::mean
(
    const label patchi
) const
{
    const scalarField& area = mesh_.magSf().boundaryField()[patchi];
    const scalarField& p =
        mesh_.lookupObject<volScalarField>("p").boundaryField()[patchi];
    return gSum(area*p)/gSum(area);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::pressureDrop::pressureDrop
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    file_(runTime, name, "pressureDrop", "time_s,dp_Pa,deposited_kg")
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::pressureDrop::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    functionKeywords::check(dict, {"from", "to"});
    cloudName_ = functionKeywords::cloud(dict, mesh_);
    from_ = patch(dict, "from");
    to_ = patch(dict, "to");
    if (from_ == to_)
    {
        dustProperties::error
        (
            dict,
            "to",
            "is the patch from which it falls, too",
            "another patch than that of from"
        );
    }
    return true;
}


bool Foam::functionObjects::pressureDrop::write()
{
    const dustCloud& cloud = mesh_.lookupObject<dustCloud>(cloudName_);
    if (cloud.gasFrozen())
    {
        FatalErrorInFunction
            << name() << ": there is no pressure, as the gas is not solved"
            << nl << "    allowed: gas solved in constant/dustProperties"
            << exit(FatalError);
    }
    const scalar rho =
        gAverage(mesh_.lookupObject<volScalarField>("rho").primitiveField());
    const scalar drop = rho*(mean(from_) - mean(to_));

    scalar deposited = 0;
    for (const auto& p : cloud.snapshot().particles)
    {
        deposited += p.patch >= 0 ? p.mass : 0;
    }
    file_.row(time_.value(), drop, deposited);
    return true;
}


// ************************************************************************* //
