// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the particles of an island meet the walls, and which of these places continues which
// contact: of the patch of the contact, the one whose normal has turned least, by less than 60
// degrees. Where the patch has none any more, as the particle has come to where another patch of
// the same surface is nearer (at their joint, about the free edge of a baffle), the contact goes
// on with that one: neither its force nor what its springs hold is interrupted. Between patches
// with different laws it ends, and another one begins.
#pragma once

#include "island/Contacts.hpp"
#include "island/Environment.hpp"
#include "island/IslandState.hpp"
#include "walls/WallSearch.hpp"

#include <vector>

namespace dem
{

class WallCandidates
{
public:

    explicit WallCandidates(const Environment& environment) : env_(environment) { clear(); }

    // Loading

        void clear();
        void addParticle() { surfaceEnd_.push_back(surfaces_.size()); }
        //- Surfaces that the last particle can reach in this run
        void addSurfaces(const std::vector<int>& surfaces);


    //- Find the surfaces within the skin [m] of the awake
    void refresh(const IslandState& state, double skin);

    //- These have woken, or some have fallen asleep
    void woken(const IslandState& state, const std::vector<int>& woken, double skin);
    void asleep(const IslandState& state);

    //- Find where the awake particles meet the walls now and give that to their contacts
    void update(IslandState& state, double skin);

    //- Places where surfaces have met and there is no contact yet; from now on there is
    void meet(const IslandState& state, std::vector<Touch>& touches);

    //- f(i, hit, gap) for each place within the skin without a contact; gap [m] beyond where
    //  the contact begins
    template<class F>
    void eachFree(const IslandState& state, F&& f) const
    {
        for (const int i : near_)
        {
            const std::size_t k = std::size_t(i);
            for (std::size_t c = 0; c < hits_[k].size(); ++c)
            {
                if (taken_[k][c]) continue;
                const WallHit& hit = hits_[k][c];
                f(i, hit, hit.distance - state.bodies[k].r - touch(state, i, hit.patch));
            }
        }
    }

    //- The place that continues a wall contact of particle i with this patch and normal; null:
    //  none. Of one at rest, too.
    const WallHit* continues
    (
        const IslandState& state, int i, int patch, const Vec3& n,
        std::vector<WallHit>& scratch
    ) const;

    //- Earliest time [s] in which particle i could come to touch, by its free flight
    double timeToTouch(const IslandState& state, int i) const;

    //- Whether within a flight of `way` [m] there can be a surface that is not near yet
    bool mayReach(const IslandState& state, int i, double way, double skin) const;


private:

    std::size_t first(std::size_t k) const { return k ? surfaceEnd_[k - 1] : 0; }
    double touch(const IslandState& state, int i, int patch) const
    {
        const int m = state.particles[std::size_t(i)].material;
        return touch_[std::size_t(m)][std::size_t(patch)];
    }
    void findNear(const IslandState& state, int i, double skin);
    bool findHits(const IslandState& state, double skin);
    int alike(const ContactList& list, std::size_t k, bool anyPatch) const;
    void follow(const IslandState& state, ContactList& list, std::size_t k, int hit);
    void followElsewhere(IslandState& state);

    //- A contact whose patch has no place for it any more
    struct Lost { std::size_t law, k; };

    const Environment& env_;
    std::vector<std::size_t> surfaceEnd_;           // of each particle in surfaces_
    std::vector<int> surfaces_;
    std::vector<std::vector<double>> touch_;        // [m], by material and patch
    std::vector<std::vector<int>> nearSurfaces_;    // by particle
    std::vector<int> near_;                         // awake, with near surfaces
    std::vector<std::vector<WallHit>> hits_;        // by particle
    std::vector<std::vector<char>> taken_;          // they have a contact
    std::vector<Lost> lost_;                        // scratch
};

}
