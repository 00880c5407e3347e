// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dem
{

struct TimeSettings
{
    //- Below this a collision is not resolved: at 20 the restitution is off by 0.012 (polystyrene
    //  of Haervig et al. 2017), below by up to 0.18
    static constexpr double fewestStepsPerContact = 20;

    //- What a law that yields needs: cohesivePlastic is off by 0.041 at 20, 0.0045 at 50
    static constexpr double fewestStepsWherePlastic = 50;

    //- Contact steps in the shortest period of a contact (normal or tangential) [-]
    double stepsPerContact = 50;

    //- Multiplies the sleep and wake tolerances [-]; 0 = nothing ever rests
    double restTolerance = 1;

    //- false: everything takes the contact step of the stiffest possible contact, as a
    //  conventional DEM code does (exact, slow)
    bool islands = true;

    //- Whether StepReport::energy is kept; costs about as much as the contact steps
    bool energyLedger = false;

    //- Contact step at most this share of the stability bound (contactPeriod.hpp) [-]
    double boundShare = 0.8;
};

}
