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

#include "dictionaryLines.H"

#include "DynamicList.H"
#include "HashTable.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What the master has told the others
static HashTable<dictionaryLines::place, string, string::hash> toldPlaces;


static string nameOf(const dictionary& dict, const word& keyword)
{
    return dict.name() + '/' + keyword;
}


//- Of those entries that know them: one without a value does not
static labelPair linesOf(const dictionary& dict)
{
    labelPair lines(-1, -1);
    for (const entry& e : dict)
    {
        if (lines.first() < 0)
        {
            lines.first() = e.startLineNumber();
        }
        lines.second() = max(lines.second(), e.endLineNumber());
    }
    return lines;
}


static labelPair linesOf(const dictionary& dict, const word& keyword)
{
    const entry* e = dict.findEntry(keyword, keyType::LITERAL);
    labelPair lines
    (
        e ? labelPair(e->startLineNumber(), e->endLineNumber()) : linesOf(dict)
    );
    for
    (
        const dictionary* d = &dict;
        lines.first() < 0 && d != &dictionary::null;
        d = &d->parent()
    )
    {
        lines = linesOf(*d);
    }
    return lines;
}


//- Names and lines of a dictionary and of all that is in it, in their order
static void collect
(
    const dictionary& dict,
    DynamicList<string>& names,
    DynamicList<labelPair>& lines
)
{
    names.append(nameOf(dict, ""));
    lines.append(linesOf(dict, ""));
    for (const entry& e : dict)
    {
        names.append(nameOf(dict, e.keyword()));
        lines.append(linesOf(dict, e.keyword()));
        if (e.isDict())
        {
            collect(e.dict(), names, lines);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::dictionaryLines::share(const dictionary& dict)
{
    if (!Pstream::parRun())
    {
        return;
    }
    DynamicList<string> names;
    DynamicList<labelPair> mine;
    collect(dict, names, mine);

    List<labelPair> lines(mine);
    fileName file(dict.name());
    Pstream::scatter(lines);
    Pstream::scatter(file);

    if (!Pstream::master() && lines.size() == names.size())
    {
        forAll(names, i)
        {
            toldPlaces.set(names[i], {file, lines[i]});
        }
    }
}


Foam::dictionaryLines::place Foam::dictionaryLines::of
(
    const dictionary& dict,
    const word& keyword
)
{
    for (const string& name : {nameOf(dict, keyword), nameOf(dict, "")})
    {
        const auto told = toldPlaces.cfind(name);
        if (told.found())
        {
            return *told;
        }
    }
    return {dict.name(), linesOf(dict, keyword)};
}


// ************************************************************************* //
