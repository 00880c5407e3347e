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

#include "parcelTracking.H"
#include "processorPolyPatch.H"
#include "PstreamBuffers.H"
#include "globalMeshData.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::parcelTracking::track
(
    const UList<dustParcel*>& parcels,
    const scalar dt
)
{
    for (dustParcel* pPtr : parcels)
    {
        if (!pPtr->move(cloud_, td_, dt))
        {
            cloud_.deleteParticle(*pPtr);
        }
        else if (td_.switchProcessor)
        {
            leave(*pPtr);
        }
    }
}


void Foam::parcelTracking::leave(dustParcel& p)
{
    const polyMesh& mesh = cloud_.pMesh();
    const globalMeshData& all = mesh.globalData();
    const label patchi = p.patch();
    const label neighbour = refCast<const processorPolyPatch>
    (
        mesh.boundaryMesh()[patchi]
    ).neighbProcNo();
    const label n = all[Pstream::myProcNo()].find(neighbour);

    p.prepareForParallelTransfer();
    going_[n].append(&p);
    entries_[n].append(all.processorPatchNeighbours()[patchi]);
}


bool Foam::parcelTracking::exchange(DynamicList<dustParcel*>& come)
{
    const polyMesh& mesh = cloud_.pMesh();
    const globalMeshData& all = mesh.globalData();
    const labelList& neighbours = all[Pstream::myProcNo()];
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);

    forAll(going_, n)
    {
        if (going_[n].empty())
        {
            continue;
        }
        UOPstream to(neighbours[n], buffers);
        to << labelList(entries_[n]);
        for (dustParcel* pPtr : going_[n])
        {
            to << *pPtr;
            cloud_.deleteParticle(*pPtr);
        }
        going_[n].clear();
        entries_[n].clear();
    }

    labelList received(Pstream::nProcs());
    buffers.finishedSends(received);
    come.clear();

    for (const label proci : neighbours)
    {
        if (!received[proci])
        {
            continue;
        }
        UIPstream from(proci, buffers);
        for (const label entry : labelList(from))
        {
            dustParcel* pPtr = new dustParcel(mesh, from);
            pPtr->correctAfterParallelTransfer
            (
                all.processorPatches()[entry], td_
            );
            cloud_.addParticle(pPtr);
            come.append(pPtr);
        }
    }
    return returnReduce(come.size() > 0, orOp<bool>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::parcelTracking::parcelTracking
(
    dustCloud& cloud,
    dustParcel::trackingData& td
)
:
    cloud_(cloud),
    td_(td)
{
    if (Pstream::parRun())
    {
        const label n =
            cloud.pMesh().globalData()[Pstream::myProcNo()].size();
        going_.setSize(n);
        entries_.setSize(n);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::parcelTracking::move
(
    const UList<dustParcel*>& parcels,
    const scalar dt
)
{
    DynamicList<dustParcel*> moving;
    for (dustParcel* pPtr : parcels)
    {
        if (pPtr->moved())
        {
            pPtr->stepFraction() = 0;
            moving.append(pPtr);
        }
    }

    td_.relocating = true;
    do
    {
        track(moving, dt);
    }
    while (Pstream::parRun() && exchange(moving));
    td_.relocating = false;
}


// ************************************************************************* //
