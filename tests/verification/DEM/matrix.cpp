// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every combination of parts that the library allows, with sizes, stiffness, surface energy
// and speeds over many decades: approach, slide, leave. Finite; momentum kept to round-off;
// the energy ledger closes to 1e-3 of the input with 125 steps per contact or more, and to
// (125/steps)^2 of that with fewer; kinetic energy grows by no more than the springs gave; a
// wall is a sphere of 1e6 radii.
#include "clouds.hpp"

#include <array>
#include <cstdlib>
#include <map>
#include <set>

using scene::Random;
using dem::Vec3;

namespace
{

//- What the samples are made for
struct Scale { double E, R; };

//- A value for every keyword that a part may take
double sampleValue(const std::string& keyword, const Scale& s, Random& random)
{
    if (keyword == "restitution") return random.below(4) ? random.uniform(0.1, 1) : 1;
    if (keyword == "dampingCoefficient") return random.uniform(0, 1);
    if (keyword == "friction") return random.uniform(0, 1);
    if (keyword == "criticalAngle") return random.logUniform(1e-3, 0.1);
    if (keyword == "adhesionHysteresis") return random.logUniform(0.01, 1);
    if (keyword == "rollingDamping") return 0;
    if (keyword == "cutOff") return random.uniform(1.65e-10, 4e-10);
    if (keyword == "range") return random.logUniform(2e-9, 2e-8);
    if (keyword == "yieldStrength") return s.E*random.logUniform(1e-3, 1e-2);
    if (keyword == "attraction") return 3*formula::pi*s.R*random.logUniform(1e-4, 0.1);
    if (keyword == "attractionPerRadius") return 3*formula::pi*random.logUniform(1e-4, 0.1);
    if (keyword == "attractionBuildUp") return random.uniform(0, 0.3);
    if (keyword == "softening") return random.below(2) ? 1 : random.logUniform(1e-2, 1);
    if (keyword == "dampingRatio") return random.uniform(0, 0.3);
    if (keyword == "bendingFactor") return random.uniform(0.1, 2);
    if (keyword == "twistingFactor") return random.uniform(0.1, 1);
    if (keyword == "twistingDamping") return 0;
    ADD_FAILURE() << "tests/verification/DEM/matrix.cpp needs a sample value for " << keyword;
    return 1;
}

//- Keywords of which a part takes exactly one; some are words
const std::vector<std::string> alternatives[] =
{
    {"restitution", "dampingCoefficient"}, {"restitution", "unloading"},
    {"criticalAngle", "adhesionHysteresis"}, {"attraction", "attractionPerRadius"}
};
const std::map<std::string, std::vector<std::string>> words
{
    {"unloading", {"initial", "average"}}
};

dem::PartSettings sample(const dem::PartEntry& entry, const Scale& scale, Random& random)
{
    std::set<std::string> taken;
    for (const dem::PartKeyword& k : entry.keywords) taken.insert(k.name);
    for (const auto& group : alternatives)
    {
        const bool all = taken.count(group[0]) && taken.count(group[1]);
        const int drop = random.below(2);
        if (all) taken.erase(group[std::size_t(drop)]);
    }
    dem::PartSettings s;
    s.model = entry.model;
    for (const std::string& keyword : taken)
    {
        const auto word = words.find(keyword);
        if (word == words.end()) s.values[keyword] = sampleValue(keyword, scale, random);
        else s.words[keyword] = word->second[std::size_t(random.below(2))];
    }
    return s;
}

using Parts = std::array<dem::PartEntry, 4>;

//- Every combination of parts that the table lists
std::vector<Parts> allCombinations()
{
    std::array<std::vector<dem::PartEntry>, 4> kinds;
    const std::string names[4] = {"normal", "tangential", "rolling", "twisting"};
    for (const dem::PartEntry& e : dem::contactModelTable())
    {
        for (std::size_t k = 0; k < 4; ++k) if (e.kind == names[k]) kinds[k].push_back(e);
    }
    std::vector<Parts> result;
    for (const auto& n : kinds[0])
    {
        for (const auto& t : kinds[1])
        {
            for (const auto& r : kinds[2])
            {
                for (const auto& w : kinds[3]) result.push_back({n, t, r, w});
            }
        }
    }
    return result;
}

dem::ContactSettings sample(const Parts& parts, const Scale& scale, Random& random)
{
    dem::ContactSettings s;
    s.normal = sample(parts[0], scale, random);
    s.tangential = sample(parts[1], scale, random);
    s.rolling = sample(parts[2], scale, random);
    s.twisting = sample(parts[3], scale, random);
    return s;
}

bool accepted(const Parts& parts)
{
    Random random(1);
    try
    {
        dem::MaterialTable
        (
            {{"dust", 1000, 1e8, 0.3, 0.1}}, sample(parts, {1e8, 1e-6}, random), {}, {}
        );
    }
    catch (const dem::inputError& e)
    {
        EXPECT_NE(e.keyword.find("/model"), std::string::npos) << e.what();
        return false;
    }
    return true;
}

std::vector<Parts> combinations()
{
    std::vector<Parts> result;
    for (const Parts& p : allCombinations()) if (accepted(p)) result.push_back(p);
    return result;
}

struct Case
{
    Parts parts;
    unsigned seed;
};

struct Outcome
{
    bool skipped = false;
    bool rebounded = false;     // left by itself
    double energyRatio = 0;     // kinetic energy after over before, if it rebounded
    double gain = 0;            // kinetic energy that nobody gave, over all exchanged
    double residual = 0;        // of the energy ledger, over all that was exchanged
    double allowed = 0;         // of both
    double adhesive = 0;        // adhesion energy over kinetic energy along the normal
    Vec3 v, omega;              // of the first sphere
    double overlap = 0;         // largest, over the smaller diameter
    std::string text;
};

//- Run one case as a pair (hugeWall false, wall false), with a wall, or with a sphere of
//  1e6 radii in place of the wall
enum Partner { pair, wall, huge };

Outcome run(const Case& c, Partner partner)
{
    Random random(c.seed);
    Outcome result;

    // Sizes, materials
    const double r1 = 0.5*random.logUniform(0.5e-6, 1e-3);
    const double ratio = random.logUniform(1, 100);
    const double r2 = random.below(2) ? std::max(0.25e-6, r1/ratio) : std::min(0.5e-3, r1*ratio);
    const double E = random.logUniform(1e6, 1e12);
    const double nu = random.uniform(0, 0.5);
    const double gamma = random.below(5) ? random.logUniform(1e-4, 1) : 0;
    const double density = random.logUniform(200, 8000);
    const double speed = random.logUniform(1e-6, 100);
    dem::ReducedStiffness softening;
    softening.ratio = random.below(2) ? 1 : random.logUniform(1e-3, 1);
    // plastic contacts have a softening of their own
    if (c.parts[0].model == "cohesivePlastic") softening.ratio = 1;
    const dem::ContactSettings settings =
        sample(c.parts, {E/(2*(1 - nu*nu)), r1/2}, random);
    const double tangential = random.logUniform(0.01, 3);
    const double spin = random.logUniform(0.01, 3);
    const Vec3 slideWay = random.direction(), spinWay1 = random.direction();
    const Vec3 spinWay2 = random.direction();
    const double steps = random.below(2) ? 125 : random.uniform(30, 250);

    char text[300];
    std::snprintf
    (
        text, sizeof text,
        "seed %u %s+%s+%s+%s partner %d r %.3g %.3g E %.3g gamma %.3g rho %.3g v %.3g"
        " chi %.3g steps %.0f",
        c.seed, c.parts[0].model.c_str(), c.parts[1].model.c_str(), c.parts[2].model.c_str(),
        c.parts[3].model.c_str(), int(partner), r1, r2, E, gamma, density, speed,
        softening.ratio, steps
    );
    result.text = text;

    const dem::MaterialTable table
    (
        {{"dust", density, E, nu, gamma}}, settings, {}, softening
    );
    const auto mass = [&](double r) { return density*4.0/3.0*formula::pi*r*r*r; };
    const double rj = partner == pair ? r2 : partner == huge ? 1e6*r1 : -1;
    const dem::ContactFigures f =
        table.figures(0, 0, r1, rj, mass(r1), rj > 0 ? mass(rj) : 0, speed);
    const double smaller = rj > 0 ? std::min(r1, rj) : r1;
    double period = f.impactTime;
    if (f.a0 > 0)
    {
        period += 2*formula::pi*std::sqrt(f.m*f.a0*f.a0/(3.6*std::max(f.pullOff, 1e-300)*f.R));
    }
    // contact laws are for small overlaps; and what creeps through the range of an
    // attraction does so for ever
    const double range = table.touchDistance(0, 0);
    if (f.impactOverlap + f.delta0 > 0.1*smaller || range > 100*period*speed)
    {
        result.skipped = true;
        return result;
    }

    dem::TimeSettings time;
    time.stepsPerContact = steps;
    time.restTolerance = 0;
    time.energyLedger = true;
    dem::System system(table, time);
    if (partner == wall)
    {
        dem::Walls walls = scene::floor();
        walls.patches[0].material = 0;
        system.setWalls(walls);
    }
    const Vec3 n(0, 0, -1);
    const Vec3 slide = (slideWay - slideWay.dot(n)*n).normalized();
    const Vec3 v = speed*(n + tangential*slide);
    // just apart: the first contact is made by the flight, along n
    const double gap = std::max(1e-3*smaller, 1.01*range);
    system.add
    (
        {1, 0, r1, mass(r1), Vec3(0, 0, r1) - gap/speed*v, v, spin*speed/r1*spinWay1}
    );
    if (rj > 0)
    {
        system.add
        (
            {
                2, 0, rj, mass(rj), Vec3(0, 0, -rj), Vec3::Zero(),
                partner == pair ? Vec3(spin*speed/rj*spinWay2) : Vec3(Vec3::Zero())
            }
        );
    }

    const auto momentum = [&]
    {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            sum += system.particle(i).mass*system.particle(i).v;
        }
        return sum;
    };
    const auto energy = [&]
    {
        double sum = 0;
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            const dem::Particle& p = system.particle(i);
            sum +=
                0.5*p.mass*p.v.squaredNorm()
              + 0.2*p.mass*p.radius*p.radius*p.omega.squaredNorm();
        }
        return sum;
    };
    const Vec3 momentum0 = momentum();
    const double energy0 = energy();

    // Approach and slide
    dem::StepReport report;
    report.add(system.advance(gap/speed + 2.5*period));
    EXPECT_EQ(report.touches >= 1, true) << text;
    result.rebounded = system.contacts().empty();
    result.overlap = report.maxOverlapOverDiameter;
    // van der Waals: twice the cut-off
    const double adhesion = f.pullOff*(f.delta0 + f.deltaC + 1e-9);
    const auto checkEnergy = [&]
    {
        const dem::EnergyLedger& e = report.energy;
        const double exchanged =
            energy0 + adhesion + std::fabs(e.normal) + std::fabs(e.gas) + std::fabs(e.springGain);
        result.allowed = 1e-3*std::max(1.0, std::pow(125/steps, 2));
        result.residual = std::max(result.residual, std::fabs(e.residual())/exchanged);
        EXPECT_TRUE(scene::near(e.kinetic, energy() - energy0, 1e-9*exchanged)) << text;
        return exchanged;
    };
    const double exchanged = checkEnergy();
    if (result.rebounded)
    {
        result.energyRatio = energy()/energy0;
        result.gain = (energy() - energy0 - report.energy.springGain)/exchanged;
        result.adhesive = adhesion/(0.5*f.m*speed*speed);
    }

    // Leave: what holds is pulled off
    double pulled = 0;
    for (int k = 0; k < 40 && !system.contacts().empty(); ++k)
    {
        // ever harder: what was pressed may hold with more than the pull-off force of before
        pulled = (5*f.pullOff + f.m*speed/period)*std::pow(1.3, k);
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            dem::GasLoad g;
            g.Su = (i ? pulled : -pulled)*n;
            system.setGasLoad(i, g);
        }
        report.add(system.advance(period));
    }
    EXPECT_TRUE(system.contacts().empty()) << "holds on: " << text;
    checkEnergy();
    for (std::size_t i = 0; i < system.size(); ++i)
    {
        const dem::Particle& p = system.particle(i);
        EXPECT_TRUE(p.x.allFinite() && p.v.allFinite() && p.omega.allFinite()) << text;
    }
    if (partner == pair)
    {
        // round-off of every step, of the momentum that goes to and fro
        const double scale =
            (mass(r1) + mass(rj))*1e-16*(system.particle(0).v.norm()*mass(r1)
          + system.particle(1).v.norm()*mass(rj))/(mass(r1) + mass(rj))
          + 1e-16
           *(
                momentum0.norm() + std::sqrt(f.m*(f.m*speed*speed + 2*adhesion))
              + pulled*period
            );
        const double allowed = 10*double(report.contactSteps + 100)*scale;
        EXPECT_LE((momentum() - momentum0).norm(), allowed) << text;
    }
    result.v = system.particle(0).v;
    result.omega = system.particle(0).omega;
    return result;
}

int casesPerCombination()
{
    const char* isLong = std::getenv("DUSTFOAM_LONG");
    return isLong && std::string(isLong) == "1" ? 200 : 12;
}

}


TEST(matrix, combinationsThatAreAllowed)
{
    // all but these: a limit must come from the part that it belongs to, and rolling by
    // adhesion hysteresis belongs to elastic contacts
    int allowed = 0;
    for (const Parts& p : allCombinations())
    {
        const std::string& normal = p[0].model;
        const std::string& tangential = p[1].model;
        const std::string& rolling = p[2].model;
        const std::string& twisting = p[3].model;
        const bool expected =
            !(twisting == "springDashpotSlider" && tangential == "none")
         && !(twisting == "cappedSpring" && rolling != "bending")
         && !(normal == "cohesivePlastic" && rolling == "springSlider");
        EXPECT_EQ(accepted(p), expected)
            << normal << " " << tangential << " " << rolling << " " << twisting;
        allowed += expected;
    }
    EXPECT_GT(allowed, 20);
}


TEST(matrix, approachSlideLeave)
{
    int ran = 0, skipped = 0, rebounds = 0;
    double worst = 0, open = 0;
    unsigned seed = 1;
    for (const auto& parts : combinations())
    {
        for (int k = 0; k < casesPerCombination();)
        {
            const Case c{parts, seed++};
            Outcome o = run(c, k%2 ? wall : pair);
            if (o.skipped)
            {
                ++skipped;
                continue;
            }
            ++k;
            ++ran;
            open = std::max(open, o.residual/o.allowed);
            EXPECT_LE(o.residual, o.allowed) << o.text;
            if (o.rebounded)
            {
                ++rebounds;
                worst = std::max(worst, o.gain);
                EXPECT_LE(o.gain, o.allowed) << o.energyRatio << " " << o.text;
            }
            if (HasFatalFailure()) return;
        }
    }
    std::printf
    (
        "%d cases (%d rebounds), %d with too large overlaps or slow left out, largest gain of energy %.2e, "
        "largest residual of the ledger %.2f of what is allowed\n",
        ran, rebounds, skipped, worst, open
    );
    EXPECT_GT(rebounds, ran/4);
}


TEST(matrix, wallIsASphereOfAMillionRadii)
{
    int compared = 0;
    unsigned seed = 100000;
    for (const auto& parts : combinations())
    {
        for (int k = 0, tries = 0; k < casesPerCombination()/4 && tries < 2000; ++tries)
        {
            const Case c{parts, seed++};
            const Outcome w = run(c, wall);
            // positions of the size of 1e6 r have an error of 1e-10 r; and what has nearly
            // stuck depends on the last digits
            if (w.skipped || !w.rebounded || w.overlap < 1e-3 || w.adhesive > 0.3) continue;
            const Outcome h = run(c, huge);
            ++k;
            ++compared;
            EXPECT_TRUE(h.rebounded) << w.text;
            EXPECT_TRUE(scene::near(h.v, w.v, 1e-3*w.v.norm())) << w.text;
            EXPECT_TRUE(scene::near(h.omega, w.omega, 1e-3*w.omega.norm())) << w.text;
        }
    }
    EXPECT_GT(compared, 20);
    std::printf("%d cases compared\n", compared);
}
