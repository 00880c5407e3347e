// SPDX-License-Identifier: GPL-3.0-or-later
#include "advice/adviseRatio.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace dem
{

namespace
{

//- The real pair of a particle with a partner of its size
struct Meeting
{
    const MaterialTable& table;
    int dust;
    const RatioPartner& partner;
    const RatioLoad& load;

    double partnerRadius() const
    {
        return partner.wall ? -1 : partner.radius > 0 ? partner.radius : load.radius;
    }
    double partnerMass() const
    {
        return partner.wall ? 0 : partner.radius > 0 ? partner.mass : load.mass;
    }
    double diameter() const     // [m] of the smaller
    {
        return 2*(partner.wall ? load.radius : std::min(load.radius, partnerRadius()));
    }
    int pair() const { return table.pairInLaw(dust, partner.material); }
    const ContactLaw& law() const
    {
        return *table.laws()[std::size_t(table.lawIndex(dust, partner.material))];
    }
    PairConstants constants() const { return table.constants(dust, partner.material).real(); }
};


//- Deepest overlap of an undamped impact [m]: where the contact has done the work m v^2/2. At any
//  speed deeper than the equilibrium, through which it falls
double deepestOverlap(const Meeting& meeting, const ContactFigures& f)
{
    constexpr int steps = 4000;     // over the deepest that it may be
    const ContactLaw& law = meeting.law();
    const PairConstants real = meeting.constants();
    const ContactScale scale{real, f.R, f.m, meeting.partner.wall ? meeting.load.radius : f.R};
    double c[maxConstants], history[maxHistory] = {};
    law.prepare(meeting.pair(), scale, c);
    const double impact = law.impact(meeting.pair(), scale, meeting.load.speed).overlap;
    const double a0 = law.equilibriumRadius(meeting.pair(), real, f.R);
    const double deepest = 2*impact + 2*a0*a0/f.R;
    if (!(deepest > 0)) return 0;

    const double h = deepest/steps, energy = 0.5*f.m*meeting.load.speed*meeting.load.speed;
    const auto force = [&](double overlap)
    {
        return law.normalResponse(c, overlap, history).elastic;
    };
    double work = 0, before = force(0);
    for (int k = 1; k <= steps; ++k)
    {
        const double now = force(k*h), more = 0.5*h*(before + now);
        if (work + more > energy) return (k - 1 + (energy - work)/more)*h;
        work += more;
        before = now;
    }
    return deepest;
}


//- Takes down the limits that one meeting sets
class Needs
{
public:

    explicit Needs(bool scaled) : exponent_(scaled ? 2.5 : 1.5) {}

    //- part: what is, over what may be, unsoftened; exponent 0: chi changes nothing of it
    void add
    (
        const char* limit, double part, double real, double bound, const Meeting& m,
        double exponent
    )
    {
        const double chi = exponent > 0 ? std::pow(part, exponent) : part > 1 ? HUGE_VAL : 0;
        for (RatioNeed& n : found)
        {
            if (n.limit != limit) continue;
            if (chi > n.chi) n = {limit, chi, real, bound, m.partner.name, m.diameter()};
            return;
        }
        found.push_back({limit, chi, real, bound, m.partner.name, m.diameter()});
    }

    void look(const Meeting& m, const RatioLimits& limits)
    {
        const RatioLoad& load = m.load;
        const ContactFigures f = m.table.figures
        (
            m.dust, m.partner.material, load.radius, m.partnerRadius(), load.mass,
            m.partnerMass(), std::max(load.speed, 1e-300), m.partner.curvature
        );
        if (load.force > 0 && f.realPullOff > 0)
        {
            const double margin = f.realPullOff/load.force;
            add
            (
                "pullOffOverForce", limits.pullOffOverForce*limits.loadFactor/margin, margin,
                limits.pullOffOverForce, m, exponent_ == 2.5 ? 2.5 : 0
            );
        }
        if (!m.law().elastic()) return;

        const PairConstants real = m.constants();
        const double overlap = deepestOverlap(m, f)/m.diameter();
        add("overlap", overlap/limits.overlap, overlap, limits.overlap, m, exponent_);

        const TaborRange range = m.law().taborRange();
        if (real.realGamma > 0 && (range.least > 0 || range.most < 1e300))
        {
            // below the least no softening helps: it is the real pair that counts
            const bool low = f.tabor < range.least;
            add
            (
                "tabor", low ? range.least/f.tabor : f.tabor/range.most, f.tabor,
                range.least > 0 ? range.least : range.most, m, low ? 0 : exponent_
            );
        }
        if (load.relaxationTime > 0 && load.speed > 0)
        {
            const double t =
                m.law().impact(m.pair(), {real, f.R, f.m}, load.speed).time;
            const double part = t/load.relaxationTime;
            add("contactTime", part/limits.contactTime, part, limits.contactTime, m, 2.5);
        }
    }

    std::vector<RatioNeed> found;

private:

    double exponent_;
};


template<class... Values>
std::string formatted(const char* format, Values... values)
{
    char line[256];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

}


std::vector<RatioPartner> ratioPartners
(
    const MaterialTable& table, int dust, const Walls& walls
)
{
    std::vector<RatioPartner> result;
    for (int i = 0; i < int(table.materials().size()); ++i)
    {
        if (i == dust) result.push_back({i, false, {}, table.pairName(dust, i)});
        bool flat = false;
        for (const WallPatch& patch : walls.patches)
        {
            if (patch.material != i) continue;
            if (patch.curvature)
            {
                result.push_back
                ({
                    i, true, *patch.curvature,
                    table.pairName(dust, i) + "(" + patch.name + ")"
                });
            }
            else if (!flat)
            {
                flat = true;
                result.push_back({i, true, {}, table.pairName(dust, i) + "(wall)"});
            }
        }
    }
    return result;
}


RatioAdvice adviseRatio
(
    const MaterialTable& table, int dust, const std::vector<RatioPartner>& partners,
    const std::vector<RatioLoad>& loads, const RatioLimits& limits
)
{
    Needs needs(table.softening().scaleSurfaceEnergy);
    for (const RatioPartner& partner : partners)
    {
        for (const RatioLoad& load : loads) needs.look({table, dust, partner, load}, limits);
    }
    needs.found.push_back({"ratio", limits.ratio, limits.ratio, limits.ratio, "", 0});

    // the table refuses to soften any pair of such a law
    for (int i = 0; i < int(table.materials().size()); ++i)
    {
        for (int j = 0; j < int(table.materials().size()); ++j)
        {
            if (table.laws()[std::size_t(table.lawIndex(i, j))]->elastic()) continue;
            needs.found.push_back({"law", 1, 1, 1, table.pairName(i, j), 0});
            i = j = int(table.materials().size());
        }
    }

    RatioAdvice advice;
    advice.needs = std::move(needs.found);
    advice.loadFactor = limits.loadFactor;
    advice.chi = std::min(1.0, advice.binding().chi);
    return advice;
}


RatioAdvice adviseRatio
(
    const MaterialTable& table, const std::vector<RatioDust>& dusts, const Walls& walls,
    const RatioLimits& limits
)
{
    RatioAdvice advice;
    advice.chi = 0;
    advice.loadFactor = limits.loadFactor;
    const auto add = [&](const RatioAdvice& more)
    {
        advice.chi = std::max(advice.chi, more.chi);
        for (const RatioNeed& n : more.needs)
        {
            const auto same = std::find_if
            (
                advice.needs.begin(), advice.needs.end(),
                [&](const RatioNeed& other) { return other.limit == n.limit; }
            );
            if (same == advice.needs.end()) advice.needs.push_back(n);
            else if (n.chi > same->chi) *same = n;
        }
    };

    for (const RatioDust& dust : dusts)
    {
        const std::vector<RatioPartner> partners = ratioPartners(table, dust.material, walls);
        add(adviseRatio(table, dust.material, partners, dust.loads, limits));
        for (const RatioDust& other : dusts)
        {
            if (other.material == dust.material || other.loads.empty()) continue;
            const RatioLoad& least = other.loads.front();
            for (const RatioLoad& load : dust.loads)
            {
                // else the other one is the smaller, and its turn comes
                if (other.loads.back().radius < load.radius) continue;
                const double radius = std::max(load.radius, least.radius);
                const double mass = least.mass*std::pow(radius/least.radius, 3);
                const RatioPartner partner
                {
                    other.material, false, {}, table.pairName(dust.material, other.material),
                    radius, mass
                };
                add(adviseRatio(table, dust.material, {partner}, {load}, limits));
            }
        }
    }
    return advice;
}


const RatioNeed& RatioAdvice::binding() const
{
    return *std::max_element
    (
        needs.begin(), needs.end(),
        [](const RatioNeed& a, const RatioNeed& b)
        {
            return (std::isinf(a.chi) ? 0 : a.chi) < (std::isinf(b.chi) ? 0 : b.chi);
        }
    );
}


bool RatioAdvice::reached() const
{
    return std::all_of
    (
        needs.begin(), needs.end(), [](const RatioNeed& n) { return n.chi <= 1; }
    );
}


const RatioNeed* RatioAdvice::find(const std::string& limit) const
{
    for (const RatioNeed& n : needs)
    {
        if (n.limit == limit) return &n;
    }
    return nullptr;
}


std::string RatioAdvice::text() const
{
    std::string lines;
    for (const RatioNeed& n : needs)
    {
        const char* what =
            n.limit == "pullOffOverForce" ? "pull-off force over that on one particle"
          : n.limit == "overlap" ? "overlap over diameter"
          : n.limit == "tabor" ? "Tabor number"
          : n.limit == "contactTime" ? "contact over relaxation time"
          : n.limit == "ratio" ? "softest at all"
          : "a law that is not softened";
        lines += formatted
        (
            "    %-16s %-11s ", n.limit.c_str(),
            n.chi > 1 ? "none" : formatted("%.5g", n.chi).c_str()
        );
        lines += what;
        if (!n.pair.empty() && n.diameter > 0)
        {
            lines += formatted
            (
                " %.3g unsoftened, limit %.3g (%s, %.3g m)", n.real, n.bound, n.pair.c_str(),
                n.diameter
            );
        }
        if (n.limit == "pullOffOverForce" && loadFactor != 1)
        {
            lines += formatted(" for %.3g times that force", loadFactor);
        }
        lines += "\n";
        if (n.chi <= 1) continue;
        lines +=
            "    Warning: no chi keeps this limit: unsoftened, it is "
          + formatted
            (
                "%.3g where %.3g is wanted",
                n.limit == "pullOffOverForce" ? n.real/loadFactor : n.real, n.bound
            )
          + (n.limit == "tabor" ? "; the law is not that of this pair\n" : "\n");
    }
    return lines;
}


double stiffenedRatio(double chi, double margin, double limit)
{
    return std::min(1.0, chi*std::pow(stiffeningHeadroom*limit/margin, 2.5));
}

}
