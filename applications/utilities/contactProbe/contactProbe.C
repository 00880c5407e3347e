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
#include "contactSteps.H"
#include "heldContact.H"
#include "probeFiles.H"
#include "probeSettings.H"
#include "probeTable.H"

#include "argList.H"
#include "OSspecific.H"
#include "Time.H"
#include "unitConversion.H"

#include <algorithm>

using namespace Foam;
using namespace Foam::probeFiles;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void addOptions()
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
}


//- The file of the option -csv, in a directory that is there
fileName csvFile(const argList& args, const Time& runTime)
{
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
    return csv;
}


//- Each pair at each chi; advised: the softest that the limits allow for all
std::vector<pairSeries> makeSeries
(
    dustProperties& dust,
    const probeSettings& settings,
    scalar& advised
)
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
    advised = 0;
    for (const probeSettings::pair& p : settings.pairs())
    {
        all.push_back({p, {}, {pairAt(p, 1)}});
        advised = std::max
        (
            advised,
            probeTable::advice(all.back().real.front(), settings, dust.limits()).chi
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
    return all;
}


void printTables
(
    const std::vector<pairSeries>& all,
    const dustProperties& dust,
    const probeSettings& settings,
    const scalar advised
)
{
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
        probeTable::print(series, settings, dust.limits());
    }
}


//- Contact steps of all collisions, at most
scalar mostSteps
(
    const std::vector<pairSeries>& all,
    const probeSettings& settings
)
{
    scalar most = 0;
    for (const pairSeries& series : all)
    {
        for (const contactPair& p : series.soft)
        {
            for (const scalar v : settings.velocities())
            {
                for (const scalar angle : settings.angles())
                {
                    most += p.mostSteps
                    (
                        v,
                        degToRad(angle),
                        settings.tangentialForce(),
                        settings.duration()
                    );
                }
            }
        }
    }
    return most;
}


void writeFiles
(
    const std::vector<pairSeries>& all,
    const probeSettings& settings,
    const fileName& csv,
    const argList& args
)
{
    Info<< nl;
    contactSteps::ahead(mostSteps(all, settings));
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

} // End namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    addOptions();
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
        caseInput::read("dustProperties", runTime.constant(), runTime)
    );
    dustProperties dust(properties);

    const IOdictionary probeDict
    (
        caseInput::read("contactProbeDict", runTime.system(), runTime)
    );
    const probeSettings settings
    (
        probeDict, properties.subOrEmptyDict("patchMaterials"), dust.materials()
    );

    const fileName csv(csvFile(args, runTime));

    try
    {
        scalar advised = 0;
        const std::vector<pairSeries> all
        (
            makeSeries(dust, settings, advised)
        );
        printTables(all, dust, settings, advised);
        writeFiles(all, settings, csv, args);
    }
    catch (const dem::inputError& e)
    {
        if (e.keyword.compare(0, 14, "patchCurvature") == 0)
        {
            dustProperties::error(probeDict, "wallRadius", e.reason, e.allowed);
        }
        dustProperties::error(properties, e);
    }
    catch (const dem::numericalError& e)
    {
        dustProperties::error
        (
            probeDict, "pairs", string("cannot be held at rest: ") + e.what(),
            "stiffer materials, less surface energy, or larger spheres"
        );
    }

    Info<< nl << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
