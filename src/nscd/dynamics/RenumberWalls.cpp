// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/dynamics/RenumberWalls.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace nscd
{

namespace
{

using Numbers = std::map<std::string, std::vector<int>>;

/// Numbers of what each entry has, in their order.
Numbers byName(const WallNames& names, const std::vector<int>& entryOf)
{
    Numbers result;
    for (std::size_t i = 0; i < entryOf.size(); ++i)
    {
        result[names.entries[entryOf[i]]].push_back(static_cast<int>(i));
    }
    return result;
}

template <int D>
void checkNames(const State<D>& state, const std::string& file)
{
    const WallNames& names = state.wallNames;
    const auto isEntry = [&](int entry)
    { return entry >= 0 && static_cast<std::size_t>(entry) < names.entries.size(); };
    if (names.ofBody.size() != state.wallBodies.size() || state.candidateWalls.size() != state.wallBodies.size() ||
        !std::all_of(names.ofBody.begin(), names.ofBody.end(), isEntry) ||
        !std::all_of(names.ofWall.begin(), names.ofWall.end(), isEntry))
    {
        throw std::runtime_error(file + ": names of walls that it does not have");
    }
}

}  // namespace

template <int D>
void renumberWalls(State<D>& state, const WallNames& names, const std::vector<WallBody<D>>& initial,
                   const std::string& file)
{
    if (state.wallNames.entries.empty() || names.entries.empty())
    {
        return;
    }
    checkNames(state, file);

    const Numbers bodies = byName(names, names.ofBody);
    const Numbers oldBodies = byName(state.wallNames, state.wallNames.ofBody);
    std::vector<WallBody<D>> now = initial;
    std::vector<WallBody<D>> listed = initial;
    for (const auto& [name, old] : oldBodies)
    {
        const auto body = bodies.find(name);
        if (body != bodies.end())
        {
            now[body->second.front()] = state.wallBodies[old.front()];
            listed[body->second.front()] = state.candidateWalls[old.front()];
        }
        else if (std::count(names.entries.begin(), names.entries.end(), name))
        {
            throw std::runtime_error(file + ": the wall " + name +
                                     " has moved, and now it has no motion; allowed: its motion, or a start before it"
                                     " had any");
        }
    }
    state.wallBodies = std::move(now);
    state.candidateWalls = std::move(listed);

    const Numbers walls = byName(names, names.ofWall);
    std::vector<int> newNumber(state.wallNames.ofWall.size(), -1);
    for (const auto& [name, old] : byName(state.wallNames, state.wallNames.ofWall))
    {
        const auto wall = walls.find(name);
        if (wall != walls.end() && wall->second.size() == old.size())
        {
            for (std::size_t i = 0; i < old.size(); ++i)
            {
                newNumber[old[i]] = wall->second[i];
            }
        }
    }
    std::vector<NamedImpulse<D>> kept;
    for (NamedImpulse<D> impulse : state.impulses)
    {
        if (impulse.b < 0)
        {
            const std::size_t wall = static_cast<std::size_t>(~impulse.b);
            if (wall >= newNumber.size() || newNumber[wall] < 0)
            {
                continue;
            }
            impulse.b = ~newNumber[wall];
        }
        kept.push_back(impulse);
    }
    state.impulses = std::move(kept);
}

template void renumberWalls<2>(State<2>&, const WallNames&, const std::vector<WallBody<2>>&, const std::string&);
template void renumberWalls<3>(State<3>&, const WallNames&, const std::vector<WallBody<3>>&, const std::string&);

}  // namespace nscd
