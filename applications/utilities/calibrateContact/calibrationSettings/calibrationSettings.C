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

#include "calibrationSettings.H"
#include "caseInput.H"
#include "dustKeywords.H"
#include "mathematicalConstants.H"
#include "Tuple2.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// With a neck, and without: see scaledCollision.H
static const wordList laws({"JKR", "simplifiedJKR"});


//- system/calibrateContactDict, as dustKeywords.H has it: path, models, kind,
//  unit, default, allowed, meaning
static const std::vector<dustKeywords::row>& rows()
{
    static const std::vector<dustKeywords::row> table
    ({
        {"pair", "", dustKeywords::name, "-", "", "", "a.b: two materials"},
        {"diameter", "", dustKeywords::number, "m", "", ">=1e-10 <=1",
            "of the sphere"},
        {"points", "", dustKeywords::other, "m/s, -", "", "( (v e) ... )",
            "speed and restitution of normal impacts"},
        {"density", "", dustKeywords::number, "kg/m3",
            "of constant/dustProperties", ">=1e-3 <=1e20", "of the sphere"},
        {"configuration", "", dustKeywords::name, "-",
            "of constant/dustProperties", "wall spheres",
            "a sphere on a wall, or two equal ones"},
        {"model", "", dustKeywords::name, "-", laws[0],
            laws[0] + ' ' + laws[1], "the contact law"},
        {"plateauRestitution", "", dustKeywords::number, "-", "fitted",
            ">=0.01 <=1", "of fast impacts"},
        {"fitPoint", "", dustKeywords::other, "m/s, -", "none", "(v e)",
            "that alone gives the adhesion"},
        {"effectiveYoungsModulus", "", dustKeywords::number, "Pa",
            "of constant/dustProperties", ">=1 <=1e20", "of the real pair"},
        {"overlap", "", dustKeywords::number, "-", "0.01", ">=1e-9 <=1",
            "largest overlap over the diameter"},
        {"highestVelocity", "", dustKeywords::number, "m/s",
            "of the fastest point", ">=1e-9 <=1e6", "where it shall hold"},
        {"output", "", dustKeywords::name, "-", "constant/calibratedContact",
            "", "the file to write"}
    });
    return table;
}


static calibrationSettings::measurement checkedPoint
(
    const dictionary& dict,
    const word& keyword,
    const Tuple2<scalar, scalar>& p
)
{
    caseInput::check
    (
        dict, keyword, p.first(), p.first() >= 1e-9 && p.first() <= 1e6,
        "(v e) with v from 1e-9 to 1e6 m/s"
    );
    caseInput::check
    (
        dict, keyword, p.second(), p.second() >= 0 && p.second() < 1,
        "(v e) with 0 <= e < 1"
    );
    return {p.first(), p.second()};
}

} // End namespace Foam


// * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool Foam::calibrationSettings::lookAtProperties(const Time& runTime)
{
    IOobject io
    (
        caseInput::mustRead("dustProperties", runTime.constant(), runTime)
    );
    if (!io.typeHeaderOk<IOdictionary>(false))
    {
        return false;
    }
    const IOdictionary properties
    (
        caseInput::read(io.name(), io.instance(), runTime)
    );
    const dustProperties dust(properties);
    const dem::MaterialTable table(dust.table());

    wordList ofWalls;
    const dictionary& patches = properties.subOrEmptyDict("patchMaterials");
    for (const entry& e : patches)
    {
        ofWalls.append(patches.get<word>(e.keyword()));
    }

    const auto& materials = table.materials();
    for (std::size_t i = 0; i < materials.size(); ++i)
    {
        for (std::size_t j = 0; j < materials.size(); ++j)
        {
            if (pair != materials[i].name + "." + materials[j].name)
            {
                continue;
            }
            density = std::max(materials[i].density, materials[j].density);
            wall =
                i != j
             && (
                    !(materials[i].density > 0) || !(materials[j].density > 0)
                 || ofWalls.found(word(materials[i].name))
                 || ofWalls.found(word(materials[j].name))
                );
            realE = table.constants(int(i), int(j)).realE;
        }
    }
    return density > 0;
}


void Foam::calibrationSettings::readPair
(
    const dictionary& dict,
    const Time& runTime
)
{
    pair = dict.get<word>("pair");
    if (pair.find('.') == std::string::npos)
    {
        dustProperties::error
        (
            dict, "pair", "'" + pair + "' names no two materials", "a.b"
        );
    }
    radius = 0.5*dict.get<scalar>("diameter");

    const bool known = lookAtProperties(runTime);

    dict.readIfPresent("density", density);
    if (!(density > 0))
    {
        dustProperties::error
        (
            dict,
            "pair",
            "the density of " + pair + " is not known",
            "density here, or the two materials in constant/dustProperties"
        );
    }
    dict.readIfPresent("effectiveYoungsModulus", realE);
    if (!known && !dict.found("configuration"))
    {
        dustProperties::error
        (
            dict,
            "pair",
            "whether " + pair + " is a sphere on a wall is not known",
            "configuration wall; or configuration spheres;"
        );
    }
    if (dict.found("configuration"))
    {
        wall = dict.get<word>("configuration") == "wall";
    }

    model = dict.lookupOrDefault("model", laws[0]);
    neck = model == laws[0];
}


void Foam::calibrationSettings::readPoints(const dictionary& dict)
{
    label rebounds = 0;
    for
    (
        const Tuple2<scalar, scalar>& p
      : dict.get<List<Tuple2<scalar, scalar>>>("points")
    )
    {
        points.push_back(checkedPoint(dict, "points", p));
        rebounds += p.second() > 0;
    }

    dict.readIfPresent("plateauRestitution", plateau);
    if (dict.found("fitPoint"))
    {
        fitPoint = checkedPoint
        (
            dict, "fitPoint", dict.get<Tuple2<scalar, scalar>>("fitPoint")
        );
        caseInput::check
        (
            dict, "fitPoint", fitPoint.e, fitPoint.e > 0,
            "(v e) with e > 0: a point that rebounds"
        );
    }

    // Unknown: alpha, and X
    const label needed = (plateau > 0 ? 0 : 1) + (fitPoint.v > 0 ? 0 : 1);
    if (rebounds < needed)
    {
        dustProperties::error
        (
            dict,
            "points",
            "has " + Foam::name(rebounds) + " points that rebound",
            Foam::name(needed) + " or more, as plateauRestitution and fitPoint"
            " are given or not"
        );
    }
}


void Foam::calibrationSettings::readLimits
(
    const dictionary& dict,
    const Time& runTime
)
{
    scalar highest = fitPoint.v;
    for (const measurement& p : points)
    {
        highest = std::max(highest, p.v);
    }
    overlapLimit = dict.lookupOrDefault<scalar>("overlap", 0.01);
    highestVelocity = dict.lookupOrDefault("highestVelocity", highest);
    output =
        dict.lookupOrDefault<fileName>("output", "constant/calibratedContact");
    if (!output.isAbsolute())
    {
        output = runTime.globalPath()/output;
    }
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::calibrationSettings::calibrationSettings
(
    const dictionary& dict,
    const Time& runTime
)
:
    wall(true),
    density(0),
    realE(0),
    plateau(0),
    fitPoint{0, 0}
{
    dustKeywords::check(dict, rows());
    readPair(dict, runTime);
    readPoints(dict);
    readLimits(dict, runTime);
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::calibrationSettings::m() const
{
    const scalar one =
        density*4.0/3.0*constant::mathematical::pi*pow3(radius);
    return wall ? one : 0.5*one;
}


Foam::scalar Foam::calibrationSettings::velocityFactor() const
{
    const scalar pi = constant::mathematical::pi;
    return
        std::sqrt(m()/(12*pi*std::pow(9*pi, 2.0/3.0)))
       /std::pow(R(), 2.0/3.0);
}



// ************************************************************************* //
