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
    calibrateContact

Description
    From measured restitutions to the damping, the stiffness and the surface
    energy of a contact, for JKR and simplifiedJKR.

    The restitution of a normal impact depends on two numbers only: the damping
    coefficient alpha and X = E^(-1/3) gamma^(5/6) (see scaledCollision.H).
    alpha follows from the plateau at high speed, X from where adhesion lets the
    restitution fall. E and gamma are not determined one by one: every E with
    gamma = X^(6/5) E^(2/5) gives the same rebound. So E may be chosen as soft
    as the overlap allows (E_mod, gamma_mod), while rolling and sliding keep
    the strength of the real gamma.

    Reads system/calibrateContactDict, writes a dictionary to #include at the
    end of constant/dustProperties, and the fit as CSV.

Usage
    \b calibrateContact [OPTIONS]

      - \par -map
        Also write the restitution over alpha and 1/A*: map.csv

    \verbatim
    pair            dust.steel;         // a.b: names in dustProperties
    diameter        1.27e-6;            // [m]
    points                              // normal impact: speed [m/s], e [-]
    (
        (2.5    0.42)
        (5      0.71)
        (20     0.85)
    );

    // Optional:
    density         1026;       // [kg/m3] default: of constant/dustProperties
    configuration   wall;       // wall | spheres (equal ones); default: as
                                // contactProbe takes the pair
    model           JKR;        // JKR (default) | simplifiedJKR
    plateauRestitution 0.86;    // fixes alpha; default: fitted
    fitPoint        (2.5 0.42); // X from this point alone; default: all points
    effectiveYoungsModulus 2.7e8;   // [Pa] of the real pair; default: of
                                // dustProperties; without both, the softened
                                // contact is written as if it were real
    overlap         0.01;       // limit of overlap/diameter; default 0.01
    highestVelocity 20;         // [m/s] where it shall hold; default: fastest
    output          "constant/calibratedContact";   // default
    \endverbatim

    A point with e = 0 is one that sticks. It is not fitted, but its residual
    is given.

\*---------------------------------------------------------------------------*/

#include "calibrationFiles.H"
#include "caseInput.H"

#include "argList.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void addOptions()
{
    argList::addNote
    (
        "From measured restitutions of normal impacts to the damping coefficient,"
        " E^(-1/3) gamma^(5/6), and E_mod and gamma_mod for a limit of the"
        " overlap.\n\n"
        "Reads system/calibrateContactDict, e.g.\n"
        "    pair     dust.steel;  diameter 1.27e-6;  overlap 0.01;\n"
        "    points   ( (2.5 0.42) (5 0.71) (20 0.85) );    // m/s, -\n"
        "(all keywords: calibrateContact.C), writes constant/calibratedContact to"
        " #include at the end of constant/dustProperties, and"
        " postProcessing/calibrateContact/0/{fit,curve}.csv."
    );
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addBoolOption
    (
        "map",
        "Also write the restitution over alpha and 1/A* (map.csv)"
    );
}


//- What was found, on the screen
void print
(
    const calibrationSettings& s,
    const restitutionFit& fit
)
{
    Info<< nl << s.pair << ": "
        << (s.wall ? "sphere on a wall" : "two equal spheres") << ", diameter "
        << 2*s.radius << " m, density " << s.density << " kg/m3, " << s.model << nl
        << "    damping coefficient alpha         " << fit.alpha() << nl
        << "    plateau restitution               "
        << scaledCollision::plateauOf(fit.alpha()) << nl
        << "    E^(-1/3) gamma^(5/6)              " << fit.X()
        << " N^(1/2) m^(-1/6)" << nl
        << "    sticking speed                    "
        << fit.sticking() << " m/s" << nl;
}


//- How soft the contact may be made, said on the screen; chi: at most 1
scalar soften
(
    const calibrationSettings& s,
    const restitutionFit& fit,
    const scalar softE
)
{
    scalar chi = 1;
    Info<< nl << "    For an overlap of " << s.overlapLimit
        << " of the diameter at " << s.highestVelocity << " m/s:" << nl
        << "    E_mod                             " << softE << " Pa (effective)"
        << nl
        << "    gamma_mod                         " << fit.gamma(softE)
        << " J/m2 (one surface)" << nl;
    if (s.realE > 0)
    {
        chi = softE/s.realE;
        Info<< "    real E                            " << s.realE
            << " Pa (effective)" << nl
            << "    real gamma                        " << fit.gamma(s.realE) << " J/m2" << nl
            << "    chi = E_mod/E                     " << chi << nl;
        if (chi > 1)
        {
            chi = 1;
            Info<< "    WARNING: even the real material overlaps more than "
                << s.overlapLimit << " of the diameter: written with ratio 1" << nl;
        }
    }
    else
    {
        Info<< "    WARNING: without the real modulus (effectiveYoungsModulus, or"
            << " the materials in" << nl
            << "    constant/dustProperties) the softened contact is written as"
            << " if it were real:" << nl
            << "    rolling and sliding limits are then too weak" << nl;
    }
    return chi;
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
        caseInput::read("calibrateContactDict", runTime.system(), runTime)
    );
    const calibrationSettings settings(dict, runTime);
    const scaledCollision curve(settings.neck);
    const restitutionFit fit(dict, settings, curve);
    print(settings, fit);

    const calibrationFiles files
    (
        settings,
        curve,
        fit,
        runTime.globalPath()/"postProcessing"/"calibrateContact"/"0"
    );
    files.writeFit();
    files.writeCurve();

    const scalar softE = fit.softModulus();
    files.writeContact(softE, soften(settings, fit, softE));
    Info<< nl << "    written to " << settings.output << nl;

    if (args.found("map"))
    {
        Info<< "    map written to " << files.writeMap() << nl;
    }

    Info<< nl << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
