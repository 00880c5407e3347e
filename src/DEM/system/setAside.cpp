// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/setAside.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

namespace
{

// Missing, over the widest gap, that is none
constexpr double exact = 1e-9;

using Vectors = std::vector<Vec3>;

double square(const Vectors& v)
{
    double sum = 0;
    for (const Vec3& x : v) sum += x.squaredNorm();
    return sum;
}


//- All who have a contact, and where they go to
class Places
{
public:

    explicit Places(std::vector<Gap> gaps);

    void guess();
    void agree();
    void keepCentres();
    Ways ways() const;


private:

    struct Link { int i, j; };      // particles of a gap by index; j = -1: wall

    std::vector<int> grow(std::vector<int> front);
    double linearise(std::vector<double>& missing);
    double descend(std::vector<double> missing);
    double apart(const Vectors& p, std::size_t g) const;
    void gather(const std::vector<double>& r, Vectors& sum) const;

    std::vector<Gap> gaps_;
    std::vector<std::int64_t> ids_;         // ascending
    std::vector<Link> links_;               // by gap
    std::vector<double> mass_;              // by particle [kg]
    std::vector<std::vector<int>> of_;      // by particle: its gaps with others
    std::vector<char> placed_;              // by particle
    std::vector<std::vector<int>> flying_;  // clusters that no wall holds
    Vectors way_;                           // by particle [m]
    Vectors n_;                             // by gap, of the particles where they are now
};


Places::Places(std::vector<Gap> gaps)
:
    gaps_(std::move(gaps))
{
    std::stable_sort(gaps_.begin(), gaps_.end(), [](const Gap& a, const Gap& b)
    {
        return a.i < b.i || (a.i == b.i && a.j < b.j);
    });
    for (const Gap& g : gaps_)
    {
        ids_.push_back(g.i);
        if (g.j >= 0) ids_.push_back(g.j);
    }
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    const auto index = [&](std::int64_t id)
    {
        return int(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
    };
    mass_.resize(ids_.size());
    of_.resize(ids_.size());
    placed_.assign(ids_.size(), 0);
    way_.assign(ids_.size(), Vec3::Zero());
    for (const Gap& g : gaps_)
    {
        const Link l{index(g.i), g.j < 0 ? -1 : index(g.j)};
        mass_[std::size_t(l.i)] = g.mi;
        if (l.j >= 0)
        {
            mass_[std::size_t(l.j)] = g.mj;
            of_[std::size_t(l.i)].push_back(int(links_.size()));
            of_[std::size_t(l.j)].push_back(int(links_.size()));
        }
        links_.push_back(l);
        n_.push_back(g.n);
    }
}


//- Place those who touch the front, then those who touch them, ...; all of them, the front first
std::vector<int> Places::grow(std::vector<int> front)
{
    std::vector<int> all = front;
    while (!front.empty())
    {
        std::unordered_map<int, int> at;
        std::vector<int> next;
        std::vector<std::pair<Vec3, int>> sums;
        for (const int i : front)
        {
            for (const int k : of_[std::size_t(i)])
            {
                const Link& l = links_[std::size_t(k)];
                const int other = l.i == i ? l.j : l.i;
                if (placed_[std::size_t(other)]) continue;
                const auto slot = at.emplace(other, int(next.size()));
                if (slot.second)
                {
                    next.push_back(other);
                    sums.emplace_back(Vec3::Zero(), 0);
                }
                const Gap& g = gaps_[std::size_t(k)];
                auto& sum = sums[std::size_t(slot.first->second)];
                sum.first += way_[std::size_t(i)] + (l.i == i ? g.open : -g.open)*g.n;
                ++sum.second;
            }
        }
        for (std::size_t k = 0; k < next.size(); ++k)
        {
            way_[std::size_t(next[k])] = sums[k].first/sums[k].second;
            placed_[std::size_t(next[k])] = 1;
        }
        all.insert(all.end(), next.begin(), next.end());
        front = std::move(next);
    }
    return all;
}


void Places::guess()
{
    std::vector<int> front, walls(ids_.size(), 0);
    for (std::size_t g = 0; g < gaps_.size(); ++g)
    {
        if (links_[g].j >= 0) continue;
        const std::size_t i = std::size_t(links_[g].i);
        way_[i] -= gaps_[g].open*gaps_[g].n;
        placed_[i] = 1;
        if (!walls[i]++) front.push_back(int(i));
    }
    for (const int i : front) way_[std::size_t(i)] /= walls[std::size_t(i)];
    grow(front);

    for (std::size_t i = 0; i < ids_.size(); ++i)
    {
        if (placed_[i]) continue;
        placed_[i] = 1;
        flying_.push_back(grow({int(i)}));
        std::size_t ends = 0;
        for (const int k : flying_.back()) ends += of_[std::size_t(k)].size();
        if (ends/2 < flying_.back().size()) continue;
        // which way round a ring it came to a particle is of no meaning
        for (const int k : flying_.back()) way_[std::size_t(k)].setZero();
    }
}


//- What is missing where the particles are now, and in which directions; the most of it [m]
double Places::linearise(std::vector<double>& missing)
{
    double most = 0;
    missing.resize(gaps_.size());
    for (std::size_t k = 0; k < gaps_.size(); ++k)
    {
        const Gap& g = gaps_[k];
        const Link& l = links_[k];
        const Vec3& wi = way_[std::size_t(l.i)];
        const Vec3 wj = l.j < 0 ? Vec3(Vec3::Zero()) : way_[std::size_t(l.j)];
        missing[k] = g.open - opened(g, wi, wj);
        most = std::max(most, std::fabs(missing[k]));
        if (l.j >= 0) n_[k] = (g.distance*g.n + wj - wi).normalized();
    }
    return most;
}


//- By how much steps p move the two of gap g apart, in first order
double Places::apart(const Vectors& p, std::size_t g) const
{
    const Link& l = links_[g];
    const double i = p[std::size_t(l.i)].dot(n_[g]);
    return l.j < 0 ? -i : p[std::size_t(l.j)].dot(n_[g]) - i;
}


//- Its transpose
void Places::gather(const std::vector<double>& r, Vectors& sum) const
{
    std::fill(sum.begin(), sum.end(), Vec3(Vec3::Zero()));
    for (std::size_t g = 0; g < gaps_.size(); ++g)
    {
        sum[std::size_t(links_[g].i)] -= r[g]*n_[g];
        if (links_[g].j >= 0) sum[std::size_t(links_[g].j)] += r[g]*n_[g];
    }
}


//- The shortest steps that leave the least sum of squares, by conjugate gradients (CGLS); the
//  longest [m]
double Places::descend(std::vector<double> missing)
{
    constexpr int most = 500;
    Vectors s(ids_.size()), step(ids_.size(), Vec3::Zero());
    gather(missing, s);
    Vectors p = s;
    double now = square(s), all = 0;
    for (const double m : missing) all += m*m;
    const double least = 1e-24*all;
    for (int k = 0; k < most && now > least; ++k)
    {
        std::vector<double> q(gaps_.size());
        double length = 0;
        for (std::size_t g = 0; g < q.size(); ++g)
        {
            q[g] = apart(p, g);
            length += q[g]*q[g];
        }
        const double alpha = now/length;
        for (std::size_t g = 0; g < q.size(); ++g) missing[g] -= alpha*q[g];
        for (std::size_t i = 0; i < p.size(); ++i) step[i] += alpha*p[i];
        gather(missing, s);
        const double before = now;
        now = square(s);
        for (std::size_t i = 0; i < p.size(); ++i) p[i] = s[i] + now/before*p[i];
    }
    double longest = 0;
    for (std::size_t i = 0; i < step.size(); ++i)
    {
        way_[i] += step[i];
        longest = std::max(longest, step[i].norm());
    }
    return longest;
}


void Places::agree()
{
    constexpr int most = 6;
    double widest = 0;
    for (const Gap& g : gaps_) widest = std::max(widest, std::fabs(g.open));
    std::vector<double> missing;
    for (int k = 0; k < most; ++k)
    {
        if (linearise(missing) <= exact*widest) return;
        if (descend(missing) <= exact*widest) return;
    }
}


void Places::keepCentres()
{
    for (const std::vector<int>& cluster : flying_)
    {
        Vec3 sum = Vec3::Zero();
        double total = 0;
        for (const int k : cluster)
        {
            sum += mass_[std::size_t(k)]*way_[std::size_t(k)];
            total += mass_[std::size_t(k)];
        }
        for (const int k : cluster) way_[std::size_t(k)] -= sum/total;
    }
}


Ways Places::ways() const
{
    Ways result;
    for (std::size_t i = 0; i < ids_.size(); ++i) result.emplace(ids_[i], way_[i]);
    return result;
}

}


double opened(const Gap& gap, const Vec3& wayI, const Vec3& wayJ)
{
    if (gap.j < 0) return -wayI.dot(gap.n);
    // |d + w| - |d| without the loss of digits of a difference
    const Vec3 d = gap.distance*gap.n, w = wayJ - wayI;
    return w.dot(2*d + w)/((d + w).norm() + gap.distance);
}


Ways setAside(std::vector<Gap> gaps)
{
    Places places(std::move(gaps));
    places.guess();
    places.agree();
    places.keepCentres();
    return places.ways();
}

}
