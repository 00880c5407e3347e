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

#include "modelTable.H"

// First: includes DEM.hpp
#include "dustProperties.H"

#include "dustCloud.H"

#include "CloudFunctionObject.H"
#include "injectorFunctions.H"
#include "Tuple2.H"
#include "uniformDimensionedFields.H"
#include "volFields.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A field that is not known yet is read from the start time, and written with
//  the others, for a restart
template<class Type>
static void provideField
(
    const word& name,
    const dictionary& dict,
    const word& keyword,
    const fvMesh& mesh
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    if (mesh.foundObject<fieldType>(name))
    {
        return;
    }

    IOobject io
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::AUTO_WRITE
    );
    if (!io.typeHeaderOk<fieldType>(true))
    {
        dustProperties::error
        (
            dict,
            dict.found(keyword) ? keyword : dict.dictName(),
            "there is no field '" + name + "' in time "
          + mesh.time().timeName(),
            "a " + fieldType::typeName + " " + name + " there"
        );
    }
    (new fieldType(io, mesh))->store();
}


//- Numbers that OpenFOAM's injectors cut to whole ones: 0.5 to none
static void checkWhole(const word& injector, const dictionary& dict)
{
    const word keyword =
        injector == "patchInjection" || injector == "coneNozzleInjection"
      ? "parcelsPerSecond"
      : injector == "coneInjection" ? "parcelsPerInjector" : "";
    const scalar n =
        keyword.empty() ? 0 : dict.lookupOrDefault<scalar>(keyword, 0);

    if (n > labelMax || n != std::floor(n))
    {
        dustProperties::error
        (
            dict,
            keyword,
            "is " + Foam::name(n),
            "a whole number up to " + Foam::name(labelMax)
          + ", as OpenFOAM's " + injector + " keeps it, or dustPatchInjection"
        );
    }
}


//- The vectors of a frame that moves, from constant/. True if it is there.
static bool provideVector(const word& name, const fvMesh& mesh)
{
    IOobject io
    (
        name,
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
    if (mesh.foundObject<uniformDimensionedVectorField>(name))
    {
        return true;
    }
    if (!io.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        return false;
    }
    (new uniformDimensionedVectorField(io))->store();
    return true;
}


//- The place of a nozzle may be a dictionary only where it moves
static void checkPlace(const word& injector, const dictionary& dict)
{
    const entry* placePtr = dict.findEntry("position", keyType::LITERAL);
    if
    (
        injector == "coneNozzleInjection" && placePtr && placePtr->isDict()
     && dict.lookupOrDefault<word>("injectionMethod", "") != "movingPoint"
    )
    {
        dustProperties::error
        (
            dict,
            "position",
            "is a dictionary",
            "a place (x y z), or a function of time with injectionMethod"
            " movingPoint"
        );
    }
}


//- Types of cloud functions: OpenFOAM's, and those of the user's libraries
static void checkCloudFunctions(const dictionary& functions)
{
    const wordList known
    (
        CloudFunctionObject<dustCloud::kinematicCloudType>
      ::dictionaryConstructorTablePtr_->sortedToc()
    );
    for (const entry& e : functions)
    {
        if (!e.isDict())
        {
            continue;
        }
        const word type(e.dict().get<word>("type"));
        if (!known.found(type))
        {
            dustProperties::error
            (
                e.dict(),
                "type",
                "there is no model '" + type + "'",
                dustProperties::listed(known)
            );
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::modelTable::provide
(
    const need& n,
    const dictionary& dict,
    const fvMesh& mesh
)
{
    if (n.what == need::frame)
    {
        const wordList keywords
        ({
            "linearAcceleration", "angularVelocity", "angularAcceleration",
            "centreOfRotation"
        });
        label known = 0;
        for (const word& keyword : keywords)
        {
            if
            (
                provideVector
                (
                    dict.lookupOrDefault<word>(keyword, keyword),
                    mesh
                )
             && keyword != "centreOfRotation"
            )
            {
                ++known;
            }
        }
        if (!known)
        {
            dustProperties::error
            (
                dict,
                dict.dictName(),
                "constant/ says nothing of the motion of the frame",
                "linearAcceleration, angularVelocity or angularAcceleration "
                "there (uniformDimensionedVectorField)"
            );
        }
        return;
    }

    // OpenFOAM says what is missing
    if (n.fallback.empty() && !dict.found(n.keyword))
    {
        return;
    }
    const word name(dict.lookupOrDefault<word>(n.keyword, n.fallback));

    if (n.what == need::scalarField)
    {
        provideField<scalar>(name, dict, n.keyword, mesh);
    }
    else if (n.what == need::vectorField)
    {
        provideField<vector>(name, dict, n.keyword, mesh);
    }
    else
    {
        const bool zone = n.what == need::cellZone;
        wordList names;
        if (zone)
        {
            names = mesh.cellZones().names();
        }
        else
        {
            for (const polyPatch& pp : mesh.boundaryMesh())
            {
                if (!pp.coupled())
                {
                    names.append(pp.name());
                }
            }
        }
        if (!names.found(name))
        {
            dustProperties::error
            (
                dict,
                n.keyword,
                string("there is no ") + (zone ? "cell zone" : "patch") + " '"
              + name + "'",
                dustProperties::listed(names)
            );
        }
    }
}


void Foam::modelTable::checkInjector(const row& r, const dictionary& dict)
{
    if (Pstream::parRun() && !r.oneRank.empty())
    {
        dustProperties::error
        (
            dict,
            "type",
            "OpenFOAM's " + r.name + " on several ranks: " + r.oneRank,
            r.name + " on one rank, or " + r.instead
        );
    }

    const entry* profilePtr =
        dict.findEntry("flowRateProfile", keyType::LITERAL);
    if
    (
        (r.name == "patchInjection" || r.name == "coneNozzleInjection")
     && profilePtr
     && (
            profilePtr->isDict()
         || (
                profilePtr->stream()[0].isWord()
             && profilePtr->stream()[0].wordToken() != "constant"
            )
        )
    )
    {
        dustProperties::error
        (
            dict,
            "flowRateProfile",
            "OpenFOAM's " + r.name + " gives it to the mass of its parcels, "
            "not to their number, and each is one particle",
            "constant 1, or dustPatchInjection"
        );
    }

    checkWhole(r.name, dict);

    checkPlace(r.name, dict);

    injectorFunctions::check(r.name, dict);

    // It counts what it injected per rank, but for all of its positions
    if
    (
        Pstream::parRun()
     && r.name == "coneInjection"
     && List<Tuple2<vector, vector>>(dict.lookup("positionAxis")).size() > 1
    )
    {
        dustProperties::error
        (
            dict,
            "positionAxis",
            "OpenFOAM's coneInjection gives too many where several positions "
            "are on different ranks",
            "one position; further injectors for the others"
        );
    }

    // Then place and velocity are those of different rows
    if
    (
        r.name == "kinematicLookupTableInjection"
     && dict.lookupOrDefault<bool>("randomise", false)
    )
    {
        dustProperties::error
        (
            dict,
            "randomise",
            "OpenFOAM draws the place, but not velocity and diameter, from "
            "another row",
            "no"
        );
    }
}


const Foam::modelTable::row& Foam::modelTable::checked
(
    const kindType kind,
    const word& name,
    const dictionary& dict,
    const word& keyword
)
{
    const row* r = find(kind, name);

    if (r && r->works && registered(kind).found(name))
    {
        return *r;
    }

    wordList allowed;
    for (const word& other : registered(kind))
    {
        const row* o = find(kind, other);
        if (o && o->works)
        {
            allowed.append(other);
        }
    }

    std::string reason = "there is no model '" + name + "'";
    std::string instead = dustProperties::listed(allowed);
    if (r && !r->works)
    {
        reason = name + " is refused: " + r->remark;
        instead = r->instead;
    }
    else if (registered(kind).found(name))
    {
        reason = name + " was never tried with dustFoam";
    }
    dustProperties::error(dict, keyword, reason, instead);

    return *r;      // never
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::wordList Foam::modelTable::drags(const dictionary& forces)
{
    wordList names;
    for (const entry& e : forces)
    {
        const row* r = find(force, e.keyword());
        if (r && r->kind == drag)
        {
            names.append(e.keyword());
        }
    }
    return names;
}


void Foam::modelTable::check
(
    const dictionary& subModels,
    const dustProperties& dust,
    const fvMesh& mesh
)
{
    const dictionary& forces = subModels.subDict("particleForces");
    for (const entry& e : forces)
    {
        const row& r = checked(force, e.keyword(), forces, e.keyword());
        const dictionary& dict = e.isDict() ? e.dict() : forces;

        for (const need& n : r.needs)
        {
            provide(n, dict, mesh);
        }
    }

    const wordList laws(drags(forces));
    if (laws.size() > 1)
    {
        dustProperties::error
        (
            forces,
            laws[1],
            "two drag laws would add up: " + dustProperties::listed(laws),
            "one of them"
        );
    }

    checked
    (
        dispersion,
        subModels.get<word>("dispersionModel"),
        subModels,
        "dispersionModel"
    );

    checkCloudFunctions(subModels.topDict().subOrEmptyDict("cloudFunctions"));

    const dictionary& injectors = subModels.subDict("injectionModels");
    for (const entry& e : injectors)
    {
        if (!e.isDict())
        {
            dustProperties::error
            (
                injectors,
                e.keyword(),
                "is not a dictionary",
                "NAME { type ...; }"
            );
        }
        const dictionary& dict = e.dict();
        const row& r =
            checked(injection, dict.get<word>("type"), dict, "type");

        for (const need& n : r.needs)
        {
            provide(n, dict, mesh);
        }
        checkInjector(r, dict);
        if (injects(e))
        {
            dust.material(dict);
        }
    }
}


// ************************************************************************* //
