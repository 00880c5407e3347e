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
#include "contactTable.H"

#include "formatted.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::contactTable::line
(
    const dustSizes::kind& dust,
    const label partner,
    const std::string& name,
    const scalar diameter,
    const scalar partnerDiameter,
    const dem::WallCurvature& curvature
) const
{
    const dem::MaterialTable& table = system_.materials();
    const int material = int(dust.material);
    const bool wall = partnerDiameter <= 0;

    const dem::ContactFigures f = table.figures
    (
        material,
        int(partner),
        0.5*diameter,
        wall ? -1 : 0.5*partnerDiameter,
        properties_.mass(dust.material, diameter),
        wall ? 0 : properties_.mass(partner, partnerDiameter),
        speed_,
        curvature
    );

    Info<< formatted
        (
            "  %-16s %9.3g %10.3g %10.3g %9.3g %9.3g %9.3g %9.3g "
            "%9.3g %9.3g %9.3g %9.3g",
            name.c_str(), diameter, f.pullOff, f.realPullOff,
            2*table.constants(material, int(partner)).realGamma, f.a0, f.delta0,
            f.deltaC, f.tabor, f.impactTime,
            f.period/properties_.time().stepsPerContact,
            f.stableStep
        ).c_str() << nl;

    // Half a radius: far beyond every law here, and what wrong units lead to
    const scalar largestOverlap =
        max(f.delta0, f.impactOverlap)
       /(wall ? diameter : min(diameter, partnerDiameter));
    if (largestOverlap > 0.25)
    {
        dustProperties::error
        (
            materials_,
            properties_.name(partner),
            formatted
            (
                "particles of %.3g m in contact %s overlap by "
                "%.3g diameters (chi %.3g, effective Young's "
                "modulus %.3g Pa): are the moduli in Pa, the "
                "sizes in m?",
                diameter,
                name.c_str(),
                largestOverlap,
                table.softening().ratio,
                table.constants(material, int(partner)).E
            ),
            "materials and reducedStiffness/ratio with less than "
            "0.25 diameters"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::contactTable::print(const dustSizes& sizes) const
{
    const dem::MaterialTable& table = system_.materials();
    const auto& kinds = sizes.kinds();
    for (auto dust = kinds.begin(); dust != kinds.end(); ++dust)
    {
        if (dust->diameters[2] <= 0)
        {
            continue;
        }
        for
        (
            const dem::RatioPartner& other
          : dem::ratioPartners(table, int(dust->material), system_.walls())
        )
        {
            for (const scalar diameter : dust->diameters)
            {
                line
                (
                    *dust, other.material, other.name, diameter,
                    other.wall ? -1 : diameter, other.curvature
                );
            }
        }

        // With others, as near in size as they come; each pair once
        for (auto other = dust + 1; other != kinds.end(); ++other)
        {
            const FixedList<scalar, 3>& range = other->diameters;
            if (range[2] <= 0)
            {
                continue;
            }
            const std::string name
            (
                table.pairName(int(dust->material), int(other->material))
            );
            for (const scalar diameter : dust->diameters)
            {
                const scalar nearest = min(max(diameter, range[0]), range[2]);
                line(*dust, other->material, name, diameter, nearest, {});
            }
        }
    }
}


// ************************************************************************* //
