// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/MaterialTable.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"
#include "contactModels/contactModel/contactModelTable.hpp"
#include "contactModels/contactModel/none.hpp"
#include "particles/errors.hpp"
#include "particles/finite.hpp"
#include "timeIntegration/contactPeriod.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dem
{

namespace
{

std::string text(double v)
{
    std::ostringstream s;
    s << "is " << v;
    return s.str();
}

void check(const Material& m)
{
    const std::string at = "materials/" + m.name + "/";
    if (!(isFinite(m.density) && m.density >= 0))
    {
        throw inputError(at + "density", text(m.density), "a positive number [kg/m3]");
    }
    if (!(isFinite(m.youngsModulus) && m.youngsModulus > 0))
    {
        throw inputError
        (
            at + "youngsModulus", text(m.youngsModulus), "a positive number [Pa]"
        );
    }
    if (!(isFinite(m.poissonRatio) && m.poissonRatio > -1 && m.poissonRatio <= 0.5))
    {
        throw inputError
        (
            at + "poissonRatio", text(m.poissonRatio), "above -1, at most 0.5"
        );
    }
    if (!(isFinite(m.surfaceEnergy) && m.surfaceEnergy >= 0))
    {
        throw inputError
        (
            at + "surfaceEnergy", text(m.surfaceEnergy), "zero or positive [J/m2]"
        );
    }
}


void checkRatio(double chi)
{
    if (isFinite(chi) && chi > 0 && chi <= 1) return;
    throw inputError("reducedStiffness/ratio", text(chi), "above 0, at most 1");
}


PairConstants softened
(
    const Material& a, const Material& b, const ContactSettings& s,
    const ReducedStiffness& softening
)
{
    const auto compliance = [](const Material& m)
    {
        return (1 - m.poissonRatio*m.poissonRatio)/m.youngsModulus;
    };
    const auto shearCompliance = [](const Material& m)
    {
        return (2 - m.poissonRatio)*2*(1 + m.poissonRatio)/m.youngsModulus;
    };
    const double mixedE = 1/(compliance(a) + compliance(b));
    const double mixedG = 1/(shearCompliance(a) + shearCompliance(b));
    const std::string pair = "contact/" + a.name + "." + b.name;

    PairConstants c;
    c.realE = s.effectiveYoungsModulus.value_or(mixedE);
    c.realGamma = s.surfaceEnergy.value_or(std::sqrt(a.surfaceEnergy*b.surfaceEnergy));
    if (!(isFinite(c.realE) && c.realE > 0))
    {
        throw inputError
        (
            pair + "/effectiveYoungsModulus", text(c.realE), "a positive number [Pa]"
        );
    }
    if (!(isFinite(c.realGamma) && c.realGamma >= 0))
    {
        throw inputError
        (
            pair + "/surfaceEnergy", text(c.realGamma), "zero or positive [J/m2]"
        );
    }
    c.chi = softening.ratio;
    c.E = c.chi*c.realE;
    c.G = c.chi*mixedG*c.realE/mixedE;
    c.gammaFactor = softening.surfaceEnergyFactor();
    c.gamma = c.gammaFactor*c.realGamma;
    c.softened = true;
    c.scaleResistance = softening.scaleResistance;
    return c;
}

}


MaterialTable::MaterialTable
(
    std::vector<Material> materials,
    ContactSettings defaults,
    std::map<std::string, ContactSettings> overrides,
    ReducedStiffness softening
)
:
    materials_(std::move(materials)),
    softening_(softening)
{
    for (const Material& m : materials_) check(m);

    const double chi = softening_.ratio;
    checkRatio(chi);

    const std::size_t n = materials_.size();
    constants_.resize(n*(n + 1));
    settings_.resize(n*(n + 1));
    names_.resize(n*(n + 1));
    lawIndex_.resize(n*(n + 1));
    pairInLaw_.resize(n*(n + 1));
    std::vector<std::shared_ptr<ContactLaw>> laws;

    for (std::size_t i = 0; i < n; ++i)
    {
        for (std::size_t j = i; j < n; ++j)
        {
            const Material& a = materials_[i];
            const Material& b = materials_[j];
            const std::string ab = a.name + "." + b.name;
            const std::string ba = b.name + "." + a.name;

            ContactSettings s = defaults;
            for (const std::string& key : {ab, ba})
            {
                const auto found = overrides.find(key);
                if (found != overrides.end())
                {
                    s = found->second;
                    overrides.erase(found);
                }
            }

            const PairConstants c = softened(a, b, s, softening_);

            try
            {
                std::unique_ptr<ContactLaw> law = newContactLaw(s);
                if (law->elastic() && c.realGamma == 0)
                {
                    law->addPair(s);    // its numbers are still checked
                    s = withoutAdhesion(s);
                    law = newContactLaw(s);
                }
                if (!law->elastic() && chi != 1)
                {
                    throw inputError
                    (
                        "normal/model",
                        s.normal.model + " with reducedStiffness ratio "
                      + text(chi).substr(3) + ", which softens elastic laws only",
                        "ratio 1 (this law has a keyword softening), or an elastic law"
                    );
                }

                std::size_t l = 0;
                while (l < laws.size() && laws[l]->name() != law->name()) ++l;
                if (l == laws.size()) laws.push_back(std::move(law));

                // every pair, in either order, gets its own numbers
                const int entry = laws[l]->addPair(s);
                for (const std::size_t k : {at(int(i), int(j)), at(int(j), int(i))})
                {
                    constants_[k] = c;
                    settings_[k] = s;
                    names_[k] = ab;
                    lawIndex_[k] = int(l);
                    pairInLaw_[k] = entry;
                }
            }
            catch (const inputError& e)
            {
                throw inputError
                (
                    "contact/" + ab + "/" + e.keyword, e.reason, e.allowed
                );
            }
        }
    }

    if (!overrides.empty())
    {
        std::string list;
        for (const std::string& name : names_)
        {
            if (list.find(name) == std::string::npos)
            {
                list += (list.empty() ? "" : " ") + name;
            }
        }
        throw inputError
        (
            "contact/" + overrides.begin()->first, "no such pair of materials", list
        );
    }

    laws_.assign(laws.begin(), laws.end());
}


void MaterialTable::addMirrors()
{
    if (mirrors_) return;
    mirrors_ = true;
    std::shared_ptr<ContactLaw> law = newContactLaw(mirrorSettings());
    for (int i = 0; i < int(materials_.size()); ++i)
    {
        ContactSettings s = mirrorSettings();
        // as stiff as the plane between two that meet in it
        s.effectiveYoungsModulus = 2*constants(i, i).realE;
        const std::size_t k = at(i, mirror);
        const Material& m = materials_[std::size_t(i)];
        constants_[k] = softened(m, m, s, softening_);
        settings_[k] = s;
        names_[k] = m.name + ".mirror";
        lawIndex_[k] = int(laws_.size());
        pairInLaw_[k] = law->addPair(s);
    }
    laws_.push_back(std::move(law));
}


void MaterialTable::setRatio(double chi)
{
    checkRatio(chi);
    softening_.ratio = chi;
    const std::size_t n = materials_.size();
    for (std::size_t i = 0; i < n; ++i)
    {
        for (std::size_t j = i; j < n; ++j)
        {
            if (chi != 1 && !laws_[std::size_t(lawIndex(int(i), int(j)))]->elastic())
            {
                throw inputError
                (
                    "reducedStiffness/ratio", text(chi) + ", but the contact law of "
                  + pairName(int(i), int(j)) + " is not softened", "1"
                );
            }
            constants_[at(int(i), int(j))] = constants_[at(int(j), int(i))] =
                softened(materials_[i], materials_[j], settings(int(i), int(j)), softening_);
        }
        if (!mirrors_) continue;
        constants_[at(int(i), mirror)] =
            softened(materials_[i], materials_[i], settings(int(i), mirror), softening_);
    }
}


int MaterialTable::index(const std::string& name) const
{
    std::string list;
    for (std::size_t i = 0; i < materials_.size(); ++i)
    {
        if (materials_[i].name == name) return int(i);
        list += (list.empty() ? "" : " ") + materials_[i].name;
    }
    throw inputError(name, "no such material", list);
}


double MaterialTable::touchDistance(int i, int j) const
{
    return laws_[std::size_t(lawIndex(i, j))]->touchDistance
    (
        pairInLaw(i, j), constants(i, j)
    );
}


double MaterialTable::wallRadius
(
    int i, int j, const WallCurvature& curvature, double r
) const
{
    if (curvature.flat()) return r;
    return laws_[std::size_t(lawIndex(i, j))]->effectiveRadius
    (
        curvature.smaller(r), curvature.larger(r)
    );
}


ContactFigures MaterialTable::figures
(
    int i, int j, double ri, double rj, double mi, double mj, double speed,
    const WallCurvature& curvature
) const
{
    const PairConstants& p = constants(i, j);
    const ContactLaw& law = *laws_[std::size_t(lawIndex(i, j))];

    ContactFigures f;
    f.R = rj > 0 ? ri*rj/(ri + rj) : wallRadius(i, j, curvature, ri);
    f.m = rj > 0 ? mi*mj/(mi + mj) : mi;
    const int pair = pairInLaw(i, j);
    f.pullOff = law.pullOff(pair, p, f.R);
    f.realPullOff = law.pullOff(pair, p.real(), f.R);
    f.a0 = law.equilibriumRadius(pair, p, f.R);
    f.delta0 = f.a0*f.a0/(3*f.R);
    f.deltaC = law.reach(pair, p, f.R);
    constexpr double atomic = 1.65e-10;     // D_min [m]
    f.tabor = std::cbrt
    (
        4*f.R*p.realGamma*p.realGamma/(p.realE*p.realE*atomic*atomic*atomic)
    );
    const ContactScale scale{p, f.R, f.m, rj > 0 ? f.R : ri};
    double c[maxConstants];
    law.prepare(pair, scale, c);
    const double turning = 1.25*(1/(mi*ri) + (rj > 0 ? 1/(mj*rj) : 0));
    const double history[maxHistory] = {};
    const ContactBound b = law.bound(pair, scale, c, history, turning, 0, speed);
    f.period = b.period;
    const double ii = 2.5/(mi*ri*ri), ij = rj > 0 ? 2.5/(mj*rj*rj) : 0;
    f.stableStep = stabilityBound
    (
        b.stiffness/f.m + std::max(b.rolling*ri*ii, b.rolling*rj*ij) + b.twisting*(ii + ij),
        b.damping/f.m + std::max(b.rollingDamping*ri*ii, b.rollingDamping*rj*ij)
      + b.twistingDamping*(ii + ij)
    );
    const Impact impact = law.impact(pair, scale, speed);
    f.impactOverlap = impact.overlap;
    f.impactTime = impact.time;
    return f;
}


double MaterialTable::reach(int material, double radius, const Walls& walls) const
{
    double longest = 0;
    const auto reachTo = [&](int j, double R)
    {
        const ContactLaw& law = *laws_[std::size_t(lawIndex(material, j))];
        return law.reach(pairInLaw(material, j), constants(material, j), R);
    };
    for (int j = 0; j < int(materials_.size()); ++j)
    {
        // the neck grows with R^(1/3); R is largest on a wall, and larger in a hollow
        longest = std::max({longest, reachTo(j, radius), touchDistance(material, j)});
    }
    for (const WallPatch& p : walls.patches)
    {
        if (!p.curvature || p.curvature->flat()) continue;
        const double R = wallRadius(material, p.material, *p.curvature, radius);
        if (R > radius) longest = std::max(longest, reachTo(p.material, R));
    }
    return longest;
}

}
