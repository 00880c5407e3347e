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
#include "patchCurvature.H"
#include "probeSettings.H"

#include <functional>

using Foam::caseInput::check;
using Foam::caseInput::positiveOr;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A list of numbers that are all good; one of them at least
static scalarList checkedList
(
    const dictionary& dict,
    const word& keyword,
    const std::function<bool(scalar)>& good,
    const string& allowed
)
{
    const scalarList values(dict.get<scalarList>(keyword));

    if (values.empty())
    {
        dustProperties::error(dict, keyword, "is empty", allowed);
    }
    for (const scalar value : values)
    {
        check(dict, keyword, value, good(value), allowed);
    }
    return values;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::probeSettings::readPairs
(
    const dictionary& dict,
    const dictionary& patchMaterials,
    const std::vector<dem::Material>& materials
)
{
    wordList ofWalls;
    for (const entry& e : patchMaterials)
    {
        ofWalls.append(patchMaterials.get<word>(e.keyword()));
    }

    string names;
    for (const dem::Material& m : materials)
    {
        names += (names.empty() ? "" : ", ") + m.name;
    }
    const string allowed("( a.b ... ) of the materials " + names);

    const wordList pairs(dict.get<wordList>("pairs"));
    if (pairs.empty())
    {
        dustProperties::error(dict, "pairs", "is empty", allowed);
    }

    for (const word& name : pairs)
    {
        pair p{name, -1, -1, false, {}};

        // a name may have a dot of its own: try every one
        for
        (
            auto dot = name.find('.');
            dot != std::string::npos;
            dot = name.find('.', dot + 1)
        )
        {
            int i = -1, j = -1;
            for (int k = 0; k < int(materials.size()); ++k)
            {
                if (materials[k].name == name.substr(0, dot)) i = k;
                if (materials[k].name == name.substr(dot + 1)) j = k;
            }
            if (i >= 0 && j >= 0)
            {
                p.i = i;
                p.j = j;
            }
        }
        if (p.i < 0)
        {
            dustProperties::error
            (
                dict,
                "pairs",
                "no such pair of materials as '" + name + "'",
                allowed
            );
        }

        const auto wall = [&](const int k)
        {
            return
                !(materials[k].density > 0)
             || ofWalls.found(word(materials[k].name));
        };
        if (!wall(p.j) && wall(p.i))
        {
            std::swap(p.i, p.j);
        }
        p.wall = p.i != p.j && wall(p.j);

        if (!(materials[p.i].density > 0))
        {
            dustProperties::error
            (
                dict,
                "pairs",
                "'" + name + "' has no sphere: no density is given for "
              + materials[p.i].name,
                "pairs of which one at least has a density"
            );
        }
        pairs_.push_back(p);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::probeSettings::probeSettings
(
    const dictionary& dict,
    const dictionary& patchMaterials,
    const std::vector<dem::Material>& materials
)
{
    dustProperties::checkKeywords
    (
        dict,
        {
            "FoamFile", "pairs", "diameter", "partnerDiameter", "velocities",
            "wallRadius", "angles", "chi", "tangentialForce", "duration",
            "slipVelocity", "gasViscosity", "curve"
        }
    );

    readPairs(dict, patchMaterials, materials);

    diameter_ = dict.get<scalar>("diameter");
    check(dict, "diameter", diameter_, diameter_ > 0, "> 0 m");
    partnerDiameter_ = positiveOr(dict, "partnerDiameter", diameter_, "m");

    if (dict.found("wallRadius"))
    {
        const dem::WallCurvature curvature
        (
            patchCurvature::read(dict, "wallRadius")
        );
        bool used = false;
        for (pair& p : pairs_)
        {
            if (p.wall)
            {
                p.curvature = curvature;
                used = true;
            }
        }
        if (!used)
        {
            dustProperties::error
            (
                dict, "wallRadius", "none of the pairs has a wall",
                "a pair of the dust and the material of a wall"
            );
        }
    }

    velocities_ = checkedList
    (
        dict,
        "velocities",
        [](const scalar v) { return v > 0 && v < GREAT; },
        "( v1 v2 ... ), each > 0 m/s"
    );
    angles_ =
        dict.found("angles")
      ? checkedList
        (
            dict,
            "angles",
            [](const scalar a) { return a >= 0 && a < 90; },
            "( a1 a2 ... ), each from 0 to below 90 degrees"
        )
      : scalarList(1, Zero);

    if (dict.found("chi"))
    {
        chi_ = checkedList
        (
            dict,
            "chi",
            [](const scalar c) { return c > 0 && c <= 1; },
            "( chi1 chi2 ... ), each above 0, at most 1"
        );
    }

    tangentialForce_ = dict.lookupOrDefault<scalar>("tangentialForce", 0);
    check
    (
        dict, "tangentialForce", tangentialForce_, tangentialForce_ >= 0,
        ">= 0 N"
    );
    duration_ = positiveOr(dict, "duration", 0, "s");
    slipVelocity_ = positiveOr(dict, "slipVelocity", 0, "m/s");
    gasViscosity_ = positiveOr(dict, "gasViscosity", 0, "Pa s");
    if ((slipVelocity_ > 0) != (gasViscosity_ > 0))
    {
        dustProperties::error
        (
            dict,
            slipVelocity_ > 0 ? "slipVelocity" : "gasViscosity",
            "is given alone",
            "slipVelocity [m/s] together with gasViscosity [Pa s]"
        );
    }

    const dictionary& curve = dict.subOrEmptyDict("curve");
    dustProperties::checkKeywords(curve, {"points", "overlaps"});
    curvePoints_ = curve.lookupOrDefault<label>("points", 200);
    check
    (
        curve, "points", curvePoints_, curvePoints_ >= 10,
        "a number of points, 10 or more"
    );
    if (curve.found("overlaps"))
    {
        curveOverlaps_ = checkedList
        (
            curve,
            "overlaps",
            [this](const scalar d) { return d > -diameter_ && d < 0.4*diameter_; },
            "( d1 d2 ... ) [m], each below 0.4 of the diameter"
        );
    }
}


// ************************************************************************* //
