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

#include "allowance.H"
#include "dustKeywords.H"
#include "modelTable.H"
#include "sizeCheck.H"

#include "argList.H"
#include "IOstreams.H"
#include "ITstream.H"

#include <algorithm>
#include <cstring>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- One of the words of a list with blanks between
static bool among(const std::string& list, const std::string& word)
{
    std::istringstream is(list);
    for (std::string part; is >> part;)
    {
        if (part == word)
        {
            return true;
        }
    }
    return false;
}


//- Bounds, words and unit as they are printed
static std::string allowedText(const dustKeywords::row& r)
{
    std::string allowed =
        r.kind == dustKeywords::other
      ? r.allowed
      : allowance::listed(r.allowed);
    if (r.kind == dustKeywords::flag)
    {
        allowed = "on, off";
    }
    if (r.kind == dustKeywords::vector)
    {
        allowed +=
            std::string(allowed.empty() ? "" : ", ") + "three numbers (x y z)";
    }
    if (r.kind == dustKeywords::numbers)
    {
        allowed = "( a b ... ), each " + allowed;
    }
    if (r.kind == dustKeywords::block || r.kind == dustKeywords::model)
    {
        allowed += std::string(allowed.empty() ? "" : ", ") + "{ ... }";
    }
    return allowed;
}


//- The model of an injector, a cloud function or a part of a contact. The rows
//  of a dictionary are not known before
static word typeOf(const dictionary& dict, const word& keyword = "type")
{
    const entry* e = dict.findEntry(keyword, keyType::LITERAL);
    const bool isWord =
        e && e->isStream() && e->stream().size() == 1
     && (e->stream()[0].isWord() || e->stream()[0].isString());
    if (!isWord)
    {
        dustProperties::error
        (
            dict,
            keyword,
            !e ? "is missing" : e->isDict() ? "is a dictionary" : "is no word",
            keyword + " with the name of a model (dustFoam -models, -keywords)"
        );
    }
    return dict.get<word>(keyword);
}


//- May what is checked elsewhere be a dictionary?
static bool mayBeBlock(const dustKeywords::row& r)
{
    return
        r.kind == dustKeywords::block || r.kind == dustKeywords::model
     || (
            r.kind == dustKeywords::other
         && (r.allowed == "a function of time" || r.allowed == "{ ... }")
        );
}


//- Which model the dictionary at a path is of, whose keywords are then asked
//  for. known: false where others say that there is no such model
static std::string modelOf
(
    const std::string& path,
    const dictionary& dict,
    bool& known
)
{
    const std::string keyword = dict.dictName();
    known = true;

    if (path == "subModels/particleForces/*")
    {
        const auto* row = modelTable::find(modelTable::force, keyword);
        known = row && row->works;
        return keyword;
    }
    if (path == "subModels/injectionModels/*")
    {
        const word type(typeOf(dict));
        const auto* row = modelTable::find(modelTable::injection, type);
        // `type none;` switches an injector off, whatever else it says
        known = row && row->works && type != "none";
        return type;
    }
    if (path == "subModels/injectionModels/*/sizeDistribution/*")
    {
        const auto end = keyword.rfind("Distribution");
        return keyword.substr(0, end);
    }
    if (path == "cloudFunctions/*")
    {
        // A library of the user may have others
        const word type(typeOf(dict));
        known = false;
        for (const dustKeywords::row& r : dustKeywords::rows())
        {
            known =
                known || (r.path == path + "/type" && among(r.models, type));
        }
        return type;
    }
    if (path.compare(0, 10, "contact/*/") == 0)
    {
        // A part without a model is merged over the default's
        const dictionary* base = &dict;
        if (!dict.found("model"))
        {
            const dictionary* defaults = dict.topDict().findDict("contact");
            defaults = defaults ? defaults->findDict("default") : nullptr;
            base = defaults ? defaults->findDict(keyword) : nullptr;
        }
        return
            base && base->found("model") ? typeOf(*base, "model") : word("none");
    }
    return "";
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<const Foam::dustKeywords::row*> Foam::dustKeywords::below
(
    const std::vector<row>& table,
    const std::string& path,
    const std::string& model
)
{
    std::vector<const row*> found;
    const std::string start = path.empty() ? "" : path + '/';

    for (const row& r : table)
    {
        if
        (
            r.path.compare(0, start.size(), start) == 0
         && r.path.find('/', start.size()) == std::string::npos
         && (r.models.empty() || among(r.models, model))
        )
        {
            found.push_back(&r);
        }
    }
    return found;
}


const std::string& Foam::dustKeywords::fallback(const std::string& path)
{
    const auto found = std::find_if
    (
        rows().begin(), rows().end(),
        [&](const row& r) { return r.path == path; }
    );
    if (found == rows().end())
    {
        FatalErrorInFunction
            << "no keyword " << path.c_str() << abort(FatalError);
    }
    return found->fallback;
}


void Foam::dustKeywords::checkEntry
(
    const dictionary& dict,
    const entry& e,
    const row& r
)
{
    std::string wrong;

    if (e.isDict())
    {
        wrong = mayBeBlock(r) ? "" : "is a dictionary";
    }
    else if (r.kind != model || !e.stream().empty())
    {
        wrong = fault(e.stream(), r);
    }

    if (!wrong.empty())
    {
        dustProperties::error
        (
            dict,
            e.keyword(),
            wrong,
            allowedText(r) + (r.unit == "-" ? "" : " " + r.unit)
          + " (" + r.meaning + ")"
        );
    }
}


void Foam::dustKeywords::checkMissing
(
    const dictionary& dict,
    const std::string& path,
    const std::vector<const row*>& valid
)
{
    // The overrides of contacts are merged over the default: the parts
    // themselves know what they miss
    if (path.compare(0, 7, "contact") == 0)
    {
        return;
    }
    for (const row* r : valid)
    {
        const word keyword(r->path.substr(path.empty() ? 0 : path.size() + 1));

        if (r->fallback.empty() && !dict.found(keyword))
        {
            dustProperties::error
            (
                dict,
                keyword,
                "is missing",
                allowedText(*r) + (r->unit == "-" ? "" : " " + r->unit)
              + " (" + r->meaning + ")"
            );
        }
    }
}


void Foam::dustKeywords::checkBlock
(
    const std::vector<row>& table,
    const dictionary& dict,
    const std::string& path,
    const std::string& model
)
{
    const std::vector<const row*> valid = below(table, path, model);
    const auto nameOf = [&](const row& r)
    {
        return path.empty() ? r.path : r.path.substr(path.size() + 1);
    };

    wordList names;
    for (const row* r : valid)
    {
        names.append(word(nameOf(*r), false));
    }

    for (const entry& e : dict)
    {
        const std::string keyword = e.keyword();
        const row* r = nullptr;
        for (const row* candidate : valid)
        {
            const std::string name = nameOf(*candidate);
            if (name == keyword || (name == "*" && !r))
            {
                r = candidate;
            }
        }
        if (path.empty() && keyword == "FoamFile")
        {
            continue;
        }
        if (!r)
        {
            dustProperties::checkKeywords(dict, names);
            continue;
        }

        checkEntry(dict, e, *r);

        if (e.isDict() && r->kind != other)
        {
            bool known;
            const std::string inner = modelOf(r->path, e.dict(), known);
            if (known)
            {
                checkBlock(table, e.dict(), r->path, inner);
            }
        }
    }

    checkMissing(dict, path, valid);

    if (path == "subModels/injectionModels/*/sizeDistribution")
    {
        // It is not `missing` to OpenFOAM, which reads an empty one
        const word numbers(typeOf(dict) + "Distribution");
        if (!dict.isDict(numbers))
        {
            dustProperties::error
            (
                dict,
                numbers,
                "is missing",
                "{ the numbers of the distribution }"
            );
        }
    }
    if (path == "subModels/injectionModels/*/sizeDistribution/*")
    {
        sizeCheck::check(word(model), dict);
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const std::vector<Foam::dustKeywords::row>& Foam::dustKeywords::rows()
{
    static const std::vector<row> table = []
    {
        std::vector<row> t;
        addCaseRows(t);
        addContactRows(t);
        addCloudRows(t);
        addForceRows(t);
        addInjectionRows(t);
        addInjectorRows(t);
        addConeRows(t);
        addSizeRows(t);
        addFunctionRows(t);
        return t;
    }();
    return table;
}


Foam::word Foam::dustKeywords::wordOf
(
    const dictionary& dict,
    const std::string& path
)
{
    return dict.lookupOrDefault<word>(fileName(path).name(), fallback(path));
}


Foam::scalar Foam::dustKeywords::numberOf
(
    const dictionary& dict,
    const std::string& path
)
{
    return dict.lookupOrDefault
    (
        fileName(path).name(), readScalar(fallback(path))
    );
}


void Foam::dustKeywords::check(const dictionary& properties)
{
    check(properties, rows());
}


void Foam::dustKeywords::check
(
    const dictionary& dict,
    const std::vector<row>& table
)
{
    checkBlock(table, dict, "", "");
}


void Foam::dustKeywords::print(Ostream& os, const std::string& word)
{
    os  << "| keyword | of | unit | default | allowed | meaning |\n"
        << "|---|---|---|---|---|---|\n";

    for (const row& r : rows())
    {
        std::string line =
            "| `" + r.path + "` | " + r.models + " | " + r.unit + " | "
          + (r.fallback.empty() ? "**required**" : r.fallback) + " | "
          + allowedText(r) + " | " + r.meaning + " |";

        if (line.find(word) != std::string::npos)
        {
            os << line.c_str() << nl;
        }
    }
    os.flush();
}


bool Foam::dustKeywords::asked(int argc, char* argv[])
{
    argList::addBoolOption
    (
        "keywords",
        "Print the keywords of constant/dustProperties, or, with a word after"
        " it, the lines that contain it; needs no case"
    );
    if (argc < 2 || argc > 3 || std::strcmp(argv[1], "-keywords"))
    {
        return false;
    }
    print(Info, argc == 3 ? argv[2] : "");
    return true;
}


// ************************************************************************* //
