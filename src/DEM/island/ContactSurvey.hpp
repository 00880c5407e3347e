// SPDX-License-Identifier: GPL-3.0-or-later
//
// A look at all contacts: the contact step h = T/stepsPerContact, T the shortest period of the
// contacts as they are now and until the next look, or shorter where stability asks for it
// (contactPeriod.hpp): many contacts on one light particle, strong dashpots. It watches the
// contacts as well.
#pragma once

#include "island/Candidates.hpp"
#include "island/Environment.hpp"
#include "island/IslandState.hpp"
#include "island/StabilitySums.hpp"
#include "system/StepReport.hpp"

#include <vector>

namespace dem
{

//- What a look has found
struct Survey
{
    double step = 0;            // contact step that is allowed [s]
    double period = 0;          // shortest of all contacts [s]
    double bound = 0;           // stability bound [s]
    double springLead = 0.5;    // share of a step by which springs are to be ahead
    double strongest = 0;       // acceleration [m/s2]
    bool deep = false;          // an overlap comes near what laws cover
};

class ContactSurvey
{
public:

    explicit ContactSurvey(const Environment& environment) : env_(environment) {}

    //- The longest contact step over the shortest period: the bound of one contact is 2/omega
    double longestStep() const;

    //- Look at all; false: there is no contact, and only `strongest` and `deep` are new.
    //  looks: contact steps until the next one; dense: in an island of many.
    //  Errors: numericalError, at `time` [s]
    bool look
    (
        IslandState& state, const Candidates& candidates, int looks, bool dense, double time,
        StepReport& report
    );

    const Survey& last() const { return last_; }

    //- At the start of a run
    void forget() { last_ = {}; }

    //- Stability bound of the contacts as they are, with nothing foreseen [s]
    double boundNow(const IslandState& state);


private:

    //- How a contact moves
    struct Approach
    {
        double smaller;     // radius of the two [m]
        double speed;       // along the normal, either way [m/s]
        double pressing;    // acceleration that presses it [m/s2]
    };

    //- A contact at its stiffest until the next look
    struct Stiffest
    {
        ContactBound bound;
        double gained;      // speed that what presses gives to it [m/s]
    };

    //- Of all contacts
    struct Extremes
    {
        double period = 1e300, path = 1e300, slipTime = 1e30, turnTime = 1e30;
    };

    void findAccelerations(const IslandState& state);
    Approach approach(const IslandState& state, const ContactList& list, std::size_t k) const;
    void check
    (
        const IslandState& state, const ContactList& list, std::size_t k, const Approach& a,
        double time, StepReport& report
    ) const;
    ContactBound boundAt
    (
        const IslandState& state, std::size_t law, const ContactList& list, std::size_t k,
        double overlap, double speed
    ) const;
    Stiffest exactBound
    (
        const IslandState& state, std::size_t law, const ContactList& list, std::size_t k,
        const Approach& a, double ahead
    ) const;
    Stiffest denseBound
    (
        IslandState& state, std::size_t law, const ContactList& list, std::size_t k,
        const Approach& a, double ahead
    ) const;
    [[noreturn]] void failBound(const IslandState& state, double time) const;

    const Environment& env_;
    Survey last_;
    StabilitySums sums_;
    std::vector<Vec3> accelerations_;
};

}
