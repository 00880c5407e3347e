// SPDX-License-Identifier: GPL-3.0-or-later
//
// The DEM system: particles, walls, contacts, and the clocks that move them.
//
// One call of advance(dt) is one particle step. Within it
//   - a particle that can meet nothing flies in closed form (linear drag, any tau_p/dt);
//   - particles that can meet form islands; each island flies to its next touch and takes
//     contact steps of its own size only while it has a contact;
//   - a particle in a deposit that has come to rest sleeps until what touches it loads it,
//     or its gas load changes; islands in which all sleep take no steps;
//   - an aggregate that is at rest inside flies as one rigid body, until its load changes or
//     something can meet it.
// Islands that span ranks are moved by the rank that owns their lowest particle id, so the
// result does not depend on the decomposition.
//
// All units SI. Nothing here knows of a mesh or of OpenFOAM.
#pragma once

#include "contacts/ContactView.hpp"
#include "insertion/Entrance.hpp"
#include "materials/ContactSettings.hpp"
#include "materials/Material.hpp"
#include "materials/MaterialTable.hpp"
#include "neighbourSearch/Periodic.hpp"
#include "parallel/Communicator.hpp"
#include "particles/GasExchange.hpp"
#include "particles/GasLoad.hpp"
#include "particles/Particle.hpp"
#include "reducedStiffness/ReducedStiffness.hpp"
#include "timeIntegration/TimeSettings.hpp"
#include "system/Restiffened.hpp"
#include "system/StepReport.hpp"
#include "walls/Walls.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dem
{

class System
{
public:

    //- Errors: inputError where a setting is wrong
    System
    (
        MaterialTable materials,
        const TimeSettings& time,
        Communicator communicator = Communicator()     // default: this process alone
    );
    ~System();

    System(const System&) = delete;
    System& operator=(const System&) = delete;

    const MaterialTable& materials() const;

    //- Another chi from here on, with all contacts that there are: see Stiffening.hpp. The same
    //  on every rank. Collective. Errors: inputError
    Restiffened setRatio(double chi);
    const TimeSettings& timeSettings() const;


    // Walls. The same list on every rank; set once, before the first particle.

        void setWalls(Walls walls);
        const Walls& walls() const;


    //- Make the system periodic. Before the first particle; on one rank only.
    //  Errors: inputError
    void setPeriodic(const Periodic& periodic);


    // Particles of this rank. An index stays valid until remove() is called.

        std::size_t size() const;

        //- Errors: inputError on a diameter, density or id that makes no sense, or an id
        //  that this rank has already. delay: it enters, at its place, that long after the next
        //  advance() has begun [s]: nothing meets it before, and it moves for the rest of that;
        //  negative: it was there that long before, see behind()
        std::size_t add(const Particle& p, double delay = 0);

        //- Remove the marked particles (one flag per index) with their contacts, and close
        //  the gaps: afterwards the remaining ones keep their order. Contacts with a
        //  particle that another rank removes end at the next advance().
        void remove(const std::vector<char>& marked);

        const Particle& particle(std::size_t index) const;

        //- Change position, velocity or spin from outside (tests, thermostats). Wakes it.
        void setMotion(std::size_t index, const Vec3& x, const Vec3& v, const Vec3& omega);

        bool resting(std::size_t index) const;

        //- Indices of those who move in the next advance(), ascending; and of those who took part
        //  in the last one, in any order: nobody else was changed by it. The first holds until
        //  anything of the system is changed, the second until the next advance() or remove().
        const std::vector<std::size_t>& awake() const;
        const std::vector<std::size_t>& moved() const;

        //- In at least one contact (pair or wall) at the end of the last advance()
        bool inContact(std::size_t index) const;

        //- Unit vector into the wall that the particle has a contact with, of several walls their
        //  mean; zero: none, or mirrors only
        Vec3 wallNormal(std::size_t index) const;


    // Gas

        //- The gas force on a particle during the next advance(): Sp (Uc - v) + Su [N]
        void setGasLoad(std::size_t index, const GasLoad& load);
        const GasLoad& gasLoad(std::size_t index) const;


    // Motion

        //- One particle step of dt [s]. Collective. Afterwards every particle of this rank
        //  has moved, and gasExchange() holds what the gas gave to it.
        //  ahead [s]: it is a part of a longer one, which goes on for so long with the same gas
        //  loads; begins: it is the first. Where it is cut makes no difference then
        //  (gasExchange() does not hold).
        //  Errors: numericalError, with particle, contact and time named.
        StepReport advance(double dt, double ahead = 0, bool begins = true);

        //- A collision that the end of a part would cut in two comes in the next part as a
        //  whole. Until then its particles stand, within their radius, where they were so long
        //  before [s]; 0 for all others.
        double behind(std::size_t index) const;

        //- What the gas gave to the particle in the last advance()
        const GasExchange& gasExchange(std::size_t index) const;

        //- Whether gasExchange() is kept; it costs some. Default: no
        void keepGasExchange(bool keep);

        //- Give an impulse [N s] to a particle that flies alone (!inContact()); it does not
        //  count as one of the next gasExchange(), but as work of the gas in the energy ledger
        void kick(std::size_t index, const Vec3& impulse);

        double time() const;        // [s] summed over advance(); set on restart
        void setTime(double time);


    // Contacts (end of the last advance())

        //- Contacts of this rank's particles. A pair contact is listed on the rank that
        //  owns its lower id; forces are re-evaluated without touching any history.
        //  Those with mirrors are left out. Collective.
        std::vector<ContactView> contacts() const;

        //- Pull-off force over external force for every bonded particle of all ranks:
        //  the force that its contact towards the wall must carry is the sum of the
        //  external forces on all that hangs on it (shortest way to the wall; of a flying
        //  aggregate, to its lowest id, in its accelerated frame). 1e30 where nothing
        //  pulls. Collective; the result is on the master (else empty).
        std::vector<double> adhesionMargins() const;

        //- Labels of connected clusters: for each particle of this rank the lowest id of
        //  its cluster and whether that cluster holds on to a wall, no mirror. Collective.
        std::vector<ClusterLabel> clusters() const;


    // Insertion

        //- Whether there is room, among walls and particles of this rank, for new spheres in
        //  this box within the next advance(), over dt [s]; none larger in radius or faster
        Entrance entrance(const Box& box, double dt, double largest, double fastest) const;


    // Moving particles between ranks, and files

        //- Contact history and rest state of a particle as numbers (empty if it has none).
        //  For a pair the lower id carries it.
        std::vector<double> packState(std::size_t index) const;

        //- The inverse, for a particle just added. wallNow: what each wall patch of the time of
        //  packing is now, -1 = gone; empty = all as they were. A contact with a patch that is
        //  gone ends and the particle wakes; returned: that patch, as packed, once per contact.
        //  Errors: inputError where the numbers do not fit the contact laws in use
        std::vector<int> unpackState
        (
            std::size_t index,
            const std::vector<double>& state,
            const std::vector<int>& wallNow = {}
        );


private:

    class Implementation;
    std::unique_ptr<Implementation> impl_;
};

}
