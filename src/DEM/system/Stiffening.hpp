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
// they can be (misfit), of which the rest is a force that moves what is awake. Velocities stay;
// who rests goes on resting. Aggregates that fly as rigid bodies become islands again, and freeze
// anew if they are at rest inside.
//
// Contacts for which a force says nothing keep a/a0, i.e. overlaps are scaled by
// (chi_old/chi_new)^(2/5), by which rebound speeds are what they would have been: those in a
// collision (awake, pressed by more than F_C), on the branch on which they are about to break, and
// those that act at a distance.
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
#include "walls/WallSearch.hpp"

#include <cstdint>
#include <unordered_map>
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
    };

    //- What the solution of all ranks needs to know of a contact
    struct Gap
    {
        std::int64_t i, j;      // j = -1: wall
        Vec3 n;
        double open;            // to move apart by [m]
        double mi, mj;          // [kg]

        template<class S, class F>
        static void fields(S& s, F& f)
        {
            f(s.i);
            f(s.j);
            f(s.n);
            f(s.open);
            f(s.mi);
            f(s.mj);
        }
    };

    //- Where particles go to, by id [m]
    using Ways = std::unordered_map<std::int64_t, Vec3>;

    const ContactLaw& law(const Contact& c) const;
    std::vector<Contact> find() const;
    bool aim(Contact& c, const MaterialTable& now) const;
    ContactEnergy energy
    (
        const Contact& c, const MaterialTable& table, double overlap, const double* history
    ) const;
    static Ways solve(std::vector<Gap> gaps);
    static void agree(const std::vector<Gap>& gaps, Ways& ways);
    void takeOver
    (
        const std::vector<Contact>& contacts, const Ways& ways, const MaterialTable& now,
        Restiffened& r
    );
    void move(const Ways& ways, const MaterialTable& now, Restiffened& r);
    Restiffened ofAllRanks(const Restiffened& mine) const;

    ParticleStore& store_;
    MaterialTable& materials_;
    const WallSearch& walls_;
    const Periodic& periodic_;
    const Communicator& communicator_;
};

}
