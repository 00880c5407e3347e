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

#include "ledgerCheck.H"
#include "dictionaryLines.H"
#include "dustKeywords.H"
#include "untrapped.H"

#include "cloud.H"
#include "IOdictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

typedef dustKeywords keys;

static const char* asWritten =
    "as it was written: restore the file, or start from another time";


//- Paths, kinds and what is allowed, all of the same meaning
static std::vector<keys::row> rowsOf
(
    const std::string& unit,
    const keys::kindType kind,
    const std::string& fallback,
    const std::string& allowed,
    const std::vector<std::string>& paths
)
{
    std::vector<keys::row> rows;
    for (const std::string& path : paths)
    {
        rows.push_back({path, "", kind, unit, fallback, allowed, asWritten});
    }
    return rows;
}


static std::vector<keys::row> together
(
    const std::vector<std::vector<keys::row>>& parts
)
{
    std::vector<keys::row> all;
    for (const auto& part : parts)
    {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}


//- Of an injector. Each has some of them
static const std::vector<keys::row>& injectorRows()
{
    static const std::vector<keys::row> table = together
    ({
        rowsOf("-", keys::block, "none", "", {"*"}),
        rowsOf
        (
            "-", keys::integer, "0", ">=0",
            {
                "*/nInjections", "*/parcelsAddedTotal", "*/key", "*/next",
                "*/redrawn", "*/leftOut", "*/withoutFlow"
            }
        ),
        rowsOf("-", keys::integer, "0", "", {"*/skipped"}),
        rowsOf("m3", keys::number, "0", ">=0 <=1e15", {"*/volumeTotal"}),
        rowsOf
        (
            "kg, or particles", keys::number, "0", ">=0 <=1e15",
            {"*/massInjected", "*/before"}
        ),
        rowsOf
        (
            "s", keys::number, "0", ">=-1e15 <=1e15",
            {
                "*/time", "*/timeStep0", "*/start", "*/began", "*/offset",
                "*/SOI"
            }
        ),
        rowsOf("1/s, kg/s", keys::number, "0", ">0 <=1e15", {"*/rate"}),
        rowsOf
        (
            "-", keys::name, "none", "",
            {"*/type", "*/rateKeyword", "*/profile"}
        )
    });
    return table;
}


//- Of the ledger
static const std::vector<keys::row>& ledgerRows()
{
    static const std::vector<keys::row> table = together
    ({
        rowsOf
        (
            "-", keys::integer, "", ">=0",
            {
                "version", "timeIndex", "injected", "refused", "nextId",
                "particleStep/number", "ofMaterial/*/injected",
                "ofMaterial/*/escaped", "escaped/*/count"
            }
        ),
        rowsOf
        (
            "kg", keys::number, "", ">=0 <=1e15",
            {
                "injectedMass", "refusedMass", "ofMaterial/*/injectedMass",
                "ofMaterial/*/escapedMass", "escaped/*/mass"
            }
        ),
        rowsOf("s", keys::number, "", ">=0 <=1e15", {"particleStep/left"}),
        rowsOf("s", keys::number, "none", ">=-1e15 <=1e15", {"time"}),
        rowsOf("-", keys::number, "none", ">0 <=1", {"chi"}),
        rowsOf("-", keys::name, "", "", {"particleStep/gas"}),
        rowsOf("-", keys::name, "none", "", {"ratio"}),
        rowsOf("-", keys::name, "none", "oneWay twoWay", {"coupling"}),
        rowsOf("-", keys::name, "none", "frozen solved", {"gas"}),
        rowsOf("-", keys::block, "", "", {"ofMaterial", "escaped"}),
        rowsOf
        (
            "-", keys::block, "none", "",
            {"particleStep", "ofMaterial/*", "escaped/*"}
        ),
        rowsOf("-", keys::other, "", "names", {"walls", "materials"}),
        rowsOf("-", keys::flag, "", "", {"complete"}),
        rowsOf("-", keys::block, "none", "", {"checksums"}),
        rowsOf("-", keys::name, "none", "", {"checksums/*"})
    });
    return table;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::ledgerCheck::check
(
    const fvMesh& mesh,
    const word& cloudName,
    const label version
)
{
    autoPtr<untrapped> reading(new untrapped);
    const IOdictionary stored
    (
        IOobject
        (
            cloudName + "OutputProperties",
            mesh.time().timeName(),
            "uniform"/cloud::prefix/cloudName,
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    reading.clear();
    dictionaryLines::share(stored);

    keys::check(stored.subOrEmptyDict("injectionModel"), injectorRows());

    // What was cut short, or is of another version, is refused as that
    const dictionary* ledger = stored.findDict("ledger");
    if
    (
        ledger && ledger->found("complete")
     && ledger->lookupOrDefault<label>("version", 1) == version
    )
    {
        keys::check(*ledger, ledgerRows());
    }
}


Foam::word Foam::ledgerCheck::entry
(
    const dictionary& outputProperties,
    const word& keyword
)
{
    const dictionary* ledger = outputProperties.findDict("ledger");
    return
        ledger ? ledger->lookupOrDefault<word>(keyword, word::null) : word();
}


// ************************************************************************* //
