// SPDX-License-Identifier: GPL-3.0-or-later
//
// The closed forms of the contact laws, written for the tests from the papers and with
// nothing of the library, and an integrator that is exact to about ten digits.
// H17: Haervig et al. 2017, C19: Chen, Liu & Li 2019.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace formula
{

constexpr double pi = 3.14159265358979323846;

//- One contact: effective modulus, shear modulus, surface energy, radius, mass
struct Contact
{
    double E, G, gamma, R, m;

    double pullOff() const { return 3*pi*R*gamma; }
    double a0() const { return std::cbrt(9*pi*gamma*R*R/E); }
    double delta0() const { return a0()*a0()/(3*R); }
    double deltaC() const { return a0()*a0()/(2*std::cbrt(6.0)*R); }
};

//- JKR: a/a0 at an overlap, the largest root of A^2 - (2/3) A^(1/2) = delta R/a0^2.
//  Bisection in quadruple precision, so that the double root at the neck's end does no harm.
inline double jkrRadius(double scaledOverlap)
{
    using Quad = __float128;
    const Quad q = scaledOverlap;
    const auto f = [&](const Quad& s) { return s*s*s*s - Quad(2)/3*s - q; };
    // s = A^(1/2), 6^(-1/3) at the neck's end
    Quad low = Quad(0.5503212081491044), high = 2;
    if (f(low) > 0) return double(low*low);
    while (f(high) < 0) high *= 2;
    for (int k = 0; k < 200; ++k)
    {
        const Quad middle = (low + high)/2;
        (f(middle) < 0 ? low : high) = middle;
    }
    return double(low*low);
}

//- The same to about 1e-15, faster (for integrations)
inline double jkrRadiusFast(double q)
{
    double low = std::pow(6.0, -1.0/3.0);
    double high = std::max(1.5, std::sqrt(std::sqrt(2*std::fabs(q) + 4)));
    for (int k = 0; k < 8; ++k)
    {
        const double middle = 0.5*(low + high);
        const double f = middle*middle*middle*middle - 2.0/3.0*middle - q;
        (f < 0 ? low : high) = middle;
    }
    double s = high;
    for (int k = 0; k < 5; ++k)     // convex there: Newton from above converges
    {
        s -= (s*s*s*s - 2.0/3.0*s - q)/(4*s*s*s - 2.0/3.0);
    }
    return s*s;
}

//- |ln e|/(ln^2 e + pi^2)^(1/2)
inline double beta(double e)
{
    const double l = std::log(e);
    return std::fabs(l)/std::sqrt(l*l + pi*pi);
}

//- What the sliding, rolling and twisting parts use of the normal law
struct Normal
{
    double force;       // F_N [N], compressive positive
    double damping;     // eta_N [N s/m]
    double radius;      // contact radius of sliding and twisting [m]
    double A;           // a/a0
};

inline Normal normal
(
    const std::string& law, const Contact& c, double overlap, double e
)
{
    const double hertzRadius = std::sqrt(c.R*std::max(overlap, 0.0));
    const double stiffness = 2*c.E*hertzRadius;
    const double hertzDamping = 2*std::sqrt(5.0/6.0)*beta(e)*std::sqrt(stiffness*c.m);
    const double hertz = 4.0/3.0*c.E*std::sqrt(c.R)*std::pow(std::max(overlap, 0.0), 1.5);

    if (law == "Hertz") return {hertz, hertzDamping, hertzRadius, 0};
    if (law == "DMT")
    {
        const double a0 = std::cbrt(3*pi*c.gamma*c.R*c.R/c.E);
        return
        {
            hertz - 4*pi*c.R*c.gamma, hertzDamping, hertzRadius, hertzRadius/a0
        };
    }

    const double A = jkrRadiusFast(overlap*c.R/(c.a0()*c.a0()));
    const double force = 4*c.pullOff()*(A*A*A - std::pow(A, 1.5));
    if (law == "simplifiedJKR") return {force, hertzDamping, hertzRadius, A};
    if (law == "JKR")
    {
        const double a = A*c.a0();
        return {force, std::sqrt(5.0)*beta(e)*std::sqrt(c.m*4.0/3.0*c.E*a), a, A};
    }
    throw std::logic_error("no such law: " + law);
}

//- Overlap at which a contact ends
inline double endOverlap(const std::string& law, const Contact& c)
{
    return law == "JKR" ? -c.deltaC() : 0;
}

//- Runge-Kutta-Fehlberg with local error control, until `over` is true (then the last step
//  is cut until the end is met to within the smallest step) or t = tEnd
template<std::size_t n>
struct Ode
{
    using State = std::array<double, n>;
    std::function<State(double, const State&)> rate;
    State scale;                // size of one unit of each component
    double tolerance = 1e-11;   // of a step, in units of scale

    double solve
    (
        State& y, double t, double tEnd, double h,
        const std::function<bool(const State&)>& over
    ) const
    {
        const double smallest = 1e-13*tEnd;
        while (t < tEnd)
        {
            h = std::min(h, tEnd - t);
            State y5;
            const double error = attempt(t, y, h, y5);
            if (error > tolerance && h > smallest)
            {
                h *= std::max(0.2, 0.9*std::pow(tolerance/error, 0.2));
                continue;
            }
            if (over(y5) && h > smallest)
            {
                h *= 0.5;
                continue;
            }
            y = y5;
            t += h;
            if (over(y)) break;
            h *= std::min(3.0, 0.9*std::pow(tolerance/std::max(error, 1e-300), 0.2));
            h = std::max(h, smallest);
        }
        return t;
    }

private:

    double attempt(double t, const State& y, double h, State& y5) const
    {
        static const double a[6][5] =
        {
            {},
            {1.0/4},
            {3.0/32, 9.0/32},
            {1932.0/2197, -7200.0/2197, 7296.0/2197},
            {439.0/216, -8, 3680.0/513, -845.0/4104},
            {-8.0/27, 2, -3544.0/2565, 1859.0/4104, -11.0/40}
        };
        static const double c[6] = {0, 0.25, 0.375, 12.0/13, 1, 0.5};
        static const double b4[6] = {25.0/216, 0, 1408.0/2565, 2197.0/4104, -0.2, 0};
        static const double b5[6] =
            {16.0/135, 0, 6656.0/12825, 28561.0/56430, -9.0/50, 2.0/55};
        State k[6];
        for (int s = 0; s < 6; ++s)
        {
            State z = y;
            for (int r = 0; r < s; ++r)
            {
                for (std::size_t i = 0; i < n; ++i) z[i] += h*a[s][r]*k[r][i];
            }
            k[s] = rate(t + c[s]*h, z);
        }
        double error = 0;
        for (std::size_t i = 0; i < n; ++i)
        {
            double difference = 0;
            y5[i] = y[i];
            for (int s = 0; s < 6; ++s)
            {
                y5[i] += h*b5[s]*k[s][i];
                difference += h*(b5[s] - b4[s])*k[s][i];
            }
            error = std::max(error, std::fabs(difference)/scale[i]);
        }
        return error;
    }
};

//- Head-on collision at relative speed v with restitution e (of the adhesionless contact)
struct Collision
{
    double restitution;     // rebound speed/v; 0 = stuck (never left within the time limit)
    double time;            // in contact [s]
    double peakOverlap;     // [m]
};

inline Collision collide
(
    const std::string& law, const Contact& c, double v, double e
)
{
    const double hertzOverlap =
        std::pow(15.0/16.0*c.m*v*v/(c.E*std::sqrt(c.R)), 0.4);
    const double overlapScale = hertzOverlap + c.delta0();
    const double time =
        2.94*hertzOverlap/v
      + (c.gamma > 0 ? 2*pi*std::sqrt(c.m*c.a0()*c.a0()/(3.6*c.pullOff()*c.R)) : 0);
    const double end = endOverlap(law, c);

    double peak = 0;
    Ode<2> ode;
    ode.rate = [&](double, const std::array<double, 2>& y)
    {
        const Normal n = normal(law, c, std::max(y[0], end), e);
        return std::array<double, 2>{y[1], -(n.force + n.damping*y[1])/c.m};
    };
    ode.scale = {overlapScale, v};
    std::array<double, 2> y{0, v};
    bool left = false;
    const double t = ode.solve
    (
        y, 0, 10*time, 1e-6*time,
        [&](const std::array<double, 2>& z)
        {
            peak = std::max(peak, z[0]);
            left = z[1] < 0 && z[0] < end;
            // turning inward again below the start: held
            return left;
        }
    );
    return {left ? -y[1]/v : 0, t, peak};
}

}
