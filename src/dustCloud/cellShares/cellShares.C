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

#include "cellShares.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellShares::cellShares(const fvMesh& mesh)
:
    mesh_(mesh),
    cell_(-1),
    own_(1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellShares::moveTo(const point& x, const label celli)
{
    cell_ = celli;
    faces_.clear();
    shares_.clear();

    const vector d((x - mesh_.cellCentres()[celli])/mesh_.cellVolumes()[celli]);
    scalar sum = 0;

    for (const label facei : mesh_.cells()[celli])
    {
        const scalar out =
            (mesh_.faceOwner()[facei] == celli ? 1 : -1)
           *(d & mesh_.faceAreas()[facei]);

        if
        (
            out > 0
         && (
                mesh_.isInternalFace(facei)
             || mesh_.boundaryMesh()
                [
                    mesh_.boundaryMesh().whichPatch(facei)
                ].coupled()
            )
        )
        {
            faces_.append(facei);
            shares_.append(out);
            sum += out;
        }
    }

    if (sum > 1)
    {
        for (scalar& share : shares_)
        {
            share /= sum;
        }
        sum = 1;
    }
    own_ = 1 - sum;
}



// ************************************************************************* //
