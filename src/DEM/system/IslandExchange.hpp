// SPDX-License-Identifier: GPL-3.0-or-later
//
// What crosses ranks within one particle step: who is shown to others, how the components of
// several ranks become one, and the particles of such a component on their way to the rank
// that moves it, and back.
#pragma once

#include "contacts/ContactRecord.hpp"
#include "parallel/Communicator.hpp"
#include "system/Component.hpp"
#include "system/Reach.hpp"
#include "system/StepReport.hpp"

#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace dem
{

//- One particle with all that is remembered of it, as it travels between ranks
struct Member
{
    Particle p = {};
    GasLoad gas;
    RestState rest;
    std::vector<ContactRecord> contacts;
    bool pushed = false;        // off the path that it has on its own
    Corridor corridor;
    double outran = 0;          // when moved: how fast it has left that [m/s]; 0: it has not
    bool rim = false;           // at rest, and must not wake: who is beyond it is not here
    bool seen = false;          // only looked at, for its contacts with the rim
    bool woke = false;          // when moved: it is the rim, and would have woken
    std::int64_t component = 0;
    int owner = 0;
    std::size_t index = 0;      // on its owner
    GasExchange exchange = {};
    double delay = 0;           // it enters that long after the particle step has begun [s];
                                // negative, when moved too: ParticleStore::delay
    std::vector<WallImpact> impacts;  // when moved

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.p);
        f(s.gas);
        f(s.rest);
        f(s.contacts);
        f(s.pushed);
        f(s.corridor.v);
        f(s.corridor.near);
        f(s.corridor.from);
        f(s.corridor.away);
        f(s.outran);
        f(s.rim);
        f(s.seen);
        f(s.woke);
        f(s.component);
        f(s.owner);
        f(s.index);
        f(s.exchange);
        f(s.delay);
        f(s.impacts);
    }
};

//- A particle that others may meet, and the component of its rank that it belongs to
struct Shown
{
    std::int64_t id = 0;        // of the particle
    Box box = {Vec3::Zero(), Vec3::Zero()};
    Path path;                  // its place, corridor, size, hit and rigid body
    Component component;

    template<class S, class F>
    static void fields(S& s, F& f)
    {
        f(s.id);
        f(s.box.low);
        f(s.box.high);
        f(s.path.x);
        f(s.path.corridor.v);
        f(s.path.corridor.near);
        f(s.path.corridor.from);
        f(s.path.corridor.away);
        f(s.path.size);
        f(s.path.hit);
        f(s.path.rigid);
        f(s.path.open);
        f(s.component);
    }
};

//- Particles (ids) of two ranks that have been found to be able to meet in this particle step.
//  As within a rank they stay together, though corridors that are set anew may part them again:
//  else it would matter which rank they are of, and who joins and parts in turn would go on
//  for ever.
using Ties = std::vector<std::pair<std::int64_t, std::int64_t>>;

//- Components as joined over ranks, by the ids that they have on their own ranks
class JoinedComponents
{
public:

    //- Who can meet whom of another rank. shown: by rank, among them all of `ties`, to which
    //  what is new is added; when one can first be hit is taken down in its path. The same on
    //  every rank.
    JoinedComponents
    (
        std::vector<std::vector<Shown>>& shown, Ties& ties, double dt, const Periodic& periodic
    );

    //- What the component with this id on its own rank has become; nullptr: it was not shown,
    //  or has met nobody
    const Component* find(std::int64_t id) const;

private:

    std::int64_t root(std::int64_t id) const;
    bool join(std::int64_t a, std::int64_t b);

    std::map<std::int64_t, Component> components_;
    std::map<std::int64_t, std::int64_t> parent_;
};

class IslandExchange
{
public:

    explicit IslandExchange(const Communicator& communicator) : communicator_(communicator) {}

    //- The boxes about all particles of each rank, from that of this one; the low end is above
    //  the high end where there are none. Collective.
    std::vector<Box> domains(const Box& mine) const;

    //- What every rank shows, by rank. Collective.
    std::vector<std::vector<Shown>> everybody(const std::vector<Shown>& mine) const;

    //- The largest speed of each shared component over all ranks. Collective.
    void shareFastest(std::vector<Component>& components) const;

    //- Send the members toRank[r] to rank r; what has come from the others, by rank. Collective.
    std::vector<Member> exchange(const std::vector<std::vector<Member>>& toRank) const;

private:

    const Communicator& communicator_;
};

}
