// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can be asked between particle steps. Nothing is changed by asking.
#pragma once

#include "contacts/ContactView.hpp"
#include "contacts/clusterMargins.hpp"
#include "materials/MaterialTable.hpp"
#include "neighbourSearch/Periodic.hpp"
#include "parallel/Communicator.hpp"
#include "system/ParticleStore.hpp"
#include "walls/WallSearch.hpp"

#include <functional>
#include <unordered_map>
#include <vector>

namespace dem
{

//- Looks at the particles of this rank; nothing is copied
class Diagnostics
{
public:

    Diagnostics
    (
        const ParticleStore& store, const MaterialTable& materials, const WallSearch& walls,
        const Periodic& periodic, const Communicator& communicator
    )
    :
        store_(store),
        materials_(materials),
        walls_(walls),
        periodic_(periodic),
        communicator_(communicator)
    {}

    // See System; all are collective

        std::vector<ContactView> contacts() const;
        std::vector<double> adhesionMargins() const;
        std::vector<ClusterLabel> clusters() const;

    //- f(i, k, j) for contact k of particle i of this rank, in order; j: its partner, also one of
    //  another rank, nullptr = wall. Not for those whose partner has left the system. Collective.
    void eachContact
    (
        const std::function<void(std::size_t i, std::size_t k, const Particle* j)>& f
    ) const;

    //- Overlap [m] of a contact of particle i; j as above
    double overlap(std::size_t i, const ContactRecord& c, const Particle* j) const;


private:

    using Partners = std::unordered_map<std::int64_t, Particle>;

    //- Particles of other ranks that own particles have contacts with
    Partners remotePartners() const;

    //- One contact of particle i, evaluated alone; j: its partner, nullptr = wall
    ContactView view(std::size_t i, const ContactRecord& c, const Particle* j) const;

    //- Overlap with the part of that wall that lies nearest to the normal that is remembered
    double wallOverlap(std::size_t i, const ContactRecord& c) const;

    const ParticleStore& store_;
    const MaterialTable& materials_;
    const WallSearch& walls_;
    const Periodic& periodic_;
    const Communicator& communicator_;
};

}
