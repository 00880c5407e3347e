// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the parts of one contact store and take, for the energy ledger: with the same parts, from
// the same state, as the forces (ContactKernel.hpp).
#pragma once

#include "contactModels/contactModel/ContactEnergy.hpp"
#include "contactModels/contactModel/ContactKernel.hpp"

namespace dem
{

template<class Normal, class Tangential, class Rolling, class Twisting>
class CompositeEnergy
{
    using Kernel = ContactKernel<Normal, Tangential, Rolling, Twisting>;
    using V = V3<double>;

    static V vector(const double* a) { return {a[0], a[1], a[2]}; }

    //- How the partners are and move against each other
    struct Meeting
    {
        V n, v, w, arm;         // arm: r_i omega_i + r_j omega_j
        double overlap, R;
        double skew = -0.5;     // (1/2)(r_i - r_j)/(r_i + r_j)
        double vn;
        V slipV = {0, 0, 0}, rollV = {0, 0, 0}, turning = {0, 0, 0};

        Meeting
        (
            const ContactList& list, std::size_t k, const Body* bodies, const Periodic& periodic
        )
        {
            const Body& bi = bodies[list.i[k]];
            v = vector(bi.v);
            w = vector(bi.w);
            arm = bi.r*w;
            R = bi.r;
            if (list.isWall())
            {
                n = {list.nx[k], list.ny[k], list.nz[k]};
                overlap = list.overlap[k];
            }
            else
            {
                const Body& bj = bodies[list.j[k]];
                const Vec3 d = periodic.nearest
                (
                    Vec3(bj.x[0] - bi.x[0], bj.x[1] - bi.x[1], bj.x[2] - bi.x[2])
                );
                const double distance = d.norm();
                n = (1/distance)*V{d[0], d[1], d[2]};
                overlap = bi.r + bj.r - distance;
                R = bi.r*bj.r/(bi.r + bj.r);
                skew = 0.5*(bi.r - bj.r)/(bi.r + bj.r);
                v = v - vector(bj.v);
                w = w - vector(bj.w);
                arm = arm + bj.r*vector(bj.w);
            }
            vn = dot(v, n);
        }

        //- Of the parts that need spin
        void turn()
        {
            slipV = v - vn*n + cross(arm, n);
            turning = cross(w, n);
            rollV = R*turning + skew*slipV;
        }
    };

    ContactEnergy e_;
    const Meeting m_;
    const NormalResponse<double>& normal_;
    const double* c_;
    const double* h_;
    double ahead_;
    TwistingBase<double> base_{0};

    //- power: what the part takes from the two bodies; the spring gets `input` of it
    void account
    (
        SpringEnergy& s, double limit, double stiffness, double square, double input,
        double power
    )
    {
        s.yields = stiffness*stiffness*square > 0.98*limit*limit;
        s.square = square;
        s.input = input;
        e_.dashpots += power - input;
    }

    //- As it was when the forces were evaluated
    V spring(const double* stored, const V& velocity) const
    {
        return vector(stored) - ahead_*velocity;
    }

    void sliding()
    {
        const double* c = c_ + Kernel::cT;
        V xi = spring(h_ + Kernel::hT, m_.slipV);
        const double limit = Kernel::template slidingLimit<double>(c, normal_);
        const V force = Tangential::template evaluate<double>(c, limit, normal_, m_.slipV, xi);
        const double k = Tangential::template stiffness<double>(c, normal_.radius);
        account
        (
            e_.springs[0], limit, k, dot(xi, xi), k*dot(xi, m_.slipV), -dot(force, m_.slipV)
        );
        e_.springs[0].stiffness = k;
        base_ = {limit, k, Tangential::template damping<double>(c, normal_.damping)};
    }

    void rolling()
    {
        const double* c = c_ + Kernel::cR;
        const double R = m_.R;
        V xi = spring(h_ + Kernel::hR, m_.rollV);
        if (Rolling::template yields<double>(c, R, normal_, xi))
        {
            xi = Rolling::template cut<double>(c, R, normal_, xi)*xi;
        }
        const double k = Rolling::stiffness(normal_);
        const V M = Kernel::template rollingMoment<double>(c, normal_, m_.rollV, xi);
        const double limit = Rolling::template limit<double>(c, R, normal_);
        account
        (
            e_.springs[1], limit, k, dot(xi, xi), k*dot(xi, m_.turning), dot(M, m_.turning)
        );
        e_.springs[1].stiffness = k/R;
        e_.springs[1].gain = k/R*m_.skew*dot(xi, m_.slipV);
        if constexpr (Twisting::limitedByBending) base_.limit = limit;
    }

    void twisting()
    {
        const double* c = c_ + Kernel::cW;
        const double spinN = dot(m_.w, m_.n);
        double xi = h_[Kernel::hW] - ahead_*spinN;
        const double moment = Twisting::template evaluate<double>
        (
            c, normal_, base_, 0, spinN, xi
        );
        const double k = Twisting::template stiffness<double>
        (
            c, normal_.radius, normal_.pullOff, base_
        );
        account
        (
            e_.springs[2], Twisting::limit(c, normal_, base_), k, xi*xi, k*xi*spinN,
            -moment*spinN
        );
        e_.springs[2].stiffness = k;
    }


public:

    //- Of contact k; its springs are `ahead` of the loads [s]
    static ContactEnergy of
    (
        const ContactList& list, std::size_t k, const Body* bodies, double ahead,
        const Periodic& periodic
    )
    {
        constexpr int nC = Kernel::nC, nH = Kernel::nH;
        double c[nC > 0 ? nC : 1], h[nH > 0 ? nH : 1];
        for (int a = 0; a < nC; ++a) c[a] = list.constants[std::size_t(a)][k];
        for (int a = 0; a < nH; ++a) h[a] = list.history[std::size_t(a)][k];

        Meeting m(list, k, bodies, periodic);
        ContactEnergy e;
        e.overlap = m.overlap;
        e.closing = m.vn;
        e.normal = Normal::energy(c, m.overlap, h);
        const NormalResponse<double> normal =
            Normal::template evaluate<double>(c, m.overlap, h);
        e.normalDashpot = normal.damping*m.vn*m.vn;
        if constexpr (Kernel::spin)
        {
            if constexpr (Normal::atDistance)
            {
                // no spot to resist with: what springs had is lost
                if (!(normal.radius > 0))
                {
                    for (SpringEnergy& s : e.springs) s.yields = true;
                    return e;
                }
            }
            m.turn();
            CompositeEnergy parts(e, m, normal, c, h, ahead);
            if constexpr (Tangential::on) parts.sliding();
            if constexpr (Rolling::on) parts.rolling();
            if constexpr (Twisting::on) parts.twisting();
            return parts.e_;
        }
        else return e;
    }


private:

    CompositeEnergy
    (
        const ContactEnergy& e, const Meeting& m, const NormalResponse<double>& normal,
        const double* c, const double* h, double ahead
    )
    :
        e_(e), m_(m), normal_(normal), c_(c), h_(h), ahead_(ahead)
    {}
};

}
