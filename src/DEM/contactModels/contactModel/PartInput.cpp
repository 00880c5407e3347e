// SPDX-License-Identifier: GPL-3.0-or-later
#include "contactModels/contactModel/PartInput.hpp"

#include "contactModels/contactModel/NormalResponse.hpp"
#include "particles/errors.hpp"
#include "particles/finite.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dem
{

namespace
{

std::string listed(const std::vector<std::string>& names)
{
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : " ") + name;
    return list;
}

}


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
    std::vector<PartKeyword> known
)
:
    kind_(std::move(kind)),
    settings_(settings),
    known_(std::move(known))
{
    std::vector<std::string> names;
    for (const PartKeyword& k : known_) names.push_back(k.name);

    const auto check = [&](const std::string& keyword)
    {
        if (!row(keyword))
        {
            throw inputError
            (
                kind_ + "/" + keyword,
                "unknown keyword of model " + settings_.model,
                known_.empty() ? "no keyword" : listed(names)
            );
        }
    };
    for (const auto& entry : settings_.values) check(entry.first);
    for (const auto& entry : settings_.words) check(entry.first);
}


std::vector<PartKeyword> PartInput::dashpot()
{
    return
    {
        {
            "restitution", "-", "or dampingCoefficient", 0.01, 1, {},
            "of impacts without adhesion"
        },
        {
            "dampingCoefficient", "-", "or restitution", 0, 2, {},
            "alpha, the share of critical damping times 5^(1/2)"
        }
    };
}


const PartKeyword* PartInput::row(const std::string& keyword) const
{
    for (const PartKeyword& k : known_)
    {
        if (k.name == keyword) return &k;
    }
    return nullptr;
}


bool PartInput::has(const std::string& keyword) const
{
    return settings_.values.count(keyword) > 0 || settings_.words.count(keyword) > 0;
}


double PartInput::get(const std::string& keyword) const
{
    const PartKeyword& known = *row(keyword);
    std::ostringstream range;
    range << "a number from " << known.low << " to " << known.high;

    const auto found = settings_.values.find(keyword);
    if (found == settings_.values.end())
    {
        const auto word = settings_.words.find(keyword);
        throw inputError
        (
            kind_ + "/" + keyword,
            word == settings_.words.end()
          ? "missing, needed by model " + settings_.model : "is " + word->second,
            range.str()
        );
    }
    if (!(isFinite(found->second) && found->second >= known.low && found->second <= known.high))
    {
        std::ostringstream given;
        given << "is " << found->second;
        throw inputError(kind_ + "/" + keyword, given.str(), range.str());
    }
    return found->second;
}


double PartInput::getOr(const std::string& keyword, double otherwise) const
{
    return has(keyword) ? get(keyword) : otherwise;
}


std::string PartInput::word(const std::string& keyword) const
{
    const std::vector<std::string>& allowed = row(keyword)->words;
    const auto found = settings_.words.find(keyword);
    if
    (
        found == settings_.words.end()
     || std::find(allowed.begin(), allowed.end(), found->second) == allowed.end()
    )
    {
        throw inputError
        (
            kind_ + "/" + keyword,
            found != settings_.words.end() ? "is " + found->second
          : has(keyword) ? "is a number" : "missing, needed by model " + settings_.model,
            listed(allowed)
        );
    }
    return found->second;
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
      ? dem::dampingRatio(get("restitution"))
      : get("dampingCoefficient")/std::sqrt(5.0);
}

}
