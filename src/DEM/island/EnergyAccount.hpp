// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the mechanical energy of an island goes (EnergyLedger.hpp): kinetic energy from the
// motion, stored energies from the closed forms of the laws, dissipated ones from powers by
// quadrature over each contact step. All functions want the velocities of the step's end; without
// timeIntegration { energyLedger on; } they do nothing.
#pragma once

#include "island/Environment.hpp"
#include "island/IslandState.hpp"
#include "system/EnergyLedger.hpp"

#include <vector>

namespace dem
{

class EnergyAccount
{
public:

    explicit EnergyAccount(const Environment& environment)
    :
        env_(environment),
        on_(environment.time.energyLedger)
    {}

    bool on() const { return on_; }

    //- Before a step of h, after the drift, which the gas has worked in, and at the end
    void open(const IslandState& state, double h, EnergyLedger& ledger);
    void drifted(const IslandState& state, EnergyLedger& ledger) const;
    void close(const IslandState& state, double h, EnergyLedger& ledger) const;

    //- A contact that has begun stores this
    void began
    (
        const IslandState& state, std::size_t law, const ContactList& list, std::size_t k,
        EnergyLedger& ledger
    ) const;

    //- The contacts marked as ended release what they store
    void ended(const IslandState& state, EnergyLedger& ledger) const;

    //- Kinetic energy that rest takes [J]
    void rested(double energy, EnergyLedger& ledger) const;


private:

    ContactEnergy energyOf
    (
        const IslandState& state, std::size_t law, const ContactList& list, std::size_t k
    ) const;
    double dashpotBetween
    (
        std::size_t law, const ContactList& list, std::size_t k,
        const ContactEnergy& before, const ContactEnergy& after, double h
    ) const;
    void closeContact
    (
        std::size_t law, const ContactList& list, std::size_t k,
        const ContactEnergy& before, const ContactEnergy& after, double h,
        EnergyLedger& ledger
    ) const;

    const Environment& env_;
    bool on_;
    std::vector<Motion> kicked_;            // after the first kick of the contact forces
    std::vector<ContactEnergy> energies_;   // by tag, before the step
};

}
