// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ballistic packing (case P): a column of spheres falls at 1.5 m/s on a floor, periodic in
// x and y, without gravity and gas, and sticks. Lengths in radii r = 5 um: cell 28 x 28; N
// spheres at even distances between z = 1.1 and 160 N/2000, at random places beside each
// other, so that the first one reaches the floor at once.
//
//   ballisticPacking write SEED N FILE      the column as a LAMMPS data file (units micro)
//   ballisticPacking header                 header line of the rows below (CSV)
//   ballisticPacking run CHI SEED N STEPS_PER_CONTACT REST_TOLERANCE PARTICLE_STEP_us [progress]
//       one row; progress: a line every 20 us on stderr
//   ballisticPacking lammps CHI SEED N STEP_tC CPU_s FILE
//       a row from the data file that LAMMPS has written and the CPU time it has taken
//
// It goes on for 500 us N/2000 + 60 us. The last 20 us are with rest off (the thaw), before
// the statistics are taken; their CPU time counts.
//
// Statistics, of sphere-sphere contacts with delta > 0:
//   phi       solid fraction between 0.15 H and 0.85 H, H = 2 <z>
//   Z         contacts per sphere whose centre is there
//   rolled    plastic rolling of a contact since it was formed, summed over all steps by the
//             rolling law itself, in units of xi_crit = criticalAngle R; mean over contacts
//   overlaps  percentiles of delta/delta_0
// Steps are given in t_C = r (rho^2/(E^2 U))^(1/5), E the softened Young's modulus.
#include "DEM.hpp"

#include "contactModels/contactModel/newComposite.hpp"
#include "contactModels/normal/JKR.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// * * * * * * * * * * * A rolling law that records its plastic path * * * * * * * * * * * //

namespace
{

//- Where the rolling part puts what each contact of one call has rolled beyond xi_crit
thread_local double* excess = nullptr;

struct recordingSlider : dem::rolling::springSlider
{
    //- Asked of every contact in turn, and once more before a cut
    template<class Real>
    [[gnu::always_inline]] static auto yields
    (
        const Real* c, const Real& R, const dem::NormalResponse<Real>& normal,
        const dem::V3<Real>& xi
    )
    {
        const auto result = springSlider::yields(c, R, normal, xi);
        Real path(0);
        if (dem::any(result))
        {
            const Real limit = c[0]*R;
            path = dem::maximum(dem::squareRoot(dot(xi, xi)) - limit, Real(0))/limit;
        }
        dem::storeReal<Real>(excess, path);
        excess += dem::laneCount<Real>;
        return result;
    }

    template<class Real>
    [[gnu::always_inline]] static Real cut
    (
        const Real* c, const Real& R, const dem::NormalResponse<Real>& normal,
        const dem::V3<Real>& xi
    )
    {
        excess -= dem::laneCount<Real>;
        return springSlider::cut(c, R, normal, xi);
    }
};

using Parts = dem::Composite
<
    dem::normal::JKR, dem::tangential::springDashpotSlider, recordingSlider,
    dem::twisting::springDashpotSlider
>;

//- One more history column: the plastic path [xi_crit]
class Recording : public Parts
{
    template<class Evaluate>
    static bool record
    (
        dem::ContactList& list, std::size_t begin, std::size_t end, const Evaluate& evaluate
    )
    {
        static thread_local std::vector<double> beyond;
        beyond.resize(std::max(beyond.size(), end - begin + dem::packWidth));
        excess = beyond.data();
        const bool ended = evaluate();
        if (excess != beyond.data() + (end - begin))
        {
            throw std::logic_error("the rolling law was not called once per contact");
        }
        double* path = list.history.back().data();
        for (std::size_t k = begin; k < end; ++k) path[k] += beyond[k - begin];
        return ended;
    }

public:

    int nHistory() const override { return Parts::nHistory() + 1; }

    bool evaluatePairs
    (
        dem::ContactList& list, std::size_t begin, std::size_t end,
        const dem::Body* bodies, dem::Load* loads, const dem::SpringStep& step, double sign,
        const dem::Periodic& periodic
    ) const override
    {
        return record(list, begin, end, [&]
        {
            return Parts::evaluatePairs
            (
                list, begin, end, bodies, loads, step, sign, periodic
            );
        });
    }

    bool evaluateWalls
    (
        dem::ContactList& list, std::size_t begin, std::size_t end,
        const dem::Body* bodies, dem::Load* loads, const dem::SpringStep& step, double sign
    ) const override
    {
        return record(list, begin, end, [&]
        {
            return Parts::evaluateWalls(list, begin, end, bodies, loads, step, sign);
        });
    }

    //- Asks the law as well; nothing to record
    dem::ContactEnergy energy
    (
        const dem::ContactList& list, std::size_t k, const dem::Body* bodies, double ahead,
        const dem::Periodic& periodic
    ) const override
    {
        double none;
        excess = &none;
        return Parts::energy(list, k, bodies, ahead, periodic);
    }
};

}

namespace dem
{
// Takes the place of the library's own, so that its table of laws makes ours
template<>
std::unique_ptr<ContactLaw> newComposite<normal::JKR>(const ContactSettings&)
{
    return std::make_unique<Recording>();
}
}

// * * * * * * * * * * * * * * * * * * The packing * * * * * * * * * * * * * * * * * * * * //

namespace
{

constexpr double radius = 5e-6, density = 1000, cell = 28*radius, speed = 1.5;
constexpr double youngsModulus = 3.8e9, poissonRatio = 0.33, surfaceEnergy = 0.05;
constexpr double damping = 0.178, friction = 0.3, criticalAngle = 0.0085;
constexpr double thaw = 20e-6;

double mass() { return density*4/3*M_PI*radius*radius*radius; }

double duration(int n) { return 500e-6*n/2000 + 60e-6; }

dem::Periodic periodic()
{
    dem::Periodic p;
    p.length = dem::Vec3(cell, cell, 0);
    return p;
}

std::vector<dem::Vec3> column(unsigned seed, int n)
{
    std::mt19937_64 engine(seed);
    const auto uniform = [&] { return std::ldexp(double(engine() >> 11), -53); };
    std::vector<dem::Vec3> all;
    const dem::Periodic p = periodic();
    const double height = 160.0*n/2000;
    for (int k = 0; k < n; ++k)
    {
        const double z = radius*(1.1 + (height - 1.1)*k/(n - 1));
        dem::Vec3 x;
        const auto taken = [&]
        {
            const std::size_t last = std::min<std::size_t>(all.size(), 120);
            return std::any_of
            (
                all.end() - std::ptrdiff_t(last), all.end(),
                [&](const dem::Vec3& y) { return p.nearest(y - x).norm() < 2.02*radius; }
            );
        };
        do
        {
            const double a = uniform(), b = uniform();
            x = dem::Vec3(cell*a, cell*b, z);
        } while (taken());
        all.push_back(x);
    }
    return all;
}

void write(unsigned seed, int n, const char* name)
{
    std::FILE* f = std::fopen(name, "w");
    std::fprintf(f, "ballistic packing\n\n%d atoms\n1 atom types\n\n", n);
    std::fprintf
    (
        f, "0 %.9g xlo xhi\n0 %.9g ylo yhi\n-1 %.9g zlo zhi\n\nAtoms\n\n",
        cell*1e6, cell*1e6, (160.0*n/2000 + 10)*radius*1e6
    );
    const auto x = column(seed, n);
    for (int k = 0; k < n; ++k)
    {
        const dem::Vec3 p = 1e6*x[std::size_t(k)];
        std::fprintf(f, "%d 1 10 1 %.12g %.12g %.12g\n", k + 1, p.x(), p.y(), p.z());
    }
    std::fprintf(f, "\nVelocities\n\n");
    for (int k = 0; k < n; ++k) std::fprintf(f, "%d 0 0 %.12g 0 0 0\n", k + 1, -speed);
    std::fclose(f);
}


//- Centre positions and the contacts between spheres, in SI
struct Packing
{
    std::vector<dem::Vec3> x;
    struct Contact { int i, j; double overlap, rolled; };   // rolled < 0: not recorded
    std::vector<Contact> contacts;
};

//- t_C [s]
double timeUnit(double chi)
{
    return radius*std::pow(density*density/(std::pow(chi*youngsModulus, 2)*speed), 0.2);
}

//- delta_0 of two spheres as softened [m]
double equilibriumOverlap(double chi)
{
    const double R = radius/2;
    const double E = chi*youngsModulus/(2*(1 - poissonRatio*poissonRatio));
    const double a0 =
        std::cbrt(9*M_PI*std::pow(chi, 0.4)*surfaceEnergy*R*R/E);
    return a0*a0/(3*R);
}

void printStatistics(const Packing& p, double chi)
{
    const double n = double(p.x.size());
    double height = 0;
    for (const dem::Vec3& x : p.x) height += 2*x.z()/n;
    const double z0 = 0.15*height, z1 = 0.85*height;

    // volume of a sphere at z below a plane at b, but for a constant
    const auto below = [](double b, double z)
    {
        const double t = std::clamp(b - z, -radius, radius);
        return M_PI*(radius*radius*t - t*t*t/3);
    };
    double solid = 0;
    std::vector<int> count(p.x.size(), 0);
    for (const dem::Vec3& x : p.x) solid += below(z1, x.z()) - below(z0, x.z());

    std::vector<double> overlaps;
    double rolled = 0;
    for (const Packing::Contact& c : p.contacts)
    {
        if (c.overlap <= 0) continue;
        overlaps.push_back(c.overlap/equilibriumOverlap(chi));
        rolled += c.rolled;
        ++count[std::size_t(c.i)];
        ++count[std::size_t(c.j)];
    }
    std::sort(overlaps.begin(), overlaps.end());
    double inside = 0, partners = 0;
    for (std::size_t k = 0; k < p.x.size(); ++k)
    {
        if (p.x[k].z() < z0 || p.x[k].z() > z1) continue;
        ++inside;
        partners += count[k];
    }
    const auto percentile = [&](double q)
    {
        return overlaps.at(std::size_t(q*double(overlaps.size() - 1)));
    };
    const bool recorded = !p.contacts.empty() && p.contacts[0].rolled >= 0;
    std::printf
    (
        "%.5f,%.4f,%s,%.4f,%.4f,%.4f,%zu\n",
        solid/(cell*cell*(z1 - z0)), partners/inside,
        recorded ? std::to_string(rolled/double(overlaps.size())).c_str() : "",
        percentile(0.1), percentile(0.5), percentile(0.9), overlaps.size()
    );
}

void printHeader()
{
    std::puts
    (
        "code,chi,seed,particles,stepsPerContact,step_tC,restTolerance,particleStep_us,"
        "cpu_s,thawCpu_s,contactSteps,contactUpdates,awakeShare,sleeps,wakes,"
        "removedEnergyShare,formed,broken,phi,Z,rolled_xiCrit,overlapP10_delta0,"
        "overlapP50_delta0,overlapP90_delta0,contacts"
    );
}


dem::ContactSettings contact(double R)
{
    // eta_R = R alpha (0.8 m k_r)^(1/2), k_r = 4 F_C/R = 12 pi gamma, both of the real
    // sphere: the dashpot of the peers' input
    const double rollingDamping =
        R*damping*std::sqrt(0.8*mass()*12*M_PI*surfaceEnergy);
    dem::ContactSettings s;
    s.normal = {"JKR", {{"dampingCoefficient", damping}}};
    s.tangential = {"springDashpotSlider", {{"friction", friction}}};
    s.rolling =
    {
        "springSlider",
        {{"criticalAngle", criticalAngle}, {"rollingDamping", rollingDamping}}
    };
    s.twisting = {"springDashpotSlider", {}};
    return s;
}

std::unique_ptr<dem::System> newSystem(double chi, const dem::TimeSettings& time)
{
    dem::ReducedStiffness soft;
    soft.ratio = chi;
    auto system = std::make_unique<dem::System>
    (
        dem::MaterialTable
        (
            {
                {"dust", density, youngsModulus, poissonRatio, surfaceEnergy},
                {"floor", 0, youngsModulus, poissonRatio, surfaceEnergy}
            },
            contact(radius/2), {{"dust.floor", contact(radius)}}, soft
        ),
        time
    );
    dem::Walls walls;
    walls.patches.push_back({"floor", 1});
    walls.planes.push_back({dem::Vec3::Zero(), dem::Vec3::UnitZ(), 0});
    system->setWalls(walls);
    system->setPeriodic(periodic());
    return system;
}

//- The same state with rest off
std::unique_ptr<dem::System> thawed(const dem::System& from, double chi)
{
    dem::TimeSettings time = from.timeSettings();
    time.restTolerance = 0;
    auto to = newSystem(chi, time);
    to->setTime(from.time());
    for (std::size_t k = 0; k < from.size(); ++k) to->add(from.particle(k));
    for (std::size_t k = 0; k < from.size(); ++k)
    {
        to->unpackState(k, from.packState(k));
        const dem::Particle& p = to->particle(k);
        to->setMotion(k, p.x, p.v, p.omega);    // wakes it
    }
    return to;
}

Packing packing(const dem::System& system)
{
    Packing p;
    for (std::size_t k = 0; k < system.size(); ++k) p.x.push_back(system.particle(k).x);
    for (std::size_t k = 0; k < system.size(); ++k)
    {
        // the history is the end of each contact in the packed state
        constexpr std::size_t before = dem::PackedState::contactNumbers - dem::maxHistory;
        const auto state = system.packState(k);
        for
        (
            std::size_t c = dem::PackedState::restNumbers;
            c < state.size();
            c += dem::PackedState::contactNumbers
        )
        {
            const int j = int(state[c + dem::PackedState::partner]);
            if (j < 0) continue;
            const dem::Vec3 d = periodic().nearest(p.x[std::size_t(j)] - p.x[k]);
            p.contacts.push_back
            (
                {
                    int(k), j, 2*radius - d.norm(),
                    state[c + before + std::size_t(Recording().nHistory()) - 1]
                }
            );
        }
    }
    return p;
}


int run(int argc, char** argv)
{
    if (argc < 8) return 1;
    const double chi = std::atof(argv[2]);
    const unsigned seed = unsigned(std::atoi(argv[3]));
    const int n = std::atoi(argv[4]);
    dem::TimeSettings time;
    time.stepsPerContact = std::atof(argv[5]);
    time.restTolerance = std::atof(argv[6]);
    const double dt = 1e-6*std::atof(argv[7]);
    const bool progress = argc > 8;

    auto system = newSystem(chi, time);
    std::int64_t id = 0;
    for (const dem::Vec3& x : column(seed, n))
    {
        system->add({id, 0, radius, mass(), x, dem::Vec3(0, 0, -speed), dem::Vec3::Zero()});
        ++id;
    }

    const int steps = int(std::lround(duration(n)/dt));
    const int thawAt = int(std::lround((duration(n) - thaw)/dt));
    dem::StepReport all;
    double awake = 0, touching = 0, cpuThaw = 0;
    std::int64_t updatesShown = 0;
    const std::clock_t start = std::clock();
    const auto cpu = [&] { return double(std::clock() - start)/CLOCKS_PER_SEC; };
    for (int k = 0; k < steps; ++k)
    {
        if (k == thawAt && time.restTolerance > 0)
        {
            cpuThaw = -cpu();
            system = thawed(*system, chi);
        }
        const dem::StepReport r = system->advance(dt);
        all.add(r);
        if (k < thawAt)
        {
            touching += double(r.inContact);
            awake += double(r.inContact - r.resting);
        }
        if (progress && (k + 1)%int(std::lround(20e-6/dt)) == 0)
        {
            std::fprintf
            (
                stderr, "t_us %.0f cpu_s %.3f updates %ld steps %ld inContact %ld resting %ld "
                "sleeps %ld wakes %ld\n",
                system->time()*1e6, cpu(), long(all.contactUpdates - updatesShown),
                long(all.contactSteps), long(r.inContact), long(r.resting),
                long(all.sleeps), long(all.wakes)
            );
            updatesShown = all.contactUpdates;
        }
    }
    const double total = cpu();
    if (cpuThaw < 0) cpuThaw += total;
    std::printf
    (
        "dustFoam,%g,%u,%d,%g,%.4f,%g,%g,%.3f,%.3f,%ld,%ld,%.4f,%ld,%ld,%.3g,%ld,%ld,",
        chi, seed, n, time.stepsPerContact,
        duration(n)/double(all.contactSteps)/timeUnit(chi), time.restTolerance, dt*1e6,
        total, cpuThaw, long(all.contactSteps), long(all.contactUpdates), awake/touching,
        long(all.sleeps), long(all.wakes),
        all.energyRemovedByRest/(n*0.5*mass()*speed*speed),
        long(all.touches), long(all.separations)
    );
    printStatistics(packing(*system), chi);
    return 0;
}


//- Of a data file that LAMMPS has written; it has no record of rolling
int lammps(char** argv)
{
    const double chi = std::atof(argv[2]);
    Packing p;
    std::ifstream file(argv[7]);
    std::string line;
    bool atoms = false;
    while (std::getline(file, line))
    {
        std::istringstream words(line);
        double id, type, d, rho, x, y, z;
        if (line.compare(0, 5, "Atoms") == 0) atoms = true;
        else if (line.compare(0, 10, "Velocities") == 0) break;
        else if (atoms && words >> id >> type >> d >> rho >> x >> y >> z)
        {
            p.x.push_back(periodic().wrapped(1e-6*dem::Vec3(x, y, z)));
        }
    }
    for (std::size_t i = 0; i < p.x.size(); ++i)
    {
        for (std::size_t j = i + 1; j < p.x.size(); ++j)
        {
            const double overlap =
                2*radius - periodic().nearest(p.x[j] - p.x[i]).norm();
            if (overlap > 0) p.contacts.push_back({int(i), int(j), overlap, -1});
        }
    }
    std::printf
    (
        "LAMMPS,%s,%s,%s,,%s,,,%s,,,,,,,,,,", argv[2], argv[3], argv[4], argv[5], argv[6]
    );
    printStatistics(p, chi);
    return 0;
}

}


int main(int argc, char** argv)
{
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "run") return run(argc, argv);
    if (what == "write" && argc > 4)
    {
        write(unsigned(std::atoi(argv[2])), std::atoi(argv[3]), argv[4]);
        return 0;
    }
    if (what == "lammps" && argc > 7) return lammps(argv);
    if (what == "header")
    {
        printHeader();
        return 0;
    }
    return 1;
}
