// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/Arrangement.hpp"
#include "nscd/contact/Contact.hpp"

namespace nscd
{

/// Impulse on the second body of a pair, see Contact.
template <int D>
struct Impulse
{
    double normal = 0;
    Tangent<D> tangential = zeroTangent<D>();
    Tangent<D> rolling = zeroTangent<D>();   ///< angular impulse on the second [N m s]
    double age = 0;   ///< how long the contact, or one that it continues, has carried an impulse without a break [s]
    double attraction = 0;   ///< of its bodies, which is in 'normal' (doc/theory, eq. 5.10) [N s]
};

/// What the contact of a pair, or the impacts before it, gave to the second body in a sub-step.
template <int D>
struct PairImpulse
{
    std::size_t pair;
    Vector<D> normal;    ///< at the beginning of the sub-step
    double gap;          ///< at the beginning of the sub-step [m]
    Vector<D> impulse;   ///< [N s]
    double pressing;     ///< sum of the normal impulses [N s]
    int impacts;         ///< 0: of the contact
    Tangent<D> moment;   ///< of rolling [N m s]
};

/// An impulse that outlives the candidate list: named by user's numbers of members, a < b, or by a member and wall ~b,
/// and meaning the impulse on b.
template <int D>
struct NamedImpulse
{
    int a, b;
    Impulse<D> impulse;
};

/// The non-zero impulses of all ranks, on every rank, in an order that does not depend on the number of ranks.
template <int D>
std::vector<NamedImpulse<D>> gatherImpulses(const Candidates<D>& candidates, const std::vector<Impulse<D>>& impulses,
                                            const Communicator& communicator);

/// Let contacts with walls go on from one facet to the next: a facet has at least the age of the member's contacts with
/// others of the same body, if the points where the member is nearest to the two are close to each other.  Returns
/// which pairs are contacts that go on so: to a facet that is no farther.
template <int D>
std::vector<char> handOverAges(const Arrangement<D>& arrangement, const std::vector<Pair>& pairs,
                               std::vector<Impulse<D>>& impulses);

/// The impulses of this rank's candidates; zero for pairs that are not in the list.
template <int D>
std::vector<Impulse<D>> matchImpulses(const Candidates<D>& candidates, const std::vector<NamedImpulse<D>>& known);

}  // namespace nscd
