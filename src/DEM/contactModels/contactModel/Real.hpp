// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact laws are written once, for a number type Real: double, or Pack, which is as many
// contacts side by side as the processor computes at once. So a law has no `if` on values:
// select(condition, a, b) evaluates both and picks per contact; both sides must be safe to
// evaluate (no division by zero, no root of a negative number: OpenFOAM traps them).
#pragma once

#include <cmath>
#include <experimental/simd>

namespace dem
{

using Pack = std::experimental::native_simd<double>;

inline constexpr int packWidth = int(Pack::size());

[[gnu::always_inline]] inline double select(bool c, double a, double b) { return c ? a : b; }

[[gnu::always_inline]] inline Pack select(const Pack::mask_type& c, const Pack& a, const Pack& b)
{
    Pack r = b;
    std::experimental::where(c, r) = a;
    return r;
}

[[gnu::always_inline]] inline double maximum(double a, double b) { return a > b ? a : b; }
[[gnu::always_inline]] inline Pack maximum(const Pack& a, const Pack& b)
{
    return std::experimental::max(a, b);
}

[[gnu::always_inline]] inline double minimum(double a, double b) { return a < b ? a : b; }
[[gnu::always_inline]] inline Pack minimum(const Pack& a, const Pack& b)
{
    return std::experimental::min(a, b);
}

[[gnu::always_inline]] inline double squareRoot(double a) { return std::sqrt(a); }
[[gnu::always_inline]] inline Pack squareRoot(const Pack& a) { return std::experimental::sqrt(a); }

[[gnu::always_inline]] inline double magnitude(double a) { return std::fabs(a); }
[[gnu::always_inline]] inline Pack magnitude(const Pack& a) { return std::experimental::abs(a); }

[[gnu::always_inline]] inline double rounded(double a) { return std::nearbyint(a); }
[[gnu::always_inline]] inline Pack rounded(const Pack& a)
{
    return std::experimental::nearbyint(a);
}

//- Three Reals. Plain, so that the compiler keeps it in registers.
template<class Real>
struct V3
{
    Real x, y, z;

    [[gnu::always_inline]] friend V3 operator+(const V3& a, const V3& b)
    {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    [[gnu::always_inline]] friend V3 operator-(const V3& a, const V3& b)
    {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    [[gnu::always_inline]] friend V3 operator*(const Real& s, const V3& a)
    {
        return {s*a.x, s*a.y, s*a.z};
    }
};

template<class Real>
[[gnu::always_inline]] inline Real dot(const V3<Real>& a, const V3<Real>& b)
{
    return a.x*b.x + a.y*b.y + a.z*b.z;
}

template<class Real>
[[gnu::always_inline]] inline V3<Real> cross(const V3<Real>& a, const V3<Real>& b)
{
    return {a.y*b.z - a.z*b.y, a.z*b.x - a.x*b.z, a.x*b.y - a.y*b.x};
}

//- Whether a condition holds for any contact: what is rare need not be computed for all
[[gnu::always_inline]] inline bool any(bool c) { return c; }
[[gnu::always_inline]] inline bool any(const Pack::mask_type& c)
{
    return std::experimental::any_of(c);
}

//- A spring in the contact plane after its normal has turned from n - dn to n, and the pair
//  with it about n by the angle twist [rad]: the rotation that takes the one normal to the
//  other, to fourth order in |dn|.
template<class Real>
[[gnu::always_inline]] inline V3<Real> turned
(
    const V3<Real>& spring, const V3<Real>& n, const V3<Real>& dn, const Real& twist
)
{
    const V3<Real> t = (Real(1) - Real(0.5)*twist*twist)*spring + twist*cross(n, spring);
    return t - dot(t, n)*(n - Real(0.5)*dn);
}

//- The same where dn is not known: projected and brought back to its length
template<class Real>
[[gnu::always_inline]] inline V3<Real> turned
(
    const V3<Real>& spring, const V3<Real>& n, const Real& twist
)
{
    const V3<Real> t = spring + twist*cross(n, spring);
    const V3<Real> p = t - dot(t, n)*n;
    const Real tiny(1e-290);
    const Real scale = squareRoot
    (
        maximum(dot(spring, spring), tiny)/maximum(dot(p, p), tiny)
    );
    return scale*p;
}

}
