/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseLock.H"

#include "argList.H"
#include "OSspecific.H"
#include "Pstream.H"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{

using namespace Foam;

class lock
{
    const fileName file_;

    int descriptor_ = -1;

    //- Does the system know locks of files here?
    bool isLocked_ = false;

    //- Open the file that the path names now; false if another process holds it
    bool open();

    //- What the file says, empty if it is new
    std::string owner() const;

    void sign() const;

    [[noreturn]] void refuse(const std::string& owner, const char* what) const;

public:

    explicit lock(const fileName& file);

    ~lock()
    {
        rm(file_);
        ::close(descriptor_);
    }
};


bool lock::open()
{
    while (true)
    {
        descriptor_ =
            ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
        if (descriptor_ < 0)
        {
            FatalErrorInFunction
                << "The file " << file_ << ", which tells that a run is in"
                << " the case, cannot be made: " << std::strerror(errno) << nl
                << "    allowed: a case whose directory can be written"
                << exit(FatalError);
        }
        isLocked_ = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
        if (!isLocked_ && errno == EWOULDBLOCK)
        {
            return false;
        }

        // The run before may have removed the file since it was opened
        struct stat held, named;
        if
        (
            ::fstat(descriptor_, &held) == 0
         && ::stat(file_.c_str(), &named) == 0
         && held.st_ino == named.st_ino
        )
        {
            return true;
        }
        ::close(descriptor_);
    }
}


std::string lock::owner() const
{
    char text[1024];
    const ssize_t length = ::pread(descriptor_, text, sizeof(text), 0);
    std::string result(text, length > 0 ? length : 0);
    result.erase(result.find_last_not_of(" \n") + 1);
    return result;
}


void lock::sign() const
{
    const std::string text
    (
        "host " + hostName() + " process " + std::to_string(::getpid()) + '\n'
    );
    if
    (
        ::ftruncate(descriptor_, 0) != 0
     || ::pwrite(descriptor_, text.data(), text.size(), 0) != ssize_t(text.size())
    )
    {
        FatalErrorInFunction
            << "The file " << file_ << " cannot be written: "
            << std::strerror(errno) << exit(FatalError);
    }
}


void lock::refuse(const std::string& owner, const char* what) const
{
    FatalErrorInFunction
        << "Another run " << what << " in this case: " << owner.c_str() << nl
        << "    allowed: one run at a time; if that one has ended, remove "
        << file_ << exit(FatalError);
    std::abort();
}


lock::lock(const fileName& file)
:
    file_(file)
{
    if (!open())
    {
        refuse(owner(), "is");
    }

    const std::string before(owner());
    if (before.size())
    {
        std::istringstream is(before);
        std::string key, host, word;
        label process = 0;
        if
        (
            !(is >> key >> host >> word >> process)
         || key != "host" || word != "process"
        )
        {
            FatalErrorInFunction
                << "The file " << file_ << ", which tells that a run is in the"
                << " case, has '" << before.c_str() << "'" << nl
                << "    allowed: host <name> process <number>; if no run is in"
                << " the case, remove it" << exit(FatalError);
        }
        if (host != hostName())
        {
            refuse(before, "on another host may be");
        }
        if (!isLocked_ && (::kill(process, 0) == 0 || errno == EPERM))
        {
            refuse(before, "is");
        }
        Info<< "The run of " << before.c_str()
            << " in this case has ended without removing " << file_
            << ": it is taken over" << nl << endl;
    }
    sign();
}


// Lives until the process ends, also by an error
std::unique_ptr<lock> held;

}


void Foam::lockCase(const argList& args)
{
    if (Pstream::master())
    {
        held.reset(new lock(args.rootPath()/args.globalCaseName()/"grains.lock"));
    }

    label isMine = 1;
    Pstream::scatter(isMine);
}
