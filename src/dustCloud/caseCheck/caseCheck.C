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
#include "dustProperties.H"

#include "caseCheck.H"
#include "injectionRate.H"
#include "modelTable.H"

#include "distributionModel.H"
#include "fvMesh.H"
#include "GlobalIOField.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::caseCheck::expected
(
    const dictionary& injector,
    const injectionRate& rate
) const
{
    const Time& time = mesh_.time();
    const scalar SOI = injector.lookupOrDefault<scalar>("SOI", 0);
    const scalar from = max(time.value() - SOI, scalar(0));
    const scalar open = min
    (
        time.endTime().value() - SOI - from,
        injector.lookupOrDefault<scalar>("duration", GREAT)
    );

    return min
    (
        rate.number(from, from + max(open, scalar(0))),
        scalar(injector.lookupOrDefault<label>("parcelsTotal", labelMax))
    );
}


Foam::scalar Foam::caseCheck::inflow
(
    const dictionary& injector,
    const volVectorField& U
) const
{
    const label patchi = mesh_.boundaryMesh().findPatchID
    (
        injector.lookupOrDefault<word>("patch", "none")
    );
    if (patchi < 0 || !injector.found("U0"))
    {
        return 0;
    }
    const fvPatch& patch = mesh_.boundary()[patchi];

    if (injector.lookupEntry("U0", keyType::LITERAL).stream()[0].isWord())
    {
        return gSum
        (
            max(-(U.boundaryField()[patchi] & patch.Sf()), scalar(0))()
        );
    }
    return mag(injector.get<vector>("U0"))*gSum(patch.magSf());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::caseCheck::caseCheck(const dictionary& injectors, const fvMesh& mesh)
:
    injectors_(injectors),
    mesh_(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::caseCheck::density
(
    const dictionary& properties,
    const dustProperties& dust
)
{
    const dictionary constants
    (
        properties.subOrEmptyDict("constantProperties")
    );
    scalar rho0;
    if (!constants.readIfPresent("rho0", rho0))
    {
        return;
    }
    for (const word& name : dust.dustMaterials())
    {
        const scalar density = dust.density(dust.index(name));
        if
        (
            (name == dust.dustMaterial() || dust.dustMaterial().empty())
         && mag(rho0 - density) > 1e-6*density
        )
        {
            dustProperties::error
            (
                constants,
                "rho0",
                "differs from the density of the material " + name,
                Foam::name(density) + ", or no rho0"
            );
        }
    }
}


void Foam::caseCheck::sizes() const
{
    // Of 2-D meshes only what is solved for
    const vector span = mesh_.bounds().span();
    scalar least = GREAT;
    for (direction i = 0; i < vector::nComponents; ++i)
    {
        if (mesh_.solutionD()[i] > 0)
        {
            least = min(least, span[i]);
        }
    }

    for (const entry& e : injectors_)
    {
        const dictionary* sizesPtr =
            e.isDict() ? e.dict().findDict("sizeDistribution") : nullptr;
        if (!sizesPtr)
        {
            continue;
        }
        Random random(0);
        const scalar largest =
            distributionModel::New(*sizesPtr, random)->maxValue();

        if (largest >= least)
        {
            const word block(sizesPtr->get<word>("type") + "Distribution");
            const dictionary* valuesPtr = sizesPtr->findDict(block);
            const dictionary& values = valuesPtr ? *valuesPtr : *sizesPtr;

            word keyword = sizesPtr->dictName();
            for (const word name : {"maxValue", "value", "distribution"})
            {
                keyword = values.found(name) ? name : keyword;
            }
            dustProperties::error
            (
                values,
                keyword,
                "particles of " + Foam::name(largest)
              + " m do not fit into a mesh of " + Foam::name(span.x()) + " x "
              + Foam::name(span.y()) + " x " + Foam::name(span.z())
              + " m: are the sizes in m?",
                "< " + Foam::name(least) + " m"
            );
        }
    }
}


void Foam::caseCheck::rates(const dustProperties& dust) const
{
    const scalar deltaT = mesh_.time().deltaTValue();

    for (const entry& e : injectors_)
    {
        if (!modelTable::injects(e))
        {
            continue;
        }
        const injectionRate rate(e.dict(), dust);
        if (rate.largest()*deltaT > 1e8)
        {
            dustProperties::error
            (
                e.dict(),
                rate.keyword().empty() ? "parcelsPerSecond" : rate.keyword(),
                "brings " + Foam::name(rate.largest()*deltaT)
              + " particles in a gas step of " + Foam::name(deltaT) + " s",
                "at most 1e8 of them"
            );
        }
    }
}


Foam::scalarList Foam::caseCheck::due
(
    const dustProperties& dust,
    const volVectorField& U
) const
{
    const scalar deltaT = mesh_.time().deltaTValue();
    scalarList nExpected(label(dust.materials().size()), Zero);

    for (const entry& e : injectors_)
    {
        if (!modelTable::injects(e))
        {
            continue;
        }
        const injectionRate injected(e.dict(), dust);
        const scalar n = expected(e.dict(), injected);
        const scalar rate = injected.largest();
        const scalar flow = inflow(e.dict(), U);

        const scalar volume =
            injected.largestMass()/dust.density(dust.material(e.dict()));

        if (n > 0)
        {
            Info<< "  Injector " << e.keyword() << ": " << n
                << " particles due until the end, up to " << min(n, rate*deltaT)
                << " in a gas step" << nl;
        }
        if (n > 0 && flow > 0 && volume > 0.5*flow)
        {
            Info<< "  Warning: injector " << e.keyword() << ": its particles"
                << " are " << volume/flow << " of the volume that enters with"
                << " them (at most 0.6 fits); "
                << (injected.byMass() ? injected.keyword() : "parcelsPerSecond")
                << " below " << 0.1*flow/volume*rate*injected.perParticle()
                << " leaves room" << nl;
        }
        nExpected[dust.material(e.dict())] += n;
    }
    return nExpected;
}


void Foam::caseCheck::positions() const
{
    for (const entry& e : injectors_)
    {
        if
        (
            !e.isDict()
         || e.dict().get<word>("type") != "manualInjection"
         || e.dict().lookupOrDefault("ignoreOutOfBounds", false)
        )
        {
            continue;
        }
        // Global, as the injector reads it: one file for all ranks
        const GlobalIOField<vector> positions
        (
            IOobject
            (
                e.dict().get<string>("positionsFile"),
                mesh_.time().constant(),
                mesh_,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        );
        labelList cells(positions.size());
        forAll(positions, i)
        {
            cells[i] = mesh_.findCell(positions[i]);
        }
        Pstream::listCombineGather(cells, maxEqOp<label>());
        Pstream::listCombineScatter(cells);

        const label i = cells.find(-1);
        if (i >= 0)
        {
            dustProperties::error
            (
                e.dict(),
                "positionsFile",
                "particle " + Foam::name(i) + " of "
              + positions.objectPath() + " at ("
              + Foam::name(positions[i].x()) + " "
              + Foam::name(positions[i].y()) + " "
              + Foam::name(positions[i].z()) + ") is outside the mesh",
                "positions inside, or ignoreOutOfBounds true"
            );
        }
    }
}


void Foam::caseCheck::calibration
(
    const dictionary& contact,
    const scalar chi,
    const bool automatic
)
{
    for (const entry& e : contact)
    {
        scalar fitted;
        if (!e.isDict() || !e.dict().readIfPresent("calibratedRatio", fitted))
        {
            continue;
        }
        if (mag(fitted - chi) < 1e-3*fitted)
        {
            Info<< "  Contact " << e.keyword() << ": chi " << chi << " is the"
                << " one for which it was calibrated" << nl;
        }
        else
        {
            Info<< "  Warning: contact " << e.keyword() << " was calibrated for"
                << " chi " << fitted << ", reducedStiffness/ratio is " << chi
                << (automatic ? " (auto)" : "") << ": its restitution is not"
                << " the measured one. 'ratio " << fitted << ";' is its own"
                << nl;
        }
    }
}


// ************************************************************************* //
