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

#include "entryText.H"

#include "dictionary.H"
#include "ITstream.H"
#include "StringStream.H"

#include <algorithm>
#include <cctype>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef std::string::size_type position;

//- Where the value of the entry stands
struct range
{
    position begin = std::string::npos;
    position end = std::string::npos;
};


position afterBlanks(const std::string& t, position p)
{
    while (p < t.size())
    {
        if (std::isspace(static_cast<unsigned char>(t[p])))
        {
            ++p;
        }
        else if (t.compare(p, 2, "//") == 0)
        {
            p = std::min(t.find('\n', p), t.size());
        }
        else if (t.compare(p, 2, "/*") == 0)
        {
            p = t.find("*/", p + 2);
            p = p == std::string::npos ? t.size() : p + 2;
        }
        else
        {
            break;
        }
    }
    return p;
}


//- After the string that begins here
position afterString(const std::string& t, position p)
{
    for (++p; p < t.size() && t[p] != '"'; ++p)
    {
        if (t[p] == '\\') ++p;
    }
    return std::min(p + 1, t.size());
}


//- At the ';' of a value, or at the bracket that ends what it stands in
position endOfValue(const std::string& t, position p)
{
    for (int depth = 0; (p = afterBlanks(t, p)) < t.size(); ++p)
    {
        const char c = t[p];
        if (c == '"')
        {
            p = afterString(t, p) - 1;
        }
        else if (c == '(' || c == '{' || c == '[')
        {
            ++depth;
        }
        else if (c == ')' || c == '}' || c == ']')
        {
            if (--depth < 0) break;
        }
        else if (c == ';' && depth == 0)
        {
            break;
        }
    }
    return p;
}


//- The entries from p on, to the end of the dictionary they are in
position search
(
    const std::string& t,
    position p,
    const std::vector<std::string>& path,
    const std::size_t level,
    range& found
)
{
    while ((p = afterBlanks(t, p)) < t.size() && t[p] != '}')
    {
        if (t[p] == '#')
        {
            p = std::min(t.find('\n', p), t.size());
            continue;
        }
        if (t[p] == '$' || t[p] == '(' || t[p] == ';')
        {
            p = endOfValue(t, p) + 1;
            continue;
        }

        std::string keyword;
        if (t[p] == '"')
        {
            const position end = afterString(t, p);
            keyword = t.substr(p + 1, end - p - 2);
            p = end;
        }
        else
        {
            const position end =
                std::min(t.find_first_of(" \t\r\n;{}\"", p), t.size());
            keyword = t.substr(p, end - p);
            p = end;
        }
        p = afterBlanks(t, p);

        const bool ours = level < path.size() && keyword == path[level];
        if (p < t.size() && t[p] == '{')
        {
            // a dictionary of another name is walked through in vain
            p = search
            (
                t, p + 1, path, ours ? level + 1 : path.size(), found
            ) + 1;
        }
        else
        {
            const position begin = p;
            p = endOfValue(t, p);
            if (ours && level + 1 == path.size())
            {
                found.begin = begin;
                found.end = p;
            }
            ++p;
        }
    }
    return p;
}


std::string quoted(const std::string& name)
{
    return
        name.find_first_of(" .*+?|()[]^$,") == std::string::npos
      ? name : '"' + name + '"';
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<std::string> Foam::entryText::split(const std::string& path)
{
    std::vector<std::string> parts(1);
    bool inQuotes = false;
    for (const char c : path)
    {
        if (c == '"')
        {
            inQuotes = !inQuotes;
        }
        else if (c == '/' && !inQuotes)
        {
            parts.emplace_back();
        }
        else
        {
            parts.back() += c;
        }
    }
    return parts;
}


std::string Foam::entryText::set
(
    std::string text,
    const std::vector<std::string>& path,
    const std::string& value
)
{
    range found;
    search(text, 0, path, 0, found);

    if (found.begin != std::string::npos)
    {
        return text.replace(found.begin, found.end - found.begin, value);
    }

    std::string before, after;
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
    {
        before += quoted(path[k]) + " { ";
        after += " }";
    }
    return
        text + "\n// errorVsRunTime\n" + before + quoted(path.back()) + ' '
      + value + ';' + after + '\n';
}


const Foam::entry* Foam::entryText::find
(
    const dictionary& dict,
    const std::vector<std::string>& path,
    const dictionary*& end
)
{
    end = &dict;
    for (std::size_t k = 0; k < path.size(); ++k)
    {
        const entry* next = end->findEntry(path[k], keyType::LITERAL);
        if (!next)
        {
            return nullptr;
        }
        if (k + 1 == path.size())
        {
            return next;
        }
        if (!next->isDict())
        {
            return nullptr;
        }
        end = &next->dict();
    }
    return nullptr;
}


std::string Foam::entryText::tokensText(ITstream& is)
{
    std::string text;
    for (const token& t : static_cast<const tokenList&>(is))
    {
        OStringStream os;
        os.precision(12);
        if (t.isString())
        {
            os << t.stringToken().c_str();      // without quotes
        }
        else
        {
            os << t;
        }
        const std::string next(os.str());
        const bool tight =
            text.empty() || text.back() == '(' || next == ")";
        text += (tight ? "" : " ") + next;
    }
    return text;
}


std::string Foam::entryText::normalised(const std::string& value)
{
    ITstream is("value", ITstream::parse(value));
    return tokensText(is);
}


// ************************************************************************* //
