// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds, for one particle step, who can meet whom:
//
//     finder.begin(dt);
//     do while (!finder.settled(dt)); while (!moved);
//
// First by the paths that the awake have on their own; then whoever can be pushed may become as
// fast as the fastest of its component, and hit others, until nobody is added. Who then is in no
// component of two or more, and is pushed by nothing, flies freely.
//
// Of those at rest only they take part whom one who moves can meet. If that is one awake, it may
// wake and is open; if it is one at rest, it is the rim, on which a component ends: it stays
// where it is. Where the rim turns out to be woken it is opened, and what it can meet is added,
// shell by shell. What the rim rests on is looked up when the island is moved (Seen).
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

//- One at rest that touches the rim of a component
struct Seen
{
    std::size_t particle;
    std::int64_t component;
    int home;               // rank that moves the component

    bool operator==(const Seen& o) const
    {
        return component == o.component && particle == o.particle;
    }
    bool operator<(const Seen& o) const
    {
        return component < o.component || (component == o.component && particle < o.particle);
    }
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

    //- Paths of those who move, for a new particle step
    void begin(double dt);

    //- One round. True: nobody is added any more, on any rank. Collective.
    bool settled(double dt);

    //- Particle i, moved at last, has left its corridor, on average by `outran` [m/s]
    void widen(std::size_t i, double outran);

    //- Particle i, of the rim, would have woken
    void open(std::size_t i);

    //- Of particle i, which takes part
    const Path& path(std::size_t i) const { return paths_[std::size_t(slot_[i])]; }

    //- Those who can meet somebody, or are pushed, and the label of each
    const std::vector<std::size_t>& crowd() const { return crowdParticles_; }
    const std::vector<Label>& labels() const { return labels_; }

    //- Of the awake, those who are not in the crowd
    std::vector<std::size_t> alone() const;

    //- What the rims of all ranks touch of the particles of this rank
    std::vector<Seen> seen() const;


private:

    //- At rest, on another rank or this, and not to wake; the component that it is of
    struct Rim
    {
        Path path;
        std::int64_t component;
        int home;
    };

    Box& box(std::size_t k)
    {
        return k < awake_ ? boxes_[k] : addedBoxes_[k - awake_];
    }
    bool flies(std::size_t k) const { return store_.flies(who_[k]); }

    void findPairs(double dt);
    bool known(std::size_t a, std::size_t b);
    void consider(std::size_t a, std::size_t b, double dt);
    std::size_t add(std::size_t i, const Path& path, double dt);
    void askResting(std::size_t k, double dt);
    void tie(std::size_t a, std::size_t b);
    void addToCrowd(std::size_t k);

    bool label(double dt);
    std::vector<std::size_t> collect();
    Component single(std::size_t k) const;
    std::vector<std::size_t> reachingOthers();
    bool joinOverRanks
    (
        const std::vector<std::size_t>& shown, const std::vector<std::size_t>& ofShown, double dt
    );
    bool addFor(Path& moving, const Box& box, double dt);
    void setSpeeds(const std::vector<std::size_t>& componentOf);
    void see(const Rim& rim, std::vector<Seen>& result) const;

    std::vector<std::size_t> widened(double dt);
    void ask(std::vector<std::size_t> asked, double dt);
    void oneIsland();

    const ParticleStore& store_;
    const Periodic& periodic_;
    const Communicator& communicator_;
    Reach reach_;
    IslandExchange exchange_;
    Ties ties_;                         // of this particle step, the same on every rank
    bool islands_;

    // Those who take part: first the awake, by index, then of those at rest whom they can meet
    std::vector<std::size_t> who_;      // particles
    std::vector<int> slot_;             // by particle: where in who_; -1 = not there
    std::size_t awake_ = 0;             // how many
    std::vector<Path> paths_;
    std::vector<Box> boxes_, addedBoxes_;   // of the awake, of those at rest
    BoxGrid grid_, addedGrid_;              // of these
    DisjointSets sets_;                 // of those who can meet, on this rank
    std::vector<int> crowdAt_;          // where in the crowd; -1 = not there

    std::vector<std::size_t> crowd_;            // of who_
    std::vector<std::size_t> crowdParticles_;   // the same, as particles
    std::vector<Component> components_;
    std::vector<Label> labels_;
    std::vector<Rim> rimElsewhere_;     // as shown by other ranks
    std::vector<std::size_t> ofRoot_;   // all 0 between calls
    std::size_t outside_ = 0;           // who is not in the largest component of this rank
};

}
