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

#include "dragRange.H"

#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static std::string text(const scalar value)
{
    char buffer[32];
    snprintf(buffer, sizeof(buffer), "%.3g", value);
    return buffer;
}

} // End namespace Foam


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const Foam::dragRange* Foam::dragRange::find(const word& law)
{
    static const char* const bed = "slipErgunWenYuDrag or ErgunWenYuDrag";
    static const char* const slipBed = "slipErgunWenYuDrag";

    static const dragRange ranges[] =
    {
        {"slipDrag", 0.9, GREAT, bed, ""},
        {"sphereDrag", 0.9, 0.01, bed, "slipDrag"},
        {"nonSphereDrag", 0.9, 0.01, bed, "slipDrag"},
        {"WenYuDrag", 0.8, 0.01, bed, slipBed},
        {"ErgunWenYuDrag", 0.36, 0.01, "", slipBed},
        {"PlessisMasliyahDrag", 0.36, 0.01, "", slipBed},
        {"slipErgunWenYuDrag", 0.36, 1, "", "slipDrag if they fly alone"}
    };

    for (const dragRange& r : ranges)
    {
        if (law == r.law)
        {
            return &r;
        }
    }
    return nullptr;
}


std::string Foam::dragRange::voidFractionRemark
(
    const word& law,
    const scalar smallestVoid,
    const std::string& who
)
{
    const dragRange* r = find(law);

    if (!r || smallestVoid >= r->minVoid)
    {
        return "";
    }

    std::string remark =
        law + " holds above a void fraction of " + text(r->minVoid) + ", "
      + who + " have " + text(smallestVoid);
    if (*r->denser)
    {
        remark += ": take " + std::string(r->denser);
    }
    return remark;
}


std::string Foam::dragRange::slipRemark
(
    const word& law,
    const scalar diameter,
    const scalar lambda,
    const std::string& who
)
{
    const dragRange* r = find(law);
    const scalar knudsen = 2*lambda/diameter;

    if (!r || knudsen <= r->maxKnudsen)
    {
        return "";
    }

    return
        law + " holds below a Knudsen number of " + text(r->maxKnudsen) + ", "
      + who + " have " + text(knudsen) + " (slip correction "
      + text(slipCorrection(knudsen)) + "): take " + r->slips;
}


Foam::scalar Foam::dragRange::slipCorrection(const scalar knudsen)
{
    return 1 + knudsen*(1.257 + 0.4*std::exp(-1.1/knudsen));
}


// ************************************************************************* //
