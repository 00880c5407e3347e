// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small scenes that between them visit the whole DEM library, each as two hashes: of every bit
// of the motion, and of the counts and sums that the steps report. See tests/tools/sameBits.
//
//     scenes [NAME ...]           on one rank: all scenes, or these
//     mpirun -np N scenes ranks   the scenes that are decomposed
//
// It uses what System.hpp offers to everybody, and nothing that is packed: the packed state may
// change its form, what is made from it may not.
#include "clouds.hpp"

#include <mpi.h>

#include <cstring>
#include <map>

using dem::Vec3;
using scene::Law;
using scene::Random;
using scene::sphere;

namespace
{

//- FNV-1a of the bits
class Hash
{
public:

    void add(double value)
    {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        for (int byte = 0; byte < 8; ++byte)
        {
            hash_ = (hash_ ^ ((bits >> 8*byte) & 0xff))*0x100000001b3ull;
        }
    }
    void add(const Vec3& v) { for (int d = 0; d < 3; ++d) add(v[d]); }
    std::uint64_t value() const { return hash_; }

private:

    std::uint64_t hash_ = 0xcbf29ce484222325ull;
};


dem::Communicator world() { return dem::Communicator(MPI_COMM_WORLD); }


//- A system, and what is made of it
class Bits
{
public:

    Bits(const Law& law, const dem::TimeSettings& time = {}, bool decomposed = false)
    :
        law_(law),
        time_(time),
        decomposed_(decomposed)
    {
        renew();
    }

    dem::System& operator*() { return *system_; }
    dem::System* operator->() { return system_.get(); }

    void renew()
    {
        system_ = std::make_unique<dem::System>
        (
            law_.table(), time_, decomposed_ ? world() : dem::Communicator()
        );
        system_->keepGasExchange(true);
    }

    void add(const std::vector<dem::Particle>& particles)
    {
        for (const dem::Particle& p : particles)
        {
            if (!decomposed_ || p.id%world().size() == world().rank()) system_->add(p);
        }
    }

    //- Steps in the gas that `load` describes
    template<class Loader>
    void run(int steps, double dt, const Loader& load)
    {
        for (int step = 0; step < steps; ++step)
        {
            load(*system_);
            take(system_->advance(dt));
            if (step%10 == 0 || step == steps - 1) takeMotion();
        }
    }
    void run(int steps, double dt) { run(steps, dt, [](dem::System& s) { scene::load(s); }); }

    void take(const dem::StepReport& r)
    {
        const double counts[] =
        {
            double(r.contactSteps), double(r.contactUpdates), double(r.islands),
            double(r.freeFlights), double(r.aggregateFlights), double(r.repeats),
            double(r.touches), double(r.followerTouches), double(r.separations),
            double(r.sleeps), double(r.wakes), double(r.resting), double(r.flyingAtRest),
            double(r.inContact), r.touchSpeed, r.touchSpeedSquare, r.maxOverlapOverDiameter,
            r.minStepsPerContact, r.maxStepOverBound, r.energyRemovedByRest
        };
        for (const double c : counts) reports.add(c);
        const dem::EnergyLedger& e = r.energy;
        for
        (
            const double term :
            {
                e.kinetic, e.normal, e.springs, e.released, e.dashpots, e.yield, e.plastic,
                e.rest, e.gas, e.springGain
            }
        ) reports.add(term);
        total.add(r);
    }

    void takeMotion()
    {
        std::map<double, std::vector<double>> byId;
        std::vector<double> mine;
        for (std::size_t i = 0; i < system_->size(); ++i)
        {
            const dem::Particle& p = system_->particle(i);
            const dem::GasExchange& g = system_->gasExchange(i);
            const bool rests = system_->resting(i), touches = system_->inContact(i);
            mine.push_back(double(p.id));
            for (const Vec3* v : {&p.x, &p.v, &p.omega, &g.impulse})
            {
                mine.insert(mine.end(), v->data(), v->data() + 3);
            }
            mine.insert
            (
                mine.end(),
                {g.response, g.memory, double(g.held), double(rests), double(touches)}
            );
        }
        constexpr std::size_t n = 18;
        const auto everybody =
            decomposed_ ? world().gather(mine) : std::vector<std::vector<double>>{mine};
        for (const auto& from : everybody)
        {
            for (std::size_t k = 0; k + n <= from.size(); k += n)
            {
                byId[from[k]] = {from.begin() + long(k), from.begin() + long(k + n)};
            }
        }
        for (const auto& entry : byId) for (const double v : entry.second) motion.add(v);
    }

    void takeContacts()
    {
        for (const dem::ContactView& c : system_->contacts())
        {
            motion.add(double(c.idI));
            motion.add(double(c.idJ));
            motion.add(c.wall);
            for (const Vec3* v : {&c.point, &c.normal, &c.force}) motion.add(*v);
            for (const double v : {c.overlap, c.pullOff, c.contactRadius}) motion.add(v);
        }
        for (const double m : system_->adhesionMargins()) motion.add(m);
        for (const dem::ClusterLabel& c : system_->clusters())
        {
            motion.add(double(c.root));
            motion.add(c.onWall);
        }
    }

    dem::StepReport total;
    Hash motion, reports;

private:

    Law law_;
    dem::TimeSettings time_;
    bool decomposed_;
    std::unique_ptr<dem::System> system_;
};


//- So that a scene which no longer shows what it is here for is seen
void require(bool happens, const char* what)
{
    if (!happens) throw std::runtime_error(std::string("no ") + what + " in this scene");
}


dem::TimeSettings ledger()
{
    dem::TimeSettings t;
    t.energyLedger = true;
    return t;
}


//- Every part of the law with this normal part; walton: the parts made for van der Waals
Law lawOf(const std::string& normal, bool walton = false)
{
    Law law = scene::stickyLaw();
    law.normal = normal;
    if (normal == "Hertz")
    {
        law.gamma = 0;
        law.adhesionHysteresis = -1;
    }
    if (normal == "cohesivePlastic")
    {
        law.E = 7e10;
        law.gamma = 0;
        law.softening.ratio = 1;
        law.adhesionHysteresis = -1;
        law.twisting = false;
    }
    law.adjust = [normal, walton](dem::ContactSettings& s)
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
                {"attractionBuildUp", 0.1}, {"softening", 0.01}
            };
        }
        if (walton)
        {
            s.rolling = {"bending", {{"bendingFactor", 1.7}}};
            s.twisting = {"cappedSpring", {{"twistingFactor", 0.6}}};
        }
    };
    return law;
}


//- Dust that falls on the floor and comes to rest there
void settle(Bits& bits, int n, int steps, unsigned seed = 5, double dt = 1e-6)
{
    bits->setWalls(scene::floor());
    bits.add(scene::rain(lawOf("JKR"), n, 5e-6, seed));
    bits.run(steps, dt);
}

void shoot(Bits& bits, int n, double speed)
{
    Random random(77);
    for (int k = 0; k < n; ++k)
    {
        const Vec3 x(random.uniform(-4e-6, 4e-6), random.uniform(-4e-6, 4e-6), 3e-5 + 3e-6*k);
        bits.add({sphere(lawOf("JKR"), 10000 + k, 7e-7, x, Vec3(0.1*speed, 0, -speed))});
    }
}

//- What a normal part does with all others
Bits law(const std::string& normal, bool walton = false)
{
    Bits bits(lawOf(normal, walton), ledger());
    // contacts that yield are stiff
    if (normal == "cohesivePlastic") settle(bits, 15, 25);
    else settle(bits, 40, 60);
    bits.takeContacts();
    require(bits.total.touches > 8, "touches");
    return bits;
}


// * * * * * * * * * * * * * * * * * * Scenes * * * * * * * * * * * * * * * * * * * * * * //

Bits restingBed()
{
    Bits bits(scene::stickyLaw());
    settle(bits, 80, 250);
    bits.takeContacts();
    require(bits.total.resting > 20 && bits.total.sleeps > 20, "rest");
    return bits;
}

Bits bombardedBed()
{
    Bits bits(scene::stickyLaw());
    settle(bits, 80, 200);
    shoot(bits, 8, 3);
    bits.run(150, 1e-6);
    bits.takeContacts();
    require(bits.total.wakes > 5, "waking");
    return bits;
}

Bits flyingAggregates()
{
    // no wall: what meets sticks, turns in the shear and flies on as one
    Bits bits(scene::stickyLaw());
    bits.add(scene::rain(scene::stickyLaw(), 30, 4e-6, 9));
    bits.run(200, 2e-6, [](dem::System& s)
    {
        for (std::size_t i = 0; i < s.size(); ++i)
        {
            const dem::Particle& p = s.particle(i);
            dem::GasLoad g = scene::breeze(p, 0);
            g.Uc = Vec3(3e3*p.x.z(), -1e4*p.x.y(), -2e3*p.x.z());
            s.setGasLoad(i, g);
        }
    });
    bits.takeContacts();
    require(bits.total.aggregateFlights > 10, "flight of aggregates");
    return bits;
}

Bits periodicBox()
{
    Law law = scene::stickyLaw();
    law.gamma = 0.01;
    const double r = 5e-6, edge = 30*r;
    dem::Periodic periodic;
    periodic.length = Vec3(edge, edge, 0);
    Bits bits(law, ledger());
    bits->setPeriodic(periodic);
    bits->setWalls(scene::floor());
    Random random(3);
    std::vector<dem::Particle> dust;
    while (dust.size() < 60)
    {
        const double radius = r*random.uniform(0.5, 1.5);
        const Vec3 x = Vec3(0, 0, 0.5*edge + 3.2*r) + random.inBox(0.5*edge);
        bool free = true;
        for (const dem::Particle& p : dust)
        {
            free = free && periodic.nearest(p.x - x).norm() > 1.02*(p.radius + radius);
        }
        if (free) dust.push_back(sphere(law, std::int64_t(dust.size()), radius, x, random.inBox(1.5)));
    }
    bits.add(dust);
    bits.run(150, 2e-6, [](dem::System&) {});
    bits.takeContacts();
    require(bits.total.touches > 20, "touches");
    return bits;
}

Bits wallsWithEdges()
{
    // a step of triangles, a wire and a bore, with curved contacts
    Law law = scene::stickyLaw();
    const double L = 2e-5, h = 5e-6;
    dem::Walls walls;
    walls.patches = {{"step", 1}, {"wire", 1}, {"ball", 1, dem::WallCurvature{2e5, 2e5}}};
    const auto rectangle = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
    {
        walls.triangles.push_back({a, b, c, 0});
        walls.triangles.push_back({a, c, d, 0});
    };
    rectangle({-L, -L, 0}, {0, -L, 0}, {0, L, 0}, {-L, L, 0});
    rectangle({0, -L, h}, {L, -L, h}, {L, L, h}, {0, L, h});
    rectangle({0, -L, 0}, {0, -L, h}, {0, L, h}, {0, L, 0});
    walls.cylinders = {{Vec3(-8e-6, 0, 2e-6), Vec3(0, 1, 0.1).normalized(), 3e-6, false, 1}};
    walls.spheres = {{Vec3(6e-6, 6e-6, 6e-6), 4e-6, false, 2}};
    Bits bits(law);
    bits->setWalls(walls);
    std::vector<dem::Particle> dust = scene::rain(law, 120, 8e-6, 21);
    for (dem::Particle& p : dust) p.x.z() += 1.2e-5;
    bits.add(dust);
    bits.run(120, 1e-6);
    bits.takeContacts();
    std::map<int, int> met;
    for (const dem::ContactView& c : bits->contacts()) ++met[c.wall];
    require(met[0] > 0 && met[1] > 0 && met[2] > 0, "contact with each patch");
    return bits;
}

Bits gasLoads()
{
    // strong drag that changes, spin, impulses from outside
    Law law = scene::stickyLaw();
    Bits bits(law, ledger());
    bits->setWalls(scene::floor());
    bits.add(scene::rain(law, 50, 8e-6, 33));
    for (int round = 0; round < 20; ++round)
    {
        bits.run(4, 3e-6, [&](dem::System& s)
        {
            for (std::size_t i = 0; i < s.size(); ++i)
            {
                dem::GasLoad g = scene::breeze(s.particle(i), s.time());
                g.Uc *= 5*std::cos(0.3*round);
                g.Su = Vec3(0, 1e-12, -1e-11);
                s.setGasLoad(i, g);
            }
        });
        for (std::size_t i = 0; i < bits->size(); ++i)
        {
            if (!bits->inContact(i)) bits->kick(i, 1e-17*Vec3(double(i%3), 1, -1));
        }
    }
    bits.takeContacts();
    return bits;
}

Bits withoutIslands()
{
    dem::TimeSettings time = ledger();
    time.islands = false;
    time.restTolerance = 0;
    Bits bits(scene::stickyLaw(), time);
    settle(bits, 30, 15, 6);
    require(bits.total.touches > 10 && bits.total.freeFlights == 0, "touches, or some fly freely");
    return bits;
}

Bits neverRests()
{
    dem::TimeSettings time;
    time.restTolerance = 0;
    time.stepsPerContact = 30;
    Bits bits(scene::stickyLaw(), time);
    settle(bits, 30, 20, 8);
    require(bits.total.touches > 10 && bits.total.sleeps == 0, "touches, or some rest");
    return bits;
}

Bits restart()
{
    Bits bits(scene::stickyLaw());
    settle(bits, 60, 40);
    std::vector<dem::Particle> particles;
    std::vector<std::vector<double>> states;
    for (std::size_t i = 0; i < bits->size(); ++i)
    {
        particles.push_back(bits->particle(i));
        states.push_back(bits->packState(i));
    }
    const double time = bits->time();
    bits.renew();
    bits->setWalls(scene::floor());
    bits->setTime(time);
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        bits->unpackState(bits->add(particles[i]), states[i]);
    }
    bits.takeContacts();
    bits.run(80, 1e-6);
    bits.takeContacts();
    return bits;
}

Bits addedMovedRemoved()
{
    Bits bits(scene::stickyLaw());
    settle(bits, 60, 120);
    for (int round = 0; round < 5; ++round)
    {
        std::vector<char> gone(bits->size(), 0);
        for (std::size_t i = 0; i < gone.size(); ++i) gone[i] = (i + std::size_t(round))%11 == 0;
        bits->remove(gone);
        const dem::Particle p = bits->particle(3);
        bits->setMotion(3, p.x + Vec3(0, 0, 4e-6), Vec3(0.2, 0, -1), p.omega);
        bits.add({sphere(scene::stickyLaw(), 5000 + round, 8e-7, Vec3(0, 0, 3e-5), Vec3(0, 0, -2))});
        bits.run(25, 1e-6);
    }
    bits.takeContacts();
    return bits;
}

Bits stiff()
{
    // chi = 1
    Law law = scene::stickyLaw();
    law.softening.ratio = 1;
    law.rollingDamping = 1e-15;
    Bits bits(law, ledger());
    settle(bits, 25, 30);
    require(bits.total.touches > 5, "touches");
    return bits;
}

Bits softAsGiven()
{
    // the studies' ways to soften, and the critical angle
    Law law = scene::stickyLaw();
    law.softening.ratio = 0.3;
    law.softening.scaleResistance = true;
    law.softening.scaleSurfaceEnergy = false;
    law.adhesionHysteresis = -1;
    law.criticalAngle = 0.02;
    Bits bits(law, ledger());
    settle(bits, 40, 50);
    require(bits.total.touches > 10, "touches");
    return bits;
}

Bits sizeRatio()
{
    // one of 100 times the radius among small ones
    Law law = scene::stickyLaw();
    Bits bits(law);
    bits->setWalls(scene::floor());
    const double r = 3e-7, big = 100*r;
    Random random(12);
    std::vector<dem::Particle> dust;
    dust.push_back(sphere(law, 1, big, Vec3(0, 0, 1.01*big), Vec3(0.05, 0, -0.1)));
    for (int k = 0; k < 80; ++k)
    {
        const Vec3 n = random.direction();
        const Vec3 at = Vec3(0, 0, 1.01*big) + (big + 1.5*r)*Vec3(n.x(), n.y(), std::fabs(n.z()));
        bool free = true;
        for (const dem::Particle& p : dust) free = free && (p.x - at).norm() > p.radius + 1.2*r;
        if (free) dust.push_back(sphere(law, 2 + k, r, at, -0.5*Vec3(n.x(), n.y(), std::fabs(n.z()))));
    }
    bits.add(dust);
    bits.run(30, 1e-6);
    bits.takeContacts();
    require(bits.total.touches > 30, "touches");
    return bits;
}

Bits longSteps()
{
    // fast ones that meet several others within one particle step
    Law law = scene::stickyLaw();
    law.gamma = 0.002;
    Bits bits(law);
    bits->setWalls(scene::floor());
    bits.add(scene::rain(law, 120, 1.2e-5, 71));
    bits.run(12, 5e-5, [](dem::System&) {});
    require(bits.total.repeats > 0 && bits.total.touches > 60, "repeated steps");
    return bits;
}


// On several ranks

Bits ranksBed()
{
    Bits bits(scene::stickyLaw(), {}, true);
    settle(bits, 80, 150);
    shoot(bits, 6, 3);
    bits.run(60, 1e-6);
    bits.takeContacts();
    return bits;
}

Bits ranksCloud()
{
    Bits bits(scene::stickyLaw(), ledger(), true);
    bits.add(scene::rain(scene::stickyLaw(), 60, 6e-6, 19));
    bits.run(150, 2e-6);
    bits.takeContacts();
    return bits;
}

Bits ranksWithoutIslands()
{
    dem::TimeSettings time;
    time.islands = false;
    Bits bits(scene::stickyLaw(), time, true);
    settle(bits, 20, 8, 6);
    return bits;
}


struct Scene
{
    const char* name;
    Bits (*make)();
};

const Scene scenes[] =
{
    {"restingBed", restingBed},
    {"bombardedBed", bombardedBed},
    {"flyingAggregates", flyingAggregates},
    {"periodicBox", periodicBox},
    {"Hertz", [] { return law("Hertz"); }},
    {"simplifiedJKR", [] { return law("simplifiedJKR"); }},
    {"JKR", [] { return law("JKR"); }},
    {"DMT", [] { return law("DMT"); }},
    {"vanDerWaals", [] { return law("vanDerWaals"); }},
    {"cohesivePlastic", [] { return law("cohesivePlastic"); }},
    {"JKRBending", [] { return law("JKR", true); }},
    {"vanDerWaalsBending", [] { return law("vanDerWaals", true); }},
    {"cohesivePlasticBending", [] { return law("cohesivePlastic", true); }},
    {"wallsWithEdges", wallsWithEdges},
    {"gasLoads", gasLoads},
    {"withoutIslands", withoutIslands},
    {"neverRests", neverRests},
    {"restart", restart},
    {"addedMovedRemoved", addedMovedRemoved},
    {"stiff", stiff},
    {"softAsGiven", softAsGiven},
    {"sizeRatio", sizeRatio},
    {"longSteps", longSteps}
};

const Scene decomposedScenes[] =
{
    {"bed", ranksBed}, {"cloud", ranksCloud}, {"withoutIslands", ranksWithoutIslands}
};


void print(const std::string& name, Bits (*make)(), bool decomposed)
{
    const Bits bits = make();
    // what each rank reports, in the order of the ranks
    Hash reports = bits.reports, motion = bits.motion;
    if (decomposed)
    {
        for (const bool ofMotion : {true, false})
        {
            const std::uint64_t own = (ofMotion ? bits.motion : bits.reports).value();
            Hash& all = ofMotion ? motion : reports;
            const std::vector<double> halves{double(own >> 32), double(own & 0xffffffffu)};
            for (const auto& from : world().gather(halves)) for (const double h : from) all.add(h);
        }
        if (world().rank() > 0) return;
    }
    std::printf
    (
        "%s %016llx %016llx\n", name.c_str(), static_cast<unsigned long long>(motion.value()),
        static_cast<unsigned long long>(reports.value())
    );
    std::fflush(stdout);
}

}


int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const std::vector<std::string> wanted(argv + 1, argv + argc);
    const bool decomposed = wanted.size() == 1 && wanted[0] == "ranks";
    std::string name;
    try
    {
        if (decomposed)
        {
            for (const Scene& s : decomposedScenes)
            {
                name = "ranks" + std::to_string(world().size()) + "/" + s.name;
                print(name, s.make, true);
            }
        }
        else
        {
            for (const Scene& s : scenes)
            {
                name = s.name;
                const bool asked =
                    wanted.empty() || std::count(wanted.begin(), wanted.end(), name) > 0;
                if (asked) print(name, s.make, false);
            }
        }
    }
    catch (const std::exception& error)
    {
        std::printf("%s failed: %s\n", name.c_str(), error.what());
        std::fflush(stdout);
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    MPI_Finalize();
    return 0;
}
