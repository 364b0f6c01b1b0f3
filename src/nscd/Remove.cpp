// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactDynamics::remove: grains go, contacts of those that stay keep their impulses.

#include "nscd/Implementation.hpp"

#include <stdexcept>

namespace nscd
{

namespace
{

/// Drop the entries that are marked.
template <class List>
void drop(List& list, const std::vector<bool>& gone)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < gone.size(); ++i)
    {
        if (!gone[i])
        {
            list[kept++] = list[i];
        }
    }
    list.resize(kept);
}

}  // namespace

template <int D>
void ContactDynamics<D>::Implementation::remove(const std::vector<bool>& gone)
{
    if (gone.size() != grains_.size())
    {
        throw std::invalid_argument(std::to_string(grains_.size()) + " grains but " + std::to_string(gone.size()) +
                                    " marks of those to remove");
    }
    std::vector<bool> goneMember;
    std::vector<int> newMember;
    int kept = 0;
    for (std::size_t m = 0; m < members_.size(); ++m)
    {
        goneMember.push_back(gone[members_.grain(static_cast<int>(m))]);
        newMember.push_back(kept);
        kept += goneMember.back() ? 0 : 1;
    }

    std::vector<NamedImpulse<D>> impulses;
    for (NamedImpulse<D> known : gatherImpulses(candidates_, impulses_, communicator_))
    {
        const bool withWall = known.b < 0;
        if (!goneMember[known.a] && (withWall || !goneMember[known.b]))
        {
            known.a = newMember[known.a];
            known.b = withWall ? known.b : newMember[known.b];
            impulses.push_back(known);
        }
    }

    drop(grains_.id, gone);
    drop(grains_.position, gone);
    drop(grains_.velocity, gone);
    drop(grains_.orientation, gone);
    drop(grains_.spin, gone);
    drop(grains_.shape, gone);
    drop(grains_.radius, gone);
    drop(grains_.mass, gone);
    drop(grains_.material, gone);
    drop(grains_.temperature, gone);
    drop(contactImpulse_, gone);
    drop(contactSpinImpulse_, gone);

    measureGrains();
    problem_.clear();
    rebuildCandidates(grains_.position, grains_.orientation, restSkin * meanRadius_, impulses);
    candidateWalls_ = wallBodies_;
    problem_.forget();
}

template void ContactDynamics<2>::Implementation::remove(const std::vector<bool>&);
template void ContactDynamics<3>::Implementation::remove(const std::vector<bool>&);

}  // namespace nscd
