// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/RestIndex.hpp"

#include <algorithm>

namespace dem
{

RestIndex::RestIndex() : around_(none()) {}


//- A box without an inside
Box RestIndex::none() { return {Vec3::Constant(1e300), Vec3::Constant(-1e300)}; }


void RestIndex::add()
{
    place_.push_back(int(awake_.size()));
    awake_.push_back(place_.size() - 1);
    ordered_ = false;
}


void RestIndex::moves(std::size_t i)
{
    if (place_[i] >= 0) return;
    tree_.remove(i);
    if (!tree_.size()) around_ = none();
    place_[i] = int(awake_.size());
    awake_.push_back(i);
    ordered_ = false;
}


void RestIndex::rests(std::size_t i, const Vec3& x, double size)
{
    if (place_[i] < 0)
    {
        around_.include({x, x});
        if (tree_.holds(i, x)) return;
        tree_.remove(i);
    }
    else
    {
        const std::size_t last = awake_.back();
        awake_[std::size_t(place_[i])] = last;
        place_[last] = place_[i];
        awake_.pop_back();
        place_[i] = -1;
        ordered_ = false;
    }
    if (!tree_.size())
    {
        largest_ = 0;
        around_ = none();
    }
    largest_ = std::max(largest_, size);
    around_.include({x, x});
    tree_.insert(i, x, size/64);
}


const std::vector<std::size_t>& RestIndex::awake() const
{
    if (ordered_) return awake_;
    std::sort(awake_.begin(), awake_.end());
    for (std::size_t k = 0; k < awake_.size(); ++k) place_[awake_[k]] = int(k);
    ordered_ = true;
    return awake_;
}


void RestIndex::remove(const std::vector<char>& marked)
{
    const auto gone = [&](std::size_t i) { return i < marked.size() && marked[i]; };
    std::vector<std::size_t> now(place_.size());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < place_.size(); ++i)
    {
        if (gone(i) && place_[i] < 0) tree_.remove(i);
        now[i] = gone(i) ? place_.size() : kept++;
    }
    tree_.renumber(now);
    awake_.clear();
    for (std::size_t i = 0; i < place_.size(); ++i)
    {
        if (gone(i)) continue;
        const bool rests = place_[i] < 0;
        place_[now[i]] = rests ? -1 : int(awake_.size());
        if (!rests) awake_.push_back(now[i]);
    }
    place_.resize(kept);
    ordered_ = true;
    if (!tree_.size()) around_ = none();
}

}
