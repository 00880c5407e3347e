// SPDX-License-Identifier: GPL-3.0-or-later
//
// A contact law put together from its parts: the constants of its contacts, what is asked about
// them, and its kernel.
#pragma once

#include "contactModels/contactModel/CompositeEnergy.hpp"
#include "contactModels/contactModel/ContactKernel.hpp"
#include "contactModels/normal/ellipticContact.hpp"
#include "timeIntegration/contactPeriod.hpp"

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
    using Kernel = ContactKernel<Normal, Tangential, Rolling, Twisting>;
    static constexpr int cT = Kernel::cT, cR = Kernel::cR, cW = Kernel::cW, nC = Kernel::nC;
    static constexpr int hT = Kernel::hT, hR = Kernel::hR, hW = Kernel::hW, nH = Kernel::nH;
    static constexpr bool spin = Kernel::spin;
    static_assert(combines<Normal, Tangential, Rolling, Twisting>);

    struct Pair
    {
        typename Normal::Parameters n;
        typename Tangential::Parameters t;
        typename Rolling::Parameters r;
        typename Twisting::Parameters w;
    };
    std::vector<Pair> pairs_;


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
        const double a0 = Normal::equilibriumRadius(p.n, limits, s.R);
        // as a quotient it would differ in the last digit from contact to contact
        double radiusFactor = s.pair.radiusFactor();
        if constexpr (!Normal::elastic)
        {
            const double a0Soft = Normal::equilibriumRadius(p.n, s.pair, s.R);
            radiusFactor = a0Soft > 0 ? a0/a0Soft : 1;
        }
        const ResistanceScale resistance
        {
            a0,
            radiusFactor,
            Normal::loadingStiffness(p.n, limits, s.R)
        };
        // shear is softened with the law's own stiffness
        PairConstants pairOfShear = s.pair;
        if constexpr (!Normal::elastic) pairOfShear.G *= Normal::shearFactor(p.n);
        const ContactScale shear{pairOfShear, s.R, s.m};
        const double dashRatio = Normal::tangentialDampingRatio(s.pair);

        Normal::prepare(p.n, s, c);
        if constexpr (Tangential::on)
        {
            Tangential::prepare(p.t, shear, dashRatio, c + cT);
        }
        if constexpr (Rolling::on)
        {
            Rolling::prepare(p.r, s, resistance, c + cR);
        }
        if constexpr (Twisting::on)
        {
            Twisting::prepare(p.w, shear, resistance, c + cW);
        }
    }

    bool elastic() const override { return Normal::elastic; }
    TaborRange taborRange() const override { return Normal::tabor; }

    double effectiveRadius(double inverse1, double inverse2) const override
    {
        return Normal::effectiveRadius(ellipticContact::Shape(inverse1, inverse2));
    }

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

    RollingYield rollingYield(const double* c, double R) const override
    {
        if constexpr (Rolling::on)
        {
            double memory[Normal::nHistory > 0 ? Normal::nHistory : 1] = {};
            const double pullOff = Normal::template evaluate<double>(c, 0, memory).pullOff;
            const double moment = Rolling::yield(c + cR, R, pullOff);
            const double k = Rolling::stiffness(c + cR, R, 0, pullOff)*R;
            return {moment, k > 0 ? 0.5*moment*moment/k : 0};
        }
        else
        {
            (void)c;
            (void)R;
            return {0, 0};
        }
    }

    SpringColumns springColumns() const override
    {
        return {Tangential::on ? hT : -1, Rolling::on ? hR : -1, Twisting::on ? hW : -1};
    }

    NormalResponse<double> normalResponse
    (
        const double* c, double overlap, double* history
    ) const override
    {
        return Normal::template evaluate<double>(c, overlap, history);
    }

    ContactEnergy energy
    (
        const ContactList& list, std::size_t k, const Body* bodies, double ahead,
        const Periodic& periodic
    ) const override
    {
        return CompositeEnergy<Normal, Tangential, Rolling, Twisting>::of
        (
            list, k, bodies, ahead, periodic
        );
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
        const double pullOff =
            Normal::pullOff(pairs_[std::size_t(pair)].n, s.pair.limits(), s.R) + b.buildUp;
        TwistingBase<double> base{0};
        (void)turning;
        (void)pullOff;
        if constexpr (Tangential::on)
        {
            const double k = Tangential::template stiffness<double>(c + cT, b.radius);
            const double dash = Tangential::template damping<double>(c + cT, eta);
            base = {0, k, dash};
            square = std::min(square, 2.0/7.0*s.m/k);
            result.stiffness = std::max(result.stiffness, 7*k);
            result.damping = std::max(eta, 3.5*dash);
            result.slipTime = dash/k;
        }
        if constexpr (Rolling::on)
        {
            const double k = Rolling::stiffness(c + cR, s.R, overlap, pullOff);
            if (k > 0) square = std::min(square, 1/(k*turning));
            result.rolling = 2*k;
            result.rollingDamping = Rolling::template damping<double>(c + cR);
            if (k > 0) result.turnTime = result.rollingDamping/k;
        }
        if constexpr (Twisting::on)
        {
            const double k = Twisting::template stiffness<double>(c + cW, b.radius, pullOff, base);
            result.twisting = 2*k;
            result.twistingDamping = Twisting::damping(c + cW, b.radius, base);
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
            return Kernel::template evaluateRange<Kernel::imagePartner>
            (
                list, begin, end, bodies, loads, step, sign, period
            );
        }
        return Kernel::template evaluateRange<Kernel::pairPartner>
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
        return Kernel::template evaluateRange<Kernel::wallPartner>
        (
            list, begin, end, bodies, loads, step, sign, nullptr
        );
    }
};

}
