// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elliptic contact solved numerically, with nothing of the library: E* = 1 and W = 1.
//
// Under the pressure H s + X x^2/(a^2 s) + Y y^2/(b^2 s), s = (1 - x^2/a^2 - y^2/b^2)^(1/2), the
// surfaces move by (H u + X a du/da + Y b du/db)/pi, with the potential of the Hertzian
// part (derivatives since that part is zero at the edge)
//     u = (pi a b/2) int_0^inf (1 - x^2/(a^2 + w) - y^2/(b^2 + w)) dw/((a^2 + w)(b^2 + w) w)^(1/2)
// H, X, Y follow from the fit delta - x^2/(2 R_1) - y^2/(2 R_2); then a, b make the elastic plus
// surface energy least at given delta (Giudici, Vella & Griffiths 2024, arXiv:2407.00378).
#pragma once

#include <Eigen/Dense>

#include <array>
#include <cmath>

namespace ellipse
{

constexpr double pi = 3.14159265358979323846;

//- int_0^inf dw/((a^2 + w)^(m + 1/2) (b^2 + w)^(n + 1/2) w^(1/2)): trapezoids in ln w, which
//  converge exponentially
inline double integral(double a, double b, int m, int n)
{
    constexpr int points = 160;
    constexpr double end = 24;
    const double h = 2*end/points;
    double sum = 0;
    for (int k = 0; k <= points; ++k)
    {
        const double w = a*b*std::exp(2*(k*h - end));
        const double p = a*a + w, q = b*b + w;
        sum += 2*std::sqrt(w/(p*q))/(std::pow(p, m)*std::pow(q, n));
    }
    return sum*h;
}

//- Rows: constant, -x^2, -y^2; columns: of H, X, Y
inline Eigen::Matrix3d displacements(double a, double b)
{
    const double c = 0.5*pi*a*b, A = a*a, B = b*b;
    const double j00 = integral(a, b, 0, 0), j10 = integral(a, b, 1, 0);
    const double j01 = integral(a, b, 0, 1), j20 = integral(a, b, 2, 0);
    const double j11 = integral(a, b, 1, 1), j02 = integral(a, b, 0, 2);
    Eigen::Matrix3d u;
    u << j00, j00 - A*j10, j00 - B*j01,
         j10, j10 - 3*A*j20, j10 - B*j11,
         j01, j01 - A*j11, j01 - 3*B*j02;
    return c/pi*u;
}

struct State { double energy, load; };

//- Total energy and load in an ellipse a, b at the approach delta
inline State state(double R1, double R2, double delta, double a, double b)
{
    const Eigen::Vector3d fit(delta, 0.5/R1, 0.5/R2);
    const Eigen::Vector3d p = displacements(a, b).fullPivLu().solve(fit);
    // int p, int p x^2, int p y^2
    const double area = pi*a*b, load = 2.0/3.0*area*p.sum();
    const double xx = area*a*a*(2*p[0] + 6*p[1] + 2*p[2])/15;
    const double yy = area*b*b*(2*p[0] + 2*p[1] + 6*p[2])/15;
    const double elastic = 0.5*(delta*load - xx*fit[1] - yy*fit[2]);
    return {elastic - area, load};
}

//- Load at the approach delta where the energy is least; a, b: first guess, then the ellipse
inline double loadAt(double R1, double R2, double delta, double& a, double& b)
{
    Eigen::Vector2d z(std::log(a), std::log(b));
    const auto energy = [&](const Eigen::Vector2d& at)
    {
        return state(R1, R2, delta, std::exp(at[0]), std::exp(at[1])).energy;
    };
    const double h = 1e-3;
    for (int iteration = 0; iteration < 40; ++iteration)
    {
        const Eigen::Vector2d dx(h, 0), dy(0, h);
        const double e = energy(z);
        const double ex = energy(z + dx), e_x = energy(z - dx);
        const double ey = energy(z + dy), e_y = energy(z - dy);
        const double exy = energy(z + dx + dy) - energy(z + dx - dy)
          - energy(z - dx + dy) + energy(z - dx - dy);
        const Eigen::Vector2d slope((ex - e_x)/(2*h), (ey - e_y)/(2*h));
        Eigen::Matrix2d bend;
        bend << (ex - 2*e + e_x)/(h*h), exy/(4*h*h), exy/(4*h*h), (ey - 2*e + e_y)/(h*h);
        Eigen::Vector2d step = -bend.ldlt().solve(slope);
        // downhill, in small steps
        if (step.dot(slope) > 0) step = -step;
        step *= std::min(1.0, 0.2/step.norm());
        z += step;
        if (step.norm() < 1e-8) break;
    }
    a = std::exp(z[0]);
    b = std::exp(z[1]);
    return state(R1, R2, delta, a, b).load;
}

//- Pull-off force over (3/2) pi W R_1
inline double pullOff(double R1, double R2)
{
    const double R = std::sqrt(R1*R2), a0 = std::cbrt(4.5*pi*R*R), unit = a0*a0/R;
    double a = a0*std::pow(R1/R2, 0.25), b = a0*std::pow(R2/R1, 0.25);
    // from near the equilibrium out to where the force is greatest, then closer
    double best = 0, at = 0, step = 0.04*unit;
    for (double delta = 0.1*unit; delta > -0.22*unit; delta -= step)
    {
        const double pull = -loadAt(R1, R2, delta, a, b);
        if (pull <= best) break;
        best = pull;
        at = delta;
    }
    for (int k = 0; k < 20; ++k, step *= 0.6)
    {
        for (const double delta : {at - step, at + step})
        {
            const double pull = -loadAt(R1, R2, delta, a, b);
            if (pull > best)
            {
                best = pull;
                at = delta;
            }
        }
    }
    return best/(1.5*pi*R1);
}

//- Hertz: load over (4/3) (R_1 R_2)^(1/4) delta^(3/2)
inline double hertz(double R1, double R2)
{
    double low = 1e-5, high = 1;    // b/a; the ratio of curvatures grows as it falls
    for (int k = 0; k < 60; ++k)
    {
        const double b = std::sqrt(low*high);
        const Eigen::Matrix3d u = displacements(1, b);
        (u(2, 0)/u(1, 0) > R1/R2 ? low : high) = b;
    }
    const Eigen::Matrix3d u = displacements(1, low);
    const double H = 0.5/R1/u(1, 0), load = 2.0/3.0*pi*low*H, delta = u(0, 0)*H;
    return load/(4.0/3.0*std::pow(R1*R2, 0.25)*std::pow(delta, 1.5));
}

}
