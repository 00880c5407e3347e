// SPDX-License-Identifier: GPL-3.0-or-later
//
// The particles of this rank: one column per thing that is remembered of them between particle
// steps. Plain values; indices stay valid until remove().
#pragma once

#include "contacts/ContactRecord.hpp"
#include "particles/GasExchange.hpp"
#include "particles/GasLoad.hpp"
#include "particles/Particle.hpp"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace dem
{

struct ParticleStore
{
    std::vector<Particle> particles;
    std::vector<GasLoad> gas;               // of the next advance()
    std::vector<RestState> rest;
    std::vector<GasExchange> exchange;      // of the last advance()
    std::vector<double> reach;              // of its contacts beyond touch [m]
    std::vector<std::vector<ContactRecord>> contacts;   // as the lower partner
    std::unordered_map<std::int64_t, std::size_t> indexOf;
    std::unordered_map<std::int64_t, double> entering;      // by id, see delay()

    std::size_t size() const { return particles.size(); }

    //- Errors: inputError where there is no such particle
    std::size_t checked(std::size_t i) const;

    //- Errors: inputError on an id that makes no sense or is there already, and on numbers that
    //  are not finite
    std::size_t add(const Particle& p, double reach, double delay = 0);

    //- It enters that long after the next advance() has begun [s]
    double delay(std::size_t i) const
    {
        if (entering.empty()) return 0;
        const auto found = entering.find(particles[i].id);
        return found == entering.end() ? 0 : found->second;
    }

    //- Change the motion from outside; its cluster wakes. Errors: inputError where not finite
    void setMotion(std::size_t i, const Vec3& x, const Vec3& v, const Vec3& omega);

    //- Drop the marked ones, close the gaps, keep the order
    void remove(const std::vector<char>& marked);

    //- A member of a rigid aggregate
    bool flies(std::size_t i) const { return rest[i].aggregate >= 0; }

    //- Whether it moves in the next particle step
    bool awake(std::size_t i) const;


    // The contacts and the rest state of a particle, as numbers that begin with their version

        //- Empty if there is nothing to remember
        std::vector<double> packState(std::size_t i) const;

        //- See System::unpackState; nWalls: how many patches there are
        std::vector<int> unpackState
        (
            std::size_t i,
            const std::vector<double>& state,
            const std::vector<int>& wallNow,
            int nWalls
        );
};

}
