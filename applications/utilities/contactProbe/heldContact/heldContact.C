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

#include "heldContact.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::heldContact::motionType>
Foam::heldContact::motionNames
({
    { motionType::SLIDING, "sliding" },
    { motionType::ROLLING, "rolling" },
    { motionType::TWISTING, "twisting" },
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

dem::MaterialTable Foam::heldContact::undamped(const contactPair& pair)
{
    const auto& materials = pair.table().materials();
    const int i = pair.pair().i, j = pair.pair().j;

    std::vector<dem::Material> both{materials[std::size_t(i)]};
    if (j != i)
    {
        both.push_back(materials[std::size_t(j)]);
    }

    dem::ContactSettings s = pair.settings();
    for (dem::PartSettings* part : {&s.normal, &s.tangential, &s.rolling, &s.twisting})
    {
        for (auto& value : part->values)
        {
            // of cohesivePlastic, restitution is a stiffness
            if (value.first == "restitution" && part->model != "cohesivePlastic")
            {
                value.second = 1;
            }
            else if
            (
                value.first == "dampingCoefficient"
             || value.first == "dampingRatio"
             || value.first == "rollingDamping"
             || value.first == "twistingDamping"
            )
            {
                value.second = 0;
            }
        }
    }

    // for this pair only: the others keep away from it
    return dem::MaterialTable
    (
        both,
        s,
        {},
        pair.table().softening()
    );
}


void Foam::heldContact::release()
{
    system_ = pair_.newSystem(table_, 0, table_.materials().size() > 1 ? 1 : 0);
    bool touching;
    press(-pair_.touchGap() + 1e-12*pair_.radius(), touching);
}


void Foam::heldContact::move
(
    const motionType motion,
    const scalar overlap,
    const scalar displacement
)
{
    const scalar r = pair_.radius();
    // two spheres must not be shifted so far that the overlap changes
    const scalar longest = 1e-5*r;
    const label parts =
        motion == TWISTING ? 1 : label(std::fabs(displacement)/longest) + 1;
    const scalar rate = displacement/parts/interval_;

    for (label k = 0; k < parts; ++k)
    {
        dem::Vec3 v = dem::Vec3::Zero(), omegaI = v, omegaJ = v;
        switch (motion)
        {
            case SLIDING:
                v.x() = rate;
                break;

            case ROLLING:
                // without slip; the rolling velocity is r omega x n along x
                omegaI.y() = -rate/r;
                if (pair_.pair().wall) v.x() = -rate;
                else omegaJ.y() = rate/pair_.partnerRadius();
                break;

            case TWISTING:
                omegaI.z() = -rate;
                break;
        }
        pair_.place(*system_, -overlap, v, omegaI, omegaJ);
        system_->advance(interval_);
    }
}


Foam::scalar Foam::heldContact::load
(
    const motionType motion,
    const scalar overlap
)
{
    bool touching;
    press(overlap, touching);

    const dem::Particle& p = system_->particle(0);
    const dem::Vec3 force = p.mass/interval_*p.v;
    const dem::Vec3 torque = 0.4*p.mass*p.radius*p.radius/interval_*p.omega;

    switch (motion)
    {
        case SLIDING:
            return -force.x();

        case ROLLING:
            // torque = r n x F - n x M with n = -z, M along x
            return torque.y() + p.radius*force.x();

        case TWISTING:
        default:
            return torque.z();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::heldContact::heldContact(const contactPair& pair, const scalar speed)
:
    pair_(pair),
    table_(undamped(pair)),
    system_(),
    interval_(0),
    highest_(0)
{
    const dem::ContactFigures f = pair.figures(speed);
    // the laws end long before the spheres have swallowed each other
    highest_ = std::min(f.impactOverlap + 3*f.delta0, 0.5*pair.smallerRadius());
    interval_ = 1e-5*f.period;
    release();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::heldContact::press(const scalar overlap, bool& touching)
{
    pair_.place(*system_, -overlap, dem::Vec3::Zero());
    system_->advance(interval_);
    touching = system_->inContact(0);
    const dem::Particle& p = system_->particle(0);
    return p.mass/interval_*p.v.z();
}


Foam::scalar Foam::heldContact::equilibrium()
{
    const auto fresh = [this](const scalar overlap)
    {
        bool touching;
        release();
        return press(overlap, touching);
    };

    scalar low = 1e-12*pair_.radius(), high = highest_;
    if (fresh(low) >= 0 || fresh(high) <= 0)
    {
        return 0.5*highest_;
    }
    for (int k = 0; k < 50; ++k)
    {
        const scalar middle = 0.5*(low + high);
        (fresh(middle) < 0 ? low : high) = middle;
    }
    return high;
}


Foam::heldContact::resistance Foam::heldContact::limit(const motionType motion)
{
    // a part that is off would leave round-off
    const dem::ContactSettings& s = pair_.settings();
    const std::string& model =
        motion == SLIDING ? s.tangential.model
      : motion == ROLLING ? s.rolling.model
      : s.twisting.model;
    if (model == "none")
    {
        return resistance();
    }

    const scalar overlap = equilibrium();
    bool touching;
    release();
    press(overlap, touching);

    const scalar unit = motion == TWISTING ? 1 : pair_.radius();
    scalar step = 1e-9*unit;
    move(motion, overlap, step);

    resistance r;
    scalar now = load(motion, overlap);
    r.stiffness = now/step;
    if (!(r.stiffness > 0))
    {
        return resistance();
    }

    for (scalar total = step; total < 0.2*unit; total += step)
    {
        const scalar before = now;
        step = 0.5*total;
        move(motion, overlap, step);
        now = load(motion, overlap);

        if (now - before < 1e-3*r.stiffness*step)
        {
            r.limit = now;
            r.displacement = now/r.stiffness;
            break;
        }
    }
    return r;
}


std::vector<Foam::heldContact::point> Foam::heldContact::cycle
(
    const motionType motion,
    const scalar range,
    const label points
)
{
    const scalar overlap = equilibrium();
    bool touching;
    release();
    press(overlap, touching);

    std::vector<point> curve{{0, load(motion, overlap)}};
    scalar now = 0;
    for (const scalar to : {range, -range, range})
    {
        const scalar step = (to - now)/points;
        for (label k = 1; k <= points; ++k)
        {
            move(motion, overlap, step);
            curve.push_back({now + k*step, load(motion, overlap)});
        }
        now = to;
    }
    return curve;
}


// ************************************************************************* //
