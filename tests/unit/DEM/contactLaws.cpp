// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each part of the contact laws against its closed form, at the kernels themselves.
#include "ContactBench.hpp"

#include "contactModels/normal/jkrCurve.hpp"

using namespace bench;
using scene::close;
using scene::near;
using scene::Law;

namespace
{

const double diameters[] = {0.5e-6, 1e-6, 10e-6, 1e-3};
const char* const normalLaws[] = {"Hertz", "simplifiedJKR", "JKR", "DMT"};

struct Geometry { const char* name; double ri, rj; };

std::vector<Geometry> geometries(double d)
{
    return {{"equal spheres", d/2, d/2}, {"spheres 1:3", d/2, 1.5*d}, {"wall", d/2, -1}};
}

Law lawOf(const std::string& normal)
{
    Law law;
    law.normal = normal;
    if (normal == "Hertz") law.gamma = 0;
    return law;
}

//- A law with every resistance on
Law fullLaw(const std::string& normal = "JKR")
{
    Law law = lawOf(normal);
    law.friction = 0.3;
    law.criticalAngle = 0.0085;
    law.twisting = true;
    return law;
}

}


// * * * * * * * * * * * * * * * * * Normal force * * * * * * * * * * * * * * * * * * * //

TEST(normalForce, closedForm)
{
    for (const char* name : normalLaws)
    {
        for (const double d : diameters)
        {
            for (const Geometry& g : geometries(d))
            {
                const Law law = lawOf(name);
                const formula::Contact c = law.contact(g.ri, g.rj);
                ContactBench b(law);

                const double unit = law.gamma > 0 ? c.delta0() : 1e-3*c.R;
                std::vector<double> overlaps;
                for (const double f : {0.0, 1e-3, 0.1, 0.5, 0.9, 1.0, 1.1, 2.0, 10.0})
                {
                    overlaps.push_back(f*unit);
                }
                if (law.normal == "JKR")
                {
                    for (const double f : {0.1, 0.5, 0.9, 0.99, 0.9999})
                    {
                        overlaps.push_back(-f*c.deltaC());
                    }
                }
                for (const double overlap : overlaps)
                {
                    Placed p{g.ri, g.rj, overlap};
                    p.n = Vec3(1, 2, 2)/3;
                    b.add(p);
                }
                b.evaluate();

                for (std::size_t k = 0; k < overlaps.size(); ++k)
                {
                    SCOPED_TRACE
                    (
                        law.normal + ", " + g.name + ", d = " + scene::text(d)
                      + ", overlap/unit " + scene::text(overlaps[k]/unit)
                    );
                    const formula::Normal f =
                        formula::normal(law.normal, c, overlaps[k], law.restitution);
                    // the overlap of a pair is a small difference of positions
                    double tolerance = 1e-12*(std::fabs(f.force) + c.pullOff());
                    const double lost = g.rj > 0 ? 4.4e-16*(g.ri + g.rj) : 0;
                    for (const double o : {overlaps[k] - lost, overlaps[k] + lost})
                    {
                        const double other =
                            formula::normal(law.normal, c, o, law.restitution).force;
                        tolerance += 2*std::fabs(other - f.force);
                    }
                    const Loads l = b.loads(k);
                    const Vec3 n = Vec3(1, 2, 2)/3;
                    EXPECT_TRUE(near(l.forceI, -f.force*n, tolerance));
                    if (g.rj > 0)
                    {
                        EXPECT_EQ(l.forceI, -l.forceJ);
                    }
                    EXPECT_EQ(l.torqueI.norm(), 0);
                    EXPECT_TRUE(overlaps[k] == 0 || !b.ended(k));
                }
            }
        }
    }
}


TEST(normalForce, JKRLandmarks)
{
    for (const double d : diameters)
    {
        for (const Geometry& g : geometries(d))
        {
            SCOPED_TRACE(g.name);
            const Law law = lawOf("JKR");
            const formula::Contact c = law.contact(g.ri, g.rj);
            const ContactBench b(law);
            const double FC = c.pullOff();
            const auto force = [&](double overlap)
            {
                return b.normal(g.ri, g.rj, overlap).elastic;
            };

            EXPECT_TRUE(close(b.pullOff(c.R), FC, 1e-14));
            EXPECT_TRUE(close(b.reach(c.R), c.deltaC(), 1e-14));
            EXPECT_TRUE(close(force(0), -8.0/9.0*FC, 1e-13));
            EXPECT_TRUE(near(force(c.delta0()), 0, 1e-13*FC));
            EXPECT_TRUE(close(b.normal(g.ri, g.rj, c.delta0()).radius, c.a0(), 1e-14));
            EXPECT_TRUE(close(b.normal(g.ri, g.rj, c.delta0()).strength, 1, 1e-14));
            // the end of the neck, approached as the square root of the distance
            EXPECT_TRUE(close(force(-c.deltaC()*(1 - 1e-14)), -5.0/9.0*FC, 1e-6));
            EXPECT_LT(b.normal(g.ri, g.rj, -c.deltaC()*(1 + 1e-9)).remaining, 0);
            EXPECT_GT(b.normal(g.ri, g.rj, -c.deltaC()*(1 - 1e-9)).remaining, 0);

            // The greatest tension, found by golden section, is F_C, at A^(3/2) = 1/2
            double low = -c.deltaC(), high = c.delta0();
            const double golden = 0.5*(std::sqrt(5.0) - 1);
            for (int k = 0; k < 100; ++k)
            {
                const double x = high - golden*(high - low);
                const double y = low + golden*(high - low);
                if (force(x) < force(y)) high = y;
                else low = x;
            }
            EXPECT_TRUE(close(force(low), -FC, 1e-12));
            const double A = std::pow(2.0, -2.0/3.0);
            EXPECT_TRUE
            (
                close(low, c.a0()*c.a0()/c.R*(A*A - 2.0/3.0*std::sqrt(A)), 1e-5)
            );
            EXPECT_TRUE(close(b.normal(g.ri, g.rj, low).radius, A*c.a0(), 1e-5));
        }
    }
}


TEST(normalForce, simplifiedJKRAndDMTHoldAtTouch)
{
    for (const Geometry& g : geometries(1e-6))
    {
        SCOPED_TRACE(g.name);
        const ContactBench simplified(lawOf("simplifiedJKR")), dmt(lawOf("DMT"));
        const formula::Contact c = lawOf("DMT").contact(g.ri, g.rj);

        EXPECT_TRUE
        (
            close(simplified.normal(g.ri, g.rj, 0).elastic, -8.0/9.0*c.pullOff(), 1e-13)
        );
        EXPECT_LT(simplified.normal(g.ri, g.rj, -1e-3*c.delta0()).remaining, 0);
        EXPECT_EQ(simplified.reach(c.R), 0);

        const double dmtPullOff = 4*formula::pi*c.R*c.gamma;
        EXPECT_TRUE(close(dmt.normal(g.ri, g.rj, 0).elastic, -dmtPullOff, 1e-13));
        EXPECT_TRUE(close(dmt.pullOff(c.R), dmtPullOff, 1e-14));
        // equilibrium: Hertz carries 4 pi R gamma at a0
        const double a0 = dmt.equilibriumRadius(c.R);
        EXPECT_TRUE(near(dmt.normal(g.ri, g.rj, a0*a0/c.R).elastic, 0, 1e-12*dmtPullOff));
        EXPECT_TRUE(close(dmt.normal(g.ri, g.rj, a0*a0/c.R).strength, 1, 1e-12));
        EXPECT_EQ(dmt.reach(c.R), 0);
    }
}


TEST(normalForce, JKRRootAgainstBisection)
{
    // q counts from the end of the neck
    const auto worst = [](double from, double to)
    {
        double error = 0;
        for (double decade = from; decade <= to; decade += 0.05)
        {
            const double q = std::pow(10.0, decade);
            // s^4 - (2/3) s + 6^(-1/3)/2 = q, in quadruple precision
            using Quad = __float128;
            Quad root = std::cbrt(6.0);
            for (int k = 0; k < 4; ++k) root -= (root*root*root - 6)/(3*root*root);
            const Quad sC = 1/root;
            Quad low = sC, high = 2 + Quad(std::sqrt(std::sqrt(q)))*2;
            for (int k = 0; k < 220; ++k)
            {
                const Quad x = (low + high)/2;
                (x*x*x*x - Quad(2)/3*x + sC/2 < Quad(q) ? low : high) = x;
            }
            error = std::max(error, std::fabs(dem::jkrCurve::rootOf(q)/double(low) - 1));
        }
        return error;
    };
    // from snap-off to 3e4 delta_0, and where adhesion no longer matters
    EXPECT_LT(worst(-12, 4), 1e-12);
    EXPECT_LT(worst(4, 12), 1e-10);

    // never below the end of the neck, never not a number
    EXPECT_TRUE(close(dem::jkrCurve::rootOf(0.0), std::pow(6.0, -1.0/3.0), 1e-12));
    EXPECT_TRUE(close(dem::jkrCurve::rootOf(-1.0), std::pow(6.0, -1.0/3.0), 1e-12));
}


TEST(normalForce, withoutSurfaceEnergyItIsHertz)
{
    for (const char* name : {"simplifiedJKR", "JKR", "DMT"})
    {
        SCOPED_TRACE(name);
        Law law = fullLaw(name);
        law.gamma = 0;
        const ContactBench b(law);
        const formula::Contact c = law.contact(1e-6, 2e-6);
        EXPECT_EQ(b.law().name(), "Hertz+springDashpotSlider+none+springDashpotSlider");
        for (const double overlap : {1e-12, 1e-9, 1e-8})
        {
            const formula::Normal f =
                formula::normal("Hertz", c, overlap, law.restitution);
            const auto n = b.normal(1e-6, 2e-6, overlap);
            EXPECT_TRUE(close(n.elastic, f.force, 1e-13));
            EXPECT_TRUE(close(n.damping, f.damping, 1e-13));
        }
        EXPECT_LT(b.normal(1e-6, 2e-6, -1e-15).remaining, 0);
    }
}


TEST(normalForce, smallSurfaceEnergyTendsToHertz)
{
    // JKR's correction to Hertz at a given overlap is of the order of (F_C/F)^(1/2)
    Law law = lawOf("JKR");
    law.gamma = 1e-14;
    const formula::Contact c = law.contact(5e-6, -1);
    const ContactBench b(law);
    const double hertz =
        4.0/3.0*c.E*std::sqrt(c.R)*std::pow(1e-8, 1.5);
    EXPECT_TRUE(close(b.normal(5e-6, -1, 1e-8).elastic, hertz, 1e-5));
}


// * * * * * * * * * * * * * * * * * * Damping * * * * * * * * * * * * * * * * * * * * * //

TEST(normalDamping, closedForm)
{
    for (const char* name : normalLaws)
    {
        for (const double e : {0.02, 0.3, 0.86, 0.99})
        {
            for (const Geometry& g : geometries(1e-6))
            {
                Law law = lawOf(name);
                law.restitution = e;
                const formula::Contact c = law.contact(g.ri, g.rj);
                ContactBench b(law);
                const double overlap = 3e-9;
                const formula::Normal f = formula::normal(name, c, overlap, e);
                SCOPED_TRACE(std::string(name) + " " + g.name + " " + scene::text(e));
                EXPECT_TRUE
                (
                    close(b.normal(g.ri, g.rj, overlap).damping, f.damping, 1e-12)
                );

                // a dashpot opposes approach and separation alike, on top of F_N
                Placed still{g.ri, g.rj, overlap};
                Placed closing = still, opening = still;
                closing.vI = Vec3(2, 0, 0);
                opening.vI = Vec3(-2, 0, 0);
                b.add(still);
                b.add(closing);
                b.add(opening);
                b.evaluate();
                const double rest = b.loads(0).forceI.x();
                const double scale = std::fabs(rest) + 2*f.damping;
                EXPECT_TRUE(near(b.loads(1).forceI.x() - rest, -2*f.damping, 1e-12*scale));
                EXPECT_TRUE(near(b.loads(2).forceI.x() - rest, 2*f.damping, 1e-12*scale));
                // along the normal only
                EXPECT_EQ(b.loads(1).forceI.y(), 0);
                EXPECT_EQ(b.loads(1).forceI.z(), 0);
            }
        }
    }
}


TEST(normalDamping, restitutionAndDampingCoefficientAreOneThing)
{
    // alpha = 5^(1/2) |ln e|/(ln^2 e + pi^2)^(1/2), exactly
    for (const char* name : normalLaws)
    {
        for (const double e : {0.01, 0.2, 0.5, 0.86, 1.0})
        {
            SCOPED_TRACE(std::string(name) + " " + scene::text(e));
            Law byRestitution = lawOf(name), byAlpha = byRestitution;
            byRestitution.restitution = e;
            const double l = std::log(e);
            byAlpha.dampingCoefficient =
                std::sqrt(5.0)*std::fabs(l)/std::sqrt(l*l + formula::pi*formula::pi);
            const double a = ContactBench(byRestitution).normal(1e-6, -1, 1e-9).damping;
            const double b = ContactBench(byAlpha).normal(1e-6, -1, 1e-9).damping;
            EXPECT_TRUE(close(a, b, 1e-13));
        }
    }

    // JKR at equilibrium: eta = alpha (m (4/3) E a0)^(1/2)
    Law law = lawOf("JKR");
    law.dampingCoefficient = 0.7;
    const formula::Contact c = law.contact(1e-6, 1e-6);
    EXPECT_TRUE
    (
        close
        (
            ContactBench(law).normal(1e-6, 1e-6, c.delta0()).damping,
            0.7*std::sqrt(c.m*4.0/3.0*c.E*c.a0()), 1e-13
        )
    );
}


// * * * * * * * * * * * * * * * * * * Sliding * * * * * * * * * * * * * * * * * * * * * //

TEST(sliding, stiffnessIs8Ga)
{
    for (const char* name : normalLaws)
    {
        for (const Geometry& g : geometries(1e-6))
        {
            SCOPED_TRACE(std::string(name) + " " + g.name);
            Law law = lawOf(name);
            law.friction = 0.5;
            ContactBench b(law);
            const formula::Contact c = law.contact(g.ri, g.rj);
            const double overlap = 2e-9, h = 1e-9, slip = 1e-15;
            const double a = formula::normal(name, c, overlap, 0.86).radius;

            Placed p{g.ri, g.rj, overlap};
            p.vSpringI = Vec3(0, 0.6*slip/h, 0.8*slip/h);
            b.add(p);
            for (int step = 1; step <= 3; ++step)
            {
                b.evaluate(h);
                const Vec3 expected = -8*c.G*a*step*slip*Vec3(0, 0.6, 0.8);
                Vec3 ft = b.loads(0).forceI;
                ft.x() = 0;
                EXPECT_TRUE(near(ft, expected, 1e-11*expected.norm()));
            }
        }
    }
}


TEST(sliding, slipOfSpinningSpheres)
{
    // v_S = (v_i - v_j)_t + (r_i omega_i + r_j omega_j) x n
    const double ri = 1e-6, rj = 3e-6, h = 1e-9;
    Law law = lawOf("JKR");
    law.friction = 0.5;
    const formula::Contact c = law.contact(ri, rj);
    const double overlap = c.delta0();
    const double k = 8*c.G*c.a0();
    const Vec3 n = Vec3::UnitX();

    Placed gears{ri, rj, overlap, n}, spin = gears, rigid = gears, both = gears;
    // surfaces that move together at the contact do not slip
    gears.wSpringI = Vec3(0, 0, 3e-6/h);
    gears.wSpringJ = Vec3(0, 0, -1e-6/h);
    spin.wSpringI = Vec3(0, 0, 1e-6/h);
    // a rigid rotation of both about the contact point
    rigid.wSpringI = rigid.wSpringJ = Vec3(0, 0, 1e-6/h);
    rigid.vSpringI = rigid.wSpringI.cross(-ri*n);
    rigid.vSpringJ = rigid.wSpringJ.cross(rj*n);
    both.vSpringI = Vec3(0, 2e-12/h, 0);
    both.vSpringJ = Vec3(0, 0, 1e-12/h);

    ContactBench b(law);
    for (const Placed& p : {gears, spin, rigid, both}) b.add(p);
    b.evaluate(h);

    const double unit = k*1e-12;
    EXPECT_TRUE(near(b.loads(0).forceI, Vec3::Zero(), 1e-8*unit));
    const Vec3 slip = ri*Vec3(0, 0, 1e-6).cross(n);
    EXPECT_TRUE(near(b.loads(1).forceI, -k*slip, 1e-8*unit));
    EXPECT_TRUE(near(b.loads(2).forceI, Vec3::Zero(), 1e-8*unit));
    EXPECT_TRUE(near(b.loads(3).forceI, -k*Vec3(0, 2e-12, -1e-12), 1e-8*unit));

    // torque r n x F_T on both, so that it drags both spheres along
    const Loads l = b.loads(1);
    EXPECT_TRUE(near(l.torqueI, ri*n.cross(l.forceI), 1e-12*ri*unit));
    EXPECT_TRUE(near(l.torqueJ, rj*n.cross(l.forceI), 1e-12*rj*unit));
    EXPECT_LT(l.torqueI.z(), 0);
    EXPECT_LT(l.torqueJ.z(), 0);
}


TEST(sliding, limitUsesTheOriginalPullOff)
{
    // mu |F_N + 2 F_C|; DMT: mu |F_N + 4 pi R gamma|; Hertz: mu |F_N|
    const double mu = 0.3, h = 1e-9;
    for (const char* name : normalLaws)
    {
        for (const double chi : {1.0, 0.1, 0.01})
        {
            for (const bool naive : {false, true})
            {
                SCOPED_TRACE
                (
                    std::string(name) + " chi " + scene::text(chi)
                  + (naive ? ", scaled resistance" : "")
                );
                Law law = lawOf(name);
                law.friction = mu;
                law.softening.ratio = chi;
                law.softening.scaleResistance = naive;
                const formula::Contact soft = law.contact(1e-6, -1);
                const formula::Contact real = law.contact(1e-6, -1, !naive);
                const double offset =
                    law.normal == "Hertz" ? 0
                  : law.normal == "DMT" ? 4*formula::pi*real.R*real.gamma
                  : 2*real.pullOff();

                ContactBench b(law);
                std::vector<double> overlaps{1e-9, 5e-9, 2e-8};
                for (const double overlap : overlaps)
                {
                    Placed p{1e-6, -1, overlap, Vec3::UnitZ()};
                    p.vSpringI = Vec3(1e-3/h, 0, 0);
                    b.add(p);
                }
                for (int step = 0; step < 2; ++step) b.evaluate(h);
                for (std::size_t k = 0; k < overlaps.size(); ++k)
                {
                    const double FN =
                        formula::normal(name, soft, overlaps[k], 0.86).force;
                    const Vec3 f = b.loads(k).forceI;
                    EXPECT_TRUE(close(f.x(), -mu*std::fabs(FN + offset), 1e-12));
                }
            }
        }
    }
}


TEST(sliding, unloadsAtOnceAfterSliding)
{
    // the limit holds the stored displacement, not only the force
    Law law = lawOf("JKR");
    law.friction = 0.3;
    const formula::Contact c = law.contact(1e-6, -1);
    const double h = 1e-9, k = 8*c.G*c.a0(), cap = 0.3*2*c.pullOff();
    Placed p{1e-6, -1, c.delta0(), Vec3::UnitZ()};
    ContactBench b(law);
    p.vSpringI = Vec3(100*cap/k/h, 0, 0);
    b.add(p);
    b.evaluate(h);
    EXPECT_TRUE(close(b.loads(0).forceI.x(), -cap, 1e-11));
    p.vSpringI = Vec3(-0.25*cap/k/h, 0, 0);
    b.place(0, p);
    b.evaluate(h);
    EXPECT_TRUE(close(b.loads(0).forceI.x(), -0.75*cap, 1e-11));
    // the other way round it slides at the same limit
    p.vSpringI = Vec3(-100*cap/k/h, 0, 0);
    b.place(0, p);
    b.evaluate(h);
    EXPECT_TRUE(close(b.loads(0).forceI.x(), cap, 1e-11));
    // and across: the force turns into the direction of slip, never beyond the limit
    p.vSpringI = Vec3(0, 1e3*cap/k/h, 0);
    b.place(0, p);
    b.evaluate(h);
    EXPECT_TRUE(close(b.loads(0).forceI.norm(), cap, 1e-6));
    EXPECT_TRUE(close(b.loads(0).forceI.y(), -cap, 1e-5));
}


TEST(sliding, dashpotClosedForm)
{
    // JKR: eta_T = eta_N; the others: 2 (5/6)^(1/2) beta (S_t m)^(1/2), S_t = 8 G a
    for (const char* name : normalLaws)
    {
        SCOPED_TRACE(name);
        Law law = lawOf(name);
        law.friction = 10;
        const formula::Contact c = law.contact(1e-6, 2e-6);
        const double overlap = 3e-9, v = 1e-3;
        const formula::Normal n = formula::normal(name, c, overlap, law.restitution);
        const double eta =
            law.normal == "JKR"
          ? n.damping
          : 2*std::sqrt(5.0/6.0)*formula::beta(law.restitution)
               *std::sqrt(8*c.G*n.radius*c.m);
        Placed p{1e-6, 2e-6, overlap};
        p.vI = Vec3(0, v, 0);
        ContactBench b(law);
        b.add(p);
        b.evaluate(0);
        EXPECT_TRUE(close(b.loads(0).forceI.y(), -eta*v, 1e-10));
    }
}


TEST(sliding, dashpotLeavesNoForceBehind)
{
    // at first touch a dashpot far above the limit; when the slip has stopped and the contact
    // has deepened, the spring may hold back up to the limit but never push along the slip
    const double v = 1;
    for (const char* name : normalLaws)
    {
        Law law = lawOf(name);
        law.friction = 0.1;
        law.restitution = 0.3;
        for (const double touch : {1e-15, 1e-13, 1e-11})
        {
            SCOPED_TRACE(std::string(name) + " from " + scene::text(touch));
            ContactBench b(law);
            Placed p{1e-6, -1, touch, -Vec3::UnitZ()};
            p.vI = Vec3(v, 0, 0);
            b.add(p);
            b.evaluate(0);
            p.vI = Vec3::Zero();
            p.overlap = 1e-8;
            b.place(0, p);
            b.evaluate(0);
            const double limit = 0.1*std::fabs
            (
                formula::normal(name, law.contact(1e-6, -1), 1e-8, 0.3).force
              + (law.normal == "DMT" ? 4*formula::pi*1e-6*law.gamma : 2*3*formula::pi*1e-6*law.gamma)
            );
            EXPECT_LE(b.loads(0).forceI.x(), 1e-9*limit);
            EXPECT_GE(b.loads(0).forceI.x(), -limit*(1 + 1e-12));
        }
    }
}


TEST(sliding, springTurnsWithThePair)
{
    // a spring that is loaded, then the normal turns: it stays tangential and keeps its size
    Law law = lawOf("JKR");
    law.friction = 10;
    const formula::Contact c = law.contact(1e-6, 1e-6);
    const double h = 1e-9, slip = 1e-14;
    Placed p{1e-6, 1e-6, c.delta0()};
    p.vSpringI = Vec3(0, slip/h, 0);
    ContactBench b(law);
    b.add(p);
    b.evaluate(h);
    const double loaded = b.loads(0).forceI.norm();
    p.vSpringI = Vec3::Zero();
    const double turn = formula::pi/2/1000, distance = 2e-6 - c.delta0();
    for (int k = 1; k <= 1000; ++k)
    {
        p.n = Vec3(std::cos(k*turn), std::sin(k*turn), 0);
        // the pair turns about the first sphere, without slip
        p.vSpringJ = Vec3(0, 0, turn/h).cross(distance*p.n);
        p.wSpringI = p.wSpringJ = Vec3(0, 0, turn/h)*distance/2e-6;
        b.place(0, p);
        b.evaluate(h);
    }
    p.vSpringJ = Vec3::Zero();
    // after a quarter turn about z, what pointed along y points along -x
    const Vec3 f = b.loads(0).forceI;
    const double normalForce = formula::normal("JKR", c, c.delta0(), 1).force;
    EXPECT_TRUE(near(f, Vec3(loaded, -normalForce, 0), 1e-7*loaded));
    EXPECT_GT(f.x(), 0);

    // spin of the pair about the normal turns it as well: a quarter turn about y
    p.wSpringI = p.wSpringJ = p.n*(formula::pi/2/1000/h);
    b.place(0, p);
    for (int k = 0; k < 1000; ++k) b.evaluate(h);
    // turned about the normal y from x to -z
    const Vec3 g = b.loads(0).forceI;
    EXPECT_TRUE(near(Vec3(g.x(), 0, g.z()), Vec3(0, 0, -loaded), 1e-5*loaded));
}


// * * * * * * * * * * * * * * * * * * Rolling * * * * * * * * * * * * * * * * * * * * * //

TEST(rolling, stiffnessAndLimit)
{
    // k_r = 4 F_C A^(3/2), |xi| <= xi_crit; F_C, xi_crit of the unsoftened contact
    for (const char* name : {"simplifiedJKR", "JKR"})
    {
        for (const double chi : {1.0, 0.1, 0.01})
        {
            for (const bool byAngle : {true, false})
            {
                SCOPED_TRACE
                (
                    std::string(name) + " chi " + scene::text(chi)
                  + (byAngle ? " criticalAngle" : " adhesionHysteresis")
                );
                Law law = lawOf(name);
                law.softening.ratio = chi;
                if (byAngle) law.criticalAngle = 0.0085;
                else law.adhesionHysteresis = 0.4;
                const double ri = 1e-6, rj = 2e-6, h = 1e-9;
                const formula::Contact soft = law.contact(ri, rj);
                const formula::Contact real = law.contact(ri, rj, true);
                const double critical = byAngle ? 0.0085*real.R : 0.4*real.a0()/12;

                for (const double f : {0.3, 1.0, 3.0})
                {
                    const double overlap = f*soft.delta0();
                    const double A = formula::normal(name, soft, overlap, 1).A;
                    const double k = 4*real.pullOff()*std::pow(A, 1.5);
                    ContactBench b(law);
                    Placed p{ri, rj, overlap};
                    // equal and opposite surface speeds: v_S = 0, only rolling
                    const double roll = 1e-3*critical;
                    p.wSpringI = Vec3(0, 0, roll/h/ri)/(1 + ri/rj)*ri/real.R;
                    p.wSpringJ = -p.wSpringI*ri/rj;
                    b.add(p);
                    b.evaluate(h);
                    const Vec3 rolled =
                        real.R*(p.wSpringI - p.wSpringJ).cross(p.n)*h;
                    EXPECT_TRUE(near(rolled, Vec3(0, roll, 0), 1e-10*roll));
                    const Loads l = b.loads(0);
                    EXPECT_TRUE(near(l.torqueI, -p.n.cross(k*rolled), 1e-10*k*roll));
                    EXPECT_TRUE(near(l.torqueJ, p.n.cross(k*rolled), 1e-10*k*roll));
                    EXPECT_LT(l.torqueI.z(), 0);    // against the spin

                    for (int step = 0; step < 3000; ++step) b.evaluate(h);
                    EXPECT_TRUE(close(b.loads(0).torqueI.z(), -k*critical, 1e-10));
                    // and unloads at once when it turns back
                    p.wSpringI *= -1;
                    p.wSpringJ *= -1;
                    b.place(0, p);
                    b.evaluate(h);
                    EXPECT_TRUE(close(b.loads(0).torqueI.z(), -k*(critical - roll), 1e-9));
                }
            }
        }
    }
}


TEST(rolling, velocity)
{
    // v_L = R (omega_i - omega_j) x n + (1/2)((ri - rj)/(ri + rj)) v_S
    const double h = 1e-9;
    Law law = lawOf("JKR");
    law.criticalAngle = 0.5;
    for (const Geometry& g : geometries(2e-6))
    {
        SCOPED_TRACE(g.name);
        const formula::Contact c = law.contact(g.ri, g.rj);
        const double k = 4*c.pullOff();
        const Vec3 n = Vec3::UnitX();
        const double skew = g.rj > 0 ? 0.5*(g.ri - g.rj)/(g.ri + g.rj) : -0.5;

        scene::Random random(7);
        for (int sample = 0; sample < 20; ++sample)
        {
            Placed p{g.ri, g.rj, c.delta0(), n};
            p.wSpringI = random.inBox(1e-4/h);
            p.vSpringI = random.inBox(1e-10/h);
            Vec3 wRel = p.wSpringI, vRel = p.vSpringI;
            Vec3 arm = g.ri*p.wSpringI;
            if (g.rj > 0)
            {
                p.wSpringJ = random.inBox(1e-4/h);
                p.vSpringJ = random.inBox(1e-10/h);
                wRel -= p.wSpringJ;
                vRel -= p.vSpringJ;
                arm += g.rj*p.wSpringJ;
            }
            const Vec3 slip = vRel - vRel.dot(n)*n + arm.cross(n);
            const Vec3 roll = (c.R*wRel.cross(n) + skew*slip)*h;
            ContactBench b(law);
            b.add(p);
            b.evaluate(h);
            EXPECT_TRUE(near(b.loads(0).torqueI, -k*n.cross(roll), 1e-10*k*roll.norm()));
        }
    }

    // A sphere that rolls without slip on a plane below it, by its own path:
    // omega = v/r, so v_L = v
    const double r = 1e-6, v = 1e-12/h;
    const formula::Contact c = law.contact(r, -1);
    Placed p{r, -1, c.delta0(), -Vec3::UnitZ()};
    p.vSpringI = Vec3(v, 0, 0);
    p.wSpringI = Vec3(0, v/r, 0);
    ContactBench b(law);
    b.add(p);
    b.evaluate(h);
    EXPECT_TRUE(near(b.loads(0).torqueI, Vec3(0, -4*c.pullOff()*v*h, 0), 1e-12*c.pullOff()*v*h));
}


TEST(rolling, dashpot)
{
    Law law = lawOf("JKR");
    law.criticalAngle = 0.01;
    law.rollingDamping = 3e-9;
    const double r = 1e-6;
    const formula::Contact c = law.contact(r, -1);
    Placed p{r, -1, c.delta0(), -Vec3::UnitZ()};
    p.vI = Vec3(2e-3, 0, 0);
    p.wI = Vec3(0, 2e-3/r, 0);
    ContactBench b(law);
    b.add(p);
    b.evaluate(0);
    EXPECT_TRUE(near(b.loads(0).torqueI, Vec3(0, -3e-9*2e-3, 0), 1e-24));
    EXPECT_EQ(b.law().rollingYield(b.constants(r, -1).data(), r).moment, 4*c.pullOff()*0.01*r);
}


TEST(rolling, yieldUnderSoftening)
{
    // Relative to the original at A = 1: proper rules 1; everything scaled chi^(1/5)
    // (hysteresis) or chi^(2/5) (angle); E alone, resistance from it, chi^(-1/3)
    struct Rule { bool angle, scaleGamma, scaleResistance; double exponent; };
    const Rule rules[] =
    {
        {false, true, false, 0}, {true, true, false, 0},
        {false, true, true, 0.2}, {true, true, true, 0.4},
        {false, false, true, -1.0/3.0}, {true, false, true, 0}
    };
    for (const Rule& rule : rules)
    {
        for (const double chi : {1.0, 0.1, 0.01, 1e-3})
        {
            Law law = lawOf("JKR");
            if (rule.angle) law.criticalAngle = 0.0085;
            else law.adhesionHysteresis = 0.4;
            const ContactBench original(law);
            law.softening = {chi, rule.scaleGamma, rule.scaleResistance};
            const ContactBench softened(law);
            const auto yield = [](const ContactBench& b)
            {
                return b.law().rollingYield(b.constants(1e-6, -1).data(), 1e-6).moment;
            };
            EXPECT_TRUE
            (
                close(yield(softened)/yield(original), std::pow(chi, rule.exponent), 1e-12)
            );
        }
    }
}


// * * * * * * * * * * * * * * * * * * Twisting * * * * * * * * * * * * * * * * * * * * * //

TEST(twisting, stiffnessDashpotAndLimit)
{
    for (const char* name : normalLaws)
    {
        for (const double chi : {1.0, 0.01})
        {
            SCOPED_TRACE(std::string(name) + " chi " + scene::text(chi));
            Law law = lawOf(name);
            law.friction = 0.3;
            law.twisting = true;
            law.softening.ratio = chi;
            const double ri = 1e-6, rj = 2e-6, h = 1e-9, overlap = 4e-9, angle = 1e-6;
            const formula::Contact c = law.contact(ri, rj);
            const formula::Contact real = law.contact(ri, rj, true);
            const formula::Normal n = formula::normal(name, c, overlap, law.restitution);
            const double a = n.radius;

            // k_T a^2/2 = 4 G a^3, opposite moments along the line of centres
            Placed p{ri, rj, overlap};
            p.wSpringI = Vec3(0.75*angle/h, 0, 0);
            p.wSpringJ = Vec3(-0.25*angle/h, 0, 0);
            ContactBench b(law);
            b.add(p);
            b.evaluate(h);
            const double k = 4*c.G*a*a*a;
            EXPECT_TRUE(close(b.loads(0).torqueI.x(), -k*angle, 1e-9));
            EXPECT_EQ(b.loads(0).torqueI, -b.loads(0).torqueJ);

            // eta_T a^2/2
            const double etaT =
                law.normal == "JKR"
              ? n.damping
              : 2*std::sqrt(5.0/6.0)*formula::beta(law.restitution)
                   *std::sqrt(8*c.G*a*c.m);
            ContactBench d(law);
            Placed q{ri, rj, overlap};
            q.wI = Vec3(10, 0, 0);
            d.add(q);
            d.evaluate(0);
            EXPECT_TRUE(close(d.loads(0).torqueI.x(), -etaT*a*a/2*10, 1e-9));

            // (3 pi/16) a mu |F_N + offset|, a and offset of the unsoftened contact
            double offset = 2*real.pullOff(), radius = a*real.a0()/c.a0();
            if (law.normal == "DMT") offset = 4*formula::pi*real.R*real.gamma;
            if (law.normal == "Hertz")
            {
                offset = 0;
                radius = a*std::pow(chi, 0.2);
            }
            const double cap =
                3*formula::pi/16*radius*0.3*std::fabs(n.force + offset);
            p.wSpringI = Vec3(1e4/h, 0, 0);
            b.place(0, p);
            b.evaluate(h);
            EXPECT_TRUE(close(b.loads(0).torqueI.x(), -cap, 1e-9));
            // unloads at once
            p.wSpringJ = Vec3::Zero();
            p.wSpringI = Vec3(-0.5*cap/k/h, 0, 0);
            b.place(0, p);
            b.evaluate(h);
            EXPECT_TRUE(close(b.loads(0).torqueI.x(), -0.5*cap, 1e-8));
        }
    }
}


TEST(twisting, dashpotLeavesNoMomentBehind)
{
    for (const char* name : normalLaws)
    {
        Law law = lawOf(name);
        law.friction = 0.1;
        law.twisting = true;
        law.restitution = 0.3;
        for (const double touch : {1e-15, 1e-13, 1e-11})
        {
            SCOPED_TRACE(std::string(name) + " from " + scene::text(touch));
            ContactBench b(law);
            Placed p{1e-6, -1, touch, -Vec3::UnitZ()};
            p.wI = Vec3(0, 0, 1e6);
            b.add(p);
            b.evaluate(0);
            p.wI = Vec3::Zero();
            p.overlap = 1e-8;
            b.place(0, p);
            b.evaluate(0);
            const formula::Contact c = law.contact(1e-6, -1);
            EXPECT_LE(b.loads(0).torqueI.z(), 1e-9*c.E*1e-24);
        }
    }
}


// * * * * * * * * * * * * * * * * * Whole contacts * * * * * * * * * * * * * * * * * * * //

TEST(contactList, sideBySideAndOneByOneAgree)
{
    // as many contacts side by side as the processor takes, then the rest one by one
    for (const char* name : normalLaws)
    {
        const Law law = fullLaw(name);
        for (int n = 1; n <= 9; ++n)
        {
            for (const bool wall : {false, true})
            {
                SCOPED_TRACE(std::string(name) + " " + std::to_string(n) + (wall ? " walls" : ""));
                ContactBench together(law), single(law);
                scene::Random random(100 + unsigned(n));
                for (int k = 0; k < n; ++k)
                {
                    const double ri = random.logUniform(0.5e-6, 5e-6);
                    const double rj = random.logUniform(0.5e-6, 5e-6);
                    const formula::Contact c = law.contact(ri, wall ? -1 : rj);
                    Placed p
                    {
                        ri, wall ? -1 : rj,
                        random.uniform(law.normal == "JKR" ? -0.9*c.deltaC() : 1e-11, 1e-8),
                        random.direction()
                    };
                    p.vSpringI = random.inBox(0.1);
                    p.vSpringJ = wall ? Vec3(Vec3::Zero()) : random.inBox(0.1);
                    p.wSpringI = random.inBox(1e5);
                    p.wSpringJ = wall ? Vec3(Vec3::Zero()) : random.inBox(1e5);
                    p.vI = random.inBox(0.1);
                    p.wI = random.inBox(1e5);
                    together.add(p);
                    single.add(p);
                }
                for (int step = 0; step < 3; ++step)
                {
                    together.evaluate(1e-9, true);
                    single.evaluate(1e-9, false);
                }
                for (int k = 0; k < n; ++k)
                {
                    const Loads a = together.loads(std::size_t(k));
                    const Loads b = single.loads(std::size_t(k));
                    EXPECT_GT(a.forceI.norm(), 0);
                    EXPECT_TRUE(near(a.forceI, b.forceI, 1e-13*b.forceI.norm()));
                    EXPECT_TRUE(near(a.torqueI, b.torqueI, 1e-12*b.torqueI.norm()));
                    EXPECT_TRUE(near(a.torqueJ, b.torqueJ, 1e-12*b.torqueI.norm()));
                    const auto ha = together.history(std::size_t(k));
                    const auto hb = single.history(std::size_t(k));
                    for (std::size_t i = 0; i < ha.size(); ++i)
                    {
                        EXPECT_TRUE(near(ha[i], hb[i], 1e-12*std::fabs(hb[i]) + 1e-25));
                    }
                }
            }
        }
    }
}


TEST(contactList, wallIsAHugeSphere)
{
    // physics.md, section 1: R = r, m = m_p, the same code with an infinite partner
    for (const char* name : normalLaws)
    {
        SCOPED_TRACE(name);
        const Law law = fullLaw(name);
        // factors of two, so that the sum of the radii is exact
        const double r = 1e-6, huge = r*1048576;
        const double overlap = 2e-9;
        ContactBench b(law);
        for (const double rj : {-1.0, huge})
        {
            Placed p{r, rj, overlap, -Vec3::UnitZ()};
            p.vSpringI = Vec3(1e-3, 2e-3, 0);
            p.wSpringI = Vec3(1e3, 2e3, 3e3);
            p.vI = Vec3(1e-3, 0, 2e-2);
            p.wI = Vec3(0, 2e3, 1e3);
            b.add(p);
        }
        b.evaluate(1e-9);
        const Loads wall = b.loads(0), sphere = b.loads(1);
        // 1/(1 + r/huge), and the overlap to the rounding of the huge radius
        const double tolerance = 3e-6 + 10*2.2e-16*huge/overlap;
        EXPECT_TRUE(near(sphere.forceI, wall.forceI, tolerance*wall.forceI.norm()));
        EXPECT_TRUE(near(sphere.torqueI, wall.torqueI, tolerance*wall.torqueI.norm()));
        EXPECT_GT(wall.torqueI.norm(), 0);
    }
}
