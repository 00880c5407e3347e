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

#include "loadFiles.H"
#include "dustParcel.H"
#include "restartFiles.H"

#include "Cloud.H"
#include "IOField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Where each begins in dustParcel::load()
static const List<Tuple2<word, label>> scalars
({
    {"gasLoadSp", dustParcel::loadSp},
    {"gasLoadSpOmega", dustParcel::loadSpOmega},
    {"behind", dustParcel::loadBehind}
});
static const List<Tuple2<word, label>> vectors
({
    {"gasLoadUc", dustParcel::loadUc},
    {"gasLoadSu", dustParcel::loadSu},
    {"gasLoadOmegaC", dustParcel::loadOmegaC},
    {"gasKick", dustParcel::loadKick}
});


template<class Type>
static void writeOne
(
    const Cloud<dustParcel>& c,
    const Tuple2<word, label>& field
)
{
    IOField<Type> values
    (
        c.fieldIOobject(field.first(), IOobject::NO_READ),
        c.size()
    );
    label i = 0;
    for (const dustParcel& p : c)
    {
        for (direction k = 0; k < pTraits<Type>::nComponents; ++k)
        {
            setComponent(values[i], k) = p.load()[field.second() + k];
        }
        ++i;
    }
    values.write(c.size());
}


template<class Type>
static void readOne
(
    Cloud<dustParcel>& c,
    const Tuple2<word, label>& field
)
{
    restartFiles::checkOne(c, field.first(), true);
    const IOField<Type> values
    (
        c.fieldIOobject(field.first(), IOobject::READ_IF_PRESENT),
        c.size()
    );
    label i = 0;
    for (dustParcel& p : c)
    {
        for (direction k = 0; k < pTraits<Type>::nComponents; ++k)
        {
            p.load()[field.second() + k] = component(values[i], k);
        }
        p.loadHolds() = true;
        ++i;
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::loadFiles::write(const Cloud<dustParcel>& c)
{
    for (const auto& field : scalars)
    {
        writeOne<scalar>(c, field);
    }
    for (const auto& field : vectors)
    {
        writeOne<vector>(c, field);
    }
}


void Foam::loadFiles::read(Cloud<dustParcel>& c)
{
    for (const auto& field : scalars)
    {
        readOne<scalar>(c, field);
    }
    for (const auto& field : vectors)
    {
        readOne<vector>(c, field);
    }
}


// ************************************************************************* //
