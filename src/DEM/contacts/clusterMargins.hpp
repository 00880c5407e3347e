// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clusters of touching particles and the load on the contacts that hold them.
#pragma once

#include "contacts/ContactView.hpp"
#include "parallel/Communicator.hpp"
#include "particles/vector.hpp"

#include <unordered_map>
#include <vector>

namespace dem
{

struct ClusterGraph
{
    struct Node
    {
        std::int64_t id;
        double mass;    // [kg]
        Vec3 force;     // external force [N]
    };
    struct Bond
    {
        std::int64_t i, j;  // j = -1: wall
        double pullOff;     // [N]
    };

    std::vector<Node> nodes;
    std::vector<Bond> bonds;

    //- The graph of all ranks, on the master (elsewhere empty). Collective.
    ClusterGraph gathered(const Communicator& c) const;
    //- The graph of all ranks, everywhere. Collective.
    ClusterGraph everywhere(const Communicator& c) const;
};

//- For every particle with a bond its cluster
std::unordered_map<std::int64_t, ClusterLabel> clusterLabels(const ClusterGraph& graph);

//- Pull-off force over load for each bonded particle (System::adhesionMargins)
std::vector<double> clusterMargins(const ClusterGraph& graph);

}
