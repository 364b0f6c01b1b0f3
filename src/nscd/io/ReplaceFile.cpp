// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/io/ReplaceFile.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <unistd.h>

namespace nscd
{

namespace
{

[[noreturn]] void throwSystemError(const std::string& file, const std::string& action)
{
    throw std::runtime_error(file + ": " + action + ": " + std::strerror(errno));
}

/// Wait until the contents of a file, or the entries of a directory, are on disc.
void synchronise(const std::string& name, int flags)
{
    const int descriptor = ::open(name.c_str(), flags);
    if (descriptor < 0)
    {
        throwSystemError(name, "cannot be opened");
    }
    const bool failed = ::fsync(descriptor) != 0 && errno != EINVAL;
    ::close(descriptor);
    if (failed)
    {
        throwSystemError(name, "cannot be brought to disc");
    }
}

}  // namespace

void replaceFile(const std::string& temporary, const std::string& file)
{
    synchronise(temporary, O_RDONLY);
    if (std::rename(temporary.c_str(), file.c_str()) != 0)
    {
        throwSystemError(file, "cannot be replaced");
    }
    const std::size_t slash = file.rfind('/');
    synchronise(slash == std::string::npos ? "." : file.substr(0, slash + 1), O_RDONLY | O_DIRECTORY);
}

}  // namespace nscd
