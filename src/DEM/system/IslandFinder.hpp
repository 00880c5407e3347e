// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds, for one particle step, who can meet whom:
//
//     finder.begin(dt);
//     do while (!finder.settled(dt)); while (!moved);
//
// First by the paths that all have on their own; then whoever can be pushed may become as fast
// as the fastest of its component, and hit others, until nobody is added. Who then is in no
// component of two or more, and is pushed by nothing, flies freely.
#pragma once

#include "neighbourSearch/BoxGrid.hpp"
#include "neighbourSearch/DisjointSets.hpp"
#include "system/IslandExchange.hpp"
#include "system/Reach.hpp"

#include <vector>

namespace dem
{

//- Of all that a particle can meet
struct Label
{
    std::int64_t component; // lowest id
    Crowd crowd;
    bool active;            // some member is awake
    bool shared;            // spans ranks
    bool alone;             // one particle or rigid aggregate that nothing pushes off its path
    int home;               // rank that moves it
};

class IslandFinder
{
public:

    //- Nothing is copied. islands: false: all are one island, always
    IslandFinder
    (
        const ParticleStore& store, const WallSearch& walls, const Periodic& periodic,
        const Communicator& communicator, bool islands
    );

    //- Paths of all for a new particle step
    void begin(double dt);

    //- One round. True: nobody is added any more, on any rank. Collective.
    bool settled(double dt);

    //- Particle i, moved at last, has left its corridor, on average by `outran` [m/s]
    void widen(std::size_t i, double outran);

    const Path& path(std::size_t i) const { return paths_[i]; }

    //- Those who can meet somebody, or are pushed, and the label of each
    const std::vector<std::size_t>& crowd() const { return crowd_; }
    const std::vector<Label>& labels() const { return labels_; }
    bool crowded(std::size_t i) const { return crowded_[i]; }


private:

    void findPairs(double dt);
    void addToCrowd(std::size_t i);
    bool known(std::size_t i, std::size_t j);

    void label(double dt);
    std::vector<std::size_t> collect();
    Component alone(std::size_t i) const;
    void joinOverRanks
    (
        const std::vector<std::size_t>& shown, const std::vector<std::size_t>& ofShown, double dt
    );
    void setSpeeds(const std::vector<std::size_t>& componentOf);

    std::vector<std::size_t> widened(double dt);
    void ask(std::vector<std::size_t> asked, double dt);
    void oneIsland();

    const ParticleStore& store_;
    const Periodic& periodic_;
    const Communicator& communicator_;
    Reach reach_;
    IslandExchange exchange_;
    bool islands_;

    std::vector<Path> paths_;
    std::vector<Box> boxes_;
    BoxGrid grid_;                      // of boxes_
    DisjointSets sets_;                 // of those who can meet, on this rank
    std::vector<std::size_t> crowd_;
    std::vector<char> crowded_;         // by particle: it is one of them
    std::vector<Component> components_;
    std::vector<Label> labels_;
    std::vector<std::size_t> ofRoot_;   // all 0 between calls
    std::size_t outside_ = 0;           // who is not in the largest component of this rank
};

}
