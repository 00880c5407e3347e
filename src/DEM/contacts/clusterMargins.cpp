// SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/clusterMargins.hpp"

#include "neighbourSearch/DisjointSets.hpp"

#include <algorithm>

namespace dem
{

namespace
{

constexpr std::size_t nodeNumbers = 5, bondNumbers = 3;

std::vector<double> packed(const ClusterGraph& g)
{
    std::vector<double> d{double(g.nodes.size())};
    for (const auto& n : g.nodes)
    {
        d.insert
        (
            d.end(), {double(n.id), n.mass, n.force[0], n.force[1], n.force[2]}
        );
    }
    for (const auto& b : g.bonds)
    {
        d.insert(d.end(), {double(b.i), double(b.j), b.pullOff});
    }
    return d;
}

ClusterGraph joined(const std::vector<std::vector<double>>& parts)
{
    ClusterGraph g;
    for (const auto& d : parts)
    {
        if (d.empty()) continue;
        const std::size_t n = std::size_t(d[0]);
        std::size_t k = 1;
        for (std::size_t i = 0; i < n; ++i, k += nodeNumbers)
        {
            g.nodes.push_back
            ({
                std::int64_t(d[k]), d[k + 1], Vec3(d[k + 2], d[k + 3], d[k + 4])
            });
        }
        for (; k + bondNumbers <= d.size(); k += bondNumbers)
        {
            g.bonds.push_back
            ({
                std::int64_t(d[k]), std::int64_t(d[k + 1]), d[k + 2]
            });
        }
    }

    // the same on any number of ranks
    std::sort
    (
        g.nodes.begin(), g.nodes.end(),
        [](const ClusterGraph::Node& a, const ClusterGraph::Node& b)
        {
            return a.id < b.id;
        }
    );
    std::stable_sort
    (
        g.bonds.begin(), g.bonds.end(),
        [](const ClusterGraph::Bond& a, const ClusterGraph::Bond& b)
        {
            return a.i < b.i || (a.i == b.i && a.j < b.j);
        }
    );
    return g;
}

}


ClusterGraph ClusterGraph::gathered(const Communicator& c) const
{
    return joined(c.gather(packed(*this)));
}


ClusterGraph ClusterGraph::everywhere(const Communicator& c) const
{
    return joined(c.allGather(packed(*this)));
}


std::unordered_map<std::int64_t, ClusterLabel> clusterLabels(const ClusterGraph& graph)
{
    std::vector<std::int64_t> ids;
    for (const auto& b : graph.bonds)
    {
        ids.push_back(b.i);
        if (b.j >= 0) ids.push_back(b.j);
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    const auto at = [&](std::int64_t id)
    {
        return std::size_t(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
    };

    DisjointSets sets(ids.size());
    for (const auto& b : graph.bonds)
    {
        if (b.j >= 0) sets.join(at(b.i), at(b.j));
    }
    std::vector<char> onWall(ids.size(), 0);
    for (const auto& b : graph.bonds)
    {
        if (b.j < 0) onWall[sets.find(at(b.i))] = 1;
    }

    std::unordered_map<std::int64_t, ClusterLabel> labels;
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
        const std::size_t root = sets.find(k);
        labels.emplace(ids[k], ClusterLabel{ids[root], onWall[root] != 0});
    }
    return labels;
}


std::vector<double> clusterMargins(const ClusterGraph& graph)
{
    const std::size_t n = graph.nodes.size();
    const auto at = [&](std::int64_t id)
    {
        const auto found = std::lower_bound
        (
            graph.nodes.begin(), graph.nodes.end(), id,
            [](const ClusterGraph::Node& a, std::int64_t b) { return a.id < b; }
        );
        return std::size_t(found - graph.nodes.begin());
    };

    struct Edge { std::size_t to; double pullOff; };
    std::vector<std::vector<Edge>> edges(n);
    std::vector<double> wallPullOff(n, 0.0);
    for (const auto& b : graph.bonds)
    {
        const std::size_t i = at(b.i);
        if (i >= n) continue;
        if (b.j < 0)
        {
            wallPullOff[i] = std::max(wallPullOff[i], b.pullOff);
            continue;
        }
        const std::size_t j = at(b.j);
        if (j >= n) continue;
        edges[i].push_back({j, b.pullOff});
        edges[j].push_back({i, b.pullOff});
    }

    std::vector<double> hold(n, 0.0);           // of the contact towards the root
    std::vector<std::ptrdiff_t> parent(n, -1);
    std::vector<char> seen(n, 0);
    std::vector<std::size_t> order;
    const auto grow = [&](std::size_t first)    // breadth first
    {
        for (std::size_t k = first; k < order.size(); ++k)
        {
            const std::size_t i = order[k];
            for (const Edge& e : edges[i])
            {
                if (seen[e.to]) continue;
                seen[e.to] = 1;
                parent[e.to] = std::ptrdiff_t(i);
                hold[e.to] = e.pullOff;
                order.push_back(e.to);
            }
        }
    };

    for (std::size_t i = 0; i < n; ++i)
    {
        if (wallPullOff[i] > 0)
        {
            seen[i] = 1;
            hold[i] = wallPullOff[i];
            order.push_back(i);
        }
    }
    grow(0);

    std::vector<Vec3> load(n);
    for (std::size_t i = 0; i < n; ++i) load[i] = graph.nodes[i].force;

    // Flying aggregates carry what accelerates each member differently from the whole
    for (std::size_t i = 0; i < n; ++i)
    {
        if (seen[i]) continue;
        const std::size_t first = order.size();
        seen[i] = 1;
        order.push_back(i);
        grow(first);
        double mass = 0;
        Vec3 force = Vec3::Zero();
        for (std::size_t k = first; k < order.size(); ++k)
        {
            mass += graph.nodes[order[k]].mass;
            force += graph.nodes[order[k]].force;
        }
        for (std::size_t k = first; k < order.size(); ++k)
        {
            load[order[k]] -= graph.nodes[order[k]].mass/mass*force;
        }
    }

    for (std::size_t k = order.size(); k-- > 0;)
    {
        if (parent[order[k]] >= 0) load[std::size_t(parent[order[k]])] += load[order[k]];
    }

    std::vector<double> margins;
    for (std::size_t i = 0; i < n; ++i)
    {
        if (!(hold[i] > 0)) continue;
        const double pull = load[i].norm();
        margins.push_back(pull > 1e-30*hold[i] ? hold[i]/pull : 1e30);
    }
    return margins;
}

}
