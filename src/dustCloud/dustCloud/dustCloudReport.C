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

#include "dustCloudData.H"
#include "dragRange.H"
#include "patchCurvature.H"
#include "dustSnapshot.H"
#include "modelTable.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Text by printf's rules: tables need fixed widths
static std::string format(const char* text, ...)
{
    char buffer[512];
    va_list arguments;
    va_start(arguments, text);
    vsnprintf(buffer, sizeof(buffer), text, arguments);
    va_end(arguments);
    return buffer;
}


static std::string duration(const scalar seconds)
{
    return
        seconds < 100 ? format("%.0f s", seconds)
      : seconds < 6000 ? format("%.1f min", seconds/60)
      : format("%.1f h", seconds/3600);
}


static std::string energyText(const dem::EnergyLedger& e)
{
    return format
    (
        "    energy [J]: kinetic %.3g, stored by normal forces %.3g and springs "
        "%.3g, released %.3g, dashpots %.3g, yield %.3g, plastic %.3g, rest "
        "%.3g; work of the gas %.3g, spring gain %.3g; residual %.2g",
        e.kinetic, e.normal, e.springs, e.released, e.dashpots, e.yield,
        e.plastic, e.rest, e.gas, e.springGain, e.residual()
    );
}


//- Value below which a share of the sorted values lies
static scalar percentile(const std::vector<double>& sorted, const scalar share)
{
    const auto n = sorted.size();
    return sorted[std::min(n - 1, std::size_t(share*scalar(n)))];
}

//- A drag law that does not hold where the particles are now: which, and how
//  many of them. Empty if all is well. Collective.
static std::string denseDragRemark
(
    const dustCloud& cloud,
    const dictionary& forces
)
{
    const fvMesh& mesh = cloud.mesh();
    scalar largest = 0;
    for (const dustParcel& p : cloud)
    {
        largest = max(largest, p.d());
    }
    reduce(largest, maxOp<scalar>());

    const diffusiveSmoothing smoothing(mesh, 3*largest);
    cellShares place(mesh);
    cellShares::sums<scalar> volume(mesh);
    for (const dustParcel& p : cloud)
    {
        place.moveTo(p.x(), p.cell());
        place.add(volume, p.volume());
    }
    place.close(volume);
    const scalarField alpha(1 - smoothing(volume.cells/mesh.V()));

    for (const entry& e : forces)
    {
        const dragRange* range = dragRange::find(e.keyword());
        if (!range)
        {
            continue;
        }
        label n = 0;
        scalar lowest = 1;
        for (const dustParcel& p : cloud)
        {
            n += alpha[p.cell()] < range->minVoid;
            lowest = min(lowest, alpha[p.cell()]);
        }
        reduce(n, sumOp<label>());
        reduce(lowest, minOp<scalar>());
        if (n)
        {
            return dragRange::voidFractionRemark
            (
                e.keyword(), lowest, format("%d particles in dense places", n)
            );
        }
    }
    return "";
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::printMaterials() const
{
    demData& d = *dem_;
    const dem::MaterialTable& table = d.system->materials();
    const int dust = d.material;
    const scalar chi = table.softening().ratio;

    // Particles that are there count, too
    scalar smallest = d.diameters[0] > 0 ? d.diameters[0] : GREAT;
    scalar largest = d.diameters[2];
    scalar sum = 0;
    for (const dustParcel& p : *this)
    {
        smallest = min(smallest, p.d());
        largest = max(largest, p.d());
        sum += p.d();
    }
    reduce(smallest, minOp<scalar>());
    reduce(largest, maxOp<scalar>());
    reduce(sum, sumOp<scalar>());
    const label n = returnReduce(this->size(), sumOp<label>());
    const scalar mean =
        d.diameters[1] > 0 ? d.diameters[1] : n ? sum/n : scalar(0);

    if (largest <= 0)
    {
        Info<< nl << "Contacts: diameters are not known yet, no table" << endl;
        return;
    }
    d.diameters[0] = smallest;
    d.diameters[1] = mean;
    d.diameters[2] = largest;

    const scalar speed = max(d.gasSpeed, VSMALL);

    Info<< nl << format
        (
            "Contacts at %.3g m/s (the fastest gas), chi %.3g%s",
            speed,
            chi,
            d.properties.automaticRatio()
          ? " (auto: the softest that keeps to the limits)"
          : ""
        ).c_str() << nl << format
        (
            "  %-16s %9s %10s %10s %9s %9s %9s %9s %9s %9s %9s %9s",
            "pair", "d_m", "F_C_N", "F_C_real", "W_J/m2", "a0_m", "delta0_m",
            "deltaC_m", "lambda_T", "contact_s", "step_s", "stable_s"
        ).c_str() << nl;

    string advice;

    for (int i = 0; i < int(table.materials().size()); ++i)
    {
        // Wall materials: those of the patches, each curved one for itself
        struct partner
        {
            bool wall;
            std::string name;
            dem::WallCurvature curvature;
        };
        std::vector<partner> partners;
        if (i == dust)
        {
            partners.push_back({false, "", {}});
        }
        bool flat = false;
        for (const dem::WallPatch& patch : d.system->walls().patches)
        {
            if (patch.material == i && patch.curvature)
            {
                partners.push_back
                (
                    {true, "(" + patch.name + ")", *patch.curvature}
                );
            }
            else if (patch.material == i && !flat)
            {
                flat = true;
                partners.push_back({true, "(wall)", {}});
            }
        }

        for (const partner& other : partners)
        {
            const bool wall = other.wall;
            const word pair(table.pairName(dust, i) + other.name, false);
            const word normal
            (
                table.constants(dust, i).realGamma > 0
              ? table.settings(dust, i).normal.model
              : "Hertz"
            );
            scalar overlap = 0;
            scalar lowTabor = GREAT;
            scalar highTabor = 0;
            scalar holds = 1;   // of what a flat wall does

            for (const scalar diameter : {smallest, mean, largest})
            {
                const scalar mass =
                    density_*constant::mathematical::pi/6*pow3(diameter);
                const dem::ContactFigures f = table.figures
                (
                    dust,
                    i,
                    0.5*diameter,
                    wall ? -1 : 0.5*diameter,
                    mass,
                    wall ? 0 : mass,
                    speed,
                    other.curvature
                );

                Info<< format
                    (
                        "  %-16s %9.3g %10.3g %10.3g %9.3g %9.3g %9.3g %9.3g "
                        "%9.3g %9.3g %9.3g %9.3g",
                        pair.c_str(), diameter, f.pullOff, f.realPullOff,
                        2*table.constants(dust, i).realGamma, f.a0, f.delta0,
                        f.deltaC, f.tabor, f.impactTime,
                        f.period/d.properties.time().stepsPerContact,
                        f.stableStep
                    ).c_str() << nl;

                // Half a radius: far beyond every law here, and what wrong
                // units lead to
                const scalar largestOverlap =
                    max(f.delta0, f.impactOverlap)/diameter;
                if (largestOverlap > 0.25)
                {
                    dustProperties::error
                    (
                        particleProperties_.subDict("materials"),
                        table.materials()[std::size_t(i)].name,
                        format
                        (
                            "particles of %.3g m in contact %s overlap by "
                            "%.3g diameters (chi %.3g, effective Young's "
                            "modulus %.3g Pa): are the moduli in Pa, the "
                            "sizes in m?",
                            diameter,
                            pair.c_str(),
                            largestOverlap,
                            chi,
                            table.constants(dust, i).E
                        ),
                        "materials and reducedStiffness/ratio with less than "
                        "0.25 diameters"
                    );
                }
                holds = wall ? min(holds, f.R/(0.5*diameter)) : holds;
                overlap = max(overlap, f.impactOverlap/diameter);
                lowTabor = min(lowTabor, f.tabor);
                highTabor = max(highTabor, f.tabor);
            }

            const scalar overlapLimit = d.properties.limits().overlap;
            if (overlap > overlapLimit)
            {
                // overlaps grow as chi^(-2/5)
                const scalar wanted = chi*pow(overlap/overlapLimit, 2.5);
                advice += format
                (
                    "  Note: %s: an impact at %.3g m/s overlaps by %.2g of "
                    "d, limit %.2g; ",
                    pair.c_str(), speed, overlap, overlapLimit
                );
                advice +=
                    wanted <= 1
                  ? format("a chi of %.2g would keep it\n", wanted)
                  : format("even chi 1 would not: the material is too soft\n");
            }

            // Where each adhesive law holds
            const bool jkr = normal == "JKR" || normal == "simplifiedJKR";
            if ((jkr && lowTabor < 3) || (normal == "DMT" && highTabor > 0.1))
            {
                advice += format
                (
                    "  Warning: %s: %s with Tabor numbers of %.2g to %.2g; "
                    "JKR holds above 3, DMT below 0.1\n",
                    pair.c_str(), normal.c_str(), lowTabor, highTabor
                );
            }

            const scalar gamma = table.constants(dust, i).realGamma;
            if (gamma > 0)
            {
                const scalar softest = dem::softestRatioForMargin
                (
                    gamma*holds,
                    d.gasViscosity,
                    speed,
                    d.properties.limits().pullOffOverForce,
                    wall
                );
                advice += format
                (
                    "  %s: pull-off force %.3g times the drag of one particle "
                    "(Stokes, fastest gas) needs chi >= %.2g\n",
                    pair.c_str(),
                    d.properties.limits().pullOffOverForce,
                    softest
                );
            }
        }
    }

    if (chi < d.properties.limits().ratio)
    {
        advice += format
        (
            "  Warning: chi %.3g is below the limit %.3g\n",
            chi,
            d.properties.limits().ratio
        );
        d.ratioBelowLimit = true;
        if (d.properties.limits().stop)
        {
            dustProperties::error
            (
                particleProperties_.subDict("reducedStiffness"),
                "ratio",
                "is below limits/ratio, and onViolation is stop",
                ">= " + Foam::name(d.properties.limits().ratio)
            );
        }
    }
    Info<< advice.c_str() << endl;
}


void Foam::dustCloud::printPlan() const
{
    const demData& d = *dem_;
    const dem::MaterialTable& table = d.system->materials();

    Info<< "Scene plan" << nl;

    const auto line = []
    (
        const char* feature,
        const bool on,
        const std::string& reason
    )
    {
        Info<< format
            (
                "  %-18s %-4s %s", feature, on ? "on" : "off", reason.c_str()
            ).c_str() << nl;
    };

    // Of the pairs that can meet
    bool adhesion = false;
    std::map<std::string, bool> parts;
    std::map<std::string, std::string> models;

    for (int i = 0; i < int(table.materials().size()); ++i)
    {
        bool met = i == d.material;
        for (const dem::WallPatch& patch : d.system->walls().patches)
        {
            met = met || patch.material == i;
        }
        if (!met)
        {
            continue;
        }

        const dem::ContactSettings& s = table.settings(d.material, i);
        const auto note = [&]
        (
            const std::string& part,
            const dem::PartSettings& settings
        )
        {
            parts[part] = parts[part] || settings.model != "none";
            std::string& text = models[part];
            const std::string name =
                settings.model + " (" + table.pairName(d.material, i) + ")";
            text += (text.empty() ? "" : ", ") + name;
        };
        note("normal", s.normal);
        note("tangential", s.tangential);
        note("rolling", s.rolling);
        note("twisting", s.twisting);

        adhesion =
            adhesion
         || (
                s.normal.model != "Hertz"
             && table.constants(d.material, i).realGamma > 0
            );
    }
    const bool spin = parts["tangential"] || parts["rolling"] || parts["twisting"];
    const scalar chi = table.softening().ratio;
    const scalar gMag = mag(g_.value());
    const bool gravityForce =
        subModelProperties_.subDict("particleForces").found("gravity");

    line("adhesion", adhesion, models["normal"]);
    string curved;
    for (const dem::WallPatch& patch : d.system->walls().patches)
    {
        if (!patch.curvature || !(d.diameters[2] > 0))
        {
            continue;
        }
        const scalar r = 0.5*d.diameters[2];
        const scalar R = table.wallRadius
        (
            d.material, patch.material, *patch.curvature, r
        );
        curved += format
        (
            "%s%s: %s, R/r %.3g for the largest",
            curved.empty() ? "" : "; ",
            patch.name.c_str(),
            patchCurvature::described(*patch.curvature).c_str(),
            R/r
        );
    }
    line
    (
        "curved walls",
        !curved.empty(),
        curved.empty() ? "all walls are taken as flat" : curved
    );
    line("sliding", parts["tangential"], models["tangential"]);
    line("rolling", parts["rolling"], models["rolling"]);
    line("twisting", parts["twisting"], models["twisting"]);
    line
    (
        "spin",
        spin,
        spin ? "a part of the contact needs it"
             : "no part of the contact needs it"
    );
    line
    (
        "reduced stiffness",
        chi < 1,
        format
        (
            "chi %.3g, surface energy %s, resistance %s",
            chi,
            table.softening().scaleSurfaceEnergy ? "scaled" : "unchanged",
            table.softening().scaleResistance ? "scaled" : "original"
        )
    );
    line
    (
        "islands",
        d.properties.time().islands,
        d.properties.time().islands
      ? format
        (
            "contact steps only where there is contact, %.3g per period, "
            "at most %.2g of the stability bound",
            d.properties.time().stepsPerContact,
            d.properties.time().boundShare
        )
      : "all particles take the contact step of the stiffest contact"
    );
    line
    (
        "rest",
        d.properties.time().restTolerance > 0,
        format("restTolerance %.3g", d.properties.time().restTolerance)
    );
    {
        const dictionary& forces =
            subModelProperties_.subDict("particleForces");
        const wordList laws(modelTable::drags(forces));

        line
        (
            "drag",
            laws.size(),
            laws.empty()
          ? std::string("particleForces names no drag law: ballistic flight")
          : std::string(laws[0])
        );
        if (laws.size() && d.diameters[0] > 0)
        {
            const scalar air = 6.6e-8;      // 20 C, 1 atm
            const std::string remark = dragRange::slipRemark
            (
                laws[0],
                d.diameters[0],
                forces.subOrEmptyDict(laws[0])
               .lookupOrDefault<scalar>("lambda", air),
                format("the smallest particles, %.3g m,", d.diameters[0])
            );
            if (!remark.empty())
            {
                Info<< "  Warning: " << remark.c_str() << nl;
            }
        }
    }
    line("gas solved", !gasFrozen_, d.gasReason);
    line("two-way momentum", twoWay_, d.couplingReason);
    line
    (
        "void fraction",
        smoothingPtr_.valid(),
        (
            twoWay_ ? std::string("goes with two-way coupling")
          : denseDrag_ ? std::string("one-way: known to the drag only")
          : std::string("one-way, and no drag depends on it")
        )
      + (
            smoothingPtr_.valid()
          ? format(", spread over %.3g m", smoothingPtr_->width())
          : ""
        )
    );
    line
    (
        "gravity",
        gMag > 0 && gravityForce,
        gMag <= 0 ? "g is zero or not given"
      : gravityForce ? format("%.4g m/s2, with buoyancy", gMag)
      : format("g is %.4g m/s2, but particleForces has no gravity", gMag)
    );
    line
    (
        "dispersion",
        d.dispersion,
        "dispersionModel " + subModelProperties_.get<word>("dispersionModel")
      + (d.dispersion ? ": resting particles get a new load in each step" : "")
    );
    line
    (
        "Brownian motion",
        d.brownian,
        d.brownian
      ? std::string("in flight and in contact, not at rest")
      : "particleForces has no brownianMotion"
      + (
            d.diameters[0] > 0 && d.diameters[0] < 1e-6
          ? format
            (
                "; it matters below 1e-6 m, smallest d %.3g m",
                d.diameters[0]
            )
          : std::string()
        )
    );
    line
    (
        "parallel",
        Pstream::parRun(),
        format("%d ranks", Pstream::parRun() ? Pstream::nProcs() : 1)
    );
    Info<< endl;
}


void Foam::dustCloud::checkLimits()
{
    demData& d = *dem_;
    const dustProperties::limitSettings& limits = d.properties.limits();
    const Time& time = mesh_.time();
    string violation;

    // Margin

    const std::vector<double> margins(d.system->adhesionMargins());
    scalar smallest = GREAT;
    scalar median = GREAT;
    if (Pstream::master() && margins.size())
    {
        std::vector<double> sorted(margins);
        std::sort(sorted.begin(), sorted.end());
        smallest = sorted.front();
        median = percentile(sorted, 0.5);
    }
    Pstream::scatter(smallest);
    Pstream::scatter(median);
    d.smallestMargin = min(d.smallestMargin, smallest);
    d.medianMargin = median;

    if (smallest < limits.pullOffOverForce)
    {
        ++d.marginSteps;
        violation = format
        (
            "a bonded particle's pull-off force is %.3g times the force on "
            "what it carries, limit %.3g",
            smallest,
            limits.pullOffOverForce
        );
        if (!d.warnedMargin)
        {
            d.warnedMargin = true;
            WarningInFunction
                << "Time " << time.timeName() << ": " << violation.c_str()
                << ". Stiffer particles (reducedStiffness ratio) hold better."
                << " Said once; the summary counts." << endl;
        }
    }

    // Overlap

    const scalar overlap =
        returnReduce(d.gasStep.maxOverlapOverDiameter, maxOp<scalar>());

    if (overlap > limits.overlap)
    {
        ++d.overlapSteps;
        if (!d.warnedOverlap || limits.stop)
        {
            const string text = format
            (
                "largest overlap %.3g of a diameter, limit %.3g",
                overlap,
                limits.overlap
            );
            violation += (violation.empty() ? "" : "; ") + text;

            if (!d.warnedOverlap)
            {
                d.warnedOverlap = true;
                WarningInFunction
                    << "Time " << time.timeName() << ": " << text.c_str()
                    << ". Said once." << endl;
            }
        }
    }

    // Coupling

    if (!twoWay_ && d.coupling == "auto" && !d.warnedLoading)
    {
        const scalar loading =
            returnReduce(massInSystem(), sumOp<scalar>())
           /gSum(rho_.primitiveField()*mesh_.V().field());

        if (loading > d.massLoadingLimit)
        {
            d.warnedLoading = true;
            WarningInFunction
                << "Time " << time.timeName() << ": mass loading " << loading
                << " exceeds couplingMassLoading " << d.massLoadingLimit
                << ", but the run began one-way. Restart with coupling twoWay"
                << " and gas solved if it matters. Said once." << endl;
        }
    }

    if (limits.stop && !violation.empty())
    {
        // A restart from here with other settings must be possible
        const_cast<Time&>(time).writeNow();

        FatalErrorInFunction
            << "Time " << time.timeName() << ": " << violation.c_str()
            << ", and reducedStiffness/limits/onViolation is stop."
            << " The state has been written." << exit(FatalError);
    }
}


void Foam::dustCloud::printProgress()
{
    demData& d = *dem_;
    const Time& time = mesh_.time();

    // The clocks of the ranks differ: the master decides
    const scalar wall = d.running.seconds();
    bool due =
        wall - d.lastProgress > d.progressInterval || time.writeTime();
    Pstream::scatter(due);
    if (!due)
    {
        return;
    }
    d.lastProgress = wall;

    labelList counts(3, Zero);  // airborne, deposited, resting
    {
        const std::vector<dem::ClusterLabel> clusters(d.system->clusters());
        for (const dustParcel& p : *this)
        {
            ++counts[clusters[std::size_t(p.demIndex())].onWall ? 1 : 0];
            if (p.state() == dustParcel::resting)
            {
                ++counts[2];
            }
        }
    }
    label touching = 0;
    for (const dustParcel& p : *this)
    {
        touching += p.state() != dustParcel::airborne;
    }
    reduce(touching, sumOp<label>());
    Pstream::listCombineGather(counts, plusEqOp<label>());

    const scalar span = time.endTime().value() - d.startTime;
    const scalar done =
        span > 0 ? min(scalar(1), (time.value() - d.startTime)/span) : 1;

    Info<< format
        (
            "%s%s s (%.1f %%), left %s: airborne %d, deposited %d "
            "(in contact %d, resting %d), escaped %d",
            // a gas that is solved has its own lines
            gasFrozen_ ? "Time = " : "Dust at ",
            time.timeName().c_str(),
            100*done,
            done > 0 ? duration(wall*(1 - done)/done).c_str() : "?",
            counts[0], counts[1], touching, counts[2], escaped().count
        ).c_str();
    if (refused_.count)
    {
        Info<< ", refused " << refused_.count;
    }
    if (d.smallestMargin < GREAT)
    {
        Info<< format(", smallest margin %.3g", d.smallestMargin).c_str();
    }
    Info<< endl;
    if (keepsEnergyLedger() && time.writeTime())
    {
        Info<< energyText(energyLedger()).c_str() << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dustCloud::summarise()
{
    demData& d = *dem_;
    const dustSnapshot& state = snapshot();

    const label inCloud = returnReduce(this->size(), sumOp<label>());
    const label inSystem =
        returnReduce(label(d.system->size()), sumOp<label>());
    const tally out = escaped();

    dem::StepReport totals = d.totals;
    reduce(totals.maxOverlapOverDiameter, maxOp<scalar>());
    reduce(totals.minStepsPerContact, minOp<scalar>());
    reduce(totals.maxStepOverBound, maxOp<scalar>());
    reduce(totals.energyRemovedByRest, sumOp<scalar>());
    const auto sum = [](const scalar mine)
    {
        return returnReduce(mine, sumOp<scalar>());
    };
    const scalar contactSteps = sum(totals.contactSteps);
    const scalar contactUpdates = sum(totals.contactUpdates);
    const scalar freeFlights = sum(totals.freeFlights);
    const scalar touches = sum(totals.touches);
    const scalar touchSpeed = sum(totals.touchSpeed)/max(touches, 1.0);
    const scalar touchSpeedSquare = sum(totals.touchSpeedSquare)/max(touches, 1.0);
    const scalar followers = sum(totals.followerTouches);
    const scalar separations = sum(totals.separations);
    const scalar aggregateFlights = sum(totals.aggregateFlights);
    const scalar repeats = sum(totals.repeats);
    const scalar sleeps = sum(totals.sleeps);
    const scalar wakes = sum(totals.wakes);
    const label offMesh = returnReduce(d.offMesh, sumOp<label>());

    tally airborne, deposited;
    std::map<label, tally> patches;
    std::map<label, label> sizes;
    {
        std::map<int64_t, label> members;
        for (const auto& p : state.particles)
        {
            tally& where = p.patch < 0 ? airborne : deposited;
            ++where.count;
            where.mass += p.mass;
            if (p.patch >= 0)
            {
                ++patches[p.patch].count;
                patches[p.patch].mass += p.mass;
            }
            ++members[p.cluster];
        }
        for (const auto& m : members)
        {
            ++sizes[m.second];
        }
    }

    const auto row = [](const std::string& name, const tally& t)
    {
        Info<< format("  %-28s %10d %14.6g", name.c_str(), t.count, t.mass)
            .c_str() << nl;
    };

    Info<< nl << format("  %-28s %10s %14s", "Balance", "particles", "kg")
        .c_str() << nl;
    row("injected", injected_);
    row("airborne", airborne);
    row("deposited", deposited);
    for (const auto& p : patches)
    {
        row("  on " + mesh_.boundaryMesh()[p.first].name(), p.second);
    }
    row("escaped", out);
    forAll(escaped_, patchi)
    {
        if (escaped_[patchi].count)
        {
            row
            (
                "  through " + mesh_.boundaryMesh()[patchi].name(),
                escaped_[patchi]
            );
        }
    }
    for (const word& name : escapedBefore_.sortedToc())
    {
        row("  through " + name + ", now gone", escapedBefore_[name]);
    }
    row("refused at injection", refused_);

    // Aggregates: 1, 2, 3, 4, 5-8, 9-16, ...
    Info<< nl << format
        (
            "  %-28s %10s %14s", "Aggregates", "number", "particles"
        ).c_str() << nl;
    for (label low = 1, high = 1; !sizes.empty() && low <= sizes.rbegin()->first;)
    {
        label number = 0;
        label members = 0;
        for (auto s = sizes.lower_bound(low); s != sizes.upper_bound(high); ++s)
        {
            number += s->second;
            members += s->first*s->second;
        }
        if (number)
        {
            Info<< format
                (
                    "  %-28s %10d %14d",
                    (
                        low == high
                      ? format("of %d", low)
                      : format("of %d to %d", low, high)
                    ).c_str(),
                    number,
                    members
                ).c_str() << nl;
        }
        low = high + 1;
        high = low <= 4 ? low : 2*(low - 1);
    }

    const scalar total = d.running.seconds();
    const auto share = [total](const char* name, const scalar seconds)
    {
        Info<< format
            (
                "  %-28s %10.1f %13.1f%%",
                name,
                seconds,
                100*seconds/max(total, VSMALL)
            ).c_str() << nl;
    };
    const scalar contact = totals.secondsContact;
    const scalar search = totals.secondsSearch;
    const scalar flight = totals.secondsFlight;

    Info<< nl << format("  %-28s %10s %14s", "Run time (master)", "s", "share")
        .c_str() << nl;
    share("gas", d.gasSeconds);
    share("injection", d.injectionSeconds);
    share("gas forces", d.forceSeconds);
    share("DEM: contacts", contact);
    share("DEM: search", search);
    share("DEM: free flight", flight);
    share("DEM: exchange and waiting", d.demSeconds - contact - search - flight);
    share("tracking", d.trackSeconds);
    share("checks and progress", d.checkSeconds);
    share("writing", d.ioSeconds);
    share
    (
        "other",
        total - d.gasSeconds - d.injectionSeconds - d.forceSeconds
      - d.demSeconds - d.trackSeconds - d.checkSeconds - d.ioSeconds
    );
    share("total", total);

    Info<< nl << "  Work and error indicators of this run" << nl
        << format
        (
            "    particle steps %d (repeated %.3g), free flights %.3g of particles, "
            "%.3g of aggregates, contact steps %.3g, contact updates %.3g\n"
            "    touches %.3g, separations %.3g, sleeps %.3g, wakes %.3g\n"
            "    speed at touch %.3g m/s, standard deviation %.3g m/s\n"
            "    touches of walls by particles that follow the gas (tau_p v_n < r) "
            "%.3g\n"
            "    largest overlap/d %.3g, fewest steps per contact period %s, "
            "largest step/stability bound %.3g, energy removed by rest %.3g J\n",
            d.particleSteps, repeats, freeFlights, aggregateFlights, contactSteps,
            contactUpdates, touches, separations, sleeps, wakes, touchSpeed,
            std::sqrt(max(touchSpeedSquare - sqr(touchSpeed), 0.0)),
            followers,
            totals.maxOverlapOverDiameter,
            totals.minStepsPerContact < 1e100
          ? format("%.3g", totals.minStepsPerContact).c_str()
          : "-",
            totals.maxStepOverBound,
            totals.energyRemovedByRest
        ).c_str();
    if (keepsEnergyLedger())
    {
        Info<< energyText(energyLedger()).c_str() << nl;
    }
    const std::string dense
    (
        denseDragRemark(*this, subModelProperties_.subDict("particleForces"))
    );
    if (!dense.empty())
    {
        Info<< "    Warning: " << dense.c_str() << nl;
    }
    if (twoWay_)
    {
        Info<< format
            (
                "    momentum given by the gas and got by the particles differ "
                "by at most %.2g of what was exchanged in a gas step\n",
                exchangePtr_->imbalance()
            ).c_str();
    }
    if (offMesh)
    {
        Info<< "    centre outside the mesh after a particle step: "
            << offMesh << " times" << nl;
    }

    const bool closes =
        injected_.count == inCloud + out.count
     && inCloud == inSystem
     && (
            !Pstream::master()
         || airborne.count + deposited.count == inCloud
        );

    Info<< nl << "Verdict: ";
    if (closes)
    {
        Info<< "balance closes (" << injected_.count << " injected = "
            << airborne.count << " airborne + " << deposited.count
            << " deposited + " << out.count << " escaped)";
    }
    else
    {
        Info<< "BALANCE DOES NOT CLOSE";
    }
    if (!injected_.count && injectors_.size())
    {
        Info<< "; NOTHING WAS INJECTED";
    }
    Info<< leftOut().c_str();
    const bool within =
        !d.marginSteps && !d.overlapSteps && !d.ratioBelowLimit;
    if (within)
    {
        Info<< "; all limits kept";
    }
    else
    {
        Info<< "; limits exceeded: margin in " << d.marginSteps
            << " gas steps (smallest "
            << (
                   d.smallestMargin < GREAT
                 ? format("%.3g", d.smallestMargin)
                 : std::string("-")
               ).c_str()
            << "), overlap in " << d.overlapSteps << ", chi "
            << (d.ratioBelowLimit ? "below" : "within") << " its limit";
    }
    if (followers && !d.dispersion)
    {
        // Neither inertia nor a force: their radius, or an error of the gas
        // velocity at the walls
        Info<< "; " << label(followers) << " touches of walls by particles"
            << " that follow the gas (tau_p v_n < r): interception, or numerics"
            << " if it does not stay with a finer mesh";
    }
    Info<< nl << endl;

    if (!closes)
    {
        FatalErrorInFunction
            << "The particle balance does not close: injected "
            << injected_.count << ", in the cloud " << inCloud
            << ", in the DEM system " << inSystem << ", airborne "
            << airborne.count << ", deposited " << deposited.count
            << ", escaped " << out.count << exit(FatalError);
    }
}


// ************************************************************************* //
