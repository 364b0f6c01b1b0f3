// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactDynamics::remove: grains go, those that stay keep their contacts.

#include "nscd/dynamics/Implementation.hpp"

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

/// Numbers of those that stay; -1 for those that are marked.
std::vector<int> numbersWithout(const std::vector<bool>& gone)
{
    std::vector<int> numbers;
    int kept = 0;
    for (const bool g : gone)
    {
        numbers.push_back(g ? -1 : kept++);
    }
    return numbers;
}

/// Renumber the two of a contact, of which a wall (< 0) may be the second; false if one of them has gone.
bool renumber(int& first, int& second, const std::vector<int>& numbers)
{
    const bool withWall = second < 0;
    first = numbers[first];
    second = withWall ? second : numbers[second];
    return first >= 0 && (withWall || second >= 0);
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
    const std::vector<int> grain = numbersWithout(gone);
    std::vector<ContactForce<D>> contacts;
    for (ContactForce<D> c : ownContacts())
    {
        if (renumber(c.first, c.second, grain))
        {
            contacts.push_back(c);
        }
    }
    contactsOfOthers_ = std::move(contacts);
    for (std::vector<Touching<D>>& mine : touching_)
    {
        const auto isGone = [&](Touching<D>& t) { return !renumber(t.first, t.second, grain); };
        mine.erase(std::remove_if(mine.begin(), mine.end(), isGone), mine.end());
    }

    std::vector<bool> goneMember;
    for (std::size_t m = 0; m < members_.size(); ++m)
    {
        goneMember.push_back(gone[members_.grain(static_cast<int>(m))]);
    }
    const std::vector<int> member = numbersWithout(goneMember);
    std::vector<NamedImpulse<D>> impulses;
    for (NamedImpulse<D> known : gatherImpulses(candidates_, impulses_, communicator_))
    {
        if (renumber(known.a, known.b, member))
        {
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
    drop(heaviness_, gone);
    for (Wrenches<D>* known : {&unexpected_, &owed_, &lasting_, &earlier_})
    {
        drop(known->force, gone);
        drop(known->torque, gone);
    }

    ambient_.clear();
    viscosity_.clear();
    measureGrains();
    problem_.clear();
    impacts_.clear();
    listAnew(reachAtRest(), impulses);
}

template void ContactDynamics<2>::Implementation::remove(const std::vector<bool>&);
template void ContactDynamics<3>::Implementation::remove(const std::vector<bool>&);

}  // namespace nscd
