// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/System.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"
#include "contacts/ContactRecord.hpp"
#include "contacts/PackedState.hpp"
#include "contacts/clusterMargins.hpp"
#include "island/Island.hpp"
#include "neighbourSearch/BoxGrid.hpp"
#include "neighbourSearch/DisjointSets.hpp"
#include "particles/errors.hpp"
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

// Whoever can be pushed gets away from its own path, from then on when it can first be hit, or
// from the mean motion of all that it can meet, as far as the fastest of them and some more;
// small motions of what holds together are allowed for. Where that turns out not to be enough
// the particle step is repeated.
constexpr double speedMargin = 1.2;
constexpr double leastPath = 1e-3;      // [radii]

constexpr std::size_t contactNumbers = PackedState::contactNumbers;
constexpr std::size_t restNumbers = PackedState::restNumbers;

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
        integrator(std::make_unique<dem::Island>(materials, time, walls, periodic)),
        grid(boxes)
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
        bool pushed;        // off the path that it has on its own
        Corridor corridor;
        double outran;      // when moved: how fast it has left that [m/s]; 0: it has not
        int owner;
        std::size_t index;  // on its owner
        GasExchange exchange = {};
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
        Vec3 x = Vec3::Zero();
        double size = 0;            // radius and reach of its contacts [m]
        Corridor corridor;          // of its own, or where others can push it
        Vec3 own = Vec3::Zero();    // velocity it has on its own [m/s]
        double gain = 0;            // what can come to that on its own [m/s]
        double bend = 0;            // how far from the straight line it gets on its own [m]
        std::int64_t rigid = -1;    // rigid aggregate; -2 = at rest
        bool pushed = false;        // contacts can push it off the path it has on its own
        bool held = false;          // at rest, or a wall can push it
        bool joint = false;         // others can: its corridor allows for that
        double hit = 1e300;         // when they first can [s]
        double hitNext = 1e300;     // as found since
        double least = 0;           // speed that it has had in a try [m/s]
    };

    //- Of all that a particle can meet
    struct Label
    {
        std::int64_t component; // lowest id
        Vec3 velocity;          // mean; 0 where anything is held [m/s]
        double speed;           // fastest member's bound, beyond that [m/s]
        bool active;            // some member is awake
        bool shared;            // spans ranks
        bool alone;             // one particle or rigid aggregate that nothing pushes off its
                                // path
        int home;               // rank that moves it
    };

    Path path(std::size_t i, double dt) const
    {
        const Particle& p = particles[i];
        Path path;
        path.x = p.x;
        path.size = p.radius + reach[i];
        if (!awake(i))
        {
            path.corridor = {Vec3::Zero(), 0, 0, 0};
            path.rigid = -2;
            path.held = true;
            return path;
        }
        const GasLoad& g = gas[i];
        const Vec3 force = g.Sp*(g.Uc - p.v) + g.Su;
        if (flies(i))
        {
            // along with the centre of mass; the rest bends its path
            const Vec3 held(rest[i].force[0], rest[i].force[1], rest[i].force[2]);
            const Vec3 arm(rest[i].arm[0], rest[i].arm[1], rest[i].arm[2]);
            const Vec3 turning = p.omega.cross(arm);
            const double pull = ((force + held)/p.mass - p.omega.cross(turning)).norm();
            const double round = p.omega.norm()*arm.norm();
            path.rigid = rest[i].aggregate;
            path.own = p.v - turning;
            path.bend = std::min(2*arm.norm(), round*dt) + 0.5*pull*dt*dt + leastPath*p.radius;
            path.gain = round + pull*dt;
        }
        else
        {
            const FlightFactors f(g.Sp/p.mass, dt);
            const double pull = force.norm()/p.mass;
            path.own = p.v;
            path.bend = 0.5*pull*dt*dt;
            path.gain = pull*f.p1;
            path.pushed = rest[i].inContact || !contacts[i].empty();
            if (path.pushed) path.hit = path.hitNext = 0;
        }
        path.corridor = {path.own, path.bend, 0, 0};
        return path;
    }

    //- Where others can push particle i, whose component is labelled `of`: off its own path,
    //  from the time on when they first can, or anywhere about the mean motion
    Corridor pushedCorridor(std::size_t i, const Label& of, double dt) const
    {
        const Path& p = paths[i];
        const double least = leastPath*particles[i].radius;
        const double fastest = speedMargin*of.speed;
        const double beyond = (p.own - of.velocity).norm() + p.gain;
        const Corridor off{p.own, p.bend + least, p.hit, fastest + beyond};
        const Corridor about{of.velocity, least, 0, fastest};
        return off.width(dt) < about.width(dt) ? off : about;
    }

    //- Where a particle can get to
    Box box(std::size_t i, const Path& p, double dt) const
    {
        Box b;
        double around = p.size;
        if (p.joint || flies(i) || !awake(i))
        {
            const Vec3 end = p.x + dt*p.corridor.v;
            b = {p.x.cwiseMin(end), p.x.cwiseMax(end)};
            around += p.corridor.width(dt);
        }
        else flightBox(particles[i], gas[i], dt, b.low, b.high);
        return {b.low.array() - around, b.high.array() + around};
    }

    bool wallWithin(const Box& b) const
    {
        static thread_local std::vector<int> surfaces;
        walls.query(b.low, b.high, surfaces);
        return !surfaces.empty();
    }

    //- When two can first come as close as a contact, beyond dt if they cannot [s]
    double meetingTime(const Path& a, const Path& b, double dt) const
    {
        const Corridor &ca = a.corridor, &cb = b.corridor;
        Vec3 d = periodic.nearest(b.x - a.x);
        const Vec3 u = cb.v - ca.v;
        const double square = u.squaredNorm();
        const double nearest =
            square > 0 ? std::min(std::max(-d.dot(u)/square, 0.0), dt) : 0;
        const double sizes = a.size + b.size;
        const double most = sizes + ca.width(dt) + cb.width(dt);
        if ((d + nearest*u).squaredNorm() > most*most) return 1e300;

        // |d + u t| = R + k t between the times when they can be pushed
        const double times[4] =
        {
            0, std::min(std::min(ca.from, cb.from), dt), std::min(std::max(ca.from, cb.from), dt),
            dt
        };
        for (int piece = 0; piece < 3; ++piece)
        {
            const double start = times[piece], length = times[piece + 1] - start;
            const Vec3 apart = d + start*u;
            const double R = sizes + ca.width(start) + cb.width(start);
            const double C = apart.squaredNorm() - R*R;
            if (C <= 0) return std::max(start, together(a, b));
            const double k = (ca.from <= start ? ca.away : 0) + (cb.from <= start ? cb.away : 0);
            const double A = square - k*k, B = apart.dot(u) - R*k;
            const double root = B*B - A*C;
            const double q = root < 0 ? -1 : std::sqrt(root) - B;
            if (q > 0 && C <= q*length) return std::max(start + C/q, together(a, b));
        }
        return 1e300;
    }

    //- Two of one rigid body do not push each other before one of them is pushed
    static double together(const Path& a, const Path& b)
    {
        return a.rigid == b.rigid && a.rigid != -1 ? std::min(a.hit, b.hit) : 0;
    }

    //- Whether two whose boxes overlap can meet, or belong together; takes down when
    bool meet(Path& a, Path& b, double dt) const
    {
        const double time = meetingTime(a, b, dt);
        a.hitNext = std::min(a.hitNext, time);
        b.hitNext = std::min(b.hitNext, time);
        return time <= dt || (a.rigid >= 0 && a.rigid == b.rigid);
    }

    //- A member of a rigid aggregate
    bool flies(std::size_t i) const { return rest[i].aggregate >= 0; }

    bool awake(std::size_t i) const
    {
        return flies(i) || !rest[i].resting || wakes(rest[i], gas[i]);
    }

    void addToCrowd(std::size_t i);
    std::size_t label(DisjointSets& sets, double dt);
    bool flyTogether(std::vector<Member>& members, double dt, StepReport& report);
    void integrate(std::vector<Member>& members, double dt, StepReport& report);
    StepReport advance(double dt);
    StepReport advanceTogether(double dt, StepReport& report);
    bool move(double dt, StepReport& report, Clock::time_point& clock);
    void finish(double dt, StepReport& report);
    void exchangeAtRest(double dt);

    Member member(std::size_t i, const Path& p) const
    {
        return
        {
            particles[i], gas[i], rest[i], contacts[i], p.joint, p.corridor, 0,
            communicator.rank(), i, {}
        };
    }

    void takeBack(const Member& m)
    {
        particles[m.index] = m.p;
        rest[m.index] = m.rest;
        contacts[m.index] = m.contacts;
        exchange[m.index] = m.exchange;
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
    std::unique_ptr<dem::Island> integrator;
    std::map<std::int64_t, Island> tried;   // by component, from a try that was not enough

    // Of one particle step
    std::vector<Path> paths;
    std::vector<Box> boxes;
    BoxGrid grid;                       // of boxes
    std::vector<std::size_t> crowd;     // who can meet somebody, or is pushed
    std::vector<char> crowded;          // by particle: it is one of them
    std::vector<Label> labels;          // of the crowd

    std::vector<Particle> particles;
    std::vector<GasLoad> gas;
    std::vector<RestState> rest;
    std::vector<GasExchange> exchange;
    bool keepExchange = false;
    double kicked = 0;                  // work of kick() since the last advance() [J]
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
            double(m.pushed), m.outran, double(m.owner), double(m.index), double(m.contacts.size()),
            m.gas.Sp, m.gas.SpOmega, m.corridor.near, m.corridor.from, m.corridor.away,
            m.exchange.response, m.exchange.memory, double(m.exchange.held)
        }
    );
    put(m.p.x);
    put(m.p.v);
    put(m.p.omega);
    put(m.gas.Uc);
    put(m.gas.Su);
    put(m.gas.omegaC);
    put(m.exchange.impulse);
    put(m.corridor.v);
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
    m.pushed = from[4] > 0;
    m.outran = from[5];
    m.owner = int(from[6]);
    m.index = std::size_t(from[7]);
    const std::size_t nContacts = std::size_t(from[8]);
    m.gas.Sp = from[9];
    m.gas.SpOmega = from[10];
    m.corridor.near = from[11];
    m.corridor.from = from[12];
    m.corridor.away = from[13];
    m.exchange.response = from[14];
    m.exchange.memory = from[15];
    m.exchange.held = from[16] > 0;
    from += 17;
    m.p.x = get();
    m.p.v = get();
    m.p.omega = get();
    m.gas.Uc = get();
    m.gas.Su = get();
    m.gas.omegaC = get();
    m.exchange.impulse = get();
    m.corridor.v = get();
    unpackRest(from, nContacts, m.rest, m.contacts);
    from += restNumbers + nContacts*contactNumbers;
    return m;
}


// * * * * * * * * * * * * * * * * Who can meet whom * * * * * * * * * * * * * * * * * * //

void System::Implementation::addToCrowd(std::size_t i)
{
    if (crowded[i]) return;
    crowded[i] = 1;
    crowd.push_back(i);
}


//- Label the components of particles that can meet; `sets` says which of this rank belong
//  together. Returns how many are not in the largest of these sets.
std::size_t System::Implementation::label(DisjointSets& sets, double dt)
{
    const std::size_t n = particles.size();

    // Particles that reach into the box of another rank's particles are shown to all
    std::vector<std::size_t> shownOnes;
    if (communicator.parallel())
    {
        std::vector<double> mine;
        if (n)
        {
            Box all = boxes[0];
            for (const Box& b : boxes) all.include(b);
            mine.insert(mine.end(), all.low.data(), all.low.data() + 3);
            mine.insert(mine.end(), all.high.data(), all.high.data() + 3);
        }
        const auto domains = communicator.allGather(mine);
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
            shownOnes.push_back(i);
            addToCrowd(i);
        }
    }

    struct Component
    {
        std::int64_t id;
        double mass = 0;
        Vec3 momentum = Vec3::Zero();
        double speed = 0;
        bool active = false;
        bool shared = false;
        int home;
        std::int64_t unit;      // particle or rigid aggregate; -1 = several
        bool pushed = false;
        bool held = false;
        std::size_t count = 0;

        void add(const Component& other)
        {
            mass += other.mass;
            momentum += other.momentum;
            active = active || other.active;
            if (unit != other.unit) unit = -1;
            pushed = pushed || other.pushed;
            held = held || other.held;
        }

        Vec3 velocity() const { return held ? Vec3(Vec3::Zero()) : Vec3(momentum/mass); }
    };
    std::vector<Component> components;
    std::vector<std::size_t> componentOf(crowd.size());
    static thread_local std::vector<std::size_t> ofRoot;    // all 0 between calls
    ofRoot.resize(std::max(ofRoot.size(), n), 0);
    for (std::size_t k = 0; k < crowd.size(); ++k)
    {
        const std::size_t i = crowd[k];
        std::size_t& of = ofRoot[sets.find(i)];
        const std::int64_t unit = flies(i) ? rest[i].aggregate : particles[i].id;
        if (!of)
        {
            components.emplace_back();
            of = components.size();
            components.back().id = particles[i].id;
            components.back().home = communicator.rank();
            components.back().unit = unit;
        }
        componentOf[k] = of - 1;
        Component& c = components[of - 1];
        const Path& p = paths[i];
        const double mass = particles[i].mass;
        Component one;
        one.mass = mass;
        one.momentum = mass*p.own;
        one.active = awake(i);
        one.unit = unit;
        one.pushed = p.pushed;
        one.held = p.held;
        c.add(one);
        c.id = std::min(c.id, particles[i].id);
        ++c.count;
    }
    std::size_t largest = 1;
    for (const Component& c : components) largest = std::max(largest, c.count);
    std::vector<std::size_t> ofShown;
    for (const std::size_t i : shownOnes) ofShown.push_back(ofRoot[sets.find(i)] - 1);
    for (const std::size_t i : crowd) ofRoot[sets.find(i)] = 0;

    if (communicator.parallel())
    {
        // everybody joins the same components in the same way
        std::vector<double> shown;
        for (std::size_t m = 0; m < shownOnes.size(); ++m)
        {
            const std::size_t i = shownOnes[m];
            const Component& c = components[ofShown[m]];
            shown.insert
            (
                shown.end(), boxes[i].low.data(), boxes[i].low.data() + 3
            );
            shown.insert
            (
                shown.end(), boxes[i].high.data(), boxes[i].high.data() + 3
            );
            const Path& p = paths[i];
            const Vec3& v = p.corridor.v;
            shown.insert
            (
                shown.end(),
                {
                    p.x[0], p.x[1], p.x[2], v[0], v[1], v[2], p.corridor.near,
                    p.corridor.from, p.corridor.away, p.size, p.hit, double(p.rigid),
                    double(c.id), c.mass, c.momentum[0], c.momentum[1], c.momentum[2],
                    double(c.active), double(c.unit), double(c.pushed), double(c.held)
                }
            );
        }
        const auto everybody = communicator.allGather(shown);

        constexpr std::size_t numbers = 27;
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
                Path p;
                p.x = {s[k+6], s[k+7], s[k+8]};
                p.corridor = {{s[k+9], s[k+10], s[k+11]}, s[k+12], s[k+13], s[k+14]};
                p.size = s[k+15];
                p.hit = s[k+16];
                p.rigid = std::int64_t(s[k+17]);
                allPaths.push_back(p);
                const std::int64_t id = std::int64_t(s[k+18]);
                ids.push_back(id);
                ranks.push_back(r);
                Component& c = joined[id];
                c.id = id;
                c.mass = s[k+19];
                c.momentum = {s[k+20], s[k+21], s[k+22]};
                c.active = s[k+23] > 0;
                c.unit = std::int64_t(s[k+24]);
                c.pushed = s[k+25] > 0;
                c.held = s[k+26] > 0;
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
                to.add(from);
                to.shared = true;
            }
        );

        const std::size_t first = std::size_t
        (
            std::find(ranks.begin(), ranks.end(), communicator.rank()) - ranks.begin()
        );
        for (std::size_t m = 0; m < shownOnes.size(); ++m)
        {
            double& hit = paths[shownOnes[m]].hitNext;
            hit = std::min(hit, allPaths[first + m].hitNext);
        }
        for (Component& c : components)
        {
            const auto found = joined.find(root(c.id));
            if (found != joined.end() && found->second.shared) c = found->second;
        }
    }

    // how fast they are beyond the velocity of their component
    for (std::size_t k = 0; k < crowd.size(); ++k)
    {
        const std::size_t i = crowd[k];
        Component& c = components[componentOf[k]];
        const Path& p = paths[i];
        // contacts can turn spin into speed
        const double beyond = std::sqrt
        (
            (p.own - c.velocity()).squaredNorm()
          + 0.4*particles[i].omega.squaredNorm()*particles[i].radius*particles[i].radius
        );
        c.speed = std::max(c.speed, beyond + std::max(p.gain, p.least));
    }
    if (communicator.parallel())
    {
        std::map<std::int64_t, double> fastest;
        std::vector<double> mine;
        for (const Component& c : components)
        {
            if (c.shared) mine.insert(mine.end(), {double(c.id), c.speed});
        }
        for (const auto& from : communicator.allGather(mine))
        {
            for (std::size_t k = 0; k < from.size(); k += 2)
            {
                double& speed = fastest[std::int64_t(from[k])];
                speed = std::max(speed, from[k + 1]);
            }
        }
        for (Component& c : components) if (c.shared) c.speed = fastest[c.id];
    }

    labels.resize(crowd.size());
    for (std::size_t k = 0; k < crowd.size(); ++k)
    {
        const Component& c = components[componentOf[k]];
        labels[k] =
        {
            c.id, c.velocity(), c.speed, c.active, c.shared, c.unit >= 0 && !c.pushed, c.home
        };
    }
    return n - std::min(n, largest);
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
        if (m.rest.aggregate != first.aggregate || m.pushed) return false;
        flyers.push_back(m.p);
        loads.push_back(m.gas);
    }
    RigidAggregate body(flyers, loads, periodic);
    for (std::size_t k = 0; k < members.size(); ++k)
    {
        const RestState& r = members[k].rest;
        const Vec3 force = body.contactForce(k);
        const double change = (force - Vec3(r.force[0], r.force[1], r.force[2])).norm();
        if (r.wakeForce < 0) return false;
        if (change <= r.wakeForce) continue;
        // Of many contacts a force may be the moment of one. A pair has one, whose force and
        // moment are known.
        if (members.size() > 2) return false;
        const double radius = flyers[k].radius;
        const Vec3 n = periodic.nearest(flyers[1 - k].x - flyers[k].x).normalized();
        const Vec3 moment = body.contactTorque(k) - radius*n.cross(force);
        if
        (
            change > time.restTolerance*wakeForceChange*r.pullOff
         || moment.norm() > r.wakeForce*radius
        ) return false;
    }

    std::vector<Vec3> impulses;
    const Eigen::Matrix3d turn = body.fly(dt, impulses);
    const FlightFactors flight = body.flight(dt);
    for (std::size_t k = 0; k < members.size(); ++k)
    {
        Member& m = members[k];
        m.p = flyers[k];
        m.exchange = {impulses[k], m.gas.Sp*flight.p1, flight.e, false};
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
    dem::Island& island = *integrator;
    island.clear();

    std::vector<int> surfaces;
    std::unordered_map<std::int64_t, int> local;
    for (const Member& m : members)
    {
        const double half =
            m.p.radius + materials.reach(m.p.material, m.p.radius, walls.walls())
          + m.corridor.width(dt);
        const Vec3 end = m.p.x + dt*m.corridor.v;
        walls.query
        (
            m.p.x.cwiseMin(end).array() - half, m.p.x.cwiseMax(end).array() + half, surfaces
        );
        local.emplace(m.p.id, int(local.size()));
        RestState state = m.rest;
        if (state.aggregate >= 0)
        {
            // others may meet it, or its load has changed: no body of its own any more
            state.resting = false;
            state.aggregate = -1;
            ++report.wakes;
        }
        island.addParticle(m.p, m.gas, state, m.corridor);
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

    std::vector<GasExchange> exchanges;
    if (keepExchange) exchanges = island.gasExchange(dt);
    for (std::size_t i = 0; i < members.size(); ++i)
    {
        Member& m = members[i];
        m.p = island.particle(int(i));
        m.rest = island.rest(int(i));
        if (keepExchange) m.exchange = exchanges[i];
        m.contacts = island.contacts(int(i));
        m.outran = island.outran(int(i));
    }
}


StepReport System::Implementation::advance(double dt)
{
    StepReport report;
    Clock::time_point clock = Clock::now();
    const std::size_t n = particles.size();
    tried.clear();      // an earlier step may have ended in an error
    report.energy.kinetic += kicked;
    report.energy.gas += kicked;
    kicked = 0;
    bool active = false;
    for (std::size_t i = 0; i < n && !active; ++i) active = awake(i);
    if (keepExchange) exchangeAtRest(dt);
    if (!communicator.any(active))
    {
        finish(dt, report);
        return report;
    }

    paths.resize(n);
    boxes.resize(n);
    crowd.clear();
    crowded.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
        Path& p = paths[i] = path(i, dt);
        boxes[i] = box(i, p, dt);
        if (!awake(i)) continue;
        p.held = wallWithin(boxes[i]);
        if (p.held)
        {
            p.pushed = true;
            p.hit = p.hitNext = 0;
        }
    }
    if (!time.islands) return advanceTogether(dt, report);

    // First by the paths that all have on their own; then whoever can be pushed may become as
    // fast as the fastest of its component, and hit others, until nobody is added
    grid.build(periodic);
    DisjointSets sets(n);
    // nothing new can come of them
    const auto known = [&](std::size_t i, std::size_t j)
    {
        return i == j || (paths[i].hit == 0 && paths[j].hit == 0 && sets.together(i, j));
    };
    grid.pairs([&](int i, int j)
    {
        const std::size_t a = std::size_t(i), b = std::size_t(j);
        if (known(a, b) || !meet(paths[a], paths[b], dt)) return;
        sets.join(a, b);
        crowded[a] = crowded[b] = 1;
    });
    for (std::size_t i = 0; i < n; ++i)
    {
        crowded[i] = crowded[i] || paths[i].pushed || flies(i);
        if (crowded[i]) crowd.push_back(i);
    }
    std::vector<std::size_t> widened, asked;
    for (;;)
    {
        const std::size_t outside = label(sets, dt);
        widened.clear();
        for (std::size_t k = 0; k < crowd.size(); ++k)
        {
            const std::size_t i = crowd[k];
            const Label& of = labels[k];
            Path& p = paths[i];
            // in few stages, so that it ends soon
            if (p.hitNext <= dt) p.hit = std::min(p.hit, std::floor(32*p.hitNext/dt)*dt/32);
            if (!of.active || of.alone) continue;
            const Corridor wider = pushedCorridor(i, of, dt);
            const Corridor& c = p.corridor;
            if
            (
                p.joint && c.v == wider.v && c.near >= wider.near && c.from <= wider.from
             && c.away >= wider.away
            ) continue;
            p.joint = true;
            p.corridor = wider;
            boxes[i] = box(i, p, dt);
            grid.changed(int(i));
            p.held = p.held || wallWithin(boxes[i]);
            widened.push_back(i);
        }
        if (!communicator.any(!widened.empty()))
        {
            if (move(dt, report, clock)) return report;
            continue;
        }
        // of every pair that is news, one partner is widened, and one is outside the largest
        // set or can be pushed earlier
        asked.swap(widened);
        if (outside < asked.size())
        {
            std::vector<std::size_t> count(n), others;
            for (std::size_t i = 0; i < n; ++i) ++count[sets.find(i)];
            const std::size_t largest =
                std::size_t(std::max_element(count.begin(), count.end()) - count.begin());
            for (std::size_t i = 0; i < n && others.size() < asked.size(); ++i)
            {
                if (sets.find(i) != largest || paths[i].hit > 0) others.push_back(i);
            }
            if (others.size() < asked.size()) asked.swap(others);
        }
        for (const std::size_t i : asked)
        {
            grid.overlapping(boxes[i], [&](int other)
            {
                const std::size_t j = std::size_t(other);
                if (known(i, j) || !meet(paths[i], paths[j], dt)) return;
                sets.join(i, j);
                addToCrowd(i);
                addToCrowd(j);
            });
        }
    }
}


//- Everything in one island with the step of the stiffest possible contact: what a
//  conventional DEM code does. On the rank of the lowest id.
StepReport System::Implementation::advanceTogether(double dt, StepReport& report)
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

    for (std::size_t i = 0; i < n; ++i) addToCrowd(i);
    labels.assign
    (
        n,
        {
            std::int64_t(first), Vec3::Zero(), 0, true, communicator.parallel(), false,
            int(home)
        }
    );
    do
    {
        double fastest = 0;
        for (const Path& p : paths)
        {
            fastest = std::max(fastest, p.own.norm() + std::max(p.gain, p.least));
        }
        fastest = communicator.max(fastest);
        for (std::size_t i = 0; i < n; ++i)
        {
            paths[i].joint = true;
            paths[i].corridor =
                {Vec3::Zero(), leastPath*particles[i].radius, 0, speedMargin*fastest};
        }
    }
    while (!move(dt, report, clock));
    return report;
}


//- Move everything, components as labelled. Particles that contacts have made so fast that
//  they have left the box they were searched in may have missed others: false then, with
//  their paths as fast as that and nothing moved; what holds good for the next try is kept
bool System::Implementation::move(double dt, StepReport& report, Clock::time_point& clock)
{
    const std::size_t n = particles.size();
    const int rank = communicator.rank();

    // Sort out: closed-form flight, islands of this rank, islands moved elsewhere
    std::vector<std::size_t> flights;
    std::map<std::int64_t, Island> islands;
    std::vector<std::vector<double>> away(std::size_t(communicator.size()));
    for (std::size_t i = 0; i < n; ++i)
    {
        if (!crowded[i] && awake(i)) flights.push_back(i);
    }
    for (std::size_t k = 0; k < crowd.size(); ++k)
    {
        const std::size_t i = crowd[k];
        const Label& of = labels[k];
        if (!of.active) continue;
        if (of.alone && !flies(i)) flights.push_back(i);
        else if (of.shared && of.home != rank)
        {
            std::vector<double>& to = away[std::size_t(of.home)];
            to.push_back(double(of.component));
            pack(member(i, paths[i]), to);
        }
        else islands[of.component].members.push_back(member(i, paths[i]));
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
            if (!flyTogether(members, dt, island.report)) integrate(members, dt, island.report);
            for (const Member& m : members) island.outran = island.outran || m.outran > 0;
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
            if (m.owner != rank || m.outran <= 0) continue;
            Path& p = paths[m.index];
            p.pushed = outran = true;
            p.hit = p.hitNext = 0;
            p.least = std::max(p.least, m.outran + (p.corridor.v - p.own).norm());
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
        const Vec3 impulse = fly(particles[i], gas[i], dt);
        if (keepExchange)
        {
            const FlightFactors f(gas[i].Sp/particles[i].mass, dt);
            exchange[i] = {impulse, gas[i].Sp*f.p1, f.e, false};
        }
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


//- What the gas gives to those at rest, whom nothing else may look at in this particle step
void System::Implementation::exchangeAtRest(double dt)
{
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        if (awake(i)) continue;
        const GasLoad& g = gas[i];
        exchange[i] = {dt*(g.Sp*g.Uc + g.Su), dt*g.Sp, 1, true};
    }
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
            pack(member(found->second, Path()), answers[std::size_t(r)]);
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
    checkCurvature(walls(), p.radius, p.id);
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
    impl_->exchange.emplace_back();
    impl_->reach.push_back(materials().reach(p.material, p.radius, walls()));
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
            s.exchange[kept] = s.exchange[i];
            s.reach[kept] = s.reach[i];
            s.contacts[kept] = std::move(s.contacts[i]);
            s.indexOf[s.particles[i].id] = kept;
        }
        ++kept;
    }
    s.particles.resize(kept);
    s.gas.resize(kept);
    s.rest.resize(kept);
    s.exchange.resize(kept);
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


Vec3 System::wallNormal(std::size_t i) const
{
    Vec3 sum = Vec3::Zero();
    for (const ContactRecord& c : impl_->contacts[impl_->checked(i)])
    {
        if (c.wall >= 0) sum += Vec3(c.n[0], c.n[1], c.n[2]);
    }
    const double length = sum.norm();
    return length > 0 ? Vec3(sum/length) : sum;
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


const GasLoad& System::gasLoad(std::size_t i) const
{
    return impl_->gas[impl_->checked(i)];
}


StepReport System::advance(double dt)
{
    if (!(dt > 0 && std::isfinite(dt)))
    {
        throw inputError("dt", "is " + std::to_string(dt), "a positive time [s]");
    }
    return impl_->advance(dt);
}


const GasExchange& System::gasExchange(std::size_t i) const
{
    return impl_->exchange[impl_->checked(i)];
}


void System::keepGasExchange(bool keep) { impl_->keepExchange = keep; }


void System::kick(std::size_t i, const Vec3& impulse)
{
    Particle& p = impl_->particles[impl_->checked(i)];
    const double before = p.kineticEnergy();
    p.v += impulse/p.mass;
    if (impl_->time.energyLedger) impl_->kicked += p.kineticEnergy() - before;
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
                wall
              ? s.materials.wallRadius(p.material, mj, walls().curvature(c.wall), p.radius)
              : p.radius*q.radius/(p.radius + q.radius);
            const double m = wall ? p.mass : p.mass*q.mass/(p.mass + q.mass);
            double constants[maxConstants];
            law.prepare
            (
                s.materials.pairInLaw(p.material, mj), {pair, R, m, wall ? p.radius : R}, constants
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


std::vector<int> System::unpackState
(
    std::size_t i,
    const std::vector<double>& state,
    const std::vector<int>& wallNow
)
{
    Implementation& s = *impl_;
    s.checked(i);
    if (state.empty()) return {};
    if (!PackedState::fits(state.size()))
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
    std::vector<ContactRecord> contacts;
    unpackRest
    (
        state.data(), (state.size() - restNumbers)/contactNumbers, s.rest[i], contacts
    );

    const int nWalls = int(walls().patches.size());
    std::vector<int> gone;
    s.contacts[i].clear();
    for (ContactRecord& c : contacts)
    {
        const int then = c.wall;
        if (then >= 0 && !wallNow.empty())
        {
            c.wall = std::size_t(then) < wallNow.size() ? wallNow[std::size_t(then)] : nWalls;
            if (c.wall < 0)
            {
                gone.push_back(then);
                s.rest[i].wakeForce = -1;
                continue;
            }
        }
        if (c.wall >= nWalls)
        {
            throw inputError
            (
                "contact state", "wall patch " + std::to_string(then),
                "below " + std::to_string(wallNow.empty() ? nWalls : int(wallNow.size()))
            );
        }
        s.contacts[i].push_back(c);
    }
    return gone;
}

}
