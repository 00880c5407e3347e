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

Description
    The Reynolds-stress models of OpenFOAM, LRR and SSG, for the gas of
    dustFoam. OpenFOAM has them for gas alone only: its table for gas with a
    void fraction (libDPMTurbulenceModels) knows kEpsilon, realizableKE,
    kOmegaSST, kEqn and Smagorinsky.

\*---------------------------------------------------------------------------*/

#include "PhaseIncompressibleTurbulenceModel.H"
#include "singlePhaseTransportModel.H"
#include "addToRunTimeSelectionTable.H"
#include "makeTurbulenceModel.H"

#include "bound.H"
#include "wallDist.H"
#include "laminarModel.H"
#include "RASModel.H"
#include "LESModel.H"
#include "LRR.H"
#include "SSG.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeTurbulenceModelTypes
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    PhaseIncompressibleTurbulenceModel,
    singlePhaseTransportModel
);

makeTemplatedTurbulenceModel
(
    singlePhaseTransportModelPhaseIncompressibleTurbulenceModel,
    RAS,
    LRR
);

makeTemplatedTurbulenceModel
(
    singlePhaseTransportModelPhaseIncompressibleTurbulenceModel,
    RAS,
    SSG
);


// ************************************************************************* //
