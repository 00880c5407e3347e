// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbourSearch/BoxGrid.hpp"

namespace dem
{

BoxGrid::BoxGrid(const std::vector<Box>& boxes, const Periodic& periodic)
:
    boxes_(boxes)
{
    build(periodic);
}


void BoxGrid::build(const Periodic& periodic)
{
    periodic_ = periodic;
    farthest_ = 0;
    entries_.clear();
    middles_.clear();
    if (boxes_.empty()) return;
    if (periodic_.on())
    {
        all_ = boxes_;
        original_.clear();
        for (std::size_t i = 0; i < boxes_.size(); ++i)
        {
            bool first = true;      // the box itself
            periodicImages(boxes_[i], periodic_, [&](const Box& image)
            {
                if (!first)
                {
                    all_.push_back(image);
                    original_.push_back(int(i));
                }
                first = false;
            });
        }
    }
    const std::vector<Box>& all = periodic_.on() ? all_ : boxes_;

    middles_.resize(boxes_.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i)
    {
        middles_[i] = boxes_[i].middle();
        changed(int(i));
    }

    Vec3 low = all[0].middle(), high = low;
    for (const Box& b : all)
    {
        low = low.cwiseMin(b.middle());
        high = high.cwiseMax(b.middle());
        size_ = std::max(&b == &all[0] ? 0 : size_, (b.high - b.low).maxCoeff());
    }
    // at most 2^19 cells along an edge, so that three numbers fit into one key
    size_ = std::max(size_*(1 + 1e-9), (high - low).maxCoeff()/524000.0);
    if (!(size_ > 0)) size_ = 1;
    low_ = low;
    for (int d = 0; d < 3; ++d)
    {
        cells_[d] = std::int64_t((high[d] - low[d])/size_) + 3;
    }

    entries_.resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const Vec3 m = all[i].middle();
        entries_[i] = {key(cell(0, m[0]), cell(1, m[1]), cell(2, m[2])), int(i)};
    }
    sort();
}


void BoxGrid::changed(int i)
{
    const Box& b = boxes_[std::size_t(i)];
    const Vec3& middle = middles_[std::size_t(i)];
    farthest_ = std::max({farthest_, (b.high - middle).maxCoeff(), (middle - b.low).maxCoeff()});
}


//- By key, then by box: radix sort, which leaves equal keys in their order
void BoxGrid::sort()
{
    const auto less = [](const Entry& a, const Entry& b)
    {
        return a.key < b.key || (a.key == b.key && a.box < b.box);
    };
    if (entries_.size() < 256)
    {
        std::sort(entries_.begin(), entries_.end(), less);
        return;
    }
    constexpr int bits = 11;
    constexpr std::size_t buckets = std::size_t(1) << bits;
    const std::int64_t most = cells_[0]*cells_[1]*cells_[2];
    std::vector<Entry>& other = scratch_;
    other.resize(entries_.size());
    for (int shift = 0; shift < 63 && (most >> shift) > 0; shift += bits)
    {
        std::size_t start[buckets + 1] = {};
        const auto digit = [&](const Entry& e)
        {
            return std::size_t(e.key >> shift) & (buckets - 1);
        };
        for (const Entry& e : entries_) ++start[digit(e) + 1];
        for (std::size_t b = 0; b < buckets; ++b) start[b + 1] += start[b];
        for (const Entry& e : entries_) other[start[digit(e)]++] = e;
        entries_.swap(other);
    }
}

}
