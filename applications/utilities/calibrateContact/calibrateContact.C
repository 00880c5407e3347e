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

Application
    calibrateContact

Description
    From measured restitutions to the damping, the stiffness and the surface
    energy of a contact, for JKR and simplifiedJKR.

    The restitution of a normal impact depends on two numbers only: the damping
    coefficient alpha and X = E^(-1/3) gamma^(5/6) (see scaledCollision.H).
    alpha follows from the plateau at high speed, X from where adhesion lets the
    restitution fall. E and gamma are not determined one by one: every E with
    gamma = X^(6/5) E^(2/5) gives the same rebound. So E may be chosen as soft
    as the overlap allows (E_mod, gamma_mod), while rolling and sliding keep
    the strength of the real gamma.

    Reads system/calibrateContactDict, writes a dictionary to #include at the
    end of constant/dustProperties, and the fit as CSV.

Usage
    \b calibrateContact [OPTIONS]

      - \par -map
        Also write the restitution over alpha and 1/A*: map.csv

    \verbatim
    pair            dust.steel;         // a.b: names in dustProperties
    diameter        1.27e-6;            // [m]
    points                              // normal impact: speed [m/s], e [-]
    (
        (2.5    0.42)
        (5      0.71)
        (20     0.85)
    );

    // Optional:
    density         1026;       // [kg/m3] default: of constant/dustProperties
    configuration   wall;       // wall | spheres (equal ones); default: as
                                // contactProbe takes the pair
    model           JKR;        // JKR (default) | simplifiedJKR
    plateauRestitution 0.86;    // fixes alpha; default: fitted
    fitPoint        (2.5 0.42); // X from this point alone; default: all points
    effectiveYoungsModulus 2.7e8;   // [Pa] of the real pair; default: of
                                // dustProperties; without both, the softened
                                // contact is written as if it were real
    overlap         0.01;       // limit of overlap/diameter; default 0.01
    highestVelocity 20;         // [m/s] where it shall hold; default: fastest
    output          "constant/calibratedContact";   // default
    \endverbatim

    A point with e = 0 is one that sticks. It is not fitted, but its residual
    is given.

\*---------------------------------------------------------------------------*/

#include "caseInput.H"
#include "scaledCollision.H"

#include "argList.H"
#include "IOmanip.H"
#include "mathematicalConstants.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"
#include "Tuple2.H"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

using namespace Foam;

using caseInput::check;
using caseInput::choice;
using caseInput::positive;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct measurement
{
    scalar v;   // [m/s]
    scalar e;
};


struct contactSettings
{
    word pair;
    bool wall;
    scalar radius;              // of a sphere [m]
    scalar density;             // [kg/m3]
    scalar realE;               // effective [Pa]; 0 = not known
    word model;
    std::vector<measurement> points;
    scalar plateau;             // 0 = to be fitted
    measurement fitPoint;       // v = 0: all points
    scalar overlapLimit;
    scalar highestVelocity;
    fileName output;

    scalar R() const { return wall ? radius : 0.5*radius; }
    scalar m() const
    {
        const scalar one =
            density*4.0/3.0*constant::mathematical::pi*pow3(radius);
        return wall ? one : 0.5*one;
    }

    //- V = velocityFactor v/X
    scalar velocityFactor() const
    {
        const scalar pi = constant::mathematical::pi;
        return
            std::sqrt(m()/(12*pi*std::pow(9*pi, 2.0/3.0)))
           /std::pow(R(), 2.0/3.0);
    }
};


measurement checkedPoint
(
    const dictionary& dict,
    const word& keyword,
    const Tuple2<scalar, scalar>& p
)
{
    check(dict, keyword, p.first(), p.first() > 0, "(v e) with v > 0 m/s");
    check
    (
        dict, keyword, p.second(), p.second() >= 0 && p.second() < 1,
        "(v e) with 0 <= e < 1"
    );
    return {p.first(), p.second()};
}


//- Look up what dustProperties knows of the pair, if there is one
void lookAtProperties
(
    const Time& runTime,
    contactSettings& s,
    scalar& density,
    bool& wall,
    scalar& realE
)
{
    IOobject io
    (
        caseInput::mustRead("dustProperties", runTime.constant(), runTime)
    );
    if (!io.typeHeaderOk<IOdictionary>(false))
    {
        return;
    }
    const IOdictionary properties(io);
    const dustProperties dust(properties);
    const dem::MaterialTable table(dust.table());

    wordList ofWalls;
    const dictionary& patches = properties.subOrEmptyDict("patchMaterials");
    for (const entry& e : patches)
    {
        ofWalls.append(patches.get<word>(e.keyword()));
    }

    const auto& materials = table.materials();
    for (std::size_t i = 0; i < materials.size(); ++i)
    {
        for (std::size_t j = 0; j < materials.size(); ++j)
        {
            if (s.pair != materials[i].name + "." + materials[j].name)
            {
                continue;
            }
            density = std::max(materials[i].density, materials[j].density);
            wall =
                i != j
             && (
                    !(materials[i].density > 0) || !(materials[j].density > 0)
                 || ofWalls.found(word(materials[i].name))
                 || ofWalls.found(word(materials[j].name))
                );
            realE = table.constants(int(i), int(j)).realE;
        }
    }
}


contactSettings readSettings(const dictionary& dict, const Time& runTime)
{
    dustProperties::checkKeywords
    (
        dict,
        {
            "FoamFile", "pair", "diameter", "points", "density",
            "configuration", "model", "plateauRestitution", "fitPoint",
            "effectiveYoungsModulus", "overlap", "highestVelocity", "output"
        }
    );

    contactSettings s;
    s.pair = dict.get<word>("pair");
    if (s.pair.find('.') == std::string::npos)
    {
        dustProperties::error
        (
            dict, "pair", "'" + s.pair + "' names no two materials", "a.b"
        );
    }
    s.radius = 0.5*positive(dict, "diameter", "m");

    scalar density = 0, realE = 0;
    bool wall = true, known = false;
    {
        scalar before = density;
        lookAtProperties(runTime, s, density, wall, realE);
        known = density > before;
    }

    s.density = dict.found("density") ? positive(dict, "density", "kg/m3") : density;
    if (!(s.density > 0))
    {
        dustProperties::error
        (
            dict,
            "pair",
            "the density of " + s.pair + " is not known",
            "density here, or the two materials in constant/dustProperties"
        );
    }

    const word configuration
    (
        choice
        (
            dict, "configuration", wall ? "wall" : "spheres", {"wall", "spheres"}
        )
    );
    if (!known && !dict.found("configuration"))
    {
        dustProperties::error
        (
            dict,
            "pair",
            "whether " + s.pair + " is a sphere on a wall is not known",
            "configuration wall; or configuration spheres;"
        );
    }
    s.wall = configuration == "wall";

    s.model = choice(dict, "model", "JKR", {"JKR", "simplifiedJKR"});

    const List<Tuple2<scalar, scalar>> points
    (
        dict.get<List<Tuple2<scalar, scalar>>>("points")
    );
    s.highestVelocity = 0;
    scalar highest = 0;
    label rebounds = 0;
    for (const auto& p : points)
    {
        s.points.push_back(checkedPoint(dict, "points", p));
        highest = std::max(highest, p.first());
        rebounds += p.second() > 0;
    }

    s.plateau = 0;
    if (dict.found("plateauRestitution"))
    {
        s.plateau = dict.get<scalar>("plateauRestitution");
        check
        (
            dict, "plateauRestitution", s.plateau,
            s.plateau >= 0.01 && s.plateau <= 1, "0.01 to 1"
        );
    }
    s.fitPoint = {0, 0};
    if (dict.found("fitPoint"))
    {
        s.fitPoint = checkedPoint
        (
            dict, "fitPoint", dict.get<Tuple2<scalar, scalar>>("fitPoint")
        );
        check
        (
            dict, "fitPoint", s.fitPoint.e, s.fitPoint.e > 0,
            "(v e) with e > 0: a point that rebounds"
        );
    }

    const label needed = s.fitPoint.v > 0 ? (s.plateau > 0 ? 0 : 1)
        : (s.plateau > 0 ? 1 : 2);
    if (rebounds < needed)
    {
        dustProperties::error
        (
            dict,
            "points",
            "has " + Foam::name(rebounds) + " points that rebound",
            Foam::name(needed) + " or more, as plateauRestitution and fitPoint"
            " are given or not"
        );
    }

    s.realE =
        dict.found("effectiveYoungsModulus")
      ? positive(dict, "effectiveYoungsModulus", "Pa")
      : realE;
    s.overlapLimit =
        dict.found("overlap") ? positive(dict, "overlap", "-") : 0.01;
    s.highestVelocity =
        dict.found("highestVelocity")
      ? positive(dict, "highestVelocity", "m/s")
      : std::max(highest, s.fitPoint.v);
    s.output =
        dict.lookupOrDefault<fileName>("output", "constant/calibratedContact");
    if (!s.output.isAbsolute())
    {
        s.output = runTime.globalPath()/s.output;
    }
    return s;
}


//- Lowest point of f by the simplex method of Nelder & Mead, in two dimensions
std::array<scalar, 2> lowest
(
    const std::function<scalar(const std::array<scalar, 2>&)>& f,
    const std::array<scalar, 2>& start,
    const std::array<scalar, 2>& size
)
{
    using point = std::array<scalar, 2>;
    struct corner { point x; scalar y; };
    std::array<corner, 3> s
    {{
        {start, f(start)},
        {{start[0] + size[0], start[1]}, f({start[0] + size[0], start[1]})},
        {{start[0], start[1] + size[1]}, f({start[0], start[1] + size[1]})}
    }};

    for (int k = 0; k < 400; ++k)
    {
        std::sort
        (
            s.begin(), s.end(),
            [](const corner& a, const corner& b) { return a.y < b.y; }
        );
        const scalar extent = std::max
        (
            std::fabs(s[2].x[0] - s[0].x[0]), std::fabs(s[2].x[1] - s[0].x[1])
        );
        if (extent < 1e-10) break;

        // from the worst corner through the middle of the others
        const auto along = [&](const scalar c)
        {
            point x;
            for (int d = 0; d < 2; ++d)
            {
                const scalar middle = 0.5*(s[0].x[d] + s[1].x[d]);
                x[d] = middle + c*(s[2].x[d] - middle);
            }
            return corner{x, f(x)};
        };
        const corner reflected = along(-1);
        if (reflected.y < s[0].y)
        {
            const corner expanded = along(-2);
            s[2] = expanded.y < reflected.y ? expanded : reflected;
        }
        else if (reflected.y < s[1].y)
        {
            s[2] = reflected;
        }
        else
        {
            const corner contracted = along(reflected.y < s[2].y ? -0.5 : 0.5);
            if (contracted.y < std::min(reflected.y, s[2].y))
            {
                s[2] = contracted;
            }
            else
            {
                for (int c = 1; c < 3; ++c)
                {
                    for (int d = 0; d < 2; ++d)
                    {
                        s[c].x[d] = 0.5*(s[0].x[d] + s[c].x[d]);
                    }
                    s[c].y = f(s[c].x);
                }
            }
        }
    }
    return s[0].x;
}


struct fitResult
{
    scalar alpha;
    scalar X;   // E^(-1/3) gamma^(5/6) [N^(1/2) m^(-1/6)]
};


fitResult fit
(
    const contactSettings& s,
    const scaledCollision& curve,
    const dictionary& dict
)
{
    const scalar factor = s.velocityFactor();

    std::vector<measurement> rebounds;
    for (const measurement& p : s.points)
    {
        if (p.e > 0) rebounds.push_back(p);
    }

    // X from one point, for given alpha; -1: above the plateau
    const auto fromPoint = [&](const scalar alpha, const measurement& p)
    {
        const scalar V = curve.velocityOf(alpha, p.e);
        return V > 0 ? factor*p.v/V : -1;
    };
    const auto squares = [&](const scalar alpha, const scalar X)
    {
        scalar sum = 0;
        for (const measurement& p : rebounds)
        {
            sum += sqr(curve.collide(alpha, factor*p.v/X).restitution - p.e);
        }
        return sum;
    };

    // The points that determine: the slowest rebound feels adhesion most, the
    // highest restitution is next to the plateau
    measurement slow = s.fitPoint;
    scalar highest = s.plateau;
    for (const measurement& p : rebounds)
    {
        if (!(s.fitPoint.v > 0) && (!(slow.v > 0) || p.v < slow.v)) slow = p;
        highest = std::max(highest, p.e);
    }
    if (slow.e >= highest)
    {
        dustProperties::error
        (
            dict,
            s.fitPoint.v > 0 ? "fitPoint" : "points",
            "the restitution " + Foam::name(slow.e) + " of the point that shall"
            " give the adhesion is not below the plateau",
            "a slower impact, whose restitution adhesion makes lower than "
          + Foam::name(highest)
        );
    }
    const scalar alphaMost = scaledCollision::alphaOf(0.01);

    if (s.plateau > 0)
    {
        const scalar alpha = scaledCollision::alphaOf(s.plateau);
        const scalar X = fromPoint(alpha, slow);
        if (X < 0 && s.fitPoint.v > 0)
        {
            FatalErrorInFunction << "No adhesion fits" << exit(FatalError);
        }
        if (s.fitPoint.v > 0)
        {
            return {alpha, X};
        }
        // one unknown; the second dimension is idle
        const auto best = lowest
        (
            [&](const std::array<scalar, 2>& x)
            {
                return squares(alpha, std::exp(x[0])) + sqr(x[1]);
            },
            {std::log(X), 0}, {0.05, 1e-3}
        );
        return {alpha, std::exp(best[0])};
    }

    // The plateau is a little above the highest restitution
    const scalar guess = scaledCollision::alphaOf
    (
        highest + 0.2*(1 - highest)
    );

    if (s.fitPoint.v > 0)
    {
        // alpha from the points, X from the one point
        const auto best = lowest
        (
            [&](const std::array<scalar, 2>& x)
            {
                if (x[0] < 0 || x[0] > alphaMost) return scalar(1e3);
                const scalar X = fromPoint(x[0], s.fitPoint);
                return X > 0 ? squares(x[0], X) + sqr(x[1]) : scalar(1e3);
            },
            {guess, 0}, {0.1*guess, 1e-3}
        );
        return {best[0], fromPoint(best[0], s.fitPoint)};
    }

    const auto best = lowest
    (
        [&](const std::array<scalar, 2>& x)
        {
            return
                x[0] < 0 || x[0] > alphaMost
              ? scalar(1e3)
              : squares(x[0], std::exp(x[1]));
        },
        {guess, std::log(fromPoint(guess, slow))}, {0.2*guess, 0.05}
    );
    return {best[0], std::exp(best[1])};
}


//- The dictionary to include
void writeContact
(
    const contactSettings& s,
    const fitResult& f,
    const scaledCollision& curve,
    const scalar softE,
    const scalar chi
)
{
    const scalar E = s.realE > 0 ? s.realE : softE;
    const scalar gamma = std::pow(f.X, 1.2)*std::pow(E, 0.4);

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
        << "// plateau restitution " << scaledCollision::plateauOf(f.alpha)
        << ", E^(-1/3) gamma^(5/6) = " << f.X << " N^(1/2) m^(-1/6)" << nl;
    if (s.points.size())
    {
        os  << "// v [m/s]  measured  fitted  residual" << nl;
    }
    for (const measurement& p : s.points)
    {
        const scalar e =
            curve.collide(f.alpha, s.velocityFactor()*p.v/f.X).restitution;
        os  << "//     " << p.v << "  " << p.e << "  " << e << "  " << e - p.e << nl;
    }
    os  << nl
        << "contact" << nl
        << "{" << nl
        << "    \"" << s.pair << "\"" << nl << "    {" << nl
        << "        normal  { model " << s.model << "; dampingCoefficient "
        << f.alpha << "; }" << nl
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

} // End namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "From measured restitutions of normal impacts to the damping coefficient,"
        " E^(-1/3) gamma^(5/6), and E_mod and gamma_mod for a limit of the"
        " overlap.\n\n"
        "Reads system/calibrateContactDict, e.g.\n"
        "    pair     dust.steel;  diameter 1.27e-6;  overlap 0.01;\n"
        "    points   ( (2.5 0.42) (5 0.71) (20 0.85) );    // m/s, -\n"
        "(all keywords: calibrateContact.C), writes constant/calibratedContact to"
        " #include at the end of constant/dustProperties, and"
        " postProcessing/calibrateContact/0/{fit,curve}.csv."
    );
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addBoolOption
    (
        "map",
        "Also write the restitution over alpha and 1/A* (map.csv)"
    );

    argList args(argc, argv);
    if (!args.checkRootCase())
    {
        FatalError.exit();
    }
    Time runTime
    (
        args.rootPath(), args.caseName(), "system", "constant", false, false
    );

    const IOdictionary dict
    (
        caseInput::mustRead("calibrateContactDict", runTime.system(), runTime)
    );
    const contactSettings s(readSettings(dict, runTime));
    const scaledCollision curve(s.model == "JKR");

    const fitResult f(fit(s, curve, dict));
    const scalar factor = s.velocityFactor();
    const scalar pi = constant::mathematical::pi;

    Info<< nl << s.pair << ": "
        << (s.wall ? "sphere on a wall" : "two equal spheres") << ", diameter "
        << 2*s.radius << " m, density " << s.density << " kg/m3, " << s.model << nl
        << "    damping coefficient alpha         " << f.alpha << nl
        << "    plateau restitution               "
        << scaledCollision::plateauOf(f.alpha) << nl
        << "    E^(-1/3) gamma^(5/6)              " << f.X
        << " N^(1/2) m^(-1/6)" << nl
        << "    sticking speed                    "
        << curve.sticking(f.alpha)*f.X/factor << " m/s" << nl;

    const fileName directory
    (
        runTime.globalPath()/"postProcessing"/"calibrateContact"/"0"
    );
    mkDir(directory);

    {
        OFstream os(directory/"fit.csv");
        os.precision(9);
        os  << "velocity_mps,restitution,fitted,residual,Astar" << nl;
        Info<< nl << "    v [m/s]     measured    fitted      residual    A*" << nl;
        scalar sum = 0;
        label n = 0;
        const auto report = [&](const measurement& p)
        {
            const scalar V = factor*p.v/f.X;
            const scalar e = curve.collide(f.alpha, V).restitution;
            const scalar A = scaledCollision::Astar(V);
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
        for (const measurement& p : s.points)
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

    {
        OFstream os(directory/"curve.csv");
        os.precision(9);
        os  << "velocity_mps,restitution" << nl;
        const scalar from =
            std::max(curve.sticking(f.alpha), scalar(1e-3))*f.X/factor;
        const scalar to = std::max(2*s.highestVelocity, 10*from);
        for (label k = 0; k <= 200; ++k)
        {
            const scalar v = from*std::pow(to/from, k/200.0);
            os  << v << ','
                << curve.collide(f.alpha, factor*v/f.X).restitution << nl;
        }
    }

    // Peak overlap at given X: q a0^2/R, a0^2 = (9 pi R^2 gamma/E)^(2/3), and
    // gamma/E = X^(6/5) E^(-3/5); so it goes as E^(-2/5)
    const scalar peak =
        curve.collide(f.alpha, factor*s.highestVelocity/f.X).peak;
    const scalar overlapAtOnePascal =
        peak*std::pow(9*pi*sqr(s.R())*std::pow(f.X, 1.2), 2.0/3.0)/s.R();
    const scalar softE = std::pow
    (
        overlapAtOnePascal/(2*s.radius*s.overlapLimit), 2.5
    );
    const scalar softGamma = std::pow(f.X, 1.2)*std::pow(softE, 0.4);
    scalar chi = 1;

    Info<< nl << "    For an overlap of " << s.overlapLimit
        << " of the diameter at " << s.highestVelocity << " m/s:" << nl
        << "    E_mod                             " << softE << " Pa (effective)"
        << nl
        << "    gamma_mod                         " << softGamma
        << " J/m2 (one surface)" << nl;
    if (s.realE > 0)
    {
        const scalar gamma = std::pow(f.X, 1.2)*std::pow(s.realE, 0.4);
        chi = softE/s.realE;
        Info<< "    real E                            " << s.realE
            << " Pa (effective)" << nl
            << "    real gamma                        " << gamma << " J/m2" << nl
            << "    chi = E_mod/E                     " << chi << nl;
        if (chi > 1)
        {
            chi = 1;
            Info<< "    WARNING: even the real material overlaps more than "
                << s.overlapLimit << " of the diameter: written with ratio 1" << nl;
        }
    }
    else
    {
        Info<< "    WARNING: without the real modulus (effectiveYoungsModulus, or"
            << " the materials in" << nl
            << "    constant/dustProperties) the softened contact is written as"
            << " if it were real:" << nl
            << "    rolling and sliding limits are then too weak" << nl;
    }

    writeContact(s, f, curve, softE, chi);
    Info<< nl << "    written to " << s.output << nl;

    if (args.found("map"))
    {
        OFstream os(directory/"map.csv");
        os.precision(9);
        os  << "alpha,inverseAstar,restitution" << nl;
        for (const scalar alpha : {0.0, 0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0})
        {
            // 1/A* = V over the V of A* = 1
            const scalar first = std::max
            (
                curve.sticking(alpha)/scaledCollision::VofAstar(1), scalar(0.1)
            );
            os  << alpha << ',' << first << ",0" << nl;
            for (label k = 0; k <= 150; ++k)
            {
                // dense next to sticking
                const scalar x = k/150.0;
                const scalar inverse = first*(1 + 1e-9)*std::pow(1e3/first, x*x);
                os  << alpha << ',' << inverse << ','
                    << curve.collide
                       (
                           alpha, scaledCollision::VofAstar(1/inverse)
                       ).restitution
                    << nl;
            }
        }
        Info<< "    map written to " << directory/"map.csv" << nl;
    }

    Info<< nl << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
