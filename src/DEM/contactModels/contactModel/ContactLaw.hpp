// SPDX-License-Identifier: GPL-3.0-or-later
//
// A contact law as the rest of the library sees it: one virtual call per list of contacts.
// The laws are composites of parts (Composite.hpp) made by newContactLaw().
#pragma once

#include "contactModels/contactModel/ContactEnergy.hpp"
#include "contactModels/contactModel/ContactScale.hpp"
#include "contactModels/contactModel/NormalResponse.hpp"
#include "contacts/ContactList.hpp"
#include "materials/ContactSettings.hpp"
#include "neighbourSearch/Periodic.hpp"
#include "particles/vector.hpp"
#include "timeIntegration/contactPeriod.hpp"

#include <memory>
#include <string>

namespace dem
{

//- The most history values that any law keeps per contact
inline constexpr int maxHistory = 10;
//- The most constants that any law keeps per contact
inline constexpr int maxConstants = 24;

struct RollingYield
{
    double moment;      // [N m]
    double energy;      // stored there [J]
};

//- Where the history holds the displacements of springs, those of sliding and rolling as vectors;
//  -1: there is no such spring
struct SpringColumns
{
    int sliding, rolling, twisting;
};

class ContactLaw
{
public:

    virtual ~ContactLaw() = default;

    //- e.g. "JKR+springDashpotSlider+springSlider+springDashpotSlider"
    virtual std::string name() const = 0;

    virtual int nConstants() const = 0;     // per contact
    virtual int nHistory() const = 0;       // per contact
    virtual bool needsSpin() const = 0;

    //- Whether stiffness and strength come from the pair's E and gamma: then chi softens it,
    //  and at gamma = 0 it is Hertz
    virtual bool elastic() const = 0;

    //- For which Tabor numbers of the real pair it holds
    virtual TaborRange taborRange() const = 0;

    //- Read the numbers of one pair of materials; returns its index in this law.
    //  Errors: inputError
    virtual int addPair(const ContactSettings& settings) = 0;

    //- Effective radius R [m] of a sphere on a curved wall from the relative curvatures
    //  1/R_1 <= 1/R_2 (normal/ellipticContact.hpp)
    virtual double effectiveRadius(double inverse1, double inverse2) const = 0;

    //- Constants of one contact of that pair
    virtual void prepare(int pair, const ContactScale& s, double* constants) const = 0;

    //- Pull-off force of a contact not loaded before [N], where it ends: at overlap
    //  = -reach [m], equilibrium radius [m]; of the pair as given, softened or real
    virtual double pullOff(int pair, const PairConstants& c, double R) const = 0;
    virtual double reach(int pair, const PairConstants& c, double R) const = 0;
    virtual double equilibriumRadius(int pair, const PairConstants& c, double R) const = 0;

    //- Without adhesion and damping, at this speed [m/s]
    virtual Impact impact(int pair, const ContactScale& s, double speed) const = 0;

    //- Where rolling yields at A = 1, R of the rolling velocity [m] (ContactScale); zeros
    //  without rolling resistance
    virtual RollingYield rollingYield(const double* constants, double R) const = 0;

    virtual SpringColumns springColumns() const = 0;

    //- Turn what the history holds in space by R, as the pair turns
    void turnHistory(const Eigen::Matrix3d& R, double* history) const
    {
        const SpringColumns at = springColumns();
        for (const int column : {at.sliding, at.rolling})
        {
            if (column < 0) continue;
            Eigen::Map<Vec3> xi(history + column);
            xi = R*Vec3(xi);
        }
    }

    //- Multiply the displacements of the sliding, rolling and twisting springs
    void scaleSprings(const double (&factors)[3], double* history) const
    {
        const SpringColumns at = springColumns();
        for (int d = 0; d < 3; ++d)
        {
            if (at.sliding >= 0) history[at.sliding + d] *= factors[0];
            if (at.rolling >= 0) history[at.rolling + d] *= factors[1];
        }
        if (at.twisting >= 0) history[at.twisting] *= factors[2];
    }

    //- The normal part alone; `history` holds the contact's history values and is moved on
    virtual NormalResponse<double> normalResponse
    (
        const double* constants, double overlap, double* history
    ) const = 0;

    //- Energies of contact k, whose springs are ahead by the slip time `ahead` [s]
    virtual ContactEnergy energy
    (
        const ContactList& list, std::size_t k, const Body* bodies, double ahead,
        const Periodic& periodic
    ) const = 0;

    //- Contact begins at overlap = -touchDistance [m]: 0 but for laws that act at a distance
    virtual double touchDistance(int pair, const PairConstants& c) const = 0;

    //- What the contact step is made of (timeIntegration/contactPeriod.hpp), at this overlap
    //  [m] and normal speed [m/s]; turning = (r_i/I_i + r_j/I_j)/2 [1/(kg m)]
    virtual ContactBound bound
    (
        int pair, const ContactScale& s, const double* constants, const double* history,
        double turning, double overlap, double speed
    ) const = 0;

    //- Add the loads of contacts [begin, end) to the bodies, times sign; springs move on as
    //  `step` says. Sets ended[k] where a contact has come to its end and returns whether
    //  any has.
    virtual bool evaluatePairs
    (
        ContactList& list, std::size_t begin, std::size_t end,
        const Body* bodies, Load* loads, const SpringStep& step, double sign,
        const Periodic& periodic
    ) const = 0;

    virtual bool evaluateWalls
    (
        ContactList& list, std::size_t begin, std::size_t end,
        const Body* bodies, Load* loads, const SpringStep& step, double sign
    ) const = 0;
};

//- Errors: inputError on unknown models or parts that cannot be combined
std::unique_ptr<ContactLaw> newContactLaw(const ContactSettings& settings);

}
