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

#include "runSummary.H"
#include "formatted.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "error.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::runSummary::printBalance(Ostream& os) const
{
    os  << nl
        << formatted("  %-28s %10s %14s", "Balance", "particles", "kg").c_str()
        << nl;
    for (const amount& a : balance)
    {
        os  << formatted("  %-28s %10d %14.6g", a.name.c_str(), a.count, a.mass)
                .c_str()
            << nl;
    }
}


void Foam::runSummary::printAggregates(Ostream& os) const
{
    os  << nl
        << formatted("  %-28s %10s %14s", "Aggregates", "number", "particles")
            .c_str()
        << nl;

    // 1, 2, 3, 4, 5-8, 9-16, ...
    const label largest = aggregates.empty() ? 0 : aggregates.rbegin()->first;
    for (label low = 1, high = 1; low <= largest;)
    {
        label number = 0;
        label members = 0;
        const auto end = aggregates.upper_bound(high);
        for (auto a = aggregates.lower_bound(low); a != end; ++a)
        {
            number += a->second;
            members += a->first*a->second;
        }
        if (number)
        {
            const std::string size
            (
                low == high
              ? formatted("of %d", low)
              : formatted("of %d to %d", low, high)
            );
            os  << formatted("  %-28s %10d %14d", size.c_str(), number, members)
                    .c_str()
                << nl;
        }
        low = high + 1;
        high = low <= 4 ? low : 2*(low - 1);
    }
}


void Foam::runSummary::printTimes(Ostream& os) const
{
    const auto line = [&](const std::string& name, const scalar s)
    {
        os  << formatted
            (
                "  %-28s %10.1f %13.1f%%",
                name.c_str(),
                s,
                100*s/std::max(seconds, VSMALL)
            ).c_str()
            << nl;
    };

    os  << nl
        << formatted("  %-28s %10s %14s", "Run time (master)", "s", "share")
            .c_str()
        << nl;
    scalar other = seconds;
    for (const duration& part : parts)
    {
        line(part.name, part.seconds);
        other -= part.seconds;
    }
    line("other", other);
    line("total", seconds);
}


void Foam::runSummary::printWork(Ostream& os) const
{
    const dem::StepReport& w = work;

    os  << nl << "  Work and error indicators of this run" << nl
        << formatted
        (
            "    particle steps %d (repeated %.3g), free flights %.3g of particles, "
            "%.3g of aggregates, contact steps %.3g, contact updates %.3g\n"
            "    touches %.3g, separations %.3g, sleeps %.3g, wakes %.3g\n"
            "    speed at touch %.3g m/s, standard deviation %.3g m/s\n",
            particleSteps, double(w.repeats), double(w.freeFlights),
            double(w.aggregateFlights), double(w.contactSteps),
            double(w.contactUpdates), double(w.touches), double(w.separations),
            double(w.sleeps), double(w.wakes), touchSpeed(),
            touchSpeedDeviation()
        ).c_str()
        << formatted
        (
            "    touches of walls by particles that follow the gas (tau_p v_n < r) "
            "%.3g\n"
            "    largest overlap/d %.3g, fewest steps per contact period %s, "
            "largest step/stability bound %.3g, energy removed by rest %.3g J\n",
            double(w.followerTouches), w.maxOverlapOverDiameter,
            w.minStepsPerContact < 1e100
          ? formatted("%.3g", w.minStepsPerContact).c_str()
          : "-",
            w.maxStepOverBound, double(w.energyRemovedByRest)
        ).c_str()
        << remarks.c_str();
    if (imbalance >= 0)
    {
        os  << formatted
            (
                "    momentum given by the gas and got by the particles differ "
                "by at most %.2g of what was exchanged in a gas step\n",
                imbalance
            ).c_str();
    }
    if (chiChanges)
    {
        os  << formatted
            (
                "    chi changed %d times, %.3g -> %.3g: %.10g contacts went on, "
                "%.10g of them as collisions; stored energy %+.3g J\n",
                chiChanges, firstChi, chi, double(changes.contacts),
                double(changes.similar), changes.normal + changes.springs
            ).c_str();
    }
    if (offMesh)
    {
        os  << "    centre outside the mesh after a particle step: " << offMesh
            << " times" << nl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::runSummary::touchSpeed() const
{
    return work.touchSpeed/std::max(double(work.touches), 1.0);
}


Foam::scalar Foam::runSummary::touchSpeedDeviation() const
{
    const scalar meanSquare =
        work.touchSpeedSquare/std::max(double(work.touches), 1.0);
    return std::sqrt(std::max(meanSquare - sqr(touchSpeed()), 0.0));
}


std::vector<Foam::runSummary::row> Foam::runSummary::rows() const
{
    std::vector<row> all;
    const auto add =
        [&](const std::string& name, const scalar value, const char* unit)
    {
        all.push_back({name, value, unit});
    };

    std::string whole;
    for (const amount& a : balance)
    {
        const auto start = a.name.find_first_not_of(' ');
        const bool part = start > 0;
        whole = part ? whole : a.name;
        const std::string name(part ? whole + a.name.substr(start - 1) : a.name);
        add(name, a.count, "particles");
        add(name + " mass", a.mass, "kg");
    }
    for (const auto& a : aggregates)
    {
        add("aggregates of " + std::to_string(a.first), a.second, "-");
    }
    for (const duration& part : parts)
    {
        add("time " + part.name, part.seconds, "s");
    }
    add("time total", seconds, "s");

    add("particle steps", particleSteps, "-");
    add("particle steps repeated", work.repeats, "-");
    add("free flights", work.freeFlights, "-");
    add("aggregate flights", work.aggregateFlights, "-");
    add("contact steps", work.contactSteps, "-");
    add("contact updates", work.contactUpdates, "-");
    add("touches", work.touches, "-");
    add("separations", work.separations, "-");
    add("sleeps", work.sleeps, "-");
    add("wakes", work.wakes, "-");
    add("speed at touch", touchSpeed(), "m/s");
    add("speed at touch deviation", touchSpeedDeviation(), "m/s");
    add("touches by followers", work.followerTouches, "-");
    add("largest overlap over diameter", work.maxOverlapOverDiameter, "-");
    if (work.minStepsPerContact < 1e100)
    {
        add("fewest steps per contact", work.minStepsPerContact, "-");
    }
    add("largest step over bound", work.maxStepOverBound, "-");
    add("energy removed by rest", work.energyRemovedByRest, "J");
    if (imbalance >= 0)
    {
        add("momentum imbalance", imbalance, "-");
    }
    add("centres outside mesh", offMesh, "-");
    if (smallestMargin < GREAT)
    {
        add("smallest margin", smallestMargin, "-");
    }
    add("gas steps below margin", marginSteps, "-");
    add("gas steps above overlap", overlapSteps, "-");
    add("chi", chi, "-");
    if (chiChanges)
    {
        add("chi at start", firstChi, "-");
        add("changes of chi", chiChanges, "-");
        add("contacts at changes of chi", changes.contacts, "-");
        add("collisions at changes of chi", changes.similar, "-");
        add("energy by changes of chi", changes.normal + changes.springs, "J");
        add("overlap misfit by changes of chi", changes.misfit, "-");
        add("woken by changes of chi", changes.woken, "-");
        add("new overlap by changes of chi", changes.newOverlap, "-");
    }
    add("balance closes", closes, "-");
    return all;
}


void Foam::runSummary::print(Ostream& os) const
{
    printBalance(os);
    printAggregates(os);
    printTimes(os);
    printWork(os);
}


std::string Foam::runSummary::energyText(const dem::EnergyLedger& e)
{
    return formatted
    (
        "    energy [J]: kinetic %.3g, stored by normal forces %.3g and springs "
        "%.3g, released %.3g, dashpots %.3g, yield %.3g, plastic %.3g, rest "
        "%.3g; work of the gas %.3g, spring gain %.3g, changes of chi %.3g; "
        "residual %.2g",
        double(e.kinetic), double(e.normal), double(e.springs),
        double(e.released), double(e.dashpots), double(e.yield),
        double(e.plastic), double(e.rest), double(e.gas),
        double(e.springGain), double(e.stiffening), e.residual()
    );
}


void Foam::runSummary::write(const fileName& file) const
{
    mkDir(file.path());
    OFstream os(file);
    os << "quantity,value,unit" << nl;
    for (const row& r : rows())
    {
        os  << formatted("%s,%.10g,%s", r.quantity.c_str(), r.value, r.unit.c_str())
                .c_str()
            << nl;
    }
    os.flush();
    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << file << ": is the disk full?"
            << exit(FatalError);
    }
}


// ************************************************************************* //
