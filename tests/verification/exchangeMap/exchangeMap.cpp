// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stability map of what gas and dust give each other: sampled boxes. See README.md.
//
//     exchangeMap draw NUMBER FOLDER         -> FOLDER/settings (for makeCase), places, places2
//     exchangeMap skew NUMBER CASE           moves the inner points of CASE's mesh, if drawn so
//     exchangeMap judge NUMBER CASE EXIT [WRONG]
//                                            verdict and figures on one line; WRONG: as if each
//                                            particle had got that share less than it did

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using Vec = std::array<double, 3>;
constexpr double pi = 3.14159265358979323846;

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec operator*(double s, const Vec& a) { return {s*a[0], s*a[1], s*a[2]}; }
double dot(const Vec& a, const Vec& b) { return a[0]*b[0] + a[1]*b[1] + a[2]*b[2]; }
double mag(const Vec& a) { return std::sqrt(dot(a, a)); }
Vec cross(const Vec& a, const Vec& b)
{
    return {a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]};
}

//- A function of the case's number and a counter alone, so that a case can be repeated
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
    int from(int low, int high) { return low + int(uniform()*(high - low + 1)); }
    Vec direction()
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


// * * * * * * * * * * * * * * * * * * Case * * * * * * * * * * * * * * * * * * * * * * //

struct Case
{
    std::string scene, ends;
    double z, loading, phi;         // dt/tau, mass of dust over gas, volume fraction in the dust
    double d, d2, length, height;
    double density, gas, mu, Cc, dt, speed, energy;
    double part = 1, grading = 1, skew = 0;     // share of the box with dust
    int nx, ny, outer = 1, steps = 4;
    Vec v, v2;
    double U;
    std::vector<Vec> places, places2;

    double cells() const { return d*std::max(nx/length, ny/height); }
    double fill() const { return pi/6*(d*d*d*double(places.size()) + d2*d2*d2*double(places2.size()))/volume(); }
    double volume() const { return length*height*height; }
};

//- A body-centred lattice of bodies; small: of which every second one has the other size
void place(Case& c, Random& random, bool two)
{
    const bool bonded = c.scene == "bonded";
    const int k = bonded ? random.from(2, 4) : 1;
    const int mx = random.from(1, 6), my = random.from(1, bonded ? 2 : 3);
    double a = c.d*std::cbrt(pi/3*k/c.phi);
    if (bonded) a = std::max(a, 1.3*k*c.d);
    c.length = mx*a;
    c.height = my*a;
    const double gap = std::max(0.0, 0.5*std::sqrt(3.0)*a - k*c.d);
    for (int i = 0; i < mx; ++i) for (int j = 0; j < my; ++j) for (int l = 0; l < my; ++l) for (int b = 0; b < 2; ++b)
    {
        const double s = 0.25 + 0.5*b;
        Vec x = {a*(i + s), a*(j + s), a*(l + s)};
        if (bonded) x[2] = a*(l + 0.5) - 0.5*(k - 1)*c.d;
        else x = x + 0.3*random.uniform()*std::min(gap, 0.1*a)*random.direction();
        if (c.scene == "wall") x[2] = 0.5*c.d*1.0001;
        if (x[0] > c.part*c.length && !c.places.empty()) continue;
        if (c.scene == "wall" && l > 0) continue;
        for (int n = 0; n < k; ++n)
            (two && b ? c.places2 : c.places).push_back({x[0], x[1], x[2] + n*c.d*(1 - 1e-6)});
    }
}

Case draw(int number)
{
    Random random{std::uint64_t(number)};
    Case c;
    const double s = random.uniform();
    c.scene = s < 0.35 ? "flying" : s < 0.55 ? "dense" : s < 0.8 ? "bonded" : "wall";
    const double e = random.uniform();
    c.ends = c.scene == "wall" ? (e < 0.7 ? "channel" : "inlet") : e < (c.scene == "dense" ? 0.9 : 0.6) ? "cyclic" : e < 0.75 ? "channel" : e < 0.85 ? "closed" : "inlet";
    c.z = random.logUniform(1e-3, 1e6);
    c.loading = random.logUniform(1e-3, 1e3);
    c.phi = c.scene == "dense" ? random.uniform(0.1, 0.64) : random.logUniform(1e-6, c.scene == "flying" ? 0.1 : 0.05);
    c.d = random.logUniform(1e-6, 1e-3);
    const bool two = c.scene != "bonded" && c.scene != "wall" && random.uniform() < 0.4;
    c.part = random.uniform() < 0.5 ? random.uniform(0.2, 0.8) : 1;
    c.d2 = c.d*(two ? random.uniform(0.2, 1) : 1);
    place(c, random, two);
    c.nx = random.from(1, 12);
    c.ny = random.from(1, 5);
    if (random.uniform() < 0.3) c.grading = random.logUniform(0.1, 10);
    if (random.uniform() < 0.3) c.skew = random.uniform(0.05, 0.25);
    c.outer = random.from(1, 4);
    c.speed = random.logUniform(1e-2, 3);
    const double courant = random.logUniform(1e-3, 1);
    c.dt = courant*std::min(c.length/c.nx, c.height/c.ny)/c.speed;
    c.gas = 1.2;
    const double dust = c.fill()*c.volume();
    c.density = c.loading*c.gas*(1 - c.fill())*c.volume()/dust;
    // Viscosity by itself, drag by the slip correction: a few spheres stand for many. Some have
    // the viscosity that they would need
    const double h = std::min(c.length/c.nx, c.height/c.ny), tau = c.dt/c.z;
    const double alone = c.density*c.d2*c.d2/(18*tau);
    c.mu = random.uniform() < 0.1 ? alone : std::max(1e-9*alone, c.gas*random.logUniform(1e-6, 10)*h*h/c.dt);
    c.Cc = c.mu/alone;
    c.energy = random.logUniform(1e-4, 0.1);
    c.U = c.ends == "closed" ? 0 : c.speed*random.uniform(0, 1);
    c.v = c.scene == "wall" ? Vec{0, 0, -c.speed} : c.speed*random.direction();
    c.v2 = two && random.uniform() < 0.5 ? c.speed*random.direction() : c.v;
    return c;
}

std::string text(const Vec& v)
{
    char s[100];
    std::snprintf(s, sizeof s, "%.17g %.17g %.17g", v[0], v[1], v[2]);
    return s;
}

void write(const Case& c, const std::string& folder)
{
    std::filesystem::create_directories(folder);
    std::ofstream settings(folder + "/settings");
    settings.precision(17);
    settings << "length=" << c.length << "\nheight=" << c.height << "\nnx=" << c.nx << "\nny=" << c.ny << "\ngrading=" << c.grading
        << "\nends=" << c.ends << "\nU=" << c.U << "\nrho=" << c.gas << "\nmu=" << c.mu << "\ndiameter=" << c.d << "\ndensity=" << c.density
        << "\nspeed=" << text(c.v) << "\ndt=" << c.dt << "\nend=" << c.steps*c.dt << "\nwrite=" << c.dt << "\nouter=" << c.outer
        << "\nenergy=" << c.energy << "\ndrag=slipDrag { lambda " << 0.5*c.d2 << "; A (" << c.Cc - 1 << " 0 1); }\n";
    if (!c.places2.empty())
        settings << "more=second { type manualInjection; massTotal 0; parcelBasisType fixed; nParticle 1; SOI 0; positionsFile \"places2\"; U0 ("
            << text(c.v2) << "); sizeDistribution { type fixedValue; fixedValueDistribution { value " << c.d2 << "; } } }\n";
    std::ofstream first(folder + "/places"), second(folder + "/places2");
    for (const Vec& x : c.places) first << text(x) << '\n';
    second << "FoamFile { version 2.0; format ascii; class vectorField; object places2; }\n(\n";
    for (const Vec& x : c.places2) second << '(' << text(x) << ")\n";
    second << ")\n";
}


// * * * * * * * * * * * * * * * * * Reading  * * * * * * * * * * * * * * * * * * * * * //

std::string slurp(const std::string& name)
{
    std::ifstream in(name);
    std::stringstream s;
    s << in.rdbuf();
    return s.str();
}

//- Numbers of OpenFOAM's list in an ascii file, brackets left out; n values each. A uniform field
//  or list as often as `count`
std::vector<double> numbers(const std::string& name, std::size_t count, std::size_t n)
{
    std::string s = slurp(name);
    const auto head = s.find("// * *");
    if (head == std::string::npos) { std::cerr << "no " << name << '\n'; std::exit(3); }
    s = s.substr(s.find('\n', head));
    std::vector<double> x;
    const auto inner = s.find("internalField");
    if (inner != std::string::npos) s = s.substr(inner);
    const auto add = [&](std::string t)
    {
        for (char& ch : t) if (ch == '(' || ch == ')') ch = ' ';
        const char* p = t.c_str();
        char* q;
        for (double v = std::strtod(p, &q); p != q; p = q, v = std::strtod(p, &q)) x.push_back(v);
    };
    const auto uniform = s.find(" uniform ");
    const auto brace = s.find('{'), bracket = s.find('(');
    if (inner != std::string::npos && uniform != std::string::npos && uniform < s.find(';')) add(s.substr(uniform + 9, s.find(';') - uniform - 9));
    else if (inner == std::string::npos && brace < bracket) add(s.substr(brace + 1, s.find('}') - brace - 1));
    else
    {
        std::string t = s.substr(bracket + 1);
        const auto end = std::min(t.find("\n)"), t.find(";"));
        add(t.substr(0, end));
    }
    for (const std::size_t one = x.size(); one == n && x.size() < count*n;)
        for (std::size_t i = 0; i < one; ++i) x.push_back(x[i]);
    return x;
}

std::vector<Vec> vectors(const std::string& name, std::size_t count)
{
    const auto x = numbers(name, count, 3);
    std::vector<Vec> v(x.size()/3);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = {x[3*i], x[3*i + 1], x[3*i + 2]};
    return v;
}

//- OpenFOAM's cell volumes: pyramids of the faces, whose centres are weighted by triangles
std::vector<double> volumes(const std::string& mesh)
{
    const auto points = vectors(mesh + "/points", 0);
    std::string f = slurp(mesh + "/faces");
    f = f.substr(f.find("\n(", f.find("// * *")) + 2);
    std::vector<Vec> centre, area;
    const std::regex face("4\\((\\d+) (\\d+) (\\d+) (\\d+)\\)");
    for (std::sregex_iterator i(f.begin(), f.end(), face), end; i != end; ++i)
    {
        std::array<Vec, 4> p;
        Vec mid{};
        for (int k = 0; k < 4; ++k) { p[k] = points[std::stoul((*i)[k + 1])]; mid = mid + 0.25*p[k]; }
        Vec A{}, sum{};
        double weight = 0;
        for (int k = 0; k < 4; ++k)
        {
            const Vec n = cross(p[(k + 1)%4] - p[k], mid - p[k]);
            A = A + 0.5*n;
            weight += mag(n);
            sum = sum + (mag(n)/3)*(p[k] + p[(k + 1)%4] + mid);
        }
        centre.push_back((1/weight)*sum);
        area.push_back(A);
    }
    const auto owner = numbers(mesh + "/owner", centre.size(), 1), neighbour = numbers(mesh + "/neighbour", 0, 0);
    std::vector<double> V(std::size_t(*std::max_element(owner.begin(), owner.end())) + 1);
    for (std::size_t i = 0; i < owner.size(); ++i) V[std::size_t(owner[i])] += dot(centre[i], area[i])/3;
    for (std::size_t i = 0; i < neighbour.size(); ++i) V[std::size_t(neighbour[i])] -= dot(centre[i], area[i])/3;
    return V;
}

//- Inner points moved by up to c.skew of the smallest spacing
void skew(int number, const std::string& folder)
{
    const Case c = draw(number);
    if (c.skew == 0) return;
    const std::string name = folder + "/constant/polyMesh/points";
    auto points = vectors(name, 0);
    double h = c.height/c.ny;
    std::vector<double> xs;
    for (const Vec& x : points) xs.push_back(x[0]);
    std::sort(xs.begin(), xs.end());
    for (std::size_t i = 1; i < xs.size(); ++i) if (xs[i] - xs[i - 1] > 1e-6*c.length) h = std::min(h, xs[i] - xs[i - 1]);
    Random random(std::uint64_t(number) + (1ull << 40));
    std::ofstream out(name);
    out << "FoamFile { version 2.0; format ascii; class vectorField; location \"constant/polyMesh\"; object points; }\n"
        << "// * * //\n" << points.size() << "\n(\n";
    for (Vec x : points)
    {
        const auto inside = [](double a, double L) { return a > 1e-6*L && a < (1 - 1e-6)*L; };
        if (inside(x[0], c.length) && inside(x[1], c.height) && inside(x[2], c.height)) x = x + c.skew*h*random.direction();
        out << '(' << text(x) << ")\n";
    }
    out << ")\n";
}


// * * * * * * * * * * * * * * * * * Judging  * * * * * * * * * * * * * * * * * * * * * //

struct State
{
    std::vector<Vec> U, v;
    std::vector<double> alpha, m;
    Vec momentum{}, gas{}, dust{};
    double kinetic = 0, gasMass = 0, dustMass = 0;
    bool finite = true;
};

void sum(State& s, const Case& c, const std::vector<double>& V, const std::vector<Vec>& owed)
{
    for (std::size_t i = 0; i < V.size(); ++i)
    {
        const double m = c.gas*s.alpha[i]*V[i];
        s.gas = s.gas + m*s.U[i];
        s.gasMass += m;
        s.kinetic += 0.5*m*dot(s.U[i], s.U[i]);
        s.finite = s.finite && std::isfinite(dot(s.U[i], s.U[i])) && s.alpha[i] > 0;
    }
    for (std::size_t i = 0; i < s.v.size(); ++i)
    {
        const Vec due = owed.empty() ? Vec{} : owed[i];
        s.dust = s.dust + s.m[i]*s.v[i] + due;
        s.dustMass += s.m[i];
        // With what bonded dust will get in the next step; what a wall holds gets nothing of it
        const Vec v = c.scene == "bonded" ? s.v[i] + (1/s.m[i])*due : s.v[i];
        s.kinetic += 0.5*s.m[i]*dot(v, v);
        s.finite = s.finite && std::isfinite(dot(s.v[i], s.v[i]));
    }
    s.momentum = s.gas + s.dust;
}

std::vector<State> states(const Case& c, const std::string& folder, double wrong)
{
    const auto V = volumes(folder + "/constant/polyMesh");
    std::vector<std::pair<double, std::string>> times;
    for (const auto& e : std::filesystem::directory_iterator(folder))
    {
        const std::string name = e.path().filename().string();
        if (name != "0" && std::isdigit(name[0]) && std::filesystem::exists(e.path()/"lagrangian/dust/U"))
            times.push_back({std::stod(name), e.path().string()});
    }
    std::sort(times.begin(), times.end());
    std::vector<State> all(1);
    for (const auto& time : times)
    {
        State s;
        const std::string dust = time.second + "/lagrangian/dust/";
        s.U = vectors(time.second + "/U", V.size());
        s.alpha = numbers(time.second + "/alphac", V.size(), 1);
        s.v = vectors(dust + "U", c.places.size() + c.places2.size());
        const auto d = numbers(dust + "d", s.v.size(), 1);
        const auto id = numbers(dust + "origId", s.v.size(), 1);
        const auto owed = vectors(dust + "owedImpulse", s.v.size());
        for (double di : d) s.m.push_back(c.density*pi/6*di*di*di);
        if (wrong != 0)
            for (std::size_t i = 0; i < s.v.size(); ++i)
            {
                const Vec& v0 = d[i] == c.d && (c.d2 != c.d || id[i] < double(c.places.size())) ? c.v : c.v2;
                s.v[i] = v0 + (1 - wrong)*(s.v[i] - v0);
            }
        sum(s, c, V, owed);
        all.push_back(s);
    }
    if (all.size() > 1)
    {
        // At the start: the particles, and the gas that is between them
        State& s = all[0];
        s.U.assign(V.size(), {c.U, 0, 0});
        s.alpha = all[1].alpha;
        for (int k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < (k ? c.places2 : c.places).size(); ++i)
            {
                s.v.push_back(k ? c.v2 : c.v);
                s.m.push_back(c.density*pi/6*std::pow(k ? c.d2 : c.d, 3));
            }
        sum(s, c, V, {});
    }
    return all;
}

//- Largest difference of the gas of a cell from the mean velocity [m/s]
double unevenness(const State& s)
{
    double most = 0;
    for (const Vec& U : s.U) most = std::max(most, mag(U - (1/s.gasMass)*s.gas));
    return most;
}

//- Share of its slip that gas keeps in a step among dust of a void fraction: two bodies, exactly
double keeps(const Case& c, double alpha)
{
    const double mu = c.density*(1 - alpha)/(c.gas*alpha);
    return (1 + mu*std::exp(-c.z*(1 + mu)))/(1 + mu);
}

//- Where the dust of two cells takes more and less, the pressure pushes gas from one to the other:
//  round a sphere without resistance by at most twice what the two differ by [m/s]
double pushed(const Case& c, const State& s)
{
    const auto range = std::minmax_element(s.alpha.begin(), s.alpha.end());
    return 2*mag(Vec{c.U, 0, 0} - c.v)*std::abs(keeps(c, *range.second) - keeps(c, *range.first));
}

double after(const std::string& s, const std::string& words, bool largest)
{
    double found = -1;
    for (auto at = s.find(words); at != std::string::npos; at = s.find(words, at + 1))
    {
        const double x = std::strtod(s.c_str() + at + words.size(), nullptr);
        found = largest ? std::max(found, std::isfinite(x) ? std::abs(x) : 1e300) : x;
    }
    return found;
}

//- What adhesion of the contacts can give a particle of this mass [J]: wells of JKR, four each
double adhesion(const Case& c)
{
    const double E = 0.5*1e9/(1 - 0.09), R = 0.25*c.d, W = 2*c.energy;
    return 4*7.09*std::cbrt(std::pow(W, 5)*std::pow(R, 4)/(E*E));
}

int judge(int number, const std::string& folder, int code, double wrong)
{
    const Case c = draw(number);
    const std::string log = slurp(folder + "/log.dustFoam");
    std::string verdict = "right", why;
    const auto fail = [&](const std::string& reason) { why += (why.empty() ? "" : "+") + reason; };
    double dP = 0, dK = -1e300, back = 0, out = 0, outGas = 0, over = 0;

    std::smatch m;
    const auto fatal = log.find("FOAM FATAL");
    if (fatal != std::string::npos && code == 1)
    {
        verdict = "refused";
        const auto at = log.find('\n', fatal);
        why = log.substr(at, 400);
        std::replace(why.begin(), why.end(), '\n', ' ');
        std::replace(why.begin(), why.end(), ',', ';');
    }
    else if (code != 0) fail("exit" + std::to_string(code));
    else
    {
        const auto all = states(c, folder, wrong);
        const bool whole = c.ends == "cyclic", alone = log.find("    touches 0,") != std::string::npos;
        const bool even = alone && c.places2.empty() && c.part == 1 && c.skew == 0;
        double vMax = std::max(c.speed, std::abs(c.U)), push = 0;
        if (int(all.size()) != c.steps + 1) fail("steps");
        for (std::size_t n = 1; n < all.size(); ++n)
        {
            const State &s = all[n], &before = all[n - 1], &start = all[0];
            if (!s.finite) { fail("notFinite"); break; }
            if (std::abs(s.dustMass/start.dustMass - 1) > 1e-9 && c.ends != "inlet") fail("dustLost");
            // Errors of the gas: over its own momentum
            const double P = start.gasMass*vMax;
            if (whole) dP = std::max(dP, mag(s.momentum - start.momentum)/P);
            const double wells = double(start.v.size())*adhesion(c);
            // Never above what there was; in a step some of what the gas's differences from cell to
            // cell have taken may come back, see README.md
            const double gasEnergy = 0.5*start.gasMass*vMax*vMax;
            if (c.ends != "inlet") dK = std::max(dK, (s.kinetic - start.kinetic - wells)/gasEnergy);
            if (c.ends != "inlet") back = std::max(back, (s.kinetic - before.kinetic - wells)/start.kinetic);
            // Velocities within those there were
            push += pushed(c, s);
            const double give = std::sqrt(2*adhesion(c)/s.m.back());
            for (int k = 0; k < 3; ++k)
            {
                double low = k == 0 ? std::min(c.U, 0.0) : 0, high = k == 0 ? c.U : 0;
                for (const Vec& v : before.v) { low = std::min(low, v[k]); high = std::max(high, v[k]); }
                for (const State* t : {&before, &s})
                    for (const Vec& v : t->U) { low = std::min(low, v[k]); high = std::max(high, v[k]); }
                if (alone) for (const Vec& v : s.v) out = std::max(out, std::max(low - v[k], v[k] - high) - give);
                low = std::min({c.U*(k == 0), c.v[k], c.v2[k]}) - push;
                high = std::max({c.U*(k == 0), c.v[k], c.v2[k]}) + push;
                if (even && whole) for (const Vec& v : s.U) outGas = std::max(outGas, std::max(low - v[k], v[k] - high));
            }
            // Mean velocities approach each other, and do not pass
            const Vec r0 = (1/before.gasMass)*before.gas - (1/before.dustMass)*before.dust;
            const Vec r1 = (1/s.gasMass)*s.gas - (1/s.dustMass)*s.dust;
            // but for what the gas differs from cell to cell: dust sees its own cells
            const double uneven = unevenness(before) + unevenness(s);
            const double passed = std::max(mag(r1) - mag(r0), -dot(r0, r1)/std::max(mag(r0), 1e-300));
            if (whole && even) over = std::max(over, (passed - uneven)/vMax);
        }
        out /= vMax;
        outGas /= vMax;
    }
    const double differ = after(log, "got by the particles differ by at most ", false);
    const double continuity = after(log, "sum local = ", true);
    if (verdict != "refused" && why.empty())
    {
        // Gas that makes way for dust: model B keeps momentum and energy but for the share of volume
        const double volume = 1e-5 + 3*c.fill();
        if (differ < 0 || differ > 1e-10) fail("balance");
        if (continuity > 1e-6) fail("continuity");
        if (dP > volume) fail("momentum");
        if (dK > volume*(1 + c.loading)) fail("energy");
        if (out > 1e-6) fail("particlesBeyond");
        if (outGas > volume) fail("gasBeyond");
        if (over > volume) fail("apart");
    }
    if (verdict != "refused" && !why.empty())
    {
        const bool named = log.find("FOAM Warning") != std::string::npos || log.find("all limits kept") == std::string::npos;
        verdict = named && why.rfind("exit", 0) != 0 ? "named" : "SILENT";
    }
    std::printf("%d,%s,%s,%s,%.3g,%.3g,%.3g,%.3g,%zu,%d,%d,%.3g,%.3g,%.3g,%d,%.3g,%.3g,%.3g,%.3g,%.3g,%.3g,%.3g,%.3g,%s,%.3g\n", number, verdict.c_str(),
        c.scene.c_str(), c.ends.c_str(), c.z, c.loading, c.fill(), c.cells(), c.places.size() + c.places2.size(), c.nx, c.ny, c.part,
        c.grading, c.skew, c.outer, c.mu/c.gas*c.dt/std::pow(c.height/c.ny, 2), differ, continuity, dP, dK, out, outGas, over, why.c_str(), back);
    return 0;
}

} // namespace


int main(int argc, char* argv[])
{
    const std::string mode = argc > 3 ? argv[1] : "";
    const int number = argc > 2 ? std::atoi(argv[2]) : 0;
    if (mode == "draw") write(draw(number), argv[3]);
    else if (mode == "skew") skew(number, argv[3]);
    else if (mode == "judge" && argc > 4) return judge(number, argv[3], std::atoi(argv[4]), argc > 5 ? std::atof(argv[5]) : 0);
    else { std::cerr << "exchangeMap draw NUMBER FOLDER | skew NUMBER CASE | judge NUMBER CASE EXIT [WRONG]\n"; return 2; }
}
