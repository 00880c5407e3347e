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

#include "modelTable.H"

// First: includes DEM.hpp
#include "dustProperties.H"

#include "injectorFunctions.H"

#include "Function1.H"
#include "OStringStream.H"
#include "TableBase.H"
#include "Tuple2.H"
#include "untrapped.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A function of time at some times of the injection: equal distances, and what
//  it is given at
class sampledFunction
{
    const dictionary& dict_;
    const word keyword_;
    autoPtr<Function1<scalar>> f_;


public:

    sampledFunction(const dictionary& dict, const word& keyword)
    :
        dict_(dict),
        keyword_(keyword)
    {
        // OpenFOAM says what is missing
        if (dict.found(keyword, keyType::LITERAL))
        {
            const untrapped reading;
            f_ = Function1<scalar>::New(keyword, dict);
        }
    }

    scalar operator()(const scalar t) const
    {
        return f_.valid() ? f_->value(t) : 0;
    }

    //- Up to the end of the injection
    scalarList times() const
    {
        const scalar end = dict_.lookupOrDefault<scalar>("duration", 1);
        const label n = 1000;
        DynamicList<scalar> t(n + 1);
        for (label i = 0; i <= n; ++i)
        {
            t.append(end*i/n);
        }
        const auto* tablePtr =
            f_.valid()
          ? dynamic_cast<const Function1Types::TableBase<scalar>*>(&f_())
          : nullptr;
        if (tablePtr)
        {
            const scalarField given(tablePtr->x());
            for (const scalar x : given)
            {
                if (x > 0 && x < end)
                {
                    t.append(x);
                }
            }
        }
        return scalarList(t);
    }

    //- Refuse values that are not from least to most
    void within(const scalar least, const scalar most, const string& allowed)
    const
    {
        for (const scalar t : times())
        {
            const scalar value = (*this)(t);
            if (f_.valid() && !(value >= least && value <= most))
            {
                dustProperties::error
                (
                    dict_,
                    keyword_,
                    "is " + Foam::name(value) + " at " + Foam::name(t)
                  + " s of the injection",
                    allowed
                );
            }
        }
    }

    //- Refuse one that is never above 0
    void some() const
    {
        scalar most = 0;
        for (const scalar t : times())
        {
            most = max(most, (*this)(t));
        }
        if (f_.valid() && !(most > 0))
        {
            dustProperties::error
            (
                dict_,
                keyword_,
                "is never above 0 during the injection: nothing would enter",
                "above 0 some time"
            );
        }
    }
};


static void checkAxis
(
    const dictionary& dict,
    const word& keyword,
    const vector& axis
)
{
    if (!(mag(axis) > ROOTVSMALL))
    {
        OStringStream reason;
        reason << "the direction is " << axis;
        dustProperties::error
        (
            dict, keyword, reason.str(), "a vector that is not zero"
        );
    }
}


static void checkCone(const dictionary& dict)
{
    const sampledFunction inner(dict, "thetaInner");
    const sampledFunction outer(dict, "thetaOuter");
    const string angles("0 to 180 degrees");
    inner.within(0, 180, angles);
    outer.within(0, 180, angles);

    for (const sampledFunction* f : {&inner, &outer})
    {
        for (const scalar t : f->times())
        {
            if (inner(t) > outer(t))
            {
                dustProperties::error
                (
                    dict,
                    "thetaInner",
                    "is " + Foam::name(inner(t)) + " at " + Foam::name(t)
                  + " s of the injection, thetaOuter " + Foam::name(outer(t)),
                    "at most thetaOuter"
                );
            }
        }
    }
}


static void checkNozzle(const dictionary& dict)
{
    if (dict.found("direction"))
    {
        checkAxis(dict, "direction", dict.get<vector>("direction"));
    }

    const scalar outer = dict.lookupOrDefault<scalar>("outerDiameter", GREAT);
    const scalar inner = dict.lookupOrDefault<scalar>("innerDiameter", 0);
    if (!(inner < outer))
    {
        dustProperties::error
        (
            dict,
            "innerDiameter",
            "is " + Foam::name(inner) + " m, outerDiameter "
          + Foam::name(outer) + " m",
            "less than outerDiameter"
        );
    }

    const word flow(dict.lookupOrDefault<word>("flowType", ""));
    if (flow == "pressureDrivenVelocity")
    {
        // Of the gas it is 0 in a kinematic cloud
        sampledFunction(dict, "Pinj").within
        (
            0,
            GREAT,
            "at least 0 Pa, the pressure of the gas that they go into"
        );
    }
    if (flow == "flowRateAndDischarge")
    {
        dustProperties::error
        (
            dict,
            "flowType",
            "flowRateAndDischarge makes the velocity of massTotal, which is 0"
            " where each parcel is a particle",
            "constantVelocity, pressureDrivenVelocity"
        );
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::injectorFunctions::check(const word& type, const dictionary& dict)
{
    if (!dict.lookupOrDefault("active", true))
    {
        dustProperties::error
        (
            dict,
            "active",
            "is off: OpenFOAM does not look at it, and injects",
            "on; type none for an injector that injects nothing"
        );
    }

    const bool cone = type == "coneInjection";
    const bool nozzle = type == "coneNozzleInjection";

    if (cone || nozzle || type == "patchInjection")
    {
        const sampledFunction rate(dict, "flowRateProfile");
        rate.within(0, GREAT, "not below 0");
        rate.some();
    }
    if (type == "patchFlowRateInjection")
    {
        const sampledFunction concentration(dict, "concentration");
        concentration.within(0, GREAT, "not below 0");
        concentration.some();
    }
    if (cone)
    {
        for
        (
            const Tuple2<vector, vector>& p
          : List<Tuple2<vector, vector>>(dict.lookup("positionAxis"))
        )
        {
            checkAxis(dict, "positionAxis", p.second());
        }
        sampledFunction(dict, "Umag").within(0, GREAT, "not below 0 m/s");
    }
    if (nozzle)
    {
        checkNozzle(dict);
    }
    if (cone || nozzle)
    {
        checkCone(dict);
    }
}


// ************************************************************************* //
