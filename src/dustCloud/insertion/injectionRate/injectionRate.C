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
#include "injectionRate.H"

#include "Constant.H"
#include "distributionModel.H"
#include "Function1.H"
#include "SHA1.H"
#include "TableBase.H"
#include "untrapped.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const word profileKeyword("flowRateProfile");


static void refuseProfile
(
    const dictionary& injector,
    const string& reason,
    const string& allowed
)
{
    dustProperties::error(injector, profileKeyword, reason, allowed);
}


//- As OpenFOAM reads it. Its errors, as of a file that is not there, name
//  neither the injector nor the line
static autoPtr<Function1<scalar>> newProfile(const dictionary& injector)
{
    if (const dictionary* dictPtr = injector.findDict(profileKeyword))
    {
        const dictionary& dict = *dictPtr;
        dustProperties::checkKeywords
        (
            dict,
            {
                "type", "value", "values", profileKeyword, "file",
                "outOfBounds", "interpolationScheme", "nHeaderLine",
                "refColumn", "componentColumns", "separator",
                "mergeSeparators"
            }
        );
        const word bounds(dict.lookupOrDefault<word>("outOfBounds", "clamp"));
        const word scheme
        (
            dict.lookupOrDefault<word>("interpolationScheme", "linear")
        );
        if (bounds != "clamp" || scheme != "linear")
        {
            refuseProfile
            (
                injector,
                "has outOfBounds " + bounds + ", interpolationScheme "
              + scheme,
                "clamp, linear"
            );
        }
    }

    autoPtr<Function1<scalar>> f;
    string fault;
    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();
    try
    {
        const untrapped reading;
        f = Function1<scalar>::New(profileKeyword, injector);
    }
    catch (const Foam::IOerror& e)
    {
        fault = e.message() + " (" + e.ioFileName() + ")";
    }
    catch (const Foam::error& e)
    {
        fault = e.message();
    }
    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);

    if (!f.valid())
    {
        refuseProfile
        (
            injector,
            "cannot be read: " + fault,
            "constant, table, tableFile or csvFile; a file by its whole path"
            " or as \"<case>/...\", times in it ascending"
        );
    }
    return f;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::injectionRate::readRate(const dictionary& injector)
{
    if (injector.found("parcelsPerSecond") == injector.found("massFlowRate"))
    {
        const bool both = injector.found("massFlowRate");
        dustProperties::error
        (
            injector,
            both ? "massFlowRate" : "parcelsPerSecond",
            both ? "is given, and parcelsPerSecond, too" : "is missing",
            "either parcelsPerSecond [1/s] or massFlowRate [kg/s]"
        );
    }
    keyword_ =
        injector.found("massFlowRate") ? "massFlowRate" : "parcelsPerSecond";
    rate_ = injector.get<scalar>(keyword_);
    if (!(rate_ > 0 && std::isfinite(rate_)))
    {
        dustProperties::error
        (
            injector,
            keyword_,
            "is " + Foam::name(rate_),
            "a positive number"
        );
    }
}


void Foam::injectionRate::readProfile(const dictionary& injector)
{
    if (!injector.found(profileKeyword))
    {
        return;
    }
    const autoPtr<Function1<scalar>> f(newProfile(injector));
    scalarField t(1, Zero);
    scalarField w(1, Zero);
    const auto* tablePtr =
        dynamic_cast<const Function1Types::TableBase<scalar>*>(&f());
    if (tablePtr)
    {
        t = tablePtr->x();
        w = tablePtr->y();
    }
    else if (isA<Function1Types::Constant<scalar>>(f()))
    {
        w = f->value(0);
    }
    else
    {
        refuseProfile
        (
            injector,
            "is of type " + f->type(),
            "constant, table, tableFile, csvFile"
        );
    }

    forAll(t, i)
    {
        if (!(std::isfinite(w[i]) && w[i] >= 0 && std::isfinite(t[i])))
        {
            refuseProfile
            (
                injector,
                "is " + Foam::name(w[i]) + " at " + Foam::name(t[i]) + " s",
                "finite numbers, none below 0"
            );
        }
    }
    profile_ = rateProfile
    (
        std::vector<double>(t.begin(), t.end()),
        std::vector<double>(w.begin(), w.end())
    );
    if (!tablePtr && w[0] == 1)
    {
        return;     // as without one
    }
    if (!(profile_.largest() > 0))
    {
        refuseProfile
        (
            injector,
            "is never above 0: nothing would enter",
            "above 0 some time"
        );
    }

    SHA1 sum;
    sum.append(reinterpret_cast<const char*>(t.cdata()), t.byteSize());
    sum.append(reinterpret_cast<const char*>(w.cdata()), w.byteSize());
    digest_ = word("x" + sum.digest().str());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::injectionRate::injectionRate
(
    const dictionary& injector,
    const dustProperties& dust
)
:
    rate_(0),
    density_(dust.density(dust.material(injector))),
    meanMass_(0),
    digest_("none")
{
    if (const dictionary* sizesPtr = injector.findDict("sizeDistribution"))
    {
        // By samples: no model tells it
        Random random(0);
        const autoPtr<distributionModel> sizes
        (
            distributionModel::New(*sizesPtr, random)
        );
        const label nSamples = 1000;
        for (label i = 0; i < nSamples; ++i)
        {
            meanMass_ += mass(sizes->sample())/nSamples;
        }
    }

    if (injector.get<word>("type") == "dustPatchInjection")
    {
        readRate(injector);
        readProfile(injector);
    }
    else
    {
        rate_ = injector.lookupOrDefault<scalar>("parcelsPerSecond", 0);
    }
}



// ************************************************************************* //
