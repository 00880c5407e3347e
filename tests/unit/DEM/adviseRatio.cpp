// SPDX-License-Identifier: GPL-3.0-or-later
//
// The softest chi (src/DEM/advice): each limit by its closed form, and what it says where no chi
// keeps them.
#include "scene.hpp"

using dem::RatioAdvice;
using dem::RatioLimits;
using dem::RatioLoad;
using dem::RatioPartner;
using scene::close;
using scene::Law;

namespace
{

constexpr double r = 1e-6, mu = 1.8e-5;

//- Limits that do not bind
RatioLimits none()
{
    RatioLimits l;
    l.pullOffOverForce = 1e-9;
    l.overlap = 1e9;
    l.ratio = 1e-12;
    l.loadFactor = 1;
    l.contactTime = 1e9;
    return l;
}

RatioLoad load(const Law& law, double radius, double speed)
{
    const double Sp = 6*formula::pi*mu*radius, m = law.mass(radius);
    return {radius, m, Sp*speed, speed, m/Sp};
}

const RatioPartner dust{0, false, {}, "dust.dust"};
const RatioPartner wall{1, true, {}, "dust.wall"};

double chi(const Law& law, const RatioPartner& p, const RatioLoad& l, const RatioLimits& limits)
{
    return dem::adviseRatio(law.table(), 0, {p}, {l}, limits).chi;
}

}


TEST(adviseRatio, theMarginBindsAsInTheClosedForm)
{
    // W/(8 mu U), equal spheres, any diameter; twice that on a wall
    Law law;
    law.gamma = 0.02;
    const double margin = 2*0.02/(8*mu*1.0);
    EXPECT_TRUE(scene::near(margin, 280, 5));
    for (const double radius : {1e-7, 1e-6, 1e-5})
    {
        for (const double limit : {1.0, 10.0, 25.0})
        {
            RatioLimits l = none();
            l.pullOffOverForce = limit;
            const RatioLoad one = load(law, radius, 1);
            EXPECT_TRUE(close(chi(law, dust, one, l), std::pow(limit/margin, 2.5), 1e-12));
            EXPECT_TRUE(close(chi(law, wall, one, l), std::pow(limit/margin/2, 2.5), 1e-12));
            l.loadFactor = 10;
            EXPECT_TRUE(close(chi(law, dust, one, l), std::pow(10*limit/margin, 2.5), 1e-12));
        }
    }
}


TEST(adviseRatio, atTheChiThatItGivesTheMarginIsWhatWasAskedFor)
{
    for (const char* model : {"JKR", "simplifiedJKR", "DMT"})
    {
        Law law;
        law.normal = model;
        RatioLimits l = none();
        l.pullOffOverForce = 30;
        l.loadFactor = 3;
        const RatioLoad one = load(law, r, 2);
        dem::MaterialTable table = law.table();
        const RatioAdvice a = dem::adviseRatio(table, 0, {dust, wall}, {one}, l);
        const std::string limit = std::string(model) == "DMT" ? "tabor" : "pullOffOverForce";
        EXPECT_EQ(a.binding().limit, limit) << model;
        if (limit == "tabor") continue;
        EXPECT_EQ(a.binding().pair, "dust.dust");
        table.setRatio(a.chi);
        const double m = law.mass(r);
        const dem::ContactFigures f = table.figures(0, 0, r, r, m, m, 1);
        EXPECT_TRUE(close(f.pullOff/one.force, 90, 1e-12)) << model;
    }
}


TEST(adviseRatio, overlapOfHertzInClosedForm)
{
    // delta = (15 m v^2/(16 E R^(1/2)))^(2/5) on a wall
    Law law;
    law.normal = "Hertz";
    law.gamma = 0;
    const double v = 3, m = law.mass(r), o = 0.02;
    RatioLimits l = none();
    l.overlap = o;
    const double delta = std::pow(15*m*v*v/(16*law.E*std::sqrt(r)), 0.4);
    EXPECT_TRUE(close(chi(law, wall, load(law, r, v), l), std::pow(delta/(o*2*r), 2.5), 1e-5));
}


TEST(adviseRatio, anUndampedImpactIsAsDeepAsTheLimit)
{
    for (const double v : {0.2, 3.0})
    {
        Law law;
        law.restitution = 1;
        const double limit = 0.06;
        RatioLimits l = none();
        l.overlap = limit;
        law.softening.ratio = chi(law, wall, load(law, r, v), l);
        ASSERT_LT(law.softening.ratio, 1);
        dem::TimeSettings time;
        time.stepsPerContact = 400;
        dem::System system(law.table(), time);
        system.setWalls(scene::floor());
        system.add(scene::sphere(law, 1, r, dem::Vec3(0, 0, 1.001*r), dem::Vec3(0, 0, -v)));
        dem::StepReport report;
        for (int k = 0; k < 40; ++k) report.add(system.advance(0.05*r/v));
        EXPECT_TRUE(close(report.maxOverlapOverDiameter, limit, 1e-3)) << v;
    }
}


//- Without speed: where the energy is that of touch again, below any equilibrium
TEST(adviseRatio, atRestTheFallIntoContactCounts)
{
    // JKR: 0 = (2/5) A^5 - (2/3) A^(7/2) + (1/6) A^2 + (1/10) (2/3)^(4/3)
    double low = 1, high = 2;
    for (int k = 0; k < 100; ++k)
    {
        const double A = 0.5*(low + high);
        const double energy =
            0.4*std::pow(A, 5) - std::pow(A, 3.5)/1.5 + A*A/6 + 0.1*std::pow(1.5, -4.0/3.0);
        (energy < 0 ? low : high) = A;
    }
    const double JKR = low*low - std::sqrt(low)/1.5;
    EXPECT_TRUE(scene::near(JKR, 0.6215, 1e-4));
    struct Fall { const char* normal; double depth, equilibrium; };     // [a0^2/R]
    for (const Fall& fall : {Fall{"JKR", JKR, 1.0/3.0}, Fall{"simplifiedJKR", JKR, 1.0/3.0},
        Fall{"DMT", std::pow(2.5, 2.0/3.0), 1}})
    {
        for (const RatioPartner& partner : {dust, wall})
        {
            Law law;
            law.normal = fall.normal;
            RatioLimits l = none();
            l.overlap = 0.5;
            RatioLoad still = load(law, r, 0);
            still.relaxationTime = 0;
            const formula::Contact c = law.contact(r, partner.wall ? -1 : r, true);
            const double a0 =
                std::cbrt((fall.equilibrium < 1 ? 9 : 3)*formula::pi*c.gamma*c.R*c.R/c.E);
            const double share = fall.depth*a0*a0/c.R/(2*r);
            const RatioAdvice a = dem::adviseRatio(law.table(), 0, {partner}, {still}, l);
            EXPECT_TRUE(close(a.find("overlap")->real, share, 1e-5)) << fall.normal;
            EXPECT_TRUE(close(a.find("overlap")->chi, std::pow(share/0.5, 2.5), 3e-5));
            EXPECT_GT(fall.depth, fall.equilibrium);
        }
    }
}


TEST(adviseRatio, contactTimeOverRelaxationTime)
{
    Law law;
    RatioLimits l = none();
    l.contactTime = 0.1;
    const RatioLoad one = load(law, 2e-7, 1);
    const double m = law.mass(2e-7);
    const double t = law.table().figures(0, 0, 2e-7, 2e-7, m, m, 1).impactTime;
    EXPECT_TRUE
    (
        close(chi(law, dust, one, l), std::pow(t/(0.1*one.relaxationTime), 2.5), 1e-12)
    );
}


TEST(adviseRatio, theTaborNumberOfTheLaw)
{
    Law law;
    law.E = 1e11;
    law.gamma = 0.001;
    law.normal = "DMT";
    const double m = law.mass(1e-8);
    const double tabor = law.table().figures(0, 0, 1e-8, 1e-8, m, m, 1).tabor;
    ASSERT_LT(tabor, 0.1);
    const RatioLoad small = load(law, 1e-8, 1e-3);
    // softened, the particle leaves the range of the law at lambda chi^(-2/5) = 0.1
    EXPECT_TRUE(close(chi(law, dust, small, none()), std::pow(tabor/0.1, 2.5), 1e-12));

    // a hard particle is none of JKR's, however soft or stiff it is made: no reason to be stiff
    law.normal = "JKR";
    const RatioAdvice a = dem::adviseRatio(law.table(), 0, {dust}, {small}, none());
    EXPECT_FALSE(a.reached());
    EXPECT_TRUE(std::isinf(a.find("tabor")->chi));
    EXPECT_EQ(a.binding().limit, "ratio");
    EXPECT_EQ(a.chi, none().ratio);
    EXPECT_NE(a.text().find("no chi keeps this limit"), std::string::npos);
}


TEST(adviseRatio, whereNoChiReachesTheLimitItSaysWhatIsReached)
{
    Law law;
    law.gamma = 0.02;
    RatioLimits l = none();
    l.pullOffOverForce = 1000;
    const RatioAdvice a = dem::adviseRatio(law.table(), 0, {dust}, {load(law, r, 1)}, l);
    EXPECT_EQ(a.chi, 1);
    EXPECT_FALSE(a.reached());
    EXPECT_NE(a.text().find("it is 278 where 1e+03 is wanted"), std::string::npos) << a.text();
}


TEST(adviseRatio, scaledOrNotTheTableOfAnotherChiIsThatMadeWithIt)
{
    for (const bool scaled : {true, false})
    {
        Law law;
        law.friction = 0.3;
        law.softening.scaleSurfaceEnergy = scaled;
        dem::MaterialTable table = law.table();
        for (const double ratio : {0.013, 1.0, 0.37})
        {
            table.setRatio(ratio);
            law.softening.ratio = ratio;
            const dem::PairConstants &a = table.constants(0, 1), b = law.table().constants(0, 1);
            EXPECT_EQ(a.E, b.E);
            EXPECT_EQ(a.G, b.G);
            EXPECT_EQ(a.gamma, b.gamma);
            EXPECT_EQ(table.softening().ratio, ratio);
        }
        EXPECT_THROW(table.setRatio(0), dem::inputError);
        EXPECT_THROW(table.setRatio(1.1), dem::inputError);
    }
}


TEST(adviseRatio, unscaledSurfaceEnergyKeepsThePullOffForce)
{
    Law law;
    law.softening.scaleSurfaceEnergy = false;
    RatioLimits l = none();
    l.pullOffOverForce = 10;
    const RatioAdvice a = dem::adviseRatio(law.table(), 0, {dust}, {load(law, r, 1)}, l);
    EXPECT_EQ(a.find("pullOffOverForce")->chi, 0);
    EXPECT_TRUE(a.reached());
}


TEST(adviseRatio, materialsThatTouchNothingDoNotCount)
{
    const Law law;
    dem::Walls walls;
    EXPECT_EQ(dem::ratioPartners(law.table(), 0, walls).size(), 1u);
    EXPECT_EQ(dem::ratioPartners(law.table(), 0, scene::floor()).size(), 2u);
}


TEST(adviseRatio, aLawThatIsNotSoftenedTakesOne)
{
    Law law;
    law.adjust = [](dem::ContactSettings& s)
    {
        s.normal = {"cohesivePlastic", {{"yieldStrength", 1e8}, {"restitution", 0.5},
            {"attraction", 1e-9}, {"attractionBuildUp", 0}}};
    };
    const RatioAdvice a = dem::adviseRatio(law.table(), 0, {dust}, {load(law, r, 1)}, none());
    EXPECT_EQ(a.chi, 1);
    EXPECT_TRUE(a.reached());
}


TEST(adviseRatio, severalMaterials)
{
    // walls none, JKR: F_C = 3/2 pi W R, W the geometric mean
    const Law law;
    const double youngs = 2*(1 - law.nu*law.nu)*law.E;
    const dem::MaterialTable table
    (
        {{"sand", law.density, youngs, law.nu, 0.11}, {"coal", law.density, youngs, law.nu, 0.02}},
        law.settings(), {}, {}
    );
    RatioLimits l = none();
    l.pullOffOverForce = 10;
    const auto need = [&](double W, double R, double force)
    {
        return std::pow(10*force/(1.5*formula::pi*W*R), 2.5);
    };
    const RatioLoad large = load(law, r, 1), small = load(law, 0.1*r, 1);

    // of one size: the weakest pair, in any order, and one alone as ever
    const dem::RatioDust sand{0, {large}}, coal{1, {large}}, fine{1, {small}};
    for (const auto& dusts : {std::vector<dem::RatioDust>{sand, coal}, {coal, sand}, {coal}})
    {
        const RatioAdvice a = dem::adviseRatio(table, dusts, {}, l);
        EXPECT_TRUE(close(a.chi, need(0.04, 0.5*r, large.force), 1e-12));
        EXPECT_EQ(a.binding().pair, "coal.coal");
    }
    EXPECT_TRUE(close
    (
        dem::adviseRatio(table, {sand}, {}, l).chi, need(0.22, 0.5*r, large.force), 1e-12
    ));

    // a smaller one is held by the nearest of the others: here coal.coal is as strong as can be
    const dem::MaterialTable held
    (
        {{"sand", law.density, youngs, law.nu, 0.11}, {"coal", law.density, youngs, law.nu, 0.02}},
        law.settings(), {{"coal.coal", [&] { auto s = law.settings(); s.surfaceEnergy = 1; return s; }()}}, {}
    );
    const RatioAdvice a = dem::adviseRatio(held, {sand, fine}, {}, l);
    const double both = need(2*std::sqrt(0.11*0.02), 0.1*r/1.1, small.force);
    const double alone = need(0.22, 0.5*r, large.force);
    EXPECT_TRUE(close(a.chi, std::max(both, alone), 1e-12));
    EXPECT_TRUE(close(dem::adviseRatio(held, {fine, sand}, {}, l).chi, a.chi, 1e-12));
}
