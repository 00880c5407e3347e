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

#include "rehearsal.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <chrono>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Run time of f [s]
template<class Function>
static scalar secondsOf(const Function& f)
{
    const auto start = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<scalar>
    (
        std::chrono::steady_clock::now() - start
    ).count();
}


//- One of the size; Uc: gas velocity [m/s]
static void add
(
    dem::System& scene,
    const int dust,
    const dem::RatioLoad& load,
    const dem::Vec3& x,
    const dem::Vec3& v,
    const dem::Vec3& Uc
)
{
    dem::Particle p;
    p.id = std::int64_t(scene.size());
    p.material = dust;
    p.radius = load.radius;
    p.mass = load.mass;
    p.x = x;
    p.v = v;
    const std::size_t i = scene.add(p);

    dem::GasLoad gas;
    gas.Sp = load.relaxationTime > 0 ? load.mass/load.relaxationTime : 0;
    gas.SpOmega = 4.0/3.0*sqr(load.radius)*gas.Sp;  // as Stokes' is to Sp
    gas.Uc = Uc;
    scene.setGasLoad(i, gas);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::rehearsal::touch
(
    const dem::System& system,
    const int dust,
    const dem::RatioLoad& load
)
{
    constexpr int most = 50000;     // contact steps
    const scalar r = load.radius;
    const scalar v = 0.5*load.speed;
    const dem::MaterialTable& table = system.materials();
    const auto& patches = system.walls().patches;

    dem::TimeSettings time(system.timeSettings());
    time.energyLedger = false;
    dem::System scene(table, time);
    dem::Walls walls;
    walls.patches = {{"wall", patches.empty() ? dust : patches.front().material}};
    walls.planes = {{dem::Vec3::Zero(), dem::Vec3(0, 0, 1), 0}};
    scene.setWalls(walls);
    add
    (
        scene, dust, load, dem::Vec3(0, 0, (1 + 1e-6)*r),
        std::sqrt(0.5)*dem::Vec3(v, 0, -v), dem::Vec3::Zero()
    );

    const dem::ContactFigures f = table.figures
    (
        dust, walls.patches.front().material, r, -1, load.mass, 0, v
    );
    const scalar dt = 10*f.period;
    contactSeconds_ = GREAT;
    scalar passed = 0;
    for (int k = 0; k < 1000 && stepsOfTouch_ < most; ++k)
    {
        dem::StepReport report;
        const scalar seconds = secondsOf([&]{ report = scene.advance(dt); });
        passed += dt;
        stepsOfTouch_ += scalar(report.contactSteps);
        if (report.contactSteps > 10)
        {
            contactSeconds_ =
                min(contactSeconds_, seconds/scalar(report.contactSteps));
        }
        if (scene.awake().empty())
        {
            break;
        }
    }
    contactSeconds_ = contactSeconds_ < GREAT ? contactSeconds_ : 0;
    // Still there and not at rest: so it will go on
    if
    (
        scene.awake().size()
     && scene.particle(0).x.z() < r
     && stepsOfTouch_ >= most
    )
    {
        steady_ = passed/max(stepsOfTouch_, scalar(1));
    }
}


void Foam::rehearsal::fly
(
    const dem::System& system,
    const int dust,
    const dem::RatioLoad& load
)
{
    constexpr int n = 10;           // along each side of a cube
    constexpr int steps = 10;
    const scalar apart = 100*load.radius;

    // What contact steps for all cost is not asked here
    dem::TimeSettings time(system.timeSettings());
    time.islands = true;
    dem::System scene(system.materials(), time);
    for (int k = 0; k < n*n*n; ++k)
    {
        const dem::Vec3 v(load.speed, 0, 0);
        add
        (
            scene, dust, load, apart*dem::Vec3(k%n, (k/n)%n, k/(n*n)), v, v
        );
    }
    flightSeconds_ = GREAT;
    for (int k = 0; k < steps; ++k)
    {
        const scalar seconds =
            secondsOf([&]{ scene.advance(load.radius/load.speed); });
        flightSeconds_ = min(flightSeconds_, seconds/(n*n*n));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rehearsal::rehearsal
(
    const dem::System& system,
    const int dust,
    const dem::RatioLoad& load
)
{
    if (load.speed > 0)
    {
        try
        {
            touch(system, dust, load);
            fly(system, dust, load);
        }
        catch (const std::exception& e)
        {
            // What it costs is the least of it
            WarningInFunction
                << "No forecast of contacts and flights: a touch of a wall at "
                << load.speed << " m/s: " << e.what() << endl;
        }
    }
    reduce(contactSeconds_, maxOp<scalar>());
    reduce(flightSeconds_, maxOp<scalar>());
}


// ************************************************************************* //
