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

#include "givenTwice.H"

#include "DynamicList.H"
#include "HashTable.H"
#include "IFstream.H"
#include "OStringStream.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

struct givenValue
{
    string text;
    label line;
};


static string textOf(const token& t)
{
    OStringStream os;
    os.precision(15);
    os  << t;
    return os.str();
}


//- Keep a value; warn if there is another one
static void keep
(
    const fileName& file,
    const UList<string>& names,
    const string& keyword,
    const givenValue& value,
    HashTable<givenValue, string, string::hash>& given
)
{
    string path;
    for (const string& name : names)
    {
        path += name + '/';
    }
    path += keyword;

    const auto before = given.cfind(path);
    if (before.found() && (*before).text != value.text)
    {
        Info<< "Warning: keyword '" << path.c_str() << "' is given twice:"
            << (*before).text.c_str() << " in line " << (*before).line
            << ", and" << value.text.c_str() << " in line " << value.line
            << " of " << file << ". The last one counts" << nl << endl;
    }
    given.set(path, value);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::givenTwice::check(const dictionary& dict)
{
    if (!Pstream::master())
    {
        return;
    }
    IFstream is(dict.name());
    HashTable<givenValue, string, string::hash> given;
    DynamicList<string> names;
    string keyword;
    givenValue value{"", 0};
    label depth = 0;    // of parentheses

    for (token t; is.good() && is.read(t).good();)
    {
        const bool punctuation = t.isPunctuation();
        const char p = punctuation ? char(t.pToken()) : ' ';
        const bool between = depth == 0 && punctuation;
        depth += (p == '(') - (p == ')');

        if (between && p == '{')
        {
            names.append(keyword);
            keyword.clear();
        }
        else if (between && p == '}')
        {
            if (names.empty())
            {
                return;     // OpenFOAM says what is wrong
            }
            names.remove();
            keyword.clear();
        }
        else if (between && p == ';')
        {
            if (!keyword.empty())
            {
                keep(dict.name(), names, keyword, value, given);
            }
            keyword.clear();
        }
        else if (keyword.empty())
        {
            if (!t.isWord() && !t.isString() && !t.isVariable())
            {
                return;
            }
            keyword =
                t.isWord() ? string(t.wordToken()) : string(t.stringToken());
            if (keyword[0] == '#')
            {
                // To the end of its line, as #include
                string rest;
                is.getLine(rest);
                if (keyword.find("#include") != 0)
                {
                    return;     // more than text
                }
                keyword.clear();
            }
            value = givenValue{"", t.lineNumber()};
        }
        else
        {
            value.text += ' ' + textOf(t);
        }
    }
}


// ************************************************************************* //
