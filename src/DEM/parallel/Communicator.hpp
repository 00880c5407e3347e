// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only door to MPI. It never initialises or finalises MPI, and it frees nothing: the
// communicator handed in must live longer than the System.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <vector>

namespace dem
{

class Communicator
{
public:

    //- This process alone; MPI need not be initialised
    Communicator() = default;

    explicit Communicator(MPI_Comm comm);

    int rank() const { return rank_; }
    int size() const { return size_; }
    bool parallel() const { return size_ > 1; }

    //- Send toRank[r] to rank r; returns what each rank sent here. Collective.
    std::vector<std::vector<double>> exchange
    (
        const std::vector<std::vector<double>>& toRank
    ) const;

    //- Everybody's numbers, by rank. Collective.
    std::vector<std::vector<double>> allGather(const std::vector<double>& mine) const;

    //- Everybody's numbers, by rank, on rank 0 only. Collective.
    std::vector<std::vector<double>> gather(const std::vector<double>& mine) const;

    bool any(bool mine) const;      // Collective
    double max(double mine) const;  // Collective

private:

    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0;
    int size_ = 1;
};

}
