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

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dustCloud::particleStepLimit() const
{
    const demData& d = *dem_;
    const scalar maxCo = solution_.maxCo();
    const vector& g = d.gravity;
    scalar limit = GREAT;

    for (const std::size_t index : d.system->awake())
    {
        const dustParcel& p = d.parcels[index];
        if (p.state() == dustParcel::resting)
        {
            continue;
        }
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
        rate = max(rate, cellCrossing(mesh_, p.cell(), U_[p.cell()]));
        if (rate > VSMALL)
        {
            limit = min(limit, maxCo/rate);
        }

        // And fall, from rest
        if (g != vector::zero)
        {
            const scalar fall = cellCrossing(mesh_, p.cell(), g);
            limit = min(limit, sqrt(2*maxCo/max(fall, VSMALL)));
        }
    }

    return returnReduce(limit, minOp<scalar>());
}


Foam::scalar Foam::dustCloud::nextParticleStep(const scalar left) const
{
    const demData& d = *dem_;
    const scalar limit = d.insertion->stepLimit
    (
        d.now,
        particleStepLimit(),
        solution_.maxCo()
    );

    const scalar longest =
        solution_.dict().lookupOrDefault<scalar>("deltaTMax", GREAT);

    // The limit may differ in its last bits between decompositions

    if (gasFrozen_ && min(limit, longest) < GREAT)
    {
        // Whatever deltaT is, see particleStep
        int exponent;
        const scalar mantissa = std::frexp((1 + 1e-6)*limit, &exponent);
        const scalar even = std::ldexp(std::floor(0x1p10*mantissa), exponent - 10);
        return min(even, longest);
    }

    // Equal steps for what is left of the gas step, as few as the limit allows
    const scalar parts = std::ceil(left/min(limit, longest) - 1e-6);
    return left/max(scalar(1), parts);
}


// ************************************************************************* //
