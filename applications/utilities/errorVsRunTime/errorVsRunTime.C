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
    errorVsRunTime

Description
    How accurate is a case, and what does it cost? Runs the case in the current
    directory with other settings (stiffness ratio chi, contact steps, rest
    tolerance, gas step, mesh, ...: any entry of any dictionary), compares
    quantities that it writes as CSV with those of a reference, and says which
    is the cheapest setting whose error is within a tolerance.

    Every run has a copy of the case, errorVsRunTime/\<setting\>[/seed\<k\>].
    Runs that ended well are not repeated, unless the case or their setting has
    changed (a new build of the program is not noticed: remove errorVsRunTime/);
    one that fails is named with its log, and the others go on. Writes
    postProcessing/errorVsRunTime/errorVsRunTime.csv,

    \verbatim
    setting,<a column per variable>,<q>,error_<q>,ci95_<q>,...,cpu_s,runs,failed
    \endverbatim

    with the mean over the seeds of quantity q, its error and its confidence
    limits (see studyReport.H), and a picture, errorVsRunTime.png, of error
    over CPU time with the Pareto front. CPU time is that of the command and
    all its children, of all ranks, user and system; not that of `prepare`.

Usage
    \b errorVsRunTime [OPTIONS]

      - \par -report
        Run nothing: table, picture and recommendation of what is finished

    Reads system/errorVsRunTimeDict:

    \verbatim
    command         "dustFoam";     // any shell command, run in the copy

    settings                        // a name of yours for each
    {
        stepsPerContact
        {
            file    "constant/dustProperties";
            entry   "timeIntegration/stepsPerContact";  // one that is there;
            values  ( 10 20 50 100 );                   // "dust.steel" counts
        }                                               // as one name
        chi
        {
            file    "constant/dustProperties";
            entry   "reducedStiffness/ratio";
            values  ( 1 0.1 0.01 );     // words, numbers, lists; what holds
        }                               // brackets or blanks in "..."
    }

    reference       // settings to run, or numbers that are known, or both
    {
        settings    { stepsPerContact 400; chi 1; }
        values      { e3 0.4834; }
    }

    quantities      // from CSV files with one header line
    {
        captured
        {
            file    "postProcessing/deposition/0/deposition.csv";
            column  count;
            where   { patch screen; time_s last; }  // optional: only these
                                    // rows; last: as in the last row
            take    last;           // last (default) | first | sum | mean |
                                    // min | max, of those rows
            weights ( size count ); // optional, of sum and mean: columns
                                    // whose product multiplies
            error   relative;       // relative (default) | absolute
            tolerance 0.02;         // optional: its own
        }
    }
    tolerance       0.01;

    // Optional:
    vary            product;        // product (default): every combination |
                                    // oneAtATime: one value at a time differs
    base            { stepsPerContact 100; chi 1; } // from these (default:
                                    // reference/settings)
    seeds                           // every setting runs with each of these
    {
        file    "constant/dustProperties";
        entry   "subModels/injectionModels/inlet/seed";
        values  ( 1 2 3 4 5 6 );
    }
    prepare         "blockMesh";    // before the command; default: nothing
    ranks           2;              // decomposePar, mpirun; default 1
    jobs            1;              // runs at once; default 1
    keepFields      no;             // yes: mesh, times and processor*
                                    // directories of finished runs stay
    \endverbatim

    The copy has no times but 0. A waiting rank counts as CPU time, too.

\*---------------------------------------------------------------------------*/

#include "caseInput.H"
#include "studyPicture.H"

#include "argList.H"
#include "OSspecific.H"

#include <cstdlib>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void addOptions()
{
    argList::addNote
    (
        "Error against run time: runs the case with other settings, compares"
        " quantities from its CSV files with those of a reference, and says"
        " which setting is the cheapest within a tolerance.\n\n"
        "Reads system/errorVsRunTimeDict, e.g.\n"
        "    command    \"dustFoam\";\n"
        "    settings   { chi { file \"constant/dustProperties\";\n"
        "                 entry \"reducedStiffness/ratio\"; values ( 1 0.1 ); } }\n"
        "    reference  { settings { chi 1; } }\n"
        "    quantities { captured { column count; where { patch screen; }\n"
        "                 file \"postProcessing/deposition/0/deposition.csv\"; } }\n"
        "    tolerance  0.01;\n"
        "(all keywords, among them seeds for confidence limits:"
        " errorVsRunTime.C). Runs in errorVsRunTime/, finished ones are not"
        " repeated; writes postProcessing/errorVsRunTime/errorVsRunTime.csv and"
        " a picture."
    );
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addBoolOption
    (
        "report",
        "Run nothing: table, picture and recommendation of what is finished"
    );
}


//- Write the script, and let gnuplot draw it
void draw(const studyPicture& picture, const fileName& directory)
{
    const fileName script(directory/"errorVsRunTime.gp");
    const fileName png(directory/"errorVsRunTime.png");
    picture.write(script, png);
    Foam::rm(png);
    const int code = std::system
    (
        (
            "cd " + directory + " && command -v gnuplot > /dev/null"
            " && gnuplot errorVsRunTime.gp > log.gnuplot 2>&1"
        ).c_str()
    );
    if (code == 0 && isFile(png, false))
    {
        Info<< "    drawn in " << png << nl;
    }
    else
    {
        Info<< "    WARNING: no picture. With gnuplot (Debian: apt-get install"
            << " gnuplot-nox):" << nl
            << "    cd " << directory << " && gnuplot " << script.name() << nl;
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
    Time runTime
    (
        args.rootPath(), args.caseName(), "system", "constant", false, false
    );
    const IOdictionary dict
    (
        caseInput::read("errorVsRunTimeDict", runTime.system(), runTime)
    );
    chDir(runTime.globalPath());

    const studySettings settings(dict);
    studyRuns runs(settings);
    if (!args.found("report"))
    {
        runs.execute();
    }

    const studyReport report(settings, runs.runs());
    const fileName directory("postProcessing/errorVsRunTime");
    const fileName csv(directory/"errorVsRunTime.csv");
    mkDir(directory);
    report.writeTable(csv);
    report.print();
    Info<< nl << "    written to " << csv << nl;

    draw(studyPicture(settings, report), directory);

    label failed = 0;
    for (const studyRuns::run& r : runs.runs())
    {
        failed += !r.failure.empty();
    }
    if (failed)
    {
        Info<< nl << failed << " of " << label(runs.runs().size())
            << " runs failed, see above" << endl;
        std::exit(1);       // argList would end with 0
    }
    Info<< nl << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
