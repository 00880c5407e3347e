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

#include "csvTable.H"

#include "scalar.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::vector<std::string> fields(const std::string& line)
{
    std::vector<std::string> all;
    std::istringstream is(line);
    for (std::string field; std::getline(is, field, ',');)
    {
        all.push_back(field);
    }
    return all;
}


//- Equal as text or as numbers
bool same(const std::string& a, const std::string& b)
{
    Foam::scalar x, y;
    return
        a == b
     || (
            Foam::csvTable::number(a, x) && Foam::csvTable::number(b, y)
         && x == y
        );
}

} // End namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::size_t Foam::csvTable::column(const std::string& name) const
{
    const auto found = std::find(header_.begin(), header_.end(), name);
    if (found == header_.end())
    {
        std::string all;
        for (const std::string& one : header_)
        {
            all += (all.empty() ? "" : ",") + one;
        }
        throw error{"there is no column " + name + " in " + file_ + ": " + all};
    }
    return std::size_t(found - header_.begin());
}


Foam::scalar Foam::csvTable::cell
(
    const std::vector<std::string>& row,
    const std::size_t column
) const
{
    scalar value;
    if (!number(row[column], value) || !std::isfinite(value))
    {
        throw error
        {
            "in " + file_ + " column " + header_[column] + " is '" + row[column]
          + "', not a finite number"
        };
    }
    return value;
}


std::vector<const std::vector<std::string>*> Foam::csvTable::rowsFor
(
    const studySettings::quantity& q
) const
{
    std::vector<std::size_t> where;
    for (const auto& w : q.where)
    {
        where.push_back(column(w.first));
    }

    std::vector<const std::vector<std::string>*> result;
    for (const auto& row : rows_)
    {
        bool wanted = true;
        for (std::size_t k = 0; k < where.size(); ++k)
        {
            const std::string& value = q.where[k].second;
            wanted =
                wanted
             && same
                (
                    row[where[k]],
                    value == "last" ? rows_.back()[where[k]] : value
                );
        }
        if (wanted)
        {
            result.push_back(&row);
        }
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::csvTable::csvTable(const std::string& directory, const std::string& file)
:
    file_(file)
{
    std::ifstream is(directory + '/' + file);
    std::string line;
    if (!is || !std::getline(is, line))
    {
        throw error{"there is no " + file};
    }
    header_ = fields(line);
    while (std::getline(is, line))
    {
        rows_.push_back(fields(line));
        if (rows_.back().size() != header_.size())
        {
            throw error{"in " + file + " this is no whole row: " + line};
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::csvTable::number(const std::string& text, scalar& value)
{
    char* end;
    value = std::strtod(text.c_str(), &end);
    return !text.empty() && !*end;
}


Foam::scalar Foam::csvTable::valueOf(const studySettings::quantity& q) const
{
    const std::size_t wanted = column(q.column);
    std::vector<std::size_t> weights;
    for (const word& w : q.weights)
    {
        weights.push_back(column(w));
    }

    std::vector<scalar> values;
    scalar sum = 0, weight = 0;
    for (const auto* row : rowsFor(q))
    {
        values.push_back(cell(*row, wanted));
        scalar w = 1;
        for (const std::size_t k : weights)
        {
            w *= cell(*row, k);
        }
        sum += w*values.back();
        weight += w;
    }

    if (q.take == "sum")
    {
        return sum;
    }
    if (values.empty() || (q.take == "mean" && !(weight > 0)))
    {
        throw error{"no row of " + q.file + " is what " + q.name + " wants"};
    }
    return
        q.take == "first" ? values.front()
      : q.take == "last" ? values.back()
      : q.take == "min" ? *std::min_element(values.begin(), values.end())
      : q.take == "max" ? *std::max_element(values.begin(), values.end())
      : sum/weight;
}



// ************************************************************************* //
