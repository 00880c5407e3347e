// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves the particles of one island over one particle step. How
//   - a step is chosen:                    StepControl, ContactSurvey, eventTimes
//   - loads reach velocities:              Propagator; Forces, Boundary
//   - a contact begins and ends:           Candidates, Contacts
//   - a particle falls asleep and wakes:   Rest, restCriteria
//   - energy is accounted for:             EnergyAccount
// and what all of them work on:            IslandState
// Proof: tests/verification/DEM/{convergence,pslRebound}.cpp, tests/unit/DEM/{stability,island}.cpp
#pragma once

#include "contacts/ContactRecord.hpp"
#include "island/Boundary.hpp"
#include "island/Candidates.hpp"
#include "island/Contacts.hpp"
#include "island/Corridor.hpp"
#include "island/EnergyAccount.hpp"
#include "island/Environment.hpp"
#include "island/Forces.hpp"
#include "island/IslandState.hpp"
#include "island/Propagator.hpp"
#include "island/Rest.hpp"
#include "island/StepControl.hpp"
#include "particles/GasExchange.hpp"
#include "system/Span.hpp"
#include "system/StepReport.hpp"

#include <vector>

namespace dem
{

class Island
{
public:

    Island
    (
        const MaterialTable& materials,
        const TimeSettings& time,
        const WallSearch& walls,
        const Periodic& periodic
    );

    Island(const Island&) = delete;
    Island& operator=(const Island&) = delete;

    // Loading, in this order: particles, their wall surfaces, contacts

        void clear();

        //- Particles in order of id. corridor: where it can get in this step; rim: it is at
        //  rest, and must not wake, as what is beyond it is not here
        void addParticle
        (
            const Particle& p, const GasLoad& g, const RestState& rest,
            const Corridor& corridor = {}, bool rim = false
        );

        //- Surfaces that the last particle can reach in this step
        void addSurfaces(const std::vector<int>& surfaces);

        //- A contact of particle i (with local particle j, or with a wall: j = -1)
        void addContact(int i, int j, const ContactRecord& record);


    //- Move everything. It ends at once where one of the rim would wake (wokeAtRim): nothing else
    //  holds then. Errors: numericalError
    //  A step that is to go on does not end within a contact: with other contact steps it would
    //  leave it otherwise, by their error. It goes back to where all flew last, or to its
    //  beginning, and behind() tells how long ago that was; unless somebody has come farther than
    //  its radius since.
    void run(const Span& span, StepReport& report);


    // Results

        std::size_t size() const { return state_.particles.size(); }
        const Particle& particle(int i) const { return state_.particles[std::size_t(i)]; }
        const Vec3& gasImpulse(int i) const { return state_.impulse[std::size_t(i)]; }

        //- Of all particles, over the last run(), which was over dt
        std::vector<GasExchange> gasExchange(double dt) const;

        const RestState& rest(int i) const { return state_.rest[std::size_t(i)]; }

        //- How fast particle i has left its corridor, on average since it began [m/s]; 0: it
        //  has not
        double outran(int i) const { return candidates_.outran(std::size_t(i)); }

        bool wokeAtRim(int i) const { return wokeAtRim_[std::size_t(i)]; }

        //- Those awake stand where they were so long before the end of the run [s]
        double behind() const { return behind_; }
        //- That is where it began: all else is as it was loaded, too
        bool atStart() const { return atStart_; }

        //- Contacts of particle i as the lower partner
        std::vector<ContactRecord> contacts(int i) const;


private:

    void begin(const Span& span);
    void firstContacts(StepReport& report);
    void take(const Step& step, StepReport& report);
    void prepareSprings(double ahead);
    Changes update(StepReport& report);
    void endContacts(Changes& changes, StepReport& report);
    void beginContacts(Changes& changes, StepReport& report);
    WallImpact impact(const Touch& touch) const;
    void noteTouches(const std::vector<Touch>& touches, StepReport& report) const;
    void wake(std::vector<int> woken, StepReport& report);
    bool findAtRim(const std::vector<int>& woken);
    void settle(StepReport& report);
    void mark(const StepReport& report);
    bool nearMark() const;
    void goBack(StepReport& report);
    void finish(const Span& span, StepReport& report);
    void takeBack();

    Environment env_;
    IslandState state_;
    Contacts contacts_;
    Candidates candidates_;
    Propagator propagator_;
    Boundary boundary_;
    Forces forces_;
    StepControl control_;
    Rest rest_;
    EnergyAccount account_;
    std::vector<char> rim_, wokeAtRim_;     // by particle
    bool rimWoke_ = false;      // one of them has
    bool ended_ = false;        // the last forces have marked contacts that end

    // Where a run that would cut a contact goes back to
    bool marked_ = false;
    IslandState mark_;
    StepReport markReport_;
    double ahead_ = 0;          // [s] the particle step goes on after the run
    double behind_ = 0;         // [s]
    bool atStart_ = false;      // it has gone back to its beginning
};

}
