// SPDX-License-Identifier: GPL-3.0-or-later
#include "timeIntegration/RigidAggregate.hpp"

#include "timeIntegration/freeFlight.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace dem
{

namespace
{

//- r^2 1 - r r^T
Eigen::Matrix3d squareArm(const Vec3& r)
{
    return r.squaredNorm()*Eigen::Matrix3d::Identity() - r*r.transpose();
}

Eigen::Matrix3d rotation(const Vec3& angle)
{
    const double size = angle.norm();
    if (size == 0) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(size, angle/size).toRotationMatrix();
}

}


RigidAggregate::RigidAggregate
(
    std::vector<Particle>& particles, const std::vector<GasLoad>& gas,
    const Periodic& periodic
)
:
    particles_(particles),
    gas_(gas),
    X_(Vec3::Zero()),
    V_(Vec3::Zero()),
    L_(Vec3::Zero())
{
    // from the first particle, which may have the others beyond a period
    for (const Particle& p : particles_)
    {
        r_.push_back(periodic.nearest(p.x - particles_[0].x));
        M_ += p.mass;
        X_ += p.mass*r_.back();
        V_ += p.mass*p.v;
    }
    X_ /= M_;
    V_ /= M_;
    for (std::size_t k = 0; k < r_.size(); ++k)
    {
        const Particle& p = particles_[k];
        r_[k] -= X_;
        L_ += p.mass*r_[k].cross(p.v - V_) + inertiaOf(k)*p.omega;
    }
    X_ += particles_[0].x;
    setInertia();
    accelerate();
}


void RigidAggregate::setInertia()
{
    I_ = Matrix::Zero();
    for (std::size_t k = 0; k < r_.size(); ++k)
    {
        I_ += particles_[k].mass*squareArm(r_[k]) + inertiaOf(k)*Matrix::Identity();
    }
    omega_ = I_.inverse()*L_;
}


Vec3 RigidAggregate::gasForce(std::size_t k) const
{
    return gas_[k].Sp*(gas_[k].Uc - velocity(k)) + gas_[k].Su;
}


void RigidAggregate::accelerate()
{
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (std::size_t k = 0; k < r_.size(); ++k)
    {
        const Vec3 f = gasForce(k);
        force += f;
        torque += r_[k].cross(f) + gas_[k].SpOmega*(gas_[k].omegaC - omega_);
    }
    a_ = force/M_;
    alpha_ = I_.inverse()*(torque - omega_.cross(L_));
}


Vec3 RigidAggregate::contactForce(std::size_t k) const
{
    const Vec3& r = r_[k];
    return
        particles_[k].mass*(a_ + alpha_.cross(r) + omega_.cross(omega_.cross(r)))
      - gasForce(k);
}


Vec3 RigidAggregate::contactTorque(std::size_t k) const
{
    return inertiaOf(k)*alpha_ - gas_[k].SpOmega*(gas_[k].omegaC - omega_);
}


double RigidAggregate::stiffen()
{
    double energy = 0;
    for (std::size_t k = 0; k < r_.size(); ++k)
    {
        Particle& p = particles_[k];
        energy += 0.5*
        (
            p.mass*(p.v.squaredNorm() - velocity(k).squaredNorm())
          + inertiaOf(k)*(p.omega.squaredNorm() - omega_.squaredNorm())
        );
        p.v = velocity(k);
        p.omega = omega_;
    }
    return energy;
}


//- Rotation over h at constant angular momentum, by the spin half way
void RigidAggregate::rotate(double h)
{
    const Matrix half = rotation(0.5*h*omega_);
    const Vec3 middle = half*(I_.inverse()*(half.transpose()*L_));
    const Matrix whole = rotation(h*middle);
    for (Vec3& r : r_) r = whole*r;
    R_ = whole*R_;
    setInertia();
}


//- I domega/dt = T - K omega over h, exact for the body as it lies
void RigidAggregate::relax(double h)
{
    Matrix K = Matrix::Zero();
    Vec3 T = Vec3::Zero();
    for (std::size_t k = 0; k < r_.size(); ++k)
    {
        const GasLoad& g = gas_[k];
        K += g.Sp*squareArm(r_[k]) + g.SpOmega*Matrix::Identity();
        T += r_[k].cross(g.Sp*(g.Uc - V_) + g.Su) + g.SpOmega*g.omegaC;
    }
    if (T.isZero(0) && K.isZero(0)) return;

    // K e = lambda I e with e^T I e = 1
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> modes(K, I_);
    const Matrix& E = modes.eigenvectors();
    Vec3 amount = E.transpose()*L_;
    const Vec3 drive = E.transpose()*T;
    for (int d = 0; d < 3; ++d)
    {
        const FlightFactors f(std::max(modes.eigenvalues()[d], 0.0), h);
        amount[d] = f.e*amount[d] + f.p1*drive[d];
    }
    omega_ = E*amount;
    L_ = I_*omega_;
}


//- The centre in closed form, the turning of the particles about it as it is
void RigidAggregate::advanceCentre(double h)
{
    double S = 0;
    Vec3 b = Vec3::Zero();
    for (std::size_t k = 0; k < r_.size(); ++k)
    {
        const GasLoad& g = gas_[k];
        S += g.Sp;
        b += g.Sp*(g.Uc - omega_.cross(r_[k])) + g.Su;
    }
    b /= M_;
    const FlightFactors f(S/M_, h);
    X_ += f.p1*V_ + f.p2*b;
    V_ = f.e*V_ + f.p1*b;
}


FlightFactors RigidAggregate::flight(double h) const
{
    double S = 0;
    for (const GasLoad& g : gas_) S += g.Sp;
    return FlightFactors(S/M_, h);
}


RigidAggregate::Matrix RigidAggregate::fly(double h, std::vector<Vec3>& impulse)
{
    const Vec3 startX = X_, startV = V_;
    const std::vector<Vec3> start = r_;
    R_ = Matrix::Identity();

    // as fast as it spins now or will, drag allowing
    const Vec3 L = L_;
    double spin = omega_.norm();
    relax(h);
    spin = std::max(spin, omega_.norm());
    L_ = L;
    setInertia();
    const int steps = std::max(1, int(std::ceil(h*spin/turn)));
    const double step = h/steps;
    for (int k = 0; k < steps; ++k)
    {
        relax(0.5*step);
        rotate(0.5*step);
        advanceCentre(step);
        rotate(0.5*step);
        relax(0.5*step);
    }
    accelerate();

    // The gas gives to each what its path says; what the splitting lacks in the sum is
    // shared by mass, so that momentum is kept
    impulse.resize(r_.size());
    Vec3 lacking = M_*(V_ - startV);
    for (std::size_t k = 0; k < r_.size(); ++k)
    {
        const Vec3 moved = (X_ - startX) + (r_[k] - start[k]);
        impulse[k] = gas_[k].Sp*(h*gas_[k].Uc - moved) + h*gas_[k].Su;
        lacking -= impulse[k];
    }
    for (std::size_t k = 0; k < r_.size(); ++k)
    {
        Particle& p = particles_[k];
        impulse[k] += p.mass/M_*lacking;
        p.x = X_ + r_[k];
        p.v = velocity(k);
        p.omega = omega_;
    }
    return R_;
}

}
