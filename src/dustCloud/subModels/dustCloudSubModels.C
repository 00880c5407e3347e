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

// OpenFOAM's sub-models for our cloud, each selectable by its usual name. Some
// are completed by defaults, see modelTable.H.
// Our own are added where they are defined.

#include "dustCloud.H"
#include "completedModels.H"
#include "shearLift.H"

#include "makeParcelCloudFunctionObjects.H"

// Kinematic
#include "makeParcelForces.H"
#include "makeParcelDispersionModels.H"
#include "makeParcelInjectionModels.H"
#include "makeParcelPatchInteractionModels.H"
#include "makeParcelStochasticCollisionModels.H"
#include "makeParcelSurfaceFilmModels.H"
#include "makeParcelTurbulenceDispersionModels.H"

#if OPENFOAM >= 2012
#include "makeMPPICParcelDampingModels.H"
#include "makeMPPICParcelIsotropyModels.H"
#include "makeMPPICParcelPackingModels.H"
#endif

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

makeParcelCloudFunctionObjects(dustCloud);

makeParcelForces(dustCloud);
makeParcelDispersionModels(dustCloud);
makeParcelInjectionModels(dustCloud);
makeParcelPatchInteractionModels(dustCloud);
makeParcelStochasticCollisionModels(dustCloud);
makeParcelSurfaceFilmModels(dustCloud);

#if OPENFOAM >= 2012
// Asked for by every kinematic cloud; left at their defaults, none
makeMPPICParcelDampingModels(dustCloud);
makeMPPICParcelIsotropyModels(dustCloud);
makeMPPICParcelPackingModels(dustCloud);
#endif

namespace Foam
{
    makeParcelTurbulenceDispersionModels(dustCloud);

    typedef dustCloud::kinematicCloudType cloudType;

    template<class Force>
    static void completeForce()
    {
        ParticleForce<cloudType>::dictionaryConstructorTablePtr_->set
        (
            Force::typeName,
            completedForce<Force>::New
        );
    }

    template<template<class> class Injector>
    static void completeInjector()
    {
        InjectionModel<cloudType>::dictionaryConstructorTablePtr_->set
        (
            Injector<cloudType>::typeName,
            completedInjector<Injector<cloudType>>::New
        );
    }

    // After OpenFOAM's own, above
    static const bool completed = []
    {
        completeForce<WenYuDragForce<cloudType>>();
        completeForce<ErgunWenYuDragForce<cloudType>>();
        completeForce<PlessisMasliyahDragForce<cloudType>>();
        completeForce<shearLift>();
        completeForce<PressureGradientForce<cloudType>>();
        completeForce<VirtualMassForce<cloudType>>();
        completeForce<NonInertialFrameForce<cloudType>>();
        completeForce<ParamagneticForce<cloudType>>();

        completeInjector<CellZoneInjection>();
        completeInjector<ConeInjection>();
        completeInjector<ConeNozzleInjection>();
        completeInjector<FieldActivatedInjection>();
        completeInjector<KinematicLookupTableInjection>();
        completeInjector<ManualInjection>();
        completeInjector<PatchInjection>();
        completeInjector<PatchFlowRateInjection>();

        return true;
    }();
}


// ************************************************************************* //
