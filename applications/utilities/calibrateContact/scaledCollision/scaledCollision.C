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

#include "scaledCollision.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// s = A^(1/2) at the neck's end, where the slope of q(s) vanishes
static const scalar sEnd = 1/std::cbrt(scalar(6));
static const scalar qEnd = -0.5*sEnd;


//- The largest root s of s^4 - (2/3) s = q. The double root at the neck's end
//  is divided out: with u = s - sEnd, q - qEnd = u^2 ((u + 2 sEnd)^2 + 2 sEnd^2)
static scalar rootOf(const scalar q)
{
    const scalar w = std::sqrt(std::max(q - qEnd, scalar(0)));
    scalar u = w > 1 ? std::sqrt(w) : w/(std::sqrt(scalar(6))*sEnd);
    for (int k = 0; k < 50; ++k)
    {
        // Newton on u B^(1/2) = w
        const scalar x = u + 2*sEnd;
        const scalar root = std::sqrt(x*x + 2*sEnd*sEnd);
        const scalar du = (u*root - w)/(root + u*x/root);
        u -= du;
        if (std::fabs(du) <= 1e-15*(u + sEnd)) break;
    }
    return u + sEnd;
}


struct motion
{
    scalar q, u;
};


//- One step of Dormand & Prince 5(4); returns the error in units of the scales
template<class Rate>
static scalar attempt
(
    const Rate& rate,
    const motion& y,
    const scalar h,
    const scalar scaleQ,
    const scalar scaleU,
    motion& next
)
{
    static const scalar a[7][6] =
    {
        {},
        {1.0/5},
        {3.0/40, 9.0/40},
        {44.0/45, -56.0/15, 32.0/9},
        {19372.0/6561, -25360.0/2187, 64448.0/6561, -212.0/729},
        {9017.0/3168, -355.0/33, 46732.0/5247, 49.0/176, -5103.0/18656},
        {35.0/384, 0, 500.0/1113, 125.0/192, -2187.0/6784, 11.0/84}
    };
    static const scalar b4[7] =
    {
        5179.0/57600, 0, 7571.0/16695, 393.0/640, -92097.0/339200,
        187.0/2100, 1.0/40
    };

    scalar kq[7], ku[7];
    motion z = y;
    for (int s = 0; s < 7; ++s)
    {
        z = y;
        for (int r = 0; r < s; ++r)
        {
            z.q += h*a[s][r]*kq[r];
            z.u += h*a[s][r]*ku[r];
        }
        kq[s] = z.u;
        ku[s] = rate(z);
    }
    next = z;       // the last stage is the fifth-order result

    motion low = y;
    for (int s = 0; s < 7; ++s)
    {
        low.q += h*b4[s]*kq[s];
        low.u += h*b4[s]*ku[s];
    }
    return std::max
    (
        std::fabs(next.q - low.q)/scaleQ,
        std::fabs(next.u - low.u)/scaleU
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scaledCollision::result Foam::scaledCollision::collide
(
    const scalar alpha,
    const scalar V
) const
{
    const scalar end = neck_ ? qEnd : 0;

    const auto rate = [&](const motion& y)
    {
        const scalar q = std::max(y.q, end);
        const scalar s = rootOf(q);
        const scalar s3 = s*s*s;
        const scalar damping = neck_ ? s : std::sqrt(std::sqrt(q));
        return -(s3*s3 - s3) - alpha*damping*y.u;
    };

    // Hertz: the peak goes as V^(4/5); its order is enough here
    const scalar scaleQ = 1 + std::pow(V, 0.8);
    const scalar tolerance = 1e-11;
    const scalar time = scaleQ/V;
    const scalar smallest = 1e-14*time;

    motion y{0, V};
    scalar h = 1e-6*time;
    result r{0, 0};
    bool opened = false;

    while (true)
    {
        motion next;
        const scalar error = attempt(rate, y, h, scaleQ, V, next);
        if (error > tolerance && h > smallest)
        {
            h = std::max(smallest, h*std::max(0.2, 0.9*std::pow(tolerance/error, 0.2)));
            continue;
        }
        const bool left = next.u < 0 && next.q < end;
        if (left && h > smallest && end - next.q > 1e-13*scaleQ)
        {
            // close in on the end, as far as round-off lets one see it
            h = std::max(smallest, 0.5*h);
            continue;
        }

        r.peak = std::max(r.peak, next.q);
        if (y.u > 0 && next.u < 0)
        {
            // largest q of the parabola through the turning point
            r.peak = std::max(r.peak, y.q + 0.5*h*y.u*y.u/(y.u - next.u));
        }
        y = next;

        if (left)
        {
            r.restitution = -y.u/V;
            return r;
        }
        opened = opened || y.u < 0;
        const bool creeps =
            std::fabs(y.u) < 1e-9*V && std::fabs(rate(y)) < 1e-9;
        if ((opened && y.u > 0) || creeps)
        {
            return r;       // turned back inside: held
        }

        h *= std::min(3.0, 0.9*std::pow(tolerance/std::max(error, scalar(1e-30)), 0.2));
        h = std::max(smallest, std::min(h, 0.05*time));
    }
}


Foam::scalar Foam::scaledCollision::sticking(const scalar alpha) const
{
    if (!neck_ && alpha <= 0)
    {
        return 0;
    }
    scalar low = 1e-4, high = 1;
    while (collide(alpha, high).restitution <= 0)
    {
        low = high;
        high *= 2;
    }
    while (high - low > 1e-12*high)
    {
        const scalar middle = 0.5*(low + high);
        (collide(alpha, middle).restitution > 0 ? high : low) = middle;
    }
    return high;
}


Foam::scalar Foam::scaledCollision::velocityOf
(
    const scalar alpha,
    const scalar restitution
) const
{
    if (restitution >= plateauOf(alpha))
    {
        return -1;
    }
    // e grows with V
    scalar low = sticking(alpha), high = std::max(2*low, scalar(1));
    while (collide(alpha, high).restitution < restitution)
    {
        low = high;
        high *= 2;
        if (high > 1e9)
        {
            return -1;
        }
    }
    while (high - low > 1e-12*high)
    {
        const scalar middle = 0.5*(low + high);
        (collide(alpha, middle).restitution < restitution ? low : high) = middle;
    }
    return 0.5*(low + high);
}


Foam::scalar Foam::scaledCollision::alphaOf(const scalar restitution)
{
    const scalar l = std::log(restitution);
    const scalar pi = constant::mathematical::pi;
    return std::sqrt(scalar(5))*std::fabs(l)/std::sqrt(l*l + pi*pi);
}


Foam::scalar Foam::scaledCollision::plateauOf(const scalar alpha)
{
    const scalar beta = alpha/std::sqrt(scalar(5));
    return std::exp
    (
        -constant::mathematical::pi*beta/std::sqrt(1 - beta*beta)
    );
}


Foam::scalar Foam::scaledCollision::VofAstar(const scalar A)
{
    return 1/(3*std::cbrt(9*constant::mathematical::pi)*A);
}


Foam::scalar Foam::scaledCollision::Astar(const scalar V)
{
    return VofAstar(V);     // its own inverse
}


// ************************************************************************* //
