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
#include "startCells.H"

#include "Pstream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::startCells::tolerance(const label celli) const
{
    return 1e-7*cbrt(mesh_.cellVolumes()[celli]);
}


Foam::scalar Foam::startCells::outside
(
    const point& x,
    const label celli,
    const label facei
) const
{
    const vector& S = mesh_.faceAreas()[facei];
    const scalar along = ((x - mesh_.faceCentres()[facei]) & S)/mag(S);
    return mesh_.faceOwner()[facei] == celli ? along : -along;
}


bool Foam::startCells::holds(const point& x, const label celli) const
{
    for (const label facei : mesh_.cells()[celli])
    {
        if (outside(x, celli, facei) > tolerance(celli))
        {
            return false;
        }
    }
    return true;
}


bool Foam::startCells::lower
(
    const point& a,
    const point& b,
    const scalar width
)
{
    for (direction d = 0; d < 3; ++d)
    {
        if (mag(a[d] - b[d]) > 1e-4*width)
        {
            return a[d] < b[d];
        }
    }
    return false;
}


Foam::label Foam::startCells::lowest(const point& x) const
{
    label best = mesh_.findCell(x);
    const label near = best >= 0 ? best : mesh_.findNearestCell(x);
    if (near < 0)
    {
        return -1;
    }

    for (const label pointi : mesh_.cellPoints()[near])
    {
        for (const label celli : mesh_.pointCells()[pointi])
        {
            if
            (
                holds(x, celli)
             && (
                    best < 0
                 || lower
                    (
                        mesh_.cellCentres()[celli],
                        mesh_.cellCentres()[best],
                        cbrt(mesh_.cellVolumes()[celli])
                    )
                )
            )
            {
                best = celli;
            }
        }
    }
    return best;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::startCells::onFace(const point& x, const label celli) const
{
    for (const label facei : mesh_.cells()[celli])
    {
        const label patchi = mesh_.boundaryMesh().whichPatch(facei);
        if
        (
            (patchi < 0 || mesh_.boundaryMesh()[patchi].coupled())
         && mag(outside(x, celli, facei)) <= tolerance(celli)
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::startCells::find(const pointField& mine)
{
    List<pointField> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = mine;
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    owner_.setSize(mine.size());
    cell_.setSize(mine.size());

    forAll(all, proci)
    {
        forAll(all[proci], i)
        {
            const label celli = lowest(all[proci][i]);

            // Centre and width of the best of each rank
            List<FixedList<scalar, 4>> best(Pstream::nProcs());
            labelList cells(Pstream::nProcs(), -1);
            FixedList<scalar, 4>& my = best[Pstream::myProcNo()];
            my = scalar(-1);
            if (celli >= 0)
            {
                const point& c = mesh_.cellCentres()[celli];
                my[0] = c.x();
                my[1] = c.y();
                my[2] = c.z();
                my[3] = cbrt(mesh_.cellVolumes()[celli]);
                cells[Pstream::myProcNo()] = celli;
            }
            Pstream::gatherList(best);
            Pstream::scatterList(best);
            Pstream::listCombineGather(cells, maxEqOp<label>());
            Pstream::listCombineScatter(cells);

            label rank = -1;
            forAll(best, ranki)
            {
                const auto centre = [&best](const label r)
                {
                    return point(best[r][0], best[r][1], best[r][2]);
                };
                if
                (
                    cells[ranki] >= 0
                 && (
                        rank < 0
                     || lower(centre(ranki), centre(rank), best[ranki][3])
                    )
                )
                {
                    rank = ranki;
                }
            }
            if (proci == Pstream::myProcNo())
            {
                owner_[i] = rank;
                cell_[i] = rank < 0 ? -1 : cells[rank];
            }
        }
    }
}


// ************************************************************************* //
