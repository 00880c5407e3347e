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

#include "dustKeywords.H"
#include "patchCurvature.H"
#include "probeSettings.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- system/contactProbeDict, as dustKeywords.H has it: path, models, kind, unit,
//  default, allowed, meaning
static const std::vector<dustKeywords::row>& rows()
{
    static const std::vector<dustKeywords::row> table
    ({
        {"pairs", "", dustKeywords::other, "-", "", "( a.b ... )",
            "materials that touch"},
        {"diameter", "", dustKeywords::number, "m", "", ">=1e-10 <=1",
            "of the sphere"},
        {"partnerDiameter", "", dustKeywords::number, "m", "diameter",
            ">=1e-10 <=1", "of the second sphere"},
        {"velocities", "", dustKeywords::numbers, "m/s", "",
            ">=1e-9 <=1e6", "relative speed of the two"},
        {"wallRadius", "", dustKeywords::other, "m", "flat",
            "as in patchCurvature", "of walls"},
        {"angles", "", dustKeywords::numbers, "deg", "( 0 )", ">=0 <=89.99",
            "from the normal"},
        {"chi", "", dustKeywords::numbers, "-", "reducedStiffness/ratio",
            ">=1e-9 <=1", "stiffness ratios"},
        {"tangentialForce", "", dustKeywords::number, "N", "0",
            "0 >=1e-30 <=1e6", "from touch on"},
        {"duration", "", dustKeywords::number, "s", "50 windows",
            ">=1e-15 <=1e6", "how long a held contact is watched"},
        {"slipVelocity", "", dustKeywords::number, "m/s", "none",
            ">=1e-9 <=1e6", "of the gas past a held particle"},
        {"gasViscosity", "", dustKeywords::number, "Pa s", "none",
            ">=1e-9 <=1e6", "for the limit pullOffOverForce"},
        {"curve", "", dustKeywords::block, "-", "none: the defaults", "",
            "of the option -curve"},
        {"curve/points", "", dustKeywords::integer, "-", "200",
            ">=10 <=1000000", "of each branch"},
        {"curve/overlaps", "", dustKeywords::numbers, "m",
            "that of the fastest impact", ">=-1 <=1", "turning points"}
    });
    return table;
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
    dustKeywords::check(dict, rows());
    readPairs(dict, patchMaterials, materials);

    diameter_ = dict.get<scalar>("diameter");
    partnerDiameter_ = dict.lookupOrDefault("partnerDiameter", diameter_);

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

    velocities_ = dict.get<scalarList>("velocities");
    angles_ = dict.lookupOrDefault("angles", scalarList(1, Zero));
    dict.readIfPresent("chi", chi_);

    tangentialForce_ = dict.lookupOrDefault<scalar>("tangentialForce", 0);
    duration_ = dict.lookupOrDefault<scalar>("duration", 0);
    slipVelocity_ = dict.lookupOrDefault<scalar>("slipVelocity", 0);
    gasViscosity_ = dict.lookupOrDefault<scalar>("gasViscosity", 0);
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
    curvePoints_ = curve.lookupOrDefault<label>("points", 200);
    if (curve.readIfPresent("overlaps", curveOverlaps_))
    {
        for (const scalar d : curveOverlaps_)
        {
            if (d <= -diameter_ || d >= 0.4*diameter_)
            {
                dustProperties::error
                (
                    curve, "overlaps", "is " + Foam::name(d),
                    "( d1 d2 ... ) [m], each below 0.4 of the diameter"
                );
            }
        }
    }
}


// ************************************************************************* //
