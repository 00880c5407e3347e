// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bending and its twisting at the kernels: stiffness, caps, what they are made from.
#include "ContactBench.hpp"

#include <cfenv>

using namespace bench;
using formula::pi;
using scene::close;
using scene::near;
using scene::Law;

namespace
{

constexpr double bf = 1.7, tf = 0.6;

Law lawOf(const std::string& normal)
{
    Law law;
    law.normal = normal;
    law.gamma = 0.02;
    law.E = normal == "cohesivePlastic" ? 7e10 : 2.71e8;
    law.adjust = [normal](dem::ContactSettings& s)
    {
        if (normal == "vanDerWaals")
        {
            s.normal.values["cutOff"] = 4e-10;
            s.normal.values["range"] = 1e-8;
        }
        if (normal == "cohesivePlastic")
        {
            s.normal.values =
            {
                {"yieldStrength", 2e8}, {"restitution", 0.7}, {"attraction", 5e-8},
                {"attractionBuildUp", 0.1}, {"softening", 0.25}
            };
        }
        s.rolling = {"bending", {{"bendingFactor", bf}}};
        s.twisting = {"cappedSpring", {{"twistingFactor", tf}}};
    };
    return law;
}

const char* const laws[] = {"JKR", "simplifiedJKR", "DMT", "vanDerWaals", "cohesivePlastic"};

struct Strength { double Fc, K; };

//- F_c and K'_R as physics.md has them; plastic at a past overlap `most`
Strength strengthOf(const Law& law, double ri, double rj, double most, bool scaled = false)
{
    const formula::Contact c = law.contact(ri, rj, !scaled);
    if (law.normal == "cohesivePlastic")
    {
        const double K = 4*pi*2e8*c.R;
        return {5e-8 + 0.1*0.25*K*most, scaled ? 0.25*K : K};
    }
    if (law.normal == "DMT" || law.normal == "vanDerWaals")
    {
        return {4*pi*c.R*c.gamma, 2*c.E*std::cbrt(3*pi*c.gamma*c.R*c.R/c.E)};
    }
    // the slope of the JKR curve at its equilibrium, by differences
    const auto force = [&](double o) { return formula::normal("JKR", c, o, 1).force; };
    const double d = 1e-4*c.delta0();
    return {c.pullOff(), (force(c.delta0() + d) - force(c.delta0() - d))/(2*d)};
}

double pastOf(const Law& law) { return law.normal == "cohesivePlastic" ? 3e-9 : 0; }

}


TEST(bending, stiffnessAndCap)
{
    const double h = 1e-9;
    for (const char* normal : laws)
    {
        for (const double rj : {-1.0, 1e-6, 2.5e-6})
        {
            SCOPED_TRACE(normal + (", rj " + scene::text(rj)));
            const Law law = lawOf(normal);
            const double ri = 1e-6, R = rj > 0 ? ri*rj/(ri + rj) : ri;
            const double overlap = 3e-9;
            const Strength s = strengthOf(law, ri, rj, pastOf(law));
            const double K = R*s.Fc/2;
            const double cap = bf*s.Fc/2*std::sqrt(R*s.Fc/s.K);

            // pure rolling of the pair: one turns, the other stands, no slip velocity
            // enters v_L for equal spheres; else it does by the skew
            const double skew = rj > 0 ? 0.5*(ri - rj)/(ri + rj) : -0.5;
            const Vec3 n = Vec3(1, 2, -2)/3;
            const Vec3 w = Vec3(2, -1, 0)/std::sqrt(5.0);
            for (const double angle : {0.3*cap/K, 5*cap/K})
            {
                ContactBench b(law);
                Placed p{ri, rj, overlap, n};
                b.add(p);
                b.evaluate(0);
                p.wI = w*angle/h;
                b.place(0, p);
                b.evaluate(h);
                const Vec3 slip = (ri*p.wI).cross(n)*h;
                const Vec3 xi = R*(p.wI*h).cross(n) + skew*slip;
                Vec3 expected = -s.Fc/2*n.cross(xi);
                if (expected.norm() > cap) expected *= cap/expected.norm();
                EXPECT_TRUE(near(b.loads(0).torqueI, expected, 1e-6*cap));
                EXPECT_TRUE(near(b.loads(0).torqueI.dot(n), 0.0, 1e-12*cap));
                if (rj > 0)
                {
                    EXPECT_TRUE(near
                    (
                        b.loads(0).torqueJ, Vec3(-b.loads(0).torqueI), 1e-15*cap
                    ));
                }
            }

            // twisting
            for (const double angle : {0.3*tf*cap/K, 5*tf*cap/K})
            {
                ContactBench b(law);
                Placed p{ri, rj, overlap, n};
                b.add(p);
                b.evaluate(0);
                p.wI = n*angle/h;
                b.place(0, p);
                b.evaluate(h);
                const double expected = std::min(K*angle, tf*cap);
                EXPECT_TRUE(near(b.loads(0).torqueI, Vec3(-expected*n), 1e-6*cap));
                // unloads at once
                p.wI = -0.1*tf*cap/K*n/h;
                b.place(0, p);
                b.evaluate(h);
                EXPECT_TRUE(near
                (
                    b.loads(0).torqueI, Vec3(-(expected - 0.1*tf*cap)*n), 1e-6*cap
                ));
            }

            // what the rest of the library is told
            const ContactBench b(law);
            const double first = strengthOf(law, ri, rj, 0).Fc;
            EXPECT_TRUE(close
            (
                b.law().rollingYield(b.constants(ri, rj).data(), R).moment,
                bf*first/2*std::sqrt(R*first/s.K), 1e-6
            ));
        }
    }
}


TEST(bending, isAnEighthOfTheJKRStiffness)
{
    Law law = lawOf("JKR");
    const double r = 1e-6, h = 1e-9;
    const formula::Contact c = law.contact(r, -1);
    double torque[2];
    for (const bool walton : {true, false})
    {
        if (!walton) law.adjust = nullptr;
        law.criticalAngle = 1;
        ContactBench b(law);
        Placed p{r, -1, c.delta0()};
        p.wI = Vec3(0, 0, 1e-9/h);
        b.add(p);
        b.evaluate(h);
        torque[walton] = b.loads(0).torqueI.norm();
    }
    EXPECT_TRUE(close(torque[1]/torque[0], 0.125, 1e-9));
}


TEST(bending, strengthUnderSoftening)
{
    // chi of elastic laws, s_f of cohesivePlastic: the original strength, or the softened
    for (const char* normal : laws)
    {
        for (const bool scaled : {false, true})
        {
            SCOPED_TRACE(normal);
            Law law = lawOf(normal);
            const bool plastic = law.normal == "cohesivePlastic";
            law.softening = {plastic ? 1 : 0.01, true, scaled};
            const double r = 1e-6;
            const Strength s = strengthOf(law, r, -1, 0, scaled);
            const ContactBench b(law);
            const double yield = b.law().rollingYield(b.constants(r, -1).data(), r).moment;
            EXPECT_TRUE(close(yield, bf*s.Fc/2*std::sqrt(r*s.Fc/s.K), 1e-6));

            // B_max goes with F_c^(3/2)/K'_R^(1/2): chi^(3/5 - 2/5)
            Law real = lawOf(normal);
            const ContactBench original(real);
            const double whole =
                original.law().rollingYield(original.constants(r, -1).data(), r).moment;
            const double expected = !scaled ? 1 : plastic ? 2 : std::pow(0.01, 0.2);
            EXPECT_TRUE(close(yield/whole, expected, 1e-9));
        }
    }
}


TEST(bending, dashpots)
{
    Law law = lawOf("JKR");
    law.adjust = [](dem::ContactSettings& s)
    {
        s.rolling = {"bending", {{"bendingFactor", bf}, {"rollingDamping", 3e-9}}};
        s.twisting = {"cappedSpring", {{"twistingFactor", tf}, {"twistingDamping", 2e-18}}};
    };
    const double r = 1e-6;
    ContactBench b(law);
    Placed p{r, -1, law.contact(r, -1).delta0(), -Vec3::UnitZ()};
    p.vI = Vec3(2e-3, 0, 0);
    p.wI = Vec3(0, 2e-3/r, 40);
    b.add(p);
    b.evaluate(0);
    EXPECT_TRUE(near(b.loads(0).torqueI, Vec3(0, -3e-9*2e-3, -2e-18*40), 1e-24));
}


TEST(bending, combinations)
{
    // every combination of names either is refused with a teaching word, or works
    int works = 0, refused = 0;
    for (const dem::PartEntry& n : dem::contactModelTable())
    for (const dem::PartEntry& t : dem::contactModelTable())
    for (const dem::PartEntry& r : dem::contactModelTable())
    for (const dem::PartEntry& w : dem::contactModelTable())
    {
        if
        (
            n.kind != "normal" || t.kind != "tangential"
         || r.kind != "rolling" || w.kind != "twisting"
        )
        {
            continue;
        }
        Law law = lawOf(n.model);
        law.adjust = [&, first = law.adjust](dem::ContactSettings& s)
        {
            first(s);
            s.tangential = {t.model, {}};
            if (t.model != "none") s.tangential.values = {{"friction", 0.3}};
            s.rolling = {r.model, {}};
            if (r.model == "bending") s.rolling.values = {{"bendingFactor", bf}};
            if (r.model == "springSlider") s.rolling.values = {{"criticalAngle", 0.01}};
            s.twisting = {w.model, {}};
            if (w.model == "cappedSpring") s.twisting.values = {{"twistingFactor", tf}};
        };
        const std::string name =
            n.model + "+" + t.model + "+" + r.model + "+" + w.model;
        SCOPED_TRACE(name);
        const bool allowed =
            (w.model != "springDashpotSlider" || t.model != "none")
         && (w.model != "cappedSpring" || r.model == "bending")
         && (n.model != "cohesivePlastic" || r.model != "springSlider");
        try
        {
            ContactBench b(law);
            EXPECT_TRUE(allowed);
            EXPECT_EQ(b.law().name(), name);
            ++works;

            for (const double rj : {-1.0, 1e-6, 3e-6, 1e-5, 1e-4}) b.add({1e-6, rj, 1e-9});
            std::feclearexcept(FE_ALL_EXCEPT);
            b.evaluate(0);
            b.evaluate(1e-9);
            EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));
        }
        catch (const dem::inputError& e)
        {
            EXPECT_FALSE(allowed) << e.what();
            EXPECT_NE(e.keyword.find("/model"), std::string::npos);
            EXPECT_NE(e.allowed.find("none"), std::string::npos);
            ++refused;
        }
    }
    EXPECT_EQ(works, 5*11 + 8);
    EXPECT_EQ(works + refused, 6*2*3*3);
}
