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

#include "awakeParcels.H"

#include <algorithm>
#include <iterator>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::UList<Foam::dustParcel*>& Foam::awakeParcels::list
(
    const std::vector<std::size_t>& indices
)
{
    list_.clear();
    for (const std::size_t i : indices)
    {
        list_.append(parcels_[label(i)]);
    }
    return list_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::awakeParcels::add(dustParcel& p)
{
    p.demIndex() = label(parcels_.size());
    parcels_.append(&p);
}


void Foam::awakeParcels::leaves(dustParcel& p)
{
    leaving_.push_back(std::size_t(p.demIndex()));
    p.demIndex() = -1;
}


void Foam::awakeParcels::removeLeavers(dem::System& system)
{
    if (leaving_.empty())
    {
        return;
    }
    std::vector<char> marked(std::size_t(parcels_.size()), 0);
    for (const std::size_t i : leaving_)
    {
        marked[i] = 1;
    }
    system.remove(marked);

    std::vector<const dustParcel*> settled;
    for (const std::size_t i : settled_)
    {
        if (!marked[i])
        {
            settled.push_back(parcels_[label(i)]);
        }
    }

    // Close the gaps, as the system has
    label kept =
        label(*std::min_element(leaving_.begin(), leaving_.end()));
    for (label i = kept; i < parcels_.size(); ++i)
    {
        if (!marked[std::size_t(i)])
        {
            parcels_[kept] = parcels_[i];
            parcels_[kept]->demIndex() = kept;
            ++kept;
        }
    }
    parcels_.setSize(kept);
    leaving_.clear();

    settled_.clear();
    for (const dustParcel* p : settled)
    {
        settled_.push_back(std::size_t(p->demIndex()));
    }
}


void Foam::awakeParcels::settled(const dustParcel& p)
{
    settled_.push_back(std::size_t(p.demIndex()));
}


const Foam::UList<Foam::dustParcel*>& Foam::awakeParcels::toLoad
(
    const dem::System& system,
    const bool everyone
)
{
    if (newGas_ || everyone)
    {
        newGas_ = false;
        settled_.clear();
        list_ = parcels_;
        return list_;
    }

    const std::vector<std::size_t>& awake = system.awake();
    std::vector<std::size_t> indices;
    std::sort(settled_.begin(), settled_.end());
    std::set_union
    (
        awake.begin(), awake.end(), settled_.begin(), settled_.end(),
        std::back_inserter(indices)
    );
    settled_.clear();
    return list(indices);
}


const Foam::UList<Foam::dustParcel*>& Foam::awakeParcels::withoutLoad
(
    const dem::System& system
)
{
    list_.clear();
    for (const std::size_t i : system.awake())
    {
        if (!parcels_[label(i)]->loadHolds())
        {
            list_.append(parcels_[label(i)]);
        }
    }
    return list_;
}


const Foam::UList<Foam::dustParcel*>& Foam::awakeParcels::changed
(
    const dem::System& system
)
{
    std::vector<std::size_t> moved(system.moved());
    std::sort(moved.begin(), moved.end());
    return list(moved);
}


// ************************************************************************* //
