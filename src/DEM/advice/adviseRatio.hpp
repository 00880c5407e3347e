// SPDX-License-Identifier: GPL-3.0-or-later
//
// THE softest chi = E_mod/E that keeps to all limits. With gamma_mod = gamma chi^(2/5) forces of
// contacts fall as chi^(2/5), overlaps and contact times grow as chi^(-2/5) (ReducedStiffness.hpp),
// so that each limit has its own softest chi in closed form, and the largest of them rules:
//
//     pullOffOverForce M    F_C chi^(2/5) >= M f F          chi >= (M f F/F_C)^(5/2)
//     overlap           o   delta/d chi^(-2/5) <= o         chi >= (delta/(o d))^(5/2)
//     tabor             L   lambda_T chi^(-2/5) <= L        chi >= (lambda_T/L)^(5/2)
//     contactTime       q   t chi^(-2/5) <= q tau           chi >= (t/(q tau))^(5/2)
//     ratio                 chi >= ratio  (packings of softer ones are too dense)
//
// F: force on one particle at the largest slip of the case, F_C: real pull-off force, f (loadFactor):
// how many times F a bond has to carry, because chains hang on it and the gas speeds up between
// deposits; delta: real overlap where an impact at that speed without damping is deepest, without
// speed that of the fall into contact (0.6215 a0^2/R of JKR, 2.5^(2/3) a0^2/R of DMT: deeper than
// equilibrium); d: diameter of the smaller; L: largest Tabor number of the law (none for JKR, whose
// number only grows as it is softened); t: real contact time of that impact without adhesion;
// tau: relaxation time m/Sp at that slip.
// With surfaceEnergy `unchanged` pull-off forces stay, and what adhesion brings about grows faster,
// at most as chi^(-2/3): (..)^(3/2) instead.
// Source: Haervig et al. 2017; Chen, Liu & Li 2019, eq. 17.
// Proof: tests/unit/DEM/adviseRatio.cpp
#pragma once

#include "materials/MaterialTable.hpp"
#include "walls/Walls.hpp"

#include <string>
#include <vector>

namespace dem
{

struct RatioLimits
{
    double pullOffOverForce = 100;  // M
    double overlap = 0.01;          // o, of the diameter
    double ratio = 1e-3;
    double loadFactor = 10;         // f
    double contactTime = 0.1;       // q, of the relaxation time
};

//- What particles of one size meet
struct RatioLoad
{
    double radius, mass;    // [m], [kg]
    double force;           // F [N]; 0: nothing pulls
    double speed;           // of their fastest impact [m/s]
    double relaxationTime;  // tau [s]; 0: no drag
};

//- What particles can touch: others of them, or a wall
struct RatioPartner
{
    int material;
    bool wall;
    WallCurvature curvature;
    std::string name;       // e.g. "dust.steel(screen)"

    //- Of another particle [m], [kg]; 0: of the same size
    double radius = 0, mass = 0;
};

//- Those in this scene: materials that no wall has touch nothing
std::vector<RatioPartner> ratioPartners
(
    const MaterialTable& table, int dust, const Walls& walls
);

//- One limit, for the pair and the size where it asks for the stiffest
struct RatioNeed
{
    std::string limit;      // pullOffOverForce | overlap | tabor | contactTime | ratio | law
    double chi;             // the softest that keeps it, above 1: none does; infinite: nor does
                            // any come nearer to it
    double real;            // what it limits, unsoftened: margin f = 1, delta/d, lambda_T, t/tau
    double bound;           // the limit
    std::string pair;       // "" where the limit asks nobody
    double diameter;        // [m]
};

struct RatioAdvice
{
    double chi = 1;                 // the softest that keeps all limits, at most 1
    double loadFactor = 1;
    std::vector<RatioNeed> needs;   // one per limit that there is something to say of

    //- The one that asks for the stiffest, of those that chi does something for
    const RatioNeed& binding() const;

    //- Some chi, at most 1, keeps all limits
    bool reached() const;

    //- The limit of that name; nullptr: nothing to say of it
    const RatioNeed* find(const std::string& limit) const;

    //- Lines about all of them, each with an end of line
    std::string text() const;
};

//- loads: one for each size; each is taken with partners of its own size, if they have none given.
//  The softening of the table does not matter, but for whether surface energy is scaled.
RatioAdvice adviseRatio
(
    const MaterialTable& table, int dust, const std::vector<RatioPartner>& partners,
    const std::vector<RatioLoad>& loads, const RatioLimits& limits
);

//- Particles of one material
struct RatioDust
{
    int material;
    std::vector<RatioLoad> loads;   // by size, the smallest first
};

//- The softest for all: each limit takes the stiffest that any of the materials asks for. A particle
//  meets walls, those of its material and size, and of each other material the one whose size is the
//  nearest; the smaller of two is the one that is held.
RatioAdvice adviseRatio
(
    const MaterialTable& table, const std::vector<RatioDust>& dusts, const Walls& walls,
    const RatioLimits& limits
);

//- While running: by how much of a margin more than needed chi is raised, so that not every look
//  at a load that grows raises it again
inline constexpr double stiffeningHeadroom = 1.2;

//- chi for a run that finds the pull-off force `margin` times the load, less than the limit:
//      chi (headroom limit/margin)^(5/2),  at most 1
double stiffenedRatio(double chi, double margin, double limit);

}
