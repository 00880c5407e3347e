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


// First: includes DEM.hpp
#include "dustProperties.H"

#include "controlKeywords.H"
#include "controlTimes.H"
#include "gasKeywords.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of the algorithm in use by others of OpenFOAM's solvers, which this one
//  would do without
static void checkName(const dictionary& fvSolution)
{
    const word right("PIMPLE");
    for (const entry& e : fvSolution)
    {
        const word& name = e.keyword();
        const bool other =
            (name == "PISO" || name == "SIMPLE") && !fvSolution.found(right);
        if (e.isDict() && (other || controlKeywords::mistaken(name, right)))
        {
            dustProperties::error
            (
                fvSolution, name, "is not read where the gas is solved", right
            );
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::gasKeywords::check(const dictionary& fvSolution, const label nCells)
{
    checkName(fvSolution);

    const dictionary* dictPtr = fvSolution.findDict("PIMPLE");
    if (!dictPtr)
    {
        return;
    }
    const dictionary& dict = *dictPtr;
    controlKeywords::check
    (
        dict,
        {
            "solveFlow", "nCorrectors", "nNonOrthogonalCorrectors",
            "nOuterCorrectors", "momentumPredictor", "transonic", "consistent",
            "frozenFlow", "SIMPLErho", "turbOnFinalIterOnly", "residualControl",
            "outerCorrectorResidualControl", "pRefCell", "pRefPoint",
            "pRefValue", "momentumTolerance"
        }
    );

    const std::string count(">=1 <=1000");
    controlTimes::number(dict, "nCorrectors", count, 1, true);
    controlTimes::number(dict, "nOuterCorrectors", count, 1, true);
    controlTimes::number(dict, "nNonOrthogonalCorrectors", ">=0 <=1000", 0, true);
    controlTimes::number(dict, "momentumTolerance", ">=1e-15 <=1", 1);
    controlTimes::number(dict, "pRefValue", ">=-1e15 <=1e15", 0);
    controlTimes::number
    (
        dict,
        "pRefCell",
        ">=0 <=" + std::string(Foam::name(nCells - 1)),
        0,
        true
    );
}


// ************************************************************************* //
