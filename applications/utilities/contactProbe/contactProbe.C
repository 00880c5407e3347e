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

Application
    contactProbe

Description
    What will a pair of materials do? Collides two spheres, or a sphere and a
    wall, flat or curved, for lists of speeds, angles and stiffness ratios chi,
    with the contact laws of constant/dustProperties and the motion that dustFoam
    uses.

    Prints for every pair a table of forces, lengths and times, how many contact
    steps are needed, and how soft the material may be made. Writes

    \verbatim
    pair,chi,velocity_mps,angle_deg,restitution,contactTime_s,maxOverlap_m,outcome,
    tangentialRestitution,spinAfter_radps,reboundAngle_deg,reason
    \endverbatim

    (in one line). restitution is that of the normal velocity, 0 where the contact
    holds; contactTime_s of a contact that holds is the time for which it was
    watched; outcome is rebound, stick, roll, slide or refused (see contactPair.H).
    tangentialRestitution is that of the velocity of the centre along the wall (0
    at normal impact), spinAfter_radps that of the (first) sphere, positive as it
    rolls onwards; both at the end of the watch where the contact holds.
    reboundAngle_deg is from the normal, negative where it turns back. An impact
    that cannot be computed has nan for numbers; reason says why, else none.

Usage
    \b contactProbe [OPTIONS]

      - \par -csv \<file\>
        The table's file; default postProcessing/contactProbe/0/contactProbe.csv.
        The files below go next to it, with its name as the first part of theirs

      - \par -sticking
        Fastest normal impact that sticks, by bisection: _sticking.csv, with
        lambda = E/(rho v^2), Ad = 3 gamma/(rho v^2 r) on a wall, else
        gamma/(rho v^2 R), all as softened, and lambda/Ad^(5/2)

      - \par -curve
        A slow load cycle and the resistance to sliding, rolling and twisting
        at the equilibrium overlap: _forceOverlap.csv, _sliding.csv,
        _rolling.csv, _twisting.csv

      - \par -history
        Every collision in time: _history.csv

    Needs constant/dustProperties (of which it reads all blocks but solution,
    constantProperties, subModels) and system/contactProbeDict (see
    probeSettings.H); no mesh.

\*---------------------------------------------------------------------------*/

#include "caseInput.H"
#include "contactPair.H"
#include "heldContact.H"
#include "patchCurvature.H"
#include "probeFiles.H"
#include "probeSettings.H"

#include "argList.H"
#include "IOmanip.H"
#include "mathematicalConstants.H"
#include "OSspecific.H"
#include "Time.H"

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


// * * * * * * * * * * * * * * * * The Table * * * * * * * * * * * * * * * * //

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


//- The law that the Tabor number asks for, and a warning where it is another
void printValidity(const contactPair& p)
{
    const scalar lambda = p.figures(0).tabor;
    const word law(p.settings().normal.model);

    if (law == "cohesivePlastic")
    {
        return;     // its attraction is not that of surface energy
    }

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

    const bool jkr = law == "JKR" || law == "simplifiedJKR";
    if ((jkr && lambda < 3) || (law == "DMT" && lambda > 0.1))
    {
        Info<< "    WARNING: normal model " << law << " is outside its validity ("
            << (jkr ? "lambda_T above 3)" : "lambda_T below 0.1)") << nl;
    }
    if (law == "simplifiedJKR")
    {
        Info<< "    simplifiedJKR has no neck: it holds (8/9) F_C at most" << nl;
    }
}


//- cohesivePlastic has a softening of its own
bool softens(const contactPair& p)
{
    return p.settings().normal.model != "cohesivePlastic";
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
    if (!softens(p) && p.time().stepsPerContact < fewest)
    {
        Info<< "    WARNING: cohesivePlastic, which turns from loading to"
            << " unloading at a kink, wants stepsPerContact " << fewest
            << " or more" << nl;
    }
}


//- The softest chi that the limits allow for this pair, by the rule of dustFoam
//  (adviseRatio.hpp), with Stokes drag at slipVelocity and the fastest impact
dem::RatioAdvice advice
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


void printAdvice
(
    const contactPair& real,
    const probeSettings& settings,
    const dustProperties::limitSettings& limits
)
{
    const dem::RatioAdvice found = advice(real, settings, limits);
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


void printTable
(
    const pairSeries& series,
    const probeSettings& settings,
    const dustProperties::limitSettings& limits
)
{
    const contactPair& real = series.real.front();
    const dem::ContactSettings& s = real.settings();
    const scalar v = fastest(settings);
    const std::vector<contactPair>& soft = series.soft;

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
    if (!series.pair.curvature.flat())
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

    printValidity(real);
    printSteps(soft.front(), settings.velocities());
    if (softens(real))
    {
        printAdvice(real, settings, limits);
    }
}

} // End namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "What will a pair of materials do? Collides two spheres, or a sphere and"
        " a flat wall, with the contact laws of constant/dustProperties and the"
        " motion of dustFoam.\n\n"
        "Reads constant/dustProperties and system/contactProbeDict, e.g.\n"
        "    pairs      ( dust.steel dust.dust );  // a wall's material: flat wall\n"
        "    diameter   1.27e-6;                   // m\n"
        "    velocities ( 3 5 );                   // m/s\n"
        "    angles     ( 0 30 );                  // degrees from the normal\n"
        "    chi        ( 1 0.1 );                 // stiffness ratios\n"
        "    slipVelocity 1; gasViscosity 1.8e-5;  // for advice on chi\n"
        "(all keywords: probeSettings.H). Prints a table of forces, lengths,"
        " times, contact steps and the softest chi that the limits allow; writes"
        " restitution, contact time, overlap and outcome (rebound, stick, roll,"
        " slide) as CSV."
    );
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addOption
    (
        "csv",
        "file",
        "Write the collisions to this file"
        " (default: postProcessing/contactProbe/0/contactProbe.csv)"
    );
    argList::addBoolOption
    (
        "sticking",
        "Find the fastest normal impact that sticks (<csv>_sticking.csv)"
    );
    argList::addBoolOption
    (
        "curve",
        "Write force over overlap and resistance over displacement"
        " (<csv>_forceOverlap.csv, _sliding, _rolling, _twisting)"
    );
    argList::addBoolOption
    (
        "history",
        "Write every collision in time (<csv>_history.csv)"
    );

    argList args(argc, argv);
    if (!args.checkRootCase())
    {
        FatalError.exit();
    }

    // Neither a mesh nor a controlDict is needed
    Time runTime
    (
        args.rootPath(), args.caseName(), "system", "constant", false, false
    );

    const IOdictionary properties
    (
        caseInput::mustRead("dustProperties", runTime.constant(), runTime)
    );
    dustProperties dust(properties);

    const IOdictionary probeDict
    (
        caseInput::mustRead("contactProbeDict", runTime.system(), runTime)
    );
    const probeSettings settings
    (
        probeDict, properties.subOrEmptyDict("patchMaterials"), dust.materials()
    );

    fileName csv
    (
        args.opt<fileName>
        (
            "csv",
            runTime.globalPath()/"postProcessing"/"contactProbe"/"0"
           /"contactProbe.csv"
        )
    );
    if (csv.ext() != "csv")
    {
        csv += ".csv";
    }
    if (!csv.path().empty())
    {
        mkDir(csv.path());
    }

    try
    {
        const auto pairAt = [&](const probeSettings::pair& p, const scalar chi)
        {
            dust.setRatio(chi);
            return contactPair
            (
                dust.table(), dust.time(), p,
                settings.diameter(), settings.partnerDiameter()
            );
        };

        const scalar given = dust.softening().ratio;
        std::vector<pairSeries> all;
        scalar advised = 0;
        for (const probeSettings::pair& p : settings.pairs())
        {
            all.push_back({p, {}, {pairAt(p, 1)}});
            advised = std::max
            (
                advised,
                advice(all.back().real.front(), settings, dust.limits()).chi
            );
        }

        scalarList chis(settings.chi());
        if (chis.empty())
        {
            chis = scalarList(1, dust.automaticRatio() ? advised : given);
        }
        for (pairSeries& series : all)
        {
            for (const scalar chi : chis)
            {
                series.soft.push_back(pairAt(series.pair, chi));
            }
        }

        if (dust.automaticRatio())
        {
            Info<< nl << "reducedStiffness/ratio auto: the softest that the"
                << " limits allow for these pairs is " << advised << nl;
        }
        if (!dust.softening().scaleSurfaceEnergy)
        {
            Info<< nl << "reducedStiffness/surfaceEnergy unchanged: sticking and"
                << " rebound depend on chi" << nl;
        }

        for (const pairSeries& series : all)
        {
            printTable(series, settings, dust.limits());
        }

        writeCollisions(all, settings, csv, args.found("history"));

        if (args.found("sticking"))
        {
            writeSticking(all, csv);
        }
        if (args.found("curve"))
        {
            Info<< nl << "Curves:" << nl;
            writeForceOverlap(all, settings, csv);
            for (const auto motion :
                {
                    heldContact::SLIDING, heldContact::ROLLING,
                    heldContact::TWISTING
                })
            {
                writeResistance(all, settings, motion, csv);
            }
        }
    }
    catch (const dem::inputError& e)
    {
        dustProperties::error(properties, e);
    }
    catch (const std::exception& e)
    {
        FatalErrorInFunction << e.what() << exit(FatalError);
    }

    Info<< nl << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
