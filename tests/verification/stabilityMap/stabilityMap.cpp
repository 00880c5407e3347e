// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stability map: every contact law through stiff and extreme cases. See README.md.
//
//     stabilityMap run COUNT [FIRST]   -> cases.csv, map.csv, worst.csv, summary on stdout
//     stabilityMap case NUMBER [FINER] one case: its input, course and verdict; also the course
//                                      with FINER times the steps
//     stabilityMap wrong BY COUNT [FIRST]  of the cases judged by their energy: in how many
//                                      a run with wrong numbers (wrongBy) is found
#include "DEM.hpp"
#include "contactModels/contactModel/ContactLaw.hpp"
#include "contactModels/contactModel/contactModelTable.hpp"
#include "contactFormulas.hpp"
#include "island/Island.hpp"

#include <algorithm>
#include <array>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <sys/time.h>

using dem::Vec3;

namespace
{

constexpr double pi = formula::pi;

// * * * * * * * * * * * * * * * * Random numbers * * * * * * * * * * * * * * * * * * * //

//- A function of case number and counter alone, so that one case can be repeated
class Random
{
public:

    explicit Random(std::uint64_t seed) : state_(mix(seed + 0x1234567ull)) {}

    double uniform()
    {
        state_ += 0x9E3779B97F4A7C15ull;
        return double(mix(state_) >> 11)*0x1.0p-53;
    }
    double uniform(double low, double high) { return low + (high - low)*uniform(); }
    double logUniform(double low, double high) { return low*std::pow(high/low, uniform()); }
    int below(int n) { return int(uniform()*n); }
    Vec3 direction()
    {
        const double z = uniform(-1, 1), a = uniform(0, 2*pi), s = std::sqrt(1 - z*z);
        return {s*std::cos(a), s*std::sin(a), z};
    }

private:

    static std::uint64_t mix(std::uint64_t z)
    {
        z = (z ^ (z >> 30))*0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27))*0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};


// * * * * * * * * * * * * * * * * * * Axes * * * * * * * * * * * * * * * * * * * * * * //

enum AxisIndex
{
    youngs, diameter, gammaAxis, speedAxis, restitution, sizeRatio, massRatio, chiAxis, stepAxis,
    overlapAxis, tauAxis, contactsAxis, gravityAxis, nAxes
};

struct Axis { const char* name; double low, high; };

// chi = 1, gamma = 0, overlap = 0, ... lie outside their logarithmic range: a bin of their own
const Axis axes[nAxes] =
{
    {"E_Pa", 1e6, 1e13}, {"d_m", 1e-7, 5e-3}, {"gamma_Jpm2", 1e-3, 10},
    {"v_mps", 1e-9, 500}, {"e", 0.01, 1}, {"sizeRatio", 1, 1000}, {"massRatio", 1, 1e6},
    {"chi", 1e-6, 1}, {"stepOverBound", 0.05, 2}, {"overlapOverD", 1e-4, 0.1},
    {"tauOverStep", 1e-6, 1e6}, {"contacts", 1, 5000}, {"g", 1, 1e6}
};

constexpr int nBins = 8;

// The library refuses overlaps above 0.45 of the smaller diameter; up to here a coarse and a
// fine integration may differ about that
constexpr double nearLimit = 0.35;

// Overlaps are differences of coordinates: what they are known to
constexpr double resolution = 4e-15;

//- -1: off (0, or 1 for chi)
int bin(int axis, double value)
{
    const Axis& a = axes[axis];
    if (value == 0 || (axis == chiAxis && value == 1)) return -1;
    const double x = std::log(value/a.low)/std::log(a.high/a.low);
    return std::min(nBins - 1, std::max(0, int(x*nBins)));
}


// * * * * * * * * * * * * * * * * * * Laws * * * * * * * * * * * * * * * * * * * * * * //

using Parts = std::array<dem::PartEntry, 4>;

//- What numbers are made for
struct Scale { double E, R, gamma, e; };

double sampleValue(const std::string& keyword, const Scale& s, Random& random)
{
    if (keyword == "restitution") return s.e;
    if (keyword == "dampingCoefficient") return random.uniform(0, 2);
    if (keyword == "friction") return random.uniform(0, 1);
    if (keyword == "criticalAngle") return random.logUniform(1e-3, 0.1);
    if (keyword == "adhesionHysteresis") return random.logUniform(0.01, 1);
    if (keyword == "rollingDamping" || keyword == "twistingDamping")
    {
        // from nothing to far above what is critical for the rolling mode
        if (random.below(3) == 0) return 0;
        const double m = 4000*s.R*s.R*s.R, F = 3*pi*s.R*std::max(s.gamma, 1e-6);
        const double critical = std::sqrt(m*F*s.R);
        return random.logUniform(1e-3, 30)*critical*(keyword[0] == 't' ? s.R : 1);
    }
    if (keyword == "cutOff") return random.uniform(1.65e-10, 4e-10);
    if (keyword == "range") return random.logUniform(2e-9, 2e-8);
    if (keyword == "yieldStrength") return std::max(1.0, s.E*random.logUniform(1e-3, 1e-2));
    if (keyword == "attraction") return 3*pi*s.R*s.gamma;
    if (keyword == "attractionPerRadius") return 3*pi*s.gamma;
    if (keyword == "attractionBuildUp") return random.uniform(0, 0.5);
    if (keyword == "softening") return random.below(2) ? 1 : random.logUniform(1e-6, 1);
    if (keyword == "dampingRatio") return random.below(2) ? 0 : random.uniform(0, 1);
    if (keyword == "bendingFactor") return random.uniform(0.1, 2);
    if (keyword == "twistingFactor") return random.uniform(0.1, 1);
    throw std::logic_error("stabilityMap.cpp needs a sample value for " + keyword);
}

const std::vector<std::string> alternatives[] =
{
    {"restitution", "dampingCoefficient"}, {"restitution", "unloading"},
    {"criticalAngle", "adhesionHysteresis"}, {"attraction", "attractionPerRadius"}
};

dem::PartSettings sample(const dem::PartEntry& entry, const Scale& scale, Random& random)
{
    std::map<std::string, bool> taken;
    for (const dem::PartKeyword& k : entry.keywords) taken[k.name] = true;
    for (const auto& group : alternatives)
    {
        const bool all = taken.count(group[0]) && taken.count(group[1]);
        // the restitution is an axis: mostly kept
        const bool drop = random.uniform() < (group[1] == "dampingCoefficient" ? 0.1 : 0.5);
        if (all) taken.erase(group[drop ? 0 : 1]);
    }
    dem::PartSettings s;
    s.model = entry.model;
    for (const auto& k : taken)
    {
        if (k.first == "unloading") s.words[k.first] = random.below(2) ? "initial" : "average";
        else s.values[k.first] = sampleValue(k.first, scale, random);
    }
    return s;
}

dem::ContactSettings sample(const Parts& parts, const Scale& scale, Random& random)
{
    dem::ContactSettings s;
    s.normal = sample(parts[0], scale, random);
    s.tangential = sample(parts[1], scale, random);
    s.rolling = sample(parts[2], scale, random);
    s.twisting = sample(parts[3], scale, random);
    return s;
}

//- Every combination of parts that the library accepts
const std::vector<Parts>& laws()
{
    static const std::vector<Parts> result = []
    {
        std::array<std::vector<dem::PartEntry>, 4> kinds;
        const std::string names[4] = {"normal", "tangential", "rolling", "twisting"};
        for (const dem::PartEntry& e : dem::contactModelTable())
        {
            for (std::size_t k = 0; k < 4; ++k) if (e.kind == names[k]) kinds[k].push_back(e);
        }
        std::vector<Parts> all;
        for (const auto& n : kinds[0]) for (const auto& t : kinds[1])
        for (const auto& r : kinds[2]) for (const auto& w : kinds[3])
        {
            const Parts p{n, t, r, w};
            Random random(1);
            try
            {
                dem::MaterialTable
                (
                    {{"dust", 1000, 1e8, 0.3, 0.1}}, sample(p, {1e8, 1e-6, 0.1, 0.5}, random),
                    {}, {}
                );
                all.push_back(p);
            }
            catch (const dem::inputError&) {}
        }
        return all;
    }();
    return result;
}

std::string lawName(const Parts& p)
{
    return p[0].model + "+" + p[1].model + "+" + p[2].model + "+" + p[3].model;
}


// * * * * * * * * * * * * * * * * * * Cases * * * * * * * * * * * * * * * * * * * * * * //

enum Scene
{
    headOn, obliquePair, obliqueWall, overlapPair, overlapWall, pressed, placed, drag, chain,
    cluster, crowd, bullet, nScenes
};

const char* const sceneNames[nScenes] =
{
    "headOn", "obliquePair", "obliqueWall", "overlapPair", "overlapWall", "pressed", "placed",
    "drag", "chain", "cluster", "crowd", "bullet"
};

//- Fewest steps per contact that System takes (timeIntegration/TimeSettings.hpp)
constexpr double fewestSteps = dem::TimeSettings::fewestStepsPerContact;

struct Case
{
    std::uint64_t number;
    int law;
    Scene scene;
    double value[nAxes];
    bool beneath = false;       // the integrator itself, beyond what System accepts
    bool conserves = false;     // one contact without a dashpot or a neck, along its normal

    std::vector<dem::Material> materials;
    dem::ContactSettings settings;
    dem::ReducedStiffness softening;
    dem::TimeSettings time;
    std::vector<dem::Particle> particles;
    std::vector<dem::GasLoad> loads;
    bool wall = false;
    double piece = 0;           // particle step [s]
    int pieces = 0;
    double energyScale = 0;     // [J]
    double work = 0;            // that gas and gravity can do [J]

    std::string text() const
    {
        std::ostringstream s;
        s.precision(12);
        s << "case " << number << " " << lawName(laws()[std::size_t(law)]) << " "
          << sceneNames[scene];
        for (int a = 0; a < nAxes; ++a) s << " " << axes[a].name << "=" << value[a];
        if (beneath) s << " beneath";
        return s.str();
    }
};

double mass(double density, double r) { return density*4.0/3.0*pi*r*r*r; }

//- Energy that a contact can give back: what is stored at this overlap and the depth of its
//  well of adhesion [J]
double contactEnergy
(
    const dem::MaterialTable& table, double ri, double rj, double m, double overlap,
    double* restForce = nullptr
)
{
    const dem::PairConstants& pair = table.constants(0, 0);
    const dem::ContactLaw& law = *table.laws()[std::size_t(table.lawIndex(0, 0))];
    const int p = table.pairInLaw(0, 0);
    const double R = rj > 0 ? ri*rj/(ri + rj) : ri;
    double c[dem::maxConstants];
    law.prepare(p, {pair, R, m}, c);
    const double low = -std::max(law.reach(p, pair, R), law.touchDistance(p, pair));
    const double a0 = law.equilibriumRadius(p, pair, R);
    const double high = std::max(overlap, 1.01*a0*a0/R);
    double history[dem::maxHistory] = {};
    double sum = 0, least = 0;
    constexpr int n = 400;
    const auto at = [&](double d)
    {
        const double force = law.normalResponse(c, d, history).elastic;
        if (restForce) *restForce = force;
        return force;
    };
    // to the overlap, then on to the bottom of the well
    for (const auto& range : {std::pair<double, double>{low, 0.0}, {0.0, high}})
    {
        for (int k = 0; k < n; ++k)
        {
            const double h = (range.second - range.first)/n;
            const double d = range.first + (k + 0.5)*h;
            if (h > 0) sum += at(d)*h;
            least = std::min(least, sum);
        }
    }
    double stored = 0;
    std::fill(history, history + dem::maxHistory, 0.0);
    for (int k = 0; k < n && overlap > 0; ++k) stored += at((k + 0.5)*overlap/n)*overlap/n;
    std::fill(history, history + dem::maxHistory, 0.0);
    at(overlap);
    return std::max(stored, 0.0) - least;
}

//- Potential of a contact without a neck [J], 0 where it begins: quadrature of its force
double potential
(
    const dem::MaterialTable& table, double ri, double rj, double m, double overlap
)
{
    const dem::PairConstants& pair = table.constants(0, 0);
    const dem::ContactLaw& law = *table.laws()[std::size_t(table.lawIndex(0, 0))];
    const int p = table.pairInLaw(0, 0);
    double c[dem::maxConstants];
    law.prepare(p, {pair, rj > 0 ? ri*rj/(ri + rj) : ri, m}, c);
    double history[dem::maxHistory] = {};
    const double begins = -law.touchDistance(p, pair);
    double sum = 0;
    constexpr int n = 400;
    for (const auto& range : {std::pair<double, double>{begins, 0.0}, {0.0, 1e300}})
    {
        const double h = (std::min(overlap, range.second) - range.first)/n;
        for (int k = 0; k < n && h > 0; ++k)
        {
            sum += law.normalResponse(c, range.first + (k + 0.5)*h, history).elastic*h;
        }
    }
    return sum;
}

//- Overlap at which the law bears a force [m]; -1 if none below a radius does
double overlapOf(const dem::MaterialTable& table, double r, double m, double force)
{
    double low = 0, high = r;
    double f = 0;
    contactEnergy(table, r, -1, m, high, &f);
    if (f < force) return -1;
    for (int k = 0; k < 60; ++k)
    {
        const double middle = 0.5*(low + high);
        contactEnergy(table, r, -1, m, middle, &f);
        (f < force ? low : high) = middle;
    }
    return high;
}

Case makeCase(std::uint64_t number)
{
    Case c;
    c.number = number;
    Random random(number);
    double* v = c.value;

    c.law = int(number%laws().size());
    const Parts& parts = laws()[std::size_t(c.law)];
    const std::uint64_t round = number/laws().size();
    // a crowd or a bullet costs as much as hundreds of pairs: one each in 300 cases
    const std::uint64_t dear = number%300;
    c.scene =
        dear == 7 ? crowd : dear == 157 ? bullet : Scene(round%std::uint64_t(crowd));

    for (int a = 0; a < nAxes; ++a) v[a] = random.logUniform(axes[a].low, axes[a].high);
    if (c.scene >= crowd)
    {
        // dear: where something is to be seen
        v[stepAxis] = random.logUniform(axes[stepAxis].low, 0.3);
        v[speedAxis] = random.logUniform(1e-6, 5);
        v[youngs] = random.logUniform(1e8, axes[youngs].high);
        v[chiAxis] = random.logUniform(1e-3, 1);
    }
    if (random.below(6) == 0) v[gammaAxis] = 0;
    if (random.below(2)) v[chiAxis] = 1;
    v[restitution] =
        random.below(8) ? random.uniform(axes[restitution].low, axes[restitution].high) : 1;
    if (parts[0].model == "cohesivePlastic") v[chiAxis] = 1;
    const bool overlaps =
        c.scene == overlapPair || c.scene == overlapWall || c.scene == chain
     || c.scene == cluster;
    if (!overlaps) v[overlapAxis] = 0;
    if (c.scene != drag) v[tauAxis] = 0;
    if (c.scene != pressed && c.scene != placed) v[gravityAxis] = 0;
    c.wall =
        c.scene == obliqueWall || c.scene == overlapWall || c.scene == pressed
     || c.scene == placed || c.scene == drag
     || ((c.scene == headOn || c.scene == chain || c.scene == cluster) && random.below(2));
    const bool two = c.scene == headOn || c.scene == obliquePair || c.scene == overlapPair;
    if (two ? c.wall : c.scene <= drag) v[sizeRatio] = v[massRatio] = 0;

    // Materials
    const double E = v[youngs], nu = random.uniform(0, 0.5), density = 1000;
    const double r = 0.5*v[diameter];
    c.materials = {{"dust", density, E, nu, v[gammaAxis]}};
    c.softening.ratio = v[chiAxis];
    c.softening.scaleResistance = random.below(8) == 0;
    const Scale scale{E/(2*(1 - nu*nu)), r/2, v[gammaAxis], v[restitution]};
    c.settings = sample(parts, scale, random);
    if (c.settings.normal.model == "vanDerWaals" && r < 1e-6)
    {
        c.settings.normal.values["range"] = 2e-9;
    }
    const dem::MaterialTable table(c.materials, c.settings, {}, c.softening);
    const dem::ContactLaw& law = *table.laws()[std::size_t(table.lawIndex(0, 0))];

    // Particles; masses are given by themselves, for the ratio
    const double m = mass(density, r);
    double touch = table.touchDistance(0, 0);
    double overlap = v[overlapAxis]*v[diameter];
    const double speed = v[speedAxis];
    const auto add = [&](double radius, double kg, const Vec3& x, const Vec3& u, const Vec3& w)
    {
        c.particles.push_back({std::int64_t(c.particles.size()), 0, radius, kg, x, u, w});
        c.loads.emplace_back();
    };
    const bool turns = c.scene != headOn && c.scene != placed && c.scene != pressed;
    const double spin = turns ? random.logUniform(0.01, 3)*speed : 0;
    const double slide = turns ? random.logUniform(0.01, 3)*speed : 0;
    const Vec3 along = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0).normalized();
    double smallest = r, lightest = m, rj = -1, mj = 0;
    double apart = 0;           // of the first touch [m]
    int bonds = 1;

    if (c.scene == crowd)
    {
        // one large and light, hidden under small ones: as many as fit, up to thousands
        const int want = int(v[contactsAxis]);
        const double ratio = std::max(2.0, 1.3*std::sqrt(double(want)));
        v[sizeRatio] = ratio;
        const double r1 = r/ratio;
        smallest = r1;
        const double m1 = mass(density, r1);
        lightest = std::min(m1, m1*ratio*ratio*ratio/v[massRatio]);
        add(r, m1*ratio*ratio*ratio/v[massRatio], Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
        v[massRatio] = std::max(c.particles[0].mass/m1, m1/c.particles[0].mass);
        for (int k = 0; k < want; ++k)
        {
            const double z = 1 - 2*(k + 0.5)/want, a = 2.399963229728653*k;
            const double s = std::sqrt(1 - z*z);
            const Vec3 n(s*std::cos(a), s*std::sin(a), z);
            add
            (
                r1, m1, (r + r1)*(1 - 1e-6)*n,
                speed*(-n + 0.3*random.direction()), Vec3::Zero()
            );
        }
        bonds = want;
    }
    else if (c.scene == bullet)
    {
        // a dense heap that hardly moves, and one that comes fast
        const int n = 5;
        v[contactsAxis] = 300;
        for (int i = 0; i < n*n*n; ++i)
        {
            const Vec3 x(i%n, (i/n)%n, i/(n*n));
            add(r, m, 2*r*(1 - 1e-6)*x, 1e-6*speed*random.direction(), Vec3::Zero());
        }
        add
        (
            r, m, 2*r*Vec3(2.3, 1.9, 5.2), speed*Vec3(0, 0, -1), spin/r*random.direction()
        );
        v[sizeRatio] = v[massRatio] = 0;
        bonds = 300;
    }
    else if (c.scene == chain || c.scene == cluster)
    {
        const int n = 3 + random.below(4);
        const double s = std::pow(v[sizeRatio], 1.0/(n - 1));
        const double q = std::pow(v[massRatio], 1.0/(n - 1));
        double rk = r, mk = m;
        Vec3 x(0, 0, r - overlap);
        std::vector<Vec3> nearBy;
        for (int k = 0; k < n; ++k)
        {
            if (k)
            {
                const double before = rk;
                rk = r/std::pow(s, k);
                mk = m*std::pow(q, random.below(2) ? k : -k);
                const Vec3 way =
                    c.scene == chain ? Vec3(0.2*along + Vec3(0, 0, 1)).normalized()
                  : Vec3(random.direction().cwiseAbs() + Vec3(0.1, 0.1, 0.1)).normalized();
                x += (before + rk - 2*rk*v[overlapAxis])*way;
            }
            add(rk, mk, x, speed*(0.3*random.direction() - Vec3(0, 0, 1)), spin/rk*random.direction());
            smallest = std::min(smallest, rk);
            lightest = std::min(lightest, mk);
        }
        bonds = n;
        v[contactsAxis] = n;
        overlap = 2*smallest*v[overlapAxis];
    }
    else
    {
        v[contactsAxis] = 1;
        const bool fixedStart = c.scene == pressed || c.scene == placed;
        Vec3 u = speed*Vec3(0, 0, -1) + slide*along;
        if (fixedStart) u.setZero();
        double gap = 1e-3*r;
        if (overlap > 0) gap = -overlap;
        if (c.scene == placed) gap = 1e-9*r;
        const Vec3 w = spin/r*random.direction();
        if (c.wall)
        {
            if (overlap == 0 && !fixedStart) apart = gap;
            add(r, m, Vec3(0, 0, r + gap + (overlap > 0 ? 0 : touch)), u, w);
            if (c.scene == pressed)
            {
                const double weight = m*9.81*v[gravityAxis];
                const double d = overlapOf(table, r, m, weight);
                c.particles[0].x.z() = d >= 0 ? r - d : r;
            }
        }
        else
        {
            rj = random.below(2) ? r/v[sizeRatio] : r*v[sizeRatio];
            mj = random.below(2) ? m/v[massRatio] : m*v[massRatio];
            smallest = std::min(r, rj);
            lightest = std::min(m, mj);
            if (overlap > 0) gap = -(overlap = 2*smallest*v[overlapAxis]);
            else apart = gap = 1e-3*smallest;
            add(r, m, Vec3(0, 0, r + gap + (overlap > 0 ? 0 : touch)), u, w);
            add(rj, mj, Vec3(0, 0, -rj), Vec3::Zero(), spin/rj*random.direction());
        }
    }

    // Time scales, of the shortest contact
    const dem::ContactFigures f =
        c.wall && c.particles.size() == 1 ? table.figures(0, 0, r, -1, m, 0, speed)
      : rj > 0 ? table.figures(0, 0, r, rj, m, mj, speed)
      : table.figures(0, 0, smallest, smallest, lightest, lightest, speed);

    const double share = v[stepAxis];
    c.time.stepsPerContact = pi/share;
    c.time.restTolerance = 0;
    if (c.time.stepsPerContact < fewestSteps && random.below(4) && c.scene < crowd)
    {
        // beneath System: is the bound a bound?
        c.beneath = true;
        c.time.stepsPerContact = 1;
        c.time.boundShare = share;
    }

    // Duration: the collision, or some periods
    const double step = f.period/std::max(c.time.stepsPerContact, 4.0);
    double duration = std::min(1.2*f.impactTime, 20*f.period);
    if (c.scene == headOn) duration = 2.2*f.impactTime;
    if (f.pullOff > 0 && f.a0 > 0)
    {
        duration += 4*2*pi*std::sqrt(f.m*f.a0*f.a0/(3.6*f.pullOff*f.R));
    }
    const bool far = c.settings.normal.model == "vanDerWaals";
    duration = std::min(std::max(duration, 4*f.period), (far ? 40 : 16)*f.period);
    if (c.scene == pressed || c.scene == placed)
    {
        // what 1e6 g makes of it is faster than what the speed would
        for (dem::GasLoad& g : c.loads) g.Su = Vec3(0, 0, -m*9.81*v[gravityAxis]);
        const double d = overlapOf(table, r, m, m*9.81*v[gravityAxis]);
        if (d > 0)
        {
            const double k = m*9.81*v[gravityAxis]/d;
            duration = std::min(duration, 8*2*pi*std::sqrt(m/k));
            c.work = m*9.81*v[gravityAxis]*(3*d + touch + 2e-9*r);
        }
        else c.work = m*9.81*v[gravityAxis]*2*r;    // pressed through: refused
    }
    const std::string& normal = c.settings.normal.model;
    const double R = rj > 0 ? r*rj/(r + rj) : r;
    const int inLaw = table.pairInLaw(0, 0);
    const dem::PairConstants& pair = table.constants(0, 0);
    c.conserves =
        (c.scene == headOn || c.scene == placed) && normal != "cohesivePlastic"
     && c.settings.normal.values.count("restitution")
     && c.settings.normal.values.at("restitution") == 1
     && law.reach(inLaw, pair, R) <= law.touchDistance(inLaw, pair);
    if (c.scene == drag)
    {
        dem::GasLoad& g = c.loads[0];
        g.Sp = m/(v[tauAxis]*step);
        g.Uc = speed*(0.3*random.direction() - Vec3(0, 0, 0.5));
        g.SpOmega = 4.0/3.0*g.Sp*r*r;
        g.omegaC = spin/r*random.direction();
        c.work = m*speed*speed*(1 + 2*spin*spin/(speed*speed));
    }
    if (c.scene == crowd) duration = 2*f.period;
    if (c.scene == bullet)
    {
        // it comes in the first third of the time
        duration = 12*f.period;
        double& z = c.particles.back().x.z();
        z = std::min(z, 2*r*4.95 + touch + duration/3*speed);
    }
    // no long way to the first touch: half of the time at most
    const double approach = std::min(apart/speed, 0.5*duration);
    if (apart > 0) c.particles[0].x += (apart - approach*speed)*Vec3(0, 0, -1);
    c.pieces = c.scene >= crowd ? 2 : 8;
    c.piece = (approach + duration)/c.pieces;

    if (c.beneath)
    {
        // in one go: the steps of one run are equal and end with it, so with few of them they
        // would be shorter than their share of the bound says
        c.piece *= c.pieces;
        c.pieces = 1;
    }

    // Energy
    double energy = c.work;
    Vec3 momentum = Vec3::Zero();
    double total = 0;
    for (const dem::Particle& p : c.particles)
    {
        momentum += p.mass*p.v;
        total += p.mass;
    }
    const Vec3 centre = c.wall ? Vec3::Zero() : Vec3(momentum/total);
    for (const dem::Particle& p : c.particles)
    {
        energy +=
            0.5*p.mass*(p.v - centre).squaredNorm()
          + 0.2*p.mass*p.radius*p.radius*p.omega.squaredNorm();
    }
    for (std::size_t i = 0; i < c.particles.size() && c.scene < crowd; ++i)
    {
        const dem::Particle& p = c.particles[i];
        if (c.wall)
        {
            energy += contactEnergy
            (
                table, p.radius, -1, p.mass,
                std::max(0.0, p.radius - p.x.z()) + resolution*p.x.norm()
            );
        }
        for (std::size_t j = 0; j < i; ++j)
        {
            const dem::Particle& q = c.particles[j];
            const double d = p.radius + q.radius - (p.x - q.x).norm();
            energy += contactEnergy
            (
                table, p.radius, q.radius, p.mass*q.mass/(p.mass + q.mass),
                std::max(0.0, d) + resolution*(p.x.norm() + q.x.norm())
            );
        }
    }
    if (c.scene >= crowd)
    {
        energy += bonds*contactEnergy
        (
            table, smallest, r, lightest, 1.01e-6*(r + smallest)
        );
    }
    c.energyScale = std::max(energy, 1e-300);
    return c;
}


// * * * * * * * * * * * * * * * * * * Runs * * * * * * * * * * * * * * * * * * * * * * //

//- OpenFOAM traps floating-point exceptions; so does this
sigjmp_buf trapped;
void onTrap(int) { siglongjmp(trapped, 1); }
void onAlarm(int) { siglongjmp(trapped, 2); }

void setTraps(bool on)
{
    std::feclearexcept(FE_ALL_EXCEPT);
    if (on) feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
    else fedisableexcept(FE_ALL_EXCEPT);
}

struct Course
{
    std::string refused;        // message
    bool trap = false;
    bool budget = false;        // stopped at the limit of steps
    int pieces = 0;             // done
    std::vector<dem::Particle> end;
    std::vector<std::vector<dem::Particle>> ends;   // of each piece, where energy is kept
    double energy = 0;          // kinetic [J], about the moving centre without a wall
    double peak = 0;            // largest of it [J]
    double given = 0;           // most that dashpots and springs have given by then [J]: ledger
    Vec3 momentum0, momentum;
    double momentumScale = 0;
    dem::StepReport report;
    bool contacts = false;
};

double kinetic(const std::vector<dem::Particle>& particles, bool wall)
{
    Vec3 momentum = Vec3::Zero();
    double total = 0, energy = 0;
    for (const dem::Particle& p : particles)
    {
        momentum += p.mass*p.v;
        total += p.mass;
    }
    const Vec3 centre = wall ? Vec3::Zero() : Vec3(momentum/total);
    for (const dem::Particle& p : particles)
    {
        energy +=
            0.5*p.mass*(p.v - centre).squaredNorm()
          + 0.2*p.mass*p.radius*p.radius*p.omega.squaredNorm();
    }
    return energy;
}

dem::Walls floorOf()
{
    dem::Walls walls;
    walls.patches = {{"floor", 0}};
    walls.planes = {{Vec3::Zero(), Vec3::UnitZ(), 0}};
    return walls;
}

//- The particles moved by System, or by the integrator alone
class Mover
{
public:

    Mover(const Case& c, const dem::TimeSettings& time, double fast)
    :
        table_(nudged(c.materials, fast), nudged(c.settings, fast), {}, c.softening),
        particles_(c.particles),
        loads_(c.loads)
    {
        for (dem::Particle& p : particles_) p.v *= fast;
        dem::Walls walls;
        if (c.wall) walls = floorOf();
        if (c.beneath)
        {
            walls_ = std::make_unique<dem::WallSearch>(walls);
            island_ = std::make_unique<dem::Island>(table_, time, *walls_, periodic_);
            contacts_.resize(particles_.size());
            rest_.resize(particles_.size());
            return;
        }
        system_ = std::make_unique<dem::System>(table_, time);
        if (c.wall) system_->setWalls(walls);
        for (std::size_t i = 0; i < particles_.size(); ++i)
        {
            system_->add(particles_[i]);
            system_->setGasLoad(i, loads_[i]);
        }
    }

    dem::StepReport advance(double dt)
    {
        if (system_)
        {
            const dem::StepReport report = system_->advance(dt);
            for (std::size_t i = 0; i < particles_.size(); ++i)
            {
                particles_[i] = system_->particle(i);
            }
            return report;
        }
        dem::StepReport report;
        island_->clear();
        const int n = int(particles_.size());
        for (int i = 0; i < n; ++i)
        {
            const std::size_t k = std::size_t(i);
            island_->addParticle(particles_[k], loads_[k], rest_[k]);
            if (walls_->walls().planes.size()) island_->addSurfaces(surfaces());
        }
        for (int i = 0; i < n; ++i)
        {
            for (const dem::ContactRecord& r : contacts_[std::size_t(i)])
            {
                island_->addContact(i, r.wall < 0 ? int(r.idJ) : -1, r);
            }
        }
        island_->run({dt, time_}, report);
        time_ += dt;
        for (int i = 0; i < n; ++i)
        {
            particles_[std::size_t(i)] = island_->particle(i);
            contacts_[std::size_t(i)] = island_->contacts(i);
        }
        return report;
    }

    const std::vector<dem::Particle>& particles() const { return particles_; }
    bool contacts() const
    {
        if (system_) return !system_->contacts().empty();
        for (const auto& c : contacts_) if (!c.empty()) return true;
        return false;
    }

private:

    static std::vector<dem::Material> nudged(std::vector<dem::Material> m, double by)
    {
        for (dem::Material& k : m) k.surfaceEnergy *= by;
        return m;
    }

    static dem::ContactSettings nudged(dem::ContactSettings s, double by)
    {
        auto& v = s.normal.values;
        if (v.count("restitution"))
        {
            v["restitution"] = std::min(1.0, std::max(0.01, v["restitution"]*(0.9 + 0.1*by)));
        }
        if (v.count("dampingCoefficient"))
        {
            v["dampingCoefficient"] = std::min(2.0, v["dampingCoefficient"] + std::fabs(1 - by));
        }
        if (v.count("yieldStrength")) v["yieldStrength"] *= by;
        return s;
    }

    std::vector<int> surfaces() const
    {
        std::vector<int> found;
        walls_->query(Vec3::Constant(-1e30), Vec3::Constant(1e30), found);
        return found;
    }

    dem::MaterialTable table_;
    std::vector<dem::Particle> particles_;
    std::vector<dem::GasLoad> loads_;
    std::unique_ptr<dem::System> system_;
    std::unique_ptr<dem::WallSearch> walls_;
    std::unique_ptr<dem::Island> island_;
    dem::Periodic periodic_;
    std::vector<std::vector<dem::ContactRecord>> contacts_;
    std::vector<dem::RestState> rest_;
    double time_ = 0;
};

bool verbose = false;
constexpr int longest = 60;         // CPU seconds that one run of a case may take

void setLimit(int seconds)
{
    const itimerval limit{{0, 0}, {seconds, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
}

Course follow
(
    const Case& c, double finer, double fast, int pieces, std::int64_t budget,
    bool ledger = false
)
{
    Course course;
    dem::TimeSettings time = c.time;
    time.energyLedger = ledger;
    time.stepsPerContact *= finer;
    if (c.beneath) time.boundShare /= finer;
    course.end = c.particles;
    if (const int signal = sigsetjmp(trapped, 1))
    {
        setLimit(0);
        setTraps(false);
        course.trap = true;
        course.refused = signal == 1 ? "floating-point trap" : "does not end";
        return course;
    }
    setTraps(true);
    setLimit(longest);
    try
    {
        Mover mover(c, time, fast);
        for (const dem::Particle& p : mover.particles()) course.momentum0 += p.mass*p.v;
        course.momentum0 = Vec3::Zero();
        for (const dem::Particle& p : mover.particles()) course.momentum0 += p.mass*p.v;
        for (int k = 0; k < pieces; ++k)
        {
            course.report.add(mover.advance(c.piece));
            course.end = mover.particles();
            if (c.conserves) course.ends.push_back(course.end);
            course.energy = kinetic(course.end, c.wall);
            course.peak = std::max(course.peak, course.energy);
            const dem::EnergyLedger& e = course.report.energy;
            course.given = std::max(course.given, e.springGain - e.dashpots - e.yield);
            double scale = 0;
            for (const dem::Particle& p : course.end) scale += p.mass*p.v.norm();
            course.momentumScale = std::max(course.momentumScale, scale);
            ++course.pieces;
            if (verbose)
            {
                std::printf
                (
                    "  finer %-4g piece %d steps %lld energy/scale %.6g overlap/d %.3g"
                    " touches %lld separations %lld v %.6g %.6g %.6g\n", finer, k,
                    (long long)course.report.contactSteps, course.energy/c.energyScale,
                    course.report.maxOverlapOverDiameter, (long long)course.report.touches,
                    (long long)course.report.separations, course.end[0].v.x(),
                    course.end[0].v.y(), course.end[0].v.z()
                );
            }
            if (course.report.contactSteps > budget)
            {
                course.budget = true;
                break;
            }
        }
        course.momentum = Vec3::Zero();
        for (const dem::Particle& p : course.end) course.momentum += p.mass*p.v;
        course.contacts = mover.contacts();
    }
    catch (const dem::inputError& e) { course.refused = e.what(); }
    catch (const dem::numericalError& e) { course.refused = e.what(); }
    setLimit(0);
    setTraps(false);
    return course;
}


// * * * * * * * * * * * * * * * * * Verdicts * * * * * * * * * * * * * * * * * * * * * //

enum Verdict { right, refused, beyond, silent, nVerdicts };
const char* const verdictNames[nVerdicts] = {"right", "refused", "unstableBeyondBound", "SILENT"};

struct Judgement
{
    Verdict verdict = right;
    std::string why;
    double error = 0, band = 0, steps = 0;
    double left = 0;        // step over the bound of the contacts as it left them, see leavesBound
};

//- From this share of the bound on, a step that takes up a contact leaves it beyond its bound.
//  With h = 2 s (m/k)^(1/2) at the peak overlap delta* of Hertz it goes h v = s (32/15)^(1/2)
//  delta* deep, and k grows with the root of the overlap: s^(5/4) (32/15)^(1/8) = 1
const double leavesBound = std::pow(32.0/15, -0.1);

//- Distance of two ends, as the root of the energy of the difference of their velocities
double distance(const Case& c, const Course& a, const Course& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.end.size(); ++i)
    {
        const dem::Particle& p = a.end[i];
        const dem::Particle& q = b.end[i];
        sum +=
            0.5*p.mass*(p.v - q.v).squaredNorm()
          + 0.2*p.mass*p.radius*p.radius*(p.omega - q.omega).squaredNorm();
    }
    return std::sqrt(sum/c.energyScale);
}

//- Energy of a case that conserves it, 0 for two that are apart and still [J]
double heldEnergy(const Case& c, const std::vector<dem::Particle>& particles)
{
    const dem::MaterialTable table(c.materials, c.settings, {}, c.softening);
    const dem::Particle& p = particles[0];
    double energy = kinetic(particles, c.wall);
    if (c.wall)
    {
        const double gap = p.x.z() - p.radius - table.touchDistance(0, 0);
        return
            energy + potential(table, p.radius, -1, p.mass, p.radius - p.x.z())
          - c.loads[0].Su.z()*gap;
    }
    const dem::Particle& q = particles[1];
    return energy + potential
    (
        table, p.radius, q.radius, p.mass*q.mass/(p.mass + q.mass),
        p.radius + q.radius - (p.x - q.x).norm()
    );
}

std::string number(double x)
{
    char s[40];
    std::snprintf(s, sizeof s, "%.3g", x);
    return s;
}

//- A message must say who, where and when, or which keyword
bool clear(const std::string& message)
{
    const bool numerical =
        message.find("particle ") != std::string::npos
     && message.find(" at time ") != std::string::npos;
    return numerical || message.find("(allowed: ") != std::string::npos;
}

//- What the run that is judged is made wrong by: speeds, surface energy, yield strength and
//  restitution are this much larger. 1: it is not
double wrongBy = 1;

Judgement judge(const Case& c)
{
    Judgement j;
    const double N = c.beneath ? pi/c.value[stepAxis] : c.time.stepsPerContact;
    const std::int64_t budget = std::int64_t(12*N) + 200;
    const Course a = follow(c, 1, wrongBy, c.pieces, budget);
    j.steps = double(a.report.contactSteps);
    const bool isBeyond = c.beneath && c.value[stepAxis] > 1;
    const auto wrong = [&](const std::string& why)
    {
        j.verdict = isBeyond ? beyond : silent;
        j.why = why;
        return j;
    };
    // Grown in a run of which a step left contacts beyond their bound, as it can only from
    // leavesBound on: found by running it again, with a look at the contacts after each step
    const auto grown = [&](const std::string& why)
    {
        wrong(why);
        if (!c.beneath || isBeyond || c.value[stepAxis] < leavesBound) return j;
        const Course again = follow(c, 1, wrongBy, c.pieces, budget, true);
        if (again.report.maxStepOverBound <= 1) return j;
        j.verdict = beyond;
        j.left = again.report.maxStepOverBound;
        j.why += "; a step left contacts at " + number(j.left) + " of their bound";
        return j;
    };
    if (a.trap)
    {
        // what grows without limit ends in one
        return wrong(a.refused);
    }
    if (!a.refused.empty())
    {
        if (!clear(a.refused))
        {
            j.verdict = silent;
            j.why = "unclear message: " + a.refused;
            return j;
        }
        if (a.refused.find("stepsPerContact") != std::string::npos)
        {
            j.verdict = refused;
            j.why = a.refused;
            return j;
        }
        // an unstable step may end so; a right answer must not be refused for that
        const Course fine = follow(c, 8, 1, c.pieces, 30*budget);
        // at the very limit of overlap one is refused and the other is not
        bool limit = fine.report.maxOverlapOverDiameter > nearLimit;
        const double nudge = 0.005 + 10.3/(N*N);
        for (const double way : {1 - nudge, 1 + nudge, 1 - 0.3*nudge, 1 + 0.3*nudge})
        {
            if (limit || !fine.refused.empty()) break;
            const Course near = follow(c, 8, way, c.pieces, 30*budget);
            limit =
                !near.refused.empty() || near.report.maxOverlapOverDiameter > nearLimit;
        }
        if (c.beneath && fine.refused.empty() && !fine.budget && !isBeyond && !limit)
        {
            // diverged within the bound
            return grown("refused, finer is not: " + a.refused);
        }
        j.verdict = isBeyond && fine.refused.empty() ? beyond : refused;
        j.why = a.refused;
        return j;
    }
    for (const dem::Particle& p : a.end)
    {
        if (!p.x.allFinite() || !p.v.allFinite() || !p.omega.allFinite())
        {
            return wrong("not finite");
        }
    }

    // Momentum, where nothing outside pushes
    if (!c.wall)
    {
        const double off = (a.momentum - a.momentum0).norm();
        const double allowed =
            1e-15*(double(a.report.contactUpdates) + 100)*
            (a.momentumScale + std::sqrt(c.energyScale*2*c.particles[0].mass));
        if (off > allowed) return wrong("momentum off by " + number(off/allowed) + " x round-off");
    }

    // Energy: what there was, what contacts and loads can give, and the scheme's error
    const double periods = double(a.report.contactSteps)/N;
    const double growth = c.beneath ? 2.0 : 1 + 0.01 + 40/(N*N);
    double allowed = c.energyScale;
    const bool passive =
        c.settings.rolling.model == "none" && c.settings.tangential.model == "none";
    if (a.peak > growth*allowed && !passive && !isBeyond)
    {
        // rolling and sliding are not quite passive as laws (README): what they gave, by ledger
        allowed += follow(c, 1, wrongBy, a.pieces, 1000*budget, true).given;
    }
    if (a.peak > growth*allowed)
    {
        return grown("energy grew to " + number(a.peak/allowed) + " of what there is");
    }
    if (c.beneath) return j;        // stable; so few steps are not meant to be right

    // A finer integration over the same time
    const double finer = c.scene >= crowd ? 4 : 8;
    const Course b = follow(c, finer, 1, a.pieces, 1000*budget);
    const bool limit =
        a.report.maxOverlapOverDiameter > nearLimit
     || b.refused.find("dashpots") != std::string::npos;
    if (!b.refused.empty() && limit && !b.trap)
    {
        j.verdict = refused;
        j.why = b.refused;
        return j;
    }
    if (b.trap || !b.refused.empty())
    {
        return wrong("only a finer run is refused: " + b.refused);
    }
    // phase error of the scheme, (2 pi/N)^2/24 per radian, over two periods or more, twice
    j.band = 0.01 + 2*10.3*std::max(2.0, std::min(periods, 12.0))/(N*N);
    // at a kink, where a contact begins to spring back, it is of first order
    if (c.settings.normal.model == "cohesivePlastic") j.band += 1/N;
    j.error = distance(c, a, b);
    if (c.scene >= crowd)
    {
        // many bodies: the sum only
        j.error = std::fabs(a.energy - b.energy)/c.energyScale;
    }
    // Energy that is kept, by quadrature of the law
    if (c.conserves)
    {
        const double begun = heldEnergy(c, c.particles);
        double off = 0;
        for (const auto& end : a.ends)
        {
            off = std::max(off, std::fabs(heldEnergy(c, end) - begun)/c.energyScale);
        }
        // what velocity Verlet makes of it: (omega h)^2/4
        const double ripple = pi*pi/(N*N);
        // It leaves with what it came with. Where that is less, to hold on is as right as to
        // leave, now or later
        const bool either = j.error > j.band && begun < ripple*c.energyScale;
        const double allowance = either ? ripple : growth - 1;
        if (off > allowance)
        {
            return wrong("energy off by " + number(off) + ", band " + number(allowance));
        }
        if (either)
        {
            j.error = off;
            j.band = ripple;
        }
    }
    if (j.error > j.band)
    {
        // is the case itself that sensitive?
        const double nudge = 0.5*j.band;
        double sensitive = 0;
        for (const double way : {1 - nudge, 1 + nudge, 1 - 0.3*nudge, 1 + 0.3*nudge})
        {
            const Course s = follow(c, finer, way, a.pieces, 1000*budget);
            if (s.trap || !s.refused.empty()) continue;
            sensitive = std::max
            (
                sensitive,
                c.scene >= crowd
              ? std::fabs(s.energy - b.energy)/c.energyScale : distance(c, s, b)
            );
        }
        if (j.error > j.band + 2*sensitive)
        {
            return wrong
            (
                "differs from " + number(finer) + " times finer by " + number(j.error)
              + ", band " + number(j.band) + ", nudged " + number(sensitive)
            );
        }
    }

    // Head-on: the closed law, integrated independently
    const std::string& model = c.settings.normal.model;
    const dem::MaterialTable table(c.materials, c.settings, {}, c.softening);
    const std::string used = table.settings(0, 0).normal.model;
    if
    (
        c.scene == headOn && c.settings.normal.values.count("restitution")
     && (used == "Hertz" || used == "simplifiedJKR" || used == "JKR" || used == "DMT")
     && !a.contacts && a.report.separations == 1
    )
    {
        const dem::PairConstants& pair = table.constants(0, 0);
        const bool wall = c.wall;
        const dem::Particle& p = c.particles[0];
        const dem::Particle& q = c.particles.back();
        formula::Contact k;
        k.E = pair.E; k.G = pair.G; k.gamma = pair.gamma;
        k.R = wall ? p.radius : p.radius*q.radius/(p.radius + q.radius);
        k.m = wall ? p.mass : p.mass*q.mass/(p.mass + q.mass);
        const double v = c.value[speedAxis], e = c.value[restitution];
        const formula::Collision truth = formula::collide(used, k, v, e);
        const Vec3 rebound =
            wall ? a.end[0].v : Vec3(a.end[0].v - a.end[1].v);
        const double error = std::fabs(rebound.z()/v - truth.restitution)
            *std::sqrt(0.5*k.m*v*v/c.energyScale);
        // energies to within the band
        const double energies = std::fabs
        (
            std::pow(rebound.z()/v, 2) - std::pow(truth.restitution, 2)
        )*0.5*k.m*v*v/c.energyScale;
        if (std::min(error, energies) > j.band)
        {
            return wrong
            (
                "rebounds with " + number(rebound.z()/v) + ", independently "
              + number(truth.restitution) + " (" + model + ")"
            );
        }
    }
    return j;
}

}


int main(int argc, char** argv)
{
    std::signal(SIGFPE, onTrap);
    std::signal(SIGPROF, onAlarm);
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "case" && (argc == 3 || argc == 4))
    {
        verbose = true;
        const Case c = makeCase(std::strtoull(argv[2], nullptr, 10));
        std::printf("%s\n", c.text().c_str());
        const auto part = [](const char* kind, const dem::PartSettings& s)
        {
            std::printf("  %s %s", kind, s.model.c_str());
            for (const auto& v : s.values) std::printf(" %s %.12g", v.first.c_str(), v.second);
            for (const auto& w : s.words) std::printf(" %s %s", w.first.c_str(), w.second.c_str());
            std::printf("\n");
        };
        part("normal", c.settings.normal);
        part("tangential", c.settings.tangential);
        part("rolling", c.settings.rolling);
        part("twisting", c.settings.twisting);
        std::printf
        (
            "  poissonRatio %.12g stepsPerContact %.9g boundShare %.9g wall %d piece %.6g s"
            " energy scale %.6g J\n", c.materials[0].poissonRatio, c.time.stepsPerContact,
            c.time.boundShare, c.wall, c.piece, c.energyScale
        );
        for (std::size_t i = 0; i < c.particles.size() && i < 8; ++i)
        {
            const dem::Particle& p = c.particles[i];
            std::printf
            (
                "  particle %zu r %.9g m %.9g x %.9g %.9g %.9g v %.6g %.6g %.6g w %.6g %.6g %.6g"
                " Sp %.3g Su %.3g\n", i, p.radius, p.mass, p.x.x(), p.x.y(), p.x.z(), p.v.x(),
                p.v.y(), p.v.z(), p.omega.x(), p.omega.y(), p.omega.z(), c.loads[i].Sp,
                c.loads[i].Su.z()
            );
        }
        if (argc > 3) follow(c, std::atof(argv[3]), 1, c.pieces, 1000000000);
        const Judgement j = judge(c);
        std::printf
        (
            "verdict %s  error %.3g band %.3g steps %.0f  %s\n", verdictNames[j.verdict],
            j.error, j.band, j.steps, j.why.c_str()
        );
        return 0;
    }
    if (what == "wrong" && argc >= 4)
    {
        // those that are judged by their energy, and right as they are
        const std::uint64_t begin = argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 0;
        int judged = 0, found = 0;
        for (std::uint64_t n = begin; n < begin + std::strtoull(argv[3], nullptr, 10); ++n)
        {
            const Case c = makeCase(n);
            if (c.beneath || !c.conserves) continue;
            wrongBy = 1;
            if (judge(c).verdict != right) continue;
            wrongBy = std::atof(argv[2]);
            const Judgement j = judge(c);
            ++judged;
            found += j.verdict == silent;
            if (j.verdict != silent && std::getenv("SM_MISSED"))
            {
                std::fprintf
                (
                    stderr, "%s %s error %.3g band %.3g\n", c.text().c_str(),
                    verdictNames[j.verdict], j.error, j.band
                );
            }
        }
        std::printf("judged %d\nfound wrong %d\n", judged, found);
        return 0;
    }
    if (what != "run" || argc < 3)
    {
        std::cerr
            << "stabilityMap run COUNT [FIRST] | case NUMBER [FINER] | wrong BY COUNT [FIRST]\n";
        return 2;
    }

    const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
    const std::uint64_t first = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 0;
    using Counts = std::array<std::int64_t, nVerdicts>;
    std::map<std::string, std::vector<std::array<Counts, nBins + 1>>> map;
    std::array<Counts, nScenes> scenes{};
    std::map<std::string, std::int64_t> reasons;
    std::vector<std::string> left;
    Counts total{};
    struct Worst { double excess = -1; std::string text; };
    std::map<std::string, Worst> worst;

    std::ofstream cases("cases.csv"), failures("silent.csv");
    cases << "case,law,scene,beneath";
    for (const Axis& a : axes) cases << "," << a.name;
    cases << ",verdict,error,band,steps\n";
    failures << "case,law,scene,why,input\n";
    double seconds[nScenes] = {};
    for (std::uint64_t n = first; n < first + count; ++n)
    {
        const auto start = std::chrono::steady_clock::now();
        const Case c = makeCase(n);
        const Judgement j = judge(c);
        const double spent =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        seconds[c.scene] += spent;
        if (spent > 0.5 && std::getenv("SM_SLOW"))
        {
            std::fprintf(stderr, "slow %.1f s %s %s\n", spent, c.text().c_str(), j.why.c_str());
        }
        const std::string law = lawName(laws()[std::size_t(c.law)]);
        ++total[j.verdict];
        ++scenes[c.scene][j.verdict];
        for (const std::string& key : {std::string("all"), law})
        {
            auto& table = map[key];
            table.resize(nAxes);
            for (int a = 0; a < nAxes; ++a)
            {
                ++table[std::size_t(a)][std::size_t(1 + bin(a, c.value[a]))][j.verdict];
            }
        }
        cases << n << "," << law << "," << sceneNames[c.scene] << "," << c.beneath;
        for (const double v : c.value) cases << "," << number(v);
        cases << "," << verdictNames[j.verdict] << "," << number(j.error) << ","
              << number(j.band) << "," << j.steps << "\n";
        if (j.verdict == silent)
        {
            failures << n << "," << law << "," << sceneNames[c.scene] << ",\"" << j.why
                     << "\",\"" << c.text() << "\"\n";
        }
        if (j.left > 0)
        {
            left.push_back(std::to_string(n) + " share " + number(c.value[stepAxis]) + " " + j.why);
        }
        if (j.verdict == refused)
        {
            std::string why = j.why.substr(0, j.why.find(" at time"));
            std::string kind =
                why.find("overlap") != std::string::npos ? "overlap beyond every law"
              : why.find("not finite") != std::string::npos ? "not finite"
              : why.find("dashpots") != std::string::npos ? "dashpots too strong for any step"
              : why.substr(0, why.find(':'));
            ++reasons[kind];
        }
        Worst& w = worst[law];
        const double excess = j.verdict == silent ? 1e9 : j.band > 0 ? j.error/j.band : 0;
        if (excess > w.excess) w = {excess, std::to_string(n) + "," + law + "," + verdictNames[j.verdict] + "," + number(j.error) + "," + number(j.band) + ",\"" + c.text() + "\""};
    }

    std::ofstream table("map.csv");
    table << "law,axis,low,high";
    for (const char* v : verdictNames) table << "," << v;
    table << "\n";
    for (const auto& row : map)
    {
        for (int a = 0; a < nAxes; ++a)
        {
            for (int b = -1; b < nBins; ++b)
            {
                const Counts& n = row.second[std::size_t(a)][std::size_t(b + 1)];
                if (n == Counts{}) continue;
                const double ratio = axes[a].high/axes[a].low;
                table << row.first << "," << axes[a].name << ",";
                if (b < 0) table << "off,off";
                else
                {
                    table << number(axes[a].low*std::pow(ratio, double(b)/nBins)) << ","
                          << number(axes[a].low*std::pow(ratio, double(b + 1)/nBins));
                }
                for (const std::int64_t k : n) table << "," << k;
                table << "\n";
            }
        }
    }
    std::ofstream worstFile("worst.csv");
    worstFile << "case,law,verdict,error,band,input\n";
    for (const auto& w : worst) worstFile << w.second.text << "\n";

    std::printf("laws %zu\ncases %llu\n", laws().size(), (unsigned long long)count);
    for (int v = 0; v < nVerdicts; ++v)
    {
        std::printf("verdict %s %lld\n", verdictNames[v], (long long)total[std::size_t(v)]);
    }
    std::printf("beyond by what a step left %zu\n", left.size());
    for (const std::string& l : left) std::printf("left %s\n", l.c_str());
    for (int s = 0; s < nScenes; ++s)
    {
        std::printf("scene %s", sceneNames[s]);
        for (const std::int64_t k : scenes[std::size_t(s)]) std::printf(" %lld", (long long)k);
        std::printf("  (%.1f s)\n", seconds[s]);
    }
    for (const auto& r : reasons)
    {
        std::printf("refusal %lld %s\n", (long long)r.second, r.first.c_str());
    }
    return 0;
}
