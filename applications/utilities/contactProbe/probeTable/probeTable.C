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

#include "probeTable.H"
#include "patchCurvature.H"

#include "DynamicList.H"
#include "IOmanip.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace Foam;
using namespace Foam::probeFiles;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Error of the restitution that the advice on contact steps allows
constexpr scalar restitutionError = 0.002;


void printRow
(
    const char* name,
    const char* unit,
    const std::vector<contactPair>& soft,
    const std::function<scalar(const contactPair&)>& value
)
{
    Info<< "    " << padded(name, 31).c_str() << padded(unit, 8).c_str();
    for (const contactPair& p : soft)
    {
        Info<< ' ' << setw(11) << value(p);
    }
    Info<< nl;
}


const dem::ContactLaw& law(const contactPair& p)
{
    const dem::MaterialTable& table = p.table();
    return *table.laws()[table.lawIndex(p.pair().i, p.pair().j)];
}


//- The law that the Tabor number asks for, and a warning where it is another
void printValidity(const contactPair& p)
{
    if (!law(p).elastic())
    {
        return;     // its attraction is not that of surface energy
    }
    const scalar lambda = p.figures(0).tabor;
    const dem::TaborRange range = law(p).taborRange();

    if (!(p.constants().realGamma > 0))
    {
        Info<< "    No adhesion: Hertz" << nl;
        return;
    }

    Info<< "    Tabor number lambda_T = " << lambda << ": "
        << (
               lambda > 3 ? "JKR (above 3)"
             : lambda < 0.1 ? "DMT (below 0.1)"
             : "between JKR (above 3) and DMT (below 0.1)"
           )
        << nl;

    const word model(p.settings().normal.model);
    if (lambda < range.least || lambda > range.most)
    {
        Info<< "    WARNING: normal model " << model
            << " is outside its validity (lambda_T "
            << (lambda < range.least ? "above " : "below ")
            << (lambda < range.least ? range.least : range.most) << ')' << nl;
    }
    if (model == "simplifiedJKR")
    {
        Info<< "    simplifiedJKR has no neck: it holds (8/9) F_C at most" << nl;
    }
}


//- The speeds at which a normal impact is not refused
scalarList computable(const contactPair& p, const scalarList& velocities)
{
    DynamicList<scalar> good;
    for (const scalar v : velocities)
    {
        if (p.collide(v).outcome != contactPair::REFUSED)
        {
            good.append(v);
        }
    }
    return scalarList(good);
}


//- Error of the restitution over the number of contact steps
void printSteps(const contactPair& p, const scalarList& velocities)
{
    // Slowest, middle and fastest of those that rebound tell enough
    scalarList v(velocities);
    std::sort(v.begin(), v.end());
    if (v.size() > 3)
    {
        v = scalarList({v.first(), v[v.size()/2], v.last()});
    }

    v = computable(p, v);
    if (v.empty())
    {
        Info<< "    No impact of these can be computed" << nl;
        return;
    }

    const auto withSteps = [&](const scalar steps)
    {
        dem::TimeSettings time(p.time());
        time.stepsPerContact = steps;
        return contactPair
        (
            p.table(), time, p.pair(), 2*p.radius(),
            p.partnerRadius() > 0 ? 2*p.partnerRadius() : 2*p.radius()
        );
    };

    scalarList exact(v.size());
    const contactPair fine(withSteps(2000));
    forAll(v, k)
    {
        exact[k] = fine.collide(v[k]).restitution;
    }

    const auto error = [&](const scalar steps)
    {
        const contactPair coarse(withSteps(steps));
        scalar worst = 0;
        forAll(v, k)
        {
            worst = std::max
            (
                worst,
                std::fabs(coarse.collide(v[k]).restitution - exact[k])
            );
        }
        return worst;
    };

    Info<< "    Error of the restitution over contact steps:";
    scalar suggested = 0;
    for (const scalar steps : {25, 34, 50, 100, 200, 400})
    {
        const scalar e = error(steps);
        Info<< (steps > 25 ? ", " : " ") << steps << ": " << e;
        if (!suggested && e <= restitutionError)
        {
            suggested = steps;
        }
    }
    Info<< nl << "    Suggested stepsPerContact: ";
    if (suggested)
    {
        Info<< suggested << " (error below " << restitutionError << ")";
    }
    else
    {
        Info<< "400 or more (some impact is close to the sticking speed)";
    }
    Info<< "; in dustProperties: " << p.time().stepsPerContact << nl;

    const scalar fewest = dem::TimeSettings::fewestStepsWherePlastic;
    if (!law(p).elastic() && p.time().stepsPerContact < fewest)
    {
        Info<< "    WARNING: " << word(p.settings().normal.model) << ", which turns"
            << " from loading to unloading at a kink, wants stepsPerContact "
            << fewest << " or more" << nl;
    }
}


void printAdvice
(
    const contactPair& real,
    const probeSettings& settings,
    const dustProperties::limitSettings& limits
)
{
    const dem::RatioAdvice found = probeTable::advice(real, settings, limits);
    if (const dem::RatioNeed* margin = found.find("pullOffOverForce"))
    {
        Info<< "    Pull-off force over Stokes drag at "
            << settings.slipVelocity() << " m/s and "
            << settings.gasViscosity() << " Pa s: " << margin->real
            << " unsoftened; the limit is " << margin->bound << nl;
    }
    Info<< "    Softest chi by limit:" << nl << found.text().c_str()
        << "    Suggested chi: " << found.chi << " (" << found.binding().limit
        << " binds)";
    if (!(settings.slipVelocity() > 0))
    {
        Info<< "; without slipVelocity and gasViscosity the limit"
            << " pullOffOverForce is not looked at";
    }
    Info<< nl;
}


void printHeading(const pairSeries& series)
{
    const contactPair& real = series.real.front();
    const dem::ContactSettings& s = real.settings();

    Info<< nl << series.pair.name << ": ";
    if (series.pair.wall)
    {
        const dem::WallCurvature& k = series.pair.curvature;
        Info<< "sphere of " << 2*real.radius() << " m on a "
            << (k.flat() ? "flat" : "curved") << " wall";
        if (!k.flat())
        {
            Info<< " (" << patchCurvature::described(k).c_str() << ")";
        }
    }
    else
    {
        Info<< "spheres of " << 2*real.radius() << " and "
            << 2*real.partnerRadius() << " m";
    }
    Info<< ", " << word(s.normal.model) << " + " << word(s.tangential.model)
        << " + " << word(s.rolling.model) << " + " << word(s.twisting.model) << nl;
}


//- Stiffness, adhesion and the contact at equilibrium
void printEquilibrium(const pairSeries& series)
{
    const std::vector<contactPair>& soft = series.soft;

    printRow
    (
        "stiffness ratio chi", "", soft,
        [](const contactPair& p) { return p.constants().chi; }
    );
    printRow
    (
        "effective modulus E", "Pa", soft,
        [](const contactPair& p) { return p.constants().E; }
    );
    printRow
    (
        "surface energy gamma", "J/m2", soft,
        [](const contactPair& p) { return p.constants().gamma; }
    );
    printRow
    (
        "work of adhesion W = 2 gamma", "J/m2", soft,
        [](const contactPair& p) { return 2*p.constants().gamma; }
    );
    printRow
    (
        "pull-off force F_C", "N", soft,
        [](const contactPair& p) { return p.figures(0).pullOff; }
    );
    if
    (
        !series.pair.curvature.flat()
     && soft.front().figures(0).pullOff > 0
    )
    {
        printRow
        (
            "  of that of a flat wall", "-", soft,
            [](const contactPair& p)
            {
                return
                    p.figures(0).pullOff
                   /p.table().figures
                    (
                        p.pair().i, p.pair().j, p.radius(), 0, p.mass(), 0, 0
                    ).pullOff;
            }
        );
    }
    printRow
    (
        "contact radius a0", "m", soft,
        [](const contactPair& p) { return p.figures(0).a0; }
    );
    printRow
    (
        "overlap delta_0", "m", soft,
        [](const contactPair& p) { return p.figures(0).delta0; }
    );
    printRow
    (
        "neck delta_C", "m", soft,
        [](const contactPair& p) { return p.figures(0).deltaC; }
    );
}


//- Where sliding and rolling begin; v: of the impact [m/s]
void printYield(const pairSeries& series, const scalar v)
{
    const dem::ContactSettings& s = series.real.front().settings();
    const std::vector<contactPair>& soft = series.soft;

    if (s.tangential.model != "none")
    {
        printRow
        (
            "sliding yields at force", "N", soft,
            [&](const contactPair& p)
            {
                return heldContact(p, v).limit(heldContact::SLIDING).limit;
            }
        );
    }
    if (s.rolling.model != "none")
    {
        printRow
        (
            "rolling yields at moment", "N m", soft,
            [&](const contactPair& p)
            {
                return heldContact(p, v).limit(heldContact::ROLLING).limit;
            }
        );
        if (series.pair.wall)
        {
            printRow
            (
                "  = force on the sphere", "N", soft,
                [&](const contactPair& p)
                {
                    return
                        heldContact(p, v).limit(heldContact::ROLLING).limit
                       /p.radius();
                }
            );
        }
    }
}


//- A normal impact at v [m/s]
void printImpact(const std::vector<contactPair>& soft, const scalar v)
{
    Info<< "    at " << v << " m/s, normal:" << nl;
    printRow
    (
        "contact time", "s", soft,
        [&](const contactPair& p)
        {
            const auto c = p.collide(v);
            // of a held contact: one period
            return
                c.outcome == contactPair::REBOUND
             || c.outcome == contactPair::REFUSED
              ? c.contactTime : p.figures(v).period;
        }
    );
    printRow
    (
        "contact step", "s", soft,
        [&](const contactPair& p)
        {
            return p.figures(v).period/p.time().stepsPerContact;
        }
    );
    printRow
    (
        "stable below (alone)", "s", soft,
        [&](const contactPair& p) { return p.figures(v).stableStep; }
    );
    printRow
    (
        "overlap/d", "-", soft,
        [&](const contactPair& p)
        {
            return p.collide(v).maxOverlap/(2*p.smallerRadius());
        }
    );
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

dem::RatioAdvice Foam::probeTable::advice
(
    const contactPair& real,
    const probeSettings& settings,
    const dustProperties::limitSettings& limits
)
{
    const scalar mu = settings.gasViscosity(), d = 2*real.radius();
    const scalar Sp = 3*constant::mathematical::pi*mu*d;
    const dem::RatioLoad load
    {
        real.radius(), real.mass(), Sp*settings.slipVelocity(), fastest(settings),
        Sp > 0 ? real.mass()/Sp : 0
    };
    const dem::RatioPartner partner
    {
        real.pair().j, real.pair().wall, real.pair().curvature,
        std::string(real.pair().name), real.partnerRadius(),
        real.partnerMass()
    };
    return dem::adviseRatio
    (
        real.table(), real.pair().i, {partner}, {load}, limits
    );
}


void Foam::probeTable::print
(
    const pairSeries& series,
    const probeSettings& settings,
    const dustProperties::limitSettings& limits
)
{
    const contactPair& real = series.real.front();
    const scalar v = fastest(settings);

    printHeading(series);
    printEquilibrium(series);
    printYield(series, v);
    printImpact(series.soft, v);
    printValidity(real);
    printSteps(series.soft.front(), settings.velocities());
    // Others have a softening of their own
    if (law(real).elastic())
    {
        printAdvice(real, settings, limits);
    }
}


// ************************************************************************* //
