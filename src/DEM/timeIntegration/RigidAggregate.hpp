// SPDX-License-Identifier: GPL-3.0-or-later
//
// Particles that hold together and are at rest among themselves, moved as one body.
//
//     M dV/dt = sum_k F_k,   dL/dt = sum_k (r_k x F_k + T_k),   L = I omega
//     F_k = Sp_k (Uc_k - v_k) + Su_k,   T_k = SpOmega_k (omegaC_k - omega)
//     v_k = V + omega x r_k,   r_k = x_k - X from the centre of mass
//
// Symmetric splitting over steps that turn the body by less than `turn`: relaxation of the
// spin by the drag torques (exact for the body as it lies), rotation at constant angular
// momentum, flight of the centre in closed form, rotation, relaxation. Of second order in
// the step and stable for any tau_p/step; with equal drag per mass the flight is exact.
#pragma once

#include "neighbourSearch/Periodic.hpp"
#include "particles/GasLoad.hpp"
#include "particles/Particle.hpp"
#include "particles/vector.hpp"
#include "timeIntegration/freeFlight.hpp"

#include <vector>

namespace dem
{

class RigidAggregate
{
public:

    using Matrix = Eigen::Matrix3d;

    //- Mass, momentum and angular momentum are those of the particles. Nothing is copied:
    //  both lists must stay.
    RigidAggregate
    (
        std::vector<Particle>& particles, const std::vector<GasLoad>& gas,
        const Periodic& periodic
    );

    //- The body's motion at particle k [m/s], and its spin [rad/s]
    Vec3 velocity(std::size_t k) const { return V_ + omega_.cross(r_[k]); }
    const Vec3& spin() const { return omega_; }
    //- Particle k from the centre of mass [m]
    const Vec3& arm(std::size_t k) const { return r_[k]; }

    //- What the particle's own motion has beyond the body's [m/s], [rad/s]
    Vec3 velocityBeyond(std::size_t k) const { return particles_[k].v - velocity(k); }
    Vec3 spinBeyond(std::size_t k) const { return particles_[k].omega - omega_; }

    //- Force [N] and torque [N m] that its contacts must give to particle k now
    Vec3 contactForce(std::size_t k) const;
    Vec3 contactTorque(std::size_t k) const;

    //- Give the particles the body's motion; returns the kinetic energy that goes [J]
    double stiffen();

    //- Move the particles over h [s]; impulse[k] is what the gas gave [N s]. Returns the
    //  rotation of the body.
    Matrix fly(double h, std::vector<Vec3>& impulse);

    //- Of the centre of mass over h, for GasExchange
    FlightFactors flight(double h) const;


private:

    static constexpr double turn = 0.05;    // [rad]

    Vec3 gasForce(std::size_t k) const;
    double inertiaOf(std::size_t k) const
    {
        return 0.4*particles_[k].mass*particles_[k].radius*particles_[k].radius;
    }

    void accelerate();
    void setInertia();
    void rotate(double h);
    void relax(double h);
    void advanceCentre(double h);

    std::vector<Particle>& particles_;
    const std::vector<GasLoad>& gas_;
    std::vector<Vec3> r_;
    double M_ = 0;
    Vec3 X_, V_, L_, omega_;
    Matrix I_, R_ = Matrix::Identity();
    Vec3 a_, alpha_;        // acceleration of the centre and of the spin
};

}
