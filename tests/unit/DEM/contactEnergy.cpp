// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energies that contact laws state against integrals of their forces.
#include "contactModels/contactModel/ContactLaw.hpp"
#include "scene.hpp"

using scene::Law;

namespace
{

constexpr double r = 1e-6;

//- One contact with a wall in the direction x, at rest
struct Contact
{
    dem::MaterialTable table;
    const dem::ContactLaw& law;
    std::vector<double> constants, history;
    dem::ContactList list;
    dem::Body body{};

    explicit Contact(const Law& l)
    :
        table(l.table()),
        law(*table.laws()[std::size_t(table.lawIndex(0, 1))]),
        constants(dem::maxConstants, 0.0),
        history(dem::maxHistory, 0.0)
    {
        law.prepare
        (
            table.pairInLaw(0, 1), {table.constants(0, 1), r, l.mass(r)}, constants.data()
        );
        body.r = r;
    }

    double force(double overlap)
    {
        return law.normalResponse(constants.data(), overlap, history.data()).elastic;
    }

    void place(double overlap)
    {
        list.setUp(law.nConstants(), law.nHistory(), true);
        list.append(0, 0, 0, constants.data(), history.data());
        list.nx[0] = 1;
        list.overlap[0] = overlap;
    }

    dem::ContactEnergy energy(double overlap)
    {
        place(overlap);
        return law.energy(list, 0, &body, 0, dem::Periodic());
    }

    //- Work on the contact from one overlap to another, midpoints denser at both ends
    double work(double from, double to)
    {
        const int n = 20000;
        const auto at = [&](double s) { return from + (to - from)*s*s*(3 - 2*s); };
        double sum = 0;
        for (int k = 0; k < n; ++k)
        {
            sum += force(at((k + 0.5)/n))*(at(double(k + 1)/n) - at(double(k)/n));
        }
        return sum;
    }
};

}


TEST(contactEnergy, isTheIntegralOfTheNormalForce)
{
    struct Model { const char* name; double gamma, begin; };
    for (const Model& m : {Model{"Hertz", 0, 0}, {"simplifiedJKR", 0.11, 0},
        {"JKR", 0.11, 0}, {"JKR", 0, 0}, {"DMT", 0.11, 0}, {"vanDerWaals", 0.11, -1e-8}})
    {
        for (const double chi : {1.0, 0.01})
        {
            SCOPED_TRACE(std::string(m.name) + " chi " + scene::text(chi));
            Law law;
            law.normal = m.name;
            law.gamma = m.gamma;
            law.softening.ratio = chi;
            double begin = m.begin;
            if (law.normal == "vanDerWaals")
            {
                law.adjust = [](dem::ContactSettings& s)
                {
                    s.normal.values["cutOff"] = 4e-10;
                    s.normal.values["range"] = 1e-8;
                };
                begin *= std::pow(chi, -0.4);
            }
            Contact contact(law);
            const double end = formula::endOverlap(m.name, law.contact(r, -1));
            const double size = 3e-9*std::pow(chi, -0.4);
            const double scale = std::fabs(contact.energy(size).normal.stored);
            EXPECT_TRUE(scene::near(contact.energy(begin).normal.stored, 0, 1e-12*scale));
            for (const double overlap : {size, 5*size, 0.5*end, end, 0.5*begin, 0.01*begin})
            {
                EXPECT_TRUE
                (
                    scene::near
                    (
                        contact.energy(overlap).normal.stored, contact.work(begin, overlap),
                        1e-6*scale
                    )
                ) << overlap;
            }
        }
    }
}


TEST(contactEnergy, plasticContactGivesBackWhatItHasStored)
{
    for (const char* unloading : {"initial", "average"})
    {
        for (const double depth : {1e-9, 3e-8})     // elastic and plastic
        {
            Law law;
            law.normal = "cohesivePlastic";
            law.adjust = [&](dem::ContactSettings& s)
            {
                s.normal.values =
                {
                    {"yieldStrength", 5e6}, {"attraction", 1e-7}, {"attractionBuildUp", 0.2}
                };
                s.normal.words["unloading"] = unloading;
            };
            Contact contact(law);
            const double loading = contact.work(0, depth);
            const dem::NormalEnergy deepest = contact.energy(depth).normal;
            const double scale = std::fabs(loading);
            EXPECT_TRUE(scene::near(deepest.stored + deepest.plastic, loading, 1e-6*scale));
            for (const double way : {0.9, 0.3, 0.0})
            {
                const dem::NormalEnergy e = contact.energy(way*depth).normal;
                EXPECT_TRUE
                (
                    scene::near
                    (
                        e.stored, deepest.stored + contact.work(depth, way*depth), 1e-6*scale
                    )
                );
                EXPECT_TRUE(scene::close(e.plastic, deepest.plastic, 1e-8));
            }
            EXPECT_GE(deepest.plastic, 0);
        }
    }
}


TEST(contactEnergy, springsGiveTheForceAsSlope)
{
    // k conjugate to xi: dU/d(xi) is the force, dU/d(angle) the moment, angle = xi/R
    Law law;
    law.friction = 10;
    law.adhesionHysteresis = 0.4;
    law.twisting = true;
    Contact contact(law);
    const double overlap = 2e-9, slide = 1e-12, roll = 2e-12, twist = 1e-6;
    contact.history[1] = slide;         // y, of x y z: the normal is x
    contact.history[5] = roll;          // z
    contact.history[6] = twist;
    const dem::ContactEnergy e = contact.energy(overlap);
    contact.place(overlap);
    dem::Load load{};
    contact.law.evaluateWalls(contact.list, 0, 1, &contact.body, &load, {}, 1);
    EXPECT_TRUE(scene::close(-load.f[1], e.springs[0].stiffness*slide, 1e-12));
    // torque of rolling is -n x M: about y here
    EXPECT_TRUE(scene::close(load.t[1], e.springs[1].stiffness*r*roll, 1e-12));
    EXPECT_TRUE(scene::close(-load.t[0], e.springs[2].stiffness*twist, 1e-12));
    EXPECT_TRUE
    (
        scene::close
        (
            e.inSprings(),
            0.5*(-load.f[1]*slide + load.t[1]*roll/r - load.t[0]*twist), 1e-12
        )
    );
}
