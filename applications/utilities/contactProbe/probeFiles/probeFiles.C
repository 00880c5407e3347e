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

#include "probeFiles.H"

#include "IOmanip.H"
#include "OFstream.H"
#include "unitConversion.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Collisions that are printed, and not only written
static constexpr label mostPrinted = 40;


class csvFile
{
    OFstream os_;

public:

    csvFile(const fileName& name, const char* header)
    :
        os_(name)
    {
        if (!os_.good())
        {
            FatalErrorInFunction
                << "Cannot write " << name << exit(FatalError);
        }
        os_.precision(9);
        os_ << header << nl;
    }

    template<class Type>
    csvFile& operator<<(const Type& value)
    {
        os_ << value;
        return *this;
    }
};


//- `base` of FILE as base.csv
static fileName beside(const fileName& csv, const char* what)
{
    return csv.lessExt() + "_" + what + ".csv";
}


//- As one cell of a table that is read by commas and lines
static std::string cell(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        result += c == ',' ? ';' : c == '\n' ? ' ' : c;
    }
    return result.empty() ? "none" : result;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::probeFiles::fastest(const probeSettings& settings)
{
    return *std::max_element
    (
        settings.velocities().begin(), settings.velocities().end()
    );
}


Foam::string Foam::probeFiles::padded
(
    const std::string& text,
    const std::size_t width
)
{
    return text + std::string(width > text.size() ? width - text.size() : 1, ' ');
}


void Foam::probeFiles::writeCollisions
(
    const std::vector<pairSeries>& all,
    const probeSettings& settings,
    const fileName& csv,
    const bool withHistory
)
{
    csvFile table
    (
        csv,
        "pair,chi,velocity_mps,angle_deg,restitution,contactTime_s,"
        "maxOverlap_m,outcome,tangentialRestitution,spinAfter_radps,"
        "reboundAngle_deg,reason"
    );
    autoPtr<csvFile> histories;
    if (withHistory)
    {
        histories.reset
        (
            new csvFile
            (
                beside(csv, "history"),
                "pair,chi,velocity_mps,angle_deg,time_s,overlap_m,"
                "closingSpeed_mps,normalForce_N,slip_m,roll_m"
            )
        );
    }

    const label total =
        all.size()*all.front().soft.size()
       *settings.velocities().size()*settings.angles().size();
    const bool print = total <= mostPrinted;

    Info<< nl << total << " collisions";
    if (print)
    {
        Info<< ":" << nl << "    "
            << padded("pair", 20).c_str()
            << setw(9) << "chi" << setw(11) << "m/s" << setw(8) << "degree"
            << setw(13) << "restitution" << setw(14) << "time [s]"
            << setw(14) << "overlap [m]" << setw(13) << "tangential"
            << setw(14) << "spin [rad/s]" << "  outcome" << nl;
    }

    FixedList<label, 5> count(Zero);
    string firstReason;
    std::vector<contactPair::moment> history;

    for (const pairSeries& series : all)
    {
        for (const contactPair& p : series.soft)
        {
            const scalar chi = p.constants().chi;
            for (const scalar v : settings.velocities())
            {
                for (const scalar angle : settings.angles())
                {
                    history.clear();
                    const contactPair::collision c = p.collide
                    (
                        v,
                        degToRad(angle),
                        settings.tangentialForce(),
                        settings.duration(),
                        withHistory ? &history : nullptr
                    );
                    const word outcome(contactPair::outcomeNames[c.outcome]);
                    ++count[c.outcome];

                    table
                        << series.pair.name << ',' << chi << ',' << v << ','
                        << angle << ',' << c.restitution << ',' << c.contactTime
                        << ',' << c.maxOverlap << ',' << outcome << ','
                        << c.tangentialRestitution << ',' << c.spin << ','
                        << radToDeg(c.reboundAngle) << ','
                        << cell(c.reason).c_str() << nl;
                    if (firstReason.empty())
                    {
                        firstReason = c.reason;
                    }

                    if (print)
                    {
                        Info<< "    " << padded(series.pair.name, 20).c_str()
                            << setw(9) << chi << setw(11) << v << setw(8) << angle
                            << setw(13) << c.restitution
                            << setw(14) << c.contactTime
                            << setw(14) << c.maxOverlap
                            << setw(13) << c.tangentialRestitution
                            << setw(14) << c.spin
                            << "  " << outcome << endl;
                    }
                    for (const contactPair::moment& m : history)
                    {
                        *histories
                            << series.pair.name << ',' << chi << ',' << v << ','
                            << angle << ',' << m.time << ',' << m.overlap << ','
                            << m.closingSpeed << ',' << m.normalForce << ','
                            << m.slip << ',' << m.roll << nl;
                    }
                }
            }
        }
    }

    Info<< (print ? "    " : ": ");
    for (const auto o :
        {
            contactPair::REBOUND, contactPair::STICK,
            contactPair::ROLL, contactPair::SLIDE, contactPair::REFUSED
        })
    {
        Info<< count[o] << ' ' << contactPair::outcomeNames[o]
            << (o == contactPair::REFUSED ? "" : ", ");
    }
    Info<< nl;
    if (count[contactPair::REFUSED])
    {
        Info<< "    WARNING: " << count[contactPair::REFUSED] << " of " << total
            << " cannot be computed: choose a stiffer material (chi) or a lower"
            << " velocity. The first: " << firstReason.c_str() << nl;
    }
    Info<< "    written to " << csv << nl;
}


void Foam::probeFiles::writeSticking
(
    const std::vector<pairSeries>& all,
    const fileName& csv
)
{
    const fileName name(beside(csv, "sticking"));
    csvFile table(name, "pair,chi,stickingSpeed_mps,lambda,Ad,lambdaOverAd52");

    Info<< nl << "Sticking speed, normal impact:" << nl;
    for (const pairSeries& series : all)
    {
        for (const contactPair& p : series.soft)
        {
            const scalar v = p.stickingSpeed();
            const dem::PairConstants& c = p.constants();

            Info<< "    " << padded(series.pair.name, 20).c_str() << "chi" << setw(10)
                << c.chi << ": ";
            if (v == 0)
            {
                Info<< "never sticks" << nl;
                table << series.pair.name << ',' << c.chi << ",0,inf,inf,nan" << nl;
                continue;
            }
            if (v < 0)
            {
                Info<< "sticks at every speed that can be computed" << nl;
                table << series.pair.name << ',' << c.chi << ",inf,0,0,nan" << nl;
                continue;
            }

            const scalar rho =
                p.table().materials()[std::size_t(p.pair().i)].density;
            const scalar lambda = c.E/(rho*v*v);
            const scalar Ad =
                p.pair().wall
              ? 3*c.gamma/(rho*v*v*p.radius())
              : c.gamma/(rho*v*v*p.figures(0).R);
            Info<< v << " m/s";
            table << series.pair.name << ',' << c.chi << ',' << v << ',';
            if (Ad > 0)
            {
                const scalar factor = lambda/std::pow(Ad, 2.5);
                Info<< ", lambda " << lambda << ", Ad " << Ad
                    << ", lambda/Ad^(5/2) " << factor << nl;
                table << lambda << ',' << Ad << ',' << factor << nl;
            }
            else
            {
                // an attraction that does not come from surface energy
                Info<< nl;
                table << lambda << ",0,nan" << nl;
            }
        }
    }
    Info<< "    (lambda = E/(rho v^2); Ad = 3 gamma/(rho v^2 r) on a wall,"
        << " gamma/(rho v^2 R) for two spheres)" << nl
        << "    written to " << name << nl;
}


void Foam::probeFiles::writeForceOverlap
(
    const std::vector<pairSeries>& all,
    const probeSettings& settings,
    const fileName& csv
)
{
    const fileName name(beside(csv, "forceOverlap"));
    csvFile table(name, "pair,chi,branch,overlap_m,force_N");

    for (const pairSeries& series : all)
    {
        for (const contactPair& p : series.soft)
        {
            heldContact contact(p, fastest(settings));
            const scalar touch = p.touchGap();
            const scalar neck = std::max(p.figures(0).deltaC, touch);

            scalarList turns(settings.curveOverlaps());
            if (turns.empty())
            {
                const auto c = p.collide(fastest(settings));
                turns = scalarList
                (
                    1,
                    c.outcome == contactPair::REFUSED
                  ? 0.5*p.smallerRadius() : c.maxOverlap
                );
            }
            // out to the end at last
            turns.append(-std::max(1.05*neck, 1e-6*p.radius()));

            bool touching;
            scalar now = -touch;
            scalar before = 0;
            label branch = 0;
            const auto write = [&](const scalar overlap, const scalar force)
            {
                table
                    << series.pair.name << ',' << p.constants().chi << ','
                    << branch << ',' << overlap << ',' << force << nl;
                before = overlap;
            };
            write(now, 0);
            for (const scalar to : turns)
            {
                const label n = settings.curvePoints();
                for (label k = (branch ? 1 : 0); k <= n; ++k)
                {
                    // denser towards the turning point where the contact
                    // opens, as the neck's end is steep
                    const scalar s = scalar(k)/n;
                    const scalar overlap = std::max
                    (
                        now + (to - now)*(to < now ? s*(2 - s) : s),
                        branch || touch > 0 ? -1e300 : 1e-12*p.radius()
                    );
                    const scalar force = contact.press(overlap, touching);
                    if (!touching)
                    {
                        // the jump to nothing
                        write(before, 0);
                        break;
                    }
                    write(overlap, force);
                }
                now = to;
                ++branch;
                if (!touching) break;
            }
        }
    }
    Info<< "    written to " << name << nl;
}


void Foam::probeFiles::writeResistance
(
    const std::vector<pairSeries>& all,
    const probeSettings& settings,
    const heldContact::motionType motion,
    const fileName& csv
)
{
    const word& what = heldContact::motionNames[motion];
    const fileName name(beside(csv, what.c_str()));
    autoPtr<csvFile> table;

    for (const pairSeries& series : all)
    {
        for (const contactPair& p : series.soft)
        {
            heldContact contact(p, fastest(settings));
            const heldContact::resistance r = contact.limit(motion);
            if (!(r.stiffness > 0))
            {
                continue;
            }
            if (!table.valid())
            {
                table.reset
                (
                    new csvFile
                    (
                        name,
                        motion == heldContact::SLIDING
                      ? "pair,chi,displacement_m,force_N"
                      : motion == heldContact::ROLLING
                      ? "pair,chi,displacement_m,moment_Nm"
                      : "pair,chi,angle_rad,moment_Nm"
                    )
                );
            }

            const auto curve = contact.cycle
            (
                motion,
                r.limit > 0 ? 2.5*r.displacement : 0.01*p.radius(),
                settings.curvePoints()
            );
            for (const heldContact::point& x : curve)
            {
                *table
                    << series.pair.name << ',' << p.constants().chi << ','
                    << x.displacement << ',' << x.load << nl;
            }
        }
    }
    if (table.valid())
    {
        Info<< "    written to " << name << nl;
    }
}


// ************************************************************************* //
