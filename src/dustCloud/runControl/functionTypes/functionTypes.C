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


// First: includes DEM.hpp
#include "dustProperties.H"

#include "functionTypes.H"
#include "controlKeywords.H"

#include "functionObject.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const wordList ours
({
    "adhesionMargin", "aggregates", "captureEfficiency", "deposition",
    "depositionVelocity", "dustFields", "energyLedger", "pressureDrop",
    "reentrainment"
});

static const word library("dustFunctionObjects");


//- Known without the libraries that are still to be loaded
static bool loaded(const word& type)
{
    const auto* table = functionObject::dictionaryConstructorTablePtr_;
    return table && table->found(type);
}


//- Does the dictionary name the library, in one of its two keywords?
static bool namesLibrary(const dictionary& dict)
{
    for (const word keyword : {"libs", "functionObjectLibs"})
    {
        const entry* e = dict.findEntry(keyword, keyType::LITERAL);
        if (!e || !e->isStream())
        {
            continue;
        }
        for (const token& t : e->stream())
        {
            const std::string name =
                t.isString() ? std::string(t.stringToken())
              : t.isWord() ? std::string(t.wordToken()) : std::string();
            const fileName file(name, false);
            if (file.nameLessExt() == "lib" + library || file == library)
            {
                return true;
            }
        }
    }
    return false;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::functionTypes::check(const dictionary& controlDict)
{
    const dictionary* functionsPtr = controlDict.findDict("functions");
    if (!functionsPtr)
    {
        return;
    }
    for (const entry& f : *functionsPtr)
    {
        const entry* e =
            f.isDict()
          ? f.dict().findEntry("type", keyType::LITERAL)
          : nullptr;
        if (!e || !e->isStream() || e->stream().size() != 1)
        {
            continue;   // OpenFOAM says what it misses
        }
        const token& t = e->stream()[0];
        const word type
        (
            t.isWord() ? t.wordToken()
          : t.isString() ? word(t.stringToken(), false)
          : word()
        );
        if (loaded(type))
        {
            continue;
        }
        if (ours.found(type))
        {
            if (!namesLibrary(f.dict()) && !namesLibrary(controlDict))
            {
                dustProperties::error
                (
                    f.dict(),
                    f.dict().found("libs") ? "libs" : "type",
                    "type " + type + " is not in the libraries that are named",
                    "libs (\"lib" + library + ".so\")"
                );
            }
            continue;
        }
        for (const word& meant : ours)
        {
            if (controlKeywords::mistaken(type, meant))
            {
                dustProperties::error
                (
                    f.dict(),
                    "type",
                    "there is no function object '" + type + "'",
                    meant
                );
            }
        }
    }
}


// ************************************************************************* //
