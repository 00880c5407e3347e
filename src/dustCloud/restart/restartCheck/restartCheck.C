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
#include "masterFirst.H"
#include "restartCheck.H"

#include "DEM.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Faster than any dust, and slow enough for squares of it
static const scalar fastest = 1e5;

//- What spin gives the surface of dust is slower than this [m/s]
static const scalar fastestSurface = 1e3;

//- What gas does to dust takes longer than this [s]
static const scalar shortest = 1e-15;

//- Weight and forces beside drag accelerate dust by less than this [m/s2]
static const scalar steepest = 1e6;


// std::isfinite first: comparing what is not a number may trap

static bool within(const scalar v, const scalar low, const scalar high)
{
    return std::isfinite(v) && v >= low && v <= high;
}


static bool within(const vector& v, const scalar high)
{
    return
        within(v.x(), -high, high)
     && within(v.y(), -high, high)
     && within(v.z(), -high, high);
}


static string text(const scalar v)
{
    return std::isfinite(v) ? string(Foam::name(v)) : string("not finite");
}


static string text(const vector& v)
{
    return "(" + text(v.x()) + " " + text(v.y()) + " " + text(v.z()) + ")";
}


//- Numbers of all ranks in a row, on the master
static scalarList gathered(const UList<scalar>& mine)
{
    List<scalarList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = mine;
    Pstream::gatherList(all);

    scalarList result;
    if (Pstream::master())
    {
        for (const scalarList& part : all)
        {
            result.append(part);
        }
    }
    return result;
}


static string nameOf(const scalar id)
{
    const int64_t stride = int64_t(1) << 31;
    return Foam::name(label(int64_t(id)/stride)) + ":"
        + Foam::name(label(int64_t(id)%stride));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::restartCheck::error
(
    const word& field,
    const label i,
    const dustParcel& p,
    const string& reason,
    const string& allowed
) const
{
    FatalErrorInFunction
        << cloud_.fieldIOobject(field, IOobject::NO_READ).objectPath()
        << ": particle " << i << " (identityProc:identity "
        << p.origProc() << ':' << p.origId() << "): " << reason.c_str() << nl
        << "    allowed: " << allowed.c_str() << nl
        << "    Restore it, or start from another time" << exit(FatalError);
}


void Foam::restartCheck::fixedValues(const label i, const dustParcel& p) const
{
    const scalar largest = cloud_.pMesh().bounds().mag();

    if (ours_ && p.origProc() < 0)
    {
        error("identityProc", i, p, Foam::name(p.origProc()), ">= 0");
    }
    if (ours_ && p.origId() < 0)
    {
        error("identity", i, p, Foam::name(p.origId()), ">= 0");
    }
    if (!p.active())
    {
        error("active", i, p, "0", "1: every particle moves");
    }
    if (!within(p.nParticle(), 1 - 1e-9, 1 + 1e-9))
    {
        error
        (
            "nParticle",
            i,
            p,
            text(p.nParticle()),
            "1: each parcel is one particle"
        );
    }
    if (!within(p.d(), 1e-12, largest))
    {
        error
        (
            "d",
            i,
            p,
            text(p.d()) + " m",
            "above 1e-12 m, below the size of the mesh"
        );
    }
    if (!within(p.dTarget(), 0, largest))
    {
        error("dTarget", i, p, text(p.dTarget()) + " m", ">= 0 m");
    }
    const scalar density = ours_ ? properties_.density(p.material()) : 0;
    if (ours_ && !within(p.rho(), (1 - 1e-6)*density, (1 + 1e-6)*density))
    {
        error
        (
            "rho",
            i,
            p,
            text(p.rho()) + " kg/m3",
            text(density) + " kg/m3, the density of its material "
          + properties_.name(p.material()) + " in " + cloud_.name()
          + "Properties"
        );
    }
}


void Foam::restartCheck::motion(const label i, const dustParcel& p) const
{
    const auto vectorField = [&]
    (
        const word& field,
        const vector& v,
        const scalar most,
        const char* unit
    )
    {
        if (!within(v, most))
        {
            error
            (
                field,
                i,
                p,
                text(v) + unit,
                "finite, each below " + text(most) + unit
            );
        }
    };
    vectorField("U", p.U(), fastest, " m/s");
    vectorField("UTurb", p.UTurb(), fastest, " m/s");
    vectorField("angularVelocity", p.omega(), 2*fastestSurface/p.d(), " rad/s");
    vectorField("x", p.x(), 1e10, " m");
    vectorField("owedImpulse", p.owed(), 1, " N s");

    if (!within(p.age(), -1e-9, 1e15))
    {
        error("age", i, p, text(p.age()) + " s", ">= 0 s");
    }
    if (!within(p.tTurb(), -1e15, 1e15))
    {
        error("tTurb", i, p, text(p.tTurb()) + " s", "finite");
    }
    if (p.state() < dustParcel::airborne || p.state() > dustParcel::resting)
    {
        error
        (
            "state",
            i,
            p,
            Foam::name(p.state()),
            "0 (airborne), 1 (in contact), 2 (at rest)"
        );
    }
}


void Foam::restartCheck::loads(const label i, const dustParcel& p) const
{
    const auto& load = p.load();
    const auto check = [&]
    (
        const char* field,
        const label first,
        const label n,
        const scalar least,
        const scalar most,
        const char* unit
    )
    {
        for (label k = first; k < first + n; ++k)
        {
            if (!within(load[k], least, most))
            {
                error
                (
                    field,
                    i,
                    p,
                    text(load[k]) + unit,
                    text(least) + " to " + text(most) + unit
                );
            }
        }
    };
    const scalar m = p.mass();
    const scalar inertia = m*sqr(p.d());
    const scalar spin = 2*fastestSurface/p.d();
    const scalar gas = max(scalar(1e3), 10*gasSpeed_);

    typedef dustParcel dust;
    check("gasLoadSp", dust::loadSp, 1, 0, m/shortest, " kg/s");
    check
    (
        "gasLoadSpOmega",
        dust::loadSpOmega,
        1,
        0,
        inertia/shortest,
        " N m s"
    );
    check("gasLoadUc", dust::loadUc, 3, -gas, gas, " m/s");
    const scalar force = load[dust::loadSp]*gas + m*steepest;
    check("gasLoadSu", dust::loadSu, 3, -force, force, " N");
    check("gasLoadOmegaC", dust::loadOmegaC, 3, -spin, spin, " rad/s");
    check("gasKick", dust::loadKick, 3, -gas, gas, " m/s");
    const scalar age = (1 + 1e-9)*max(p.age(), scalar(0));
    check("behind", dust::loadBehind, 1, 0, age, " s");
}


void Foam::restartCheck::contacts(const label i, const dustParcel& p) const
{
    const char* fault = dem::PackedState::fault
    (
        std::vector<double>(p.blob().begin(), p.blob().end()),
        p.id(),
        int(nWalls_)
    );
    if (*fault)
    {
        error
        (
            "contacts",
            i,
            p,
            string("of this, rest* and contact*: ") + fault,
            "what a run of dustFoam has written"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::restartCheck::values() const
{
    label i = 0;
    for (const dustParcel& p : cloud_)
    {
        fixedValues(i, p);
        motion(i, p);
        if (p.loadHolds())
        {
            loads(i, p);
        }
        contacts(i, p);
        ++i;
    }
}


void Foam::restartCheck::identities() const
{
    typedef dem::PackedState packed;

    // Ids are below 2^53: exact as scalars
    DynamicList<scalar> ids(cloud_.size());
    DynamicList<scalar> asked;
    for (const dustParcel& p : cloud_)
    {
        ids.append(scalar(p.id()));

        const scalarField& blob = p.blob();
        for
        (
            label k = label(packed::restNumbers);
            k < blob.size();
            k += label(packed::contactNumbers)
        )
        {
            if (blob[k + label(packed::partner)] >= 0)
            {
                asked.append(scalar(p.id()));
                asked.append(blob[k + label(packed::partner)]);
            }
        }
    }
    const scalarList all(gathered(ids));
    const scalarList partners(gathered(asked));
    const fileName path =
        cloud_.time().timeName()/cloud::prefix/cloud_.name();

    std::unordered_set<int64_t> known;
    for (const scalar id : all)
    {
        if (!known.insert(int64_t(id)).second)
        {
            FatalErrorInFunction
                << path.c_str() << "/identity: two particles are "
                << nameOf(id).c_str() << " (identityProc:identity)" << nl
                << "    Restore it, or start from another time"
                << exit(FatalError);
        }
    }
    for (label i = 0; i < partners.size(); i += 2)
    {
        if (!known.count(int64_t(partners[i + 1])))
        {
            FatalErrorInFunction
                << path.c_str() << "/contact*Id: particle "
                << nameOf(partners[i]).c_str() << " touches particle "
                << nameOf(partners[i + 1]).c_str()
                << " (identityProc:identity), which there is not" << nl
                << "    Restore it, or start from another time"
                << exit(FatalError);
        }
    }
}


void Foam::restartCheck::mass(const scalar expected, const scalar ofAll) const
{
    scalar there = 0;
    for (const dustParcel& p : cloud_)
    {
        there += p.mass();
    }
    reduce(there, sumOp<scalar>());

    // A tool may have rounded d to 6 digits
    if (mag(there - expected) > 1e-4*ofAll)
    {
        masterFirst();
        FatalErrorInFunction
            << "The files of time " << cloud_.time().timeName()
            << " do not belong together: the ledger in uniform/lagrangian/"
            << cloud_.name() << " tells of " << expected << " kg, but the"
            << " particles in lagrangian/" << cloud_.name() << " have "
            << there << " kg" << nl
            << "    Restore d and the ledger, or start from another time"
            << exit(FatalError);
    }
}


void Foam::restartCheck::places() const
{
    DynamicList<scalar> mine;
    for (const dustParcel& p : cloud_)
    {
        mine.append(scalar(p.id()));
        mine.append(p.d());
        mine.append(p.x().x());
        mine.append(p.x().y());
        mine.append(p.x().z());
    }
    const scalarList all(gathered(mine));
    const label n = all.size()/5;
    if (!n)
    {
        return;
    }

    // The largest first: each that follows is the smaller one of a pair
    labelList order(n);
    std::iota(order.begin(), order.end(), 0);
    std::sort
    (
        order.begin(),
        order.end(),
        [&all](const label a, const label b)
        {
            return all[5*a + 1] > all[5*b + 1];
        }
    );
    const auto place = [&all](const label i)
    {
        return point(all[5*i + 2], all[5*i + 3], all[5*i + 4]);
    };
    const scalar width = 0.5*all[5*order[0] + 1];
    const auto key = [width](const point& x, label di, label dj, label dk)
    {
        return
            int64_t(std::floor(x.x()/width) + di)*73856093
          ^ int64_t(std::floor(x.y()/width) + dj)*19349663
          ^ int64_t(std::floor(x.z()/width) + dk)*83492791;
    };

    std::unordered_multimap<int64_t, label> grid;
    for (const label i : order)
    {
        const point x(place(i));
        for (label c = 0; c < 27; ++c)
        {
            const auto range =
                grid.equal_range(key(x, c%3 - 1, c/3%3 - 1, c/9 - 1));
            for (auto j = range.first; j != range.second; ++j)
            {
                const scalar apart = mag(place(j->second) - x);
                if (apart < 0.5*all[5*j->second + 1])
                {
                    FatalErrorInFunction
                        << cloud_.time().timeName()/cloud::prefix
                          /cloud_.name()
                        << "/x: the centre of particle "
                        << nameOf(all[5*i]).c_str() << " lies within "
                        << nameOf(all[5*j->second]).c_str()
                        << " (identityProc:identity), at " << x << " m" << nl
                        << "    allowed: centres more than a radius apart"
                        << nl << "    Restore x and d, or start from another"
                        << " time" << exit(FatalError);
                }
            }
        }
        grid.emplace(key(x, 0, 0, 0), i);
    }
}


// ************************************************************************* //
