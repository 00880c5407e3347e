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
#include "dustTime.H"
#include "stopSignals.H"
#include "controlKeywords.H"
#include "controlTimes.H"
#include "dictionaryLines.H"
#include "dustProperties.H"
#include "functionTypes.H"
#include "IFstream.H"
#include "timeFiles.H"

#include "argList.H"
#include "IOdictionary.H"
#include "OSspecific.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const word markName("dustFoam");


//- Times that this rank has a directory of
static wordList timesIn(const fileName& directory)
{
    DynamicList<word> result;
    for (const fileName& name : readDir(directory, fileName::DIRECTORY))
    {
        scalar value;
        if (readScalar(name, value))
        {
            result.append(word(name));
        }
    }
    return result;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustTime::readControls()
{
    keep_ = purgeWrite_;
    purgeWrite_ = 0;

    if (!(std::isfinite(deltaT_) && deltaT_ > 0))
    {
        dustProperties::error
        (
            controlDict(),
            "deltaT",
            "is " + Foam::name(deltaT_) + " s",
            "> 0 s"
        );
    }
    maxWallTime_ = controlDict().lookupOrDefault<scalar>("maxWallTime", 0);
    if
    (
        controlDict().found("maxWallTime")
     && !(std::isfinite(maxWallTime_) && maxWallTime_ > 0)
    )
    {
        dustProperties::error
        (
            controlDict(),
            "maxWallTime",
            "is " + Foam::name(maxWallTime_) + " s",
            "> 0 s, or not given (no limit)"
        );
    }
}


Foam::scalar Foam::dustTime::wall() const
{
    return std::chrono::duration<scalar>
    (
        std::chrono::steady_clock::now() - start_
    ).count();
}


Foam::fileName Foam::dustTime::directory(const word& time) const
{
    const fileName own(path()/time);
    if (returnReduce(Foam::isDir(own), orOp<bool>()))
    {
        return own;
    }
    return fileHandler().filePath(own);
}


Foam::fileName Foam::dustTime::markFile(const word& time) const
{
    return fileHandler().objectPath
    (
        IOobject(markName, time, "uniform", *this),
        word::null
    );
}


bool Foam::dustTime::complete(const word& time) const
{
    const fileName files(directory(time));
    bool is = true;
    if (Pstream::master())
    {
        is = timeFiles::complete(files, files/"uniform"/markName);
    }
    Pstream::scatter(is);
    return is;
}


void Foam::dustTime::startAt(const instant& time)
{
    const scalar deltaT = deltaT_;
    const bool adjusts = controlDict().lookupOrDefault("adjustTimeStep", false);

    setTime(time, 0);
    startTime_ = time.value();
    startTimeIndex_ = timeIndex_;
    if (!adjusts)
    {
        deltaT_ = deltaT;
        deltaT0_ = deltaT;
    }
    deltaTSave_ = deltaT_;
}


void Foam::dustTime::skipIncomplete()
{
    if (complete(timeName()))
    {
        return;
    }
    const word bad(timeName());

    const word startFrom
    (
        controlDict().lookupOrDefault<word>("startFrom", "latestTime")
    );

    instantList all(findTimes(path(), constant()));
    label i = all.size() - 1;
    while
    (
        i >= 0
     && (all[i].name() == constant() || !complete(all[i].name()))
    )
    {
        --i;
    }

    if (startFrom != "latestTime" || i < 0)
    {
        dustProperties::error
        (
            controlDict(),
            "startFrom",
            "time " + bad + ", from which to start, is not complete:"
            " its writing was cut off. It may be deleted",
            "another time"
          + string
            (
                i < 0
              ? ", but none is complete"
              : ", the last complete one is " + all[i].name()
            )
        );
    }

    Info<< "Warning: time " << bad << " is not complete: its writing was cut"
        << " off. It is passed over and may be deleted" << nl
        << "    The run goes on from time " << all[i].name() << nl << endl;

    startAt(all[i]);
}


void Foam::dustTime::takeExactValue()
{
    const IOdictionary written
    (
        IOobject
        (
            "time", timeName(), "uniform", *this,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    scalar exact = 0;
    if
    (
        written.readIfPresent("value", exact)
     && std::isfinite(exact) && timeName(exact) == timeName()
    )
    {
        value() = exact;
        startTime_ = exact;
    }
}


void Foam::dustTime::begin() const
{
    const word time(timeName());

    // Of an earlier try, or of a run with other ranks: a rank that has no
    // particles writes none, and would leave what is there
    const fileName own(path()/time);
    if (Foam::isDir(own/"lagrangian"))
    {
        Foam::rmDir(own/"lagrangian");
    }

    const fileName mark(markFile(time));
    bool ok = true;
    string why;
    if (Pstream::master())
    {
        const double free = timeFiles::free(path());
        if (free >= 0 && free < lastSize_)
        {
            ok = false;
            why = "needs about " + timeFiles::sizeText(lastSize_);
        }
        else
        {
            ok = timeFiles::mark(mark, false);
            why = "its first file could not be written";
        }
    }
    Pstream::scatter(ok);
    Pstream::scatter(why);
    if (!ok)
    {
        fail(why);
    }

    // The directory is there on all ranks, or on none but the first
    if (Pstream::parRun())
    {
        returnReduce(ok, andOp<bool>());
    }
}


void Foam::dustTime::finish(const bool ok) const
{
    fileHandler().flush();

    const word time(timeName());
    const fileName files(directory(time));
    const bool looks = Pstream::master() || Foam::isDir(path()/time);

    fileNameList bad;
    double size = 0;
    if (looks)
    {
        // Some disks keep full seconds only
        bad = timeFiles::cutShort(files, beganWriting_ - 1);
        size = timeFiles::size(files);
    }

    List<fileNameList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = bad;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    for (const fileNameList& list : all)
    {
        if (list.size())
        {
            fail("file " + list.first() + " is cut short");
        }
    }
    if (!returnReduce(ok, andOp<bool>()))
    {
        fail("some of its files could not be written");
    }

    bool marked = true;
    if (Pstream::master())
    {
        marked = timeFiles::mark(markFile(time), true);
    }
    Pstream::scatter(marked);
    if (!marked)
    {
        fail("its last file could not be written");
    }

    lastSize_ = returnReduce(size, sumOp<double>());
    writtenIndex_ = timeIndex();
}


void Foam::dustTime::purge() const
{
    if (!keep_)
    {
        return;
    }
    if (written_.empty() || written_.last() != timeName())
    {
        written_.append(timeName());
    }
    while (written_.size() > keep_)
    {
        fileHandler().rmDir
        (
            fileHandler().filePath(objectRegistry::path(written_.first()))
        );
        DynamicList<word> rest;
        for (label i = 1; i < written_.size(); ++i)
        {
            rest.append(written_[i]);
        }
        written_.transfer(rest);
    }
}


void Foam::dustTime::fail(const string& what) const
{
    const double free = timeFiles::free(path());
    const double needed = max(lastSize_, 1e5);

    FatalErrorInFunction
        << "Time " << timeName() << " could not be written: " << what.c_str()
        << nl;
    if (free >= 0 && free < needed)
    {
        FatalError
            << "    The disk is full: " << timeFiles::sizeText(free).c_str()
            << " are free for " << path() << nl;
    }
    FatalError
        << "    Time " << timeName() << " is marked as not complete and may be"
        << " deleted. The run can go on from the last complete time with"
        << " startFrom latestTime" << exit(FatalError);
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const Foam::argList& Foam::dustTime::cleaned(const argList& args)
{
    // Before Time reads it: OpenFOAM divides by intervals. A rank that has no
    // such file leaves it to the others
    IFstream is
    (
        args.rootPath()/args.globalCaseName()/"system"/Time::controlDictName
    );
    if (is.good())
    {
        controlTimes::check(dictionary(is));
    }

    if (!Pstream::parRun())
    {
        return args;
    }

    List<wordList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = timesIn(args.path());
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    for (const word& time : all[Pstream::myProcNo()])
    {
        bool everywhere = true;
        for (const wordList& times : all)
        {
            everywhere = everywhere && times.found(time);
        }
        const fileName directory(args.path()/time);
        const fileName mark(directory/"uniform"/markName);

        // Nothing in it but the mark, or not even that
        const label n = timeFiles::all(directory).size();
        if (!everywhere && n == (Foam::isFile(mark) ? 1 : 0))
        {
            Foam::rmDir(directory);
            Pout<< "Warning: " << directory << " was removed: a run was ended"
                << " when it began to write there, and left no files" << endl;
        }
    }
    return args;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dustTime::dustTime(const argList& args)
:
    Time(Time::controlDictName, cleaned(args)),
    keep_(0),
    written_(),
    maxWallTime_(0),
    start_(std::chrono::steady_clock::now()),
    lastStep_(0),
    longestStep_(0),
    longestWrite_(0),
    beganWriting_(0),
    lastSize_(0),
    writtenIndex_(-1)
{
    dictionaryLines::share(controlDict());
    controlKeywords::check(controlDict());
    functionTypes::check(controlDict());
    readControls();
    skipIncomplete();
    takeExactValue();
    if (value() > endTime_ - 0.5*deltaT_)
    {
        Info<< "Nothing to do: the run starts at time " << timeName()
            << ", and endTime in " << controlDict().name() << " is "
            << endTime_ << " s" << nl << endl;
    }
    stopSignals::watch();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dustTime::readDict()
{
    Time::readDict();
    readControls();
}


void Foam::dustTime::stopIfAsked()
{
    const scalar now = wall();
    if (timeIndex() > startTimeIndex_ + 1)
    {
        longestStep_ = max(longestStep_, now - lastStep_);
    }
    lastStep_ = now;

    // The clocks of the ranks differ: the first decides
    bool late =
        maxWallTime_ > 0
     && now + longestStep_ + 2*longestWrite_ > maxWallTime_;
    Pstream::scatter(late);

    const label signal = returnReduce(label(stopSignals::came()), maxOp<label>());

    const bool over = value() > endTime_ - 0.5*deltaT_;
    if ((!signal && !late) || over)
    {
        return;
    }

    if (writtenIndex_ != timeIndex())
    {
        writeNow();
    }
    // No further step; what function objects do at the end is done
    stopAt_ = saNoWriteNow;
    endTime_ = value();

    Info<< nl << "Stopped after time " << timeName() << ": ";
    if (signal)
    {
        Info<< stopSignals::name(signal) << " came.";
    }
    else
    {
        Info<< "maxWallTime " << maxWallTime_ << " s is almost over.";
    }
    Info<< " All is written; startFrom latestTime goes on." << nl << endl;
}


bool Foam::dustTime::writeObject
(
    #if OPENFOAM >= 2006
    IOstreamOption streamOpt,
    #else
    IOstream::streamFormat fmt,
    IOstream::versionNumber ver,
    IOstream::compressionType cmp,
    #endif
    const bool valid
) const
{
    if (!writeTime())
    {
        return false;
    }
    const scalar began = wall();
    beganWriting_ = double(clock::getTime());

    begin();

    // OpenFOAM's own error says only at which list it came. Not where another
    // thread writes: nobody would catch it there.
    const bool catches = fileHandler().type() != "collated";
    const bool throwing = FatalError.throwExceptions(catches);
    const bool throwingIO = FatalIOError.throwExceptions(catches);
    bool ok = false;
    string why;
    try
    {
        #if OPENFOAM >= 2006
        ok = Time::writeObject(streamOpt, valid);
        #else
        ok = Time::writeObject(fmt, ver, cmp, valid);
        #endif
    }
    catch (const Foam::error& e)
    {
        why = e.message();
    }
    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);
    if (why.size())
    {
        fail(why);
    }

    finish(ok);
    purge();

    longestWrite_ = max(longestWrite_, wall() - began);
    return ok;
}


// ************************************************************************* //
