// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/System.hpp"

#include "particles/errors.hpp"
#include "particles/finite.hpp"
#include "system/Diagnostics.hpp"
#include "system/ParticleStep.hpp"
#include "system/ParticleStore.hpp"
#include "system/Stiffening.hpp"
#include "walls/WallSearch.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

namespace
{

const TimeSettings& checked(const TimeSettings& time)
{
    const auto refuse = [](const char* keyword, double value, const std::string& allowed)
    {
        throw inputError
        (
            std::string("timeIntegration/") + keyword, "is " + std::to_string(value), allowed
        );
    };
    if
    (
        !isFinite(time.stepsPerContact)
     || !(time.stepsPerContact >= TimeSettings::fewestStepsPerContact)
    )
    {
        refuse
        (
            "stepsPerContact", time.stepsPerContact,
            "at least " + std::to_string(int(TimeSettings::fewestStepsPerContact))
          + " (fewer do not resolve a collision; at pi and below the scheme is unstable)"
        );
    }
    if (!(isFinite(time.boundShare) && time.boundShare > 0 && time.boundShare <= 1))
    {
        refuse
        (
            "boundShare", time.boundShare,
            "above 0, at most 1 (beyond the stability bound errors grow without limit)"
        );
    }
    if (!(isFinite(time.restTolerance) && time.restTolerance >= 0))
    {
        refuse("restTolerance", time.restTolerance, "zero or positive");
    }
    return time;
}


void check(const Particle& p, const MaterialTable& materials)
{
    const std::string name = "particle " + std::to_string(p.id);
    if (!(isFinite(p.radius) && p.radius > 0))
    {
        throw inputError
        (
            "diameter", name + " has " + std::to_string(2*p.radius) + " m",
            "a positive number"
        );
    }
    if (!(isFinite(p.mass) && p.mass > 0))
    {
        throw inputError
        (
            "density", name + " has a mass of " + std::to_string(p.mass) + " kg",
            "a positive number"
        );
    }
    if (p.material < 0 || p.material >= int(materials.materials().size()))
    {
        throw inputError("material", name, "an index into the materials");
    }
}

}


//- Who owns what: the settings and the walls, the particles, and what moves them
class System::Implementation
{
public:

    Implementation(MaterialTable m, const TimeSettings& t, Communicator c)
    :
        materials(std::move(m)),
        time(checked(t)),
        communicator(c),
        walls(Walls{}),
        step(store, materials, time, walls, periodic, communicator)
    {}

    Diagnostics diagnostics() const
    {
        return {store, materials, walls, periodic, communicator};
    }

    MaterialTable materials;
    TimeSettings time;
    Communicator communicator;
    WallSearch walls;
    Periodic periodic;
    ParticleStore store;
    ParticleStep step;
    bool keepExchange = false;
    Sum kicked;             // work of kick() since the last advance() [J]
    double now = 0;
};


System::System
(
    MaterialTable materials, const TimeSettings& time, Communicator communicator
)
:
    impl_(std::make_unique<Implementation>(std::move(materials), time, communicator))
{}


System::~System() = default;


const MaterialTable& System::materials() const { return impl_->materials; }
Restiffened System::setRatio(double chi)
{
    return Stiffening
    (
        impl_->store, impl_->materials, impl_->walls, impl_->periodic, impl_->communicator
    ).to(chi);
}


const TimeSettings& System::timeSettings() const { return impl_->time; }


void System::setWalls(Walls walls)
{
    for (const WallPatch& p : walls.patches)
    {
        if (p.material == mirror && materials().mirrors()) continue;
        if (p.material < 0 || p.material >= int(materials().materials().size()))
        {
            throw inputError
            (
                "walls", "material " + std::to_string(p.material) + " of " + p.name,
                "an index into the materials, or mirror where these have addMirrors()"
            );
        }
    }
    impl_->walls = WallSearch(std::move(walls));
}


void System::setPeriodic(const Periodic& periodic)
{
    if (size() || impl_->communicator.parallel())
    {
        throw inputError
        (
            "periodic", size() ? "set after the first particle" : "on several ranks",
            "one rank, before the first particle"
        );
    }
    impl_->periodic = periodic;
}


const Walls& System::walls() const { return impl_->walls.walls(); }


std::size_t System::size() const { return impl_->store.size(); }


std::size_t System::add(const Particle& p, double delay)
{
    if (!isFinite(delay))
    {
        throw inputError("delay", "is " + std::to_string(delay), "a finite time [s]");
    }
    check(p, materials());
    checkCurvature(walls(), p.radius, p.id);
    Particle inside = p;
    inside.x = impl_->periodic.wrapped(p.x);
    return impl_->store.add(inside, materials().reach(p.material, p.radius, walls()), delay);
}


void System::remove(const std::vector<char>& marked) { impl_->store.remove(marked); }


const Particle& System::particle(std::size_t i) const
{
    return impl_->store.particles[impl_->store.checked(i)];
}


void System::setMotion
(
    std::size_t i, const Vec3& x, const Vec3& v, const Vec3& omega
)
{
    impl_->store.setMotion(i, impl_->periodic.wrapped(x), v, omega);
}


bool System::resting(std::size_t i) const
{
    return impl_->store.rest[impl_->store.checked(i)].resting && !impl_->store.flies(i);
}


const std::vector<std::size_t>& System::awake() const { return impl_->store.index.awake(); }
const std::vector<std::size_t>& System::moved() const { return impl_->store.moved; }


double System::behind(std::size_t i) const
{
    return std::max(0.0, -impl_->store.delay(impl_->store.checked(i)));
}


bool System::inContact(std::size_t i) const
{
    return impl_->store.rest[impl_->store.checked(i)].inContact;
}


Vec3 System::wallNormal(std::size_t i) const
{
    Vec3 sum = Vec3::Zero();
    for (const ContactRecord& c : impl_->store.contacts[impl_->store.checked(i)])
    {
        if (c.wall >= 0 && !walls().mirrors(c.wall)) sum += Vec3(c.n[0], c.n[1], c.n[2]);
    }
    const double length = sum.norm();
    return length > 0 ? Vec3(sum/length) : sum;
}


void System::setGasLoad(std::size_t i, const GasLoad& load)
{
    ParticleStore& store = impl_->store;
    store.checked(i);
    if (!(load.finite() && load.Sp >= 0 && load.SpOmega >= 0))
    {
        throw numericalError
        (
            "The gas force on particle " + std::to_string(store.particles[i].id)
          + " is not finite or its drag is negative, at time "
          + std::to_string(impl_->now) + " s"
        );
    }
    store.setGas(i, load);
}


const GasLoad& System::gasLoad(std::size_t i) const
{
    return impl_->store.gas[impl_->store.checked(i)];
}


StepReport System::advance(double dt, double ahead, bool begins)
{
    if (!(isFinite(dt) && dt > 0))
    {
        throw inputError("dt", "is " + std::to_string(dt), "a positive time [s]");
    }
    if (!(isFinite(ahead) && ahead >= 0))
    {
        throw inputError("ahead", "is " + std::to_string(ahead), "zero or a positive time [s]");
    }
    for (const auto& entry : impl_->store.delays)
    {
        if (entry.second < dt) continue;
        throw inputError
        (
            "delay", "particle " + std::to_string(entry.first) + " enters after the step",
            "less than the particle step"
        );
    }
    StepReport report;
    report.energy.kinetic = report.energy.gas = impl_->kicked;
    impl_->kicked = Sum();
    impl_->step.advance({dt, impl_->now, ahead, begins}, impl_->keepExchange, report);
    impl_->now += dt;
    return report;
}


const GasExchange& System::gasExchange(std::size_t i) const
{
    ParticleStore& store = impl_->store;
    store.checked(i);
    return impl_->keepExchange ? store.gasExchange(i) : store.exchange[i];
}


void System::keepGasExchange(bool keep) { impl_->keepExchange = keep; }


void System::kick(std::size_t i, const Vec3& impulse)
{
    Particle& p = impl_->store.particles[impl_->store.checked(i)];
    const double before = p.kineticEnergy();
    p.v += impulse/p.mass;
    if (impl_->time.energyLedger) impl_->kicked += p.kineticEnergy() - before;
}


double System::time() const { return impl_->now; }
void System::setTime(double time) { impl_->now = time; }


std::vector<ContactView> System::contacts() const { return impl_->diagnostics().contacts(); }


std::vector<double> System::adhesionMargins() const
{
    return impl_->diagnostics().adhesionMargins();
}


std::vector<ClusterLabel> System::clusters() const { return impl_->diagnostics().clusters(); }


Entrance System::entrance
(
    const Box& box, double dt, double largest, double fastest
) const
{
    const ParticleStore& store = impl_->store;
    const Box around{box.low.array() - largest, box.high.array() + largest};
    std::vector<Particle> particles;
    for (const std::size_t i : store.index.awake()) particles.push_back(store.particles[i]);
    store.index.near(around, impl_->periodic, [&](std::size_t i)
    {
        particles.push_back(store.particles[i]);
    });
    return {particles, impl_->walls, impl_->periodic, box, dt, largest, fastest};
}


std::vector<double> System::packState(std::size_t i) const
{
    return impl_->store.packState(i);
}


std::vector<int> System::unpackState
(
    std::size_t i,
    const std::vector<double>& state,
    const std::vector<int>& wallNow
)
{
    return impl_->store.unpackState(i, state, wallNow, int(walls().patches.size()));
}

}
