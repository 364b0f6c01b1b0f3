// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace nscd
{

/// Bring 'temporary' to disc and give it the name 'file', in the same directory: whatever happens, 'file' is the old
/// one or the new one.  Throws std::runtime_error naming file and reason.
void replaceFile(const std::string& temporary, const std::string& file);

}  // namespace nscd
