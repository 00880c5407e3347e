// Deposition between two walls by the normalised Langevin equation in one dimension, Stokes drag, wall
// units: independent of dustFoam, with small steps and nothing exact about them.
//
//   dw = -w dt/T + (2/T)^(1/2) dW + ds/dy dt/(1 + St),  u = s w,  dv = (u - v) dt/tau
//
// with the fits of turbulenceSeen.H up to y+ = 100, from 200 on s = 0.766 (2k/3)^(1/2), T = 0.3 k/epsilon
// with k and epsilon of verification/dispersion/channel.sh, a smooth step in between.
//
//   langevin1D TAU RADIUS NUMBER FROM END: prints V+ = flux/(mean concentration) between FROM and END

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

const double half = 400;

double k(double y) { return 3.33*(1 - 0.7*y/half)*std::pow(1 - std::exp(-y/10), 2); }

double step(double y)
{
    const double r = (y - 100)/100;
    return r < 0 ? 0 : r > 1 ? 1 : r*r*(3 - 2*r);
}

double s(double y)
{
    const double near = 0.0116*y*y/(1 + 0.203*y + 0.0014*std::pow(y, 2.421));
    return near + step(y)*(0.766*std::sqrt(2*k(y)/3) - near);
}

double T(double y)
{
    if (y <= 5) return 10;
    const double near = 7.122 + 0.5731*y - 0.00129*y*y;
    const double far = 0.3*0.41*y*(1 - y/(2*half))/0.1643/std::sqrt(k(y));
    return near + step(y)*(far - near);
}

int main(int, char** argument)
{
    const double tau = std::atof(argument[1]), radius = std::atof(argument[2]);
    const double from = std::atof(argument[4]), end = std::atof(argument[5]), dt = 0.5;
    const int n = std::atoi(argument[3]);

    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal;
    struct particle { double y, v, w; };
    std::vector<particle> all(n);
    for (int i = 0; i < n; ++i) all[i] = {radius + (half - radius)*(i + 0.5)/n, 0, normal(engine)};

    const double e = std::exp(-dt/tau);
    double lost = 0, concentration = 0;
    for (double t = 0; t < end; t += dt)
    {
        for (std::size_t i = 0; i < all.size();)
        {
            particle& p = all[i];
            const double h = 0.01*p.y, time = T(p.y), f = std::exp(-dt/time);
            const double drift = (s(p.y + h) - s(p.y - h))/(2*h)/(1 + tau/time);
            const double w = f*p.w + std::sqrt(1 - f*f)*normal(engine) + time*(1 - f)*drift;
            const double u = s(p.y)*(p.w + w)/2;
            p.w = w;
            p.y += u*dt + (p.v - u)*tau*(1 - e);
            p.v = u + (p.v - u)*e;
            if (p.y > half) p = {2*half - p.y, -p.v, -p.w};
            if (p.y < radius)
            {
                p = all.back();
                all.pop_back();
                lost += t >= from;
            }
            else ++i;
        }
        if (t >= from) concentration += all.size()/half*dt;
    }
    std::printf("%.4g %.0f\n", lost/concentration, lost);
}
