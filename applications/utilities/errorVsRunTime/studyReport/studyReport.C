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

#include "studyReport.H"

#include "error.H"
#include "IOstreams.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::string padded(const std::string& s, const std::size_t width)
{
    return s + std::string(width > s.size() ? width - s.size() : 0, ' ');
}


//- Integral of cos^n from 0 to b, by Simpson's rule
double cosinePower(const int n, const double b)
{
    const int m = 2000;
    double sum = 0;
    for (int i = 0; i <= m; ++i)
    {
        const double weight = i == 0 || i == m ? 1 : i % 2 ? 4 : 2;
        sum += weight*std::pow(std::max(0.0, std::cos(b*i/m)), n);
    }
    return sum*b/(3*m);
}


//- Runs of a setting that must have ended well
Foam::label needed(const Foam::studySettings& settings)
{
    return settings.seeded() ? 2 : 1;
}

} // End namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::studyRuns::run& Foam::studyReport::runOf
(
    const std::size_t setting,
    const std::size_t seed
) const
{
    return runs_[seed*settings_.settings().size() + setting];
}


Foam::studyReport::row Foam::studyReport::costs(const std::size_t setting) const
{
    row r;
    r.setting = setting;
    r.cpu = 0;
    r.runs = 0;
    r.failed = 0;
    r.worst = 0;
    for (std::size_t k = 0; k < settings_.seeds().values.size(); ++k)
    {
        const studyRuns::run& one = runOf(setting, k);
        if (one.finished)
        {
            r.cpu += one.cpu;
            ++r.runs;
        }
        r.failed += !one.failure.empty();
    }
    r.cpu /= std::max(r.runs, label(1));
    return r;
}


bool Foam::studyReport::estimateOf(row& r, const std::size_t q) const
{
    const studySettings::quantity& quantity = settings_.quantities()[q];
    std::vector<scalar> differences;
    scalar mean = 0, reference = 0;
    for (std::size_t k = 0; k < settings_.seeds().values.size(); ++k)
    {
        const studyRuns::run& one = runOf(r.setting, k);
        if (!one.finished || (!quantity.given && !runOf(0, k).finished))
        {
            continue;
        }
        const scalar of =
            quantity.given ? quantity.reference : runOf(0, k).results[q];
        differences.push_back(one.results[q] - of);
        mean += one.results[q];
        reference += of;
    }
    const auto n = label(differences.size());
    if (n < needed(settings_))
    {
        return false;
    }
    mean /= n;
    reference /= n;

    scalar difference = 0, squares = 0;
    for (const scalar d : differences)
    {
        difference += d/n;
    }
    for (const scalar d : differences)
    {
        squares += sqr(d - difference);
    }
    const scalar unit = quantity.relative ? std::fabs(reference) : 1;
    if (!(unit > 0))
    {
        FatalErrorInFunction
            << "The reference of " << quantity.name << " is 0, of"
            << " which no error can be a part: write error absolute;"
            << " in quantities/" << quantity.name
            << exit(FatalError);
    }
    const estimate e
    {
        mean,
        std::fabs(difference)/unit,
        n > 1 ? student95(n - 1)*std::sqrt(squares/(n - 1)/n)/unit : 0
    };
    r.quantities.push_back(e);
    r.worst = std::max(r.worst, (e.error + e.limit)/quantity.tolerance);
    return true;
}


bool Foam::studyReport::competes(const row& r) const
{
    return !isReference(r) && r.failed == 0;
}


std::string Foam::studyReport::title(const row& r) const
{
    return settings_.title(settings_.settings()[r.setting]);
}


std::string Foam::studyReport::errorText
(
    const row& r,
    const std::size_t q
) const
{
    const bool relative = settings_.quantities()[q].relative;
    const double unit = relative ? 100 : 1;
    const std::string sign(relative ? " %" : "");
    const estimate& e = r.quantities[q];
    return
        text(unit*e.error) + sign
      + (settings_.seeded() ? " +- " + text(unit*e.limit, 2) + sign : "");
}


std::string Foam::studyReport::errorsText(const row& r) const
{
    std::string all;
    for (std::size_t q = 0; q < r.quantities.size(); ++q)
    {
        const auto& quantity = settings_.quantities()[q];
        all +=
            (q ? ", " : "") + quantity.name + ' ' + errorText(r, q)
          + " (tolerance "
          + (
                quantity.relative
              ? text(100*quantity.tolerance) + " %"
              : text(quantity.tolerance)
            )
          + ')';
    }
    return all;
}


void Foam::studyReport::printTable(const std::vector<const row*>& best) const
{
    std::vector<std::vector<std::string>> table(1, {"setting"});
    for (const auto& q : settings_.quantities())
    {
        table[0].push_back(q.name);
        table[0].push_back("error");
    }
    table[0].push_back("CPU [s]");
    table[0].push_back("");
    for (const row& r : rows_)
    {
        table.push_back({title(r)});
        for (std::size_t q = 0; q < r.quantities.size(); ++q)
        {
            table.back().push_back(text(r.quantities[q].mean, 5));
            table.back().push_back(isReference(r) ? "" : errorText(r, q));
        }
        table.back().push_back(text(r.cpu));
        table.back().push_back
        (
            isReference(r) ? "reference"
          : r.failed ? std::to_string(r.failed) + " failed"
          : std::find(best.begin(), best.end(), &r) != best.end() ? "front"
          : ""
        );
    }
    Info<< nl;
    for (const auto& line : table)
    {
        Info<< "    ";
        for (std::size_t k = 0; k < line.size(); ++k)
        {
            std::size_t width = 0;
            for (const auto& other : table)
            {
                width = std::max(width, other[k].size() + 2);
            }
            Info<< padded(line[k], k + 1 < line.size() ? width : 0).c_str();
        }
        Info<< nl;
    }
    Info<< nl;
}


void Foam::studyReport::printFailures() const
{
    for (const studyRuns::run& r : runs_)
    {
        if (!r.failure.empty())
        {
            Info<< "Failed: "
                << settings_.title(settings_.settings()[r.setting]).c_str()
                << (
                       settings_.seeded()
                     ? " seed " + settings_.seeds().values[r.seed]
                     : std::string()
                   ).c_str()
                << ": " << r.failure.c_str() << nl;
        }
    }
}


void Foam::studyReport::sayNearest(const row& r) const
{
    Info<< ". Nearest is " << title(r).c_str() << ": "
        << errorsText(r).c_str() << ", " << text(r.cpu).c_str() << " s";
    scalar more = 0;
    for (std::size_t q = 0; q < r.quantities.size(); ++q)
    {
        const scalar room =
            settings_.quantities()[q].tolerance - r.quantities[q].error;
        more = std::max
        (
            more,
            room > 0 ? sqr(r.quantities[q].limit/room) : GREAT
        );
    }
    if (settings_.seeded() && more > 1 && more < 1e4)
    {
        Info<< ". About " << text(std::ceil(more*r.runs)).c_str()
            << " seeds would tell whether it is within";
    }
}


void Foam::studyReport::recommend(const std::vector<const row*>& best) const
{
    const row* chosen = nullptr;
    const row* dearest = &rows_.front();
    const row* reference = nullptr;
    for (const row& r : rows_)
    {
        if (competes(r) && r.worst <= 1 && (!chosen || r.cpu < chosen->cpu))
        {
            chosen = &r;
        }
        if (r.cpu > dearest->cpu)
        {
            dearest = &r;
        }
        if (isReference(r))
        {
            reference = &r;
        }
    }
    const row* against = reference ? reference : dearest;
    const std::string what(reference ? "the reference" : "the dearest setting");
    Info<< "Recommendation: ";
    if (chosen && chosen->cpu < against->cpu)
    {
        Info<< title(*chosen).c_str() << ", the cheapest setting whose errors are"
            << " within the tolerance"
            << (settings_.seeded() ? " with 95 % confidence" : "") << ": "
            << errorsText(*chosen).c_str() << ". It takes " << text(chosen->cpu).c_str()
            << " s of CPU time, " << text(against->cpu/chosen->cpu).c_str()
            << " times less than " << what.c_str() << " ("
            << title(*against).c_str() << ", " << text(against->cpu).c_str()
            << " s).";
    }
    else if (chosen)
    {
        Info<< title(*against).c_str() << ", " << what.c_str()
            << ": nothing within the tolerance is cheaper.";
    }
    else
    {
        Info<< "none, as no setting is within the tolerance";
        if (best.size())
        {
            sayNearest(*best.back());
        }
        Info<< '.';
    }
    Info<< nl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::studyReport::studyReport
(
    const studySettings& settings,
    const std::vector<studyRuns::run>& runs
)
:
    settings_(settings),
    runs_(runs)
{
    for (std::size_t i = 0; i < settings.settings().size(); ++i)
    {
        row r(costs(i));
        bool enough = r.runs >= needed(settings);
        for (std::size_t q = 0; q < settings.quantities().size() && enough; ++q)
        {
            enough = estimateOf(r, q);
        }
        if (enough)
        {
            rows_.push_back(r);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::studyReport::isReference(const row& r) const
{
    const auto& all = settings_.quantities();
    return
        settings_.hasReferenceRun() && r.setting == 0
     && std::any_of
        (
            all.begin(), all.end(),
            [](const studySettings::quantity& q) { return !q.given; }
        );
}


std::vector<const Foam::studyReport::row*> Foam::studyReport::front
(
    const std::function<scalar(const row&)>& measure
) const
{
    std::vector<const row*> all;
    for (const row& r : rows_)
    {
        if (competes(r))
        {
            all.push_back(&r);
        }
    }
    std::sort
    (
        all.begin(), all.end(),
        [&](const row* a, const row* b)
        {
            return
                std::make_pair(a->cpu, measure(*a))
              < std::make_pair(b->cpu, measure(*b));
        }
    );

    std::vector<const row*> best;
    for (const row* r : all)
    {
        if (best.empty() || measure(*r) < measure(*best.back()))
        {
            best.push_back(r);
        }
    }
    return best;
}


std::string Foam::studyReport::text(const scalar value, const int digits)
{
    std::ostringstream os;
    os << std::setprecision(digits) << value;
    return os.str();
}


Foam::scalar Foam::studyReport::student95(const label n)
{
    // With t = sqrt(n) tan(a) the density of t goes as cos^(n - 1) of a
    const double quarter = constant::mathematical::pi/2;
    const double whole = cosinePower(n - 1, quarter);
    double low = 0, high = quarter;
    for (int i = 0; i < 60; ++i)
    {
        const double a = (low + high)/2;
        (cosinePower(n - 1, a) < 0.95*whole ? low : high) = a;
    }
    return std::sqrt(double(n))*std::tan(low);
}


void Foam::studyReport::writeTable(const fileName& csv) const
{
    std::ofstream os(csv);
    os.precision(9);
    os << "setting";
    for (const auto& v : settings_.variables())
    {
        os << ',' << v.name;
    }
    for (const auto& q : settings_.quantities())
    {
        os << ',' << q.name << ",error_" << q.name << ",ci95_" << q.name;
    }
    os << ",cpu_s,runs,failed\n";

    for (const row& r : rows_)
    {
        os << title(r);
        for (const std::string& value : settings_.settings()[r.setting])
        {
            os << ',' << studySettings::plain(value);
        }
        for (const estimate& e : r.quantities)
        {
            os << ',' << e.mean << ',' << e.error << ',' << e.limit;
        }
        os << ',' << r.cpu << ',' << r.runs << ',' << r.failed << '\n';
    }
    if (!os)
    {
        FatalErrorInFunction << "Cannot write " << csv << exit(FatalError);
    }
}


void Foam::studyReport::print() const
{
    const auto best = front([](const row& r) { return r.worst; });

    printTable(best);
    printFailures();
    if (rows_.empty())
    {
        Info<< "Recommendation: none, as "
            << (
                   settings_.hasReferenceRun() && !runOf(0, 0).finished
                 ? "the reference is not there" : "too few runs ended well"
               )
            << nl;
        return;
    }
    recommend(best);
    Info<< "Pareto front (largest error"
        << (settings_.seeded() ? " limit" : "") << " over tolerance):";
    for (const row* r : best)
    {
        Info<< (r == best.front() ? " " : ", ") << title(*r).c_str() << " ("
            << text(r->worst, 2).c_str() << ", " << text(r->cpu).c_str() << " s)";
    }
    Info<< nl;
}


// ************************************************************************* //
