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

//- Gap of width 2 r - overlap between floor and ceiling
dem::Walls slot(double width)
{
    dem::Walls walls = scene::floor();
    walls.planes.push_back({Vec3(0, 0, width), -Vec3::UnitZ(), 0});
    walls.patches.push_back({"ceiling", 1});
    walls.planes.back().patch = 1;
    return walls;
}

//- Energy of JKR contacts from their overlaps [J], in the particles' order
double storedEnergy(const dem::System& system, const std::vector<formula::Contact>& laws)
{
    const std::vector<dem::ContactView> contacts = system.contacts();
    EXPECT_EQ(contacts.size(), laws.size());
    double sum = 0;
    for (std::size_t k = 0; k < contacts.size(); ++k)
    {
        const formula::Contact& c = laws[k];
        const double unit = c.a0()*c.a0()/c.R, A = formula::jkrRadius(contacts[k].overlap/unit);
        sum += 4*c.pullOff()*unit
            *(0.4*std::pow(A, 5) - std::pow(A, 3.5)/1.5 + A*A/6 + 0.1*std::pow(1.5, -4.0/3.0));
    }
    return sum;
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
    for (int k = 0; k < 50; ++k) e += system.advance(1e-6).energy;
    // each particle has the contact with the one below in the list of the lower
    ASSERT_EQ(system.contacts()[0].idJ, -1);
    const formula::Contact wall = law.contact(r, -1);
    const double before = storedEnergy(system, {wall, c, c});
    const dem::Restiffened done = system.setRatio(0.1);
    Law stiff = law;
    stiff.softening.ratio = 0.1;
    const formula::Contact after = stiff.contact(r, 0.7*r);
    const double change = storedEnergy(system, {stiff.contact(r, -1), after, after}) - before;
    EXPECT_TRUE(close(done.normal, change, 1e-6));
    e.normal += done.normal;
    e.springs += done.springs;
    e.stiffening += done.normal + done.springs;
    for (int k = 0; k < 50; ++k) e += system.advance(1e-6).energy;
    // F_C delta_0 is the same at any chi: only what the load adds to it changes
    EXPECT_GT(std::fabs(e.stiffening), 0.01*c.pullOff()*c.delta0());
    EXPECT_LT(std::fabs(e.residual()), 0.05*std::fabs(e.stiffening));
}


//- An awake one hits one at rest with more than F_C, whichever of the two has the lower id
TEST(stiffening, aCollisionIsOneWhicheverHasTheLowerId)
{
    for (const int small : {900, 1})
    {
        Law law;
        law.restitution = 0.9;
        law.softening.ratio = 0.01;
        dem::System system(law.table(), {});
        system.setWalls(scene::floor());
        const double R = 5*r, z = R - law.contact(R, -1).delta0();
        system.add(sphere(law, 3, R, Vec3(0, 0, z)));
        for (int k = 0; k < 200 && !system.resting(0); ++k) system.advance(1e-6);
        ASSERT_TRUE(system.resting(0));

        // one that wakes nobody, as it is weak beside what holds the large one
        const formula::Contact c = law.contact(R, r);
        const double top = system.particle(0).x.z() + R;
        system.add(sphere(law, small, r, Vec3(0, 0, top + 1.01*r), Vec3(0, 0, -5)));
        const auto pair = [&]()
        {
            for (const dem::ContactView& v : system.contacts()) if (v.wall < 0) return v;
            return dem::ContactView{};
        };
        double force = 0;
        for (int k = 0; k < 4000 && force < 1.3*c.pullOff(); ++k)
        {
            system.advance(2e-10);
            const dem::ContactView v = pair();
            force = system.contacts().size() < 2 ? 0
              : formula::normal("JKR", c, v.overlap, 0.9).force;
        }
        ASSERT_GT(force, 1.3*c.pullOff());
        ASSERT_LT(force, 2.4*c.pullOff());
        ASSERT_TRUE(system.resting(0));
        const double before = pair().overlap;
        const dem::Restiffened done = system.setRatio(0.1);
        EXPECT_EQ(done.contacts, 2);
        EXPECT_EQ(done.similar, 1);
        EXPECT_TRUE(close(pair().overlap, before*std::pow(0.1, 0.4), 1e-6)) << small;
    }
}


//- Between two walls two have no room for three shorter overlaps: each keeps a third of what is
//  missing, and who rests wakes
TEST(stiffening, whoseOverlapsCannotBeMetWake)
{
    for (const bool held : {true, false})
    {
        Law law = sticky(0.01);
        const double pair = law.contact(r, r).delta0(), wall = law.contact(r, -1).delta0();
        const double width = 4*r - 2*wall - pair;
        dem::System system(law.table(), {});
        system.setWalls(held ? slot(width) : scene::floor());
        system.add(sphere(law, 7, r, Vec3(0, 0, r - wall)));
        system.add(sphere(law, 2, r, Vec3(0, 0, 3*r - wall - pair)));
        for (int k = 0; k < 200; ++k) system.advance(1e-6);
        ASSERT_TRUE(system.resting(0) && system.resting(1));
        ASSERT_TRUE(system.awake().empty());
        const dem::Restiffened done = system.setRatio(0.3);
        EXPECT_EQ(done.woken, held ? 2 : 0);
        EXPECT_EQ(system.awake().size(), held ? 2u : 0u);
        if (held) EXPECT_GT(done.misfit, 1);
        else EXPECT_LT(done.misfit, 1e-6);
    }
}


//- The same with ids in any order: what is missing is shared alike
TEST(stiffening, whatIsMissingIsSharedWhateverTheIds)
{
    const Law law = sticky(0.01);
    Law stiff = law;
    stiff.softening.ratio = 0.3;
    const double pair = law.contact(r, r).delta0(), wall = law.contact(r, -1).delta0();
    const double pairAfter = stiff.contact(r, r).delta0();
    const double wallAfter = stiff.contact(r, -1).delta0();
    const double share = (2*(wall - wallAfter) + pair - pairAfter)/3;
    for (const bool upward : {true, false})
    {
        dem::System system(law.table(), {});
        system.setWalls(slot(4*r - 2*wall - pair));
        system.add(sphere(law, upward ? 1 : 9, r, Vec3(0, 0, r - wall)));
        system.add(sphere(law, 5, r, Vec3(0, 0, 3*r - wall - pair)));
        system.advance(1e-15);
        ASSERT_EQ(system.contacts().size(), 3u);
        system.setRatio(0.3);
        for (const dem::ContactView& c : system.contacts())
        {
            const double expected = share + (c.wall < 0 ? pairAfter : wallAfter);
            EXPECT_TRUE(close(c.overlap, expected, 1e-5)) << upward << c.idI << c.idJ;
        }
    }
}


//- A column grows by the sum of what its overlaps lose, into what is above it
TEST(stiffening, newOverlapsAreTold)
{
    for (const std::string above : {"nothing", "wall", "sphere", "far"})
    {
        const Law law = sticky(0.001);
        Law real = law;
        real.softening.ratio = 1;
        const auto loses = [&](double a, double b)
        {
            return law.contact(a, b).delta0() - real.contact(a, b).delta0();
        };
        const double grows = loses(r, -1) + 3*loses(r, 0.7*r), gap = 0.4*grows;
        const std::vector<dem::Particle> parts = column(law, 4);
        const double top = parts.back().x.z() + parts.back().radius;
        dem::System system(law.table(), {});
        system.setWalls(above == "wall" ? slot(top + gap) : scene::floor());
        fill(system, parts);
        const double by = above == "far" ? 1.1*grows : gap;
        if (above == "sphere" || above == "far")
        {
            system.add(sphere(law, 77, 2*r, Vec3(0, 0, top + by + 2*r)));
        }
        system.advance(1e-15);
        ASSERT_EQ(system.contacts().size(), 4u);
        const dem::Restiffened done = system.setRatio(1);
        EXPECT_TRUE(close(done.farthest, grows, 1e-6));
        const bool meets = above == "wall" || above == "sphere";
        EXPECT_TRUE(near(done.newOverlap, meets ? (grows - gap)/(1.4*r) : 0, 1e-7)) << above;
        EXPECT_EQ(done.newI, meets ? 3 : -1);
        EXPECT_EQ(done.newJ, above == "sphere" ? 77 : -1);
        // what grows in contacts that there are is nothing new
        if (above == "nothing") EXPECT_EQ(system.setRatio(0.001).newOverlap, 0);
    }
}


//- A pull at which the overlap should be 0, in a ring that cannot move: what is missing counts in
//  units of delta_0
TEST(stiffening, theMisfitOfAnOverlapOfNothingIsFinite)
{
    // 8/9 F_C at 1.3 chi, (8/9) 1.3^(2/5) F_C at chi; s = A^(3/2)
    Law law = sticky(0.3);
    const double factor = std::pow(1.3, 0.4);
    const double s = 0.5*(1 + std::sqrt(1 - 8.0/9.0*factor));
    const double A = std::pow(s, 2.0/3.0);
    const double gap = -3*(A*A - std::sqrt(A)/1.5);     // [delta_0]
    ASSERT_TRUE(near(gap, 0.27, 0.02));
    const double unit = law.contact(r, -1).delta0();
    dem::System system(law.table(), {});
    system.setWalls(slot(2*r + 2*gap*unit));
    system.add(sphere(law, 1, r, Vec3(0, 0, r - 0.01*unit)));
    system.advance(1e-15);
    ASSERT_EQ(system.contacts().size(), 1u);
    // its neck holds on below while it touches above
    system.setMotion(0, Vec3(0, 0, r + (2*gap + 0.01)*unit), Vec3::Zero(), Vec3::Zero());
    system.advance(1e-15);
    ASSERT_EQ(system.contacts().size(), 2u);
    system.setMotion(0, Vec3(0, 0, r + gap*unit), Vec3::Zero(), Vec3::Zero());
    system.advance(1e-15);
    ASSERT_EQ(system.contacts().size(), 2u);
    const dem::Restiffened done = system.setRatio(0.39);
    EXPECT_EQ(done.similar, 0);
    EXPECT_TRUE(close(done.misfit, gap*factor, 1e-3));
}


//- Without adhesion a collision at 45 degrees with another chi differs in time only, and what it
//  has stored stays
TEST(stiffening, anObliqueCollisionGoesOnAsItWouldHave)
{
    Vec3 v[2], omega[2];
    for (const bool changed : {false, true})
    {
        Law law;
        law.normal = "Hertz";
        law.gamma = 0;
        law.restitution = 0.9;
        law.friction = 10;      // sticks: the spring is loaded all the time
        law.softening.ratio = 0.01;
        dem::TimeSettings time;
        time.stepsPerContact = 400;
        dem::System system(law.table(), time);
        system.setWalls(scene::floor());
        system.add(sphere(law, 1, r, Vec3(0, 0, 1.0001*r), Vec3(5, 0, -5)));
        const double t = law.table().figures(0, 1, r, -1, law.mass(r), 0, 5).impactTime;
        system.advance(0.3*t);
        ASSERT_TRUE(system.inContact(0));
        if (changed)
        {
            const double energy = 0.5*law.mass(r)*25;
            const dem::Restiffened done = system.setRatio(0.1);
            EXPECT_EQ(done.similar, 1);
            EXPECT_TRUE(near(done.normal, 0, 1e-9*energy));
            EXPECT_TRUE(near(done.springs, 0, 1e-9*energy));
        }
        for (int k = 0; k < 20; ++k) system.advance(0.2*t);
        ASSERT_FALSE(system.inContact(0));
        v[changed] = system.particle(0).v;
        omega[changed] = system.particle(0).omega;
    }
    EXPECT_TRUE(near(v[1], v[0], 2e-3*5));
    EXPECT_TRUE(near(r*omega[1], r*omega[0], 2e-3*5));
    EXPECT_GT(r*omega[0].norm(), 1);
}


//- a/a0 is kept on the branch about to break, with surface energy scaled or not
TEST(stiffening, aNeckAboutToBreakStaysOne)
{
    for (const bool scaled : {true, false})
    {
        Law law;
        law.softening.ratio = 0.01;
        law.softening.scaleSurfaceEnergy = scaled;
        const formula::Contact c = law.contact(r, r);
        dem::System system(law.table(), {});
        const double d = 2*r - c.delta0();
        system.add(sphere(law, 1, r, Vec3::Zero()));
        system.add(sphere(law, 2, r, Vec3(d, 0, 0)));
        system.advance(1e-15);
        system.setMotion(1, Vec3(2*r + 0.9*c.deltaC(), 0, 0), Vec3::Zero(), Vec3::Zero());
        const dem::Restiffened done = system.setRatio(0.1);
        EXPECT_EQ(done.similar, 1);
        Law stiff = law;
        stiff.softening.ratio = 0.1;
        const double end = stiff.contact(r, r).deltaC();
        ASSERT_EQ(system.contacts().size(), 1u);
        EXPECT_TRUE(close(system.contacts()[0].overlap, -0.9*end, 1e-6)) << scaled;
    }
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
