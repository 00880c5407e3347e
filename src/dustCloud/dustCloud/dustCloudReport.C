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
#include "contactTable.H"
#include "dragRange.H"
#include "patchCurvature.H"
#include "dustSnapshot.H"
#include "formatted.H"
#include "modelTable.H"
#include "runSummary.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <algorithm>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static std::string duration(const scalar seconds)
{
    return
        seconds < 100 ? formatted("%.0f s", seconds)
      : seconds < 6000 ? formatted("%.1f min", seconds/60)
      : formatted("%.1f h", seconds/3600);
}


//- The material that has the largest particles
static const dustSizes::kind& withLargest(const dustSizes& sizes)
{
    return *std::max_element
    (
        sizes.kinds().begin(),
        sizes.kinds().end(),
        [](const dustSizes::kind& a, const dustSizes::kind& b)
        {
            return a.diameters[2] < b.diameters[2];
        }
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustCloud::printMaterials() const
{
    demData& d = *dem_;
    const dem::MaterialTable& table = d.system->materials();
    const scalar chi = table.softening().ratio;

    if (d.sizes.largest() <= 0)
    {
        Info<< nl << "Contacts: diameters are not known yet, no table; chi "
            << chi << endl;
        return;
    }

    const scalar speed = max(d.gasSpeed, VSMALL);
    const char* chosen =
        !d.properties.automaticRatio() ? ""
      : mag(chi - d.advice.chi) > 1e-9*chi ? " (auto: kept from the run before)"
      : d.advice.reached() ? " (auto: the softest that keeps to the limits)"
      : " (auto: no chi keeps to all limits)";

    Info<< nl << formatted
        (
            "Contacts at %.3g m/s (the fastest gas), chi %.3g%s",
            speed,
            chi,
            chosen
        ).c_str() << nl << formatted
        (
            "  %-16s %9s %10s %10s %9s %9s %9s %9s %9s %9s %9s %9s",
            "pair", "d_m", "F_C_N", "F_C_real", "W_J/m2", "a0_m", "delta0_m",
            "deltaC_m", "lambda_T", "contact_s", "step_s", "stable_s"
        ).c_str() << nl;

    contactTable
    (
        *d.system, d.properties, particleProperties_.subDict("materials"), speed
    ).print(d.sizes);

    printAdvice();
}


void Foam::dustCloud::printAdvice() const
{
    demData& d = *dem_;
    const scalar chi = d.system->materials().softening().ratio;

    string advice = formatted
    (
        "  Softest chi that each limit allows, for a slip of %.3g m/s "
        "(the fastest gas, or dust against it):\n",
        d.loads->slip()
    );
    advice += d.advice.text();
    if (!d.advice.find("pullOffOverForce"))
    {
        advice +=
            "    pullOffOverForce is not looked at here: nothing pulls at the "
            "start, or nothing adheres\n";
    }
    for (const dem::RatioNeed& need : d.advice.needs)
    {
        if (chi < need.chi*(1 - 1e-9) && need.chi <= 1)
        {
            advice += formatted
            (
                "  Note: chi %.3g is softer than the limit %s allows\n",
                chi,
                need.limit.c_str()
            );
        }
    }

    if (chi < d.properties.limits().ratio)
    {
        advice += formatted
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
        Info<< formatted
            (
                "  %-18s %-4s %s", feature, on ? "on" : "off", reason.c_str()
            ).c_str() << nl;
    };

    // Of the pairs that can meet
    bool adhesion = false;
    std::map<std::string, bool> parts;
    std::map<std::string, std::string> models;

    for (const labelPair& pair : d.sizes.meetings(d.system->walls()))
    {
        const int dust = int(pair.first());
        const int i = int(pair.second());
        const dem::ContactSettings& s = table.settings(dust, i);
        const auto note = [&]
        (
            const std::string& part,
            const dem::PartSettings& settings
        )
        {
            parts[part] = parts[part] || settings.model != "none";
            std::string& text = models[part];
            const std::string name =
                settings.model + " (" + table.pairName(dust, i) + ")";
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
             && table.constants(dust, i).realGamma > 0
            );
    }
    const bool spin = parts["tangential"] || parts["rolling"] || parts["twisting"];
    const scalar chi = table.softening().ratio;
    const scalar gMag = mag(g_.value());
    const bool gravityForce =
        subModelProperties_.subDict("particleForces").found("gravity");

    line("adhesion", adhesion, models["normal"]);
    string curved;
    const dustSizes::kind& largestKind = withLargest(d.sizes);
    for (const dem::WallPatch& patch : d.system->walls().patches)
    {
        if (!patch.curvature || !(largestKind.diameters[2] > 0))
        {
            continue;
        }
        const scalar r = 0.5*largestKind.diameters[2];
        const scalar R = table.wallRadius
        (
            int(largestKind.material), patch.material, *patch.curvature, r
        );
        curved += formatted
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
        formatted
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
      ? formatted
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
        formatted("restTolerance %.3g", d.properties.time().restTolerance)
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
        if (laws.size() && d.sizes.smallest() > 0)
        {
            const scalar air = 6.6e-8;      // 20 C, 1 atm
            const std::string remark = dragRange::slipRemark
            (
                laws[0],
                d.sizes.smallest(),
                forces.subOrEmptyDict(laws[0])
               .lookupOrDefault<scalar>("lambda", air),
                formatted("the smallest particles, %.3g m,", d.sizes.smallest())
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
          ? formatted(", spread over %.3g m", smoothingPtr_->width())
          : ""
        )
    );
    line
    (
        "gravity",
        gMag > 0 && gravityForce,
        gMag <= 0 ? "g is zero or not given"
      : gravityForce ? formatted("%.4g m/s2, with buoyancy", gMag)
      : formatted("g is %.4g m/s2, but particleForces has no gravity", gMag)
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
            d.sizes.smallest() > 0 && d.sizes.smallest() < 1e-6
          ? formatted
            (
                "; it matters below 1e-6 m, smallest d %.3g m",
                d.sizes.smallest()
            )
          : std::string()
        )
    );
    line
    (
        "parallel",
        Pstream::parRun(),
        formatted("%d ranks", Pstream::parRun() ? Pstream::nProcs() : 1)
    );
    Info<< endl;
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

    Info<< formatted
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
        Info<< formatted(", smallest margin %.3g", d.smallestMargin).c_str();
    }
    Info<< endl;
    if (keepsEnergyLedger() && time.writeTime())
    {
        Info<< runSummary::energyText(energyLedger()).c_str() << endl;
    }
}


// ************************************************************************* //
