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

#include "dustCloudData.H"
#include "timeFiles.H"

#include "IFstream.H"
#include "IOobject.H"
#include "OSspecific.H"
#include "OStringStream.H"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sys/statvfs.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- End of the last line of every file that OpenFOAM writes
static const char* const endDivider = "*********** //";


static std::string content(const fileName& file)
{
    // Compressed or not
    IFstream is(file);
    if (!is.good())
    {
        return std::string();
    }
    return std::string
    (
        std::istreambuf_iterator<char>(is.stdStream()),
        std::istreambuf_iterator<char>()
    );
}


//- The first and the last characters of a file that is not compressed
static std::string ends(const fileName& file, const std::streamoff n)
{
    std::ifstream is(file, std::ios::binary);
    std::string result(std::size_t(2*n), ' ');
    is.read(&result[0], n);
    is.clear();
    is.seekg(0, std::ios::end);
    const std::streamoff size = is.tellg();
    is.seekg(std::max(std::streamoff(0), size - n));
    is.read(&result[std::size_t(n)], n);
    return result;
}


//- Whether a collated file, which has no last line, holds its blocks as a
//  whole: `// Processor<i>`, number of bytes, (bytes)
static bool blocksAreCut(const std::string& text)
{
    const std::string start("\n// Processor");
    const std::size_t entry = text.find("blocks ");
    const long n =
        entry == std::string::npos
      ? 1
      : std::strtol(text.c_str() + entry + 7, nullptr, 10);

    std::size_t at = 0;
    for (long blocki = 0; blocki < n; ++blocki)
    {
        at = text.find(start, at);
        const std::size_t line =
            at == std::string::npos ? at : text.find('\n', at + 1);
        const std::size_t open =
            line == std::string::npos ? line : text.find('(', line);
        if (open == std::string::npos)
        {
            return true;
        }
        const long size = std::strtol(text.c_str() + line, nullptr, 10);
        at = open + 1 + std::size_t(std::max(size, 0L));
        if (at >= text.size() || text[at] != ')')
        {
            return true;
        }
    }
    return false;
}


//- The mark while it is written
static fileName beside(const fileName& mark)
{
    return mark + ".new";
}


//- Whether a file of OpenFOAM has no end
static bool hasNoEnd(const fileName& file)
{
    const bool compressed = file.hasExt("gz");
    const std::string text = compressed ? content(file) : ends(file, 2000);

    if (fileSize(file) == 0 || (compressed && text.empty()))
    {
        return true;
    }
    if (text.find("FoamFile") == std::string::npos)
    {
        return false;
    }
    if (text.find("decomposedBlockData") != std::string::npos)
    {
        return blocksAreCut(content(file));
    }
    const std::size_t last = text.find_last_not_of(" \n");
    const std::size_t n = std::string(endDivider).size();
    return
        last == std::string::npos
     || last + 1 < n
     || text.compare(last + 1 - n, n, endDivider) != 0;
}

} // End namespace Foam


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

bool Foam::timeFiles::mark(const fileName& file, const bool complete)
{
    mkDir(file.path());

    // Renamed: it is there as a whole or not at all
    const fileName fresh(beside(file));
    {
        std::ofstream os(fresh);
        os  << "FoamFile\n{\n    version     2.0;\n    format      ascii;\n"
            << "    class       dictionary;\n    object      "
            << file.name() << ";\n}\n\n"
            << "complete        " << (complete ? "yes" : "no") << ";\n\n"
            << "// " << endDivider << "\n" << std::flush;
        if (!os.good())
        {
            return false;
        }
    }
    return std::rename(fresh.c_str(), file.c_str()) == 0;
}


bool Foam::timeFiles::complete(const fileName& directory, const fileName& mark)
{
    if (!mark.empty() && isFile(mark))
    {
        const std::string text = content(mark);
        const std::size_t at = text.find("\ncomplete");
        return
            at != std::string::npos
         && text.find("yes;", at) != std::string::npos;
    }
    // Nothing is written before the mark
    if (!mark.empty() && isFile(beside(mark), false))
    {
        return false;
    }
    // One that is not there is nobody's half-written one
    return !isDir(directory) || !all(directory).empty();
}


Foam::fileNameList Foam::timeFiles::all(const fileName& directory)
{
    fileNameList result;
    for (const fileName& name : readDir(directory, fileName::FILE, false))
    {
        result.append(directory/name);
    }
    for (const fileName& name : readDir(directory, fileName::DIRECTORY))
    {
        result.append(all(directory/name));
    }
    return result;
}


Foam::fileNameList Foam::timeFiles::cutShort
(
    const fileName& directory,
    const double since
)
{
    fileNameList result;
    for (const fileName& file : all(directory))
    {
        if (highResLastModified(file) >= since && hasNoEnd(file))
        {
            result.append(file);
        }
    }
    return result;
}


double Foam::timeFiles::size(const fileName& directory)
{
    double sum = 0;
    for (const fileName& file : all(directory))
    {
        sum += double(fileSize(file));
    }
    return sum;
}


double Foam::timeFiles::free(const fileName& directory)
{
    struct statvfs disk;
    return
        statvfs(directory.c_str(), &disk) == 0
      ? double(disk.f_bavail)*double(disk.f_frsize)
      : -1;
}


Foam::string Foam::timeFiles::sizeText(const double bytes)
{
    char text[40];
    std::snprintf(text, sizeof(text), "%.3g MB", bytes/1e6);
    return text;
}


// ************************************************************************* //
