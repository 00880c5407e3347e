// SPDX-License-Identifier: GPL-3.0-or-later
//
// Another chi for contacts that there are (system/Stiffening.hpp).
#include "scene.hpp"

#include <algorithm>
#include <map>

using dem::Vec3;
using scene::close;
using scene::Law;
using scene::near;
using scene::sphere;

namespace
{

constexpr double r = 1e-6;

Law sticky(double chi, const std::string& normal = "JKR")
{
    Law law;
    law.normal = normal;
    law.restitution = 0.5;
    law.friction = 0.3;
    law.criticalAngle = 0.0085;
    law.rollingDamping = 1e-15;
    law.twisting = true;
    law.softening.ratio = chi;
    return law;
}

//- A column of n on the floor, radii alternately r and 0.7 r
std::vector<dem::Particle> column(const Law& law, int n)
{
    std::vector<dem::Particle> all;
    double z = 0;
    for (int k = 0; k < n; ++k)
    {
        const double radius = k%2 ? 0.7*r : r;
        const double other = k%2 ? r : 0.7*r;
        z += radius + (k ? other : 0);
        z -= k ? law.contact(radius, other).delta0() : law.contact(radius, -1).delta0();
        all.push_back(sphere(law, k, radius, Vec3(0, 0, z)));
    }
    return all;
}

void fill(dem::System& system, const std::vector<dem::Particle>& particles)
{
    for (const dem::Particle& p : particles) system.add(p);
}

void pull(dem::System& system, const Vec3& force, double Sp = 0)
{
    for (std::size_t i = 0; i < system.size(); ++i)
    {
        dem::GasLoad g;
        g.Su = force;
        g.Sp = Sp;
        system.setGasLoad(i, g);
    }
}

double fastest(const dem::System& system)
{
    double v = 0;
    for (std::size_t i = 0; i < system.size(); ++i) v = std::max(v, system.particle(i).v.norm());
    return v;
}

}


TEST(stiffening, forcesOfAColumnUnderLoadStay)
{
    for (const std::string normal : {"JKR", "simplifiedJKR", "DMT"})
    {
        for (const double rest : {0.0, 1.0})
        {
            const Law law = sticky(0.01, normal);
            dem::TimeSettings time;
            time.restTolerance = rest;
            dem::System system(law.table(), time);
            system.setWalls(scene::floor());
            fill(system, column(law, 5));
            const double FC = law.contact(r, 0.7*r).pullOff();
            pull(system, FC*Vec3(0.002, 0, 0.1), 1e-8);
            for (int k = 0; k < 200; ++k) system.advance(1e-6);
            ASSERT_LT(fastest(system), 1e-3);

            const std::vector<dem::ContactView> before = system.contacts();
            std::vector<char> resting;
            for (std::size_t i = 0; i < system.size(); ++i) resting.push_back(system.resting(i));
            if (rest > 0) EXPECT_TRUE(resting[0]);
            const dem::Restiffened done = system.setRatio(0.3);
            EXPECT_EQ(done.contacts, 5);
            EXPECT_EQ(done.similar, 0);
            EXPECT_LT(done.misfit, 1e-6);
            EXPECT_LT(done.normal + done.springs, 0);
            const std::vector<dem::ContactView> after = system.contacts();
            ASSERT_EQ(after.size(), before.size());
            for (std::size_t k = 0; k < after.size(); ++k)
            {
                EXPECT_TRUE(near(after[k].force, before[k].force, 1e-5*FC)) << normal << k;
                EXPECT_TRUE(close(after[k].pullOff/before[k].pullOff, std::pow(30, 0.4), 1e-12));
                EXPECT_LT(after[k].overlap, 0.5*before[k].overlap);
            }
            for (std::size_t i = 0; i < system.size(); ++i)
            {
                EXPECT_EQ(system.resting(i), bool(resting[i]));
            }
            // and stays where it is
            const double z = system.particle(4).x.z();
            for (int k = 0; k < 50; ++k) system.advance(1e-6);
            EXPECT_TRUE(near(system.particle(4).x.z(), z, 1e-4*r));
            EXPECT_LT(fastest(system), 1e-3);
            EXPECT_EQ(system.contacts().size(), before.size());
        }
    }
}


TEST(stiffening, withoutItTheColumnIsDisturbed)
{
    // what the test above sees where overlaps stay: the same column with a new table
    Law law = sticky(0.01);
    dem::System soft(law.table(), {});
    soft.setWalls(scene::floor());
    fill(soft, column(law, 5));
    law.softening.ratio = 0.3;
    dem::System hard(law.table(), {});
    hard.setWalls(scene::floor());
    for (std::size_t i = 0; i < soft.size(); ++i) hard.add(soft.particle(i));
    hard.advance(1e-8);
    EXPECT_GT(fastest(hard), 0.1);
}


TEST(stiffening, ringsAgree)
{
    // a tetrahedron of equal spheres has as many distances as places: all can be right
    const Law law = sticky(0.01);
    const double d = 2*r - law.contact(r, r).delta0(), a = d/std::sqrt(8.0);
    dem::TimeSettings time;
    dem::System system(law.table(), time);
    const Vec3 corner[4] =
        {Vec3(a, a, a), Vec3(a, -a, -a), Vec3(-a, a, -a), Vec3(-a, -a, a)};
    for (int k = 0; k < 4; ++k) system.add(sphere(law, k, r, corner[k], Vec3(0.5, 0, 0)));
    system.advance(1e-9);
    ASSERT_EQ(system.contacts().size(), 6u);
    Vec3 centre = Vec3::Zero();
    for (int k = 0; k < 4; ++k) centre += 0.25*system.particle(std::size_t(k)).x;
    const dem::Restiffened done = system.setRatio(1);
    EXPECT_EQ(done.contacts, 6);
    EXPECT_LT(done.misfit, 1e-3);
    Law real = law;
    real.softening.ratio = 1;
    for (const dem::ContactView& c : system.contacts())
    {
        EXPECT_TRUE(close(c.overlap, real.contact(r, r).delta0(), 0.01));
    }
    Vec3 now = Vec3::Zero();
    for (int k = 0; k < 4; ++k) now += 0.25*system.particle(std::size_t(k)).x;
    EXPECT_TRUE(near(now, centre, 1e-9*r));
}


TEST(stiffening, aCollisionReboundsAsFast)
{
    double speed[2];
    for (const bool changed : {false, true})
    {
        Law law;
        law.restitution = 0.8;
        law.softening.ratio = 0.01;
        dem::TimeSettings time;
        time.stepsPerContact = 200;
        dem::System system(law.table(), time);
        system.setWalls(scene::floor());
        system.add(sphere(law, 1, r, Vec3(0, 0, 1.0001*r), Vec3(0, 0, -5)));
        const double t = law.table().figures(0, 1, r, -1, law.mass(r), 0, 5).impactTime;
        system.advance(0.3*t);
        ASSERT_TRUE(system.inContact(0));
        if (changed)
        {
            const dem::Restiffened done = system.setRatio(0.1);
            EXPECT_EQ(done.similar, 1);
        }
        for (int k = 0; k < 20; ++k) system.advance(0.2*t);
        ASSERT_FALSE(system.inContact(0));
        speed[changed] = system.particle(0).v.z();
    }
    EXPECT_TRUE(close(speed[1], speed[0], 2e-3));
}


TEST(stiffening, theLedgerCloses)
{
    const Law law = sticky(0.01);
    dem::TimeSettings time;
    time.restTolerance = 0;
    time.energyLedger = true;
    dem::System system(law.table(), time);
    system.setWalls(scene::floor());
    fill(system, column(law, 3));
    const formula::Contact c = law.contact(r, 0.7*r);
    pull(system, c.pullOff()*Vec3(0, 0, 0.1), 1e-8);
    // contacts begin with overlaps, which nobody has paid for
    for (int k = 0; k < 100; ++k) system.advance(1e-6);
    dem::EnergyLedger e;
    for (int k = 0; k < 50; ++k) e.add(system.advance(1e-6).energy);
    const dem::Restiffened done = system.setRatio(0.1);
    e.normal += done.normal;
    e.springs += done.springs;
    e.stiffening += done.normal + done.springs;
    for (int k = 0; k < 50; ++k) e.add(system.advance(1e-6).energy);
    // F_C delta_0 is the same at any chi: only what the load adds to it changes
    EXPECT_GT(std::fabs(e.stiffening), 0.01*c.pullOff()*c.delta0());
    EXPECT_LT(std::fabs(e.residual()), 0.05*std::fabs(e.stiffening));
}


//- Drag that rises slowly: with chi raised as the margin asks for, the bond lets go at the real
//  pull-off force wherever chi began
TEST(stiffening, aBondBreaksAtItsRealStrengthFromAnyChi)
{
    for (const std::string normal : {"JKR", "simplifiedJKR"})
    {
        for (const double chi : {0.001, 0.01, 1.0})
        {
            const Law law = sticky(chi, normal);
            Law real = law;
            real.softening.ratio = 1;
            const double share = normal == "JKR" ? 1 : 8.0/9.0;
            // two hang on the lower bond of the column of three; the wall holds twice as much
            const formula::Contact bond = real.contact(r, 0.7*r);
            const double strength = share*bond.pullOff()/2;
            // at rest, a change of load below a tenth of F_C wakes nobody
            dem::TimeSettings time;
            time.restTolerance = 0;
            dem::System system(law.table(), time);
            system.setWalls(scene::floor());
            fill(system, column(law, 3));
            const double limit = 3;
            double now = chi, force = 0, margin = 0;
            int raised = 0;
            system.advance(1e-6);
            while (system.contacts().size() == 3 && force < 2*strength)
            {
                force += 5e-3*strength;
                pull(system, Vec3(0, 0, force), 1e-9);
                for (int k = 0; k < 3; ++k) system.advance(1e-6);
                const std::vector<double> margins = system.adhesionMargins();
                if (margins.size() < 3) break;
                margin = *std::min_element(margins.begin(), margins.end());
                const double wanted =
                    margin < limit ? dem::stiffenedRatio(now, margin, limit) : now;
                if (wanted > now)
                {
                    system.setRatio(now = wanted);
                    ++raised;
                    EXPECT_EQ(system.contacts().size(), 3u);
                }
            }
            EXPECT_EQ(now, 1);
            EXPECT_TRUE(close(force, strength, 0.02)) << normal << " from chi " << chi;
            if (chi < 1) EXPECT_GE(raised, 5);
        }
    }
}
