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

#include "studyPicture.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of gnuplot's points, by the second variable
const int symbols[] = {7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14};

int symbol(const std::size_t j)
{
    return symbols[j % (sizeof(symbols)/sizeof(symbols[0]))];
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
                    (list.empty() ? "" : ", ") + Foam::studyReport::text(digit*std::pow(10.0, k));
            }
        }
    }
    return list;
}


std::string blockOf(const std::size_t quantity)
{
    return "$q" + std::to_string(quantity);
}

} // End namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<std::string> Foam::studyPicture::valuesOf
(
    const std::size_t variable
) const
{
    std::vector<std::string> values;
    for (const studyReport::row& r : report_.rows())
    {
        const studySettings::setting& s = settings_.settings()[r.setting];
        if
        (
            !report_.isReference(r) && variable < s.size()
         && std::find(values.begin(), values.end(), s[variable]) == values.end()
        )
        {
            values.push_back(s[variable]);
        }
    }
    return values;
}


std::pair<Foam::scalar, Foam::scalar> Foam::studyPicture::costs() const
{
    const auto& rows = report_.rows();
    scalar least = rows.empty() ? 1 : rows.front().cpu;
    scalar most = least;
    for (const studyReport::row& r : rows)
    {
        least = std::min(least, r.cpu);
        most = std::max(most, r.cpu);
    }
    return {least, most};
}


std::pair<Foam::scalar, Foam::scalar> Foam::studyPicture::edges
(
    const std::size_t quantity
) const
{
    const scalar tolerance = settings_.quantities()[quantity].tolerance;
    scalar lowest = tolerance, highest = tolerance;
    for (const studyReport::row& r : report_.rows())
    {
        const studyReport::estimate& e = r.quantities[quantity];
        highest = std::max(highest, e.error + e.limit);
        if (e.error > 1e-6*tolerance)
        {
            lowest = std::min(lowest, e.error);
        }
    }
    return {lowest/2, highest};
}


void Foam::studyPicture::writeHead
(
    std::ostream& os,
    const word& script,
    const word& png
) const
{
    const std::size_t n = settings_.quantities().size();
    const std::size_t columns = n == 4 ? 2 : std::min(std::size_t(3), n);
    const std::size_t lines = (n + columns - 1)/columns;
    const auto cpu = costs();

    os  << "# Error against run time: gnuplot " << script << '\n'
        << "set terminal pngcairo size " << 640*columns << ',' << 560*lines
        << " font \"sans,11\"\n"
        << "set output \"" << png << "\"\n"
        << "set multiplot layout " << lines << ',' << columns << '\n'
        << "set logscale xy\nset format \"%g\"\nset grid lc rgb \"#dddddd\"\n"
        << "set xrange [" << 0.8*cpu.first << ':' << 1.6*cpu.second << "]\n"
        << "set xtics (" << tics(0.8*cpu.first, 1.6*cpu.second) << ")\n"
        << "set xlabel \"CPU time [s]\" offset 0,0.6\nset key outside bottom center"
        << " horizontal samplen 2 font \",9\"\nset bars 0.5\n";
}


void Foam::studyPicture::writeFront
(
    std::ostream& os,
    std::ostream& plot,
    const std::size_t quantity,
    const scalar edge
) const
{
    const auto shown = [&](const studyReport::row& r)
    {
        return std::max(r.quantities[quantity].error, edge);
    };
    const std::string block(blockOf(quantity) + "_front");

    os << block << " << EOD\n";
    for (const studyReport::row* r : report_.front(shown))
    {
        std::string values;
        for (const std::string& v : settings_.settings()[r->setting])
        {
            values += (values.empty() ? "" : ", ") + v;
        }
        os << r->cpu << ' ' << shown(*r) << " \"" << values << "\"\n";
    }
    os << "EOD\n";
    plot<< "    " << block << " using 1:2 with lines lw 2 lc 0"
        << " title \"Pareto front\"";
    plot<< ", \\\n    " << block << " using 1:2:3 with labels left"
        << " offset 0.7,0.6 font \",8\" noenhanced notitle";
}


void Foam::studyPicture::writeGroups
(
    std::ostream& os,
    std::ostream& plot,
    const std::size_t quantity,
    const scalar edge
) const
{
    for (const auto& group : groups_)
    {
        const std::size_t i = group.first.first, j = group.first.second;
        const std::string block
        (
            blockOf(quantity) + '_' + std::to_string(i) + '_'
          + std::to_string(j)
        );
        os << block << " << EOD\n";
        for (const studyReport::row* r : group.second)
        {
            const studyReport::estimate& e = r->quantities[quantity];
            os  << r->cpu << ' ' << std::max(e.error, edge) << ' '
                << std::max(e.error - e.limit, edge) << ' '
                << std::max(e.error + e.limit, edge) << '\n';
        }
        os << "EOD\n";
        plot<< ", \\\n    " << block << " using 1:2:3:4 with yerrorbars pt "
            << symbol(j) << " ps 1.2 lc " << i + 1 << " notitle";
    }
}


void Foam::studyPicture::writeLegend(std::ostream& plot) const
{
    const std::vector<std::string> first(valuesOf(0)), second(valuesOf(1));
    for (std::size_t i = 0; i < first.size(); ++i)
    {
        plot<< ", \\\n    keyentry with points pt 7 ps 1.2 lc " << i + 1
            << " title "
            << quoted(settings_.variables()[0].name + ' ' + first[i]);
    }
    for (std::size_t j = 0; j < second.size(); ++j)
    {
        plot<< ", \\\n    keyentry with points pt " << symbol(j)
            << " ps 1.2 lc 0 title "
            << quoted(settings_.variables()[1].name + ' ' + second[j]);
    }
}


void Foam::studyPicture::writeReference
(
    std::ostream& os,
    std::ostream& plot,
    const scalar tolerance
) const
{
    plot<< ", \\\n    " << tolerance
        << " with lines dt 2 lc rgb \"#cc0000\" title \"tolerance\"";
    for (const studyReport::row& r : report_.rows())
    {
        if (report_.isReference(r))
        {
            os  << "set arrow 1 from " << r.cpu << ", graph 0 to " << r.cpu
                << ", graph 1 nohead dt 3 lc 0\n"
                << "set label 1 \"reference\" at " << r.cpu
                << ", graph 0.02 rotate left offset -0.7,0 font \",8\"\n";
            plot<< ", \\\n    \"-\" using 1:2 with points pt 0 notitle\n"
                << r.cpu << ' ' << tolerance << "\ne";
        }
    }
}


void Foam::studyPicture::writeDiagram
(
    std::ostream& os,
    const std::size_t quantity
) const
{
    const studySettings::quantity& q = settings_.quantities()[quantity];
    const auto edge = edges(quantity);

    std::ostringstream plot;
    writeFront(os, plot, quantity, edge.first);
    writeGroups(os, plot, quantity, edge.first);
    writeLegend(plot);
    writeReference(os, plot, q.tolerance);

    os  << "set ylabel " << quoted
           (
               (q.relative ? "relative error of " : "error of ") + q.name
             + (settings_.seeded() ? ", 95 % limits" : "")
           )
        << "\nset yrange [" << edge.first << ':' << 2*edge.second
        << "]\nplot \\\n" << plot.str() << '\n';
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::studyPicture::studyPicture
(
    const studySettings& settings,
    const studyReport& report
)
:
    settings_(settings),
    report_(report)
{
    const std::vector<std::string> values[] = {valuesOf(0), valuesOf(1)};
    for (const studyReport::row& r : report.rows())
    {
        if (report.isReference(r))
        {
            continue;
        }
        const studySettings::setting& s = settings.settings()[r.setting];
        std::size_t index[2] = {0, 0};
        for (std::size_t k = 0; k < 2 && k < s.size(); ++k)
        {
            index[k] = std::size_t
            (
                std::find(values[k].begin(), values[k].end(), s[k])
              - values[k].begin()
            );
        }
        groups_[{index[0], index[1]}].push_back(&r);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::studyPicture::write(const fileName& script, const fileName& png) const
{
    std::ofstream os(script);
    os.precision(9);
    writeHead(os, script.name(), png.name());
    for (std::size_t q = 0; q < settings_.quantities().size(); ++q)
    {
        writeDiagram(os, q);
    }
    os << "unset multiplot\n";
    if (!os)
    {
        FatalErrorInFunction << "Cannot write " << script << exit(FatalError);
    }
}



// ************************************************************************* //
