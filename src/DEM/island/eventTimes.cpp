// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/eventTimes.hpp"

#include <algorithm>
#include <cmath>

namespace dem
{

namespace
{

// Time over which steps grow to their full length, over the period of the contact
constexpr double gradedShare = 1.0/16;

bool bothRest(const IslandState& state, const Candidate& c)
{
    return state.rest[std::size_t(c.i)].resting && state.rest[std::size_t(c.j)].resting;
}

//- How a pair without a contact moves
struct Closing
{
    Vec3 d;             // from i to j [m]
    double distance;    // [m]
    double gap;         // to the touch, no less than places can tell [m]
    double speed;       // [m/s]

    Closing(const Environment& env, const IslandState& state, const Candidate& c)
    {
        const Body& a = state.bodies[std::size_t(c.i)];
        const Body& b = state.bodies[std::size_t(c.j)];
        d = env.periodic.nearest(vec(b.x) - vec(a.x));
        distance = d.norm();
        gap = std::max
        ({
            distance - a.r - b.r - c.touch,
            gapResolution(vec(a.x), a.r), gapResolution(vec(b.x), b.r)
        });
        speed = (vec(a.v) - vec(b.v)).dot(d)/std::max(distance, 1e-290);
    }
};

//- How the partners of a contact part
struct Parting
{
    double speed;           // [m/s]
    double acceleration;    // [m/s2]

    Parting
    (
        const Environment& env, const IslandState& state, const ContactList& list,
        std::size_t k
    )
    {
        const int i = list.i[k];
        const Body& bi = state.bodies[std::size_t(i)];
        if (list.isWall())
        {
            const Vec3 n(list.nx[k], list.ny[k], list.nz[k]);
            speed = -vec(bi.v).dot(n);
            acceleration = -dem::acceleration(state, i).dot(n);
        }
        else
        {
            const int j = list.j[k];
            const Body& bj = state.bodies[std::size_t(j)];
            const Vec3 n = env.periodic.nearest(vec(bj.x) - vec(bi.x)).normalized();
            speed = (vec(bj.v) - vec(bi.v)).dot(n);
            acceleration = (dem::acceleration(state, j) - dem::acceleration(state, i)).dot(n);
        }
    }
};

}


double timeToTouchInFlight
(
    const Environment& env, const IslandState& state, const Candidates& candidates
)
{
    double shortest = 1e300;
    for (const Candidate& c : candidates.pairs().all())
    {
        if (c.touching || bothRest(state, c)) continue;
        const Closing closing(env, state, c);
        const double bound = accelerationBound(state, c.i) + accelerationBound(state, c.j);
        shortest = std::min
        (
            shortest, closingTime(closing.gap, closing.speed, std::max(bound, 0.0))
        );
    }
    for (const int i : state.awake)
    {
        shortest = std::min(shortest, candidates.walls().timeToTouch(state, i));
    }
    return shortest;
}


double timeToTouchInContact
(
    const Environment& env, const IslandState& state, const Candidates& candidates,
    double strongest, double h
)
{
    double shortest = 1e300;
    // whether what contacts press together can meet within a contact step
    const auto soon = [&](double gap, double closing)
    {
        return gap < (std::max(closing, 0.0) + 2*strongest*h)*h;
    };
    candidates.pairs().eachNear([&](const Candidate& c)
    {
        if (c.touching || bothRest(state, c)) return;
        const Closing closing(env, state, c);
        double bound = 0;
        if (soon(closing.gap, closing.speed))
        {
            bound =
                (acceleration(state, c.i) - acceleration(state, c.j)).dot(closing.d)
               /std::max(closing.distance, 1e-290);
        }
        shortest = std::min
        (
            shortest, closingTime(closing.gap, closing.speed, std::max(bound, 0.0))
        );
    });
    candidates.walls().eachFree(state, [&](int i, const WallHit& hit, double gap)
    {
        const double closing = vec(state.bodies[std::size_t(i)].v).dot(hit.n);
        const double bound = soon(gap, closing) ? acceleration(state, i).dot(hit.n) : 0;
        shortest = std::min(shortest, closingTime(gap, closing, std::max(bound, 0.0)));
    });
    return shortest;
}


GradedStep gradedStep
(
    const Environment& env, const IslandState& state, double strongest, double h, bool refined
)
{
    const double tau = gradedShare*env.time.stepsPerContact*h;
    const double first = 0.25*h*h/tau;
    const double far = 2*(state.phase.fastest*std::max(h, tau) + strongest*h*h);
    double graded = h, end = 1e300;
    state.contacts.each([&](std::size_t, const ContactList& list, std::size_t k)
    {
        const ContactEntry& e = state.contacts.entry(list, k);
        const double left = std::max(list.overlap[k] + e.neck, 0.0);
        const double inside = list.overlap[k] - e.edge;
        // most contacts are nowhere near
        if (std::min(left, std::fabs(inside)) > far) return;
        const Parting parting(env, state, list, k);
        const double opening = parting.speed;
        end = std::min(end, closingTime(left, opening, std::max(parting.acceleration, 0.0)));
        if (opening == 0) return;
        const double t = std::fabs(inside/opening);
        const double even = h*std::sqrt(t/tau);
        const bool nears = inside*opening > 0;
        // not shorter than places can tell
        const Body& bi = state.bodies[std::size_t(list.i[k])];
        const double least =
            16*2.2e-16*vec(bi.x).lpNorm<Eigen::Infinity>()/std::fabs(opening);
        graded = std::min
        (
            graded,
            std::max(least, !nears ? even + first : t > first ? even - first : t + first)
        );
    });
    if (!refined) graded = h;
    if (end >= graded) end = 1e300;
    return {graded, end};
}


double meetingStep
(
    const Environment& env, const IslandState& state, const Candidates& candidates, double h,
    int looks, bool dense
)
{
    double fastest = 0;
    for (const int i : state.awake)
    {
        fastest = std::max(fastest, vec(state.bodies[std::size_t(i)].v).norm());
    }
    const double path = mostPath*candidates.smallest();     // a quarter of the skin
    if (!dense && fastest*h <= path) return h;

    double shortest = h;
    const double window = looks*h;
    const PairCandidates& pairs = candidates.pairs();
    for (std::size_t k = 0; k < pairs.all().size(); ++k)
    {
        const Candidate& c = pairs.all()[k];
        if (pairs.due(k) - candidates.skin().path > fastest*window || c.touching) continue;
        const Body& a = state.bodies[std::size_t(c.i)];
        const Body& b = state.bodies[std::size_t(c.j)];
        const double closing = (vec(a.v) - vec(b.v)).norm();
        if (closing*window <= 0) continue;
        const double gap = pairs.gap(state, c);
        if (gap > closing*window) continue;
        if (closing*h > path) shortest = std::min(shortest, path/closing);
        if (!dense || gap >= closing*window) continue;
        const ContactFigures figures = env.materials.figures
        (
            state.particles[std::size_t(c.i)].material,
            state.particles[std::size_t(c.j)].material,
            a.r, b.r, 1/a.invM, 1/b.invM, closing
        );
        shortest = std::min(shortest, figures.period/env.time.stepsPerContact);
    }
    for (std::size_t i = 0; i < state.particles.size(); ++i)
    {
        const double speed = vec(state.bodies[i].v).norm();
        if
        (
            speed*window > path
         && candidates.walls().mayReach
            (
                state, int(i), speed*window, candidates.skin().width
            )
        ) shortest = std::min(shortest, std::max(path/speed, 1e-3*h));
    }
    return shortest;
}

}
