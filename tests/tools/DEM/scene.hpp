// SPDX-License-Identifier: GPL-3.0-or-later
//
// Short ways to set up materials, spheres and walls for tests of the DEM library.
#pragma once

#include "DEM.hpp"

#include "contactFormulas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <cstdio>
#include <string>
#include <vector>

namespace scene
{

using dem::Vec3;

inline std::string text(double value)
{
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.12g", value);
    return buffer;
}

inline ::testing::AssertionResult verdict
(
    double value, double expected, double error, double tolerance
)
{
    if (error <= tolerance) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
        << "is " << text(value) << ", expected " << text(expected) << ", off by "
        << text(error) << ", allowed " << text(tolerance);
}

//- |value - expected| <= tolerance
inline ::testing::AssertionResult near(double value, double expected, double tolerance)
{
    return verdict(value, expected, std::fabs(value - expected), tolerance);
}

//- |value - expected| <= relative |expected|
inline ::testing::AssertionResult close(double value, double expected, double relative)
{
    return near(value, expected, relative*std::fabs(expected));
}

inline ::testing::AssertionResult near
(
    const Vec3& value, const Vec3& expected, double tolerance
)
{
    const double error = (value - expected).norm();
    if (error <= tolerance) return ::testing::AssertionSuccess();
    ::testing::AssertionResult result = ::testing::AssertionFailure();
    for (int d = 0; d < 3; ++d)
    {
        result << text(value[d]) << " (expected " << text(expected[d]) << ") ";
    }
    return result << "off by " << text(error) << ", allowed " << text(tolerance);
}

//- Two materials, "dust" (0) and "wall" (1), alike; the defaults are the polystyrene of
//  Haervig et al. 2017 with every part of the contact law switched off but the normal one
struct Law
{
    std::string normal = "JKR";
    double restitution = 0.86;
    double dampingCoefficient = -1;     // if >= 0, instead of the restitution
    double friction = -1;               // >= 0: springDashpotSlider
    double criticalAngle = -1;          // > 0: springSlider with this
    double adhesionHysteresis = -1;     // > 0: springSlider with this
    double rollingDamping = 0;          // [N s]
    bool twisting = false;
    double E = 2.71e8;                  // effective modulus [Pa]
    double nu = 0.33;
    double gamma = 0.11;                // [J/m2]
    double density = 1026;              // [kg/m3]
    dem::ReducedStiffness softening;
    std::function<void(dem::ContactSettings&)> adjust;  // has the last word, if given

    bool rolls() const { return criticalAngle > 0 || adhesionHysteresis > 0; }

    dem::ContactSettings settings() const
    {
        dem::ContactSettings s;
        s.normal.model = normal;
        if (dampingCoefficient >= 0)
        {
            s.normal.values["dampingCoefficient"] = dampingCoefficient;
        }
        else
        {
            s.normal.values["restitution"] = restitution;
        }
        if (friction >= 0)
        {
            s.tangential.model = "springDashpotSlider";
            s.tangential.values["friction"] = friction;
        }
        if (rolls())
        {
            s.rolling.model = "springSlider";
            if (criticalAngle > 0) s.rolling.values["criticalAngle"] = criticalAngle;
            if (adhesionHysteresis > 0)
            {
                s.rolling.values["adhesionHysteresis"] = adhesionHysteresis;
            }
            if (rollingDamping > 0) s.rolling.values["rollingDamping"] = rollingDamping;
        }
        if (twisting) s.twisting.model = "springDashpotSlider";
        if (adjust) adjust(s);
        return s;
    }

    dem::MaterialTable table() const
    {
        // like materials: 1/E = 2 (1 - nu^2)/E_i
        const double youngs = 2*(1 - nu*nu)*E;
        return
        {
            {
                {"dust", density, youngs, nu, gamma},
                {"wall", 0, youngs, nu, gamma}
            },
            settings(), {}, softening
        };
    }

    double mass(double radius) const
    {
        return density*4.0/3.0*formula::pi*radius*radius*radius;
    }

    //- The contact of radii ri, rj (rj <= 0: flat wall) as softened or (chi = 1) as real
    formula::Contact contact(double ri, double rj, bool real = false) const
    {
        const double chi = real ? 1 : softening.ratio;
        formula::Contact c;
        c.E = chi*E;
        // G/E of like materials: (1 - nu)/(2 (2 - nu))
        c.G = c.E*(1 - nu)/(2*(2 - nu));
        c.gamma = gamma*(softening.scaleSurfaceEnergy ? std::pow(chi, 0.4) : 1);
        c.R = rj > 0 ? ri*rj/(ri + rj) : ri;
        const double mi = mass(ri), mj = rj > 0 ? mass(rj) : 0;
        c.m = rj > 0 ? mi*mj/(mi + mj) : mi;
        return c;
    }
};

inline dem::Particle sphere
(
    const Law& law, std::int64_t id, double radius, const Vec3& x,
    const Vec3& v = Vec3::Zero(), const Vec3& omega = Vec3::Zero()
)
{
    return {id, 0, radius, law.mass(radius), x, v, omega};
}

//- The plane z = 0 with the particles above it
inline dem::Walls floor()
{
    dem::Walls walls;
    walls.patches = {{"floor", 1}};
    walls.planes = {{Vec3::Zero(), Vec3::UnitZ(), 0}};
    return walls;
}

//- Random numbers that are a function of seed and counter alone
class Random
{
public:

    explicit Random(std::uint64_t seed)
    :
        state_(seed*0x9E3779B97F4A7C15ull + 0x1234567ull)
    {}

    double uniform()    // [0, 1)
    {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
        z = (z ^ (z >> 30))*0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27))*0x94D049BB133111EBull;
        z = z ^ (z >> 31);
        return double(z >> 11)*0x1.0p-53;
    }
    double uniform(double low, double high) { return low + (high - low)*uniform(); }
    double logUniform(double low, double high)
    {
        return low*std::pow(high/low, uniform());
    }
    int below(int n) { return int(uniform()*n); }
    Vec3 inBox(double half)
    {
        const double x = uniform(-half, half), y = uniform(-half, half);
        return {x, y, uniform(-half, half)};
    }
    Vec3 direction()
    {
        for (;;)
        {
            const Vec3 d = inBox(1);
            if (d.norm() > 0.1 && d.norm() < 1) return d.normalized();
        }
    }

private:

    std::uint64_t state_;
};

}
