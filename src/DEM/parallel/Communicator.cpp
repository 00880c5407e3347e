// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/Communicator.hpp"

#include <cstddef>

namespace dem
{

Communicator::Communicator(MPI_Comm comm)
:
    comm_(comm)
{
    if (comm_ == MPI_COMM_NULL) return;
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
}


std::vector<std::vector<double>> Communicator::exchange
(
    const std::vector<std::vector<double>>& toRank
) const
{
    if (!parallel()) return toRank;

    const std::size_t n = std::size_t(size_);
    std::vector<int> sendCount(n), receiveCount(n), sendStart(n), receiveStart(n);
    std::vector<double> send;
    for (std::size_t r = 0; r < n; ++r)
    {
        sendCount[r] = int(toRank[r].size());
        sendStart[r] = int(send.size());
        send.insert(send.end(), toRank[r].begin(), toRank[r].end());
    }
    MPI_Alltoall
    (
        sendCount.data(), 1, MPI_INT, receiveCount.data(), 1, MPI_INT, comm_
    );
    int total = 0;
    for (std::size_t r = 0; r < n; ++r)
    {
        receiveStart[r] = total;
        total += receiveCount[r];
    }
    std::vector<double> receive(std::size_t(total), 0.0);
    MPI_Alltoallv
    (
        send.data(), sendCount.data(), sendStart.data(), MPI_DOUBLE,
        receive.data(), receiveCount.data(), receiveStart.data(), MPI_DOUBLE, comm_
    );

    std::vector<std::vector<double>> result(n);
    for (std::size_t r = 0; r < n; ++r)
    {
        const auto first = receive.begin() + receiveStart[r];
        result[r].assign(first, first + receiveCount[r]);
    }
    return result;
}


std::vector<std::vector<double>> Communicator::allGather
(
    const std::vector<double>& mine
) const
{
    return exchange(std::vector<std::vector<double>>(std::size_t(size_), mine));
}


std::vector<std::vector<double>> Communicator::gather
(
    const std::vector<double>& mine
) const
{
    std::vector<std::vector<double>> toRank(static_cast<std::size_t>(size_));
    toRank[0] = mine;
    return exchange(toRank);
}


bool Communicator::any(bool mine) const
{
    return max(mine ? 1 : 0) > 0;
}


double Communicator::max(double mine) const
{
    double result = mine;
    if (parallel())
    {
        MPI_Allreduce(&mine, &result, 1, MPI_DOUBLE, MPI_MAX, comm_);
    }
    return result;
}

}
