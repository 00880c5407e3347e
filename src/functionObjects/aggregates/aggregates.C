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

#include "aggregates.H"
#include "functionKeywords.H"
#include "dustCloud.H"
#include "dustSnapshot.H"
#include "addToRunTimeSelectionTable.H"

#include <map>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(aggregates, 0);
    addToRunTimeSelectionTable(functionObject, aggregates, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::aggregates::aggregates
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    file_
    (
        runTime,
        name,
        "aggregates",
        "time_s,size,count,radiusOfGyration_m,coordination"
    )
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::aggregates::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    functionKeywords::check(dict);
    cloudName_ = functionKeywords::cloud(dict, mesh_);
    return true;
}


bool Foam::functionObjects::aggregates::write()
{
    const dustSnapshot& state =
        mesh_.lookupObject<dustCloud>(cloudName_).snapshot();

    struct clusterData
    {
        label size = 0;
        scalar mass = 0;
        vector firstMoment = Zero;
        point origin = Zero;        // of the moments: its first particle
        label contacts = 0;
        scalar secondMoment = 0;
    };
    std::map<int64_t, clusterData> clusters;

    for (const auto& p : state.particles)
    {
        clusterData& c = clusters[p.cluster];
        if (!c.size)
        {
            c.origin = p.x;
        }
        const vector r = p.x - c.origin;
        ++c.size;
        c.mass += p.mass;
        c.firstMoment += p.mass*r;

        // 3/5 r^2: the sphere's own
        c.secondMoment += p.mass*(magSqr(r) + 0.6*sqr(0.5*p.d));
    }
    for (const auto& b : state.bonds)
    {
        if (b.j >= 0)
        {
            clusters[state.particles[std::size_t(b.i)].cluster].contacts += 2;
        }
    }

    struct sizeData
    {
        label count = 0;
        scalar radius = 0;
        scalar coordination = 0;
    };
    std::map<label, sizeData> sizes;

    for (const auto& entry : clusters)
    {
        const clusterData& c = entry.second;
        sizeData& s = sizes[c.size];
        ++s.count;
        s.radius += sqrt
        (
            max
            (
                scalar(0),
                c.secondMoment/c.mass - magSqr(c.firstMoment/c.mass)
            )
        );
        s.coordination += scalar(c.contacts)/c.size;
    }

    for (const auto& entry : sizes)
    {
        const sizeData& s = entry.second;
        file_.row
        (
            time_.value(),
            entry.first,
            s.count,
            s.radius/s.count,
            s.coordination/s.count
        );
    }

    return true;
}


// ************************************************************************* //
