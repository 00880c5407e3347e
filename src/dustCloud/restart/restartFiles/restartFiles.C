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
#include "restartFiles.H"
#include "dustParcel.H"

#include "Cloud.H"
#include "PstreamReduceOps.H"
#include "token.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Reads the first word of a file only
class firstToken
:
    public regIOobject
{
public:

    explicit firstToken(const IOobject& io)
    :
        regIOobject(io)
    {}

    label count(const bool valid)
    {
        const bool there = headerOk();
        Istream& is = readStream(word::null, valid && there);

        label n = -1;
        if (valid && there)
        {
            const token t(is);
            n = t.isLabel() ? t.labelToken() : -1;
            close();
        }
        return n;
    }

    virtual bool writeData(Ostream&) const
    {
        return false;
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::label Foam::restartFiles::count(const IOobject& io, const bool valid)
{
    return firstToken(io).count(valid);
}


bool Foam::restartFiles::checkOne
(
    const Cloud<dustParcel>& c,
    const word& name,
    const bool needed
)
{
    const label size = c.size();
    const IOobject io(c.fieldIOobject(name, IOobject::READ_IF_PRESENT));
    const label n = count(io, size);

    if (size && n != size && (needed || n >= 0))
    {
        FatalErrorInFunction
            << "The files of time " << c.time().timeName()
            << " do not belong together: " << io.objectPath();
        if (n < 0)
        {
            FatalError<< " is missing, empty or no field of OpenFOAM,";
        }
        else
        {
            FatalError<< " has " << n << " values";
        }
        FatalError
            << " for " << size << " particles" << nl
            << "    Restore it, or start from another time"
            << exit(FatalError);
    }
    return n >= 0;
}


void Foam::restartFiles::check
(
    const Cloud<dustParcel>& c,
    const wordList& names,
    const bool needed
)
{
    for (const word& name : names)
    {
        checkOne(c, name, needed);
    }
}


Foam::wordList Foam::restartFiles::stock()
{
    return
    {
        "origProcId", "origId", "active", "typeId", "nParticle", "d",
        "dTarget", "U", "rho", "age", "tTurb", "UTurb"
    };
}


Foam::wordList Foam::restartFiles::ours(const word& spin)
{
    return {spin, "x", "state", "owedImpulse", "material"};
}


Foam::word Foam::restartFiles::spin(const Cloud<dustParcel>& c)
{
    const auto found = [&c](const word& name)
    {
        const IOobject io(c.fieldIOobject(name, IOobject::READ_IF_PRESENT));
        return returnReduce(count(io, c.size()) >= 0, orOp<bool>());
    };

    const word now("angularVelocity");
    const word before("omega");
    return !found(now) && found(before) ? before : now;
}


// ************************************************************************* //
