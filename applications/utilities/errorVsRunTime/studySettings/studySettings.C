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

#include "caseInput.H"
#include "entryText.H"
#include "studySettings.H"

#include "IFstream.H"
#include "OSspecific.H"
#include "Switch.H"

#include <algorithm>
#include <cctype>

using Foam::caseInput::check;
using Foam::caseInput::choice;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The items of a list of anything: words, numbers, strings, lists
static std::vector<std::string> itemsOf
(
    const dictionary& dict,
    const word& keyword
)
{
    const string allowed("( v1 v2 ... )");
    std::vector<std::string> items;
    label depth = 0;

    ITstream& is = dict.lookup(keyword);
    for (const token& t : static_cast<const tokenList&>(is))
    {
        const bool open = t.isPunctuation() && t.pToken() == token::BEGIN_LIST;
        const bool close = t.isPunctuation() && t.pToken() == token::END_LIST;

        if (close && --depth == 0)
        {
            break;
        }
        if (depth == 0 && !open)
        {
            dustProperties::error(dict, keyword, "is not a list", allowed);
        }
        if (depth > 0)
        {
            ITstream one(keyword, tokenList(1, t));
            const std::string text(entryText::tokensText(one));
            if (depth == 1 && !close)
            {
                items.push_back(text);
            }
            else
            {
                std::string& list = items.back();
                list += (close || list.back() == '(' ? "" : " ") + text;
            }
        }
        if (open)
        {
            ++depth;
        }
    }
    if (items.empty())
    {
        dustProperties::error(dict, keyword, "is empty", allowed);
    }
    return items;
}


//- A sub-dictionary, or an error
static const dictionary& subDictOf(const dictionary& dict, const word& keyword)
{
    const entry* e = dict.findEntry(keyword, keyType::LITERAL);
    if (!e || !e->isDict())
    {
        dustProperties::error
        (
            dict, keyword, e ? "is not a dictionary" : "is missing",
            keyword + " { ... }"
        );
    }
    return e->dict();
}


static wordList namesOf(const std::vector<studySettings::variable>& variables)
{
    wordList names;
    for (const auto& v : variables)
    {
        names.append(v.name);
    }
    return names;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::studySettings::variable Foam::studySettings::readVariable
(
    const dictionary& parent,
    const word& name
) const
{
    const dictionary& dict = subDictOf(parent, name);
    dustProperties::checkKeywords(dict, {"file", "entry", "values"});

    variable v;
    v.name = name;
    const fileName file(dict.get<fileName>("file"));
    v.file = file;
    v.path = entryText::split(dict.get<string>("entry"));
    v.values = itemsOf(dict, "values");

    if (file.isAbsolute() || !isFile(file, false))
    {
        dustProperties::error
        (
            dict, "file", "there is no file '" + v.file + "' in the case",
            "a dictionary of the case, as \"constant/dustProperties\""
        );
    }

    const dictionary target((IFstream(v.file)()));
    const dictionary* end;
    const entry* e = entryText::find(target, v.path, end);
    if (!e || e->isDict())
    {
        dustProperties::error
        (
            dict,
            "entry",
            string(e ? "is a dictionary" : "there is no such entry") + " in "
          + v.file + ": '" + dict.get<string>("entry") + '\'',
            "an entry that is there, as a/b/c; in "
          + (end == &target ? word("this file") : word(end->dictName()))
          + " there are " + dustProperties::listed(end->toc())
        );
    }
    return v;
}


Foam::studySettings::setting Foam::studySettings::readSetting
(
    const dictionary& parent,
    const word& keyword,
    const setting& otherwise
) const
{
    if (!parent.found(keyword))
    {
        return otherwise;
    }
    const dictionary& dict = subDictOf(parent, keyword);
    dustProperties::checkKeywords(dict, namesOf(variables_));

    setting s;
    for (const variable& v : variables_)
    {
        const entry* e = dict.findEntry(v.name, keyType::LITERAL);
        if (!e || e->isDict())
        {
            dustProperties::error
            (
                parent, keyword, "has no value of " + v.name,
                "a value for each of " + dustProperties::listed(namesOf(variables_))
            );
        }
        s.push_back(entryText::tokensText(e->stream()));
    }
    return s;
}


Foam::studySettings::quantity Foam::studySettings::readQuantity
(
    const dictionary& dict,
    const dictionary& references,
    const scalar tolerance
) const
{
    dustProperties::checkKeywords
    (
        dict,
        {"file", "column", "where", "take", "weights", "error", "tolerance"}
    );

    quantity q;
    q.name = dict.dictName();
    q.file = dict.get<fileName>("file");
    q.column = dict.get<word>("column");
    q.take = choice
    (
        dict, "take", "last", {"last", "first", "sum", "mean", "min", "max"}
    );
    q.weights = dict.lookupOrDefault<wordList>("weights", wordList());
    if (q.weights.size() && q.take != "mean" && q.take != "sum")
    {
        dustProperties::error
        (
            dict, "weights", "does not go with take " + q.take,
            "take mean, take sum"
        );
    }
    q.relative =
        choice(dict, "error", "relative", {"relative", "absolute"})
     == "relative";
    q.tolerance = caseInput::positiveOr(dict, "tolerance", tolerance, "");

    if (dict.found("where"))
    {
        for (const entry& e : subDictOf(dict, "where"))
        {
            q.where.push_back
            ({
                e.keyword(), entryText::tokensText(e.stream())
            });
        }
    }

    q.reference = 0;
    q.given = references.readIfPresent(q.name, q.reference);
    if (q.given && q.relative && q.reference == 0)
    {
        dustProperties::error
        (
            references, q.name, "is 0, of which no error can be a part",
            "another number, or error absolute; in " + q.name
        );
    }
    return q;
}


void Foam::studySettings::combine(const dictionary& dict)
{
    const bool product =
        choice(dict, "vary", "product", {"product", "oneAtATime"})
     == "product";
    const setting base(readSetting(dict, "base", reference_));

    if (hasReferenceRun())
    {
        settings_.push_back(reference_);
    }
    const auto add = [this](const setting& s)
    {
        if (std::find(settings_.begin(), settings_.end(), s) == settings_.end())
        {
            settings_.push_back(s);
        }
    };

    if (product)
    {
        if (dict.found("base"))
        {
            dustProperties::error
            (
                dict, "base", "is of no use with vary product", "vary oneAtATime"
            );
        }
        std::vector<setting> all(1);
        for (const variable& v : variables_)
        {
            std::vector<setting> longer;
            for (const setting& s : all)
            {
                for (const std::string& value : v.values)
                {
                    longer.push_back(s);
                    longer.back().push_back(value);
                }
            }
            all.swap(longer);
        }
        for (const setting& s : all)
        {
            add(s);
        }
    }
    else
    {
        if (base.empty())
        {
            dustProperties::error
            (
                dict, "vary", "oneAtATime needs something to start from",
                "base { ... } or reference { settings { ... } }"
            );
        }
        add(base);
        for (std::size_t k = 0; k < variables_.size(); ++k)
        {
            for (const std::string& value : variables_[k].values)
            {
                setting s(base);
                s[k] = value;
                add(s);
            }
        }
    }
}


void Foam::studySettings::checkRanks(const dictionary& dict) const
{
    if (ranks_ == 1)
    {
        return;
    }
    const fileName file("system/decomposeParDict");
    if (!isFile(file, false))
    {
        dustProperties::error
        (
            dict, "ranks", "there is no " + file, "1, or a case with that file"
        );
    }
    const dictionary decompose((IFstream(file)()));
    const auto n = decompose.get<label>("numberOfSubdomains");
    if (n != ranks_)
    {
        dustProperties::error
        (
            dict,
            "ranks",
            "is " + Foam::name(ranks_) + ", but numberOfSubdomains in " + file
          + " is " + Foam::name(n),
            "the same number"
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::studySettings::studySettings(const dictionary& dict)
:
    command_(dict.get<string>("command")),
    prepare_(dict.lookupOrDefault<string>("prepare", "")),
    ranks_(dict.lookupOrDefault<label>("ranks", 1)),
    jobs_(dict.lookupOrDefault<label>("jobs", 1)),
    keepFields_(dict.lookupOrDefault<Switch>("keepFields", false)),
    seeded_(dict.found("seeds")),
    seeds_{"", "", {}, {""}}
{
    dustProperties::checkKeywords
    (
        dict,
        {
            "FoamFile", "command", "prepare", "ranks", "jobs", "keepFields",
            "settings", "vary", "base", "reference", "seeds", "quantities",
            "tolerance"
        }
    );
    if (command_.empty())
    {
        dustProperties::error
        (
            dict, "command", "is empty", "a command, as \"dustFoam\""
        );
    }
    check(dict, "ranks", ranks_, ranks_ >= 1, "1, 2, ...");
    check(dict, "jobs", jobs_, jobs_ >= 1, "1, 2, ...");
    checkRanks(dict);

    const dictionary& settings = subDictOf(dict, "settings");
    for (const entry& e : settings)
    {
        variables_.push_back(readVariable(settings, e.keyword()));
    }
    if (variables_.empty())
    {
        dustProperties::error
        (
            dict, "settings", "is empty",
            "name { file ...; entry ...; values ( ... ); }"
        );
    }

    if (seeded_)
    {
        seeds_ = readVariable(dict, "seeds");
        check
        (
            subDictOf(dict, "seeds"), "values", seeds_.values.size(),
            seeds_.values.size() > 1,
            "two values or more, as one tells nothing of the scatter"
        );
    }

    const dictionary& reference = subDictOf(dict, "reference");
    dustProperties::checkKeywords(reference, {"settings", "values"});
    reference_ = readSetting(reference, "settings", setting());
    const dictionary& given = reference.subOrEmptyDict("values");

    const scalar tolerance = caseInput::positive(dict, "tolerance", "");
    const dictionary& quantities = subDictOf(dict, "quantities");
    wordList names;
    for (const entry& e : quantities)
    {
        quantities_.push_back
        (
            readQuantity
            (
                subDictOf(quantities, e.keyword()), given, tolerance
            )
        );
        names.append(e.keyword());
        if (!quantities_.back().given && !hasReferenceRun())
        {
            dustProperties::error
            (
                dict, "reference",
                "has neither settings, nor a value of " + e.keyword(),
                "settings { ... } of the reference run, values { "
              + e.keyword() + " ...; }"
            );
        }
    }
    if (quantities_.empty())
    {
        dustProperties::error
        (
            dict, "quantities", "is empty", "name { file ...; column ...; }"
        );
    }
    dustProperties::checkKeywords(given, names);

    combine(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::string Foam::studySettings::plain(const std::string& text)
{
    std::string result(text);
    for (char& c : result)
    {
        const bool good =
            std::isalnum(static_cast<unsigned char>(c))
         || c == '.' || c == '-' || c == '+' || c == '_';
        if (!good)
        {
            c = '_';
        }
    }
    return result;
}


std::string Foam::studySettings::title(const setting& s) const
{
    std::string text;
    for (std::size_t k = 0; k < s.size(); ++k)
    {
        text +=
            (k ? "." : "") + variables_[k].name + '_' + plain(s[k]);
    }
    return text;
}


// ************************************************************************* //
