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

#include "restitutionFit.H"
#include "dustProperties.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Lowest point of f by the simplex method of Nelder & Mead, in two dimensions
static std::array<scalar, 2> lowest
(
    const std::function<scalar(const std::array<scalar, 2>&)>& f,
    const std::array<scalar, 2>& start,
    const std::array<scalar, 2>& size
)
{
    using point = std::array<scalar, 2>;
    struct corner { point x; scalar y; };
    std::array<corner, 3> s
    {{
        {start, f(start)},
        {{start[0] + size[0], start[1]}, f({start[0] + size[0], start[1]})},
        {{start[0], start[1] + size[1]}, f({start[0], start[1] + size[1]})}
    }};

    for (int k = 0; k < 400; ++k)
    {
        std::sort
        (
            s.begin(), s.end(),
            [](const corner& a, const corner& b) { return a.y < b.y; }
        );
        const scalar extent = std::max
        (
            std::fabs(s[2].x[0] - s[0].x[0]), std::fabs(s[2].x[1] - s[0].x[1])
        );
        if (extent < 1e-10) break;

        // from the worst corner through the middle of the others
        const auto along = [&](const scalar c)
        {
            point x;
            for (int d = 0; d < 2; ++d)
            {
                const scalar middle = 0.5*(s[0].x[d] + s[1].x[d]);
                x[d] = middle + c*(s[2].x[d] - middle);
            }
            return corner{x, f(x)};
        };
        const corner reflected = along(-1);
        if (reflected.y < s[0].y)
        {
            const corner expanded = along(-2);
            s[2] = expanded.y < reflected.y ? expanded : reflected;
        }
        else if (reflected.y < s[1].y)
        {
            s[2] = reflected;
        }
        else
        {
            const corner contracted = along(reflected.y < s[2].y ? -0.5 : 0.5);
            if (contracted.y < std::min(reflected.y, s[2].y))
            {
                s[2] = contracted;
            }
            else
            {
                for (int c = 1; c < 3; ++c)
                {
                    for (int d = 0; d < 2; ++d)
                    {
                        s[c].x[d] = 0.5*(s[0].x[d] + s[c].x[d]);
                    }
                    s[c].y = f(s[c].x);
                }
            }
        }
    }
    return s[0].x;
}

} // End namespace Foam


// * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::scalar Foam::restitutionFit::through
(
    const scalar alpha,
    const calibrationSettings::measurement& p
) const
{
    const scalar V = curve_.velocityOf(alpha, p.e);
    return V > 0 ? settings_.velocityFactor()*p.v/V : -1;
}


Foam::scalar Foam::restitutionFit::squares
(
    const scalar alpha,
    const scalar X
) const
{
    const scalar factor = settings_.velocityFactor();
    scalar sum = 0;
    for (const calibrationSettings::measurement& p : settings_.points)
    {
        if (p.e > 0)
        {
            sum += sqr(curve_.collide(alpha, factor*p.v/X).restitution - p.e);
        }
    }
    return sum;
}


void Foam::restitutionFit::fitAdhesion
(
    const calibrationSettings::measurement& slow
)
{
    X_ = through(alpha_, slow);
    if (X_ < 0 || settings_.fitPoint.v > 0)
    {
        return;
    }
    // one unknown; the second dimension is idle
    const auto best = lowest
    (
        [&](const std::array<scalar, 2>& x)
        {
            return squares(alpha_, std::exp(x[0])) + sqr(x[1]);
        },
        {std::log(X_), 0}, {0.05, 1e-3}
    );
    X_ = std::exp(best[0]);
}


void Foam::restitutionFit::fitDamping(const scalar guess)
{
    const scalar alphaMost = scaledCollision::alphaOf(0.01);
    const auto best = lowest
    (
        [&](const std::array<scalar, 2>& x)
        {
            if (x[0] < 0 || x[0] > alphaMost)
            {
                return scalar(1e3);
            }
            const scalar X = through(x[0], settings_.fitPoint);
            return X > 0 ? squares(x[0], X) + sqr(x[1]) : scalar(1e3);
        },
        {guess, 0}, {0.1*guess, 1e-3}
    );
    alpha_ = best[0];
    X_ = through(alpha_, settings_.fitPoint);
}


void Foam::restitutionFit::fitBoth
(
    const scalar guess,
    const calibrationSettings::measurement& slow
)
{
    X_ = through(guess, slow);
    if (X_ < 0)
    {
        return;
    }
    const scalar alphaMost = scaledCollision::alphaOf(0.01);
    const auto best = lowest
    (
        [&](const std::array<scalar, 2>& x)
        {
            return
                x[0] < 0 || x[0] > alphaMost
              ? scalar(1e3)
              : squares(x[0], std::exp(x[1]));
        },
        {guess, std::log(X_)}, {0.2*guess, 0.05}
    );
    alpha_ = best[0];
    X_ = std::exp(best[1]);
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::restitutionFit::restitutionFit
(
    const dictionary& dict,
    const calibrationSettings& settings,
    const scaledCollision& curve
)
:
    settings_(settings),
    curve_(curve),
    alpha_(0),
    X_(0)
{
    const bool onePoint = settings.fitPoint.v > 0;

    // The points that determine: the slowest rebound feels adhesion most, the
    // highest restitution is next to the plateau
    calibrationSettings::measurement slow = settings.fitPoint;
    scalar highest = settings.plateau;
    for (const calibrationSettings::measurement& p : settings.points)
    {
        if (p.e > 0 && !onePoint && (!(slow.v > 0) || p.v < slow.v))
        {
            slow = p;
        }
        highest = std::max(highest, p.e);
    }
    if (slow.e >= highest)
    {
        dustProperties::error
        (
            dict,
            onePoint ? "fitPoint" : "points",
            "the restitution " + Foam::name(slow.e) + " of the point that shall"
            " give the adhesion is not below the plateau",
            "a slower impact, whose restitution adhesion makes lower than "
          + Foam::name(highest)
        );
    }

    // The plateau is a little above the highest restitution
    const scalar guess =
        scaledCollision::alphaOf(highest + 0.2*(1 - highest));

    if (settings.plateau > 0)
    {
        alpha_ = scaledCollision::alphaOf(settings.plateau);
        fitAdhesion(slow);
    }
    else if (onePoint)
    {
        fitDamping(guess);
    }
    else
    {
        fitBoth(guess, slow);
    }

    if (!(X_ > 0))
    {
        dustProperties::error
        (
            dict,
            onePoint ? "fitPoint" : "points",
            "no adhesion gives a restitution of " + Foam::name(slow.e),
            "a restitution well between 0 and that of fast impacts"
        );
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::restitutionFit::gamma(const scalar E) const
{
    return std::pow(X_, 1.2)*std::pow(E, 0.4);
}


Foam::scalar Foam::restitutionFit::restitution(const scalar v) const
{
    return
        curve_.collide(alpha_, settings_.velocityFactor()*v/X_).restitution;
}


Foam::scalar Foam::restitutionFit::sticking() const
{
    return curve_.sticking(alpha_)*X_/settings_.velocityFactor();
}


Foam::scalar Foam::restitutionFit::softModulus() const
{
    // Peak overlap at given X: q a0^2/R, a0^2 = (9 pi R^2 gamma/E)^(2/3), and
    // gamma/E = X^(6/5) E^(-3/5); so it goes as E^(-2/5)
    const calibrationSettings& s = settings_;
    const scalar peak = curve_.collide
    (
        alpha_, s.velocityFactor()*s.highestVelocity/X_
    ).peak;
    const scalar areaAtOnePascal = std::pow
    (
        9*constant::mathematical::pi*sqr(s.R())*gamma(1), 2.0/3.0
    );
    return std::pow
    (
        peak*areaAtOnePascal/s.R()/(2*s.radius*s.overlapLimit), 2.5
    );
}



// ************************************************************************* //
