// SPDX-License-Identifier: GPL-3.0-or-later
//
// Calls the kernels of one contact law for contacts placed by hand, without any motion.
#pragma once

#include "contactModels/contactModel/ContactLaw.hpp"
#include "scene.hpp"

namespace bench
{

using dem::Vec3;

//- One contact along n (from i to j, or into the wall) and how its partners move
struct Placed
{
    double ri, rj;                  // rj <= 0: flat wall
    double overlap;
    Vec3 n = Vec3::UnitX();
    // velocities and spins, by which springs are moved on and which dashpots see
    Vec3 vI = Vec3::Zero(), vJ = Vec3::Zero();
    Vec3 wI = Vec3::Zero(), wJ = Vec3::Zero();
    // the same for the springs alone, added to those
    Vec3 vSpringI = Vec3::Zero(), vSpringJ = Vec3::Zero();
    Vec3 wSpringI = Vec3::Zero(), wSpringJ = Vec3::Zero();
};

struct Loads { Vec3 forceI, forceJ, torqueI, torqueJ; };

inline void put(double* to, const Vec3& from)
{
    for (int d = 0; d < 3; ++d) to[d] = from[d];
}

//- A list of contacts of one pair of materials, evaluated together
class ContactBench
{
public:

    explicit ContactBench(const scene::Law& law)
    :
        law_(law),
        table_(law.table())
    {
        const std::size_t l = std::size_t(table_.lawIndex(0, 1));
        contactLaw_ = table_.laws()[l].get();
        pairs_.setUp(contactLaw_->nConstants(), contactLaw_->nHistory(), false);
        walls_.setUp(contactLaw_->nConstants(), contactLaw_->nHistory(), true);
    }

    const dem::ContactLaw& law() const { return *contactLaw_; }
    const dem::MaterialTable& table() const { return table_; }

    //- Figures of the law at effective radius R, as softened
    double pullOff(double R) const
    {
        return contactLaw_->pullOff(table_.pairInLaw(0, 1), table_.constants(0, 1), R);
    }
    double reach(double R) const
    {
        return contactLaw_->reach(table_.pairInLaw(0, 1), table_.constants(0, 1), R);
    }
    double equilibriumRadius(double R) const
    {
        return contactLaw_->equilibriumRadius
        (
            table_.pairInLaw(0, 1), table_.constants(0, 1), R
        );
    }

    std::vector<double> constants(double ri, double rj) const
    {
        std::vector<double> c(dem::maxConstants, 0.0);
        const double mi = law_.mass(ri), mj = rj > 0 ? law_.mass(rj) : 0;
        const double R = rj > 0 ? ri*rj/(ri + rj) : ri;
        const double m = rj > 0 ? mi*mj/(mi + mj) : mi;
        contactLaw_->prepare
        (
            table_.pairInLaw(0, 1), {table_.constants(0, 1), R, m}, c.data()
        );
        return c;
    }

    dem::NormalResponse<double> normal(double ri, double rj, double overlap) const
    {
        double history[dem::maxHistory] = {};
        return contactLaw_->normalResponse(constants(ri, rj).data(), overlap, history);
    }

    void add(const Placed& p)
    {
        const int i = int(bodies_.size());
        bodies_.emplace_back();
        bodies_.emplace_back();
        loads_.resize(bodies_.size());
        dem::ContactList& list = p.rj > 0 ? pairs_ : walls_;
        list.append
        (
            i, p.rj > 0 ? i + 1 : 0, 0, constants(p.ri, p.rj).data(), nullptr
        );
        tags_.push_back({p.rj > 0, list.size() - 1});
        place(tags_.size() - 1, p);
    }

    //- Move contact k, keeping its history
    void place(std::size_t k, const Placed& p)
    {
        placed_.resize(tags_.size());
        placed_[k] = p;
        dem::Body& a = bodies_[2*k];
        dem::Body& b = bodies_[2*k + 1];
        a = {};
        b = {};
        a.r = p.ri;
        b.r = p.rj > 0 ? p.rj : 0;
        if (p.rj > 0)
        {
            put(b.x, (p.ri + p.rj - p.overlap)*p.n);
        }
        else
        {
            const std::size_t l = tags_[k].index;
            walls_.nx[l] = p.n.x();
            walls_.ny[l] = p.n.y();
            walls_.nz[l] = p.n.z();
            walls_.overlap[l] = p.overlap;
        }
    }

    //- Move the springs on over h, then evaluate; contacts of one kind go to the kernel in
    //  one call, or one by one
    void evaluate(double h = 0, bool together = true)
    {
        if (h > 0)
        {
            // over a long time at low speed, so that no dashpot has a say
            const double slow = 1e15;
            for (std::size_t k = 0; k < placed_.size(); ++k)
            {
                const Placed& p = placed_[k];
                dem::Body& a = bodies_[2*k];
                dem::Body& b = bodies_[2*k + 1];
                put(a.v, h/slow*(p.vI + p.vSpringI));
                put(b.v, h/slow*(p.vJ + p.vSpringJ));
                put(a.w, h/slow*(p.wI + p.wSpringI));
                put(b.w, h/slow*(p.wJ + p.wSpringJ));
            }
            run({slow, slow, 0}, together);
        }
        for (std::size_t k = 0; k < placed_.size(); ++k)
        {
            const Placed& p = placed_[k];
            put(bodies_[2*k].v, p.vI);
            put(bodies_[2*k + 1].v, p.vJ);
            put(bodies_[2*k].w, p.wI);
            put(bodies_[2*k + 1].w, p.wJ);
        }
        run({}, together);
    }

    Loads loads(std::size_t k) const
    {
        const auto vector = [](const double* p) { return Vec3(p[0], p[1], p[2]); };
        const dem::Load& a = loads_[2*k];
        const dem::Load& b = loads_[2*k + 1];
        return {vector(a.f), vector(b.f), vector(a.t), vector(b.t)};
    }

    bool ended(std::size_t k) const
    {
        return (tags_[k].pair ? pairs_ : walls_).ended[tags_[k].index] != 0;
    }

    std::vector<double> history(std::size_t k) const
    {
        const dem::ContactList& list = tags_[k].pair ? pairs_ : walls_;
        std::vector<double> h;
        for (const auto& column : list.history) h.push_back(column[tags_[k].index]);
        return h;
    }

private:

    struct Tag { bool pair; std::size_t index; };

    void run(const dem::SpringStep& step, bool together)
    {
        for (dem::Load& l : loads_) l = {};
        for (const bool wall : {false, true})
        {
            const std::size_t n = wall ? walls_.size() : pairs_.size();
            for (std::size_t first = 0; first < n;)
            {
                const std::size_t last = together ? n : first + 1;
                if (wall)
                {
                    contactLaw_->evaluateWalls
                    (
                        walls_, first, last, bodies_.data(), loads_.data(), step, 1
                    );
                }
                else
                {
                    contactLaw_->evaluatePairs
                    (
                        pairs_, first, last, bodies_.data(), loads_.data(), step, 1, {}
                    );
                }
                first = last;
            }
        }
    }

    scene::Law law_;
    dem::MaterialTable table_;
    const dem::ContactLaw* contactLaw_;
    dem::ContactList pairs_, walls_;
    std::vector<Tag> tags_;
    std::vector<Placed> placed_;
    std::vector<dem::Body> bodies_;
    std::vector<dem::Load> loads_;
};

}
