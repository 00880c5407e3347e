// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adhesive contact of a paraboloid x^2/2R_1 + y^2/2R_2 whose edge is free to take its shape,
// not only that of an ellipse: an independent numerical solution of the JKR problem.
//
// Contact area   L > 0,  L = 1 - X^2 - Y^2 - sum_k c_k Re (X + iY)^(2k + 2),  X = x/a, Y = y/b
// Pressure       p = sum P_ij X^2i Y^2j/L^(1/2)
// Elastic energy of a half-space from its projections (Radon transform) p_t(s) along the direction t,
//     (1/2) P.A P,  A = (1/2 pi E) int dt int ds p_t(s) p'_t(s)
// stored at the approach d: (1/2) B.A^-1 B, B = int p (d - x^2/2R_1 - y^2/2R_2) dA. Less W times the
// area it is least over a, b, c_k: G = W all along the edge. Pull-off: largest pull over d.
// Here E = W = 1.
#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace freeEdge
{

constexpr double pi = 3.14159265358979323846;

//- Nodes and weights of Gauss and Legendre on (0, 1)
inline std::vector<std::pair<double, double>> gauss(int n)
{
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, n);
    for (int i = 1; i < n; ++i) J(i, i - 1) = J(i - 1, i) = i/std::sqrt(4.0*i*i - 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(J);
    std::vector<std::pair<double, double>> nodes;
    for (int i = 0; i < n; ++i)
    {
        nodes.push_back({0.5*(1 + solver.eigenvalues()(i)), std::pow(solver.eigenvectors()(0, i), 2)});
    }
    return nodes;
}

struct Contact
{
    double R1, R2;
    int modes;          // of the edge beyond the ellipse
    int degree = 4;     // i + j of the pressure
    int directions = 16, lines = 10, points = 10;

    //- L at a point of the scaled plane
    double level(const Eigen::VectorXd& q, double X, double Y) const
    {
        double L = 1 - X*X - Y*Y, u = X*X - Y*Y, v = 2*X*Y, re = u, im = v;
        for (int k = 0; k < modes; ++k)
        {
            const double next = re*u - im*v;
            im = re*v + im*u;
            re = next;
            L -= q[2 + k]*re;
        }
        return L;
    }

    //- Way from (X, Y), inside, to the edge
    double toEdge(const Eigen::VectorXd& q, double X, double Y, double dX, double dY) const
    {
        double low = 0, high = 0.02;
        while (level(q, X + high*dX, Y + high*dY) > 0 && high < 4) { low = high; high += 0.05; }
        double fLow = level(q, X + low*dX, Y + low*dY), fHigh = level(q, X + high*dX, Y + high*dY);
        for (int i = 0; i < 60 && high - low > 1e-15; ++i)
        {
            double mid = (low*fHigh - high*fLow)/(fHigh - fLow);
            if (i % 3 == 2 || !(mid > low && mid < high)) mid = 0.5*(low + high);
            const double f = level(q, X + mid*dX, Y + mid*dY);
            if (f > 0) { low = mid; fLow = f; } else { high = mid; fHigh = f; }
        }
        return 0.5*(low + high);
    }

    //- Distance of the tangent at right angles to the unit vector (nX, nY), and its point
    double support(const Eigen::VectorXd& q, double nX, double nY, double& X, double& Y) const
    {
        const double t0 = std::atan2(nY, nX);
        const auto reach = [&](double t) { return toEdge(q, 0, 0, std::cos(t), std::sin(t))*std::cos(t - t0); };
        double a = t0 - 0.7, b = t0 + 0.7;
        const double g = 0.5*(std::sqrt(5.0) - 1);
        double c = b - g*(b - a), d = a + g*(b - a), fc = reach(c), fd = reach(d);
        for (int i = 0; i < 40; ++i)
        {
            if (fc > fd) { b = d; d = c; fd = fc; c = b - g*(b - a); fc = reach(c); }
            else { a = c; c = d; fc = fd; d = a + g*(b - a); fd = reach(d); }
        }
        const double t = 0.5*(a + b), r = toEdge(q, 0, 0, std::cos(t), std::sin(t));
        X = r*std::cos(t);
        Y = r*std::sin(t);
        return r*std::cos(t - t0);
    }

    //- What energy and force follow from: B.A^-1 B for B of 1 and of the shape, and the area
    struct Sums { double one, mixed, shape, area; };

    Sums sums(const Eigen::VectorXd& q) const
    {
        const double a = q[0], b = q[1];
        std::vector<std::pair<int, int>> powers;
        for (int i = 0; i <= degree; ++i) for (int j = 0; i + j <= degree; ++j) powers.push_back({i, j});
        const int n = int(powers.size());
        Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
        Eigen::VectorXd one = Eigen::VectorXd::Zero(n), shape = one;
        const auto nodes = gauss(lines);

        double area = 0;
        // Directions over a quarter, with its ends; the first also gives the integrals
        for (int m = 0; m <= directions; ++m)
        {
            const double t = 0.5*pi*m/directions, c = std::cos(t), s = std::sin(t);
            const double h = std::sqrt(a*a*c*c + b*b*s*s), nX = a*c/h, nY = b*s/h;
            double X0, Y0;
            const double reach = support(q, nX, nY, X0, Y0);
            const double share = (m == 0 || m == directions ? 0.5 : 1)*0.5*pi/directions*4;
            for (const auto& [at, weight] : nodes)
            {
                // a point within the chord: on the way to the tangent's point
                const double Xm = at*X0, Ym = at*Y0;
                const double ahead = toEdge(q, Xm, Ym, -nY, nX), back = toEdge(q, Xm, Ym, nY, -nX);
                const double half = 0.5*(ahead + back), middle = 0.5*(ahead - back);
                Eigen::VectorXd R = Eigen::VectorXd::Zero(n);
                for (int k = 0; k < points; ++k)
                {
                    const double z = std::cos(pi*(k + 0.5)/points), l = middle + half*z;
                    const double X = Xm - l*nY, Y = Ym + l*nX;
                    const double w = pi/points*half*std::sqrt((1 - z*z)/level(q, X, Y));
                    std::vector<double> XX(degree + 1, 1), YY(degree + 1, 1);
                    for (int i = 0; i < degree; ++i)
                    {
                        XX[i + 1] = XX[i]*X*X;
                        YY[i + 1] = YY[i]*Y*Y;
                    }
                    const double u = X*X*a*a/(2*R1) + Y*Y*b*b/(2*R2);
                    for (int i = 0; i < n; ++i)
                    {
                        const double f = w*XX[powers[i].first]*YY[powers[i].second];
                        R[i] += f;
                        if (m == 0)
                        {
                            one[i] += 2*a*b*reach*weight*f;
                            shape[i] += 2*a*b*reach*weight*f*u;
                        }
                    }
                }
                A += share*a*b*a*b/h*2*reach*weight/(2*pi)*R*R.transpose();
            }
        }
        // the area, from the edge
        const int edge = 64;
        for (int k = 0; k < edge; ++k)
        {
            const double t = 2*pi*k/edge;
            area += pi/edge*a*b*std::pow(toEdge(q, 0, 0, std::cos(t), std::sin(t)), 2);
        }
        const Eigen::LDLT<Eigen::MatrixXd> ldlt(A);
        const Eigen::VectorXd P1 = ldlt.solve(one), P2 = ldlt.solve(shape);
        return {one.dot(P1), one.dot(P2), shape.dot(P2), area};
    }

    double energy(const Eigen::VectorXd& q, double d) const
    {
        const Sums s = sums(q);
        return 0.5*(d*d*s.one - 2*d*s.mixed + s.shape) - s.area;
    }

    //- The edge at an approach: Newton's steps from a guess
    void settle(Eigen::VectorXd& q, double d) const
    {
        const int n = int(q.size());
        for (int iteration = 0; iteration < 12; ++iteration)
        {
            Eigen::VectorXd gradient(n), step(n);
            Eigen::MatrixXd H(n, n);
            for (int i = 0; i < n; ++i) step[i] = i < 2 ? 2e-3*q[i] : 2e-3;
            const auto moved = [&](int i, double x, int j, double y)
            {
                Eigen::VectorXd p = q;
                p[i] += x*step[i];
                p[j] += y*step[j];
                return energy(p, d);
            };
            const double centre = energy(q, d);
            for (int i = 0; i < n; ++i)
            {
                const double up = moved(i, 1, i, 0), down = moved(i, -1, i, 0);
                gradient[i] = (up - down)/(2*step[i]);
                H(i, i) = (up - 2*centre + down)/(step[i]*step[i]);
                for (int j = 0; j < i; ++j)
                {
                    H(i, j) = H(j, i) = (moved(i, 1, j, 1) - moved(i, 1, j, -1) - moved(i, -1, j, 1) + moved(i, -1, j, -1))
                        /(4*step[i]*step[j]);
                }
            }
            const Eigen::VectorXd change = -H.ldlt().solve(gradient);
            q += change;
            double size = 0;
            for (int i = 0; i < n; ++i) size = std::max(size, std::abs(change[i])/(i < 2 ? q[i] : 1));
            if (size < 1e-6) break;
        }
    }

    //- Force at an approach, compressive
    double force(Eigen::VectorXd& q, double d) const
    {
        settle(q, d);
        const Sums s = sums(q);
        return d*s.one - s.mixed;
    }

    //- Largest pull of the load. Starts from the round contact of the same R_1 R_2
    double pullOff() const
    {
        const double Re = std::sqrt(R1*R2);
        const double a = std::cbrt(9*pi*Re*Re/8);
        double d = -a*a/(3*Re), width = -0.1*d;
        Eigen::VectorXd q = Eigen::VectorXd::Zero(2 + modes);
        q[0] = a*std::cbrt(R1/R2);
        q[1] = a*std::cbrt(R2/R1);
        for (int i = 0; i < 4; ++i)
        {
            const double f1 = force(q, d);
            Eigen::VectorXd p = q;
            const double f0 = force(p, d - width), f2 = force(p = q, d + width);
            d += 0.5*width*(f0 - f2)/(f0 - 2*f1 + f2);
            width *= 0.3;
        }
        return -force(q, d);
    }
};

}
