// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every combination of parts that the library allows, with sizes, stiffness, surface energy
// and speeds over many decades: approach, slide, leave. Finite; momentum kept to round-off;
// kinetic energy never grows; a wall is a sphere of 1e6 radii.
#include "clouds.hpp"

#include <cstdlib>
#include <set>

using scene::Random;
using dem::Vec3;

namespace
{

//- A value for every keyword that a part may take; of alternatives the first or the second
double sampleValue(const std::string& keyword, Random& random)
{
    if (keyword == "restitution") return random.below(4) ? random.uniform(0.1, 1) : 1;
    if (keyword == "dampingCoefficient") return random.uniform(0, 1);
    if (keyword == "friction") return random.uniform(0, 1);
    if (keyword == "criticalAngle") return random.logUniform(1e-3, 0.1);
    if (keyword == "adhesionHysteresis") return random.logUniform(0.01, 1);
    if (keyword == "rollingDamping") return 0;
    ADD_FAILURE() << "tests/verification/DEM/matrix.cpp needs a sample value for " << keyword;
    return 1;
}

const std::set<std::string> alternatives[] =
{
    {"restitution", "dampingCoefficient"}, {"criticalAngle", "adhesionHysteresis"}
};

dem::PartSettings sample(const dem::PartEntry& entry, Random& random)
{
    dem::PartSettings s;
    s.model = entry.model;
    for (const std::string& keyword : entry.keywords)
    {
        s.values[keyword] = sampleValue(keyword, random);
    }
    for (const auto& group : alternatives)
    {
        const int keep = random.below(int(group.size()));
        int k = 0;
        for (const std::string& keyword : group)
        {
            if (k++ != keep) s.values.erase(keyword);
        }
    }
    return s;
}

//- Allowed combinations, as the table and the library say
std::vector<std::array<dem::PartEntry, 4>> combinations()
{
    std::array<std::vector<dem::PartEntry>, 4> kinds;
    const std::string names[4] = {"normal", "tangential", "rolling", "twisting"};
    for (const dem::PartEntry& e : dem::contactModelTable())
    {
        for (std::size_t k = 0; k < 4; ++k) if (e.kind == names[k]) kinds[k].push_back(e);
    }
    std::vector<std::array<dem::PartEntry, 4>> result;
    Random random(1);
    for (const auto& n : kinds[0])
    {
        for (const auto& t : kinds[1])
        {
            for (const auto& r : kinds[2])
            {
                for (const auto& w : kinds[3])
                {
                    dem::ContactSettings s
                    {
                        sample(n, random), sample(t, random), sample(r, random),
                        sample(w, random), {}, {}
                    };
                    try
                    {
                        dem::MaterialTable({{"dust", 1000, 1e8, 0.3, 0.1}}, s, {}, {});
                    }
                    catch (const dem::inputError&)
                    {
                        continue;
                    }
                    result.push_back({n, t, r, w});
                }
            }
        }
    }
    return result;
}

struct Case
{
    std::array<dem::PartEntry, 4> parts;
    unsigned seed;
};

struct Outcome
{
    bool skipped = false;
    bool rebounded = false;     // left by itself
    double energyRatio = 0;     // kinetic energy after over before, if it rebounded
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
    const dem::ContactSettings settings
    {
        sample(c.parts[0], random), sample(c.parts[1], random),
        sample(c.parts[2], random), sample(c.parts[3], random), {}, {}
    };
    const double tangential = random.logUniform(0.01, 3);
    const double spin = random.logUniform(0.01, 3);
    const Vec3 slideWay = random.direction(), spinWay1 = random.direction();
    const Vec3 spinWay2 = random.direction();
    const double steps = random.below(2) ? 50 : random.uniform(30, 200);

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
    // contact laws are for small overlaps
    if (f.impactOverlap + f.delta0 > 0.1*smaller)
    {
        result.skipped = true;
        return result;
    }

    dem::TimeSettings time;
    time.stepsPerContact = steps;
    time.restTolerance = 0;
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
    // just apart: the first contact is made by the flight
    const double gap = 1e-3*smaller;
    system.add({1, 0, r1, mass(r1), Vec3(0, 0, r1 + gap), v, spin*speed/r1*spinWay1});
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
    double period = f.impactTime;
    if (f.a0 > 0)
    {
        period += 2*formula::pi*std::sqrt(f.m*f.a0*f.a0/(3.6*std::max(f.pullOff, 1e-300)*f.R));
    }
    dem::StepReport report;
    report.add(system.advance(gap/speed + 2.5*period));
    EXPECT_EQ(report.touches >= 1, true) << text;
    result.rebounded = system.contacts().empty();
    result.overlap = report.maxOverlapOverDiameter;
    if (result.rebounded) result.energyRatio = energy()/energy0;

    // Leave: what holds is pulled off
    double pulled = 0;
    for (int k = 0; k < 40 && !system.contacts().empty(); ++k)
    {
        pulled = 5*f.pullOff + f.m*speed/period;
        for (std::size_t i = 0; i < system.size(); ++i)
        {
            dem::GasLoad g;
            g.Su = (i ? pulled : -pulled)*n;
            system.setGasLoad(i, g);
        }
        report.add(system.advance(period));
    }
    EXPECT_TRUE(system.contacts().empty()) << "holds on: " << text;
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
          + 1e-16*(momentum0.norm() + f.m*speed + pulled*period);
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
    // all but twisting without sliding
    std::size_t normal = 0, tangential = 0, rolling = 0, twisting = 0;
    for (const dem::PartEntry& e : dem::contactModelTable())
    {
        normal += e.kind == "normal";
        tangential += e.kind == "tangential" && e.model != "none";
        rolling += e.kind == "rolling";
        twisting += e.kind == "twisting" && e.model != "none";
    }
    EXPECT_GE(normal, 4u);
    EXPECT_EQ(combinations().size(), normal*rolling*(1 + tangential*(1 + twisting)));
}


TEST(matrix, approachSlideLeave)
{
    int ran = 0, skipped = 0, rebounds = 0;
    double worst = 0;
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
            if (o.rebounded)
            {
                ++rebounds;
                worst = std::max(worst, o.energyRatio);
                EXPECT_LE(o.energyRatio, 1.01) << o.text;
            }
            if (HasFatalFailure()) return;
        }
    }
    std::printf
    (
        "%d cases (%d rebounds), %d with too large overlaps left out, largest energy ratio %.6f\n",
        ran, rebounds, skipped, worst
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
            // positions of the size of 1e6 r have an error of 1e-10 r
            if (w.skipped || !w.rebounded || w.overlap < 1e-3) continue;
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
