// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contacts/ContactStore.hpp"
#include "island/IslandState.hpp"
#include "timeIntegration/contactPeriod.hpp"

#include <vector>

namespace dem
{

//- The stability bound of an island, from the bounds of its contacts (contactPeriod.hpp)
class StabilitySums
{
public:

    //- Of all contacts of one particle, or of two in contact over their masses
    struct Sums
    {
        double stiffness = 0, damping = 0;
        double rolling = 0, rollingDamping = 0;
        double twisting = 0, twistingDamping = 0;

        //- If these are the most of all [s]
        double bound() const
        {
            return stabilityBound
            (
                stiffness + rolling + twisting, damping + rollingDamping + twistingDamping
            );
        }
    };

    void reset(std::size_t nParticles) { sums_.assign(nParticles, {}); }

    //- Of one contact. Not inline: with g++ 12 wide registers would stay in use over the loop of
    //  ContactSurvey, which makes calls of the C library slow
    void add(Partners p, const ContactBound& b);

    //- No mode is faster than the fastest of these sums
    Sums most(const IslandState& state) const;


private:

    std::vector<Sums> sums_;    // by particle
};

}
