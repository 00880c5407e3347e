// SPDX-License-Identifier: GPL-3.0-or-later
//
// The van der Waals law at its kernel and where its contacts begin and end.
#include "ContactBench.hpp"

#include <cfenv>

using namespace bench;
using formula::pi;
using scene::close;
using scene::near;
using scene::Law;

namespace
{

constexpr double z0 = 4e-10, range = 1e-8;

Law lawOf(double gamma = 0.02)
{
    Law law;
    law.normal = "vanDerWaals";
    law.E = 4e10;
    law.gamma = gamma;
    law.adjust = [](dem::ContactSettings& s)
    {
        s.normal.values["cutOff"] = z0;
        s.normal.values["range"] = range;
    };
    return law;
}

Law fullLaw(bool walton)
{
    Law law = lawOf();
    law.friction = 0.3;
    if (walton)
    {
        law.adjust = [first = law.adjust](dem::ContactSettings& s)
        {
            first(s);
            s.rolling = {"bending", {{"bendingFactor", 2}, {"rollingDamping", 1e-9}}};
            s.twisting = {"cappedSpring", {{"twistingFactor", 1}, {"twistingDamping", 1e-18}}};
        };
    }
    else
    {
        law.criticalAngle = 0.0085;
        law.rollingDamping = 1e-9;
        law.twisting = true;
    }
    return law;
}

}


TEST(vanDerWaals, closedForm)
{
    const double r = 0.5e-6;
    for (const double rj : {-1.0, 0.5e-6, 2e-6})
    {
        const Law law = lawOf();
        const formula::Contact c = law.contact(r, rj);
        const ContactBench b(law);
        const double hamaker = 24*pi*c.gamma*z0*z0;
        for (const double z : {9.99e-9, 5e-9, 1e-9, 4.0001e-10, 4e-10, 3.9999e-10, 1e-10, 0.0})
        {
            const double expected = -hamaker*c.R/(6*std::max(z, z0)*std::max(z, z0));
            EXPECT_TRUE(close(b.normal(r, rj, -z).elastic, expected, 1e-12)) << z;
            EXPECT_EQ(b.normal(r, rj, -z).damping, 0);
            EXPECT_EQ(b.normal(r, rj, -z).radius, 0);
        }
        for (const double d : {1e-12, 1e-10, 3e-9})
        {
            const double expected =
                4.0/3.0*c.E*std::sqrt(c.R)*std::pow(d, 1.5) - 4*pi*c.R*c.gamma;
            EXPECT_TRUE(close(b.normal(r, rj, d).elastic, expected, 1e-11)) << d;
        }
        EXPECT_GE(b.normal(r, rj, -0.999999*range).remaining, 0);
        EXPECT_LT(b.normal(r, rj, -1.000001*range).remaining, 0);
    }
}


TEST(vanDerWaals, rangeInTheTable)
{
    const Law law = lawOf();
    const dem::MaterialTable table = law.table();
    EXPECT_EQ(table.touchDistance(0, 1), range);
    EXPECT_EQ(table.reach(0, 1e-6, {}), range);
    EXPECT_TRUE(close
    (
        table.figures(0, 1, 1e-6, -1, law.mass(1e-6), 0, 1).pullOff, 4*pi*1e-6*0.02, 1e-14
    ));

    // softened: F_C falls, lengths grow as chi^(-2/5), work of adhesion stays
    Law soft = law;
    soft.softening.ratio = 0.01;
    const double stretch = std::pow(0.01, -0.4);
    EXPECT_TRUE(close(soft.table().touchDistance(0, 1), range*stretch, 1e-13));
    const ContactBench hard(law), b(soft);
    for (const double z : {5e-9, 1e-9, 2e-10, -2e-9})
    {
        EXPECT_TRUE(close
        (
            b.normal(1e-6, -1, -z*stretch).elastic*stretch,
            hard.normal(1e-6, -1, -z).elastic, 1e-9
        )) << z;
    }

    // no surface energy: Hertz, with the keywords still checked
    Law none = fullLaw(true);
    none.gamma = 0;
    const dem::MaterialTable plain = none.table();
    EXPECT_EQ(plain.settings(0, 1).normal.model, "Hertz");
    EXPECT_EQ(plain.settings(0, 1).rolling.model, "none");
    EXPECT_EQ(plain.settings(0, 1).twisting.model, "none");
    EXPECT_EQ(plain.settings(0, 1).tangential.model, "springDashpotSlider");
    EXPECT_EQ(plain.touchDistance(0, 1), 0);
    for (const double gamma : {0.0, 0.02})
    {
        Law wrong = lawOf(gamma);
        wrong.adjust = [first = wrong.adjust](dem::ContactSettings& s)
        {
            first(s);
            s.normal.values["range"] = 0.5*z0;
        };
        EXPECT_THROW(wrong.table(), dem::inputError);
    }
}


TEST(vanDerWaals, beforeContactNothingResists)
{
    for (const bool walton : {true, false})
    {
        const Law law = fullLaw(walton);
        const double r = 1e-6, h = 1e-9;
        for (const double rj : {-1.0, 1e-6})
        {
            ContactBench b(law);
            Placed p{r, rj, -1e-9};
            p.vI = Vec3(0, 1, 2);
            p.wI = Vec3(1e5, 2e5, -3e5);
            b.add(p);
            for (int k = 0; k < 5; ++k) b.evaluate(h);
            const bench::Loads l = b.loads(0);
            EXPECT_EQ(l.forceI.y(), 0);
            EXPECT_EQ(l.forceI.z(), 0);
            EXPECT_GT(l.forceI.x(), 0);     // attracted along n = x
            EXPECT_EQ(l.torqueI.norm(), 0);
            EXPECT_EQ(l.torqueJ.norm(), 0);
            for (const double x : b.history(0)) EXPECT_EQ(x, 0);

            // and in contact everything does
            p.overlap = 1e-9;
            b.place(0, p);
            b.evaluate(h);
            EXPECT_LT(b.loads(0).forceI.y(), 0);
            EXPECT_GT(b.loads(0).torqueI.norm(), 0);
            EXPECT_LT(b.loads(0).torqueI.x(), 0);
            int moved = 0;
            for (const double x : b.history(0)) moved += x != 0;
            EXPECT_EQ(moved, 2 + 2 + 1);    // sliding, rolling (not along n), twisting

            // a contact that opens forgets
            p.overlap = -1e-10;
            b.place(0, p);
            b.evaluate(h);
            for (const double x : b.history(0)) EXPECT_EQ(x, 0);
        }
    }
}


TEST(vanDerWaals, contactsBeginAndEndAtTheRange)
{
    const Law law = lawOf();
    const double r = 1e-6;
    for (const bool wall : {true, false})
    {
        dem::System system(law.table(), {});
        if (wall)
        {
            system.setWalls(scene::floor());
            system.add(scene::sphere(law, 0, r, Vec3(0, 0, r + 1.5*range), Vec3(0, 0, -2)));
        }
        else
        {
            system.add(scene::sphere(law, 0, r, Vec3(0, 0, 0), Vec3(0, 0, 1)));
            system.add(scene::sphere(law, 1, r, Vec3(0, 0, 2*r + 1.5*range), Vec3(0, 0, -1)));
        }
        const double dt = range/2/40;
        double gapBegin = -1, gapEnd = -1, before = 0;
        for (int k = 0; k < 400; ++k)
        {
            dem::StepReport report = system.advance(dt);
            const double gap =
                wall ? system.particle(0).x.z() - r
              : system.particle(1).x.z() - system.particle(0).x.z() - 2*r;
            if (report.touches) gapBegin = gap;
            if (report.separations) gapEnd = before;
            before = gap;
        }
        EXPECT_TRUE(near(gapBegin, range, 2*2*dt));
        EXPECT_TRUE(near(gapEnd, range, 2*2*dt));
    }
}


TEST(vanDerWaals, nothingTraps)
{
    for (const bool walton : {true, false})
    {
        ContactBench b(fullLaw(walton));
        for (const double overlap : {0.0, -z0, -range, -1.0, 1e-300, -1e-300, 1e-9, 1e-7})
        {
            for (const double rj : {-1.0, 1e-6, 1e-3}) b.add({1e-6, rj, overlap});
        }
        std::feclearexcept(FE_ALL_EXCEPT);
        b.evaluate(0);
        b.evaluate(1e-9);
        EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));
    }
}
