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

#include "argList.H"
#include "IOstreams.H"
#include "ITstream.H"
#include "Switch.H"

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


//- What the tokens of an entry look like
static std::string text(const ITstream& is)
{
    std::ostringstream os;
    for (const token& t : is)
    {
        OSstream out(os, "text");
        out.precision(10);
        os << (os.str().empty() ? "" : " ");
        out << t;
    }
    return os.str();
}


//- A finite number. Of the bits: comparing what is none could trap
static bool finite(const token& t)
{
    return t.isNumber() && dem::isFinite(t.number());
}


static bool isWord(const ITstream& is)
{
    return is.size() == 1 && (is[0].isWord() || is[0].isString());
}


static std::string wordOf(const ITstream& is)
{
    return is[0].isWord() ? is[0].wordToken() : is[0].stringToken();
}


//- What is wrong with what should be a number; empty: nothing
static std::string faultOfNumber
(
    const ITstream& is,
    const bool whole,
    const allowance& allowed
)
{
    const std::string given = "is '" + text(is) + "', ";

    if (is.size() > 1 && is[0].isNumber())
    {
        return given + "more than one number";
    }
    if (is.size() != 1 || !finite(is[0]))
    {
        return given + "not a number";
    }
    if (whole && !is[0].isLabel())
    {
        return given + "not a whole number that can be counted to";
    }
    return allowed.contains(is[0].number()) ? "" : "is " + text(is);
}


//- The same of three numbers
static std::string faultOfVector
(
    const ITstream& is,
    const allowance& allowed
)
{
    bool three = is.size() == 5;
    for (label i = 1; three && i < 4; ++i)
    {
        three = finite(is[i]);
    }
    if
    (
        !three
     || is[0] != token(token::BEGIN_LIST)
     || is[4] != token(token::END_LIST)
    )
    {
        return "is '" + text(is) + "', not three numbers in parentheses";
    }
    for (label i = 1; i < 4; ++i)
    {
        if (!allowed.contains(is[i].number()))
        {
            return "is " + text(is);
        }
    }
    return "";
}


//- What is wrong with the value of an entry; empty: nothing
static std::string fault
(
    const ITstream& is,
    const dustKeywords::row& r,
    const allowance& allowed
)
{
    const std::string given = "is '" + text(is) + "', ";

    if (is.empty())
    {
        return "has no value";
    }
    if (isWord(is) && allowed.contains(wordOf(is)))
    {
        return "";
    }

    switch (r.kind)
    {
        case dustKeywords::number:
        case dustKeywords::integer:
        {
            return faultOfNumber(is, r.kind == dustKeywords::integer, allowed);
        }
        case dustKeywords::vector:
        {
            return faultOfVector(is, allowed);
        }
        case dustKeywords::flag:
        {
            const bool known =
                is.size() == 1
             && (
                    (is[0].isLabel() && (is[0].labelToken() & ~1) == 0)
                 || (isWord(is) && Switch(wordOf(is), true).valid())
                );
            return known ? "" : given + "not a switch";
        }
        case dustKeywords::name:
        {
            if (!isWord(is))
            {
                return given + "not one word";
            }
            return
                allowed.words().empty()
              ? ""
              : "unknown value '" + wordOf(is) + "'";
        }
        case dustKeywords::block:
        case dustKeywords::model:
        {
            return given + "not a dictionary";
        }
        default:
        {
            return "";
        }
    }
}


//- Bounds, words and unit as they are printed
static std::string allowedText(const dustKeywords::row& r)
{
    std::string allowed = allowance::listed(r.allowed);
    if (r.kind == dustKeywords::flag)
    {
        allowed = "on, off";
    }
    if (r.kind == dustKeywords::vector)
    {
        allowed +=
            std::string(allowed.empty() ? "" : ", ") + "three numbers (x y z)";
    }
    if (r.kind == dustKeywords::block || r.kind == dustKeywords::model)
    {
        allowed += std::string(allowed.empty() ? "" : ", ") + "{ ... }";
    }
    return allowed;
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
        const word type(dict.lookupOrDefault<word>("type", "none"));
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
        const word type(dict.lookupOrDefault<word>("type", "none"));
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
        return base ? base->lookupOrDefault<word>("model", "none") : "none";
    }
    return "";
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<const Foam::dustKeywords::row*> Foam::dustKeywords::below
(
    const std::string& path,
    const std::string& model
)
{
    std::vector<const row*> found;
    const std::string start = path.empty() ? "" : path + '/';

    for (const row& r : rows())
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


void Foam::dustKeywords::checkEntry
(
    const dictionary& dict,
    const entry& e,
    const row& r
)
{
    const bool isBlock = r.kind == block || r.kind == model;
    std::string wrong;

    if (e.isDict())
    {
        wrong = isBlock || r.kind == other ? "" : "is a dictionary";
    }
    else if (r.kind != model || !e.stream().empty())
    {
        wrong = fault(e.stream(), r, allowance(r.allowed));
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


void Foam::dustKeywords::checkSizes(const dictionary& sizes)
{
    scalar low, high;
    if
    (
        sizes.readIfPresent("minValue", low)
     && sizes.readIfPresent("maxValue", high)
     && !(low < high)
    )
    {
        dustProperties::error
        (
            sizes,
            "maxValue",
            "is " + Foam::name(high) + ", minValue " + Foam::name(low),
            "minValue < maxValue"
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
    const dictionary& dict,
    const std::string& path,
    const std::string& model
)
{
    const std::vector<const row*> valid = below(path, model);
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
                checkBlock(e.dict(), r->path, inner);
            }
        }
    }

    checkMissing(dict, path, valid);

    if (path == "subModels/injectionModels/*/sizeDistribution/*")
    {
        checkSizes(dict);
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


void Foam::dustKeywords::check(const dictionary& properties)
{
    checkBlock(properties, "", "");
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
