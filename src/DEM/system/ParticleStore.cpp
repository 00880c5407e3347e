// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/ParticleStore.hpp"

#include "contacts/PackedState.hpp"
#include "foundation/Fields.hpp"
#include "particles/errors.hpp"
#include "contacts/restCriteria.hpp"
#include "particles/finite.hpp"

#include <string>

namespace dem
{

namespace
{

// An impossible wake force: the whole cluster wakes at the next step
void wakeUp(RestState& rest) { rest.wakeForce = -1; }

void needFinite(const std::string& name, const Vec3& x, const Vec3& v, const Vec3& omega)
{
    if (isFinite(x) && isFinite(v) && isFinite(omega)) return;
    throw inputError("position", name + " is not finite", "finite numbers");
}

//- There may be very many: only a tenth more room than is needed
template<class T>
void append(std::vector<T>& column, const T& value)
{
    if (column.size() == column.capacity()) column.reserve(column.size() + column.size()/10 + 16);
    column.push_back(value);
}

std::string nameOf(std::int64_t id) { return "particle " + std::to_string(id); }

}


std::size_t ParticleStore::checked(std::size_t i) const
{
    if (i >= size())
    {
        throw inputError
        (
            "particle", "index " + std::to_string(i), "below " + std::to_string(size())
        );
    }
    return i;
}


std::size_t ParticleStore::add(const Particle& p, double reachOf, double delay)
{
    needFinite(nameOf(p.id), p.x, p.v, p.omega);
    if (p.id < 0 || !indexOf.emplace(p.id, size()).second)
    {
        throw inputError("id", nameOf(p.id) + " is there already", "unique numbers, 0 or more");
    }
    if (delay != 0) delays.emplace(p.id, delay);
    append(particles, p);
    append(gas, {});
    append(rest, {});
    append(exchange, {});
    append(reach, reachOf);
    append(contacts, {});
    append(counted_, char(0));
    append(exchanged_, steps_);
    index.add();
    return size() - 1;
}


void ParticleStore::setMotion
(
    std::size_t i, const Vec3& x, const Vec3& v, const Vec3& omega
)
{
    Particle& p = particles[checked(i)];
    needFinite(nameOf(p.id), x, v, omega);
    p.x = x;
    p.v = v;
    p.omega = omega;
    delays.erase(p.id);
    wakeUp(rest[i]);
    rest[i].quietTime = 0;
    changed(i);
}


void ParticleStore::setGas(std::size_t i, const GasLoad& load)
{
    gas[i] = load;
    if (rest[i].resting) changed(i);
}


void ParticleStore::changed(std::size_t i)
{
    if (awake(i)) index.moves(i);
    else index.rests(i, particles[i].x, particles[i].radius + reach[i]);
    count(i);
}


void ParticleStore::count(std::size_t i)
{
    enum { isResting = 1, isFlying = 2, isInContact = 4 };
    const RestState& r = rest[i];
    const int now =
        (r.resting && !flies(i) ? isResting : 0) | (flies(i) ? isFlying : 0)
      | (r.inContact ? isInContact : 0);
    const int before = counted_[i];
    const auto difference = [&](int bit) { return int((now & bit) > 0) - int((before & bit) > 0); };
    counts.resting += difference(isResting);
    counts.flyingAtRest += difference(isFlying);
    counts.inContact += difference(isInContact);
    counted_[i] = char(now);
}


void ParticleStore::began(double dt)
{
    step_ = dt;
    ++steps_;
    moved.clear();
}


void ParticleStore::give(std::size_t i, const GasExchange& given)
{
    exchange[i] = given;
    exchanged_[i] = steps_;
}


const GasExchange& ParticleStore::gasExchange(std::size_t i)
{
    if (exchanged_[i] != steps_ && rest[i].resting)
    {
        const GasLoad& g = gas[i];
        give(i, {step_*(g.Sp*g.Uc + g.Su), step_*g.Sp, 1, true});
    }
    return exchange[i];
}


void ParticleStore::remove(const std::vector<char>& marked)
{
    index.remove(marked);
    moved.clear();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        if (i < marked.size() && marked[i])
        {
            indexOf.erase(particles[i].id);
            if (!delays.empty()) delays.erase(particles[i].id);
            rest[i] = RestState();
            count(i);
            continue;
        }
        if (kept != i)
        {
            particles[kept] = particles[i];
            gas[kept] = gas[i];
            rest[kept] = rest[i];
            exchange[kept] = exchange[i];
            reach[kept] = reach[i];
            contacts[kept] = std::move(contacts[i]);
            counted_[kept] = counted_[i];
            exchanged_[kept] = exchanged_[i];
            indexOf[particles[i].id] = kept;
        }
        ++kept;
    }
    particles.resize(kept);
    gas.resize(kept);
    rest.resize(kept);
    exchange.resize(kept);
    reach.resize(kept);
    contacts.resize(kept);
    counted_.resize(kept);
    exchanged_.resize(kept);
}


bool ParticleStore::awake(std::size_t i) const
{
    return flies(i) || !rest[i].resting || wakes(rest[i], gas[i]);
}


std::vector<double> ParticleStore::packState(std::size_t i) const
{
    std::vector<double> state;
    if (rest[checked(i)].inContact || !contacts[i].empty())
    {
        state.push_back(PackedState::version);
        pack(rest[i], state);
        for (const ContactRecord& c : contacts[i]) pack(c, state);
    }
    return state;
}


std::vector<int> ParticleStore::unpackState
(
    std::size_t i,
    const std::vector<double>& state,
    const std::vector<int>& wallNow,
    int nWalls
)
{
    checked(i);
    if (state.empty()) return {};
    const auto refuse = [&](const std::string& reason, const std::string& allowed)
    {
        throw inputError("contact state", reason, allowed);
    };
    if (state[0] != PackedState::version)
    {
        refuse
        (
            "of version " + std::to_string(state[0]) + " for " + nameOf(particles[i].id),
            "version " + std::to_string(int(PackedState::version))
        );
    }
    if (!PackedState::fits(state.size()))
    {
        refuse
        (
            std::to_string(state.size()) + " numbers for " + nameOf(particles[i].id),
            std::to_string(PackedState::restNumbers) + " and "
          + std::to_string(PackedState::contactNumbers) + " per contact"
        );
    }
    const double* from = state.data() + 1;
    rest[i] = unpack<RestState>(from);
    changed(i);

    std::vector<int> gone;
    contacts[i].clear();
    while (from < state.data() + state.size())
    {
        ContactRecord c = unpack<ContactRecord>(from);
        const int then = c.wall;
        if (then >= 0 && !wallNow.empty())
        {
            c.wall = std::size_t(then) < wallNow.size() ? wallNow[std::size_t(then)] : nWalls;
            if (c.wall < 0)
            {
                gone.push_back(then);
                wakeUp(rest[i]);
                continue;
            }
        }
        if (c.wall >= nWalls)
        {
            refuse
            (
                "wall patch " + std::to_string(then),
                "below " + std::to_string(wallNow.empty() ? nWalls : int(wallNow.size()))
            );
        }
        contacts[i].push_back(c);
    }
    changed(i);
    return gone;
}

}
