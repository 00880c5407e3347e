// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who of this rank moves in the next particle step, and where those are who rest. A particle step
// goes through the first and looks up the others; it never goes through all.
#pragma once

#include "neighbourSearch/PointTree.hpp"
#include "neighbourSearch/Periodic.hpp"

#include <cstddef>
#include <vector>

namespace dem
{

class RestIndex
{
public:

    RestIndex();

    //- One more particle, the last; it moves
    void add();

    //- Particle i moves from here on, or rests at x; size [m]: how far it reaches from there
    void moves(std::size_t i);
    void rests(std::size_t i, const Vec3& x, double size);

    bool resting(std::size_t i) const { return place_[i] < 0; }

    //- Those who move, ascending
    const std::vector<std::size_t>& awake() const;
    bool anyAwake() const { return !awake_.empty(); }

    std::size_t nResting() const { return tree_.size(); }

    //- About all at rest and perhaps more; the low end above the high end where nobody is
    Box around() const
    {
        return {around_.low.array() - largest_, around_.high.array() + largest_};
    }

    //- Calls f(i) for each one at rest that a box may reach
    template<class F>
    void near(const Box& box, const Periodic& periodic, F&& f) const;

    //- Drop those with mark, close the gaps
    void remove(const std::vector<char>& marked);


private:

    static Box none();

    PointTree tree_;
    double largest_ = 0;                        // [m] size of any of them
    Box around_;                                // their places
    mutable std::vector<int> place_;            // in awake_; -1: at rest
    mutable std::vector<std::size_t> awake_;
    mutable bool ordered_ = true;               // awake_ is ascending
};


template<class F>
void RestIndex::near(const Box& box, const Periodic& periodic, F&& f) const
{
    if (!tree_.size()) return;
    const Box wide{box.low.array() - largest_, box.high.array() + largest_};
    periodicImages(wide, periodic, [&](const Box& image)
    {
        if (image.overlaps(around_)) tree_.inside(image, f);
    });
}

}
