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

#include "studyRuns.H"

#include "csvTable.H"
#include "entryText.H"

#include "dictionary.H"
#include "error.H"
#include "IFstream.H"
#include "IOstreams.H"
#include "SHA1.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const char* const root = "errorVsRunTime";
const char* const dictionaryFile = "system/errorVsRunTimeDict";

// Text of numbers in files; enough for any double
constexpr int precision = 12;


std::string contents(const fs::path& file)
{
    std::ifstream is(file, std::ios::binary);
    std::ostringstream text;
    text << is.rdbuf();
    return text.str();
}


bool begins(const std::string& text, const char* with)
{
    return text.rfind(with, 0) == 0;
}


//- At the top of the case: what a run makes anew, or nobody needs
bool leftOut(const fs::path& path)
{
    const std::string name(path.filename());
    Foam::scalar time;
    return
        name == root || name == "postProcessing" || name == "VTK"
     || name == "dynamicCode" || begins(name, "processor")
     || begins(name, "log.") || begins(name, ".") || begins(name, "README")
     || path.extension() == ".png"
     || (Foam::csvTable::number(name, time) && time != 0);
}


double seconds(const timeval& t)
{
    return t.tv_sec + 1e-6*t.tv_usec;
}


double wallClock()
{
    timeval now;
    gettimeofday(&now, nullptr);
    return seconds(now);
}


//- 45 s, 12 min, 3.4 h
std::string duration(const double s)
{
    std::ostringstream os;
    if (s < 100)
    {
        os << std::lround(s) << " s";
    }
    else if (s < 6000)
    {
        os << std::lround(s/60) << " min";
    }
    else
    {
        os << std::setprecision(3) << s/3600 << " h";
    }
    return os.str();
}

} // End namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::studyRuns::findFiles()
{
    for (const auto& top : fs::directory_iterator("."))
    {
        if (leftOut(top.path()))
        {
            continue;
        }
        if (!top.is_directory())
        {
            files_.push_back(top.path().lexically_normal().string());
            continue;
        }
        for
        (
            const auto& item : fs::recursive_directory_iterator
            (
                top.path(), fs::directory_options::follow_directory_symlink
            )
        )
        {
            if (item.is_regular_file())
            {
                files_.push_back(item.path().lexically_normal().string());
            }
        }
    }
    std::sort(files_.begin(), files_.end());
}


std::string Foam::studyRuns::checksum() const
{
    SHA1 sum;
    const std::string commands
    (
        settings_.command() + '\n' + settings_.prepare() + '\n'
    );
    for (const std::string& file : files_)
    {
        const bool script = file == "Allrun" || file == "Allclean";
        if
        (
            file != dictionaryFile
         && (!script || commands.find(file) != std::string::npos)
        )
        {
            sum.append(file + '\n');
            const std::string text(contents(file));
            sum.append(text.data(), text.size());
        }
    }
    sum.append(commands + std::to_string(settings_.ranks()) + '\n');
    return sum.str();
}


void Foam::studyRuns::makeCase(const run& r) const
{
    const fs::path directory(r.directory);
    fs::remove_all(directory);
    for (const std::string& file : files_)
    {
        const fs::path to(directory/file);
        fs::create_directories(to.parent_path());
        fs::copy_file(file, to);
    }

    const auto setEntry =
        [&](const studySettings::variable& v, const std::string& value)
    {
        const fs::path file(directory/v.file);
        const std::string text
        (
            entryText::set(contents(file), v.path, value)
        );
        std::ofstream(file, std::ios::binary) << text;

        // An entry below may take it back
        const dictionary dict((IFstream(file.string())()));
        const dictionary* end;
        const entry* e = entryText::find(dict, v.path, end);
        if
        (
            !e || e->isDict()
         || entryText::tokensText(e->stream()) != entryText::normalised(value)
        )
        {
            FatalErrorInFunction
                << "Cannot set " << v.name << " to " << value << " in "
                << file.string() << ": what stands there overrules it"
                << exit(FatalError);
        }
    };

    const studySettings::setting& s = settings_.settings()[r.setting];
    for (std::size_t k = 0; k < s.size(); ++k)
    {
        setEntry(settings_.variables()[k], s[k]);
    }
    if (settings_.seeded())
    {
        setEntry(settings_.seeds(), settings_.seeds().values[r.seed]);
    }
}


std::vector<Foam::studyRuns::stage> Foam::studyRuns::stages() const
{
    std::vector<stage> all;
    if (!settings_.prepare().empty())
    {
        all.push_back({"log.prepare", settings_.prepare()});
    }
    if (settings_.ranks() > 1)
    {
        all.push_back({"log.decomposePar", "decomposePar -force -copyUniform"});
        all.push_back
        ({
            "log.command",
            "mpirun -np " + std::to_string(settings_.ranks()) + ' '
          + settings_.command() + " -parallel"
        });
    }
    else
    {
        all.push_back({"log.command", settings_.command()});
    }
    return all;
}


pid_t Foam::studyRuns::start
(
    const std::string& directory,
    const std::string& command,
    const std::string& log
)
{
    Info().flush();
    const pid_t pid = fork();
    if (pid < 0)
    {
        FatalErrorInFunction << "Cannot start a process" << exit(FatalError);
    }
    if (pid == 0)
    {
        // Not to go on alone if errorVsRunTime is ended
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        const int in = open("/dev/null", O_RDONLY);
        if (chdir(directory.c_str()) == 0)
        {
            const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
            dup2(in, 0);
            dup2(out, 1);
            dup2(out, 2);
            execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        }
        _exit(127);
    }
    return pid;
}


bool Foam::studyRuns::recorded(run& r) const
{
    IFstream is(r.directory + "/finished");
    if (!is.good())
    {
        return false;
    }
    const dictionary record(is);
    string checksum;
    return
        record.readIfPresent("checksum", checksum)
     && checksum == r.checksum
     && record.readIfPresent("cpu_s", r.cpu);
}


bool Foam::studyRuns::readResults(run& r) const
{
    r.results.clear();
    try
    {
        for (const auto& q : settings_.quantities())
        {
            r.results.push_back(csvTable(r.directory, q.file).valueOf(q));
        }
    }
    catch (const csvTable::error& e)
    {
        r.failure = e.reason;
        return false;
    }
    return true;
}


void Foam::studyRuns::removeFields(const std::string& directory)
{
    std::vector<fs::path> all{fs::path(directory)/"constant"/"polyMesh"};
    for (const auto& item : fs::directory_iterator(directory))
    {
        const std::string name(item.path().filename());
        scalar time;
        if
        (
            item.is_directory()
         && (begins(name, "processor") || csvTable::number(name, time))
        )
        {
            all.push_back(item.path());
        }
    }
    for (const fs::path& path : all)
    {
        fs::remove_all(path);
    }
}


void Foam::studyRuns::take(run& r) const
{
    r.finished = readResults(r);
    if (!r.finished)
    {
        return;
    }
    if (!settings_.keepFields())
    {
        removeFields(r.directory);
    }
    std::ofstream os(r.directory + "/finished");
    os.precision(precision);
    os  << "checksum \"" << r.checksum << "\";\n"
        << "cpu_s " << r.cpu << ";\n";
}


std::string Foam::studyRuns::name(const run& r) const
{
    return
        settings_.title(settings_.settings()[r.setting])
      + (
            settings_.seeded()
          ? " seed " + settings_.seeds().values[r.seed]
          : std::string()
        );
}


Foam::scalar Foam::studyRuns::secondsLeft() const
{
    // A run takes as long as others of its setting, or as all do on average
    std::vector<scalar> sum(settings_.settings().size()), n(sum.size());
    scalar all = 0;
    for (const run& r : runs_)
    {
        sum[r.setting] += r.wall;
        n[r.setting] += r.wall > 0;
        all += r.wall;
    }
    scalar left = 0;
    for (const run& r : runs_)
    {
        if (!r.finished && r.failure.empty())
        {
            left += n[r.setting] ? sum[r.setting]/n[r.setting] : all/done_;
        }
    }
    return left/settings_.jobs();
}


void Foam::studyRuns::report(run& r)
{
    r.wall = wallClock() - r.began;
    ++done_;
    Info<< "    " << label(done_) << '/' << label(toDo_) << "  "
        << name(r).c_str() << ": ";
    if (r.finished)
    {
        Info<< r.cpu << " s CPU";
    }
    else
    {
        Info<< "FAILED: " << r.failure.c_str();
    }
    if (done_ < toDo_)
    {
        Info<< ", left about " << duration(secondsLeft()).c_str();
    }
    Info<< endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::studyRuns::studyRuns(const studySettings& settings)
:
    settings_(settings),
    done_(0),
    toDo_(0)
{
    findFiles();
    const std::string common(checksum());

    // Seeds outermost: all settings with the first seed, and it is known how
    // long the others take
    for (std::size_t k = 0; k < settings.seeds().values.size(); ++k)
    {
        for (std::size_t i = 0; i < settings.settings().size(); ++i)
        {
            const std::string& seed = settings.seeds().values[k];
            const studySettings::setting& s = settings.settings()[i];

            run r;
            r.setting = i;
            r.seed = k;
            r.directory = std::string(root) + "/" + settings.title(s);
            if (settings.seeded())
            {
                r.directory =
                    r.directory + "/seed" + studySettings::plain(seed);
            }

            SHA1 sum(common);
            for (std::size_t j = 0; j < s.size(); ++j)
            {
                const studySettings::variable& v = settings.variables()[j];
                sum.append('\n' + v.file);
                for (const std::string& part : v.path)
                {
                    sum.append('\n' + part);
                }
                sum.append('\n' + s[j]);
            }
            sum.append('\n' + seed);
            r.checksum = sum.str();

            r.finished = recorded(r) && readResults(r);
            r.failure.clear();
            toDo_ += !r.finished;
            runs_.push_back(r);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::studyRuns::execute()
{
    Info<< label(runs_.size()) << " runs, "
        << label(runs_.size() - toDo_) << " of them finished earlier" << endl;

    struct process
    {
        run* r;
        std::size_t stage;
    };
    const std::vector<stage> all(stages());
    std::map<pid_t, process> running;
    const auto begin = [&](run& r, const std::size_t k)
    {
        running[start(r.directory, all[k].command, all[k].log)] = {&r, k};
    };
    auto next = runs_.begin();

    while (true)
    {
        while (running.size() < std::size_t(settings_.jobs()))
        {
            next = std::find_if
            (
                next, runs_.end(), [](const run& r) { return !r.finished; }
            );
            if (next == runs_.end())
            {
                break;
            }
            makeCase(*next);
            next->began = wallClock();
            begin(*next, 0);
            ++next;
        }
        if (running.empty())
        {
            break;
        }

        int status;
        rusage usage;
        const auto found = running.find(wait4(-1, &status, 0, &usage));
        if (found == running.end())
        {
            continue;
        }
        const process p = found->second;
        running.erase(found);

        const bool good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
        if (good && p.stage + 1 < all.size())
        {
            begin(*p.r, p.stage + 1);
            continue;
        }
        if (good)
        {
            p.r->cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
            take(*p.r);
        }
        else
        {
            p.r->failure =
                '\'' + all[p.stage].command + "' ended with "
              + (
                    WIFEXITED(status)
                  ? "exit code " + std::to_string(WEXITSTATUS(status))
                  : "signal " + std::to_string(WTERMSIG(status))
                );
        }
        if (!p.r->failure.empty())
        {
            p.r->failure += ", see " + p.r->directory + '/' + all[p.stage].log;
        }
        report(*p.r);
    }
}


// ************************************************************************* //
