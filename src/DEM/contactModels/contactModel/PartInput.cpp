// SPDX-License-Identifier: GPL-3.0-or-later
#include "contactModels/contactModel/PartInput.hpp"

#include "contactModels/contactModel/NormalResponse.hpp"
#include "particles/errors.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dem
{

double dampingRatio(double restitution)
{
    constexpr double pi = 3.14159265358979323846;
    const double l = std::log(restitution);
    return std::fabs(l)/std::sqrt(l*l + pi*pi);
}


PartInput::PartInput
(
    std::string kind,
    const PartSettings& settings,
    const std::vector<std::string>& known
)
:
    kind_(std::move(kind)),
    settings_(settings)
{
    for (const auto& entry : settings_.values)
    {
        if (std::find(known.begin(), known.end(), entry.first) == known.end())
        {
            std::string list;
            for (const auto& k : known)
            {
                list += (list.empty() ? "" : " ") + k;
            }
            throw inputError
            (
                kind_ + "/" + entry.first,
                "unknown keyword of model " + settings_.model,
                list.empty() ? "no keyword" : list
            );
        }
    }
}


bool PartInput::has(const std::string& keyword) const
{
    return settings_.values.count(keyword) > 0;
}


double PartInput::get(const std::string& keyword, double low, double high) const
{
    std::ostringstream range;
    range << "a number from " << low << " to " << high;

    const auto found = settings_.values.find(keyword);
    if (found == settings_.values.end())
    {
        throw inputError
        (
            kind_ + "/" + keyword,
            "missing, needed by model " + settings_.model,
            range.str()
        );
    }
    if (!(found->second >= low && found->second <= high))
    {
        std::ostringstream given;
        given << "is " << found->second;
        throw inputError(kind_ + "/" + keyword, given.str(), range.str());
    }
    return found->second;
}


double PartInput::getOr
(
    const std::string& keyword, double low, double high, double otherwise
) const
{
    return has(keyword) ? get(keyword, low, high) : otherwise;
}


double PartInput::dampingRatio() const
{
    const bool e = has("restitution"), alpha = has("dampingCoefficient");
    if (e == alpha)
    {
        throw inputError
        (
            kind_ + "/restitution",
            e ? "given together with dampingCoefficient"
              : "missing, needed by model " + settings_.model,
            "either restitution (0.01 to 1) or dampingCoefficient (0 to 2)"
        );
    }
    return
        e
      ? dem::dampingRatio(get("restitution", 0.01, 1))
      : get("dampingCoefficient", 0, 2)/std::sqrt(5.0);
}

}
