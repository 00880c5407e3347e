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

// First: includes DEM.hpp
#include "dustProperties.H"

#include "dustKeywords.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

// Upper bounds of numbers are far above what is sensible: they keep what is
// computed from them from overflowing. What is sensible caseCheck.H says.

namespace Foam
{

//- Bounds of the DEM library's numbers; its words
static std::string allowedOf(const dem::PartKeyword& k)
{
    std::string allowed;
    for (const std::string& word : k.words)
    {
        allowed += (allowed.empty() ? "" : " ") + word;
    }
    return
        k.words.empty()
      ? ">=" + std::string(Foam::name(k.low)) + " <="
      + std::string(Foam::name(k.high))
      : allowed;
}


static std::string text(const double value)
{
    return Foam::name(value);
}


static std::string text(const bool value)
{
    return value ? "on" : "off";
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// path, models that read it, kind, unit, default, allowed, meaning

void Foam::dustKeywords::addCaseRows(std::vector<row>& t)
{
    // What the code has without a keyword
    const dem::RatioLimits limits;
    const dem::TimeSettings time;
    const dem::ReducedStiffness softening;

    const std::vector<row> rows
    ({
        {"materials", "", block, "-", "", "",
            "what particles and walls are made of, by names of your own"},
        {"materials/*", "", block, "-", "none", "", "one material"},
        {"materials/*/density", "", number, "kg/m3", "none: a wall",
            ">=1e-3 <=1e20", "of a material that particles are made of"},
        {"materials/*/youngsModulus", "", number, "Pa", "", ">=1 <=1e20",
            "of the real material, not softened"},
        {"materials/*/poissonRatio", "", number, "-", "", ">-1 <=0.5", "of it"},
        {"materials/*/surfaceEnergy", "", number, "J/m2", "",
            "0 >=1e-9 <=1e6", "of one surface: half the work of adhesion"},
        {"dustMaterial", "", name, "-", "the one with a density", "",
            "material of particles whose injector names none"},
        {"patchMaterials", "", block, "-", "none", "",
            "materials of the wall patches; mirrors (symmetry, empty) take none"},
        {"patchMaterials/*", "", name, "-", "none", "",
            "a material; the patch by its name or a pattern"},
        {"patchCurvature", "", block, "-", "none", "",
            "radii of curved wall patches"},
        {"patchCurvature/*", "", other, "m", "none",
            "R, (R1 R2), measured or flat",
            "of a cylinder, or both principal radii; negative: hollow"},
        {"reducedStiffness", "", block, "-", "none: the real stiffness", "",
            "particles softer than real, with the same sticking"},
        {"reducedStiffness/ratio", "", number, "-", text(softening.ratio),
            ">=1e-9 <=1 auto",
            "chi, modulus over the real one; auto: the softest within limits"},
        {"reducedStiffness/surfaceEnergy", "", name, "-",
            softening.scaleSurfaceEnergy ? "scaled" : "unchanged",
            "scaled unchanged", "scaled: with chi^(2/5), the same rebound"},
        {"reducedStiffness/resistance", "", name, "-",
            softening.scaleResistance ? "scaled" : "original",
            "original scaled", "to rolling and sliding"},
        {"reducedStiffness/limits", "", block, "-", "none: the defaults", "",
            "checked while running"},
        {"reducedStiffness/limits/pullOffOverForce", "", number, "-",
            text(limits.pullOffOverForce),
            ">=1e-9 <=1e12", "smallest pull-off force over the gas force"},
        {"reducedStiffness/limits/overlap", "", number, "-",
            text(limits.overlap),
            ">=1e-9 <=1", "largest overlap over the diameter"},
        {"reducedStiffness/limits/ratio", "", number, "-",
            text(limits.ratio),
            ">=1e-12 <=1", "smallest chi"},
        {"reducedStiffness/limits/loadFactor", "", number, "-",
            text(limits.loadFactor),
            ">=1 <=1e6",
            "what a bond carries over the force on one particle in the fastest"
            " gas of the start, for ratio auto"},
        {"reducedStiffness/limits/onViolation", "", name, "-", "warn",
            "warn stop stiffen", "of a limit; stiffen: raise chi, go on"},
        {"timeIntegration", "", block, "-", "none: the defaults", "",
            "of contacts"},
        {"timeIntegration/stepsPerContact", "", number, "-",
            text(time.stepsPerContact),
            ">=20 <=1e6", "contact steps per collision; 34 is usual, 136 fine"},
        {"timeIntegration/restTolerance", "", number, "-",
            text(time.restTolerance), ">=0 <=1e6",
            "factor of the criterion of rest; 0: nothing ever rests"},
        {"timeIntegration/islands", "", flag, "-", text(time.islands), "",
            "only what is in contact takes contact steps"},
        {"timeIntegration/energyLedger", "", flag, "-",
            text(time.energyLedger), "",
            "say where the energy of contacts goes"}
    });
    t.insert(t.end(), rows.begin(), rows.end());
}


void Foam::dustKeywords::addContactRows(std::vector<row>& t)
{
    t.push_back({"contact", "", block, "-", "", "", "what contacts do"});
    t.push_back
    ({
        "contact/*", "", block, "-", "none", "",
        "default, for all pairs of materials, or one as \"a.b\", merged over it"
    });
    t.push_back
    ({
        "contact/*/effectiveYoungsModulus", "", number, "Pa", "mixing rule",
        ">=1 <=1e20", "of a pair: 1/E = (1 - nu1^2)/E1 + (1 - nu2^2)/E2"
    });
    t.push_back
    ({
        "contact/*/surfaceEnergy", "", number, "J/m2", "geometric mean",
        "0 >=1e-9 <=1e6", "of one surface of a pair"
    });
    t.push_back
    ({
        "contact/*/calibratedRatio", "", number, "-", "none", ">=1e-9 <=1",
        "chi for which calibrateContact fitted it; said if the run has another"
    });

    std::string kind;
    for (const dem::PartEntry& part : dem::contactModelTable())
    {
        const std::string path = "contact/*/" + part.kind;
        if (part.kind != kind)
        {
            kind = part.kind;
            std::string models;
            for (const dem::PartEntry& p : dem::contactModelTable())
            {
                if (p.kind == kind)
                {
                    models += (models.empty() ? "" : " ") + p.model;
                }
            }
            t.push_back
            ({
                path, "", block, "-", "", kind == "normal" ? "" : "none",
                "part of the contact law"
            });
            t.push_back
            ({
                path + "/model", "", name, "-", "", models,
                "a law: src/DEM/contactModels/" + kind
            });
        }
        for (const dem::PartKeyword& k : part.keywords)
        {
            const std::string allowed = allowedOf(k);
            bool merged = false;
            for (row& r : t)
            {
                if
                (
                    r.path == path + '/' + k.name && r.allowed == allowed
                 && r.meaning == k.meaning
                )
                {
                    r.models += ' ' + part.model;
                    merged = true;
                }
            }
            if (!merged)
            {
                t.push_back
                ({
                    path + '/' + k.name, part.model,
                    k.words.empty() ? number : name,
                    k.unit, k.fallback, allowed, k.meaning
                });
            }
        }
    }
}


void Foam::dustKeywords::addCloudRows(std::vector<row>& t)
{
    const std::string schemes =
        "cell cellWall cellPatchConstrained cellPoint cellPointFace"
        " cellPointWallModified pointMVC";
    const std::vector<row> rows
    ({
        {"coupling", "", name, "-", "auto", "oneWay twoWay auto",
            "does the gas feel the particles"},
        {"gas", "", name, "-", "auto", "solved frozen auto",
            "frozen: U stays as it is at the start"},
        {"couplingMassLoading", "", number, "-", "0.02", ">=0 <=1e12",
            "dust over gas above which coupling auto is twoWay"},
        {"progressInterval", "", number, "s", "5", ">=0 <=1e9",
            "wall time between progress lines"},
        {"solution", "", block, "-", "none", "",
            "as of OpenFOAM's clouds"},
        {"solution/active", "", flag, "-", "", "", "on"},
        {"solution/transient", "", flag, "-", "", "", "yes"},
        {"solution/coupled", "", flag, "-", "", "",
            "OpenFOAM wants it, without effect: coupling decides"},
        {"solution/cellValueSourceCorrection", "", flag, "-", "", "",
            "OpenFOAM wants it: off"},
        {"solution/maxCo", "", number, "-", "0.3", ">=1e-3 <=1e12",
            "cell widths moved per particle step"},
        {"solution/deltaTMax", "", number, "s", "none", ">=1e-9 <=1e9",
            "longest particle step"},
        {"solution/resetSourcesOnStartup", "", flag, "-", "yes", "",
            "of OpenFOAM, without effect"},
        {"solution/sourceTerms", "", other, "-", "none", "{ ... }",
            "of OpenFOAM, without effect"},
        {"solution/interpolationSchemes", "", block, "-", "", "",
            "of gas fields at particles"},
        {"solution/interpolationSchemes/rho", "", name, "-", "", schemes,
            "of the gas density"},
        {"solution/interpolationSchemes/U", "", name, "-", "", schemes,
            "of the gas velocity"},
        {"solution/interpolationSchemes/mu", "", name, "-", "", schemes,
            "of the gas viscosity"},
        {"solution/interpolationSchemes/*", "", name, "-", "none", schemes,
            "of a field that a force reads"},
        {"solution/integrationSchemes", "", block, "-", "", "", "in time"},
        {"solution/integrationSchemes/U", "", name, "-", "",
            "Euler analytical", "OpenFOAM wants it; not used"},
        {"solution/integrationSchemes/*", "", name, "-", "none", "",
            "of a variable"},
        {"constantProperties", "", block, "-", "none", "",
            "of OpenFOAM's clouds"},
        {"constantProperties/rho0", "", number, "kg/m3",
            "density of the dust", ">0 <=1e20", "not another than this"},
        {"constantProperties/rhoMin", "", number, "kg/m3", "1e-15",
            ">0 <=1e20", "of OpenFOAM: gas density at least"},
        {"constantProperties/minParcelMass", "", number, "kg", "1e-15",
            ">=0 <=1e15", "of OpenFOAM, without effect"},
        {"constantProperties/parcelTypeId", "", integer, "-", "-1", "",
            "of OpenFOAM's files"},
        {"subModels", "", block, "-", "none", "",
            "as of OpenFOAM's clouds; which: dustFoam -models"},
        {"subModels/dispersionModel", "", name, "-", "", "",
            "turbulence that particles see; none"},
        {"subModels/patchInteractionModel", "", name, "-", "", "none",
            "contacts with walls are the DEM system's"},
        {"subModels/stochasticCollisionModel", "", name, "-", "", "none",
            "contacts of particles are the DEM system's"},
        {"subModels/surfaceFilmModel", "", name, "-", "", "none", "no films"},
        {"subModels/langevinDispersionRASCoeffs", "", block, "-", "none", "",
            "of that dispersion model"},
        {"subModels/langevinDispersionRASCoeffs/timeScale", "", number, "-",
            "0.3", ">=1e-6 <=1e6", "C of the time C k/epsilon"}
    });
    t.insert(t.end(), rows.begin(), rows.end());
}


void Foam::dustKeywords::addForceRows(std::vector<row>& t)
{
    const std::string f = "subModels/particleForces/*/";
    const std::string frame = "nonInertialFrame";
    const std::vector<row> rows
    ({
        {"subModels/particleForces", "", block, "-", "", "",
            "of gas and body on particles"},
        {"subModels/particleForces/*", "", model, "-", "none", "",
            "a force by its name"},
        {f + "lambda", "slipDrag slipErgunWenYuDrag thermophoresis", number,
            "m", "", "0 >=1e-15 <=1e3",
            "mean free path of the gas; 0: no slip"},
        {f + "A", "slipDrag slipErgunWenYuDrag", vector, "-",
            "(1.257 0.4 1.1)", ">=-1e6 <=1e6",
            "of the slip factor 1 + Kn (A1 + A2 exp(-A3/Kn))"},
        {f + "phi", "nonSphereDrag", number, "-", "", ">0 <=1", "sphericity"},
        {f + "alphac", "WenYuDrag ErgunWenYuDrag PlessisMasliyahDrag", name,
            "-", "alphac", "", "field of the void fraction"},
        {f + "U", "SaffmanMeiLiftForce pressureGradient virtualMass", name,
            "-", "U", "", "field of the gas velocity"},
        {f + "T", "brownianMotion", number, "K", "", ">=1e-3 <=1e6",
            "temperature; 293 is usual"},
        {f + "T", "thermophoresis", name, "-", "T", "",
            "field of the temperature [K]"},
        {f + "conductivityRatio", "thermophoresis", number, "-", "",
            ">=0 <=1e6", "of the gas over the dust"},
        {f + "Cvm", "virtualMass", number, "-", "0.5", ">=0 <=1e3",
            "added mass over that of the displaced gas"},
        {f + "HdotGradH", "paramagnetic", name, "-", "HdotGradH", "",
            "field of it [A2/m3]"},
        {f + "magneticSusceptibility", "paramagnetic", number, "-", "",
            ">=-1e6 <=1e6", "of the dust"},
        {f + "linearAcceleration", frame, name, "-", "linearAcceleration", "",
            "file in constant"},
        {f + "angularVelocity", frame, name, "-", "angularVelocity", "",
            "file in constant"},
        {f + "angularAcceleration", frame, name, "-", "angularAcceleration",
            "", "file in constant"},
        {f + "centreOfRotation", frame, name, "-", "centreOfRotation", "",
            "file in constant"}
    });
    t.insert(t.end(), rows.begin(), rows.end());
}


//- What all injectors read
void Foam::dustKeywords::addInjectionRows(std::vector<row>& t)
{
    const std::string i = "subModels/injectionModels/*/";
    const std::vector<row> rows
    ({
        {"subModels/injectionModels", "", block, "-", "", "",
            "what brings particles in, by names of your own"},
        {"subModels/injectionModels/*", "", block, "-", "none", "",
            "an injector"},
        {i + "type", "", name, "-", "", "", "which: dustFoam -models"},
        {i + "SOI", "", number, "s", "0", ">=-1e9 <=1e9",
            "start of injection"},
        {i + "massTotal", "", number, "kg", "0", "0",
            "without effect: a parcel is a particle, their number is given"},
        {i + "parcelBasisType", "", name, "-", "fixed", "fixed",
            "a parcel is a particle"},
        {i + "nParticle", "", number, "-", "1", "1", "a parcel is a particle"},
        {i + "minParticlesPerParcel", "", number, "-", "1", "1",
            "a parcel is a particle"},
        {i + "material", "", name, "-", "that of dustMaterial", "",
            "of materials, one with a density: what its particles are of"},
        {i + "injectorID", "", integer, "-", "-1", "", "of OpenFOAM's files"},
        {i + "active", "", flag, "-", "on", "", "of OpenFOAM"}
    });
    t.insert(t.end(), rows.begin(), rows.end());
}


//- What some injectors read
void Foam::dustKeywords::addInjectorRows(std::vector<row>& t)
{
    const std::string i = "subModels/injectionModels/*/";
    const std::string dust = "dustPatchInjection";
    const std::string nozzle = "coneNozzleInjection";
    const std::string table = "kinematicLookupTableInjection";
    const std::string cones = "coneInjection " + nozzle;
    const std::string rates = "patchInjection " + cones;
    const std::string places = "manualInjection fieldActivatedInjection";
    const std::string flow = "patchFlowRateInjection";
    const std::vector<row> rows
    ({
        {i + "patch", dust + " patchInjection " + flow, name, "-", "", "",
            "where they enter"},
        {i + "parcelsPerSecond", "patchInjection " + nozzle + ' ' + table,
            number, "1/s", "", ">=1e-9 <=1e15", "particles per second"},
        {i + "parcelsPerSecond", dust, number, "1/s", "none", ">=1e-9 <=1e15",
            "particles per second; or massFlowRate"},
        {i + "massFlowRate", dust, number, "kg/s", "none", ">=1e-30 <=1e6",
            "mass of particles per second; or parcelsPerSecond"},
        {i + "duration", dust, number, "s", "no end", ">=1e-15 <=1e15",
            "of injection"},
        {i + "duration", rates + ' ' + table + ' ' + flow, number, "s", "",
            ">=1e-15 <=1e15", "of injection"},
        {i + "parcelsTotal", dust, integer, "-", "no end",
            ">=1 <=2147483647", "particles in all"},
        {i + "seed", dust, integer, "-", "1", "", "of the random numbers"},
        {i + "U0", dust, vector, "m/s", "", ">=-1e6 <=1e6 gas",
            "velocity of what enters; gas: that of the gas on the patch"},
        {i + "U0", places + " patchInjection cellZoneInjection", vector, "m/s",
            "", ">=-1e6 <=1e6", "velocity of what enters"},
        {i + "flowRateProfile", dust + ' ' + rates, other, "-", "constant 1",
            "a function of time", "weight of the rate"},
        {i + "concentration", flow, other, "-", "", "a function of time",
            "volume of the particles over that of the gas that enters"},
        {i + "parcelConcentration", flow, number, "1/m3", "", ">0 <=1e30",
            "particles per volume of particles"},
        {i + "phi", flow, name, "-", "phi", "", "field of the flux"},
        {i + "rho", flow, name, "-", "rho", "", "field of the gas density"},
        {i + "cellZone", "cellZoneInjection", name, "-", "", "",
            "where they are put"},
        {i + "numberDensity", "cellZoneInjection", number, "1/m3", "",
            ">0 <=1e30", "particles per volume"},
        {i + "positionsFile", places, name, "-", "", "",
            "in constant, a vectorField"},
        {i + "ignoreOutOfBounds", "manualInjection", flag, "-", "off", "",
            "leave out positions outside the mesh"},
        {i + "inputFile", table, name, "-", "", "", "in constant, the rows"},
        {i + "randomise", table, flag, "-", "no", "", "no"},
        {i + "parcelsPerInjector", "fieldActivatedInjection", integer, "-",
            "", ">=1 <=1e9", "particles in all, for each position"},
        {i + "factor", "fieldActivatedInjection", number, "-", "",
            ">=-1e15 <=1e15", "of the reference field"},
        {i + "referenceField", "fieldActivatedInjection", name, "-", "", "",
            "injected where factor times it reaches the threshold"},
        {i + "thresholdField", "fieldActivatedInjection", name, "-", "", "",
            "the threshold"}
    });
    t.insert(t.end(), rows.begin(), rows.end());
}


void Foam::dustKeywords::addConeRows(std::vector<row>& t)
{
    const std::string i = "subModels/injectionModels/*/";
    const std::string nozzle = "coneNozzleInjection";
    const std::string cones = "coneInjection " + nozzle;
    const std::vector<row> rows
    ({
        {i + "position", nozzle, other, "m", "none", "a function of time",
            "or, but for injectionMethod movingPoint, a place (x y z)"},
        {i + "direction", nozzle, vector, "-", "", ">=-1e15 <=1e15",
            "axis of the cone"},
        {i + "injectionMethod", nozzle, name, "-", "", "point disc movingPoint",
            "where they enter"},
        {i + "flowType", nozzle, name, "-", "",
            "constantVelocity pressureDrivenVelocity flowRateAndDischarge",
            "what sets their velocity; flowRateAndDischarge is refused"},
        {i + "UMag", nozzle, number, "m/s", "none", ">=0 <=1e6",
            "speed, of flowType constantVelocity"},
        {i + "outerDiameter", nozzle, number, "m", "", ">=0 <=1e6",
            "of the disc"},
        {i + "innerDiameter", nozzle, number, "m", "", ">=0 <=1e6",
            "of the disc"},
        {i + "Cd", nozzle, other, "-", "none", "a function of time",
            "of flowType flowRateAndDischarge"},
        {i + "Pinj", nozzle, other, "Pa", "none", "a function of time",
            "of flowType pressureDrivenVelocity"},
        {i + "thetaInner", cones, other, "deg", "constant 0",
            "a function of time", "of the cone"},
        {i + "thetaOuter", cones, other, "deg", "", "a function of time",
            "of the cone"},
        {i + "positionAxis", "coneInjection", other, "m", "",
            "(((x y z) (nx ny nz)))", "place and axis"},
        {i + "parcelsPerInjector", "coneInjection", number, "-", "",
            ">=1 <=1e9", "particles in all, for each position"},
        {i + "Umag", "coneInjection", other, "m/s", "", "a function of time",
            "speed"}
    });
    t.insert(t.end(), rows.begin(), rows.end());
}


void Foam::dustKeywords::addSizeRows(std::vector<row>& t)
{
    const std::string s = "subModels/injectionModels/*/sizeDistribution";
    const std::string weibull = "RosinRammler massRosinRammler";
    const std::string lists = "multiNormal";
    const std::string bounded =
        "logNormal uniform normal exponential " + weibull + ' ' + lists;
    const std::vector<row> rows
    ({
        {s, "dustPatchInjection patchInjection patchFlowRateInjection "
            "cellZoneInjection manualInjection coneInjection "
            "coneNozzleInjection fieldActivatedInjection", block, "-", "", "",
            "of diameters"},
        {s, "kinematicLookupTableInjection", block, "-", "none", "",
            "of diameters, for the table of contacts only"},
        {s + "/type", "", name, "-", "",
            "fixedValue uniform logNormal normal exponential RosinRammler "
            "massRosinRammler multiNormal general binned",
            "by number; its numbers are in { } after <type>Distribution"},
        {s + "/*", "", block, "-", "none", "", "<type>Distribution"},
        {s + "/*/value", "fixedValue", number, "m", "", ">=1e-10 <=1",
            "diameter"},
        {s + "/*/minValue", bounded, number, "m", "", ">=1e-10 <=1",
            "smallest diameter"},
        {s + "/*/maxValue", bounded, number, "m", "", ">=1e-10 <=1",
            "largest diameter"},
        {s + "/*/median", "logNormal", number, "m", "", ">=1e-10 <=1",
            "half of the particles are smaller, without the bounds"},
        {s + "/*/geometricStandardDeviation", "logNormal", number, "-", "",
            ">1 <=1e3", "of the diameters"},
        {s + "/*/expectation", "normal", number, "m", "none", ">=0 <=1",
            "mean diameter, without the bounds"},
        {s + "/*/variance", "normal", number, "m", "none", ">=1e-12 <=1",
            "standard deviation, as OpenFOAM reads it"},
        {s + "/*/mu", "normal", number, "m", "none", ">=0 <=1",
            "expectation, as newer OpenFOAM calls it"},
        {s + "/*/sigma", "normal", number, "m", "none", ">=1e-12 <=1",
            "variance, as newer OpenFOAM calls it"},
        {s + "/*/lambda", "exponential", number, "1/m", "", ">0 <=1e15",
            "rate of the decay"},
        {s + "/*/d", weibull, number, "m", "none", ">=1e-10 <=1", "scale"},
        {s + "/*/lambda", weibull, number, "m", "none", ">=1e-10 <=1",
            "d, as newer OpenFOAM calls it"},
        {s + "/*/n", weibull, number, "-", "", ">=0.01 <=100", "exponent"},
        {s + "/*/expectation", lists, numbers, "m", "none", ">=0 <=1", "of each"},
        {s + "/*/variance", lists, numbers, "m", "none", ">=1e-12 <=1", "of each"},
        {s + "/*/strength", lists, numbers, "-", "none", "0 >=1e-6 <=1e6", "of each"},
        {s + "/*/mu", lists, numbers, "m", "none", ">=0 <=1", "expectation"},
        {s + "/*/sigma", lists, numbers, "m", "none", ">=1e-12 <=1", "variance"},
        {s + "/*/weight", lists, numbers, "-", "none", "0 >=1e-6 <=1e6", "strength"},
        {s + "/*/distribution", "general binned", other, "m", "",
            "((d weight) ...)", "diameters and their weights"},
        {s + "/*/cumulative", "general", name, "-", "off",
            "off no false", "of newer OpenFOAM"}
    });
    t.insert(t.end(), rows.begin(), rows.end());
}


void Foam::dustKeywords::addFunctionRows(std::vector<row>& t)
{
    const std::string f = "cloudFunctions/*/";
    const std::string collector = "particleCollector";
    const std::string planes = collector + " facePostProcessing";
    const std::string patches = "patchPostProcessing particleErosion";
    const std::string files = planes + " particleTracks";
    const std::string all =
        files + ' ' + patches
      + " particleTrap patchCollisionDensity voidFraction";
    const std::vector<row> rows
    ({
        {"cloudFunctions", "", block, "-", "none", "",
            "OpenFOAM's, by names of your own"},
        {"cloudFunctions/*", "", block, "-", "none", "", "one of them"},
        {f + "type", all, name, "-", "", "", "which"},
        {f + "surfaceFormat", planes, name, "-", "", "", "of files"},
        {f + "formatOptions", planes, other, "-", "none", "{ ... }",
            "of files"},
        {f + "resetOnWrite", files, flag, "-", "", "", "count from zero"},
        {f + "log", planes, flag, "-", "", "", "write to the log"},
        {f + "faceZones", "facePostProcessing", other, "-", "", "(...)",
            "where"},
        {f + "mode", collector, name, "-", "",
            "polygon polygonWithNormal concentricCircle", "shape"},
        {f + "parcelType", collector, integer, "-", "-1", "", "which"},
        {f + "removeCollected", collector, name, "-", "", "no off false",
            "take them out: the balance would not close"},
        {f + "negateParcelsOppositeNormal", collector, flag, "-", "", "",
            "count them back"},
        {f + "polygons", collector, other, "m", "none", "(...)", "shape"},
        {f + "normal", collector, vector, "-", "none", "", "of the shape"},
        {f + "origin", collector, other, "m", "none", "(...)", "of circles"},
        {f + "radius", collector, other, "m", "none", "(...)", "of circles"},
        {f + "nSector", collector, integer, "-", "none", ">=1 <=1e6",
            "of circles"},
        {f + "refDir", collector, vector, "-", "none", "", "of sectors"},
        {f + "trackInterval", "particleTracks", integer, "-", "", ">=1 <=1e9",
            "steps between points"},
        {f + "maxSamples", "particleTracks", integer, "-", "", ">=1 <=1e9",
            "points of each"},
        {f + "patches", patches, other, "-", "", "(...)", "which"},
        {f + "maxStoredParcels", "patchPostProcessing", number, "-", "",
            ">=1 <=1e9", "hits kept between writing"},
        {f + "fields", "patchPostProcessing", other, "-", "none", "(...)",
            "which"},
        {f + "p", "particleErosion", number, "Pa", "", ">0 <=1e20",
            "plastic flow stress"},
        {f + "psi", "particleErosion", number, "-", "2", ">0 <=1e6",
            "depth of contact over depth of cut"},
        {f + "K", "particleErosion", number, "-", "2", ">0 <=1e6",
            "normal over tangential force"},
        {f + "alpha", "particleTrap", name, "-", "alpha", "", "field"},
        {f + "threshold", "particleTrap", number, "-", "none",
            ">=-1e15 <=1e15", "of the field"},
        {f + "minSpeed", "patchCollisionDensity", number, "m/s", "-1",
            ">=-1 <=1e9", "of hits that count"}
    });
    t.insert(t.end(), rows.begin(), rows.end());
}


// ************************************************************************* //
