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
#include "formatted.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Value below which a share of the sorted values lies
static scalar percentile(const std::vector<double>& sorted, const scalar share)
{
    const auto n = sorted.size();
    return sorted[std::min(n - 1, std::size_t(share*scalar(n)))];
}


//- Smallest and median margin of all ranks, GREAT where nothing holds.
//  Collective.
static void findMargins
(
    const dem::System& system,
    scalar& smallest,
    scalar& median
)
{
    std::vector<double> margins(system.adhesionMargins());
    smallest = median = GREAT;
    if (Pstream::master() && margins.size())
    {
        std::sort(margins.begin(), margins.end());
        smallest = margins.front();
        median = percentile(margins, 0.5);
    }
    Pstream::scatter(smallest);
    Pstream::scatter(median);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::dustCloud::checkMargin(const scalar overlap)
{
    demData& d = *dem_;
    const dustProperties::limitSettings& limits = d.properties.limits();
    const Time& time = mesh_.time();
    string violation;

    // Margin: counted as it was; whether it is enough when chi is raised
    // decides

    scalar smallest = GREAT;
    findMargins(*d.system, smallest, d.medianMargin);
    d.smallestMargin = min(d.smallestMargin, smallest);
    if (smallest < limits.pullOffOverForce)
    {
        ++d.marginSteps;
    }
    d.changes.raise
    (
        *this, d.parcels, *d.system, limits, smallest, overlap, d.totals.energy
    );

    if (smallest < limits.pullOffOverForce)
    {
        violation = formatted
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
                << ". "
                << (
                       d.system->materials().softening().ratio < 1
                     ? "Stiffer particles (reducedStiffness ratio) hold better."
                     : "No chi reaches the limit: this is the real strength."
                   )
                << " Said once; the summary counts." << endl;
        }
    }
    return violation;
}


void Foam::dustCloud::checkLimits()
{
    demData& d = *dem_;
    const dustProperties::limitSettings& limits = d.properties.limits();
    const Time& time = mesh_.time();
    const scalar overlap =
        returnReduce(d.gasStep.maxOverlapOverDiameter, maxOp<scalar>());
    string violation(checkMargin(overlap));

    // Overlap: what has been, raised or not

    if (overlap > limits.overlap)
    {
        ++d.overlapSteps;
        if (!d.warnedOverlap || limits.stop)
        {
            const string text = formatted
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


// ************************************************************************* //
