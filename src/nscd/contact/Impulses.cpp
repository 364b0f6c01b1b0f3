// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/contact/Impulses.hpp"

namespace nscd
{

namespace
{

/// Two facets of a wall have one contact if the points where a grain is nearest to them are as near to each other, over
/// its radius: those in an angle of at most 30 degrees, and what it passes in a step.
constexpr double close = 0.5;

/// Round-off of distances to facets that share the nearest point, over the radius.
constexpr double roundOff = 1e-9;

/// Of a member with a facet.
template <int D>
struct LoadedFacet
{
    int member, body;
    Vector<D> way;   ///< from the member's centre to the facet [m]
    double age;      ///< [s]
};

template <int D>
std::vector<LoadedFacet<D>> loadedFacets(const Arrangement<D>& arrangement, const std::vector<Pair>& pairs,
                                         const std::vector<Impulse<D>>& impulses)
{
    std::vector<LoadedFacet<D>> loaded;
    for (std::size_t p = 0; p < pairs.size(); ++p)
    {
        if (pairs[p].second < 0 && impulses[p].normal > 0)
        {
            loaded.push_back({pairs[p].first, arrangement.wallBody(~pairs[p].second),
                              arrangement.wayToWall(pairs[p]), impulses[p].age});
        }
    }
    std::sort(loaded.begin(), loaded.end(),
              [](const LoadedFacet<D>& a, const LoadedFacet<D>& b) { return a.member < b.member; });
    return loaded;
}

/// Name the impulse of a pair by user's numbers of members; vectors and moments change sign with the order of the
/// two, the tangential component of 2-D does not because its direction turns with the normal.
template <int D>
NamedImpulse<D> named(const Candidates<D>& candidates, const Pair& pair, Impulse<D> impulse)
{
    const int a = candidates.memberOrder()[pair.first];
    if (pair.second < 0)
    {
        return {a, pair.second, impulse};
    }
    const int b = candidates.memberOrder()[pair.second];
    if (a < b)
    {
        return {a, b, impulse};
    }
    if constexpr (D == 3)
    {
        impulse.tangential = -impulse.tangential;
    }
    impulse.rolling = -impulse.rolling;
    return {b, a, impulse};
}

}  // namespace

template <int D>
std::vector<char> handOverAges(const Arrangement<D>& arrangement, const std::vector<Pair>& pairs,
                               std::vector<Impulse<D>>& impulses)
{
    std::vector<char> goesOn(pairs.size(), 0);
    const std::vector<LoadedFacet<D>> loaded = loadedFacets(arrangement, pairs, impulses);
    for (std::size_t p = 0; !loaded.empty() && p < pairs.size(); ++p)
    {
        const Pair& pair = pairs[p];
        if (pair.second >= 0 || !arrangement.parameters(pair).coheres())
        {
            continue;
        }
        auto facet = std::lower_bound(loaded.begin(), loaded.end(), pair.first,
                                      [](const LoadedFacet<D>& f, int member) { return f.member < member; });
        if (facet == loaded.end() || facet->member != pair.first)
        {
            continue;
        }
        const Vector<D> way = arrangement.wayToWall(pair);
        const double radius = arrangement.radius(pair);
        for (; facet != loaded.end() && facet->member == pair.first; ++facet)
        {
            if (facet->body == arrangement.wallBody(~pair.second) && (way - facet->way).norm() < close * radius)
            {
                impulses[p].age = std::max(impulses[p].age, facet->age);
                goesOn[p] = goesOn[p] || way.norm() <= facet->way.norm() + roundOff * radius;
            }
        }
    }
    return goesOn;
}

template <int D>
std::vector<NamedImpulse<D>> gatherImpulses(const Candidates<D>& candidates, const std::vector<Impulse<D>>& impulses,
                                            const Communicator& communicator)
{
    std::vector<NamedImpulse<D>> mine;
    mine.reserve(impulses.size());
    for (std::size_t p = 0; p < impulses.size(); ++p)
    {
        if (impulses[p].normal > 0)
        {
            mine.push_back(named(candidates, candidates.pairs()[p], impulses[p]));
        }
    }
    return communicator.gather(std::move(mine));
}

template <int D>
std::vector<Impulse<D>> matchImpulses(const Candidates<D>& candidates, const std::vector<NamedImpulse<D>>& known)
{
    std::vector<Impulse<D>> impulses(candidates.pairs().size());
    if (known.empty())
    {
        return impulses;
    }
    std::vector<int> begin(candidates.memberOrder().size() + 1, 0);   // of the impulses of each grain a
    for (const NamedImpulse<D>& k : known)
    {
        ++begin[k.a + 1];
    }
    for (std::size_t a = 0; a + 1 < begin.size(); ++a)
    {
        begin[a + 1] += begin[a];
    }
    std::vector<int> sorted(known.size());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for (std::size_t k = 0; k < known.size(); ++k)
    {
        sorted[next[known[k].a]++] = static_cast<int>(k);
    }

    for (std::size_t p = 0; p < impulses.size(); ++p)
    {
        const NamedImpulse<D> wanted = named(candidates, candidates.pairs()[p], Impulse<D>());
        for (int s = begin[wanted.a]; s < begin[wanted.a + 1]; ++s)
        {
            if (known[sorted[s]].b == wanted.b)
            {
                impulses[p] = named(candidates, candidates.pairs()[p], known[sorted[s]].impulse).impulse;
            }
        }
    }
    return impulses;
}

template std::vector<char> handOverAges(const Arrangement<2>&, const std::vector<Pair>&, std::vector<Impulse<2>>&);
template std::vector<char> handOverAges(const Arrangement<3>&, const std::vector<Pair>&, std::vector<Impulse<3>>&);
template std::vector<NamedImpulse<2>> gatherImpulses(const Candidates<2>&, const std::vector<Impulse<2>>&,
                                                     const Communicator&);
template std::vector<NamedImpulse<3>> gatherImpulses(const Candidates<3>&, const std::vector<Impulse<3>>&,
                                                     const Communicator&);
template std::vector<Impulse<2>> matchImpulses(const Candidates<2>&, const std::vector<NamedImpulse<2>>&);
template std::vector<Impulse<3>> matchImpulses(const Candidates<3>&, const std::vector<NamedImpulse<3>>&);

}  // namespace nscd
