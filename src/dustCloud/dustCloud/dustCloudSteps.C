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
#include "brownianMotion.H"
#include "cellCrossing.H"
#include "dustPatchInjection.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dustCloud::particleStepLimit() const
{
    const demData& d = *dem_;
    const scalar maxCo = solution_.maxCo();
    scalar limit = solution_.dict().lookupOrDefault<scalar>("deltaTMax", GREAT);

    for (const dustParcel& p : *this)
    {
        if (d.brownian && p.state() <= dustParcel::airborne)
        {
            limit = min
            (
                limit,
                d.brownian->longestStep(p, tdPtr_(), U_[p.cell()], maxCo)
            );
            continue;
        }

        scalar rate = cellCrossing(mesh_, p.cell(), p.U());

        // A particle that follows the gas may be as fast as the gas is
        if (p.state() != dustParcel::resting)
        {
            rate = max(rate, cellCrossing(mesh_, p.cell(), U_[p.cell()]));
        }
        if (rate > VSMALL)
        {
            limit = min(limit, maxCo/rate);
        }
    }

    return returnReduce(limit, minOp<scalar>());
}


bool Foam::dustCloud::watched() const
{
    const Time& time = mesh_.time();
    const bool last =
        time.value() > time.endTime().value() - 0.5*time.deltaTValue();
    if (!gasFrozen_ || time.writeTime() || last)
    {
        return true;
    }
    if (particleProperties_.subOrEmptyDict("cloudFunctions").size())
    {
        return true;
    }
    for (const auto& injector : injectors_)
    {
        if
        (
            !isA<dustPatchInjection>(injector)
         && injector.modelType() != "none"
        )
        {
            return true;
        }
    }
    for (const entry& e : time.controlDict().subOrEmptyDict("functions"))
    {
        if
        (
            e.isDict()
         && e.dict().lookupOrDefault<word>("writeControl", "timeStep")
         != "writeTime"
        )
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::dustCloud::nextParticleStep
(
    const scalar left,
    const bool watched
) const
{
    const demData& d = *dem_;
    const scalar longest =
        solution_.dict().lookupOrDefault<scalar>("deltaTMax", GREAT);
    scalar limit = d.insertion->stepLimit
    (
        d.now,
        particleStepLimit(),
        solution_.maxCo()
    );

    // Equal steps for what is left, as few as the limit allows. The limit may
    // differ in its last bits between decompositions. In still gas deltaT is
    // all that there is to go by.
    if (!gasFrozen_ || limit > 10*mesh_.time().deltaTValue())
    {
        return left/max(scalar(1), std::ceil(left/limit - 1e-6));
    }

    // In frozen gas a step has the length that its particles want, wherever
    // gas steps end; in classes, for the sake of those last bits
    if (limit < longest)
    {
        limit = std::exp2(std::floor(32*std::log2(limit))/32);
    }
    if (limit < left*(1 - 1e-6))
    {
        return limit;
    }
    return watched ? left : 0;
}


// ************************************************************************* //
