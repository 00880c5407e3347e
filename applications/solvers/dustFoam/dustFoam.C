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
    dustFoam

Description
    Adhesive dust in air ducts: incompressible gas, laminar or turbulent, and a
    cloud of particles whose contacts are resolved by an embedded DEM library.

    The gas is either frozen, i.e. taken as it is at the start time, or solved
    by PIMPLE. With two-way coupling it feels the particles by their momentum
    (momentumExchange.H) and by the void fraction alphac:

    \verbatim
        div(alphac U + (1 - alphac) Udust) = 0
        ddt(alphac U) + div(alphac U U) - div(alphac R)
            = -grad p + (force of the particles)/rho
    \endverbatim

    The pressure gradient acts on the gas in full and not on the particles
    (model B of Gidaspow, as in DPMFoam; OpenFOAM's dense drag laws and
    slipErgunWenYuDrag are made for it); p is kinematic and without the
    hydrostatic part. constant/fvOptions or system/fvOptions are used where the
    gas is solved.

Usage
    \b dustFoam [OPTIONS]

    Needs, besides a mesh and the usual dictionaries in system:
      - constant/dustProperties: see dustCloud.H and dustProperties.H
      - constant/transportProperties: transportModel, nu, and rhoInf (gas
        density, e.g. rhoInf [1 -3 0 0 0 0 0] 1.2;)
      - constant/turbulenceProperties
      - optional constant/g; without it there is no gravity
      - the fields U and, if the gas is solved, p in the start time

    With two-way coupling the gas's equation is solved again after the last
    corrector until it loses less than momentumTolerance (in PIMPLE, 1e-6) of
    the gas's momentum in a step.

    dustFoam -dry-run prints contacts, chi, the scene plan and a forecast of
    steps, memory and run time, and ends without a step.

    dustFoam -models prints the forces, dispersion and injection models,
    dustFoam -keywords [WORD] the keywords of constant/dustProperties, with
    units, defaults and what is allowed.

    -postProcess [-time RANGES] [-func NAME] runs function objects on what a run
    has written; tables go to postProcessing/<function object>/postProcess.

    Restart: startFrom latestTime. Exact with writeFormat binary or
    writePrecision 17. What is incomplete after a kill is passed over; SIGTERM,
    SIGINT, SIGHUP, SIGUSR1 and maxWallTime (controlDict) end the run after its
    step with all written and exit code 0: see dustTime.H.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "singlePhaseTransportModel.H"
#include "PhaseIncompressibleTurbulenceModel.H"
#include "pimpleControl.H"
#include "fvOptions.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "gaussGrad.H"
#include "linear.H"
#include "clockTime.H"
#include "dustCloud.H"
#include "dustKeywords.H"
#include "dustTime.H"
#include "gasKeywords.H"
#include "localIOdictionary.H"
#include "masterFirst.H"
#include "modelTable.H"
#include "resistedMomentum.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Adhesive dust in air ducts: gas flow, frozen or solved by PIMPLE, and"
        " particles that stick to walls and to each other.\n\n"
        "Reads constant/dustProperties (materials, contact laws, injection,"
        " forces), constant/transportProperties (nu, rhoInf), the fields U and"
        " p; prints a scene plan, progress and a closing balance; writes"
        " lagrangian/dust, depositedMass (kg/m2), postProcessing/contacts."
    );

    #include "options.H"
    if (modelTable::asked(argc, argv) || dustKeywords::asked(argc, argv))
    {
        return 0;
    }
    #include "postProcessing.H"
    #include "setRootCaseLists.H"

    Info<< "Create time" << nl << endl;
    dustTime runTime(args);

    #include "exactTime.H"
    #include "createNamedMesh.H"    // createMesh.H has a -dry-run of its own
    #include "createFields.H"
    #include "checkCase.H"

    if (dust.gasFrozen())
    {
        #include "dryRun.H"

        Info<< "Starting time loop, gas frozen" << nl << endl;

        while (runTime.run())
        {
            ++runTime;
            dust.evolve();
            runTime.write();
            runTime.stopIfAsked();
        }
    }
    else
    {
        #include "createGas.H"

        Info<< "Starting time loop" << nl << endl;

        while (runTime.run())
        {
            #include "readTimeControls.H"
            #include "CourantNo.H"
            #include "setDeltaT.H"

            ++runTime;

            Info<< "Time = " << runTime.timeName() << endl;

            // Particles first: the gas then feels what they took from it
            dust.evolve(gasSeconds);

            const clockTime gasClock;

            if (dust.twoWay())
            {
                alphaGas = alphac;
                alphacf = fvc::interpolate(alphaGas);
                dustPhi = fvc::flux(dust.volumeFlux());
            }
            alphaPhi = alphacf*phi;

            transport.correct();
            mu = rho*transport.nu();

            #include "faceForce.H"

            while (pimple.loop())
            {
                #include "UEqn.H"

                while (pimple.correct())
                {
                    #include "pEqn.H"
                }

                if (dust.twoWay() && pimple.finalIter())
                {
                    #include "keepMomentum.H"
                }

                if (pimple.turbCorr())
                {
                    turbulence->correct();
                }
            }

            if (dust.twoWay())
            {
                dust.receive(U.oldTime());
            }

            gasSeconds = gasClock.elapsedTime();
            runTime.write();
            runTime.stopIfAsked();
        }

        #include "momentumReport.H"
    }

    dust.summarise();

    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
