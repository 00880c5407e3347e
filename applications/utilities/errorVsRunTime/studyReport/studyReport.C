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

std::string text(const double value, const int digits = 3)
{
    std::ostringstream os;
    os << std::setprecision(digits) << value;
    return os.str();
}


std::string padded(const std::string& s, const std::size_t width)
{
    return s + std::string(width > s.size() ? width - s.size() : 0, ' ');
}


//- As gnuplot wants it, with its enhanced text
std::string quoted(const std::string& s)
{
    std::string result;
    for (const char c : s)
    {
        result += c == '_' ? std::string("\\\\_") : std::string(1, c);
    }
    return '"' + result + '"';
}


//- 1, 2, 5, 10, ... from a to b; more than two decades: 1, 10, ...
std::string tics(const double a, const double b)
{
    std::string list;
    for (int k = int(std::floor(std::log10(a))); std::pow(10.0, k) <= b; ++k)
    {
        for (const int digit : {1, 2, 5})
        {
            if (digit == 1 || b < 100*a)
            {
                list +=
                    (list.empty() ? "" : ", ") + text(digit*std::pow(10.0, k));
            }
        }
    }
    return list;
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


bool Foam::studyReport::competes(const row& r) const
{
    return !isReference(r) && r.failed == 0;
}


template<class Measure>
std::vector<const Foam::studyReport::row*> Foam::studyReport::front
(
    const Measure& measure
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
    const std::size_t nSeeds = settings.seeds().values.size();
    const label needed = settings.seeded() ? 2 : 1;

    for (std::size_t i = 0; i < settings.settings().size(); ++i)
    {
        row r;
        r.setting = i;
        r.cpu = 0;
        r.runs = 0;
        r.failed = 0;
        r.worst = 0;
        for (std::size_t k = 0; k < nSeeds; ++k)
        {
            const studyRuns::run& one = runOf(i, k);
            if (one.finished)
            {
                r.cpu += one.cpu;
                ++r.runs;
            }
            r.failed += !one.failure.empty();
        }
        r.cpu /= std::max(r.runs, label(1));

        bool enough = r.runs >= needed;
        for (std::size_t q = 0; q < settings.quantities().size() && enough; ++q)
        {
            const studySettings::quantity& quantity = settings.quantities()[q];
            std::vector<scalar> differences;
            scalar mean = 0, reference = 0;
            for (std::size_t k = 0; k < nSeeds; ++k)
            {
                const studyRuns::run& one = runOf(i, k);
                if
                (
                    !one.finished
                 || (!quantity.given && !runOf(0, k).finished)
                )
                {
                    continue;
                }
                const scalar of =
                    quantity.given
                  ? quantity.reference : runOf(0, k).results[q];
                differences.push_back(one.results[q] - of);
                mean += one.results[q];
                reference += of;
            }
            const auto n = label(differences.size());
            if (n < needed)
            {
                enough = false;
                break;
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
            scalar unit = 1;
            if (quantity.relative)
            {
                unit = std::fabs(reference);
                if (!(unit > 0))
                {
                    FatalErrorInFunction
                        << "The reference of " << quantity.name << " is 0, of"
                        << " which no error can be a part: write error absolute;"
                        << " in quantities/" << quantity.name
                        << exit(FatalError);
                }
            }
            const estimate e
            {
                mean,
                std::fabs(difference)/unit,
                n > 1 ? student95(n - 1)*std::sqrt(squares/(n - 1)/n)/unit : 0
            };
            r.quantities.push_back(e);
            r.worst = std::max(r.worst, (e.error + e.limit)/quantity.tolerance);
        }
        if (enough)
        {
            rows_.push_back(r);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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


void Foam::studyReport::writePicture
(
    const fileName& script,
    const fileName& png
) const
{
    const auto& quantities = settings_.quantities();
    const std::size_t columns =
        quantities.size() == 4 ? 2 : std::min(std::size_t(3), quantities.size());
    const std::size_t lines = (quantities.size() + columns - 1)/columns;

    // One colour per value of the first variable, one symbol per value of the
    // second
    const auto indexOf = [&](const row& r, const std::size_t k)
    {
        std::vector<std::string> values;
        for (const row& other : rows_)
        {
            const auto& s = settings_.settings()[other.setting];
            if (!isReference(other) && k < s.size())
            {
                if (std::find(values.begin(), values.end(), s[k]) == values.end())
                {
                    values.push_back(s[k]);
                }
            }
        }
        const auto& s = settings_.settings()[r.setting];
        return
            k < s.size()
          ? std::size_t
            (
                std::find(values.begin(), values.end(), s[k]) - values.begin()
            )
          : 0;
    };
    scalar least = rows_.empty() ? 1 : rows_.front().cpu;
    scalar most = least;
    for (const row& r : rows_)
    {
        least = std::min(least, r.cpu);
        most = std::max(most, r.cpu);
    }
    const int symbols[] = {7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14};

    std::ofstream os(script);
    os.precision(9);
    os  << "# Error against run time: gnuplot " << script.name() << '\n'
        << "set terminal pngcairo size " << 640*columns << ',' << 560*lines
        << " font \"sans,11\"\n"
        << "set output \"" << png.name() << "\"\n"
        << "set multiplot layout " << lines << ',' << columns << '\n'
        << "set logscale xy\nset format \"%g\"\nset grid lc rgb \"#dddddd\"\n"
        << "set xrange [" << 0.8*least << ':' << 1.6*most << "]\n"
        << "set xtics (" << tics(0.8*least, 1.6*most) << ")\n"
        << "set xlabel \"CPU time [s]\" offset 0,0.6\nset key outside bottom center"
        << " horizontal samplen 2 font \",9\"\nset bars 0.5\n";

    for (std::size_t q = 0; q < quantities.size(); ++q)
    {
        // What a logarithm cannot show stands at the lower edge
        const scalar tolerance = quantities[q].tolerance;
        scalar lowest = tolerance, highest = tolerance;
        for (const row& r : rows_)
        {
            const scalar error = r.quantities[q].error;
            highest = std::max(highest, error + r.quantities[q].limit);
            if (error > 1e-6*tolerance)
            {
                lowest = std::min(lowest, error);
            }
        }
        const scalar edge = lowest/2;
        const auto shown = [&](const row& r)
        {
            return std::max(r.quantities[q].error, edge);
        };
        const auto best = front(shown);

        std::ostringstream plot;
        const std::string data("$q" + std::to_string(q));
        os << data << "_front << EOD\n";
        for (const row* r : best)
        {
            std::string values;
            for (const std::string& v : settings_.settings()[r->setting])
            {
                values += (values.empty() ? "" : ", ") + v;
            }
            os << r->cpu << ' ' << shown(*r) << " \"" << values << "\"\n";
        }
        os << "EOD\n";
        plot<< "    " << data << "_front using 1:2 with lines lw 2 lc 0"
            << " title \"Pareto front\"";
        plot<< ", \\\n    " << data << "_front using 1:2:3 with labels left"
            << " offset 0.7,0.6 font \",8\" noenhanced notitle";

        std::map<std::pair<std::size_t, std::size_t>, std::vector<const row*>> groups;
        for (const row& r : rows_)
        {
            if (!isReference(r))
            {
                groups[{indexOf(r, 0), indexOf(r, 1)}].push_back(&r);
            }
        }
        for (const auto& group : groups)
        {
            const std::size_t i = group.first.first, j = group.first.second;
            const std::string block
            (
                data + '_' + std::to_string(i) + '_' + std::to_string(j)
            );
            os << block << " << EOD\n";
            for (const row* r : group.second)
            {
                const estimate& e = r->quantities[q];
                os  << r->cpu << ' ' << shown(*r) << ' '
                    << std::max(e.error - e.limit, edge) << ' '
                    << std::max(e.error + e.limit, edge) << '\n';
            }
            os << "EOD\n";
            plot<< ", \\\n    " << block << " using 1:2:3:4 with yerrorbars pt "
                << symbols[j % 12] << " ps 1.2 lc " << i + 1 << " notitle";
        }

        // The legend: colours and symbols apart
        std::vector<std::size_t> colours, shapes;
        for (const auto& group : groups)
        {
            const auto& s = settings_.settings()[group.second.front()->setting];
            const std::size_t i = group.first.first;
            if (std::find(colours.begin(), colours.end(), i) == colours.end())
            {
                colours.push_back(i);
                plot<< ", \\\n    keyentry with points pt 7 ps 1.2 lc " << i + 1
                    << " title "
                    << quoted(settings_.variables()[0].name + ' ' + s[0]);
            }
        }
        for (const auto& group : groups)
        {
            const auto& s = settings_.settings()[group.second.front()->setting];
            const std::size_t j = group.first.second;
            if
            (
                s.size() > 1
             && std::find(shapes.begin(), shapes.end(), j) == shapes.end()
            )
            {
                shapes.push_back(j);
                plot<< ", \\\n    keyentry with points pt " << symbols[j % 12]
                    << " ps 1.2 lc 0 title "
                    << quoted(settings_.variables()[1].name + ' ' + s[1]);
            }
        }
        plot<< ", \\\n    " << tolerance
            << " with lines dt 2 lc rgb \"#cc0000\" title \"tolerance\"";
        for (const row& r : rows_)
        {
            if (isReference(r))
            {
                os  << "set arrow 1 from " << r.cpu << ", graph 0 to " << r.cpu
                    << ", graph 1 nohead dt 3 lc 0\n"
                    << "set label 1 \"reference\" at " << r.cpu
                    << ", graph 0.02 rotate left offset -0.7,0 font \",8\"\n";
                plot<< ", \\\n    \"-\" using 1:2 with points pt 0 notitle\n"
                    << r.cpu << ' ' << tolerance << "\ne";
            }
        }
        os  << "set ylabel " << quoted
               (
                   (quantities[q].relative ? "relative error of " : "error of ")
                 + quantities[q].name
                 + (settings_.seeded() ? ", 95 % limits" : "")
               )
            << "\nset yrange [" << edge << ':' << 2*highest
            << "]\nplot \\\n" << plot.str() << '\n';
    }
    os << "unset multiplot\n";
}


void Foam::studyReport::print() const
{
    const auto best = front([](const row& r) { return r.worst; });

    // The table
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

    // The recommendation
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
    const auto errors = [&](const row& r)
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
    };

    Info<< "Recommendation: ";
    if (chosen && chosen->cpu < against->cpu)
    {
        Info<< title(*chosen).c_str() << ", the cheapest setting whose errors are"
            << " within the tolerance"
            << (settings_.seeded() ? " with 95 % confidence" : "") << ": "
            << errors(*chosen).c_str() << ". It takes " << text(chosen->cpu).c_str()
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
            const row& r = *best.back();
            Info<< ". Nearest is " << title(r).c_str() << ": "
                << errors(r).c_str() << ", " << text(r.cpu).c_str() << " s";
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
        Info<< '.';
    }
    Info<< nl << "Pareto front (largest error"
        << (settings_.seeded() ? " limit" : "") << " over tolerance):";
    for (const row* r : best)
    {
        Info<< (r == best.front() ? " " : ", ") << title(*r).c_str() << " ("
            << text(r->worst, 2).c_str() << ", " << text(r->cpu).c_str() << " s)";
    }
    Info<< nl;
}


// ************************************************************************* //
