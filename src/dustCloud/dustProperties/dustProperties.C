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
#include "dictionaryLines.H"
#include "formatted.H"
#include "dustKeywords.H"
#include "masterFirst.H"
#include "mathematicalConstants.H"
#include "Switch.H"
#include "stringOps.H"
#include "error.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- FatalIOError that names the file and the lines of an entry
static void fatal
(
    const dictionary& dict,
    const word& keyword,
    const string& message
)
{
    const dictionaryLines::place where(dictionaryLines::of(dict, keyword));
    masterFirst();
    FatalIOError
    (
        FUNCTION_NAME,
        __FILE__,
        __LINE__,
        where.file,
        where.lines.first(),
        where.lines.second()
    )   << message.c_str() << exit(FatalIOError);
}


static const dictionary& defaultContact(const dictionary& contact)
{
    if (!contact.findDict("default"))
    {
        dustProperties::error
        (
            contact,
            "default",
            "is missing",
            "default { normal { ... } tangential { ... } rolling { ... }"
            " twisting { ... } }, the law of pairs that are not named"
        );
    }
    return contact.subDict("default");
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustProperties::readMaterials()
{
    const dictionary& materials = dict_.subDict("materials");
    for (const entry& e : materials)
    {
        const dictionary& dict = e.dict();

        dem::Material m;
        m.name = e.keyword();
        m.density = dict.lookupOrDefault<scalar>("density", 0);
        m.youngsModulus = dict.get<scalar>("youngsModulus");
        m.poissonRatio = dict.get<scalar>("poissonRatio");
        m.surfaceEnergy = dict.get<scalar>("surfaceEnergy");
        materials_.push_back(m);

        if (dict.found("density"))
        {
            dustMaterials_.append(e.keyword());
        }
    }

    if (dict_.readIfPresent("dustMaterial", dustMaterial_))
    {
        if (!dustMaterials_.found(dustMaterial_))
        {
            error
            (
                dict_,
                "dustMaterial",
                "no material with a density has the name '"
              + dustMaterial_ + "'",
                listed(dustMaterials_)
            );
        }
    }
    else if (dustMaterials_.size() == 1)
    {
        dustMaterial_ = dustMaterials_[0];
    }
    else if (dustMaterials_.empty())
    {
        error
        (
            dict_,
            "materials",
            "the particles' material needs a density, but none is given",
            "density in one of them"
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

    if (!ePtr)
    {
        error
        (
            dict,
            kind,
            "is missing",
            kind + " { model ...; }, or " + kind + " none;"
        );
    }

    // `rolling none;` is short for `rolling { model none; }`
    if (!ePtr->isDict())
    {
        part.model = word(ePtr->stream());
        return part;
    }

    const dictionary& partDict = ePtr->dict();
    if (!partDict.found("model"))
    {
        error(partDict, "model", "is missing", "a law, or none");
    }
    part.model = partDict.get<word>("model");

    for (const entry& e : partDict)
    {
        if (e.keyword() == "model")
        {
            continue;
        }
        if (e.stream()[0].isWord())
        {
            part.words[e.keyword()] = e.stream()[0].wordToken();
        }
        else
        {
            part.values[e.keyword()] = partDict.get<scalar>(e.keyword());
        }
    }

    return part;
}


dem::ContactSettings Foam::dustProperties::readContactSettings
(
    const dictionary& dict
)
{
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
    const dictionary& defaults = defaultContact(contact);

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
                e.keyword(),
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

    if (dict.found("ratio"))
    {
        const token ratio(dict.lookup("ratio"));
        automaticRatio_ = ratio.isWord();
        softening_.ratio = automaticRatio_ ? 1 : ratio.number();
    }

    if (dict.found("surfaceEnergy"))
    {
        softening_.scaleSurfaceEnergy =
            dict.get<word>("surfaceEnergy") == "scaled";
    }
    if (dict.found("resistance"))
    {
        softening_.scaleResistance = dict.get<word>("resistance") == "scaled";
    }

    const dictionary& limits = dict.subOrEmptyDict("limits");

    limits.readIfPresent("pullOffOverForce", limits_.pullOffOverForce);
    limits.readIfPresent("overlap", limits_.overlap);
    limits.readIfPresent("ratio", limits_.ratio);
    limits.readIfPresent("loadFactor", limits_.loadFactor);

    const word then
    (
        dustKeywords::wordOf(limits, "reducedStiffness/limits/onViolation")
    );
    limits_.stop = then == "stop";
    limits_.stiffen = then == "stiffen";
    if (limits_.stiffen && !softening_.scaleSurfaceEnergy)
    {
        error
        (
            dict,
            "surfaceEnergy",
            "is unchanged, but onViolation is stiffen: pull-off forces do not"
            " depend on chi then",
            "scaled, or onViolation warn or stop"
        );
    }
}


void Foam::dustProperties::readTimeIntegration()
{
    const dictionary& dict = dict_.subOrEmptyDict("timeIntegration");

    dict.readIfPresent("stepsPerContact", time_.stepsPerContact);
    dict.readIfPresent("restTolerance", time_.restTolerance);
    dict.readIfPresent("islands", time_.islands);
    dict.readIfPresent("energyLedger", time_.energyLedger);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dustProperties::dustProperties(const dictionary& dict)
:
    dict_(dict),
    automaticRatio_(false)
{
    dustKeywords::check(dict);

    readMaterials();
    readContact();
    readReducedStiffness();
    readTimeIntegration();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::dustProperties::askedRatio() const
{
    const dictionary& dict = dict_.subOrEmptyDict("reducedStiffness");
    if (!automaticRatio_)
    {
        return Foam::name
        (
            dict.lookupOrDefault("ratio", dem::ReducedStiffness().ratio)
        );
    }
    return formatted
    (
        "auto for pullOffOverForce %.6g, loadFactor %.6g, overlap %.6g, "
        "ratio %.6g",
        limits_.pullOffOverForce, limits_.loadFactor, limits_.overlap,
        limits_.ratio
    );
}


Foam::label Foam::dustProperties::material(const dictionary& injector) const
{
    if (!injector.found("material"))
    {
        return defaultMaterial(injector, "material");
    }
    const word name(injector.get<word>("material"));
    if (!dustMaterials_.found(name))
    {
        error
        (
            injector,
            "material",
            "no material with a density has the name '" + name + "'",
            listed(dustMaterials_)
        );
    }
    return index(name);
}


Foam::label Foam::dustProperties::defaultMaterial
(
    const dictionary& dict,
    const word& keyword
) const
{
    if (dustMaterial_.empty())
    {
        error
        (
            dict,
            keyword,
            "is missing, and several materials have a density",
            keyword + " followed by one of " + listed(dustMaterials_)
          + "; or dustMaterial, for all that name none"
        );
    }
    return index(dustMaterial_);
}


Foam::label Foam::dustProperties::index(const word& material) const
{
    for (std::size_t i = 0; i < materials_.size(); ++i)
    {
        if (materials_[i].name == material)
        {
            return label(i);
        }
    }
    return -1;
}


Foam::scalar Foam::dustProperties::mass
(
    const label material,
    const scalar diameter
) const
{
    return density(material)*constant::mathematical::pi/6*pow3(diameter);
}


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
                e.keyword(),
                "unknown keyword '" + e.keyword() + "' in " + dict.dictName()
              + "\n    allowed: "
              + (valid.empty() ? string("no keyword") : listed(valid))
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
    fatal
    (
        dict,
        keyword,
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
    word keyword;

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
        if (!next->isDict())
        {
            keyword = next->keyword();
            break;
        }
        where = &next->dict();
    }

    fatal
    (
        *where,
        keyword,
        string("keyword '") + e.keyword + "': " + e.reason
      + "\n    allowed: " + e.allowed
    );
}


// ************************************************************************* //
