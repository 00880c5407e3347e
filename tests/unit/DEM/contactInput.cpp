// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is refused on input and with which words; mixing rules and constants of pairs of
// materials; reduced stiffness.
#include "contactModels/contactModel/ContactLaw.hpp"
#include "floatingTraps.hpp"
#include "scene.hpp"

#include <functional>

using scene::close;
using scene::Law;

namespace
{

//- The error that an action must give
dem::inputError refused(const std::function<void()>& action)
{
    try
    {
        action();
    }
    catch (const dem::inputError& e)
    {
        return e;
    }
    ADD_FAILURE() << "was accepted";
    return {"", "", ""};
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

dem::inputError refusedSettings(const dem::ContactSettings& s)
{
    return refused
    (
        [&] { dem::MaterialTable({{"dust", 1000, 1e8, 0.3, 0.1}}, s, {}, {}); }
    );
}

dem::inputError refusedMaterial(const dem::Material& m)
{
    return refused([&] { dem::MaterialTable({m}, Law().settings(), {}, {}); });
}

Law full()
{
    Law law;
    law.friction = 0.3;
    law.criticalAngle = 0.0085;
    law.twisting = true;
    return law;
}

}


TEST(contactInput, unknownModelListsTheKnownOnes)
{
    struct Kind { const char* kind; dem::PartSettings dem::ContactSettings::* part; };
    const Kind kinds[] =
    {
        {"normal", &dem::ContactSettings::normal},
        {"tangential", &dem::ContactSettings::tangential},
        {"rolling", &dem::ContactSettings::rolling},
        {"twisting", &dem::ContactSettings::twisting}
    };
    for (const Kind& k : kinds)
    {
        SCOPED_TRACE(k.kind);
        dem::ContactSettings s = full().settings();
        (s.*k.part).model = "glue";
        const dem::inputError e = refusedSettings(s);
        EXPECT_TRUE(contains(e.keyword, std::string(k.kind) + "/model"));
        EXPECT_TRUE(contains(e.reason, "glue"));
        int listed = 0;
        for (const dem::PartEntry& entry : dem::contactModelTable())
        {
            if (entry.kind != k.kind) continue;
            EXPECT_TRUE(contains(e.allowed, entry.model));
            ++listed;
        }
        EXPECT_GE(listed, 2);
        EXPECT_TRUE(contains(e.what(), e.keyword) && contains(e.what(), e.allowed));
    }
}


TEST(contactInput, unknownKeywordListsTheKnownOnes)
{
    // every part of the table, with a keyword that no part has
    for (const dem::PartEntry& entry : dem::contactModelTable())
    {
        SCOPED_TRACE(entry.kind + " " + entry.model);
        dem::ContactSettings s = full().settings();
        if (entry.kind == "twisting" && entry.model == "none") s.twisting = {};
        if (entry.kind == "tangential" && entry.model == "none") s.twisting = {};
        dem::PartSettings& part =
            entry.kind == "normal" ? s.normal
          : entry.kind == "tangential" ? s.tangential
          : entry.kind == "rolling" ? s.rolling : s.twisting;
        part.model = entry.model;
        part.values["stickiness"] = 1;
        const dem::inputError e = refusedSettings(s);
        EXPECT_TRUE(contains(e.keyword, entry.kind + "/"));
        // the first unknown word in the alphabet is named: an old one or the new one
        EXPECT_FALSE(e.allowed.empty());
        for (const dem::PartKeyword& known : entry.keywords)
        {
            EXPECT_TRUE(contains(e.allowed, known.name)) << known.name;
        }
    }
}


TEST(contactInput, missingAndContradictoryKeywords)
{
    {
        dem::ContactSettings s = full().settings();
        s.tangential.values.clear();
        EXPECT_TRUE(contains(refusedSettings(s).keyword, "tangential/friction"));
    }
    for (const char* model : {"Hertz", "simplifiedJKR", "JKR", "DMT"})
    {
        SCOPED_TRACE(model);
        dem::ContactSettings s = full().settings();
        s.normal.model = model;
        s.normal.values = {{"restitution", 0.8}, {"dampingCoefficient", 0.1}};
        dem::inputError e = refusedSettings(s);
        EXPECT_TRUE(contains(e.keyword, "normal/restitution"));
        EXPECT_TRUE(contains(e.reason, "dampingCoefficient"));
        s.normal.values.clear();
        e = refusedSettings(s);
        EXPECT_TRUE(contains(e.keyword, "normal/restitution"));
        EXPECT_TRUE(contains(e.reason, "missing"));
    }
    {
        dem::ContactSettings s = full().settings();
        s.rolling.values["adhesionHysteresis"] = 0.4;
        EXPECT_TRUE(contains(refusedSettings(s).reason, "adhesionHysteresis"));
        s.rolling.values.clear();
        EXPECT_TRUE(contains(refusedSettings(s).keyword, "rolling/"));
    }
    {
        // the limit of twisting comes from sliding
        dem::ContactSettings s = full().settings();
        s.tangential = {};
        const dem::inputError e = refusedSettings(s);
        EXPECT_TRUE(contains(e.keyword, "twisting/model"));
        EXPECT_TRUE(contains(e.allowed, "tangential"));
    }
}


TEST(contactInput, ranges)
{
    struct Bad { const char* part; const char* keyword; double value; };
    const Bad bad[] =
    {
        {"normal", "restitution", 0}, {"normal", "restitution", -0.5},
        {"normal", "restitution", 1.0001}, {"normal", "restitution", NAN},
        {"normal", "dampingCoefficient", -0.1}, {"normal", "dampingCoefficient", 1e9},
        {"tangential", "friction", -0.1}, {"tangential", "friction", NAN},
        {"rolling", "criticalAngle", -0.1}, {"rolling", "criticalAngle", 100},
        {"rolling", "adhesionHysteresis", -0.1}, {"rolling", "rollingDamping", -1}
    };
    const FloatingTraps traps;
    for (const Bad& b : bad)
    {
        SCOPED_TRACE(std::string(b.part) + "/" + b.keyword + " " + scene::text(b.value));
        dem::ContactSettings s = full().settings();
        const std::string part = b.part, keyword = b.keyword;
        dem::PartSettings& p =
            part == "normal" ? s.normal : part == "tangential" ? s.tangential : s.rolling;
        if (keyword != "rollingDamping") p.values.clear();
        p.values[b.keyword] = b.value;
        const dem::inputError e = refusedSettings(s);
        EXPECT_TRUE(contains(e.keyword, part + "/" + keyword)) << e.what();
        EXPECT_TRUE(contains(e.reason, std::isnan(b.value) ? "nan" : "is ")) << e.what();
    }

    for (const double e : {0.01, 0.5, 1.0})
    {
        Law law;
        law.restitution = e;
        EXPECT_NO_THROW(law.table());
    }
}


TEST(contactInput, materials)
{
    const dem::Material good{"dust", 1000, 1e8, 0.3, 0.1};
    const auto with = [&](auto change)
    {
        dem::Material m = good;
        change(m);
        const dem::inputError e = refusedMaterial(m);
        EXPECT_TRUE(contains(e.keyword, "materials/dust/")) << e.what();
        return e.keyword.substr(std::string("materials/dust/").size());
    };
    for (const double bad : {-1.0, double(NAN), double(INFINITY)})
    {
        EXPECT_EQ(with([&](dem::Material& m) { m.density = bad; }), "density");
        EXPECT_EQ(with([&](dem::Material& m) { m.youngsModulus = bad; }), "youngsModulus");
        EXPECT_EQ(with([&](dem::Material& m) { m.surfaceEnergy = bad; }), "surfaceEnergy");
    }
    EXPECT_EQ(with([](dem::Material& m) { m.youngsModulus = 0; }), "youngsModulus");
    for (const double bad : {-1.0, 0.51, double(NAN)})
    {
        EXPECT_EQ(with([&](dem::Material& m) { m.poissonRatio = bad; }), "poissonRatio");
    }

    for (const double chi : {0.0, -0.1, 1.01, double(NAN)})
    {
        dem::ReducedStiffness softening;
        softening.ratio = chi;
        const dem::inputError e = refused
        (
            [&] { dem::MaterialTable({good}, Law().settings(), {}, softening); }
        );
        EXPECT_TRUE(contains(e.keyword, "reducedStiffness/ratio")) << e.what();
    }

    dem::ContactSettings s = Law().settings();
    s.effectiveYoungsModulus = -1;
    EXPECT_TRUE(contains(refusedSettings(s).keyword, "effectiveYoungsModulus"));
    s = Law().settings();
    s.surfaceEnergy = -1;
    EXPECT_TRUE(contains(refusedSettings(s).keyword, "surfaceEnergy"));

    const dem::MaterialTable table = Law().table();
    EXPECT_EQ(table.index("dust"), 0);
    EXPECT_EQ(table.index("wall"), 1);
    const dem::inputError e = refused([&] { table.index("steel"); });
    EXPECT_TRUE(contains(e.allowed, "dust") && contains(e.allowed, "wall")) << e.what();
}


TEST(materialTable, mixingRules)
{
    // 1/E = sum (1 - nu^2)/E_i, 1/G = sum (2 - nu)/G_i with G_i = E_i/(2 (1 + nu)),
    // gamma = (gamma_i gamma_j)^(1/2)
    const dem::Material a{"a", 1000, 2.4e8, 0.33, 0.11}, b{"b", 0, 2e11, 0.3, 0.04};
    const dem::MaterialTable table({a, b}, Law().settings(), {}, {});
    const auto E = [](const dem::Material& p, const dem::Material& q)
    {
        return
            1
           /(
                (1 - p.poissonRatio*p.poissonRatio)/p.youngsModulus
              + (1 - q.poissonRatio*q.poissonRatio)/q.youngsModulus
            );
    };
    const auto G = [](const dem::Material& p, const dem::Material& q)
    {
        const double gp = p.youngsModulus/(2*(1 + p.poissonRatio));
        const double gq = q.youngsModulus/(2*(1 + q.poissonRatio));
        return 1/((2 - p.poissonRatio)/gp + (2 - q.poissonRatio)/gq);
    };
    const dem::Material both[2] = {a, b};
    for (int i = 0; i < 2; ++i)
    {
        for (int j = 0; j < 2; ++j)
        {
            const dem::PairConstants& c = table.constants(i, j);
            EXPECT_TRUE(close(c.E, E(both[i], both[j]), 1e-14));
            EXPECT_TRUE(close(c.G, G(both[i], both[j]), 1e-14));
            const double gamma =
                std::sqrt(both[i].surfaceEnergy*both[j].surfaceEnergy);
            EXPECT_TRUE(close(c.gamma, gamma, 1e-14));
            EXPECT_EQ(c.chi, 1);
        }
    }

    // the effective modulus given instead: the shear modulus follows in proportion
    dem::ContactSettings s = Law().settings();
    s.effectiveYoungsModulus = 2.71e8;
    s.surfaceEnergy = 0.5;
    const dem::MaterialTable given({a, b}, s, {}, {});
    EXPECT_EQ(given.constants(0, 1).E, 2.71e8);
    EXPECT_EQ(given.constants(0, 1).gamma, 0.5);
    EXPECT_TRUE(close(given.constants(0, 1).G, G(a, b)*2.71e8/E(a, b), 1e-14));
}


TEST(materialTable, overridesInEitherOrder)
{
    const std::vector<dem::Material> m
    {
        {"a", 1000, 1e8, 0.3, 0.1}, {"b", 1000, 1e8, 0.3, 0.1}, {"c", 1000, 1e8, 0.3, 0.1}
    };
    Law law;
    dem::ContactSettings other = law.settings();
    other.surfaceEnergy = 0.7;
    other.normal.model = "simplifiedJKR";
    for (const char* key : {"a.b", "b.a"})
    {
        SCOPED_TRACE(key);
        const dem::MaterialTable table(m, law.settings(), {{key, other}}, {});
        EXPECT_EQ(table.constants(0, 1).gamma, 0.7);
        EXPECT_EQ(table.constants(1, 0).gamma, 0.7);
        EXPECT_EQ(table.settings(1, 0).normal.model, "simplifiedJKR");
        EXPECT_EQ(table.lawIndex(0, 1), table.lawIndex(1, 0));
        EXPECT_EQ(table.pairInLaw(0, 1), table.pairInLaw(1, 0));
        // nobody else
        for (const auto& p : {std::pair<int, int>{0, 0}, {1, 1}, {0, 2}, {1, 2}})
        {
            EXPECT_TRUE(close(table.constants(p.first, p.second).gamma, 0.1, 1e-15));
            EXPECT_NE(table.lawIndex(p.first, p.second), table.lawIndex(0, 1));
        }
        EXPECT_EQ(table.laws().size(), 2u);
    }

    const dem::inputError e = refused
    (
        [&] { dem::MaterialTable(m, law.settings(), {{"a.steel", other}}, {}); }
    );
    EXPECT_TRUE(contains(e.keyword, "a.steel"));
    EXPECT_TRUE(contains(e.allowed, "a.b") && contains(e.allowed, "b.c")) << e.what();

    // an error inside an override names the pair
    other.normal.values["restitution"] = 7;
    const dem::inputError inside = refused
    (
        [&] { dem::MaterialTable(m, law.settings(), {{"b.a", other}}, {}); }
    );
    EXPECT_TRUE(contains(inside.keyword, "contact/")) << inside.what();
    EXPECT_TRUE(contains(inside.keyword, "a.b")) << inside.what();
    EXPECT_TRUE(contains(inside.keyword, "normal/restitution")) << inside.what();
}


TEST(materialTable, overridesOfTwoPairsUseTheirOwnNumbers)
{
    // two pairs in one law keep their own constants
    Law law;
    dem::ContactSettings slow = law.settings(), fast = law.settings();
    slow.normal.values["restitution"] = 0.2;
    fast.normal.values["restitution"] = 0.95;
    const dem::MaterialTable table
    (
        {{"a", 1000, 1e8, 0.3, 0.1}, {"b", 1000, 1e8, 0.3, 0.1}},
        law.settings(), {{"a.b", slow}, {"b.b", fast}}, {}
    );
    ASSERT_EQ(table.laws().size(), 1u);
    const dem::ContactLaw& l = *table.laws()[0];
    const auto damping = [&](int i, int j)
    {
        double c[dem::maxConstants], history[dem::maxHistory] = {};
        l.prepare(table.pairInLaw(i, j), {table.constants(i, j), 1e-6, 1e-15}, c);
        return l.normalResponse(c, 1e-9, history).damping;
    };
    const double beta = formula::beta(0.86);
    EXPECT_TRUE(close(damping(1, 0)/damping(0, 0), formula::beta(0.2)/beta, 1e-13));
    EXPECT_TRUE(close(damping(1, 1)/damping(0, 0), formula::beta(0.95)/beta, 1e-13));
}


TEST(materialTable, figures)
{
    const Law law;
    const dem::MaterialTable table = law.table();
    for (const double rj : {-1.0, 1e-6, 3e-6})
    {
        const double ri = 1e-6, v = 0.5;
        const double mi = law.mass(ri), mj = rj > 0 ? law.mass(rj) : 0;
        const formula::Contact c = law.contact(ri, rj);
        const dem::ContactFigures f = table.figures(0, 1, ri, rj, mi, mj, v);
        EXPECT_TRUE(close(f.R, c.R, 1e-14));
        EXPECT_TRUE(close(f.m, c.m, 1e-14));
        EXPECT_TRUE(close(f.pullOff, 3*formula::pi*c.R*0.11, 1e-14));
        EXPECT_EQ(f.pullOff, f.realPullOff);
        EXPECT_TRUE(close(f.a0, c.a0(), 1e-14));
        EXPECT_TRUE(close(f.delta0, c.a0()*c.a0()/(3*c.R), 1e-14));
        EXPECT_TRUE(close(f.deltaC, c.deltaC(), 1e-14));
        // lambda_T = (4 R gamma^2/(E^2 D_min^3))^(1/3), D_min = 0.165 nm
        const double tabor =
            std::cbrt(4*c.R*0.11*0.11/(c.E*c.E*std::pow(1.65e-10, 3)));
        EXPECT_TRUE(close(f.tabor, tabor, 1e-13));
        // Hertz: delta* = (15 m v^2/(16 E R^(1/2)))^(2/5); the time in contact is
        // 2 delta*/v times the integral of (1 - x^(5/2))^(-1/2) from 0 to 1
        const double peak = std::pow(15*c.m*v*v/(16*c.E*std::sqrt(c.R)), 0.4);
        EXPECT_TRUE(close(f.impactOverlap, peak, 1e-13));
        const double integral =
            0.4*std::sqrt(formula::pi)*std::tgamma(0.4)/std::tgamma(0.9);
        EXPECT_TRUE(close(f.impactTime, 2*integral*peak/v, 1e-5));
    }

    // the longest neck of a sphere: on a wall
    EXPECT_TRUE(close(table.reach(0, 1e-6, {}), law.contact(1e-6, -1).deltaC(), 1e-14));
}


TEST(materialTable, mirrorIsTheOwnImage)
{
    // Two equal spheres that meet at 2 v, each of which turns round at the plane between them;
    // softened like all others, also later; the other pairs stay as they are
    Law elastic = full(), adhesive = full();
    elastic.gamma = 0;
    elastic.restitution = 1;
    const double r = 1e-6, v = 0.5, m = elastic.mass(r);
    for (const double chi : {1.0, 0.01})
    {
        elastic.softening.ratio = adhesive.softening.ratio = chi;
        const dem::ContactFigures pair = elastic.table().figures(0, 0, r, r, m, m, 2*v);
        adhesive.softening.ratio = 1;
        dem::MaterialTable table = adhesive.table();
        const std::size_t laws = table.laws().size();
        const double before = table.constants(1, 0).E;
        table.addMirrors();
        table.addMirrors();
        EXPECT_EQ(table.laws().size(), laws + 1);
        EXPECT_EQ(table.lawIndex(0, dem::mirror), int(laws));
        EXPECT_EQ(table.constants(1, 0).E, before);
        table.setRatio(chi);
        const dem::ContactFigures f = table.figures(0, dem::mirror, r, -1, m, 0, v);
        EXPECT_TRUE(close(f.impactTime, pair.impactTime, 1e-12));
        EXPECT_TRUE(close(f.impactOverlap, pair.impactOverlap/2, 1e-12));
        EXPECT_EQ(f.pullOff, 0);
        EXPECT_EQ(f.deltaC, 0);
        const dem::ContactLaw& law = *table.laws().back();
        EXPECT_FALSE(law.needsSpin());
        double c[dem::maxConstants], history[dem::maxHistory] = {};
        law.prepare(table.pairInLaw(0, dem::mirror), {table.constants(0, dem::mirror), r, m}, c);
        const dem::NormalResponse<double> response = law.normalResponse(c, 1e-9, history);
        EXPECT_GT(response.elastic, 0);
        EXPECT_EQ(response.damping, 0);
    }
}


TEST(reducedStiffness, scalings)
{
    for (const double chi : {0.5, 0.1, 0.01, 1e-3})
    {
        SCOPED_TRACE(scene::text(chi));
        Law law = full();
        const dem::MaterialTable real = law.table();
        law.softening.ratio = chi;
        const dem::MaterialTable soft = law.table();
        const dem::PairConstants &r = real.constants(0, 1), &s = soft.constants(0, 1);
        EXPECT_TRUE(close(s.E/r.E, chi, 1e-14));
        EXPECT_TRUE(close(s.G/r.G, chi, 1e-14));
        EXPECT_TRUE(close(s.gamma/r.gamma, std::pow(chi, 0.4), 1e-14));
        EXPECT_EQ(s.realE, r.E);
        EXPECT_EQ(s.realGamma, r.gamma);
        EXPECT_EQ(s.limits().gamma, r.gamma);

        const double mass = law.mass(1e-6);
        const auto figures = [&](const dem::MaterialTable& t)
        {
            return t.figures(0, 1, 1e-6, -1, mass, 0, 1.0);
        };
        const dem::ContactFigures a = figures(real), b = figures(soft);
        EXPECT_TRUE(close(b.pullOff/a.pullOff, std::pow(chi, 0.4), 1e-13));
        EXPECT_EQ(b.realPullOff, a.realPullOff);
        EXPECT_TRUE(close(b.delta0/a.delta0, std::pow(chi, -0.4), 1e-13));
        EXPECT_TRUE(close(b.deltaC/a.deltaC, std::pow(chi, -0.4), 1e-13));
        EXPECT_TRUE(close(b.a0/a.a0, std::pow(chi, -0.2), 1e-13));
        EXPECT_TRUE(close(b.impactTime/a.impactTime, std::pow(chi, -0.4), 1e-13));
        EXPECT_TRUE(close(b.impactOverlap/a.impactOverlap, std::pow(chi, -0.4), 1e-13));
        EXPECT_EQ(b.tabor, a.tabor);

        law.softening.scaleSurfaceEnergy = false;
        EXPECT_EQ(law.table().constants(0, 1).gamma, r.gamma);
        law.softening.scaleSurfaceEnergy = true;
        law.softening.scaleResistance = true;
        EXPECT_TRUE
        (
            close(law.table().constants(0, 1).limits().gamma, r.gamma*std::pow(chi, 0.4), 1e-14)
        );
    }
}


TEST(reducedStiffness, contactStepScalesToo)
{
    // The period of the normal and sliding springs grows as chi^(-2/5)
    Law law;
    law.friction = 0.3;
    const double mass = law.mass(1e-6);
    const double real = law.table().figures(0, 1, 1e-6, -1, mass, 0, 1.0).period;
    law.softening.ratio = 0.01;
    const double soft = law.table().figures(0, 1, 1e-6, -1, mass, 0, 1.0).period;
    EXPECT_TRUE(close(soft/real, std::pow(0.01, -0.4), 1e-12));
}
