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


#include "patchCurvature.H"
#include "dustProperties.H"
#include "ITstream.H"
#include "scalarList.H"
#include "wordRes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The entry that speaks for a patch: its own, or that of a pattern
static const entry* entryOf(const dictionary& dict, const word& patch)
{
    return dict.findEntry(patch, keyType::REGEX);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

dem::WallCurvature Foam::patchCurvature::read
(
    const dictionary& dict,
    const word& keyword,
    const string& alsoAllowed
)
{
    const auto refuse = [&](const string& reason)
    {
        dustProperties::error
        (
            dict,
            keyword,
            reason,
            "a radius [m] of a cylinder, ( R1 R2 ) of both principal radii,"
            " 1e-12 to 1e12, negative where it is hollow, or flat"
          + alsoAllowed
        );
    };

    ITstream& is = dict.lookup(keyword, keyType::REGEX);
    const tokenList& tokens = is;

    if (tokens.size() == 1 && tokens[0].isWord())
    {
        if (tokens[0].wordToken() != "flat")
        {
            refuse("unknown word '" + tokens[0].wordToken() + "'");
        }
        return dem::WallCurvature();
    }

    scalarList radii;
    if (tokens.size() == 1 && tokens[0].isNumber())
    {
        radii = scalarList(1, tokens[0].number());
    }
    else if
    (
        tokens.size() == 4
     && tokens[0] == token::BEGIN_LIST && tokens[3] == token::END_LIST
     && tokens[1].isNumber() && tokens[2].isNumber()
    )
    {
        radii = scalarList({tokens[1].number(), tokens[2].number()});
    }
    else
    {
        refuse("is neither a number nor two of them");
    }

    for (const scalar radius : radii)
    {
        if (mag(radius) < 1e-12 || mag(radius) > 1e12)
        {
            refuse("is " + Foam::name(radius));
        }
    }
    return dem::WallCurvature
    {
        1/radii[0], radii.size() > 1 ? 1/radii[1] : scalar(0)
    };
}


std::string Foam::patchCurvature::described
(
    const dem::WallCurvature& curvature
)
{
    const auto radius = [](const scalar k)
    {
        return k ? Foam::name(1/k) + " m" : word("infinite", false);
    };
    if (curvature.flat())
    {
        return "flat";
    }
    if (curvature.k2 == 0)
    {
        return "radius " + radius(curvature.k1);
    }
    return "radii " + radius(curvature.k1) + " and " + radius(curvature.k2);
}


void Foam::patchCurvature::set
(
    dem::Walls& walls,
    const dictionary& properties
)
{
    const dictionary& dict = properties.subOrEmptyDict("patchCurvature");

    wordList names;
    for (const dem::WallPatch& patch : walls.patches)
    {
        names.append(word(patch.name));
    }
    for (const entry& e : dict)
    {
        bool used = false;
        for (const word& name : names)
        {
            used = used || e.keyword().match(name, e.keyword().isLiteral());
        }
        if (!used)
        {
            dustProperties::error
            (
                dict,
                e.keyword(),
                "is not a patch of type wall in this mesh",
                dustProperties::listed(names)
            );
        }
    }

    forAll(names, i)
    {
        dem::WallPatch& patch = walls.patches[std::size_t(i)];
        const entry* e = entryOf(dict, names[i]);
        const bool measure =
            !e
         || (
                e->isStream() && e->stream().size() == 1
             && e->stream()[0].isWord()
             && e->stream()[0].wordToken() == "auto"
            );
        dem::WallCurvature curvature;
        std::string how("given");

        if (measure)
        {
            const dem::MeasuredCurvature m = dem::measureCurvature(walls, i);
            how = "measured";
            if (m.trusted())
            {
                curvature = m.curvature;
                if (m.edged > 0.01)
                {
                    how +=
                        ", but " + Foam::name(label(100*m.edged + 0.5))
                      + " % of the area has edges sharper than "
                      + Foam::name(label(dem::MeasuredCurvature::sharpest))
                      + " degrees";
                }
            }
            else
            {
                how =
                    "taken so: the mesh cannot tell, only "
                  + Foam::name(label(100*m.share)) + " % of the area has about "
                  + described(m.curvature) + "; patchCurvature can";
            }
        }
        else
        {
            curvature = read(dict, e->keyword(), ", or auto");
        }

        if (!curvature.flat())
        {
            patch.curvature = curvature;
        }
        Info<< "    " << names[i] << ": " << described(curvature).c_str()
            << " (" << how.c_str() << ")" << nl;
    }
}


// ************************************************************************* //
