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

#include "calibrationFiles.H"

#include "IOmanip.H"
#include "OFstream.H"
#include "OSspecific.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::calibrationFiles::calibrationFiles
(
    const calibrationSettings& settings,
    const scaledCollision& curve,
    const restitutionFit& fit,
    const fileName& directory
)
:
    settings_(settings),
    curve_(curve),
    fit_(fit),
    directory_(directory)
{
    mkDir(directory_);
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::calibrationFiles::writeFit() const
{
    const calibrationSettings& s = settings_;
    OFstream os(directory_/"fit.csv");
    os.precision(9);
    os  << "velocity_mps,restitution,fitted,residual,Astar" << nl;
    Info<< nl << "    v [m/s]     measured    fitted      residual    A*" << nl;
    scalar sum = 0;
    label n = 0;
    const auto report = [&](const calibrationSettings::measurement& p)
    {
        const scalar e = fit_.restitution(p.v);
        const scalar A =
            scaledCollision::Astar(s.velocityFactor()*p.v/fit_.X());
        os  << p.v << ',' << p.e << ',' << e << ',' << e - p.e << ','
            << A << nl;
        Info<< "    " << setw(10) << p.v << setw(12) << p.e << setw(12) << e
            << setw(14) << e - p.e << setw(12) << A << nl;
        if (p.e > 0)
        {
            sum += sqr(e - p.e);
            ++n;
        }
    };
    if (s.fitPoint.v > 0)
    {
        Info<< "    fitPoint:" << nl;
        report(s.fitPoint);
    }
    for (const calibrationSettings::measurement& p : s.points)
    {
        report(p);
    }
    Info<< "    residual of the points that rebound, rms: "
        << std::sqrt(sum/std::max(n, label(1))) << nl;
    if (!s.wall)
    {
        Info<< "    (A* of the impact on a wall that has this restitution)" << nl;
    }
}


void Foam::calibrationFiles::writeCurve() const
{
    OFstream os(directory_/"curve.csv");
    os.precision(9);
    os  << "velocity_mps,restitution" << nl;
    const scalar from = std::max
    (
        fit_.sticking(),
        1e-3*fit_.X()/settings_.velocityFactor()
    );
    const scalar to = std::max(2*settings_.highestVelocity, 10*from);
    for (label k = 0; k <= 200; ++k)
    {
        const scalar v = from*std::pow(to/from, k/200.0);
        os  << v << ',' << fit_.restitution(v) << nl;
    }
}


Foam::fileName Foam::calibrationFiles::writeMap() const
{
    const fileName name(directory_/"map.csv");
    OFstream os(name);
    os.precision(9);
    os  << "alpha,inverseAstar,restitution" << nl;
    for (const scalar alpha : {0.0, 0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0})
    {
        // 1/A* = V over the V of A* = 1
        const scalar first = std::max
        (
            curve_.sticking(alpha)/scaledCollision::VofAstar(1), scalar(0.1)
        );
        os  << alpha << ',' << first << ",0" << nl;
        for (label k = 0; k <= 150; ++k)
        {
            // dense next to sticking
            const scalar x = k/150.0;
            const scalar inverse = first*(1 + 1e-9)*std::pow(1e3/first, x*x);
            os  << alpha << ',' << inverse << ','
                << curve_.collide
                   (
                       alpha, scaledCollision::VofAstar(1/inverse)
                   ).restitution
                << nl;
        }
    }
    return name;
}


void Foam::calibrationFiles::writeContact
(
    const scalar softE,
    const scalar chi
) const
{
    const calibrationSettings& s = settings_;
    const scalar E = s.realE > 0 ? s.realE : softE;
    const scalar gamma = fit_.gamma(E);

    mkDir(s.output.path());
    OFstream os(s.output);
    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << s.output << exit(FatalError);
    }
    os.precision(9);
    os  << "// Contact of " << s.pair << ", fitted by calibrateContact to measured"
        << " restitutions." << nl
        << "// Put this at the end of constant/dustProperties:" << nl
        << "//     #includeIfPresent \"" << s.output.name() << "\"" << nl
        << "//" << nl
        << "// " << (s.wall ? "Sphere on a wall" : "Two equal spheres")
        << ", diameter " << 2*s.radius << " m, density " << s.density
        << " kg/m3, model " << s.model << nl
        << "// plateau restitution " << scaledCollision::plateauOf(fit_.alpha())
        << ", E^(-1/3) gamma^(5/6) = " << fit_.X() << " N^(1/2) m^(-1/6)" << nl;
    if (s.points.size())
    {
        os  << "// v [m/s]  measured  fitted  residual" << nl;
    }
    for (const calibrationSettings::measurement& p : s.points)
    {
        const scalar e = fit_.restitution(p.v);
        os  << "//     " << p.v << "  " << p.e << "  " << e << "  " << e - p.e << nl;
    }
    os  << nl
        << "contact" << nl
        << "{" << nl
        << "    \"" << s.pair << "\"" << nl << "    {" << nl
        << "        normal  { model " << s.model << "; dampingCoefficient "
        << fit_.alpha() << "; }" << nl
        << nl;
    if (s.realE > 0)
    {
        os  << "        // of the real material; with the ratio below"
            << " E_mod = " << chi*E << " Pa, gamma_mod = "
            << std::pow(chi, 0.4)*gamma << " J/m2" << nl;
    }
    else
    {
        os  << "        // E_mod and gamma_mod: the real modulus was not given."
            << " Rolling and sliding" << nl
            << "        // limits are then those of the softened contact, too"
            << " weak" << nl;
    }
    os  << "        effectiveYoungsModulus  " << E << ";" << nl
        << "        surfaceEnergy           " << gamma << ";" << nl
        << "        calibratedRatio         " << chi << ";" << nl
        << "    }" << nl
        << "}" << nl
        << nl
        << "reducedStiffness" << nl
        << "{" << nl
        << "    // overlap at most " << s.overlapLimit << " of the diameter at "
        << s.highestVelocity << " m/s" << nl
        << "    ratio   " << chi << ";" << nl
        << "}" << nl;
}


// ************************************************************************* //
