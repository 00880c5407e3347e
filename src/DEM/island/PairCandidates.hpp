// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs that can come into contact in this run. Candidates are pairs whose boxes overlap. In an
// island of many the boxes are little more than the path that each has on its own, and grow when
// a particle leaves that. A candidate is looked at again when the fastest particle has gone half
// of its gap.
#pragma once

#include "island/Contacts.hpp"
#include "island/Corridor.hpp"
#include "island/Environment.hpp"
#include "island/IslandState.hpp"
#include "neighbourSearch/BoxGrid.hpp"

#include <memory>
#include <vector>

namespace dem
{

//- How far, beyond touch, what is near is known
struct Skin
{
    double width = 0;       // [m]
    double path = 0;        // [m] that the fastest at each time has made in this run
    double refreshed = 0;   // [m] path when what is near was last looked for

    //- Whether what is near holds after a further way of all [m]
    bool holds(double further = 0) const
    {
        return !(2*(path + further - refreshed) > 0.5*width);
    }
};

//- Two that can touch, i < j
struct Candidate
{
    int i, j;
    bool touching;
    double touch;       // contact begins at this gap of the surfaces [m]
};

class PairCandidates
{
public:

    explicit PairCandidates(const Environment& environment) : env_(environment) {}

    //- All of a run of dt
    void find(const IslandState& state, const std::vector<Corridor>& corridors, double dt);

    //- Look for more candidates of those that leave their boxes in a flight over `time`
    void keepInBoxes(const IslandState& state, const Skin& skin, double time);

    //- Find those within the skin
    void refresh(const IslandState& state, const Skin& skin);

    //- A stored contact is always among the candidates
    void touching(const IslandState& state, const std::vector<Partners>& pairs);
    //- What is stored between two at rest
    void touchingAtRest(const IslandState& state);
    //- Contacts that have ended, as of which they may begin again
    void parted
    (
        const IslandState& state, const std::vector<Partners>& pairs, const Skin& skin
    );

    //- These have woken, or some have fallen asleep
    void woken(const IslandState& state, const std::vector<int>& woken, const Skin& skin);
    void asleep(const IslandState& state);

    //- Those near whose surfaces have met; from now on they count as touching
    void meet(const IslandState& state, const Skin& skin, std::vector<Touch>& touches);

    const std::vector<Candidate>& all() const { return list_; }

    //- f(candidate) for each one within the skin
    template<class F>
    void eachNear(F&& f) const
    {
        for (const Near& n : near_) f(list_[std::size_t(n.candidate)]);
    }

    //- Distance of the surfaces beyond where the contact begins [m]
    double gap(const IslandState& state, const Candidate& c) const
    {
        const Body& a = state.bodies[std::size_t(c.i)];
        const Body& b = state.bodies[std::size_t(c.j)];
        return env_.periodic.nearest(vec(b.x) - vec(a.x)).norm() - a.r - b.r - c.touch;
    }

    //- Skin::path before which candidate c cannot touch [m]
    double due(std::size_t c) const { return due_[c]; }


private:

    //- A candidate within the skin, and the path up to which it need not be looked at
    struct Near
    {
        int candidate;
        double due;
    };

    void setBoxes
    (
        const IslandState& state, const std::vector<Corridor>& corridors, double dt
    );
    void add(const IslandState& state, int i, int j);
    void widen(const IslandState& state, int i, const Box& path);
    std::size_t find(const IslandState& state, int i, int j) const;
    bool meets(const IslandState& state, const Candidate& c) const;
    bool comesNear(const IslandState& state, std::size_t c, const Skin& skin);

    const Environment& env_;
    std::vector<Box> boxes_;                // that the particles stay within, surfaces included
    std::vector<char> whole_;               // by particle: its box holds all of its corridor
    std::unique_ptr<BoxGrid> grid_;         // of boxes_; none for few particles
    std::vector<Candidate> list_;
    std::size_t sorted_ = 0;                // so many of them by i, then j
    std::vector<double> due_;               // by candidate
    std::vector<Near> near_;
    std::vector<char> marked_;              // scratch, all 0 between calls
};

}
