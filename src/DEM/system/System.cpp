// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/System.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"
#include "contacts/ContactRecord.hpp"
#include "contacts/clusterMargins.hpp"
#include "neighbourSearch/BoxGrid.hpp"
#include "neighbourSearch/DisjointSets.hpp"
#include "particles/errors.hpp"
#include "timeIntegration/IslandIntegrator.hpp"
#include "timeIntegration/RigidAggregate.hpp"
#include "timeIntegration/freeFlight.hpp"
#include "walls/WallSearch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <unordered_map>

namespace dem
{

namespace
{

using Clock = std::chrono::steady_clock;

double since(Clock::time_point& start)
{
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - start).count();
    start = now;
    return seconds;
}

// Search boxes allow for speeds above the fastest member's, and for small motions of what
// holds together; where that turns out not to be enough the particle step is repeated
constexpr double speedMargin = 1.2;
constexpr double leastPath = 1e-3;      // [radii]

// Numbers per contact and per particle in a packed state
constexpr std::size_t contactNumbers = 5 + maxHistory;
constexpr std::size_t restNumbers = 13;

}


class System::Implementation
{
public:

    Implementation(MaterialTable m, const TimeSettings& t, Communicator c)
    :
        materials(std::move(m)),
        time(t),
        communicator(c),
        walls(Walls{}),
        integrator(std::make_unique<IslandIntegrator>(materials, time, walls, periodic))
    {
        if (!(time.stepsPerContact >= TimeSettings::fewestStepsPerContact))
        {
            throw inputError
            (
                "timeIntegration/stepsPerContact",
                "is " + std::to_string(time.stepsPerContact),
                "at least "
              + std::to_string(int(TimeSettings::fewestStepsPerContact))
              + " (fewer do not resolve a collision; at pi and below the scheme is unstable)"
            );
        }
        if (!(time.boundShare > 0 && time.boundShare <= 1))
        {
            throw inputError
            (
                "timeIntegration/boundShare",
                "is " + std::to_string(time.boundShare),
                "above 0, at most 1 (beyond the stability bound errors grow without limit)"
            );
        }
        if (!(time.restTolerance >= 0))
        {
            throw inputError
            (
                "timeIntegration/restTolerance",
                "is " + std::to_string(time.restTolerance), "zero or positive"
            );
        }
    }

    std::size_t checked(std::size_t i) const
    {
        if (i >= particles.size())
        {
            throw inputError
            (
                "particle", "index " + std::to_string(i),
                "below " + std::to_string(particles.size())
            );
        }
        return i;
    }

    //- One particle with all that is remembered of it, as it travels between ranks
    struct Member
    {
        Particle p;
        GasLoad gas;
        RestState rest;
        std::vector<ContactRecord> contacts;
        double half;        // half width of its search box beyond radius and reach [m];
                            // when moved: that it should have had, if more
        int owner;
        std::size_t index;  // on its owner
        Vec3 impulse = Vec3::Zero();
    };

    //- Members in order of id, as moved in one particle step
    struct Island
    {
        std::vector<Member> members;
        StepReport report;
        bool outran = false;    // one of them has left its search box

        //- Whether `other`, not moved yet, would be moved to where this is
        bool holdsFor(const std::vector<Member>& other) const
        {
            return !outran && std::equal
            (
                members.begin(), members.end(), other.begin(), other.end(),
                [](const Member& a, const Member& b) { return a.p.id == b.p.id; }
            );
        }
    };

    //- What the search needs to know of a particle in one particle step
    struct Path
    {
        Vec3 x, v;
        double size;        // radius and reach of its contacts [m]
        double bend;        // how far from the straight line it can get on its own [m]
        double speed;       // the fastest it can be on its own, or was when tried [m/s]
        bool deviates;      // can be pushed off the path it has on its own
        double half;        // where it can then get to: half width beyond size [m]
    };

    struct Labels
    {
        std::vector<std::int64_t> component;    // by particle: lowest id
        std::vector<double> speed;              // fastest member's bound [m/s]
        std::vector<char> active;               // some member is awake
        std::vector<char> shared;               // spans ranks
        std::vector<char> alone;                // one particle or rigid aggregate that
                                                // nothing pushes off its path
        std::vector<int> home;                  // rank that moves it
    };

    Path path(std::size_t i, double dt) const
    {
        const Particle& p = particles[i];
        const double size = p.radius + reach[i];
        if (!awake(i)) return {p.x, Vec3::Zero(), size, 0, 0, false, 0};
        const GasLoad& g = gas[i];
        const Vec3 force = g.Sp*(g.Uc - p.v) + g.Su;
        if (flies(i))
        {
            // along with the centre of mass; the rest bends its path
            const Vec3 held(rest[i].force[0], rest[i].force[1], rest[i].force[2]);
            const Vec3 arm(rest[i].arm[0], rest[i].arm[1], rest[i].arm[2]);
            const Vec3 turning = p.omega.cross(arm);
            const Vec3 V = p.v - turning;
            const double pull = ((force + held)/p.mass - p.omega.cross(turning)).norm();
            const double round = p.omega.norm()*arm.norm();
            const double bend = std::min(2*arm.norm(), round*dt) + 0.5*pull*dt*dt;
            return {p.x, V, size, bend, V.norm() + round + pull*dt, false, 0};
        }
        const FlightFactors f(g.Sp/p.mass, dt);
        const double pull = force.norm()/p.mass;
        const double speed = p.v.norm() + pull*f.p1;
        const bool touches = rest[i].inContact || !contacts[i].empty();
        return {p.x, p.v, size, 0.5*pull*dt*dt, speed, touches, halfWidth(i, speed, dt)};
    }

    //- How far particle i can be pushed at speeds about `speed` [m]
    double halfWidth(std::size_t i, double speed, double dt) const
    {
        return speedMargin*speed*dt + leastPath*particles[i].radius;
    }

    //- Where a particle can get to
    Box box(std::size_t i, const Path& p, double dt) const
    {
        if (p.deviates || p.speed == 0)
        {
            const double r = p.size + p.half;
            return {p.x.array() - r, p.x.array() + r};
        }
        Box b;
        if (flies(i))
        {
            const Vec3 end = p.x + dt*p.v;
            const double r = p.size + p.bend;
            return {p.x.cwiseMin(end).array() - r, p.x.cwiseMax(end).array() + r};
        }
        flightBox(particles[i], gas[i], dt, b.low, b.high);
        return {b.low.array() - p.size, b.high.array() + p.size};
    }

    //- Whether two whose boxes overlap can come as close as a contact
    bool meet(const Path& a, const Path& b, double dt) const
    {
        if (a.deviates || b.deviates) return true;
        const Vec3 d = periodic.nearest(b.x - a.x), u = b.v - a.v;
        const double square = u.squaredNorm();
        const double t =
            square > 0 ? std::min(std::max(-d.dot(u)/square, 0.0), dt) : 0;
        const double near = a.size + b.size + a.bend + b.bend;
        return (d + t*u).squaredNorm() <= near*near;
    }

    //- A member of a rigid aggregate
    bool flies(std::size_t i) const { return rest[i].aggregate >= 0; }

    bool awake(std::size_t i) const
    {
        return flies(i) || !rest[i].resting || wakes(rest[i], gas[i]);
    }

    Labels label
    (
        DisjointSets& sets, const std::vector<Box>& boxes, const std::vector<Path>& paths,
        double dt
    ) const;
    bool flyTogether(std::vector<Member>& members, double dt, StepReport& report);
    void integrate(std::vector<Member>& members, double dt, StepReport& report);
    StepReport advance(double dt);
    StepReport advanceTogether(double dt, std::vector<Path>& paths, StepReport& report);
    bool move
    (
        const Labels& labels, std::vector<Path>& paths, double dt,
        StepReport& report, Clock::time_point& clock
    );
    void finish(double dt, StepReport& report);

    Member member(std::size_t i, double half) const
    {
        return
        {
            particles[i], gas[i], rest[i], contacts[i], half,
            communicator.rank(), i, Vec3::Zero()
        };
    }

    void takeBack(const Member& m)
    {
        particles[m.index] = m.p;
        rest[m.index] = m.rest;
        contacts[m.index] = m.contacts;
        impulse[m.index] = m.impulse;
    }

    static void pack(const Member& m, std::vector<double>& to);
    static Member unpack(const double*& from);

    //- Particles of other ranks that own particles have contacts with
    std::unordered_map<std::int64_t, Particle> remotePartners() const;


    MaterialTable materials;
    TimeSettings time;
    Communicator communicator;
    WallSearch walls;
    Periodic periodic;
    std::unique_ptr<IslandIntegrator> integrator;
    std::map<std::int64_t, Island> tried;   // by component, from a try that was not enough

    std::vector<Particle> particles;
    std::vector<GasLoad> gas;
    std::vector<RestState> rest;
    std::vector<Vec3> impulse;
    std::vector<double> reach;
    std::vector<std::vector<ContactRecord>> contacts;
    std::unordered_map<std::int64_t, std::size_t> indexOf;
    double now = 0;
};


// * * * * * * * * * * * * * * * * * Packing * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

void packRest
(
    const RestState& rest,
    const std::vector<ContactRecord>& contacts,
    std::vector<double>& to
)
{
    to.insert
    (
        to.end(),
        {
            double(rest.inContact), double(rest.resting), rest.quietTime,
            rest.force[0], rest.force[1], rest.force[2], rest.wakeForce, rest.pullOff,
            double(rest.aggregate), double(rest.members),
            rest.arm[0], rest.arm[1], rest.arm[2]
        }
    );
    for (const ContactRecord& c : contacts)
    {
        to.push_back(double(c.idJ));
        to.push_back(double(c.wall));
        to.insert(to.end(), c.n, c.n + 3);
        to.insert(to.end(), c.history, c.history + maxHistory);
    }
}

void unpackRest
(
    const double* from,
    std::size_t nContacts,
    RestState& rest,
    std::vector<ContactRecord>& contacts
)
{
    rest.inContact = from[0] > 0;
    rest.resting = from[1] > 0;
    rest.quietTime = from[2];
    std::copy(from + 3, from + 6, rest.force);
    rest.wakeForce = from[6];
    rest.pullOff = from[7];
    rest.aggregate = std::int64_t(from[8]);
    rest.members = int(from[9]);
    std::copy(from + 10, from + 13, rest.arm);
    from += restNumbers;
    contacts.resize(nContacts);
    for (ContactRecord& c : contacts)
    {
        c.idJ = std::int64_t(from[0]);
        c.wall = int(from[1]);
        std::copy(from + 2, from + 5, c.n);
        std::copy(from + 5, from + 5 + maxHistory, c.history);
        from += contactNumbers;
    }
}

}


void System::Implementation::pack(const Member& m, std::vector<double>& to)
{
    const auto put = [&](const Vec3& v) { to.insert(to.end(), v.data(), v.data() + 3); };
    to.insert
    (
        to.end(),
        {
            double(m.p.id), double(m.p.material), m.p.radius, m.p.mass,
            m.half, double(m.owner), double(m.index), double(m.contacts.size()),
            m.gas.Sp, m.gas.SpOmega
        }
    );
    put(m.p.x);
    put(m.p.v);
    put(m.p.omega);
    put(m.gas.Uc);
    put(m.gas.Su);
    put(m.gas.omegaC);
    put(m.impulse);
    packRest(m.rest, m.contacts, to);
}


System::Implementation::Member System::Implementation::unpack(const double*& from)
{
    const auto get = [&] { const Vec3 v(from[0], from[1], from[2]); from += 3; return v; };
    Member m;
    m.p.id = std::int64_t(from[0]);
    m.p.material = int(from[1]);
    m.p.radius = from[2];
    m.p.mass = from[3];
    m.half = from[4];
    m.owner = int(from[5]);
    m.index = std::size_t(from[6]);
    const std::size_t nContacts = std::size_t(from[7]);
    m.gas.Sp = from[8];
    m.gas.SpOmega = from[9];
    from += 10;
    m.p.x = get();
    m.p.v = get();
    m.p.omega = get();
    m.gas.Uc = get();
    m.gas.Su = get();
    m.gas.omegaC = get();
    m.impulse = get();
    unpackRest(from, nContacts, m.rest, m.contacts);
    from += restNumbers + nContacts*contactNumbers;
    return m;
}


// * * * * * * * * * * * * * * * * Who can meet whom * * * * * * * * * * * * * * * * * * //

//- Components of particles that can meet; `sets` says which of this rank belong together
System::Implementation::Labels System::Implementation::label
(
    DisjointSets& sets, const std::vector<Box>& boxes, const std::vector<Path>& paths,
    double dt
) const
{
    const std::size_t n = particles.size();
    struct Component
    {
        std::int64_t id;
        double speed = 0;
        bool active = false;
        bool shared = false;
        int home;
        std::int64_t unit;      // particle or rigid aggregate; -1 = several
        bool deviates = false;
        std::size_t count = 0;
    };
    std::vector<Component> components(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        Component& c = components[sets.find(i)];
        const std::int64_t unit = flies(i) ? rest[i].aggregate : particles[i].id;
        if (!c.count)
        {
            c.id = particles[i].id;
            c.home = communicator.rank();
            c.unit = unit;
        }
        if (c.unit != unit) c.unit = -1;
        c.deviates = c.deviates || paths[i].deviates;
        c.id = std::min(c.id, particles[i].id);
        c.speed = std::max(c.speed, paths[i].speed);
        c.active = c.active || awake(i);
        ++c.count;
    }

    if (communicator.parallel())
    {
        // Particles that reach into the box of another rank's particles are shown to all;
        // everybody joins the same components in the same way.
        std::vector<double> mine;
        if (n)
        {
            Box all = boxes[0];
            for (const Box& b : boxes) all.include(b);
            mine.insert(mine.end(), all.low.data(), all.low.data() + 3);
            mine.insert(mine.end(), all.high.data(), all.high.data() + 3);
        }
        const auto domains = communicator.allGather(mine);

        std::vector<double> shown;
        for (std::size_t i = 0; i < n; ++i)
        {
            bool out = false;
            for (int r = 0; r < communicator.size() && !out; ++r)
            {
                const auto& d = domains[std::size_t(r)];
                if (r == communicator.rank() || d.empty()) continue;
                out = boxes[i].overlaps({{d[0], d[1], d[2]}, {d[3], d[4], d[5]}});
            }
            if (!out) continue;
            const Component& c = components[sets.find(i)];
            shown.insert
            (
                shown.end(), boxes[i].low.data(), boxes[i].low.data() + 3
            );
            shown.insert
            (
                shown.end(), boxes[i].high.data(), boxes[i].high.data() + 3
            );
            const Path& p = paths[i];
            shown.insert
            (
                shown.end(),
                {
                    double(c.id), c.speed, double(c.active), double(p.deviates),
                    p.size, p.bend, p.x[0], p.x[1], p.x[2], p.v[0], p.v[1], p.v[2],
                    double(c.unit), double(c.deviates)
                }
            );
        }
        const auto everybody = communicator.allGather(shown);

        constexpr std::size_t numbers = 20;
        std::vector<Box> all;
        std::vector<Path> allPaths;
        std::vector<std::int64_t> ids;
        std::map<std::int64_t, Component> joined;
        std::vector<int> ranks;
        for (int r = 0; r < communicator.size(); ++r)
        {
            const auto& s = everybody[std::size_t(r)];
            for (std::size_t k = 0; k + numbers <= s.size(); k += numbers)
            {
                all.push_back({{s[k], s[k+1], s[k+2]}, {s[k+3], s[k+4], s[k+5]}});
                allPaths.push_back
                ({
                    {s[k+12], s[k+13], s[k+14]}, {s[k+15], s[k+16], s[k+17]},
                    s[k+10], s[k+11], 0, s[k+9] > 0, 0
                });
                const std::int64_t id = std::int64_t(s[k+6]);
                ids.push_back(id);
                ranks.push_back(r);
                Component& c = joined[id];
                c.id = id;
                c.speed = s[k+7];
                c.active = s[k+8] > 0;
                c.unit = std::int64_t(s[k+18]);
                c.deviates = s[k+19] > 0;
                c.home = r;
            }
        }

        std::map<std::int64_t, std::int64_t> parent;
        const auto root = [&](std::int64_t id)
        {
            for (auto p = parent.find(id); p != parent.end(); p = parent.find(id))
            {
                id = p->second;
            }
            return id;
        };
        BoxGrid(all).pairs
        (
            [&](int i, int j)
            {
                if (ranks[std::size_t(i)] == ranks[std::size_t(j)]) return;
                if (!meet(allPaths[std::size_t(i)], allPaths[std::size_t(j)], dt)) return;
                const std::int64_t a = root(ids[std::size_t(i)]);
                const std::int64_t b = root(ids[std::size_t(j)]);
                if (a == b) return;
                const std::int64_t low = std::min(a, b), high = std::max(a, b);
                parent[high] = low;
                Component& to = joined[low];
                const Component& from = joined[high];
                to.speed = std::max(to.speed, from.speed);
                to.active = to.active || from.active;
                to.deviates = to.deviates || from.deviates;
                if (to.unit != from.unit) to.unit = -1;
                to.shared = true;
            }
        );

        for (Component& c : components)
        {
            if (!c.count) continue;
            const auto found = joined.find(root(c.id));
            if (found == joined.end() || !found->second.shared) continue;
            const std::size_t count = c.count;
            c = found->second;
            c.count = count;
        }
    }

    Labels labels;
    labels.component.resize(n);
    labels.speed.resize(n);
    labels.active.resize(n);
    labels.shared.resize(n);
    labels.alone.resize(n);
    labels.home.resize(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        const Component& c = components[sets.find(i)];
        labels.component[i] = c.id;
        labels.speed[i] = c.speed;
        labels.active[i] = c.active;
        labels.shared[i] = c.shared;
        labels.alone[i] = c.unit >= 0 && !c.deviates;
        labels.home[i] = c.home;
    }
    return labels;
}


//- Move the members as one body, if that is what they are; impulses from the gas included
bool System::Implementation::flyTogether
(
    std::vector<Member>& members, double dt, StepReport& report
)
{
    const RestState& first = members[0].rest;
    if (first.aggregate < 0 || first.members != int(members.size())) return false;
    std::vector<Particle> flyers;
    std::vector<GasLoad> loads;
    for (const Member& m : members)
    {
        // pushed by others, or met by walls
        if (m.rest.aggregate != first.aggregate || m.half > 0) return false;
        flyers.push_back(m.p);
        loads.push_back(m.gas);
    }
    RigidAggregate body(flyers, loads, periodic);
    for (std::size_t k = 0; k < members.size(); ++k)
    {
        const RestState& r = members[k].rest;
        const Vec3 change = body.contactForce(k) - Vec3(r.force[0], r.force[1], r.force[2]);
        if (r.wakeForce < 0 || change.norm() > r.wakeForce) return false;
    }

    std::vector<Vec3> impulses;
    const Eigen::Matrix3d turn = body.fly(dt, impulses);
    for (std::size_t k = 0; k < members.size(); ++k)
    {
        Member& m = members[k];
        m.p = flyers[k];
        m.impulse = impulses[k];
        Eigen::Map<Vec3> force(m.rest.force);
        force = turn*Vec3(force);
        Eigen::Map<Vec3> arm(m.rest.arm);
        arm = turn*Vec3(arm);
        for (ContactRecord& c : m.contacts)
        {
            const auto partner = std::find_if
            (
                members.begin(), members.end(),
                [&](const Member& o) { return o.p.id == c.idJ; }
            );
            if (partner == members.end()) continue;
            materials.laws()
            [
                std::size_t(materials.lawIndex(m.p.material, partner->p.material))
            ]->turnHistory(turn, c.history);
        }
    }
    ++report.aggregateFlights;
    return true;
}


//- Move one island; members in order of id
void System::Implementation::integrate
(
    std::vector<Member>& members, double dt, StepReport& report
)
{
    IslandIntegrator& island = *integrator;
    island.clear();

    std::vector<int> surfaces;
    std::unordered_map<std::int64_t, int> local;
    for (const Member& m : members)
    {
        const double half =
            m.p.radius + materials.reach(m.p.material, m.p.radius) + m.half;
        walls.query(m.p.x.array() - half, m.p.x.array() + half, surfaces);
        local.emplace(m.p.id, int(local.size()));
        RestState state = m.rest;
        if (state.aggregate >= 0)
        {
            // others may meet it, or its load has changed: no body of its own any more
            state.resting = false;
            state.aggregate = -1;
            ++report.wakes;
        }
        island.addParticle(m.p, m.gas, state, m.half);
        island.addSurfaces(surfaces);
    }

    for (std::size_t i = 0; i < members.size(); ++i)
    {
        for (const ContactRecord& c : members[i].contacts)
        {
            int j = -1;
            if (c.wall < 0)
            {
                // the partner has left the system: the contact has gone with it
                const auto found = local.find(c.idJ);
                if (found == local.end()) continue;
                j = found->second;
            }
            island.addContact(int(i), j, c);
        }
    }

    island.run(dt, now, report);
    ++report.islands;

    for (std::size_t i = 0; i < members.size(); ++i)
    {
        Member& m = members[i];
        m.p = island.particle(int(i));
        m.rest = island.rest(int(i));
        m.impulse = island.gasImpulse(int(i));
        m.contacts = island.contacts(int(i));
        m.half = std::max(m.half, island.farthest(int(i)));
    }
}


StepReport System::Implementation::advance(double dt)
{
    StepReport report;
    Clock::time_point clock = Clock::now();
    const std::size_t n = particles.size();
    tried.clear();      // an earlier step may have ended in an error
    bool active = false;
    for (std::size_t i = 0; i < n && !active; ++i) active = awake(i);
    if (!communicator.any(active))
    {
        std::fill(impulse.begin(), impulse.end(), Vec3::Zero());
        finish(dt, report);
        return report;
    }

    std::vector<Path> paths(n);
    std::vector<Box> boxes(n);
    std::vector<int> surfaces;
    for (std::size_t i = 0; i < n; ++i)
    {
        impulse[i] = Vec3::Zero();
        paths[i] = path(i, dt);
        boxes[i] = box(i, paths[i], dt);
        if (awake(i) && !paths[i].deviates)
        {
            walls.query(boxes[i].low, boxes[i].high, surfaces);
            paths[i].deviates = !surfaces.empty();
            if (paths[i].deviates) boxes[i] = box(i, paths[i], dt);
        }
    }
    if (!time.islands) return advanceTogether(dt, paths, report);

    // First by the paths that all have on their own; then whoever can be hit may become as
    // fast as the fastest of its component, and hit others, until nobody is added
    const BoxGrid grid(boxes, periodic);
    DisjointSets sets(n);
    const auto join = [&](int i, int j)
    {
        const std::size_t a = std::size_t(i), b = std::size_t(j);
        if (meet(paths[a], paths[b], dt)) sets.join(a, b);
    };
    grid.pairs(join);
    Labels labels;
    std::vector<std::size_t> widened, others;
    double widest = 0;
    for (const Box& b : boxes) widest = std::max(widest, 0.5*(b.high - b.low).maxCoeff());
    for (;;)
    {
        labels = label(sets, boxes, paths, dt);
        widened.clear();
        for (std::size_t i = 0; i < n; ++i)
        {
            Path& p = paths[i];
            if (!labels.active[i] || labels.alone[i]) continue;
            const double half = halfWidth(i, labels.speed[i], dt);
            if (p.deviates && p.half >= half) continue;
            p.deviates = true;
            p.half = std::max(p.half, half);
            boxes[i] = box(i, p, dt);
            widest = std::max(widest, p.size + p.half);
            widened.push_back(i);
        }
        if (!communicator.any(!widened.empty()))
        {
            if (move(labels, paths, dt, report, clock)) return report;
            continue;
        }
        // every pair that is not together yet has a partner outside the largest component
        const std::size_t largest = sets.largest();
        others.clear();
        for (std::size_t i = 0; i < n; ++i)
        {
            if (sets.find(i) != largest) others.push_back(i);
        }
        for (const std::size_t i : widened.size() < others.size() ? widened : others)
        {
            grid.overlapping(boxes[i], widest, [&](int j) { join(int(i), j); });
        }
    }
}


//- Everything in one island with the step of the stiffest possible contact: what a
//  conventional DEM code does. On the rank of the lowest id.
StepReport System::Implementation::advanceTogether
(
    double dt, std::vector<Path>& paths, StepReport& report
)
{
    Clock::time_point clock = Clock::now();
    const std::size_t n = particles.size();
    if (!communicator.any(n > 0))
    {
        now += dt;
        return report;
    }
    double lowest = 1e300;
    for (const Particle& p : particles) lowest = std::min(lowest, double(p.id));
    const double first = -communicator.max(-lowest);
    const double home = communicator.max(first == lowest ? communicator.rank() : -1);

    Labels labels;
    labels.component.assign(n, std::int64_t(first));
    labels.active.assign(n, 1);
    labels.shared.assign(n, communicator.parallel());
    labels.alone.assign(n, 0);
    labels.home.assign(n, int(home));
    do
    {
        double fastest = 0;
        for (const Path& p : paths) fastest = std::max(fastest, p.speed);
        fastest = communicator.max(fastest);
        for (std::size_t i = 0; i < n; ++i)
        {
            paths[i].deviates = true;
            paths[i].half = halfWidth(i, fastest, dt);
        }
    }
    while (!move(labels, paths, dt, report, clock));
    return report;
}


//- Move everything, components as labelled. Particles that contacts have made so fast that
//  they have left the box they were searched in may have missed others: false then, with
//  their paths as fast as that and nothing moved; what holds good for the next try is kept
bool System::Implementation::move
(
    const Labels& labels, std::vector<Path>& paths, double dt,
    StepReport& report, Clock::time_point& clock
)
{
    const std::size_t n = particles.size();
    const int rank = communicator.rank();

    // Sort out: closed-form flight, islands of this rank, islands moved elsewhere
    std::vector<std::size_t> flights;
    std::map<std::int64_t, Island> islands;
    std::vector<std::vector<double>> away(std::size_t(communicator.size()));
    for (std::size_t i = 0; i < n; ++i)
    {
        if (!labels.active[i]) continue;
        if (labels.alone[i] && !flies(i))
        {
            flights.push_back(i);
            continue;
        }
        if (labels.shared[i] && labels.home[i] != rank)
        {
            std::vector<double>& to = away[std::size_t(labels.home[i])];
            to.push_back(double(labels.component[i]));
            pack(member(i, paths[i].half), to);
        }
        else
        {
            islands[labels.component[i]].members.push_back(member(i, paths[i].half));
        }
    }
    for (const auto& from : communicator.exchange(away))
    {
        const double* p = from.data();
        const double* const end = p + from.size();
        while (communicator.parallel() && p < end)
        {
            const std::int64_t component = std::int64_t(*p++);
            islands[component].members.push_back(unpack(p));
        }
    }
    report.secondsSearch += since(clock);

    StepReport moved;
    std::vector<std::vector<double>> back(std::size_t(communicator.size()));
    for (auto& entry : islands)
    {
        Island& island = entry.second;
        std::vector<Member>& members = island.members;
        std::sort
        (
            members.begin(), members.end(),
            [](const Member& a, const Member& b) { return a.p.id < b.p.id; }
        );
        const auto before = tried.find(entry.first);
        if (before != tried.end() && before->second.holdsFor(members))
        {
            std::swap(island, before->second);
        }
        else
        {
            std::vector<double> halves;
            for (const Member& m : members) halves.push_back(m.half);
            if (!flyTogether(members, dt, island.report)) integrate(members, dt, island.report);
            for (std::size_t k = 0; k < members.size(); ++k)
            {
                island.outran = island.outran || members[k].half > halves[k];
            }
        }
        moved.add(island.report);
        for (const Member& m : members)
        {
            if (m.owner != rank) pack(m, back[std::size_t(m.owner)]);
        }
    }
    report.secondsContact += since(clock);

    // with those moved elsewhere, as an island of no id
    std::vector<Member>& elsewhere = islands[-1].members;
    for (const auto& from : communicator.exchange(back))
    {
        const double* p = from.data();
        const double* const end = p + from.size();
        while (communicator.parallel() && p < end) elsewhere.push_back(unpack(p));
    }
    bool outran = false;
    for (const auto& entry : islands)
    {
        for (const Member& m : entry.second.members)
        {
            if (m.owner != rank || m.half <= paths[m.index].half) continue;
            Path& p = paths[m.index];
            p.deviates = outran = true;
            p.speed = std::max(p.speed, m.half/dt);
        }
    }
    if (communicator.any(outran))
    {
        islands.erase(-1);
        tried.swap(islands);
        report.repeats += communicator.rank() == 0;
        report.secondsSearch += since(clock);
        return false;
    }
    tried.clear();
    for (const auto& entry : islands)
    {
        for (const Member& m : entry.second.members) if (m.owner == rank) takeBack(m);
    }
    report.add(moved);
    report.secondsSearch += since(clock);

    for (const std::size_t i : flights)
    {
        const double before = time.energyLedger ? particles[i].kineticEnergy() : 0;
        impulse[i] = fly(particles[i], gas[i], dt);
        if (time.energyLedger)
        {
            const double work = particles[i].kineticEnergy() - before;
            report.energy.kinetic += work;
            report.energy.gas += work;
        }
        rest[i].inContact = false;
        ++report.freeFlights;
    }
    report.secondsFlight += since(clock);

    finish(dt, report);
    report.secondsSearch += since(clock);
    return true;
}


//- The end of a particle step
void System::Implementation::finish(double dt, StepReport& report)
{
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        if (periodic.on()) particles[i].x = periodic.wrapped(particles[i].x);
        report.resting += rest[i].resting && !flies(i);
        report.flyingAtRest += flies(i);
        report.inContact += rest[i].inContact;
    }
    now += dt;
}


std::unordered_map<std::int64_t, Particle>
System::Implementation::remotePartners() const
{
    std::unordered_map<std::int64_t, Particle> result;
    if (!communicator.parallel()) return result;

    std::vector<double> wanted;
    for (const auto& list : contacts)
    {
        for (const ContactRecord& c : list)
        {
            if (c.wall < 0 && !indexOf.count(c.idJ)) wanted.push_back(double(c.idJ));
        }
    }
    const auto asked = communicator.allGather(wanted);
    std::vector<std::vector<double>> answers(std::size_t(communicator.size()));
    for (int r = 0; r < communicator.size(); ++r)
    {
        for (const double id : asked[std::size_t(r)])
        {
            const auto found = indexOf.find(std::int64_t(id));
            if (found == indexOf.end()) continue;
            pack(member(found->second, 0), answers[std::size_t(r)]);
        }
    }
    for (const auto& from : communicator.exchange(answers))
    {
        const double* p = from.data();
        const double* const end = p + from.size();
        while (p < end)
        {
            const Member m = unpack(p);
            result.emplace(m.p.id, m.p);
        }
    }
    return result;
}


// * * * * * * * * * * * * * * * * * * System * * * * * * * * * * * * * * * * * * * * * * //

System::System
(
    MaterialTable materials, const TimeSettings& time, Communicator communicator
)
:
    impl_(std::make_unique<Implementation>(std::move(materials), time, communicator))
{}


System::~System() = default;


const MaterialTable& System::materials() const { return impl_->materials; }
const TimeSettings& System::timeSettings() const { return impl_->time; }


void System::setWalls(Walls walls)
{
    for (const WallPatch& p : walls.patches)
    {
        if (p.material < 0 || p.material >= int(materials().materials().size()))
        {
            throw inputError
            (
                "walls", "material " + std::to_string(p.material) + " of " + p.name,
                "an index into the materials"
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


std::size_t System::size() const { return impl_->particles.size(); }


std::size_t System::add(const Particle& p)
{
    const std::string name = "particle " + std::to_string(p.id);
    if (!(p.radius > 0 && std::isfinite(p.radius)))
    {
        throw inputError
        (
            "diameter", name + " has " + std::to_string(2*p.radius) + " m",
            "a positive number"
        );
    }
    if (!(p.mass > 0 && std::isfinite(p.mass)))
    {
        throw inputError
        (
            "density", name + " has a mass of " + std::to_string(p.mass) + " kg",
            "a positive number"
        );
    }
    if (p.material < 0 || p.material >= int(materials().materials().size()))
    {
        throw inputError("material", name, "an index into the materials");
    }
    if (p.id < 0 || !impl_->indexOf.emplace(p.id, size()).second)
    {
        throw inputError("id", name + " is there already", "unique numbers, 0 or more");
    }
    if (!p.x.allFinite() || !p.v.allFinite() || !p.omega.allFinite())
    {
        impl_->indexOf.erase(p.id);
        throw inputError("position", name + " is not finite", "finite numbers");
    }

    impl_->particles.push_back(p);
    impl_->particles.back().x = impl_->periodic.wrapped(p.x);
    impl_->gas.emplace_back();
    impl_->rest.emplace_back();
    impl_->impulse.push_back(Vec3::Zero());
    impl_->reach.push_back(materials().reach(p.material, p.radius));
    impl_->contacts.emplace_back();
    return size() - 1;
}


void System::remove(const std::vector<char>& marked)
{
    Implementation& s = *impl_;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < s.particles.size(); ++i)
    {
        if (i < marked.size() && marked[i])
        {
            s.indexOf.erase(s.particles[i].id);
            continue;
        }
        if (kept != i)
        {
            s.particles[kept] = s.particles[i];
            s.gas[kept] = s.gas[i];
            s.rest[kept] = s.rest[i];
            s.impulse[kept] = s.impulse[i];
            s.reach[kept] = s.reach[i];
            s.contacts[kept] = std::move(s.contacts[i]);
            s.indexOf[s.particles[i].id] = kept;
        }
        ++kept;
    }
    s.particles.resize(kept);
    s.gas.resize(kept);
    s.rest.resize(kept);
    s.impulse.resize(kept);
    s.reach.resize(kept);
    s.contacts.resize(kept);
}


const Particle& System::particle(std::size_t i) const
{
    return impl_->particles[impl_->checked(i)];
}


void System::setMotion
(
    std::size_t i, const Vec3& x, const Vec3& v, const Vec3& omega
)
{
    Particle& p = impl_->particles[impl_->checked(i)];
    p.x = x;
    p.v = v;
    p.omega = omega;
    // an impossible wake force: the whole cluster wakes at the next step
    impl_->rest[i].wakeForce = -1;
    impl_->rest[i].quietTime = 0;
}


bool System::resting(std::size_t i) const
{
    return impl_->rest[impl_->checked(i)].resting && !impl_->flies(i);
}


bool System::inContact(std::size_t i) const
{
    return impl_->rest[impl_->checked(i)].inContact;
}


void System::setGasLoad(std::size_t i, const GasLoad& load)
{
    if
    (
        !(load.Sp >= 0 && load.SpOmega >= 0)
     || !std::isfinite(load.Sp) || !std::isfinite(load.SpOmega)
     || !load.Uc.allFinite() || !load.Su.allFinite() || !load.omegaC.allFinite()
    )
    {
        throw numericalError
        (
            "The gas force on particle "
          + std::to_string(impl_->particles[impl_->checked(i)].id)
          + " is not finite or its drag is negative, at time "
          + std::to_string(impl_->now) + " s"
        );
    }
    impl_->gas[impl_->checked(i)] = load;
}


StepReport System::advance(double dt)
{
    if (!(dt > 0 && std::isfinite(dt)))
    {
        throw inputError("dt", "is " + std::to_string(dt), "a positive time [s]");
    }
    return impl_->advance(dt);
}


const Vec3& System::gasImpulse(std::size_t i) const
{
    return impl_->impulse[impl_->checked(i)];
}


double System::time() const { return impl_->now; }
void System::setTime(double time) { impl_->now = time; }


std::vector<ContactView> System::contacts() const
{
    const Implementation& s = *impl_;
    const auto remote = s.remotePartners();
    std::vector<ContactView> result;

    ContactList list;
    for (std::size_t i = 0; i < s.particles.size(); ++i)
    {
        for (const ContactRecord& c : s.contacts[i])
        {
            const Particle& p = s.particles[i];
            const bool wall = c.wall >= 0;
            Particle q = p;
            if (!wall)
            {
                const auto local = s.indexOf.find(c.idJ);
                const auto there = remote.find(c.idJ);
                if (local != s.indexOf.end()) q = s.particles[local->second];
                else if (there != remote.end()) q = there->second;
                else continue;      // its partner has left the system
            }
            const int mj =
                wall ? walls().patches[std::size_t(c.wall)].material : q.material;
            const PairConstants& pair = s.materials.constants(p.material, mj);
            const ContactLaw& law =
                *s.materials.laws()[std::size_t(s.materials.lawIndex(p.material, mj))];
            const double R =
                wall ? p.radius : p.radius*q.radius/(p.radius + q.radius);
            const double m = wall ? p.mass : p.mass*q.mass/(p.mass + q.mass);
            double constants[maxConstants];
            law.prepare
            (
                s.materials.pairInLaw(p.material, mj), {pair, R, m}, constants
            );

            // the kernels work on a copy of the history
            Body bodies[2] = {};
            Load loads[2] = {};
            for (int k = 0; k < 2; ++k)
            {
                const Particle& a = k ? q : p;
                for (int d = 0; d < 3; ++d)
                {
                    bodies[k].x[d] = a.x[d];
                    bodies[k].v[d] = a.v[d];
                    bodies[k].w[d] = a.omega[d];
                }
                bodies[k].r = a.radius;
            }
            list.setUp(law.nConstants(), law.nHistory(), wall);
            list.append(0, wall ? c.wall : 1, 0, constants, c.history);

            ContactView v;
            v.idI = p.id;
            v.idJ = wall ? -1 : q.id;
            v.wall = c.wall;
            if (wall)
            {
                v.normal = Vec3(c.n[0], c.n[1], c.n[2]);
                std::vector<WallHit> hits;
                std::vector<int> surfaces;
                const double range = p.radius + s.reach[i];
                s.walls.query
                (
                    p.x.array() - range, p.x.array() + range, surfaces
                );
                s.walls.hits(p.x, range*(1 + 1e-6), surfaces.data(), surfaces.size(), hits);
                double best = -2;
                v.overlap = 0;
                for (const WallHit& h : hits)
                {
                    const double alike = h.n.dot(v.normal);
                    if (h.patch == c.wall && alike > best)
                    {
                        best = alike;
                        v.overlap = p.radius - h.distance;
                    }
                }
                list.nx[0] = c.n[0];
                list.ny[0] = c.n[1];
                list.nz[0] = c.n[2];
                list.overlap[0] = v.overlap;
                law.evaluateWalls(list, 0, 1, bodies, loads, {}, 1);
            }
            else
            {
                const Vec3 d = s.periodic.nearest(q.x - p.x);
                v.normal = d.normalized();
                v.overlap = p.radius + q.radius - d.norm();
                law.evaluatePairs(list, 0, 1, bodies, loads, {}, 1, s.periodic);
            }
            v.point = p.x + (p.radius - 0.5*v.overlap)*v.normal;
            v.force = Vec3(loads[0].f[0], loads[0].f[1], loads[0].f[2]);
            double history[maxHistory];
            std::copy(c.history, c.history + maxHistory, history);
            const NormalResponse<double> normal =
                law.normalResponse(constants, v.overlap, history);
            v.contactRadius = normal.radius;
            v.pullOff =
                law.elastic()
              ? law.pullOff(s.materials.pairInLaw(p.material, mj), pair, R)
              : normal.pullOff;
            v.resting = s.rest[i].resting;
            result.push_back(v);
        }
    }
    return result;
}


std::vector<double> System::adhesionMargins() const
{
    const Implementation& s = *impl_;
    ClusterGraph graph;
    for (std::size_t i = 0; i < s.particles.size(); ++i)
    {
        if (!s.rest[i].inContact) continue;
        const GasLoad& g = s.gas[i];
        const Vec3 force = g.Sp*(g.Uc - s.particles[i].v) + g.Su;
        graph.nodes.push_back({s.particles[i].id, s.particles[i].mass, force});
    }
    for (const ContactView& c : contacts())
    {
        graph.bonds.push_back({c.idI, c.idJ, c.pullOff});
    }
    return clusterMargins(graph.gathered(s.communicator));
}


std::vector<ClusterLabel> System::clusters() const
{
    const Implementation& s = *impl_;
    ClusterGraph graph;
    for (std::size_t i = 0; i < s.particles.size(); ++i)
    {
        for (const ContactRecord& c : s.contacts[i])
        {
            graph.bonds.push_back({s.particles[i].id, c.wall >= 0 ? -1 : c.idJ, 0});
        }
    }
    const auto labels = clusterLabels(graph.everywhere(s.communicator));

    std::vector<ClusterLabel> result;
    for (const Particle& p : s.particles)
    {
        const auto found = labels.find(p.id);
        result.push_back
        (
            found == labels.end() ? ClusterLabel{p.id, false} : found->second
        );
    }
    return result;
}


double System::overlapAt(const Vec3& x, double radius, std::string& wallName) const
{
    const Implementation& s = *impl_;
    double largest = -1e300;
    wallName.clear();
    for (const Particle& p : s.particles)
    {
        largest = std::max
        (
            largest, radius + p.radius - s.periodic.nearest(p.x - x).norm()
        );
    }

    // far walls do not matter: three radii will do
    const double range = 3*radius;
    std::vector<int> surfaces;
    std::vector<WallHit> hits;
    s.walls.query(x.array() - range, x.array() + range, surfaces);
    s.walls.hits(x, range, surfaces.data(), surfaces.size(), hits);
    for (const WallHit& h : hits)
    {
        if (radius - h.distance > largest)
        {
            largest = radius - h.distance;
            wallName = walls().patchName(h.patch);
        }
    }
    return largest;
}


std::vector<double> System::packState(std::size_t i) const
{
    const Implementation& s = *impl_;
    std::vector<double> state;
    if (s.rest[s.checked(i)].inContact || !s.contacts[i].empty())
    {
        packRest(s.rest[i], s.contacts[i], state);
    }
    return state;
}


void System::unpackState(std::size_t i, const std::vector<double>& state)
{
    Implementation& s = *impl_;
    s.checked(i);
    if (state.empty()) return;
    if (state.size() < restNumbers || (state.size() - restNumbers)%contactNumbers)
    {
        throw inputError
        (
            "contact state",
            std::to_string(state.size()) + " numbers for particle "
          + std::to_string(s.particles[i].id),
            std::to_string(restNumbers) + " and " + std::to_string(contactNumbers)
          + " per contact"
        );
    }
    unpackRest
    (
        state.data(), (state.size() - restNumbers)/contactNumbers,
        s.rest[i], s.contacts[i]
    );
    for (const ContactRecord& c : s.contacts[i])
    {
        if (c.wall >= int(walls().patches.size()))
        {
            throw inputError
            (
                "contact state", "wall patch " + std::to_string(c.wall),
                "below " + std::to_string(walls().patches.size())
            );
        }
    }
}

}
