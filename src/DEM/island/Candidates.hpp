// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can come into contact, found again as the island moves. All of it follows from the state
// and the corridors; nothing here is part of the state.
#pragma once

#include "island/PairCandidates.hpp"
#include "island/WallCandidates.hpp"

#include <optional>
#include <vector>

namespace dem
{

class Candidates
{
public:

    explicit Candidates(const Environment& environment)
    :
        pairs_(environment),
        walls_(environment)
    {}

    // Loading, particle by particle

        void clear();
        void addParticle(const Corridor& corridor);
        void addSurfaces(const std::vector<int>& surfaces) { walls_.addSurfaces(surfaces); }


    //- Of a run of dt; `resumed` are in contact
    void find(const IslandState& state, double dt, const std::vector<Partners>& resumed);

    //- Find what is near: to be called when the contact step [s], if it is known, has changed
    //  much, and at the start, when Phase::fastest is a bound
    void refresh(IslandState& state, std::optional<double> contactStep);
    //- The same only if what is near does not hold after a further step of h
    void look(IslandState& state, double h, std::optional<double> contactStep);

    //- Particles have moved over a step of h
    void follow(IslandState& state, double h, std::optional<double> contactStep);

    //- Before a step of h
    void expect(const IslandState& state, double h);

    //- Before a flight that may last to the end
    void keepInBoxes(const IslandState& state, double time)
    {
        pairs_.keepInBoxes(state, skin_, time);
    }

    //- Surfaces that have met without a contact yet; from now on they count as in contact
    std::vector<Touch> meet(const IslandState& state);

    //- These contacts have ended
    void parted(const IslandState& state, const std::vector<Partners>& pairs)
    {
        pairs_.parted(state, pairs, skin_);
    }

    //- These have woken, and with them contacts of these pairs; or some have fallen asleep
    void woken
    (
        IslandState& state, const std::vector<int>& woken,
        const std::vector<Partners>& resumed
    );
    void asleep(const IslandState& state);

    //- Give the places where they meet the walls to the contacts
    void updateWalls(IslandState& state) { walls_.update(state, skin_.width); }

    //- Take down how fast the particles have left their corridors
    void noteOutran(const IslandState& state);
    //- On average since the start [m/s]; 0: it has not
    double outran(std::size_t i) const { return outran_[i]; }

    const PairCandidates& pairs() const { return pairs_; }
    const WallCandidates& walls() const { return walls_; }
    const Skin& skin() const { return skin_; }
    double smallest() const { return smallest_; }


private:

    PairCandidates pairs_;
    WallCandidates walls_;
    std::vector<Corridor> corridors_;
    std::vector<double> outran_;    // [m/s]
    Skin skin_;
    double smallest_ = 0;           // [m] radius
};

}
