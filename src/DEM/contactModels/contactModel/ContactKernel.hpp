// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loop over contacts of one law, put together from its parts at compile time: what a part does
// not need is neither stored, nor loaded, nor computed.
//
// One contact, n from i to j (into the wall):
//     delta = r_i + r_j - |x_j - x_i|,           delta' = (v_i - v_j).n
//     v_S = (v_i - v_j)_t + (r_i omega_i + r_j omega_j) x n
//     force on i  = -(F_N + eta_N delta') n + F_T
//     torque on i = r_i n x F_T - n x M_r + M_t n,  on j: r_j n x F_T + n x M_r - M_t n
// r are the undeformed radii.
#pragma once

#include "contactModels/contactModel/ContactLaw.hpp"
#include "contactModels/contactModel/Real.hpp"
#include "contactModels/contactModel/lanes.hpp"
#include "contactModels/contactModel/none.hpp"

#include <algorithm>

namespace dem
{

template<class Normal, class Tangential, class Rolling, class Twisting>
struct ContactKernel
{
    static constexpr bool spin = Tangential::on || Rolling::on || Twisting::on;

    // Columns of constants and history, part by part
    static constexpr int cT = Normal::nConstants;
    static constexpr int cR = cT + Tangential::nConstants;
    static constexpr int cW = cR + Rolling::nConstants;
    static constexpr int nC = cW + Twisting::nConstants;
    static constexpr int hT = Normal::nHistory;
    static constexpr int hR = hT + Tangential::nHistory;
    static constexpr int hW = hR + Rolling::nHistory;
    static constexpr int nH = hW + Twisting::nHistory;
    static_assert(nC <= maxConstants && nH <= maxHistory, "raise the maxima");


    //- What is the same for all contacts of one evaluation
    template<class Real>
    struct Shared
    {
        Real before, after;         // SpringStep
        Real minusTurned, halfTurned;
        V3<Real> period, inversePeriod;

        Shared(const SpringStep& step, const double* length)
        :
            before(step.before), after(step.after),
            minusTurned(-step.turned), halfTurned(0.5*step.turned)
        {
            if (!length) return;
            period = {Real(length[0]), Real(length[1]), Real(length[2])};
            inversePeriod = {Real(1/length[0]), Real(1/length[1]), Real(1/length[2])};
        }
    };

    //- The nearest image of a difference along one axis
    template<class Real>
    [[gnu::always_inline]] static Real nearest
    (
        const Real& d, const Real& period, const Real& inversePeriod
    )
    {
        return d - period*rounded(d*inversePeriod);
    }

    enum Partner { wallPartner, pairPartner, imagePartner };

    //- Where the columns of a list begin
    struct Columns
    {
        const int* i;
        const int* j;
        double* overlap;
        const double* n[3];
        char* ended;
        struct Constant
        {
            const double* column;
            std::size_t step;       // all bits; 0 where all contacts have the same value
            alignas(Pack) double same[packWidth];
        };
        Constant c[nC > 0 ? nC : 1];
        double* h[nH > 0 ? nH : 1];

        Columns(const Columns&) = delete;
        //- width: most contacts at a time
        Columns(ContactList& list, int width)
        :
            i(list.i.data()),
            j(list.j.data()),
            overlap(list.overlap.data()),
            n{list.nx.data(), list.ny.data(), list.nz.data()},
            ended(list.ended.data())
        {
            for (int a = 0; a < nC && list.size(); ++a)
            {
                const std::vector<double>& column = list.constants[std::size_t(a)];
                const bool same = list.same[std::size_t(a)];
                std::fill(c[a].same, c[a].same + width, column[0]);
                c[a].column = same ? c[a].same : column.data();
                c[a].step = same ? 0 : ~std::size_t(0);
            }
            for (int a = 0; a < nH; ++a) h[a] = list.history[std::size_t(a)].data();
        }
    };

    //- What one stage hands on to the next, for as many contacts as a Real holds
    template<class Real>
    struct Stage
    {
        Real ri, rj, inverseSum, overlap, inverseDistance, vn;
        V3<Real> n, dn, slipV, wRel;
        Real twistMean;
        NormalResponse<Real> normal;    // without `remaining`
        Real push;                      // F_N + eta_N delta'
        V3<Real> ft, M;                 // F_T, M_r
        Real moment;                    // M_t
    };

    template<class Real>
    [[gnu::always_inline]] static V4<Real> gather
    (
        const Body* bodies, const int* index, double (Body::*member)[3]
    )
    {
        const double* from[laneCount<Real>];
        for (int l = 0; l < laneCount<Real>; ++l) from[l] = (bodies + index[l])->*member;
        return gather4<Real>(from);
    }

    template<class Real>
    [[gnu::always_inline]] static V3<Real> load3(double* const* column, std::size_t k)
    {
        return
        {
            loadReal<Real>(column[0] + k), loadReal<Real>(column[1] + k),
            loadReal<Real>(column[2] + k)
        };
    }

    template<class Real>
    [[gnu::always_inline]] static void store3
    (
        double* const* column, std::size_t k, const V3<Real>& v
    )
    {
        storeReal<Real>(column[0] + k, v.x);
        storeReal<Real>(column[1] + k, v.y);
        storeReal<Real>(column[2] + k, v.z);
    }

    template<class Real, int count>
    [[gnu::always_inline]] static void loadConstants
    (
        const Columns& list, int first, std::size_t k, Real* c
    )
    {
        for (int a = 0; a < count; ++a)
        {
            const auto& constant = list.c[first + a];
            c[a] = loadReal<Real>(constant.column + (k & constant.step));
        }
    }


    //- Where the partners are
    template<class Real, Partner partner>
    [[gnu::always_inline]] static void locate
    (
        const Columns& list, std::size_t k, const Body* bodies,
        const Shared<Real>& shared, Stage<Real>& s
    )
    {
        // a radius follows each position
        const V4<Real> xi4 = gather<Real>(bodies, list.i + k, &Body::x);
        s.ri = xi4.w;
        if constexpr (partner == wallPartner)
        {
            s.rj = Real(0);
            s.inverseDistance = Real(0);
            s.n =
            {
                loadReal<Real>(list.n[0] + k), loadReal<Real>(list.n[1] + k),
                loadReal<Real>(list.n[2] + k)
            };
            s.overlap = loadReal<Real>(list.overlap + k);
        }
        else
        {
            const V4<Real> xj4 = gather<Real>(bodies, list.j + k, &Body::x);
            s.rj = xj4.w;
            V3<Real> d = xj4.v - xi4.v;
            if constexpr (partner == imagePartner)
            {
                d.x = nearest(d.x, shared.period.x, shared.inversePeriod.x);
                d.y = nearest(d.y, shared.period.y, shared.inversePeriod.y);
                d.z = nearest(d.z, shared.period.z, shared.inversePeriod.z);
            }
            const Real distance = squareRoot(maximum(dot(d, d), Real(1e-290)));
            if constexpr (Rolling::on)
            {
                // two reciprocals for one quotient
                const Real sum = s.ri + s.rj;
                const Real inverse = Real(1)/(distance*sum);
                s.inverseDistance = inverse*sum;
                s.inverseSum = inverse*distance;
            }
            else s.inverseDistance = Real(1)/distance;
            s.n = s.inverseDistance*d;
            s.overlap = s.ri + s.rj - distance;
            storeReal<Real>(list.overlap + k, s.overlap);
        }
    }


    //- How they move against each other
    template<class Real, Partner partner>
    [[gnu::always_inline]] static void approach
    (
        const Columns& list, std::size_t k, const Body* bodies,
        const Shared<Real>& shared, Stage<Real>& s
    )
    {
        constexpr bool wall = partner == wallPartner;
        V3<Real> v = gather<Real>(bodies, list.i + k, &Body::v).v;
        if constexpr (!wall) v = v - gather<Real>(bodies, list.j + k, &Body::v).v;
        s.vn = dot(v, s.n);

        if constexpr (spin)
        {
            V3<Real> wRel = gather<Real>(bodies, list.i + k, &Body::w).v;
            V3<Real> wSum = wRel;
            V3<Real> arm = s.ri*wRel;
            if constexpr (!wall)
            {
                const V3<Real> wj = gather<Real>(bodies, list.j + k, &Body::w).v;
                wRel = wRel - wj;
                wSum = wSum + wj;
                arm = arm + s.rj*wj;
            }
            const V3<Real> vt = v - s.vn*s.n;
            s.slipV = vt + cross(arm, s.n);
            s.wRel = wRel;

            // How the normal has turned since the last evaluation (on a wall that is not
            // known), and the pair about it: by the mean of the two spins, a wall's is 0.
            if constexpr (!wall) s.dn = (shared.minusTurned*s.inverseDistance)*vt;
            s.twistMean = shared.halfTurned*dot(wSum, s.n);
        }
    }


    template<class Real>
    [[gnu::always_inline]] static bool press
    (
        const Columns& list, std::size_t k, Stage<Real>& s
    )
    {
        Real c[Normal::nConstants];
        loadConstants<Real, Normal::nConstants>(list, 0, k, c);
        Real memory[Normal::nHistory > 0 ? Normal::nHistory : 1];
        for (int a = 0; a < Normal::nHistory; ++a)
        {
            memory[a] = loadReal<Real>(list.h[a] + k);
        }
        // one by one: a copy of the whole goes through memory in pieces
        const NormalResponse<Real> normal =
            Normal::template evaluate<Real>(c, s.overlap, memory);
        s.normal.elastic = normal.elastic;
        s.normal.damping = normal.damping;
        s.normal.radius = normal.radius;
        s.normal.strength = normal.strength;
        s.normal.pullOff = normal.pullOff;
        if constexpr (!Normal::elastic)
        {
            s.normal.pullOffBefore = normal.pullOffBefore;
            s.normal.radiusKept = normal.radiusKept;
        }
        for (int a = 0; a < Normal::nHistory; ++a)
        {
            storeReal<Real>(list.h[a] + k, memory[a]);
        }
        s.push = normal.elastic + normal.damping*s.vn;

        const bool anyOver = any(normal.remaining < Real(0));
        for (int l = 0; l < laneCount<Real>; ++l) list.ended[k + std::size_t(l)] = 0;
        if (anyOver)
        {
            for (int l = 0; l < laneCount<Real>; ++l)
            {
                list.ended[k + std::size_t(l)] = lane(normal.remaining, l) < 0;
            }
        }
        return anyOver;
    }


    //- 1, or 0 where a law that acts at a distance has no spot to resist with
    template<class Real>
    [[gnu::always_inline]] static Real spot(const NormalResponse<Real>& normal)
    {
        if constexpr (!Normal::atDistance) return Real(1);
        else return select(normal.radius > Real(0), Real(1), Real(0));
    }

    template<class Real>
    [[gnu::always_inline]] static Real slidingLimit
    (
        const Real* c, const NormalResponse<Real>& normal
    )
    {
        return Tangential::template limit<Real>
        (
            c, normal.elastic + Real(Normal::slidingShare)*normal.pullOff
        );
    }

    //- v_L of the rolling parts; R is set to the effective radius
    template<class Real, Partner partner>
    [[gnu::always_inline]] static V3<Real> rollVelocity(const Stage<Real>& s, Real& R)
    {
        // (1/2)(r_i - r_j)/(r_i + r_j)
        Real skew(-0.5);
        R = s.ri;
        if constexpr (partner != wallPartner)
        {
            R = s.ri*s.rj*s.inverseSum;
            skew = Real(0.5)*(s.ri - s.rj)*s.inverseSum;
        }
        return R*cross(s.wRel, s.n) + skew*s.slipV;
    }

    template<class Real>
    [[gnu::always_inline]] static V3<Real> rollingMoment
    (
        const Real* c, const NormalResponse<Real>& normal, const V3<Real>& rollV,
        const V3<Real>& xi
    )
    {
        return Rolling::stiffness(normal)*xi + spot(normal)*Rolling::damping(c)*rollV;
    }

    //- Whether any contact of a pack has reached its limit
    struct Beyond { bool slides = false, yields = false; };

    //- Sliding and rolling below their limits; twisting
    template<class Real, Partner partner>
    [[gnu::always_inline]] static Beyond resist
    (
        const Columns& list, std::size_t k, const Shared<Real>& shared, Stage<Real>& s
    )
    {
        constexpr bool wall = partner == wallPartner;
        const NormalResponse<Real>& normal = s.normal;
        const Real& before = shared.before;
        const Real& after = shared.after;
        const auto turn = [&](const V3<Real>& spring)
        {
            if constexpr (wall) return turned(spring, s.n, s.twistMean);
            else return turned(spring, s.n, s.dn, s.twistMean);
        };

        Beyond beyond;
        TwistingBase<Real> base{Real(0)};
        if constexpr (Tangential::on)
        {
            Real c[Tangential::nConstants];
            loadConstants<Real, Tangential::nConstants>(list, cT, k, c);
            V3<Real> xi = turn(load3<Real>(list.h + hT, k));
            if constexpr (!Normal::elastic) xi = Tangential::kept(c, normal)*xi;
            xi = xi + before*s.slipV;
            xi = spot(normal)*xi;
            const Real limit = slidingLimit(c, normal);
            s.ft = Tangential::trial(c, normal, s.slipV, xi);
            beyond.slides = any(Tangential::slides(s.ft, limit));
            store3<Real>(list.h + hT, k, xi + after*s.slipV);
            if constexpr (Twisting::limitedBySliding)
            {
                base.limit = limit;
                base.stiffness = Tangential::stiffness(c, normal.radius);
                base.damping = Tangential::damping(c, normal.damping);
            }
        }

        if constexpr (Rolling::on)
        {
            Real c[Rolling::nConstants];
            loadConstants<Real, Rolling::nConstants>(list, cR, k, c);
            Real R;
            const V3<Real> rollV = rollVelocity<Real, partner>(s, R);
            V3<Real> xi = turn(load3<Real>(list.h + hR, k));
            if constexpr (!Normal::elastic) xi = Rolling::kept(normal)*xi;
            xi = xi + before*rollV;
            xi = spot(normal)*xi;
            s.M = rollingMoment(c, normal, rollV, xi);
            beyond.yields = any(Rolling::yields(c, R, normal, xi));
            if constexpr (Twisting::limitedByBending)
            {
                base.limit = Rolling::template limit<Real>(c, R, normal);
            }
            store3<Real>(list.h + hR, k, xi + after*rollV);
        }

        if constexpr (Twisting::on)
        {
            Real c[Twisting::nConstants];
            loadConstants<Real, Twisting::nConstants>(list, cW, k, c);
            const Real spinN = dot(s.wRel, s.n);
            Real xi = loadReal<Real>(list.h[hW] + k);
            if constexpr (!Normal::elastic) xi = Twisting::kept(normal)*xi;
            s.moment = Twisting::template evaluate<Real>
            (
                c, normal, base, before*spinN, spinN, xi
            );
            s.moment = spot(normal)*s.moment;
            storeReal<Real>(list.h[hW] + k, spot(normal)*xi + after*spinN);
        }
        return beyond;
    }


    //- Those that slide: held, and cut back to what is held
    template<class Real>
    [[gnu::always_inline]] static void slide
    (
        const Columns& list, std::size_t k, const Shared<Real>& shared, Stage<Real>& s
    )
    {
        Real c[Tangential::nConstants];
        loadConstants<Real, Tangential::nConstants>(list, cT, k, c);
        const V3<Real> ahead = shared.after*s.slipV;
        V3<Real> xi = load3<Real>(list.h + hT, k) - ahead;
        s.ft = Tangential::template evaluate<Real>
        (
            c, slidingLimit(c, s.normal), s.normal, s.slipV, xi
        );
        store3<Real>(list.h + hT, k, xi + ahead);
    }


    //- Those whose rolling yields: cut back
    template<class Real, Partner partner>
    [[gnu::always_inline]] static void roll
    (
        const Columns& list, std::size_t k, const Shared<Real>& shared, Stage<Real>& s
    )
    {
        Real c[Rolling::nConstants];
        loadConstants<Real, Rolling::nConstants>(list, cR, k, c);
        Real R;
        const V3<Real> rollV = rollVelocity<Real, partner>(s, R);
        const V3<Real> ahead = shared.after*rollV;
        V3<Real> xi = load3<Real>(list.h + hR, k) - ahead;
        const auto yields = Rolling::yields(c, R, s.normal, xi);
        xi = select(yields, Rolling::cut(c, R, s.normal, xi), Real(1))*xi;
        s.M = rollingMoment(c, s.normal, rollV, xi);
        store3<Real>(list.h + hR, k, xi + ahead);
    }


    //- Loads, contact by contact: two of them may meet in one particle
    template<class Real, Partner partner>
    [[gnu::always_inline]] static void deliver
    (
        const Columns& list, std::size_t k, Load* loads, const Real& sign,
        const Stage<Real>& s
    )
    {
        V3<Real> force = (-s.push)*s.n;
        V3<Real> torqueI{Real(0), Real(0), Real(0)};
        V3<Real> torqueJ = torqueI;
        if constexpr (Tangential::on)
        {
            force = force + s.ft;
            const V3<Real> nxf = cross(s.n, s.ft);
            torqueI = s.ri*nxf;
            torqueJ = s.rj*nxf;
        }
        V3<Real> turning{Real(0), Real(0), Real(0)};
        if constexpr (Rolling::on) turning = cross(s.M, s.n);
        if constexpr (Twisting::on) turning = turning + s.moment*s.n;
        torqueI = sign*(torqueI + turning);
        torqueJ = sign*(torqueJ - turning);
        force = sign*force;

        if constexpr (spin) addLoad<Real>(loads, list.i + k, force, torqueI);
        else addTo<Real>(loads, list.i + k, &Load::f, force);
        if constexpr (partner != wallPartner)
        {
            if constexpr (spin) addLoad<Real, -1>(loads, list.j + k, force, torqueJ);
            else addTo<Real, -1>(loads, list.j + k, &Load::f, force);
        }
    }


    //- One stage after the other over a block: so the processor has the next contacts to
    //  work on while the roots and quotients of some are on their way
    template<class Real, Partner partner, int groups>
    [[gnu::always_inline]] static bool evaluateBlock
    (
        const Columns& list, std::size_t k, int n,
        const Body* bodies, Load* loads, const Shared<Real>& shared, double sign
    )
    {
        constexpr std::size_t width = laneCount<Real>;
        Stage<Real> stages[groups];
        bool ended = false;
        for (int g = 0; g < n; ++g)
        {
            locate<Real, partner>(list, k + width*g, bodies, shared, stages[g]);
        }
        for (int g = 0; g < n; ++g)
        {
            approach<Real, partner>(list, k + width*g, bodies, shared, stages[g]);
        }
        for (int g = 0; g < n; ++g)
        {
            ended |= press<Real>(list, k + width*g, stages[g]);
        }
        if constexpr (spin)
        {
            // those at their limits apart: branches that go now one way, now the other would
            // throw away what the processor has begun of the next contacts
            int slides[groups], yields[groups], nSlides = 0, nYields = 0;
            for (int g = 0; g < n; ++g)
            {
                const Beyond beyond = resist<Real, partner>
                (
                    list, k + width*g, shared, stages[g]
                );
                slides[nSlides] = g;
                yields[nYields] = g;
                nSlides += beyond.slides;
                nYields += beyond.yields;
            }
            if constexpr (Tangential::on)
            {
                for (int m = 0; m < nSlides; ++m)
                {
                    slide<Real>(list, k + width*slides[m], shared, stages[slides[m]]);
                }
            }
            if constexpr (Rolling::on)
            {
                for (int m = 0; m < nYields; ++m)
                {
                    roll<Real, partner>(list, k + width*yields[m], shared, stages[yields[m]]);
                }
            }
        }
        if (sign == 0) return ended;
        for (int g = 0; g < n; ++g)
        {
            deliver<Real, partner>(list, k + width*g, loads, Real(sign), stages[g]);
        }
        return ended;
    }


    template<Partner partner>
    static bool evaluateRange
    (
        ContactList& contacts, std::size_t begin, std::size_t end,
        const Body* bodies, Load* loads, const SpringStep& step, double sign,
        const double* period
    )
    {
        constexpr int groups = 64/packWidth;    // their stages stay in the first cache
        const Columns list(contacts, begin + packWidth <= end ? packWidth : 1);
        const Shared<Pack> shared(step, period);
        bool ended = false;
        std::size_t k = begin;
        while (k + packWidth <= end)
        {
            const int n = int(std::min<std::size_t>(groups, (end - k)/packWidth));
            ended |= evaluateBlock<Pack, partner, groups>
            (
                list, k, n, bodies, loads, shared, sign
            );
            k += std::size_t(n)*packWidth;
        }
        const Shared<double> single(step, period);
        for (; k < end; ++k)
        {
            ended |= evaluateBlock<double, partner, 1>
            (
                list, k, 1, bodies, loads, single, sign
            );
        }
        return ended;
    }
};

}
