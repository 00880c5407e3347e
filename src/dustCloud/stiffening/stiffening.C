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

#include "stiffening.H"
#include "awakeParcels.H"
#include "dustCloud.H"
#include "formatted.H"
#include "slipLoads.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::stiffening::takePlaces
(
    dustCloud& cloud,
    awakeParcels& parcels,
    const dem::System& system
)
{
    for (dustParcel& p : cloud)
    {
        const dem::Vec3& x = system.particle(std::size_t(p.demIndex())).x;
        p.setX(vector(x.x(), x.y(), x.z()));
    }

    // At rest, too, with the gas of its new place, as after a restart
    parcels.newGas();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::stiffening::stored
(
    const dictionary& output,
    const dustProperties& properties
)
{
    const dictionary* ledgerPtr = output.findDict("ledger");
    if (!ledgerPtr)
    {
        return -1;
    }
    if (!ledgerPtr->found("chi"))
    {
        if (properties.automaticRatio())
        {
            dustProperties::error
            (
                *ledgerPtr,
                "chi",
                "is missing: this time was written before chi was kept",
                "reducedStiffness/ratio with the chi that the log of that run"
                " prints, instead of auto"
            );
        }
        return -1;
    }
    return ledgerPtr->get<scalar>("chi");
}


bool Foam::stiffening::asBefore
(
    const dictionary& output,
    const dustProperties& properties
)
{
    const dictionary ledger(output.subOrEmptyDict("ledger"));
    return
        ledger.lookupOrDefault<string>("ratio", "") == properties.askedRatio();
}


void Foam::stiffening::store
(
    dictionary& ledger,
    const dustProperties& properties,
    const scalar chi
)
{
    ledger.set("ratio", properties.askedRatio());
    ledger.set("chi", chi);
}


Foam::scalar Foam::stiffening::choose
(
    const dustCloud& cloud,
    dustProperties& properties,
    dem::RatioAdvice& advice,
    autoPtr<slipLoads>& loads,
    dustSizes& sizes,
    const dem::Walls& walls,
    const dictionary& outputProperties
)
{
    sizes.addParticles(cloud);
    if (sizes.largest() > 0)
    {
        // the largest fits least
        dem::checkCurvature(walls, 0.5*sizes.largest(), -1);
    }
    loads.reset(new slipLoads(cloud, sizes));
    advice = dem::adviseRatio
    (
        properties.table(), loads->dusts(), walls, properties.limits()
    );

    const scalar before = stored(outputProperties, properties);
    scalar wanted =
        before > 0 && asBefore(outputProperties, properties) ? before
      : !properties.automaticRatio() ? properties.softening().ratio
      : sizes.largest() > 0 ? advice.chi
      : 1;
    const auto& limits = properties.limits();
    if (limits.stiffen && wanted < limits.ratio)
    {
        Info<< "chi " << wanted << " is raised to " << limits.ratio
            << ", the softest of reducedStiffness/limits/ratio: onViolation is"
            << " stiffen" << endl;
        wanted = limits.ratio;
    }
    properties.setRatio(before > 0 ? before : wanted);
    return wanted;
}


void Foam::stiffening::change
(
    dustCloud& cloud,
    awakeParcels& parcels,
    dem::System& system,
    const scalar chi,
    const std::string& reason,
    dem::EnergyLedger& energy
)
{
    const scalar before = system.materials().softening().ratio;
    const dem::Restiffened r = system.setRatio(chi);
    takePlaces(cloud, parcels, system);

    ++times_;
    done_.contacts += r.contacts;
    done_.similar += r.similar;
    done_.normal += r.normal;
    done_.springs += r.springs;
    done_.farthest = max(done_.farthest, r.farthest);
    done_.misfit = max(done_.misfit, r.misfit);
    done_.woken += r.woken;
    done_.add(r.newOverlap, r.newI, r.newJ);

    // of all ranks, where the ledger adds up theirs
    if (Pstream::master() && cloud.keepsEnergyLedger())
    {
        energy.normal += r.normal;
        energy.springs += r.springs;
        energy.stiffening += r.normal + r.springs;
    }

    Info<< formatted
        (
            "Time %s: chi %.3g -> %.3g, as %s: %.10g contacts go on, %.10g of "
            "them as collisions; stored energy %+.3g J, particles set aside "
            "by up to %.2g m, overlaps off by up to %.2g of themselves, %.10g "
            "woken by that",
            cloud.mesh().time().timeName().c_str(), before, chi, reason.c_str(),
            double(r.contacts), double(r.similar),
            r.normal + r.springs, r.farthest, r.misfit, double(r.woken)
        ).c_str() << endl;
    if (r.newOverlap > 0)
    {
        WarningInFunction
            << "Longer than it was, what held together meets others: the"
            << " deepest new overlap is " << r.newOverlap << " of a diameter,"
            << " of particle " << r.newI << " and "
            << (
                   r.newJ < 0 ? std::string("a wall")
                 : "particle " + std::to_string(r.newJ)
               ).c_str()
            << endl;
    }
}


void Foam::stiffening::raise
(
    dustCloud& cloud,
    awakeParcels& parcels,
    dem::System& system,
    const dustProperties::limitSettings& limits,
    scalar& margin,
    const scalar overlap,
    dem::EnergyLedger& energy
)
{
    if (!limits.stiffen)
    {
        return;
    }
    const scalar before = system.materials().softening().ratio;
    scalar chi = before;
    std::string reason;

    if (margin < limits.pullOffOverForce)
    {
        chi = max
        (
            chi,
            dem::stiffenedRatio(before, margin, limits.pullOffOverForce)
        );
        reason = formatted
        (
            "a bond holds %.3g times the force on what it carries, limit %.3g",
            margin,
            limits.pullOffOverForce
        );
    }
    if (overlap > limits.overlap)
    {
        // overlaps fall as pull-off forces grow
        chi = max(chi, dem::stiffenedRatio(before, limits.overlap, overlap));
        reason += formatted
        (
            "%san overlap is %.3g of a diameter, limit %.3g",
            reason.empty() ? "" : " and ",
            overlap,
            limits.overlap
        );
    }
    if (chi > before)
    {
        change(cloud, parcels, system, chi, reason, energy);
        margin *= std::pow(chi/before, 0.4);
    }
}


// ************************************************************************* //
