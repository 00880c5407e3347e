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
#include "IStringStream.H"

#include "DispersionModel.H"
#include "InjectionModel.H"

#include <cstring>

// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const Foam::modelTable::row* Foam::modelTable::find
(
    const kindType kind,
    const word& name
)
{
    for (const row& r : rows())
    {
        const bool same =
            r.kind == kind || (kind == force && r.kind == drag);

        if (same && r.name == name)
        {
            return &r;
        }
    }
    return nullptr;
}


Foam::wordList Foam::modelTable::registered(const kindType kind)
{
    typedef dustCloud::kinematicCloudType cloudType;

    switch (kind)
    {
        case dispersion:
            return DispersionModel<cloudType>::dictionaryConstructorTablePtr_
                ->sortedToc();
        case injection:
            return InjectionModel<cloudType>::dictionaryConstructorTablePtr_
                ->sortedToc();
        default:
            return ParticleForce<cloudType>::dictionaryConstructorTablePtr_
                ->sortedToc();
    }
}


void Foam::modelTable::print(Ostream& os)
{
    static const char* const kinds[] =
        {"drag", "force", "dispersion", "injection"};

    os  << "| kind | model | | remark | defaults |\n"
        << "|---|---|---|---|---|\n";

    for (const row& r : rows())
    {
        if (!registered(r.kind).found(r.name))
        {
            continue;
        }
        std::string remark = r.remark;
        if (!r.oneRank.empty())
        {
            remark += ". On one rank only: " + r.oneRank;
        }
        if (!r.instead.empty())
        {
            remark += ". Instead: " + r.instead;
        }
        std::string defaults = r.defaults;
        if (!r.schemes.empty())
        {
            defaults +=
                (defaults.empty() ? "" : " ")
              + ("interpolationSchemes { " + r.schemes + " }");
        }
        os  << "| " << kinds[r.kind] << " | `" << r.name << "` | "
            << (r.works ? "works" : "**refused**") << " | " << remark.c_str()
            << " | "
            << (defaults.empty() ? "" : "`" + defaults + "`").c_str()
            << " |\n";
    }

    // What nobody has looked at
    for (const kindType kind : {force, dispersion, injection})
    {
        for (const word& name : registered(kind))
        {
            if (!find(kind, name))
            {
                os  << "| " << kinds[kind] << " | `" << name
                    << "` | **refused** | not tried with dustFoam | |\n";
            }
        }
    }
    os.flush();
}


bool Foam::modelTable::asked(int argc, char* argv[])
{
    if (argc != 2 || std::strcmp(argv[1], "-models"))
    {
        return false;
    }
    print(Info);
    return true;
}


Foam::dictionary Foam::modelTable::completed
(
    const kindType kind,
    const word& name,
    const dictionary& dict
)
{
    // `gravity;` comes with the dictionary that it stands in
    const bool own = dict.dictName() == name || kind != force;
    dictionary full(own ? dict : dictionary::null);
    if (!own)
    {
        full.name() = fileName(dict.name() + '.' + name);
    }

    const row* r = find(kind, name);
    if (r && !r->defaults.empty())
    {
        for (const entry& e : dictionary(IStringStream(r->defaults)()))
        {
            if (!full.found(e.keyword()))
            {
                full.add(e);
            }
        }
    }
    return full;
}


void Foam::modelTable::addSchemes
(
    const dictionary& forces,
    dictionary& interpolationSchemes
)
{
    for (const entry& e : forces)
    {
        const row* r = find(force, e.keyword());

        if (r && !r->schemes.empty())
        {
            for (const entry& s : dictionary(IStringStream(r->schemes)()))
            {
                if (!interpolationSchemes.found(s.keyword()))
                {
                    interpolationSchemes.add(s);
                }
            }
        }
    }
}


void Foam::modelTable::setDensity
(
    const dictionary& properties,
    const dictionary& constants
)
{
    if (constants.found("rho0"))
    {
        return;
    }
    const dustProperties dust(properties);
    const label first = dust.index(dust.dustMaterials()[0]);

    // constantProperties has no other door than its dictionary
    const_cast<dictionary&>(constants).set("rho0", dust.density(first));
}


bool Foam::modelTable::injects(const entry& e)
{
    return
        e.isDict()
     && e.dict().lookupOrDefault<word>("type", "none") != "none";
}


bool Foam::modelTable::streams(const word& injector)
{
    const row* r = find(injection, injector);
    return r && r->streams;
}


// ************************************************************************* //
