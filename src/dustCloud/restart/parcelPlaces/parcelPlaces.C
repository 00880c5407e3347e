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

#include "parcelPlaces.H"

#include "fvcSurfaceIntegrate.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::parcelPlaces::fits(const dustParcel& p) const
{
    scalar sum = 0;
    for (direction d = 0; d < 4; ++d)
    {
        const scalar c = p.coordinates()[d];
        // first: comparing what is not a number may trap
        if (!std::isfinite(c) || mag(c) > 1e6)
        {
            return false;
        }
        sum += c;
    }
    return
        mag(sum - 1) < 1e-6
     && p.cell() >= 0 && p.cell() < mesh_.nCells()
     && mesh_.cells()[p.cell()].found(p.tetFace())
     && p.tetPt() > 0
     && p.tetPt() < mesh_.faces()[p.tetFace()].size() - 1;
}


Foam::scalar Foam::parcelPlaces::width(const label celli) const
{
    return cbrt(mesh_.V()[celli]);
}


Foam::scalar Foam::parcelPlaces::astray(const dustParcel& p) const
{
    return mag(cloud_.way(p.position(), p.x()))/width(p.cell());
}


bool Foam::parcelPlaces::renumbered() const
{
    // A particle's tracked place is where it is, but for one whose way was
    // blocked: then it is less than a cell away
    bool some = false;
    for (const dustParcel& p : cloud_)
    {
        some =
            some
         || !fits(p)
         || (astray(p) > 1 && !mesh_.pointInCell(p.x(), p.cell()));
    }
    return returnReduce(some, orOp<bool>());
}


void Foam::parcelPlaces::checkGas() const
{
    // renumberMesh treats the fields of one time only. Those of another have
    // sources everywhere: no gas of a solver has.
    if (!mesh_.foundObject<surfaceScalarField>("phi"))
    {
        return;
    }
    const surfaceScalarField& phi =
        mesh_.lookupObject<surfaceScalarField>("phi");
    const scalar in = gSum
    (
        mag(fvc::surfaceIntegrate(phi)().primitiveField())*mesh_.V()
    );
    const scalar through = gSum(fvc::surfaceSum(mag(phi))().primitiveField());

    if (in > 0.01*through)
    {
        FatalErrorInFunction
            << "The cells are not numbered as when time "
            << mesh_.time().timeName() << " was written, and its gas"
            << " fields were not renumbered with them: the flux has"
            << " sources of " << in/through << " of what flows through"
            << " the cells" << nl
            << "    Restore the mesh, and use renumberMesh -latestTime"
            << " (decomposed: on every rank), which renumbers the fields,"
            << " too; the particles are found by their place"
            << exit(FatalError);
    }
}


Foam::label Foam::parcelPlaces::cellOf(const dustParcel& p) const
{
    const label in = mesh_.findCell(p.x());
    if (in >= 0)
    {
        return in;
    }
    const label beside = mesh_.findNearestCell(p.x());
    if (mag(mesh_.C()[beside] - p.x()) > width(beside))
    {
        FatalErrorInFunction
            << "Particle " << p.origProc() << ':' << p.origId()
            << " at " << p.x() << " is not in the mesh"
            << (Pstream::parRun() ? " of its rank" : "") << nl
            << "    The mesh is not the one that lagrangian/" << cloud_.name()
            << " of time " << mesh_.time().timeName()
            << " was written with: restore it (and decompose anew), or"
            << " start from another time" << exit(FatalError);
    }
    return beside;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::parcelPlaces::findAgain()
{
    const bool all = renumbered();
    if (all)
    {
        checkGas();
    }

    label n = 0;
    for (dustParcel& p : cloud_)
    {
        if (fits(p) && astray(p) < 1e-5)
        {
            continue;
        }
        // One that was blocked is outside its cell
        if (all || mesh_.pointInCell(p.x(), p.cell()))
        {
            p.relocate(p.x(), cellOf(p));
            ++n;
        }
    }
    reduce(n, sumOp<label>());

    if (n)
    {
        Info<< "Warning: the cells are not numbered as when time "
            << mesh_.time().timeName() << " was written, or its lagrangian/"
            << cloud_.name() << "/coordinates were changed: " << n
            << " particles were found again by their place" << nl << endl;
    }
}


// ************************************************************************* //
