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
#include "dustSnapshot.H"

#include <algorithm>
#include <map>
#include <unordered_map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Numbers of all ranks in a row, on the master
static scalarList gatherNumbers(const UList<scalar>& mine)
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

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::dustSnapshot& Foam::dustCloud::snapshot() const
{
    const label timeIndex = mesh_.time().timeIndex();

    if (snapshotPtr_ && snapshotTimeIndex_ == timeIndex)
    {
        return *snapshotPtr_;
    }
    snapshotPtr_.reset(new dustSnapshot);
    snapshotTimeIndex_ = timeIndex;

    dustSnapshot& snapshot = *snapshotPtr_;
    const dem::System& system = *dem_->system;

    // Particles. Ids are below 2^53: exact as scalars.

    const label width = 13;
    DynamicList<scalar> mine(width*size());
    const std::vector<dem::ClusterLabel> clusters(system.clusters());

    for (const dustParcel& p : *this)
    {
        const dem::ClusterLabel& cluster =
            clusters[std::size_t(p.demIndex())];

        mine.append(scalar(p.id()));
        mine.append(p.x().x());
        mine.append(p.x().y());
        mine.append(p.x().z());
        mine.append(p.U().x());
        mine.append(p.U().y());
        mine.append(p.U().z());
        mine.append(p.d());
        mine.append(p.mass());
        mine.append(p.state());
        mine.append(scalar(cluster.root));
        mine.append(cluster.onWall);
        mine.append(p.material());
    }

    const scalarList particles(gatherNumbers(mine));

    // Contacts

    const label bondWidth = 9;
    mine.clear();

    for (const dem::ContactView& c : system.contacts())
    {
        mine.append(scalar(c.idI));
        mine.append(scalar(c.idJ));
        mine.append(c.wall >= 0 ? dem_->wallPatches[c.wall] : -1);
        mine.append(c.point.x());
        mine.append(c.point.y());
        mine.append(c.point.z());
        mine.append(c.overlap);
        mine.append(c.force.norm());
        mine.append(c.pullOff);
    }

    const scalarList bonds(gatherNumbers(mine));

    snapshot.margins = system.adhesionMargins();
    std::sort(snapshot.margins.begin(), snapshot.margins.end());

    if (!Pstream::master())
    {
        return snapshot;
    }

    for (label i = 0; i < particles.size(); i += width)
    {
        const scalar* v = &particles[i];
        snapshot.particles.push_back
        (
            dustSnapshot::particleData
            {
                int64_t(v[0]),
                point(v[1], v[2], v[3]),
                vector(v[4], v[5], v[6]),
                v[7],
                v[8],
                label(v[9]), label(v[12]),
                int64_t(v[10]),
                v[11] > 0.5 ? 0 : -1,
                point(v[1], v[2], v[3])
            }
        );
    }

    std::sort
    (
        snapshot.particles.begin(),
        snapshot.particles.end(),
        [](const auto& a, const auto& b) { return a.id < b.id; }
    );

    std::unordered_map<int64_t, label> index;
    for (const auto& p : snapshot.particles)
    {
        index.emplace(p.id, label(index.size()));
    }

    for (label i = 0; i < bonds.size(); i += bondWidth)
    {
        const scalar* v = &bonds[i];
        const auto pi = index.find(int64_t(v[0]));
        const auto pj = index.find(int64_t(v[1]));

        // A partner that has just left the domain
        if (pi == index.end() || (v[1] >= 0 && pj == index.end()))
        {
            continue;
        }
        snapshot.bonds.push_back
        (
            dustSnapshot::bondData
            {
                pi->second,
                v[1] >= 0 ? pj->second : -1,
                label(v[2]),
                point(v[3], v[4], v[5]),
                v[6],
                v[7],
                v[8]
            }
        );
    }

    std::sort
    (
        snapshot.bonds.begin(),
        snapshot.bonds.end(),
        [](const auto& a, const auto& b)
        {
            return
                a.i != b.i ? a.i < b.i
              : a.j != b.j ? a.j < b.j
              : a.patch < b.patch;
        }
    );

    // To which patch does a deposited particle belong?

    std::map<std::pair<int64_t, label>, label> contactsWith;
    for (const auto& b : snapshot.bonds)
    {
        if (b.j < 0)
        {
            ++contactsWith[{snapshot.particles[b.i].cluster, b.patch}];
        }
    }

    std::unordered_map<int64_t, label> clusterPatch;
    for (const auto& c : contactsWith)
    {
        auto& patch = clusterPatch.emplace(c.first.first, c.first.second)
            .first->second;
        if (c.second > contactsWith[{c.first.first, patch}])
        {
            patch = c.first.second;
        }
    }

    for (auto& p : snapshot.particles)
    {
        if (p.patch == 0)
        {
            const auto found = clusterPatch.find(p.cluster);
            p.patch = found == clusterPatch.end() ? -1 : found->second;
        }
    }

    // The bonds are sorted: backwards, so that the lowest patch stays
    for (auto b = snapshot.bonds.rbegin(); b != snapshot.bonds.rend(); ++b)
    {
        if (b->j < 0)
        {
            auto& p = snapshot.particles[std::size_t(b->i)];
            p.patch = b->patch;
            p.at = b->at;
        }
    }

    return snapshot;
}


// ************************************************************************* //
