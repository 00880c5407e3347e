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

#include "dustProperties.H"
#include "Switch.H"
#include "stringOps.H"
#include "error.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- FatalIOError that names the file and the given lines
static void fatal
(
    const dictionary& dict,
    const label startLine,
    const label endLine,
    const string& message
)
{
    FatalIOError
    (
        FUNCTION_NAME,
        __FILE__,
        __LINE__,
        dict.name(),
        startLine,
        endLine
    )   << message.c_str() << exit(FatalIOError);
}


//- Read one of a few words
static word choice
(
    const dictionary& dict,
    const word& keyword,
    const word& defaultValue,
    const wordList& allowed
)
{
    const word value(dict.lookupOrDefault<word>(keyword, defaultValue));

    if (!allowed.found(value))
    {
        dustProperties::error
        (
            dict,
            keyword,
            "unknown value '" + value + "'",
            dustProperties::listed(allowed)
        );
    }
    return value;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustProperties::readMaterials()
{
    const dictionary& materials = dict_.subDict("materials");
    wordList withDensity;

    for (const entry& e : materials)
    {
        if (!e.isDict())
        {
            error
            (
                materials,
                e.keyword(),
                "is not a material",
                "name { density ...; youngsModulus ...; poissonRatio ...; "
                "surfaceEnergy ...; }"
            );
        }

        const dictionary& dict = e.dict();

        checkKeywords
        (
            dict,
            {"density", "youngsModulus", "poissonRatio", "surfaceEnergy"}
        );

        dem::Material m;
        m.name = e.keyword();
        m.density = dict.lookupOrDefault<scalar>("density", 0);
        m.youngsModulus = dict.get<scalar>("youngsModulus");
        m.poissonRatio = dict.get<scalar>("poissonRatio");
        m.surfaceEnergy = dict.get<scalar>("surfaceEnergy");
        materials_.push_back(m);

        if (dict.found("density"))
        {
            withDensity.append(e.keyword());

            if (m.density <= 0)
            {
                error(dict, "density", "must be positive", "> 0 kg/m3");
            }
        }
    }

    if (dict_.readIfPresent("dustMaterial", dustMaterial_))
    {
        if (!withDensity.found(dustMaterial_))
        {
            error
            (
                dict_,
                "dustMaterial",
                "no material with a density has the name '"
              + dustMaterial_ + "'",
                listed(withDensity)
            );
        }
    }
    else if (withDensity.size() == 1)
    {
        dustMaterial_ = withDensity[0];
    }
    else
    {
        error
        (
            dict_,
            "materials",
            withDensity.empty()
          ? "the particles' material needs a density, but none is given"
          : "several materials have a density: say which one is the particles'",
            withDensity.empty()
          ? "density in one of them"
          : "dustMaterial followed by one of " + listed(withDensity)
        );
    }
}


dem::PartSettings Foam::dustProperties::readPart
(
    const dictionary& dict,
    const word& kind
)
{
    dem::PartSettings part;

    const entry* ePtr = dict.findEntry(kind, keyType::LITERAL);
    wordList models;

    for (const dem::PartEntry& known : dem::contactModelTable())
    {
        if (known.kind == kind)
        {
            models.append(word(known.model));
        }
    }
    if (kind != "normal" && !models.found("none"))
    {
        models.append("none");
    }

    if (!ePtr)
    {
        error
        (
            dict,
            kind,
            "is missing",
            "model " + listed(models) + ", e.g. " + kind + " { model "
          + models[0] + "; ... }"
        );
    }

    // `rolling none;` is short for `rolling { model none; }`
    if (!ePtr->isDict())
    {
        part.model = word(ePtr->stream());

        if (part.model != "none")
        {
            error
            (
                dict,
                kind,
                "'" + part.model + "' is not a sub-dictionary",
                kind + " { model ...; }"
              + (kind == "normal" ? "" : " or " + kind + " none;")
            );
        }
    }
    else
    {
        part.model = ePtr->dict().get<word>("model");
    }

    if (!models.found(part.model))
    {
        error
        (
            ePtr->isDict() ? ePtr->dict() : dict,
            ePtr->isDict() ? "model" : kind,
            "unknown " + kind + " model '" + part.model + "'",
            listed(models)
        );
    }

    if (ePtr->isDict())
    {
        const dictionary& partDict = ePtr->dict();
        wordList keywords({"model"});

        for (const dem::PartEntry& known : dem::contactModelTable())
        {
            if (known.kind == kind && known.model == part.model)
            {
                for (const std::string& keyword : known.keywords)
                {
                    keywords.append(word(keyword));
                }
            }
        }

        checkKeywords(partDict, keywords);

        for (const entry& e : partDict)
        {
            if (e.keyword() == "model")
            {
                continue;
            }
            if (e.isStream() && e.stream().size() == 1 && e.stream()[0].isWord())
            {
                part.words[e.keyword()] = e.stream()[0].wordToken();
            }
            else
            {
                part.values[e.keyword()] = partDict.get<scalar>(e.keyword());
            }
        }
    }

    return part;
}


dem::ContactSettings Foam::dustProperties::readContactSettings
(
    const dictionary& dict
)
{
    checkKeywords
    (
        dict,
        {
            "normal", "tangential", "rolling", "twisting",
            "effectiveYoungsModulus", "surfaceEnergy"
        }
    );

    dem::ContactSettings settings;
    settings.normal = readPart(dict, "normal");
    settings.tangential = readPart(dict, "tangential");
    settings.rolling = readPart(dict, "rolling");
    settings.twisting = readPart(dict, "twisting");

    scalar value;
    if (dict.readIfPresent("effectiveYoungsModulus", value))
    {
        settings.effectiveYoungsModulus = value;
    }
    if (dict.readIfPresent("surfaceEnergy", value))
    {
        settings.surfaceEnergy = value;
    }
    return settings;
}


void Foam::dustProperties::readContact()
{
    const dictionary& contact = dict_.subDict("contact");
    const dictionary& defaults = contact.subDict("default");

    defaults_ = readContactSettings(defaults);

    for (const entry& e : contact)
    {
        const string name(e.keyword());

        if (name == "default")
        {
            continue;
        }

        // Which pair?
        const auto dot = name.find('.');
        const auto known = [this](const std::string& material)
        {
            return std::any_of
            (
                materials_.begin(),
                materials_.end(),
                [&](const dem::Material& m) { return m.name == material; }
            );
        };

        if
        (
            dot == std::string::npos
         || !known(name.substr(0, dot))
         || !known(name.substr(dot + 1))
         || !e.isDict()
        )
        {
            string names;
            for (const dem::Material& m : materials_)
            {
                names += (names.empty() ? "" : ", ") + m.name;
            }
            fatal
            (
                contact,
                e.startLineNumber(),
                e.endLineNumber(),
                "keyword '" + name + "' in " + contact.dictName()
              + ": no such pair of materials\n    allowed: default, or "
                "\"a.b\" { ... } of the materials " + names
            );
        }

        // Merged over the default: a part that names its model starts anew
        dictionary merged(e.dict());
        for (const word kind : {"normal", "tangential", "rolling", "twisting"})
        {
            const dictionary* part = e.dict().findDict(kind, keyType::LITERAL);
            const dictionary* base = defaults.findDict(kind, keyType::LITERAL);

            if (part && base && !part->found("model"))
            {
                dictionary both(*base);
                both.merge(*part);
                both.name() = part->name();
                merged.set(kind, both);
            }
            else if (!e.dict().found(kind, keyType::LITERAL))
            {
                merged.set(defaults.lookupEntry(kind, keyType::LITERAL));
            }
        }
        for (const word kind : {"effectiveYoungsModulus", "surfaceEnergy"})
        {
            if (defaults.found(kind) && !merged.found(kind))
            {
                merged.set(defaults.lookupEntry(kind, keyType::LITERAL));
            }
        }

        overrides_[name] = readContactSettings(merged);
    }
}


void Foam::dustProperties::readReducedStiffness()
{
    const dictionary& dict = dict_.subOrEmptyDict("reducedStiffness");

    checkKeywords(dict, {"ratio", "surfaceEnergy", "resistance", "limits"});

    if (dict.found("ratio"))
    {
        const token ratio(dict.lookup("ratio"));

        if (ratio.isWord() && ratio.wordToken() == "auto")
        {
            automaticRatio_ = true;
        }
        else if (!ratio.isNumber())
        {
            error(dict, "ratio", "is not a number", "0 < ratio <= 1, or auto");
        }
        else
        {
            softening_.ratio = ratio.number();

            if (!(softening_.ratio > 0 && softening_.ratio <= 1))
            {
                error
                (
                    dict,
                    "ratio",
                    "chi = E_mod/E is " + Foam::name(softening_.ratio),
                    "0 < ratio <= 1, or auto"
                );
            }
        }
    }

    softening_.scaleSurfaceEnergy =
        choice(dict, "surfaceEnergy", "scaled", {"scaled", "unchanged"})
     == "scaled";

    softening_.scaleResistance =
        choice(dict, "resistance", "original", {"original", "scaled"})
     == "scaled";

    const dictionary& limits = dict.subOrEmptyDict("limits");

    checkKeywords
    (
        limits,
        {"pullOffOverForce", "overlap", "ratio", "onViolation"}
    );

    const auto positive = [&limits](const word& keyword, scalar& value)
    {
        if (limits.readIfPresent(keyword, value) && value <= 0)
        {
            error(limits, keyword, "is " + Foam::name(value), "> 0");
        }
    };
    positive("pullOffOverForce", limits_.pullOffOverForce);
    positive("overlap", limits_.overlap);
    positive("ratio", limits_.ratio);

    limits_.stop =
        choice(limits, "onViolation", "warn", {"warn", "stop"}) == "stop";
}


void Foam::dustProperties::readTimeIntegration()
{
    const dictionary& dict = dict_.subOrEmptyDict("timeIntegration");

    checkKeywords
    (
        dict,
        {"stepsPerContact", "restTolerance", "islands", "energyLedger"}
    );

    dict.readIfPresent("stepsPerContact", time_.stepsPerContact);
    dict.readIfPresent("restTolerance", time_.restTolerance);
    time_.islands = dict.lookupOrDefault<Switch>("islands", true);
    time_.energyLedger = dict.lookupOrDefault<Switch>("energyLedger", false);

    const scalar fewest = dem::TimeSettings::fewestStepsPerContact;
    if (!(time_.stepsPerContact >= fewest))
    {
        error
        (
            dict,
            "stepsPerContact",
            "is " + Foam::name(time_.stepsPerContact),
            ">= " + Foam::name(fewest) + "; 34 is usual, 136 is fine"
        );
    }
    if (time_.restTolerance < 0)
    {
        error
        (
            dict,
            "restTolerance",
            "is " + Foam::name(time_.restTolerance),
            ">= 0; 0 = nothing ever rests"
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dustProperties::dustProperties(const dictionary& dict)
:
    dict_(dict),
    automaticRatio_(false)
{
    readMaterials();
    readContact();
    readReducedStiffness();
    readTimeIntegration();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

dem::MaterialTable Foam::dustProperties::table() const
{
    try
    {
        return dem::MaterialTable
        (
            materials_,
            defaults_,
            overrides_,
            softening_
        );
    }
    catch (const dem::inputError& e)
    {
        error(dict_, e);
        throw;      // not reached
    }
}


Foam::wordList Foam::dustProperties::keywords()
{
    return
    {
        "FoamFile",
        // read here
        "materials", "dustMaterial", "patchMaterials", "patchCurvature",
        "contact", "reducedStiffness", "timeIntegration",
        // read by the cloud
        "coupling", "gas", "couplingMassLoading", "progressInterval",
        "solution", "constantProperties", "subModels", "cloudFunctions"
    };
}


Foam::string Foam::dustProperties::listed(const wordList& names)
{
    string text;
    for (const word& name : names)
    {
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}


void Foam::dustProperties::checkKeywords
(
    const dictionary& dict,
    const wordList& valid
)
{
    for (const entry& e : dict)
    {
        if (!valid.found(e.keyword()))
        {
            fatal
            (
                dict,
                e.startLineNumber(),
                e.endLineNumber(),
                "unknown keyword '" + e.keyword() + "' in " + dict.dictName()
              + "\n    allowed: " + listed(valid)
            );
        }
    }
}


void Foam::dustProperties::error
(
    const dictionary& dict,
    const word& keyword,
    const string& reason,
    const string& allowed
)
{
    const entry* ePtr = dict.findEntry(keyword, keyType::LITERAL);
    label start = ePtr ? ePtr->startLineNumber() : dict.startLineNumber();
    label end = ePtr ? ePtr->endLineNumber() : dict.endLineNumber();

    // An entry without a value, as `gravity;`, does not know its line: that of
    // the dictionaries around it
    for
    (
        const dictionary* d = &dict;
        start < 0 && d != &dictionary::null;
        d = &d->parent()
    )
    {
        start = d->startLineNumber();
        end = d->endLineNumber();
    }

    fatal
    (
        dict,
        start,
        end,
        "keyword '" + keyword + "' in " + dict.dictName() + ": " + reason
      + "\n    allowed: " + allowed
    );
}


void Foam::dustProperties::error
(
    const dictionary& dict,
    const dem::inputError& e
)
{
    const dictionary* where = &dict;
    const entry* found = nullptr;

    for (const auto& part : stringOps::split(e.keyword, '/'))
    {
        const std::string name(part.str());
        const entry* next = where->findEntry(name, keyType::LITERAL);

        // A pair that the user did not name, or in the other order
        const auto dot = name.find('.');
        if (!next && dot != std::string::npos)
        {
            next = where->findEntry
            (
                name.substr(dot + 1) + '.' + name.substr(0, dot),
                keyType::LITERAL
            );
            if (!next)
            {
                next = where->findEntry("default", keyType::LITERAL);
            }
        }

        if (!next)
        {
            break;
        }
        found = next;
        if (!next->isDict())
        {
            break;
        }
        where = &next->dict();
    }

    fatal
    (
        *where,
        found ? found->startLineNumber() : where->startLineNumber(),
        found ? found->endLineNumber() : where->endLineNumber(),
        string("keyword '") + e.keyword + "': " + e.reason
      + "\n    allowed: " + e.allowed
    );
}


// ************************************************************************* //
