/*---------------------------------------------------------------------------*\
    dustFoam: adhesive dust in ventilation ducts
-------------------------------------------------------------------------------
License
    This file is part of dustFoam.

    dustFoam is free software: you can redistribute it and/or modify it under
    the terms of the GNU General Public License as published by the Free
    Software Foundation, either version 3 of the License, or (at your option)
    any later version.

    dustFoam is distributed in the hope that it will be useful, but WITHOUT ANY
    WARRANTY; without even the implied warranty of MERCHANTABILITY or FITNESS
    FOR A PARTICULAR PURPOSE.  See the GNU General Public License for more
    details.

    You should have received a copy of the GNU General Public License along
    with dustFoam.  If not, see <http://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/

#include "contactPair.H"
#include "contactSteps.H"
#include "heldContact.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::contactPair::outcomeType>
Foam::contactPair::outcomeNames
({
    { outcomeType::REBOUND, "rebound" },
    { outcomeType::STICK, "stick" },
    { outcomeType::ROLL, "roll" },
    { outcomeType::SLIDE, "slide" },
    { outcomeType::REFUSED, "refused" },
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// See contactPair.H
static constexpr scalar rockingPeriods = 3;
static constexpr scalar normalPeriods = 20;
static constexpr scalar netOfPath = 0.5;
static constexpr scalar smallestNet = 1e-3;
static constexpr int steadyWindows = 10;
static constexpr int mostWindows = 50;

// Looks at the motion per shortest period of the contact; more for its history
static constexpr scalar looksPerPeriod = 25;
static constexpr scalar historyPerPeriod = 200;


static scalar sphereMass
(
    const dem::MaterialTable& table,
    const int material,
    const scalar r
)
{
    return
        table.materials()[std::size_t(material)].density
       *4.0/3.0*constant::mathematical::pi*r*r*r;
}


//- Largest overlap between two looks: of the cubic through both
static scalar peakBetween
(
    const scalar d0,
    const scalar v0,
    const scalar d1,
    const scalar v1,
    const scalar h
)
{
    scalar peak = std::max(d0, d1);
    if (v0 > 0 && v1 < 0)
    {
        // slope of the cubic: v0 + 2 b s + 3 c s^2, s from 0 to 1
        const scalar b = 3*(d1 - d0) - h*(2*v0 + v1);
        const scalar c = 2*(d0 - d1) + h*(v0 + v1);
        const scalar root = std::sqrt(std::max(b*b - 3*c*h*v0, scalar(0)));
        // v0 > 0 and v1 < 0: one root between, in the form without cancellation
        const scalar s = h*v0/(-b + root);
        if (s > 0 && s < 1)
        {
            peak = std::max(peak, d0 + s*(h*v0 + s*(b + s*c)));
        }
    }
    return peak;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::contactPair::state Foam::contactPair::look
(
    const dem::System& system
) const
{
    const dem::Particle& a = system.particle(0);
    state s;
    dem::Vec3 arm = ri_*a.omega, spin = a.omega;
    scalar skew = -0.5;
    s.v = a.v;

    if (pair_.wall)
    {
        s.n = -dem::Vec3::UnitZ();
        s.gap = a.x.z() - ri_;
    }
    else
    {
        const dem::Particle& b = system.particle(1);
        s.n = b.x - a.x;
        const scalar distance = s.n.norm();
        s.n /= distance;
        s.gap = distance - ri_ - rj_;
        s.v -= b.v;
        arm += rj_*b.omega;
        spin -= b.omega;
        skew = 0.5*(ri_ - rj_)/(ri_ + rj_);
    }

    // in the plane of the impact
    s.t = s.n.cross(dem::Vec3::UnitY());
    s.closing = s.v.dot(s.n);
    s.slip = (s.v + arm.cross(s.n)).dot(s.t);
    s.roll = rollingRadius()*spin.cross(s.n).dot(s.t) + skew*s.slip;
    return s;
}


Foam::scalar Foam::contactPair::rockingPeriod() const
{
    if (rockingPeriod_ < 0)
    {
        const scalar k =
            heldContact(*this, 0).limit(heldContact::ROLLING).stiffness;

        // The longest of the modes: a sphere that rolls to and fro on a wall
        rockingPeriod_ =
            k > 0
          ? constant::mathematical::twoPi
           *std::sqrt(1.4*mi_*ri_*ri_/(k*rollingRadius()))
          : 0;
    }
    return rockingPeriod_;
}


Foam::scalar Foam::contactPair::watch() const
{
    return std::max
    (
        rockingPeriods*rockingPeriod(), normalPeriods*figures(0).period
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::contactPair::contactPair
(
    const dem::MaterialTable& table,
    const dem::TimeSettings& time,
    const probeSettings::pair& pair,
    const scalar diameter,
    const scalar partnerDiameter
)
:
    table_(table),
    time_{time.stepsPerContact, 0, time.islands},
    pair_(pair),
    ri_(0.5*diameter),
    rj_(pair.wall ? 0 : 0.5*partnerDiameter),
    mi_(sphereMass(table, pair.i, ri_)),
    mj_(sphereMass(table, pair.j, rj_)),
    rockingPeriod_(-1)
{
    newSystem(table_, pair_.i, pair_.j);    // refuses walls too hollow for it
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::contactPair::tangential() const
{
    return
        settings().tangential.model != "none"
     || settings().rolling.model != "none";
}


std::unique_ptr<dem::System> Foam::contactPair::newSystem
(
    const dem::MaterialTable& table,
    const int i,
    const int j
) const
{
    auto system = std::make_unique<dem::System>(table, time_);

    if (pair_.wall)
    {
        dem::Walls walls;
        walls.patches.push_back
        (
            {table.materials()[std::size_t(j)].name, j, pair_.curvature}
        );
        walls.planes.push_back({dem::Vec3::Zero(), dem::Vec3::UnitZ(), 0});
        system->setWalls(walls);
    }

    // far apart: place() puts them where they belong
    dem::Particle p;
    p.id = 0;
    p.material = i;
    p.radius = ri_;
    p.mass = mi_;
    p.x = 10*ri_*dem::Vec3::UnitZ();
    system->add(p);
    if (!pair_.wall)
    {
        p.id = 1;
        p.material = j;
        p.radius = rj_;
        p.mass = mj_;
        p.x = -10*rj_*dem::Vec3::UnitZ();
        system->add(p);
    }
    return system;
}


void Foam::contactPair::place
(
    dem::System& system,
    const scalar gap,
    const dem::Vec3& relativeVelocity,
    const dem::Vec3& omegaI,
    const dem::Vec3& omegaJ
) const
{
    const scalar distance = ri_ + rj_ + gap;
    const scalar shareI = pair_.wall ? 1 : mj_/(mi_ + mj_);
    const scalar shareJ = 1 - shareI;

    system.setMotion
    (
        0,
        shareI*distance*dem::Vec3::UnitZ(),
        shareI*relativeVelocity,
        omegaI
    );
    if (!pair_.wall)
    {
        system.setMotion
        (
            1,
            -shareJ*distance*dem::Vec3::UnitZ(),
            -shareJ*relativeVelocity,
            omegaJ
        );
    }
}


Foam::contactPair::collision Foam::contactPair::collide
(
    const scalar speed,
    const scalar angle,
    const scalar force,
    const scalar duration,
    std::vector<moment>* history
) const
{
    const scalar vn = speed*std::cos(angle);
    const dem::ContactFigures f = figures(vn);
    const scalar touch = touchGap();

    // The contact ends at this gap
    const scalar endGap = std::max(f.deltaC, touch);

    // A whole number of contact steps between two looks
    const scalar step = f.period/time_.stepsPerContact;
    const scalar looks = history ? historyPerPeriod : looksPerPeriod;
    const scalar h =
        step*std::max(scalar(1), std::floor(time_.stepsPerContact/looks));

    // Just in contact, by a length that scales with the collision's own, so that
    // softened contacts go through the very same motion
    const scalar inside = std::max
    (
        1e-9*(f.impactOverlap + f.delta0), 4e-16*(ri_ + rj_)
    );
    auto system = newSystem(table_, pair_.i, pair_.j);
    place
    (
        *system,
        touch - inside,
        dem::Vec3(speed*std::sin(angle), 0, -vn)
    );

    collision result;
    state before = look(*system);
    scalar t = 0, slipPath = 0, rollPath = 0;
    bool opened = false, held = false;

    // Of the window of a held contact
    scalar window = 0, windowStart = 0;
    scalar netSlip = 0, netRoll = 0, pathSlip = 0, pathRoll = 0;
    scalar tangentialSpeed = 0;
    int windows = 0, steady = 0;

    const auto note = [&](const state& s)
    {
        if (!history)
        {
            return;
        }
        scalar push = 0;
        for (const dem::ContactView& c : system->contacts())
        {
            push -= c.force.dot(c.normal);
        }
        history->push_back({t, -s.gap, s.closing, push, slipPath, rollPath});
    };
    note(before);

    const auto noteTangential = [&](const state& s, const dem::Vec3& v)
    {
        if (angle > 0)
        {
            result.tangentialRestitution =
                v.dot(s.t)/(speed*std::sin(angle));
        }
        result.spin = system->particle(0).omega.dot(s.t.cross(s.n));
    };

    while (true)
    {
        if (force > 0)
        {
            dem::GasLoad load;
            load.Su = force*before.t;
            system->setGasLoad(0, load);
            if (!pair_.wall)
            {
                load.Su = -force*before.t;
                system->setGasLoad(1, load);
            }
        }

        try
        {
            system->advance(h);
        }
        catch (const dem::numericalError& e)
        {
            result = collision();
            result.outcome = REFUSED;
            result.reason = e.what();
            result.restitution = result.contactTime = result.maxOverlap =
                result.tangentialRestitution = result.spin =
                result.reboundAngle = std::nan("");
            return result;
        }
        t += h;
        contactSteps::taken(h/step);
        const state now = look(*system);

        if (!system->inContact(0))
        {
            // Back along the free flight to where the contact ended
            const dem::Vec3 a =
                force*(1/mi_ + (pair_.wall ? 0 : 1/mj_))*before.t;
            const dem::Vec3 x = (ri_ + rj_ + now.gap)*(-now.n);
            const auto gapBefore = [&](const scalar s)
            {
                const dem::Vec3 d = x - s*now.v + 0.5*s*s*a;
                return (pair_.wall ? d.z() : d.norm()) - ri_ - rj_;
            };
            scalar low = 0, high = h;
            for (int k = 0; k < 100; ++k)
            {
                const scalar s = 0.5*(low + high);
                (gapBefore(s) > endGap ? low : high) = s;
            }
            result.outcome = REBOUND;
            result.contactTime = t - low;
            result.restitution =
                std::max(scalar(0), -(now.v - low*a).dot(now.n))/vn;
            noteTangential(now, now.v - low*a);
            result.reboundAngle = std::atan2
            (
                angle > 0 ? (now.v - low*a).dot(now.t) : scalar(0),
                result.restitution*vn
            );
            // a fast impact may be over before the second look
            result.maxOverlap = std::max(result.maxOverlap, -before.gap);
            if (history)
            {
                // the very end
                history->push_back
                ({
                    result.contactTime, -endGap, (now.v - low*a).dot(now.n),
                    0, slipPath, rollPath
                });
            }
            break;
        }

        result.maxOverlap = std::max
        (
            result.maxOverlap,
            peakBetween(-before.gap, before.closing, -now.gap, now.closing, h)
        );
        const scalar slip = 0.5*h*(before.slip + now.slip);
        const scalar roll = 0.5*h*(before.roll + now.roll);
        slipPath += slip;
        rollPath += roll;
        note(now);

        // Turned back without having left: its energy can only fall, so the
        // normal motion is bound. (Or it creeps, as heavily damped ones do.)
        opened = opened || now.closing < 0;
        const bool creeps =
            std::fabs(before.closing) < 1e-5*vn
         && std::fabs(now.closing) < 1e-5*vn;
        if (!held && ((opened && now.closing > 0) || creeps))
        {
            held = true;
            result.contactTime = t;

            if ((angle == 0 && force == 0) || !(f.a0 > 0))
            {
                break;
            }
            window = watch();
            windowStart = t;
            tangentialSpeed = 0;
        }
        else if (held)
        {
            result.contactTime = t;
            netSlip += slip;
            netRoll += roll;
            pathSlip += std::fabs(slip);
            pathRoll += std::fabs(roll);

            const bool last = duration > 0 && t >= duration;
            if (t - windowStart >= window || last)
            {
                const auto goesOn = [&](const scalar net, const scalar path)
                {
                    return
                        std::fabs(net) > netOfPath*path
                     && std::fabs(net) > smallestNet*f.a0;
                };
                const bool slides = goesOn(netSlip, pathSlip);
                const bool rolls = goesOn(netRoll, pathRoll);
                result.outcome = slides ? SLIDE : rolls ? ROLL : STICK;

                // creep of a stressed contact while it rolls is not sliding
                if (slides && rolls && std::fabs(netSlip) < 0.01*std::fabs(netRoll))
                {
                    result.outcome = ROLL;
                }

                const scalar drift = (std::fabs(netSlip) + std::fabs(netRoll))/window;
                steady = drift >= 0.999*tangentialSpeed ? steady + 1 : 0;
                tangentialSpeed = drift;
                ++windows;

                if
                (
                    result.outcome == STICK || last || steady > steadyWindows
                 || (duration <= 0 && windows >= mostWindows)
                )
                {
                    break;
                }
                windowStart = t;
                netSlip = netRoll = pathSlip = pathRoll = 0;
            }
        }

        before = now;
    }

    if (result.outcome != REBOUND)
    {
        const state end = look(*system);
        noteTangential(end, end.v);
    }
    return result;
}


Foam::scalar Foam::contactPair::mostSteps
(
    const scalar speed,
    const scalar angle,
    const scalar force,
    const scalar duration
) const
{
    const dem::ContactFigures f = figures(speed*std::cos(angle));
    const bool watched = (angle > 0 || force > 0) && f.a0 > 0;
    const scalar held =
        !watched ? 0 : duration > 0 ? duration : mostWindows*watch();

    return time_.stepsPerContact*(1 + held/f.period);
}


Foam::scalar Foam::contactPair::stickingSpeed(const scalar tolerance) const
{
    const dem::ContactFigures f = figures(0);
    const scalar pull = f.pullOff;
    if (!(pull > 0))
    {
        return 0;
    }
    const scalar start = std::sqrt(pull*f.delta0/f.m);
    const auto sticks = [this](const scalar v)
    {
        return collide(v).outcome != REBOUND;
    };

    scalar low = start, high = start;
    if (sticks(start))
    {
        do
        {
            low = high;
            high *= 2;
            if (high > 1e6*start) return -1;
            const outcomeType outcome = collide(high).outcome;
            if (outcome == REFUSED)
            {
                return -1;      // deeper than any law goes, and still held
            }
            if (outcome == REBOUND) break;
        } while (true);
    }
    else
    {
        do
        {
            high = low;
            low *= 0.5;
            if (low < 1e-6*start) return 0;
        } while (!sticks(low));
    }
    while (high - low > tolerance*high)
    {
        const scalar middle = 0.5*(low + high);
        (sticks(middle) ? low : high) = middle;
    }
    return 0.5*(low + high);
}


// ************************************************************************* //
