// SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/PackedState.hpp"

#include "particles/finite.hpp"

#include <cmath>

namespace dem
{

namespace
{

bool integer(double value)
{
    return std::trunc(value) == value && std::fabs(value) < 9e15;
}

const char* restFault(const double* s)
{
    for (const std::size_t i : PackedState::restIntegers)
    {
        if (!integer(s[i])) return "a number that must be whole is not";
    }
    if (s[0] != PackedState::version) return "it is of another version";
    if ((s[1] != 0 && s[1] != 1) || (s[2] != 0 && s[2] != 1)) return "a flag is neither 0 nor 1";
    if (s[3] < 0) return "it has been quiet for less than no time";
    if (s[PackedState::aggregate] < -1 || s[10] < 0 || s[10] > 2e9)
    {
        return "the aggregate that it flies with cannot be";
    }
    if (s[PackedState::aggregate] >= 0 && s[10] == 0)
    {
        return "it flies with an aggregate of no members";
    }
    return "";
}

const char* contactFault(const double* c, std::int64_t idI, int nWalls)
{
    const double partner = c[PackedState::partner], wall = c[PackedState::wall];
    if (!integer(partner) || !integer(wall)) return "a partner's number is not whole";
    if (partner < -1 || wall < -1 || (partner < 0) == (wall < 0))
    {
        return "a contact is with neither a particle nor a wall, or with both";
    }
    if (wall >= nWalls) return "a contact is with a wall that there was not";
    if (partner >= 0 && partner <= double(idI)) return "a contact is not with a higher number";
    if (wall >= 0)
    {
        const double length = std::sqrt(c[2]*c[2] + c[3]*c[3] + c[4]*c[4]);
        if (!(std::fabs(length - 1) < 1e-6)) return "a wall's normal has not the length 1";
    }
    return "";
}

}


const char* PackedState::fault
(
    const std::vector<double>& state,
    std::int64_t idI,
    int nWalls
)
{
    if (state.empty()) return "";
    if (!fits(state.size())) return "it has too few or too many numbers";
    for (const double value : state)
    {
        // beyond 1e30 squares overflow
        if (!isFinite(value) || std::fabs(value) > 1e30)
        {
            return "a number is not finite or impossibly large";
        }
    }
    const char* found = restFault(state.data());
    for (std::size_t k = 0; !*found && k < contacts(state.size()); ++k)
    {
        found = contactFault(state.data() + restNumbers + k*contactNumbers, idI, nWalls);
    }
    return found;
}

}
