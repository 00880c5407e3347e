// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/StabilitySums.hpp"

#include <algorithm>

namespace dem
{

void StabilitySums::add(Partners partners, const ContactBound& b)
{
    for (const int p : {partners.i, partners.j})
    {
        if (p < 0) continue;
        Sums& s = sums_[std::size_t(p)];
        s.stiffness += b.stiffness;
        s.damping += b.damping;
        s.rolling += b.rolling;
        s.rollingDamping += b.rollingDamping;
        s.twisting += b.twisting;
        s.twistingDamping += b.twistingDamping;
    }
}


StabilitySums::Sums StabilitySums::most(const IslandState& state) const
{
    Sums most;
    state.contacts.each([&](std::size_t, const ContactList& list, std::size_t k)
    {
        Sums both;
        const Partners partner = partners(list, k);
        for (const int p : {partner.i, partner.j})
        {
            if (p < 0) continue;
            const Sums& s = sums_[std::size_t(p)];
            const Body& body = state.bodies[std::size_t(p)];
            const double turns = body.r*body.invI;
            both.stiffness += s.stiffness*body.invM;
            both.damping += s.damping*body.invM;
            both.twisting += s.twisting*body.invI;
            both.twistingDamping += s.twistingDamping*body.invI;
            most.rolling = std::max(most.rolling, s.rolling*turns);
            most.rollingDamping = std::max(most.rollingDamping, s.rollingDamping*turns);
        }
        most.stiffness = std::max(most.stiffness, both.stiffness);
        most.damping = std::max(most.damping, both.damping);
        most.twisting = std::max(most.twisting, both.twisting);
        most.twistingDamping = std::max(most.twistingDamping, both.twistingDamping);
    });
    return most;
}

}
