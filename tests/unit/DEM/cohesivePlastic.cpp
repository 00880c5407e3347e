// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cohesive plastic law at its kernel, against its closed forms written out here.
#include "ContactBench.hpp"

#include <cfenv>
#include <functional>

using namespace bench;
using formula::pi;
using scene::close;
using scene::near;
using scene::Law;

namespace
{

//- Numbers of one law, with the closed forms
struct Plastic
{
    double Y = 2e8;             // [Pa]
    std::string unloading = "initial";      // initial | average | restitution
    double e = 0.7;
    double attraction = 5e-8;   // [N]
    double buildUp = 0.1;
    double softening = 1;
    double E = 7e10;            // effective modulus [Pa]

    Law law() const
    {
        Law l;
        l.normal = "cohesivePlastic";
        l.E = E;
        l.gamma = 0;
        l.adjust = [p = *this](dem::ContactSettings& s)
        {
            s.normal.values =
            {
                {"yieldStrength", p.Y}, {"attraction", p.attraction},
                {"attractionBuildUp", p.buildUp}, {"softening", p.softening}
            };
            if (p.unloading == "restitution") s.normal.values["restitution"] = p.e;
            else s.normal.words["unloading"] = p.unloading;
        };
        return l;
    }

    double KR(double R) const { return 4*pi*Y*R*softening; }
    double K2(double R, double most) const
    {
        const double a = std::sqrt(2*R*most), modulus = E*std::pow(softening, 1.25);
        const double K =
            unloading == "restitution" ? KR(R)/(e*e)
          : (unloading == "initial" ? 2 : 4.0/3.0)*modulus*a;
        return std::max(K, KR(R));
    }
    double force(double R, double overlap, double most) const
    {
        const double top = KR(R)*most;
        const double repulsion = std::max(0.0, top - K2(R, most)*(most - overlap));
        return repulsion - attraction - buildUp*top;
    }
};

struct Geometry { const char* name; double ri, rj, R; };
const Geometry geometries[] =
{
    {"equal spheres", 1e-6, 1e-6, 0.5e-6},
    {"spheres 1:3", 1e-6, 3e-6, 0.75e-6},
    {"wall", 1e-6, -1, 1e-6}
};

dem::inputError refused(const Law& law)
{
    try
    {
        law.table();
    }
    catch (const dem::inputError& e)
    {
        return e;
    }
    ADD_FAILURE() << "was accepted";
    return {"", "", ""};
}

Law with(const Plastic& p, const std::function<void(dem::ContactSettings&)>& change)
{
    Law law = p.law();
    law.adjust = [first = law.adjust, change](dem::ContactSettings& s)
    {
        first(s);
        change(s);
    };
    return law;
}

}


TEST(cohesivePlastic, loadUnloadReload)
{
    for (const char* unloading : {"initial", "average", "restitution"})
    {
        for (const double softening : {1.0, 0.01})
        {
            for (const Geometry& g : geometries)
            {
                SCOPED_TRACE(std::string(unloading) + ", " + g.name);
                Plastic p;
                p.unloading = unloading;
                p.softening = softening;
                ContactBench b(p.law());
                Placed placed{g.ri, g.rj, 0};
                placed.n = Vec3(2, -1, 2)/3;
                b.add(placed);

                const double unit = 1e-3*g.R;
                double most = 0;
                for (const double f : {0.1, 0.5, 1.0, 0.95, 0.9, 0.3, 0.9, 1.0, 1.5, 1.4, 0.1, 0.0})
                {
                    placed.overlap = f*unit;
                    most = std::max(most, placed.overlap);
                    b.place(0, placed);
                    b.evaluate();
                    const double expected = p.force(g.R, placed.overlap, most);
                    // the overlap of a pair is a small difference of positions
                    const double lost = g.rj > 0 ? 1e-21 : 0;
                    const double tolerance =
                        1e-12*(std::fabs(expected) + p.attraction)
                      + p.K2(g.R, most)*lost;
                    EXPECT_TRUE(near(b.loads(0).forceI, -expected*placed.n, tolerance)) << f;
                    EXPECT_TRUE(near(b.history(0)[0], most, lost));
                }
                placed.overlap = -1e-3*unit;
                b.place(0, placed);
                b.evaluate();
                EXPECT_TRUE(b.ended(0));
            }
        }
    }
}


TEST(cohesivePlastic, printedStiffness)
{
    // K_R = 2 pi Y r of an equal pair, 4 pi Y r on a wall
    Plastic p;
    p.attraction = 0;
    p.buildUp = 0;
    const double r = 1e-6, overlap = 1e-9;
    ContactBench b(p.law());
    EXPECT_TRUE(close(b.normal(r, r, overlap).elastic, 2*pi*p.Y*r*overlap, 1e-14));
    EXPECT_TRUE(close(b.normal(r, -1, overlap).elastic, 4*pi*p.Y*r*overlap, 1e-14));
    // the spot carries 2 Y
    const double a = b.normal(r, -1, overlap).radius;
    EXPECT_TRUE(close(b.normal(r, -1, overlap).elastic/(pi*a*a), 2*p.Y, 1e-14));
}


TEST(cohesivePlastic, elasticBelowItsYield)
{
    // K_2 of the formula crosses K_R at 2 (pi Y/E)^2 R (initial), 9/4 of that (average)
    for (const bool initial : {true, false})
    {
        Plastic p;
        p.unloading = initial ? "initial" : "average";
        p.buildUp = 0;
        const double R = 1e-6;
        const double yield =
            (initial ? 1 : 2.25)*2*std::pow(pi*p.Y/p.E, 2)*R;
        ContactBench b(p.law());
        for (const double f : {0.5, 0.99, 1.01, 2.0})
        {
            double h[dem::maxHistory] = {};
            const std::vector<double> c = b.constants(R, -1);
            const double top = b.law().normalResponse(c.data(), f*yield, h).elastic;
            const double half = b.law().normalResponse(c.data(), 0.5*f*yield, h).elastic;
            const double lost = top + p.attraction - 2*(half + p.attraction);
            if (f < 1) EXPECT_LT(std::fabs(lost), 1e-12*top);
            else EXPECT_GT(lost, 1e-3*top);
        }
    }
}


TEST(cohesivePlastic, againWithTheSameState)
{
    Plastic p;
    ContactBench b(p.law());
    Placed placed{1e-6, -1, 2e-9};
    b.add(placed);
    b.evaluate();
    placed.overlap = 1.9e-9;
    b.place(0, placed);
    b.evaluate();
    const Vec3 force = b.loads(0).forceI;
    const std::vector<double> history = b.history(0);
    for (int k = 0; k < 3; ++k)
    {
        b.evaluate(0);
        EXPECT_EQ(b.loads(0).forceI, force);
        EXPECT_EQ(b.history(0), history);
    }
}


TEST(cohesivePlastic, lanesDoNotMix)
{
    // contacts with different pasts, together and one by one
    Plastic p;
    ContactBench together(p.law()), single(p.law());
    scene::Random random(7);
    std::vector<Placed> placed;
    for (int k = 0; k < 23; ++k)
    {
        placed.push_back({1e-6, k%2 ? -1 : 2e-6, 0});
        together.add(placed.back());
        single.add(placed.back());
    }
    for (int step = 0; step < 50; ++step)
    {
        for (std::size_t k = 0; k < placed.size(); ++k)
        {
            placed[k].overlap = random.uniform(-1e-9, 3e-9);
            together.place(k, placed[k]);
            single.place(k, placed[k]);
        }
        together.evaluate(0, true);
        single.evaluate(0, false);
        for (std::size_t k = 0; k < placed.size(); ++k)
        {
            // to round-off: products and sums may be fused in one of the two
            const dem::Vec3 force = single.loads(k).forceI;
            EXPECT_LE((together.loads(k).forceI - force).norm(), 1e-13*force.norm());
            EXPECT_EQ(together.history(k), single.history(k));
        }
    }
}


TEST(cohesivePlastic, energyIsNeverCreated)
{
    // Work done on the contact over any path from touch to the end, by exact sums over
    // pieces on which the force is linear or nearly so
    scene::Random random(11);
    for (int k = 0; k < 200; ++k)
    {
        Plastic p;
        const char* const kinds[] = {"initial", "average", "restitution"};
        p.unloading = kinds[random.below(3)];
        p.e = random.uniform(0.05, 1);
        p.Y = random.logUniform(1e5, 1e10);
        p.E = random.logUniform(1e6, 1e12);
        p.attraction = random.below(3) ? random.logUniform(1e-10, 1e-6) : 0;
        p.buildUp = random.below(2) ? random.uniform(0, 0.99) : 0;
        p.softening = random.below(2) ? 1 : random.logUniform(1e-4, 1);
        ContactBench b(p.law());
        const double R = random.logUniform(1e-7, 1e-3);
        const std::vector<double> c = b.constants(R, -1);
        double h[dem::maxHistory] = {};
        double overlap = 0, work = 0, paid = 0;
        const auto force = [&](double o)
        {
            return b.law().normalResponse(c.data(), o, h).elastic;
        };
        double last = force(0);
        for (int turn = 0; turn < 6; ++turn)
        {
            const double target = turn < 5 ? random.uniform(0, 0.02*R) : 0;
            const int n = 2000;
            const double from = overlap;
            for (int s = 1; s <= n; ++s)
            {
                const double o = from + (target - from)*s/n;
                const double f = force(o);
                work += 0.5*(f + last)*(o - overlap);
                paid += 0.5*std::fabs(f + last)*std::fabs(o - overlap);
                overlap = o;
                last = f;
            }
        }
        EXPECT_GE(work, -1e-6*paid) << k;
    }
}


TEST(cohesivePlastic, frictionPressesWithTheRepulsion)
{
    Plastic p;
    p.buildUp = 0.2;
    const double mu = 0.4, r = 1e-6, h = 1e-9;
    for (const double softening : {1.0, 0.01})
    {
        p.softening = softening;
        ContactBench b(with(p, [&](dem::ContactSettings& s)
        {
            s.tangential = {"springDashpotSlider", {{"friction", mu}}};
        }));
        Placed placed{r, -1, 2e-9, -Vec3::UnitZ()};
        b.add(placed);
        b.evaluate();

        // a small slip: 8 G a, G = E (1 - nu)/(2 (2 - nu)), softened with the rest
        const double nu = 0.33;
        const double G = p.E*(1 - nu)/(2*(2 - nu))*std::pow(softening, 1.25);
        const double a = std::sqrt(2*r*2e-9);
        placed.overlap = 1.99e-9;
        placed.vI = Vec3(1e-16/h, 0, 0);
        b.place(0, placed);
        b.evaluate(h);
        EXPECT_TRUE(near(b.loads(0).forceI.x(), -8*G*a*1e-16, 1e-12*8*G*a*1e-16));

        // a large one: mu F_R, F_R = F_N + F_c with the build-up of the past load
        placed.vI = Vec3(1e-6/h, 0, 0);
        b.place(0, placed);
        b.evaluate(h);
        const double KR = p.KR(r);
        const double repulsion = KR*2e-9 - p.K2(r, 2e-9)*0.01e-9;
        ASSERT_GT(repulsion, 0);
        EXPECT_TRUE(near(b.loads(0).forceI.x(), -mu*repulsion, 1e-9*mu*repulsion));
    }
}


TEST(cohesivePlastic, pullOffInFigures)
{
    Plastic p;
    const Law law = with(p, [](dem::ContactSettings& s)
    {
        s.normal.values.erase("attraction");
        s.normal.values["attractionPerRadius"] = 0.3;
    });
    const dem::MaterialTable table = law.table();
    const double r = 1e-6, m = law.mass(r);
    const dem::ContactFigures wall = table.figures(0, 1, r, -1, m, 0, 2);
    EXPECT_TRUE(close(wall.pullOff, 0.3*r, 1e-14));
    EXPECT_TRUE(close(table.figures(0, 0, r, r, m, m, 2).pullOff, 0.15*r, 1e-14));
    // without attraction: v (m/K_R)^(1/2); two quarter periods and the flattened part
    const double overlap = 2*std::sqrt(m/p.KR(r));
    EXPECT_TRUE(close(wall.impactOverlap, overlap, 1e-13));
    const double K2 = p.K2(r, overlap), e = std::sqrt(p.KR(r)/K2);
    EXPECT_TRUE(close
    (
        wall.impactTime,
        pi/2*(std::sqrt(m/p.KR(r)) + std::sqrt(m/K2)) + overlap*(1 - e*e)/(2*e), 1e-13
    ));
}


TEST(cohesivePlastic, systemRemembersTheLoad)
{
    // pressed by a force, let go: delta_max stays, the pull-off force is the grown one
    Plastic p;
    p.buildUp = 0.25;
    const Law law = with(p, [](dem::ContactSettings& s)
    {
        s.normal.values["dampingRatio"] = 0.3;
    });
    const double r = 1e-6;
    dem::System system(law.table(), {});
    system.setWalls(scene::floor());
    system.add(scene::sphere(law, 0, r, Vec3(0, 0, r*(1 - 1e-7))));
    dem::GasLoad press;
    press.Su = Vec3(0, 0, -1e-6);
    system.setGasLoad(0, press);
    const double period = 2*pi*std::sqrt(law.mass(r)/p.KR(r));
    for (int k = 0; k < 100; ++k) system.advance(period);
    ASSERT_EQ(system.contacts().size(), 1u);
    const double most = system.contacts()[0].pullOff - p.attraction;
    // overshoot makes it more than that of the static load
    EXPECT_GT(most, p.buildUp*(1e-6 + p.attraction));
    EXPECT_LT(most, 3*p.buildUp*(1e-6 + p.attraction));
    system.setGasLoad(0, {});
    for (int k = 0; k < 20; ++k) system.advance(period);
    ASSERT_EQ(system.contacts().size(), 1u);
    EXPECT_EQ(system.contacts()[0].pullOff - p.attraction, most);
    // the flattened spot is what is left of it
    const double a = system.contacts()[0].contactRadius;
    EXPECT_TRUE(close(p.buildUp*p.KR(r)*a*a/(2*r), most, 1e-12));
}


TEST(cohesivePlastic, input)
{
    using Settings = dem::ContactSettings;
    const Plastic p;
    const auto refusal = [&](const std::function<void(Settings&)>& change)
    {
        return refused(with(p, change));
    };
    const auto has = [](const std::string& text, const char* part)
    {
        return text.find(part) != std::string::npos;
    };

    for (const char* keyword : {"yieldStrength", "attraction", "attractionBuildUp"})
    {
        const dem::inputError e = refusal
        (
            [&](Settings& s) { s.normal.values.erase(keyword); }
        );
        EXPECT_TRUE(has(e.keyword, keyword) && has(e.reason, "missing")) << e.what();
    }
    dem::inputError e = refusal([](Settings& s) { s.normal.words.clear(); });
    EXPECT_TRUE(has(e.keyword, "normal/unloading") && has(e.reason, "missing")) << e.what();
    e = refusal([](Settings& s) { s.normal.values["restitution"] = 0.5; });
    EXPECT_TRUE(has(e.reason, "together")) << e.what();
    e = refusal([](Settings& s) { s.normal.values["attractionPerRadius"] = 0.5; });
    EXPECT_TRUE(has(e.reason, "together")) << e.what();
    e = refusal([](Settings& s) { s.normal.words["unloading"] = "steep"; });
    EXPECT_TRUE(has(e.reason, "steep") && has(e.allowed, "average")) << e.what();
    e = refusal([](Settings& s)
    {
        s.normal.words.clear();
        s.normal.values["unloading"] = 2;
    });
    EXPECT_TRUE(has(e.reason, "number") && has(e.allowed, "initial")) << e.what();
    e = refusal([](Settings& s)
    {
        s.normal.values.erase("yieldStrength");
        s.normal.words["yieldStrength"] = "high";
    });
    EXPECT_TRUE(has(e.reason, "high")) << e.what();
    // K_2 < K_R
    e = refusal([](Settings& s) { s.normal.words.clear(); s.normal.values["restitution"] = 1.1; });
    EXPECT_TRUE(has(e.keyword, "restitution")) << e.what();
    e = refusal([](Settings& s) { s.normal.values["attractionBuildUp"] = 1; });
    EXPECT_TRUE(has(e.keyword, "attractionBuildUp")) << e.what();
    // softening of another kind, rolling of another law
    Law law = p.law();
    law.softening.ratio = 0.01;
    e = refused(law);
    EXPECT_TRUE(has(e.keyword, "normal/model") && has(e.reason, "0.01")) << e.what();
    e = refusal([](Settings& s) { s.rolling = {"springSlider", {{"criticalAngle", 0.01}}}; });
    EXPECT_TRUE(has(e.keyword, "rolling/model") && has(e.allowed, "bending")) << e.what();

    // surface energy zero leaves it as it is
    EXPECT_EQ(p.law().table().settings(0, 1).normal.model, "cohesivePlastic");
}


TEST(cohesivePlastic, nothingTraps)
{
    for (const char* unloading : {"initial", "average", "restitution"})
    {
        for (const double attraction : {0.0, 1e-8})
        {
            Plastic p;
            p.unloading = unloading;
            p.attraction = attraction;
            p.buildUp = attraction > 0 ? 0.3 : 0;
            ContactBench b(with(p, [](dem::ContactSettings& s)
            {
                s.tangential = {"springDashpotSlider", {{"friction", 0.3}}};
                s.rolling = {"bending", {{"bendingFactor", 1}}};
                s.twisting = {"cappedSpring", {{"twistingFactor", 1}}};
            }));
            std::vector<Placed> placed;
            for (const double overlap : {0.0, -1e-9, 1e-300, 1e-9, 1e-7})
            {
                for (const double rj : {-1.0, 1e-6, 1e-3})
                {
                    placed.push_back({1e-6, rj, overlap});
                    b.add(placed.back());
                }
            }
            std::feclearexcept(FE_ALL_EXCEPT);
            b.evaluate(0);
            b.evaluate(1e-9);
            for (const double speed : {0.0, 1e-9, 100.0})
            {
                const double history[dem::maxHistory] = {};
                const double T = b.law().bound
                (
                    b.table().pairInLaw(0, 1), {b.table().constants(0, 1), 1e-6, 1e-15},
                    b.constants(1e-6, -1).data(), history, 1e25, 0, speed
                ).period;
                EXPECT_TRUE(T > 0 && std::isfinite(T));
            }
            EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));
        }
    }
}
