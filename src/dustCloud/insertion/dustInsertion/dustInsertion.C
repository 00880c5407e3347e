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
#include "dustCloudData.H"
#include "dustInsertion.H"
#include "dustPatchInjection.H"

#include "labelPair.H"
#include "SubList.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::DynamicList<Foam::dustInsertion::newcomer> Foam::dustInsertion::due
(
    const scalar now,
    const scalar dt
)
{
    DynamicList<newcomer> newcomers;

    forAll(injectors_, i)
    {
        dustPatchInjection& injector = *injectors_[i];

        while (injector.dueBefore(now + dt))
        {
            if (!injector.flows())
            {
                injector.passWithoutFlow();
                continue;
            }
            newcomer n = newcomer();
            n.injector = i;
            n.number = injector.next();
            n.delay = max(injector.due() - now, scalar(0));
            newcomers.append(n);
            injector.pass();
        }
    }

    std::stable_sort
    (
        newcomers.begin(),
        newcomers.end(),
        [](const newcomer& a, const newcomer& b) { return a.delay < b.delay; }
    );
    return newcomers;
}


void Foam::dustInsertion::draw(newcomer& n, const label attempt) const
{
    injectors_[n.injector]->draw(n.number, attempt, n.x, n.d, n.U);
}


Foam::List<Foam::labelPair> Foam::dustInsertion::ask
(
    const dem::Entrance& entrance,
    UList<newcomer>& newcomers
) const
{
    labelList answers(2*newcomers.size());

    forAll(newcomers, i)
    {
        newcomer& n = newcomers[i];
        std::string wall;
        const bool blocked =
            entrance.overlap(toVec3(n.x), 0.5*n.d, n.delay, wall) >= 0;

        n.celli = blocked ? -1 : mesh_.findCell(n.x);
        answers[2*i] = blocked;
        answers[2*i + 1] = n.celli >= 0 ? Pstream::myProcNo() : -1;
    }
    Pstream::listCombineGather(answers, maxEqOp<label>());
    Pstream::listCombineScatter(answers);

    List<labelPair> result(newcomers.size());
    forAll(result, i)
    {
        result[i] = labelPair(answers[2*i], answers[2*i + 1]);
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dustInsertion::check(const bool gasFrozen) const
{
    for (const dustPatchInjection* injector : injectors_)
    {
        injector->check(gasFrozen);
    }
}


void Foam::dustInsertion::newGas(const scalar now)
{
    for (dustPatchInjection* injector : injectors_)
    {
        if (injector->dueBefore(now))
        {
            injector->newGas();
        }
    }
}


Foam::scalar Foam::dustInsertion::stepLimit
(
    const scalar now,
    const scalar limit,
    const scalar maxCo
) const
{
    scalar least = limit;
    for (const dustPatchInjection* injector : injectors_)
    {
        if (injector->flows() && injector->has())
        {
            least = min
            (
                least,
                max(injector->due() - now, scalar(0))
              + maxCo/max(injector->crossing(), VSMALL)
            );
        }
    }
    return least;
}


Foam::DynamicList<Foam::dustInsertion::newcomer> Foam::dustInsertion::enter
(
    const dem::System& system,
    const dem::Periodic& periodic,
    const scalar now,
    const scalar dt
)
{
    DynamicList<newcomer> newcomers(due(now, dt));
    DynamicList<newcomer> entered;
    if (newcomers.empty())
    {
        return entered;
    }

    boundBox box;
    scalar largest = 0;
    scalar fastest = 0;
    for (newcomer& n : newcomers)
    {
        const dustPatchInjection& injector = *injectors_[n.injector];
        box.add(injector.bounds());
        largest = max(largest, 0.5*injector.largest());
        fastest = max(fastest, injector.fastest());
        draw(n, 0);
    }
    const dem::Box places{toVec3(box.min()), toVec3(box.max())};
    const dem::Entrance entrance(system.entrance(places, dt, largest, fastest));

    // The newcomers among themselves: every rank knows all
    static const std::vector<dem::Particle> nobody;
    static const dem::WallSearch noWalls{dem::Walls()};
    dem::Entrance among
    (
        nobody, noWalls, periodic, places, dt, largest, fastest
    );

    // Most find room at once: all are asked in one message
    const List<labelPair> first(ask(entrance, newcomers));

    forAll(newcomers, i)
    {
        newcomer& n = newcomers[i];
        labelPair answer = first[i];
        bool free = false;

        for (label attempt = 0; attempt < mostDraws && !free; ++attempt)
        {
            if (attempt)
            {
                injectors_[n.injector]->redraws();
                draw(n, attempt);
                SubList<newcomer> one(newcomers, 1, i);
                answer = ask(entrance, one)[0];
            }
            std::string wall;
            free =
                !answer.first()
             && answer.second() >= 0
             && among.overlap(toVec3(n.x), 0.5*n.d, n.delay, wall) < 0;
        }

        if (!free)
        {
            injectors_[n.injector]->leaveOut(n.number);
            continue;
        }
        if (answer.second() != Pstream::myProcNo())
        {
            n.celli = -1;
        }
        among.enter(toVec3(n.x), toVec3(n.U), 0.5*n.d, n.delay);
        injectors_[n.injector]->count();
        entered.append(n);
        entered.last().injector = indices_[n.injector];
    }
    return entered;
}


Foam::label Foam::dustInsertion::withoutRoom() const
{
    label n = 0;
    for (const dustPatchInjection* injector : injectors_)
    {
        n += injector->withoutRoom();
    }
    return n;
}


Foam::label Foam::dustInsertion::withoutFlow() const
{
    label n = 0;
    for (const dustPatchInjection* injector : injectors_)
    {
        n += injector->withoutFlow();
    }
    return n;
}


// ************************************************************************* //
