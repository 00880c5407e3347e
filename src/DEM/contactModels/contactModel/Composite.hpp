// SPDX-License-Identifier: GPL-3.0-or-later
//
// A contact law put together from its parts at compile time. What a part does not need is
// neither stored, nor loaded, nor computed.
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
#include "timeIntegration/contactPeriod.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace dem
{

//- Whether these parts make a law; newComposite.hpp says why not
template<class Normal, class Tangential, class Rolling, class Twisting>
inline constexpr bool combines =
    (Tangential::on || !Twisting::limitedBySliding)
 && (Rolling::bends || !Twisting::limitedByBending)
 && (Normal::elastic || !Rolling::elasticOnly);


template<class Normal, class Tangential, class Rolling, class Twisting>
class Composite : public ContactLaw
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
    static_assert(combines<Normal, Tangential, Rolling, Twisting>);

    struct Pair
    {
        typename Normal::Parameters n;
        typename Tangential::Parameters t;
        typename Rolling::Parameters r;
        typename Twisting::Parameters w;
    };
    std::vector<Pair> pairs_;


    //- The nearest image of a difference along one axis
    template<class Real>
    [[gnu::always_inline]] static Real nearest(const Real& d, double length)
    {
        const Real half(0.5*length), whole(length);
        return select(d > half, d - whole, select(d < -half, d + whole, d));
    }

    enum Partner { wallPartner, pairPartner, imagePartner };

    template<class Real, Partner partner>
    static bool evaluate
    (
        ContactList& list, std::size_t k,
        const Body* bodies, Load* loads, const SpringStep& step, double sign,
        const double* period
    )
    {
        constexpr bool wall = partner == wallPartner;
        constexpr int width = laneCount<Real>;
        (void)period;

        const Body* bi[width];
        const Body* bj[width];
        for (int l = 0; l < width; ++l)
        {
            bi[l] = bodies + list.i[k + std::size_t(l)];
            if constexpr (!wall) bj[l] = bodies + list.j[k + std::size_t(l)];
        }
        const auto gather = [&](const Body* const* b, double (Body::*member)[3])
        {
            const double* from[width];
            for (int l = 0; l < width; ++l) from[l] = b[l]->*member;
            return gather4<Real>(from);
        };

        // Geometry; a radius follows each position
        const V4<Real> xi4 = gather(bi, &Body::x);
        const Real ri = xi4.w;
        Real rj(0);
        Real inverseDistance(0);
        V3<Real> n;
        Real overlap;
        V3<Real> v = gather(bi, &Body::v).v;
        if constexpr (wall)
        {
            n = {loadReal<Real>(&list.nx[k]), loadReal<Real>(&list.ny[k]), loadReal<Real>(&list.nz[k])};
            overlap = loadReal<Real>(&list.overlap[k]);
        }
        else
        {
            const V4<Real> xj4 = gather(bj, &Body::x);
            rj = xj4.w;
            V3<Real> d = xj4.v - xi4.v;
            if constexpr (partner == imagePartner)
            {
                d.x = nearest(d.x, period[0]);
                d.y = nearest(d.y, period[1]);
                d.z = nearest(d.z, period[2]);
            }
            const Real distance = squareRoot(maximum(dot(d, d), Real(1e-290)));
            inverseDistance = Real(1)/distance;
            n = inverseDistance*d;
            overlap = ri + rj - distance;
            storeReal<Real>(&list.overlap[k], overlap);
            v = v - gather(bj, &Body::v).v;
        }

        Real c[nC > 0 ? nC : 1];
        for (int a = 0; a < nC; ++a) c[a] = loadReal<Real>(&list.constants[std::size_t(a)][k]);

        // Normal
        Real memory[Normal::nHistory > 0 ? Normal::nHistory : 1];
        for (int a = 0; a < Normal::nHistory; ++a)
        {
            memory[a] = loadReal<Real>(&list.history[std::size_t(a)][k]);
        }
        const auto normal = Normal::template evaluate<Real>(c, overlap, memory);
        for (int a = 0; a < Normal::nHistory; ++a)
        {
            storeReal<Real>(&list.history[std::size_t(a)][k], memory[a]);
        }
        const Real vn = dot(v, n);
        const Real push = normal.elastic + normal.damping*vn;
        V3<Real> force = (-push)*n;
        V3<Real> torqueI{Real(0), Real(0), Real(0)};
        V3<Real> torqueJ = torqueI;

        if constexpr (spin)
        {
            const V3<Real> wi = gather(bi, &Body::w).v;
            V3<Real> wRel = wi;
            V3<Real> wSum = wi;
            V3<Real> arm = ri*wi;
            if constexpr (!wall)
            {
                const V3<Real> wj = gather(bj, &Body::w).v;
                wRel = wRel - wj;
                wSum = wSum + wj;
                arm = arm + rj*wj;
            }
            const V3<Real> vt = v - vn*n;
            const V3<Real> slipV = vt + cross(arm, n);
            const Real before(step.before), after(step.after);

            // How the normal has turned since the last evaluation (on a wall that is not
            // known), and the pair about it: by the mean of the two spins, a wall's is 0.
            const V3<Real> dn = (Real(-step.turned)*inverseDistance)*vt;
            const Real twistMean = Real(0.5*step.turned)*dot(wSum, n);
            const auto turn = [&](const V3<Real>& spring)
            {
                if constexpr (wall) return turned(spring, n, twistMean);
                else return turned(spring, n, dn, twistMean);
            };

            // What friction presses on: the pull-off force as past loads have left it
            Real pressed = normal.elastic;
            if constexpr (!Normal::elastic) pressed = pressed + normal.buildUp;

            // A law that acts at a distance has no spot to resist with before contact
            Real spot(1);
            if constexpr (Normal::atDistance)
            {
                spot = select(normal.radius > Real(0), Real(1), Real(0));
            }

            Real twistingLimit(0);
            if constexpr (Tangential::on)
            {
                V3<Real> xi
                {
                    loadReal<Real>(&list.history[hT][k]),
                    loadReal<Real>(&list.history[hT + 1][k]),
                    loadReal<Real>(&list.history[hT + 2][k])
                };
                xi = turn(xi);
                if constexpr (!Normal::elastic) xi = Tangential::kept(c + cT, normal)*xi;
                const V3<Real> ft = Tangential::template evaluate<Real>
                (
                    c + cT, pressed, normal.damping, normal.radius,
                    before*slipV, slipV, xi
                );
                if constexpr (Normal::atDistance) xi = spot*xi;
                xi = xi + after*slipV;
                storeReal<Real>(&list.history[hT][k], xi.x);
                storeReal<Real>(&list.history[hT + 1][k], xi.y);
                storeReal<Real>(&list.history[hT + 2][k], xi.z);
                if constexpr (Twisting::limitedBySliding)
                {
                    twistingLimit = Tangential::template limit<Real>(c + cT, pressed);
                }

                force = force + ft;
                const V3<Real> nxf = cross(n, ft);
                torqueI = ri*nxf;
                torqueJ = rj*nxf;
            }

            if constexpr (Rolling::on)
            {
                // the last two constants of every rolling part
                const Real skew = c[cR + Rolling::nConstants - 2];
                const Real R = c[cR + Rolling::nConstants - 1];
                const V3<Real> rollV = R*cross(wRel, n) + skew*slipV;
                V3<Real> xi
                {
                    loadReal<Real>(&list.history[hR][k]),
                    loadReal<Real>(&list.history[hR + 1][k]),
                    loadReal<Real>(&list.history[hR + 2][k])
                };
                xi = turn(xi);
                if constexpr (!Normal::elastic) xi = Rolling::kept(c + cR, normal)*xi;
                V3<Real> M = Rolling::template evaluate<Real>
                (
                    c + cR, normal, before*rollV, rollV, xi
                );
                if constexpr (Normal::atDistance)
                {
                    xi = spot*xi;
                    M = spot*M;
                }
                if constexpr (Twisting::limitedByBending)
                {
                    twistingLimit = Rolling::template limit<Real>(c + cR, normal);
                }
                xi = xi + after*rollV;
                storeReal<Real>(&list.history[hR][k], xi.x);
                storeReal<Real>(&list.history[hR + 1][k], xi.y);
                storeReal<Real>(&list.history[hR + 2][k], xi.z);
                const V3<Real> nxm = cross(n, M);
                torqueI = torqueI - nxm;
                torqueJ = torqueJ + nxm;
            }

            if constexpr (Twisting::on)
            {
                const Real spinN = dot(wRel, n);
                Real xi = loadReal<Real>(&list.history[hW][k]);
                if constexpr (!Normal::elastic) xi = Twisting::kept(c + cW, normal)*xi;
                Real moment = Twisting::template evaluate<Real>
                (
                    c + cW, normal, twistingLimit,
                    before*spinN, spinN, xi
                );
                if constexpr (Normal::atDistance)
                {
                    xi = spot*xi;
                    moment = spot*moment;
                }
                xi = xi + after*spinN;
                storeReal<Real>(&list.history[hW][k], xi);
                torqueI = torqueI + moment*n;
                torqueJ = torqueJ - moment*n;
            }
        }

        // Loads, lane by lane: two of them may meet in one particle
        double* fi[width];
        double* ti[width];
        for (int l = 0; l < width; ++l)
        {
            Load& load = loads[list.i[k + std::size_t(l)]];
            fi[l] = load.f;
            ti[l] = load.t;
        }
        const Real plus(sign);
        addTo<Real>(fi, plus*force);
        if constexpr (spin) addTo<Real>(ti, plus*torqueI);
        if constexpr (!wall)
        {
            for (int l = 0; l < width; ++l)
            {
                Load& load = loads[list.j[k + std::size_t(l)]];
                fi[l] = load.f;
                ti[l] = load.t;
            }
            addTo<Real>(fi, (-plus)*force);
            if constexpr (spin) addTo<Real>(ti, plus*torqueJ);
        }

        bool anyEnded = false;
        for (int l = 0; l < width; ++l)
        {
            const bool over = lane(normal.remaining, l) < 0;
            list.ended[k + std::size_t(l)] = over;
            anyEnded = anyEnded || over;
        }
        return anyEnded;
    }


    template<Partner partner>
    static bool evaluateRange
    (
        ContactList& list, std::size_t begin, std::size_t end,
        const Body* bodies, Load* loads, const SpringStep& step, double sign,
        const double* period
    )
    {
        bool anyEnded = false;
        std::size_t k = begin;
        for (; k + packWidth <= end; k += packWidth)
        {
            anyEnded |= evaluate<Pack, partner>(list, k, bodies, loads, step, sign, period);
        }
        for (; k < end; ++k)
        {
            anyEnded |= evaluate<double, partner>(list, k, bodies, loads, step, sign, period);
        }
        return anyEnded;
    }


public:

    std::string name() const override
    {
        return
            std::string(Normal::model) + "+" + Tangential::model + "+"
          + Rolling::model + "+" + Twisting::model;
    }

    int nConstants() const override { return nC; }
    int nHistory() const override { return nH; }
    bool needsSpin() const override { return spin; }

    int addPair(const ContactSettings& s) override
    {
        pairs_.push_back
        ({
            Normal::read({"normal", s.normal, Normal::keywords()}),
            Tangential::read({"tangential", s.tangential, Tangential::keywords()}),
            Rolling::read({"rolling", s.rolling, Rolling::keywords()}),
            Twisting::read({"twisting", s.twisting, Twisting::keywords()})
        });
        return int(pairs_.size()) - 1;
    }

    void prepare(int pair, const ContactScale& s, double* c) const override
    {
        const Pair& p = pairs_[std::size_t(pair)];
        const PairConstants limits = s.pair.limits();
        const double strength = Normal::pullOff(p.n, limits, s.R);
        const double a0 = Normal::equilibriumRadius(p.n, limits, s.R);
        const double a0Soft = Normal::equilibriumRadius(p.n, s.pair, s.R);
        const ResistanceScale resistance
        {
            strength,
            Normal::slidingOffset(strength),
            a0,
            // without adhesion a grows as chi^(-1/5) at given impact
            a0Soft > 0 ? a0/a0Soft : std::pow(s.pair.chi/limits.chi, 0.2),
            Normal::loadingStiffness(p.n, limits, s.R)
        };
        // shear is softened with the law's own stiffness
        PairConstants pairOfShear = s.pair;
        if constexpr (!Normal::elastic) pairOfShear.G *= Normal::shearFactor(p.n);
        const ContactScale shear{pairOfShear, s.R, s.m, s.skew};
        const double dashRatio = Normal::tangentialDampingRatio(s.pair);

        Normal::prepare(p.n, s, c);
        if constexpr (Tangential::on)
        {
            Tangential::prepare(p.t, shear, resistance, dashRatio, c + cT);
        }
        if constexpr (Rolling::on)
        {
            Rolling::prepare(p.r, s, resistance, c + cR);
        }
        if constexpr (Twisting::on)
        {
            Twisting::prepare(p.w, shear, resistance, dashRatio, c + cW);
        }
    }

    bool elastic() const override { return Normal::elastic; }

    double pullOff(int pair, const PairConstants& c, double R) const override
    {
        return Normal::pullOff(pairs_[std::size_t(pair)].n, c, R);
    }

    double reach(int pair, const PairConstants& c, double R) const override
    {
        return Normal::reach(pairs_[std::size_t(pair)].n, c, R);
    }

    double equilibriumRadius(int pair, const PairConstants& c, double R) const override
    {
        return Normal::equilibriumRadius(pairs_[std::size_t(pair)].n, c, R);
    }

    Impact impact(int pair, const ContactScale& s, double speed) const override
    {
        if constexpr (Normal::elastic)
        {
            (void)pair;
            return hertzianImpact(s.pair.E, s.R, s.m, speed);
        }
        else
        {
            return Normal::impact(pairs_[std::size_t(pair)].n, s, speed);
        }
    }

    double rollingYield(const double* c) const override
    {
        if constexpr (Rolling::on)
        {
            return Rolling::yield(c + cR);
        }
        else
        {
            (void)c;
            return 0;
        }
    }

    NormalResponse<double> normalResponse
    (
        const double* c, double overlap, double* history
    ) const override
    {
        return Normal::template evaluate<double>(c, overlap, history);
    }

    double touchDistance(int pair, const PairConstants& c) const override
    {
        return Normal::touchDistance(pairs_[std::size_t(pair)].n, c);
    }

    ContactBound bound
    (
        int pair, const ContactScale& s, const double* c, const double* history,
        double turning, double overlap, double speed
    ) const override
    {
        const ElasticBound b = Normal::bound
        (
            pairs_[std::size_t(pair)].n, s, overlap, speed, history
        );
        double square = s.m/b.stiffness;

        // the dashpot at that radius
        double memory[Normal::nHistory > 0 ? Normal::nHistory : 1];
        std::copy(history, history + Normal::nHistory, memory);
        const double eta =
            Normal::template evaluate<double>(c, b.radius*b.radius/s.R, memory).damping;
        ContactBound result{0, b.radius, b.stiffness, eta};
        (void)turning;
        if constexpr (Tangential::on)
        {
            const double k = Tangential::stiffness(c + cT, b.radius);
            const double dash = Tangential::damping(c + cT, eta);
            square = std::min(square, 2.0/7.0*s.m/k);
            result.stiffness = std::max(result.stiffness, 7*k);
            result.damping = std::max(eta, 3.5*dash);
            result.slipTime = dash/k;
        }
        if constexpr (Rolling::on)
        {
            const double k = Rolling::stiffness(c + cR, overlap, b.buildUp);
            if (k > 0) square = std::min(square, 1/(k*turning));
            result.rolling = 2*k;
            result.rollingDamping = Rolling::damping(c + cR);
            if (k > 0) result.turnTime = result.rollingDamping/k;
        }
        if constexpr (Twisting::on)
        {
            const double k = Twisting::stiffness(c + cW, b.radius, b.buildUp);
            result.twisting = 2*k;
            result.twistingDamping = Twisting::damping(c + cW, b.radius, eta);
            if (k > 0) result.turnTime = std::min(result.turnTime, result.twistingDamping/k);
        }
        result.period = 2*M_PI*std::sqrt(square);
        return result;
    }

    bool evaluatePairs
    (
        ContactList& list, std::size_t begin, std::size_t end,
        const Body* bodies, Load* loads, const SpringStep& step, double sign,
        const Periodic& p
    ) const override
    {
        if (p.on())
        {
            // a length that no difference reaches where there is no period
            double period[3];
            for (int d = 0; d < 3; ++d)
            {
                period[d] = p.length[d] > 0 ? p.length[d] : 1e300;
            }
            return evaluateRange<imagePartner>
            (
                list, begin, end, bodies, loads, step, sign, period
            );
        }
        return evaluateRange<pairPartner>
        (
            list, begin, end, bodies, loads, step, sign, nullptr
        );
    }

    bool evaluateWalls
    (
        ContactList& list, std::size_t begin, std::size_t end,
        const Body* bodies, Load* loads, const SpringStep& step, double sign
    ) const override
    {
        return evaluateRange<wallPartner>
        (
            list, begin, end, bodies, loads, step, sign, nullptr
        );
    }
};

}
