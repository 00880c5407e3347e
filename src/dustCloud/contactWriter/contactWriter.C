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

#include "contactWriter.H"
#include "dustSnapshot.H"
#include "OSspecific.H"
#include "Pstream.H"

#include <fstream>
#include <map>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The appended section of a VTK XML file, and the tags that point into it
class appendedData
{
    std::string data_;

public:

    //- Append values; returns the tag of the array
    template<class Type>
    std::string add
    (
        const std::string& name,
        const std::vector<Type>& values,
        const int components = 1
    )
    {
        std::ostringstream tag;
        tag << "<DataArray type=\""
            << (std::is_floating_point<Type>::value ? "Float64" : "Int64")
            << "\" Name=\"" << name << "\" NumberOfComponents=\""
            << components << "\" format=\"appended\" offset=\""
            << data_.size() << "\"/>\n";

        static_assert(sizeof(Type) == 8, "as the tag says");
        const uint64_t bytes = values.size()*sizeof(Type);
        data_.append(reinterpret_cast<const char*>(&bytes), sizeof(bytes));
        data_.append(reinterpret_cast<const char*>(values.data()), bytes);

        return tag.str();
    }

    const std::string& data() const
    {
        return data_;
    }
};


//- The times written so far, by file name: what a restarted run finds, too
static std::map<std::string, std::string> readSeries(const fileName& path)
{
    std::map<std::string, std::string> series;
    std::ifstream is(path);
    std::string line;

    // One entry per line, as written below
    while (std::getline(is, line))
    {
        const auto name = line.find("\"name\": \"");
        const auto time = line.find("\"time\": ");
        if (name != std::string::npos && time != std::string::npos)
        {
            const auto start = name + 9;
            const auto end = line.find('"', start);
            const auto last = line.find_first_of(" }", time + 8);
            series[line.substr(start, end - start)] =
                line.substr(time + 8, last - time - 8);
        }
    }
    return series;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::contactWriter::write
(
    const Time& time,
    const fileName& directory,
    const dustSnapshot& snapshot
)
{
    if (!Pstream::master())
    {
        return;
    }
    mkDir(directory);

    std::vector<double> x, U, d, mass, isBond, overlap, force, pullOff;
    std::vector<int64_t> id, state, material, cluster, patch;
    std::vector<int64_t> vertices, vertexEnds, lines, lineEnds;
    for (const auto& p : snapshot.particles)
    {
        for (direction i = 0; i < 3; ++i)
        {
            x.push_back(p.x[i]);
            U.push_back(p.U[i]);
        }
        d.push_back(p.d);
        mass.push_back(p.mass);
        id.push_back(p.id);
        state.push_back(p.state);
        material.push_back(p.material);
        cluster.push_back(p.cluster);
        patch.push_back(p.patch);
        vertices.push_back(int64_t(vertices.size()));
        vertexEnds.push_back(int64_t(vertices.size()));
    }

    // Cells: first the vertices, then the lines
    isBond.assign(vertices.size(), 0);
    overlap.assign(vertices.size(), 0);
    force.assign(vertices.size(), 0);
    pullOff.assign(vertices.size(), 0);

    for (const auto& b : snapshot.bonds)
    {
        if (b.j >= 0)
        {
            lines.push_back(b.i);
            lines.push_back(b.j);
            lineEnds.push_back(int64_t(lines.size()));
            isBond.push_back(1);
            overlap.push_back(b.overlap);
            force.push_back(b.force);
            pullOff.push_back(b.pullOff);
        }
    }

    appendedData data;
    std::ostringstream xml;

    xml << "<?xml version=\"1.0\"?>\n"
        << "<VTKFile type=\"PolyData\" version=\"1.0\" "
        << "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        << "<PolyData>\n<Piece NumberOfPoints=\"" << id.size()
        << "\" NumberOfVerts=\"" << id.size() << "\" NumberOfLines=\""
        << lineEnds.size() << "\">\n"
        << "<Points>\n" << data.add("Points", x, 3) << "</Points>\n"
        << "<Verts>\n" << data.add("connectivity", vertices)
        << data.add("offsets", vertexEnds) << "</Verts>\n"
        << "<Lines>\n" << data.add("connectivity", lines)
        << data.add("offsets", lineEnds) << "</Lines>\n"
        << "<PointData>\n"
        << data.add("d", d) << data.add("mass", mass) << data.add("U", U, 3)
        << data.add("id", id) << data.add("state", state)
        << data.add("material", material)
        << data.add("cluster", cluster) << data.add("patch", patch)
        << "</PointData>\n<CellData>\n"
        << data.add("isBond", isBond) << data.add("overlap", overlap)
        << data.add("force", force) << data.add("pullOff", pullOff)
        << "</CellData>\n</Piece>\n</PolyData>\n"
        << "<AppendedData encoding=\"raw\">\n_";

    const std::string name("contacts_" + time.timeName() + ".vtp");
    {
        std::ofstream os(directory/name, std::ios::binary);
        os  << xml.str() << data.data() << "\n</AppendedData>\n</VTKFile>\n";
    }

    const fileName seriesPath(directory/"contacts.vtp.series");
    auto series = readSeries(seriesPath);
    series[name] = time.timeName();

    std::map<double, std::string> byTime;
    for (const auto& entry : series)
    {
        byTime[std::stod(entry.second)] = entry.first;
    }

    std::ofstream os(seriesPath);
    os  << "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [";
    const char* separator = "\n";
    for (const auto& entry : byTime)
    {
        os  << separator << "    { \"name\": \"" << entry.second
            << "\", \"time\": " << series[entry.second] << " }";
        separator = ",\n";
    }
    os  << "\n  ]\n}\n";
}


// ************************************************************************* //
