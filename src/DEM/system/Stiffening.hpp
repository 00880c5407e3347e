// SPDX-License-Identifier: GPL-3.0-or-later
//
// Another chi for a system that has contacts, between two particle steps.
//
// Forces stay as they are, so that what is in equilibrium stays so, at rest or not: each contact
// gets the overlap at which it gives, with the new chi, the normal force that it gave with the old
// one (from 0.01 to 1 the overlap at equilibrium falls by chi^(-2/5), 6.3 times); its springs are
// scaled so that sliding force, rolling and twisting moment stay. Particles are set aside, by
// less than the old overlaps times the number of contacts between them and the wall, until the
// overlaps are these: exactly where contacts make trees (chains, dendrites), else as closely as
// they can be (misfit; setAside.hpp), of which the rest is a force: those at rest whose contacts it
// is in wake. Who is set aside may come to touch others: what energy that puts in is in no ledger,
// and the deepest such overlap is told (newOverlap).
// All others who rest go on resting. Velocities stay. Aggregates that fly as rigid bodies become
// islands again, and freeze anew if they are at rest inside.
//
// Contacts for which a force says nothing keep a/a0, i.e. overlaps are scaled with a0^2, or without
// adhesion by (chi_old/chi_new)^(2/5), which is the same where surface energy is scaled, too: those
// in a collision (one of the two awake, pressed by more than F_C) and on the branch on which they
// are about to break; those that act at a distance keep the gap over their range. Their springs keep
// the energy that they have stored, xi ~ k^(-1/2), as the normal force does. So normal and sliding
// force keep their proportion (both ~ chi^(2/5), a collision without adhesion then differs in time
// only), a rolling spring, which chi changes nothing of at the same a/a0, is as it was, and what a
// spring has taken from a motion it gives back. With surfaceEnergy `unchanged` no collision is
// similar to another, and the normal energy changes.
//
// F_C delta_0, and so the energy of contacts at equilibrium, is the same at any chi; what loads add to
// it changes, and is no work of anybody (EnergyLedger::stiffening).
// Proof: tests/unit/DEM/stiffening.cpp, tests/verification/stiffening
#pragma once

#include "materials/MaterialTable.hpp"
#include "neighbourSearch/Periodic.hpp"
#include "parallel/Communicator.hpp"
#include "system/Diagnostics.hpp"
#include "system/ParticleStore.hpp"
#include "system/Restiffened.hpp"
#include "system/setAside.hpp"
#include "walls/WallSearch.hpp"

#include <cstdint>
#include <unordered_set>
#include <vector>

namespace dem
{

class ContactLaw;
struct ContactEnergy;

class Stiffening
{
public:

    //- Nothing is copied; store and materials are what it changes
    Stiffening
    (
        ParticleStore& store, MaterialTable& materials, const WallSearch& walls,
        const Periodic& periodic, const Communicator& communicator
    )
    :
        store_(store),
        materials_(materials),
        walls_(walls),
        periodic_(periodic),
        communicator_(communicator)
    {}

    //- Collective. Errors: inputError
    Restiffened to(double chi);


private:

    //- One contact of particle i
    struct Contact
    {
        std::size_t i, k;
        bool wall;
        Particle j;             // of a wall: i itself
        int materialJ;
        double R, m;            // [m], [kg]
        Vec3 n;                 // from i to j
        double before, after;   // overlap as it was, and as it should be [m]
        double size = 0;        // of overlaps, with the new chi [m]
        bool awake = false;     // one of the two is
        bool similar = true;    // keeps a/a0, not its force
    };

    const ContactLaw& law(const Contact& c) const;
    std::vector<Contact> find() const;
    std::unordered_set<std::int64_t> awakePartners(const std::vector<Contact>& contacts) const;
    void aim(Contact& c, const MaterialTable& now) const;
    ContactEnergy energy
    (
        const Contact& c, const MaterialTable& table, double overlap, const double* history
    ) const;
    Gap gap(const Contact& c) const;
    std::unordered_set<std::int64_t> takeOver
    (
        const std::vector<Contact>& contacts, const Ways& ways, const MaterialTable& now,
        Restiffened& r
    );
    void move
    (
        const Ways& ways, const std::unordered_set<std::int64_t>& wake, const MaterialTable& now,
        Restiffened& r
    );
    double unheldOverlap(std::size_t i, const Vec3& x) const;
    void lookAround(const std::vector<Gap>& gaps, const Ways& ways, Restiffened& r) const;
    Restiffened ofAllRanks(const Restiffened& mine) const;

    ParticleStore& store_;
    MaterialTable& materials_;
    const WallSearch& walls_;
    const Periodic& periodic_;
    const Communicator& communicator_;
};

}
