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

// First: includes DEM.hpp
#include "dustProperties.H"

#include "injectorPast.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of all injectors that have been
static dictionary injectorsOf(const dictionary& properties)
{
    return properties.subOrEmptyDict("injectionModel");
}


//- When it was written [s]
static scalar ledgerTime(const dictionary& properties, const Time& time)
{
    return
        properties.subOrEmptyDict("ledger")
       .lookupOrDefault("time", time.value());
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::injectorPast::last(const dictionary& properties)
{
    const dictionary injectors(injectorsOf(properties));
    label last = injectors.size() - 1;
    for (const word& name : injectors.toc())
    {
        const dictionary injector(injectors.subOrEmptyDict(name));
        last = max(last, injector.lookupOrDefault<label>("key", -1));
    }
    return last;
}


Foam::label Foam::injectorPast::place
(
    const dictionary& properties,
    const word& name
)
{
    return injectorsOf(properties).toc().find(name);
}


void Foam::injectorPast::tellGone
(
    const dictionary& properties,
    const wordList& names,
    const Time& time
)
{
    const scalar written = ledgerTime(properties, time);

    const dictionary injectors(injectorsOf(properties));
    for (const word& name : injectors.toc())
    {
        const dictionary injector(injectors.subOrEmptyDict(name));
        const scalar then = injector.lookupOrDefault("time", written);
        if (!names.found(name) && same(then, written))
        {
            Info<< "Injector " << name << " is not there any more: "
                << injector.lookupOrDefault<label>("parcelsAddedTotal", 0)
                << " particles have come from it, no more will" << nl << endl;
        }
    }
}


bool Foam::injectorPast::same(const scalar a, const scalar b)
{
    return
        Time::timeName(a) == Time::timeName(b)
     || mag(a - b) <= 1e-12*max(mag(a), mag(b));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::injectorPast::injectorPast
(
    const dictionary& injector,
    const word& name,
    const word& type,
    const dictionary& properties,
    const Time& time
)
:
    known_(false),
    shift_(0)
{
    const dictionary past
    (
        injectorsOf(properties).subOrEmptyDict(name)
    );
    const word typeThen(past.lookupOrDefault<word>("type", type));
    if (typeThen != type)
    {
        dustProperties::error
        (
            injector,
            "type",
            "until time " + time.timeName() + " injector " + name
          + " was a " + typeThen + ", and its count and clock are of that",
            typeThen + ", or another name for an injector that is new"
        );
    }

    known_ =
        past.found("type")
     || past.found(type == "dustPatchInjection" ? "start" : "nInjections");
    if (!known_)
    {
        return;
    }

    const scalar now = time.value();
    const scalar written = ledgerTime(properties, time);
    const scalar then = past.lookupOrDefault("time", written);
    if (same(then, now))
    {
        return;
    }
    shift_ = now - then;
    const word thenName(Time::timeName(then));
    Info<< "Injector " << name << ": ";
    if (same(then, written))
    {
        Info<< "what was written at " << thenName << " s is now time "
            << time.timeName() << " s; injection goes on as it would have then";
    }
    else
    {
        Info<< "it was last there at " << thenName
            << " s; injection goes on from there at " << time.timeName()
            << " s";
    }
    Info<< nl << endl;
}


// ************************************************************************* //
