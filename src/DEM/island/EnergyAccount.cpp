// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/EnergyAccount.hpp"

namespace dem
{

namespace
{

//- Of those awake [J], at the velocities `v` and `w` of a Body or Motion
template<class Moving>
double kinetic(const IslandState& state, const std::vector<Moving>& moving)
{
    double sum = 0;
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        const Particle& p = state.particles[k];
        const Moving& m = moving[k];
        sum += 0.5*(p.mass*vec(m.v).squaredNorm() + inertia(p)*vec(m.w).squaredNorm());
    }
    return sum;
}

}


ContactEnergy EnergyAccount::energyOf
(
    const IslandState& state, std::size_t law, const ContactList& list, std::size_t k
) const
{
    return env_.law(law).energy
    (
        list, k, state.bodies.data(), state.phase.ahead, env_.periodic
    );
}


//- Power of the normal dashpot in the middle of a step [W]: it is too curved where it begins
//  for the trapezoidal rule. Of an oscillation w the path over h gives a velocity that is
//  too large by (w h)^2/8, the mean of the velocities one that is as much too small.
double EnergyAccount::dashpotBetween
(
    std::size_t law, const ContactList& list, std::size_t k,
    const ContactEnergy& before, const ContactEnergy& after, double h
) const
{
    double c[maxConstants], history[maxHistory];
    for (std::size_t a = 0; a < list.constants.size(); ++a) c[a] = list.constants[a][k];
    for (std::size_t a = 0; a < list.history.size(); ++a) history[a] = list.history[a][k];
    const double overlap =
        0.5*(before.overlap + after.overlap) + h/8*(before.closing - after.closing);
    const double closing =
        0.5*(after.overlap - before.overlap)/h + 0.25*(before.closing + after.closing);
    return env_.law(law).normalResponse(c, overlap, history).damping*closing*closing;
}


void EnergyAccount::open(const IslandState& state, double h, EnergyLedger& ledger)
{
    if (!on_) return;
    ledger.kinetic -= kinetic(state, state.bodies);
    kicked_.resize(state.particles.size());
    for (const int i : state.awake)
    {
        const std::size_t k = std::size_t(i);
        const Body& b = state.bodies[k];
        const Load& l = state.loads[k];
        for (int d = 0; d < 3; ++d)
        {
            kicked_[k].v[d] = b.v[d] + 0.5*h*b.invM*l.f[d];
            kicked_[k].w[d] = b.w[d] + 0.5*h*b.invI*l.t[d];
        }
    }
    ledger.gas -= kinetic(state, kicked_);

    energies_.resize(state.contacts.entries.size());
    state.contacts.each([&](std::size_t l, const ContactList& list, std::size_t k)
    {
        energies_[std::size_t(list.tag[k])] = energyOf(state, l, list, k);
    });
}


//- Gas and body forces work in the flight only
void EnergyAccount::drifted(const IslandState& state, EnergyLedger& ledger) const
{
    if (on_) ledger.gas += kinetic(state, state.motion);
}


void EnergyAccount::closeContact
(
    std::size_t law, const ContactList& list, std::size_t k,
    const ContactEnergy& before, const ContactEnergy& after, double h, EnergyLedger& ledger
) const
{
    const double sign = env_.law(law).elastic() ? 1 : -1;
    ledger.normal += after.normal.stored - before.normal.stored;
    ledger.plastic += after.normal.plastic - before.normal.plastic;
    ledger.dashpots +=
        0.5*h*(before.dashpots + after.dashpots)
      + h/6
       *(
            before.normalDashpot + after.normalDashpot
          + 4*dashpotBetween(law, list, k, before, after, h)
        );
    for (int s = 0; s < 3; ++s)
    {
        const SpringEnergy& a = before.springs[s];
        const SpringEnergy& b = after.springs[s];
        const double change = b.stored() - a.stored();
        const double gain =
            0.25*sign*(a.square + b.square)*(b.stiffness - a.stiffness)
          + 0.5*h*(a.gain + b.gain);
        ledger.springs += change;
        ledger.springGain += gain;
        if (a.yields || b.yields)
        {
            ledger.yield += 0.5*h*(a.input + b.input) + gain - change;
        }
    }
}


void EnergyAccount::close(const IslandState& state, double h, EnergyLedger& ledger) const
{
    if (!on_) return;
    ledger.kinetic += kinetic(state, state.bodies);
    state.contacts.each([&](std::size_t l, const ContactList& list, std::size_t k)
    {
        closeContact
        (
            l, list, k, energies_[std::size_t(list.tag[k])], energyOf(state, l, list, k), h,
            ledger
        );
    });
}


void EnergyAccount::began
(
    const IslandState& state, std::size_t law, const ContactList& list, std::size_t k,
    EnergyLedger& ledger
) const
{
    ledger.normal += energyOf(state, law, list, k).normal.stored;
}


void EnergyAccount::ended(const IslandState& state, EnergyLedger& ledger) const
{
    if (!on_) return;
    for (std::size_t l = 0; l < state.contacts.lists.size(); ++l)
    {
        const ContactStore::Lists& lists = state.contacts.lists[l];
        for (const ContactList* list : {&lists.pairs, &lists.walls})
        {
            for (std::size_t k = list->size(); k-- > 0;)
            {
                if (!list->ended[k]) continue;
                const ContactEnergy e = energyOf(state, l, *list, k);
                ledger.normal -= e.normal.stored;
                ledger.springs -= e.inSprings();
                ledger.released += e.normal.stored + e.inSprings();
            }
        }
    }
}


void EnergyAccount::rested(double energy, EnergyLedger& ledger) const
{
    if (!on_) return;
    ledger.kinetic -= energy;
    ledger.rest += energy;
}

}
