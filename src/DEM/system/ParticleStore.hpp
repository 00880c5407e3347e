// SPDX-License-Identifier: GPL-3.0-or-later
//
// The particles of this rank: one column per thing that is remembered of them between particle
// steps. Plain values; indices stay valid until remove(). Whoever changes the place, the gas load
// or the rest of a particle says so by changed(), so that a particle step finds who moves, and
// counts of all, without looking at those who rest.
#pragma once

#include "contacts/ContactRecord.hpp"
#include "particles/GasExchange.hpp"
#include "particles/GasLoad.hpp"
#include "particles/Particle.hpp"
#include "system/RestIndex.hpp"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace dem
{

struct ParticleStore
{
    //- Of the particles of this rank
    struct Counts
    {
        std::int64_t resting = 0, flyingAtRest = 0, inContact = 0;
    };

    std::vector<Particle> particles;
    std::vector<GasLoad> gas;               // of the next advance()
    std::vector<RestState> rest;
    std::vector<GasExchange> exchange;      // of the last advance() in which it moved
    std::vector<double> reach;              // of its contacts beyond touch [m]
    std::vector<std::vector<ContactRecord>> contacts;   // as the lower partner
    std::unordered_map<std::int64_t, std::size_t> indexOf;
    std::unordered_map<std::int64_t, double> delays;        // by id, see delay()
    double behind = 0;                      // the most of all ranks, see delay() [s]
    RestIndex index;                        // who moves, who rests
    std::vector<std::size_t> moved;         // who took part in the last advance(), in any order
    Counts counts;

    std::size_t size() const { return particles.size(); }

    //- Errors: inputError where there is no such particle
    std::size_t checked(std::size_t i) const;

    //- Errors: inputError on an id that makes no sense or is there already, and on numbers that
    //  are not finite
    std::size_t add(const Particle& p, double reach, double delay = 0);

    //- It enters that long after the next advance() has begun [s]; negative: it stands where it
    //  was that long before, at a touch that is still to come (Island::run)
    double delay(std::size_t i) const
    {
        if (delays.empty()) return 0;
        const auto found = delays.find(particles[i].id);
        return found == delays.end() ? 0 : found->second;
    }

    //- Change the motion from outside; its cluster wakes. Errors: inputError where not finite
    void setMotion(std::size_t i, const Vec3& x, const Vec3& v, const Vec3& omega);

    //- Drop the marked ones, close the gaps, keep the order
    void remove(const std::vector<char>& marked);

    //- A member of a rigid aggregate
    bool flies(std::size_t i) const { return rest[i].aggregate >= 0; }

    //- Whether it moves in the next particle step
    bool awake(std::size_t i) const;

    //- Place, gas load or rest of particle i are other ones now
    void changed(std::size_t i);

    //- The load is checked already
    void setGas(std::size_t i, const GasLoad& load);

    // What the gas gave in the last particle step, until the gas loads are set anew. Of those who
    // rested all the time it follows from their loads.

        //- A particle step of dt [s] begins
        void began(double dt);

        //- Of particle i, which has moved
        void give(std::size_t i, const GasExchange& exchange);

        const GasExchange& gasExchange(std::size_t i);



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


private:

    void count(std::size_t i);

    double step_ = 0;                       // [s] the last one
    std::uint32_t steps_ = 0;               // how many began
    std::vector<std::uint32_t> exchanged_;  // by particle: exchange is of this one
    std::vector<char> counted_;             // by particle: as what, one bit of each of counts
};

}
