// SPDX-License-Identifier: GPL-3.0-or-later
//
// Materials, and for every pair of them the constants and the contact law, all worked out
// once. Pairs are unordered: (i, j) and (j, i) are the same entry.
#pragma once

#include "materials/ContactSettings.hpp"
#include "materials/Material.hpp"
#include "reducedStiffness/ReducedStiffness.hpp"
#include "walls/Walls.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dem
{

class ContactLaw;

//- Constants of a pair of materials; E and gamma appear as softened and as real
struct PairConstants
{
    double E;               // effective modulus, chi applied [Pa]
    double G;               // effective shear modulus, chi applied [Pa]
    double gamma;           // surface energy of one surface, softened [J/m2]
    double realE;           // [Pa], chi = 1
    double realGamma;       // [J/m2], chi = 1
    double chi;             // E/realE
    double gammaFactor;     // gamma/realGamma; both are exactly the same for all pairs
    bool softened;          // false: the real contact
    bool scaleResistance;   // limits() are softened as well (studies)

    //- The same pair without softening
    PairConstants real() const
    {
        return {realE, G/chi, realGamma, realE, realGamma, 1, 1, false, scaleResistance};
    }

    //- The pair from whose numbers the limits of rolling, sliding and twisting are made
    PairConstants limits() const { return scaleResistance ? *this : real(); }

    //- The gamma of limits() over this one's
    double strengthFactor() const { return scaleResistance ? 1 : 1/gammaFactor; }

    //- The contact radius of limits() over this one's, where it goes with (gamma/E)^(1/3), and
    //  at given impact without adhesion
    double radiusFactor() const
    {
        if (scaleResistance) return 1;
        return gamma > 0 ? std::cbrt(chi/gammaFactor) : std::pow(chi, 0.2);
    }
};

//- Dimensional figures of one contact, for tables and checks
struct ContactFigures
{
    double R, m;            // effective radius [m], mass [kg]
    double pullOff;         // F_C = 3 pi R gamma as softened [N] (DMT: 4 pi R gamma ...)
    double realPullOff;     // at chi = 1 [N]
    double a0, delta0, deltaC;  // equilibrium contact radius and overlap, neck length [m]
    double tabor;           // lambda_T of the real material [-]
    double period;          // shortest period at equilibrium or at impact speed v [s]
    double stableStep;      // stability bound of the contact step, in this contact alone [s]
    double impactTime;      // contact time at v without adhesion and damping [s]
    double impactOverlap;   // peak overlap at v without adhesion and damping [m]
};

class MaterialTable
{
public:

    //- overrides: key "a.b" (either order); complete settings that replace the defaults.
    //  Errors: inputError on impossible numbers, unknown models or keywords, parts that
    //  cannot be combined.
    MaterialTable
    (
        std::vector<Material> materials,
        ContactSettings defaults,
        std::map<std::string, ContactSettings> overrides,
        ReducedStiffness softening
    );

    //- Let walls be mirrors: what each material does there is what it does with its own image,
    //  but without adhesion, friction and loss
    void addMirrors();
    bool mirrors() const { return mirrors_; }

    //- Another chi for all pairs; what else was asked for of the softening stays.
    //  Errors: inputError on what the constructor refuses, too
    void setRatio(double chi);

    const std::vector<Material>& materials() const { return materials_; }
    int index(const std::string& name) const;   // Errors: inputError with the known names
    const ReducedStiffness& softening() const { return softening_; }

    const PairConstants& constants(int i, int j) const { return constants_[at(i, j)]; }
    const ContactSettings& settings(int i, int j) const { return settings_[at(i, j)]; }
    const std::string& pairName(int i, int j) const { return names_[at(i, j)]; }

    //- The law of a pair: laws are shared by all pairs that combine the same parts
    int lawIndex(int i, int j) const { return lawIndex_[at(i, j)]; }
    int pairInLaw(int i, int j) const { return pairInLaw_[at(i, j)]; }
    const std::vector<std::shared_ptr<const ContactLaw>>& laws() const { return laws_; }

    //- Contacts of the pair begin at this gap of the surfaces [m]
    double touchDistance(int i, int j) const;

    //- Effective radius [m] of a sphere of material i and radius r on a wall of material j;
    //  flat: r itself
    double wallRadius(int i, int j, const WallCurvature& curvature, double r) const;

    //- Figures for radii ri, rj (rj <= 0: wall of that curvature) and relative speed [m/s].
    ContactFigures figures
    (
        int i, int j, double ri, double rj, double mi, double mj, double speed,
        const WallCurvature& curvature = {}
    ) const;

    //- Farthest distance beyond touch at which some contact of a sphere of radius r can
    //  still hold (the longest neck) [m], with spheres and these walls
    double reach(int material, double radius, const Walls& walls) const;

private:

    std::size_t at(int i, int j) const
    {
        // the first of a row is its material with mirrors
        return std::size_t(i)*(materials_.size() + 1) + std::size_t(j - mirror);
    }

    std::vector<Material> materials_;
    ReducedStiffness softening_;
    bool mirrors_ = false;
    std::vector<PairConstants> constants_;
    std::vector<ContactSettings> settings_;
    std::vector<std::string> names_;
    std::vector<int> lawIndex_;
    std::vector<int> pairInLaw_;
    std::vector<std::shared_ptr<const ContactLaw>> laws_;
};

}
