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

#include "csvFile.H"
#include "functionObject.H"
#include "OSspecific.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::csvFile::csvFile
(
    const Time& time,
    const word& functionObject,
    const word& name,
    const std::string& header
)
:
    path_
    (
        time.globalPath()/"postProcessing"/functionObject
       /(functionObject::postProcess ? "postProcess" : time.timeName())
       /(name + ".csv")
    ),
    header_(header)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::csvFile::open()
{
    if (!Pstream::master())
    {
        return false;
    }
    if (!os_.is_open())
    {
        mkDir(path_.path());
        os_.open(path_);
        os_.precision(10);
        os_ << header_ << '\n';
    }
    return true;
}


void Foam::csvFile::restart()
{
    if (os_.is_open())
    {
        os_.close();
    }
    open();
}


// ************************************************************************* //
