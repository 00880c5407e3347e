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

#include "modelTable.H"

// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const std::vector<Foam::modelTable::row>& Foam::modelTable::rows()
{
    // What each injector of OpenFOAM wants, but what can only be this here
    static const std::string oneParticle =
        "SOI 0; massTotal 0; parcelBasisType fixed; nParticle 1;";
    static const std::string rates = " flowRateProfile constant 1;";
    static const std::string cone = rates + " thetaInner constant 0;";
    static const std::string decomposed = "its places depend on the ranks";

    // kind, name, works, remark, instead, defaults, schemes, needs, streams
    static const std::vector<row> table
    ({
        {
            drag, "slipDrag", true,
            "Schiller-Naumann with slip; for flying dust and single layers",
            "", "", "", {}, false
        },
        {
            drag, "slipErgunWenYuDrag", true,
            "ErgunWenYuDrag with slip; for cakes of fine dust",
            "", "", "", {}, false
        },
        {
            drag, "sphereDrag", true,
            "no slip: 13 % too strong at 1.3 um in air; slipDrag has it",
            "", "", "", {}, false
        },
        {
            drag, "nonSphereDrag", true,
            "no slip; `phi` is the sphericity; contacts are those of spheres",
            "", "", "", {}, false
        },
        {
            drag, "WenYuDrag", true,
            "no slip; void fraction 0.8 to 1",
            "", "alphac alphac;", "", {}, false
        },
        {
            drag, "ErgunWenYuDrag", true,
            "no slip; beds and what flies above them",
            "", "alphac alphac;", "", {}, false
        },
        {
            drag, "PlessisMasliyahDrag", true,
            "no slip; beds",
            "", "alphac alphac;", "", {}, false
        },
        {
            force, "gravity", true, "with buoyancy; g from constant/g",
            "", "", "", {}, false
        },
        {
            force, "SaffmanMeiLiftForce", true,
            "shear lift in flight, far from walls",
            "", "U U;", "curlUcDt cell;", {}, false
        },
        {
            force, "brownianMotion", true,
            "exact for any particle step; `T` [K]; drag of the case's law",
            "", "", "", {}, false
        },
        {
            force, "vorticityTorque", true,
            "the gas turns particles with half its vorticity; U cellWall",
            "", "", "", {}, false
        },
        {
            force, "wallShear", true,
            "drag 1.701, torque 0.944 and lift of what touches a wall",
            "", "", "", {}, false
        },
        {
            force, "thermophoresis", true,
            "reads the temperature T [K] from the start time; `lambda` and "
            "`conductivityRatio`, gas over dust",
            "", "", "", {{need::scalarField, "T", "T"}}, false
        },
        {
            force, "TomiyamaLift", false,
            "a law for bubbles that are deformed by surface tension",
            "SaffmanMeiLiftForce", "", "", {}, false
        },
        {
            force, "pressureGradient", true,
            "of the accelerated gas; about gas over dust density of the drag",
            "", "U U;", "DUcDt cell;", {}, false
        },
        {
            force, "virtualMass", true,
            "added mass in flight, besides pressureGradient; in contact it "
            "weighs nothing",
            "", "U U; Cvm 0.5;", "DUcDt cell;", {}, false
        },
        {
            force, "nonInertialFrame", true,
            "on the particles only: the gas must have been solved in the same "
            "frame. Reads linearAcceleration, angularVelocity, "
            "angularAcceleration, centreOfRotation from constant/, at least "
            "one of them",
            "", "linearAcceleration linearAcceleration; angularVelocity "
            "angularVelocity; angularAcceleration angularAcceleration; "
            "centreOfRotation centreOfRotation;", "",
            {{need::frame, "", ""}}, false
        },
        {
            force, "SRF", false,
            "dustFoam solves no gas in a rotating frame",
            "nonInertialFrame with constant/angularVelocity",
            "", "", {}, false
        },
        {
            force, "paramagnetic", true,
            "reads the field HdotGradH [A2/m3] from the start time",
            "", "HdotGradH HdotGradH;", "HdotGradH cell;",
            {{need::vectorField, "HdotGradH", "HdotGradH"}}, false
        },
        {
            force, "interface", false,
            "keeps particles at the surface of a liquid, and there is none",
            "surfaceEnergy and patchMaterials for what sticks to walls",
            "", "", {}, false
        },
        {dispersion, "none", true, "", "", "", "", {}, false},
        {
            dispersion, "langevinDispersionRAS", true,
            "normalised Langevin model; needs a RAS model of turbulence",
            "", "", "", {}, false
        },
        {
            dispersion, "stochasticDispersionRAS", true,
            "fluctuations are too weak, and zero where the particle step "
            "exceeds k/epsilon; langevinDispersionRAS is not",
            "", "", "", {}, false
        },
        {
            dispersion, "gradientDispersionRAS", true,
            "like stochasticDispersionRAS, along the gradient of k",
            "", "", "", {}, false
        },
        {
            injection, "dustPatchInjection", true,
            "numbered: the same particles on any number of ranks and after a "
            "restart; no overlaps",
            "", "", "", {{need::patch, "patch", ""}}, false
        },
        {injection, "none", true, "", "", "", "", {}, false},
        {
            injection, "manualInjection", true,
            "all at SOI, or at a later start, at the positions of a file",
            "", oneParticle, "", {}, false
        },
        {
            injection, "patchInjection", true,
            "what overlaps a wall or another particle is refused and counted",
            "dustPatchInjection", oneParticle + rates, "",
            {{need::patch, "patch", ""}}, true, decomposed
        },
        {
            injection, "patchFlowRateInjection", true,
            "its number is drawn by lot; what overlaps is refused and counted",
            "dustPatchInjection", oneParticle, "",
            {{need::patch, "patch", ""}}, true, decomposed
        },
        {
            injection, "cellZoneInjection", true,
            "all at SOI, or at a later start; what overlaps is refused and counted",
            "manualInjection", oneParticle, "",
            {{need::cellZone, "cellZone", ""}}, false, decomposed
        },
        {
            injection, "coneInjection", true,
            "from a point: Umag over the rate must exceed the diameter; "
            "parallel: one position per injector",
            "", oneParticle + cone, "", {}, true
        },
        {
            injection, "coneNozzleInjection", true,
            "as coneInjection, or from a disc; parcelsPerSecond is kept",
            "", oneParticle + cone, "", {}, true
        },
        {
            injection, "kinematicLookupTableInjection", true,
            "`rho` of each row must be that of the material; parcelsPerSecond is "
            "per row; randomise no",
            "", oneParticle + " randomise no;", "", {}, true
        },
        {
            injection, "fieldActivatedInjection", true,
            "reads both fields from the start time; no restart after it",
            "manualInjection", oneParticle, "",
            {
                {need::scalarField, "referenceField", ""},
                {need::scalarField, "thresholdField", ""}
            },
            false, "each looks for the cells of all"
        },
        {
            injection, "inflationInjection", false,
            "particles grow and are split, of which the DEM system knows "
            "nothing",
            "manualInjection or dustPatchInjection", "", "", {}, false
        },
        {
            injection, "injectedParticleInjection", false,
            "not tried with dustFoam: wants a cloud of "
            "extractEulerianParticles",
            "manualInjection", "", "", {}, false
        },
        {
            injection, "injectedParticleDistributionInjection", false,
            "not tried with dustFoam: wants a cloud of "
            "extractEulerianParticles",
            "dustPatchInjection", "", "", {}, false
        }
    });

    return table;
}


// ************************************************************************* //
