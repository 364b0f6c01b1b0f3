/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "networkFactors.H"

#include <algorithm>
#include <tuple>

Foam::networkFactors::networkFactors
(
    const nscd::HeatNetwork& network,
    const scalar capacity,
    const scalarField& weight,
    const scalarField& diagonal
)
:
    inverse_(diagonal)
{
    links_.reserve(network.links().size());
    for (const nscd::HeatNetwork::Link& l : network.links())
    {
        const scalar h = l.conductance/capacity;
        const label lower = min(l.i, l.j);
        const label upper = max(l.i, l.j);
        if (lower != upper)
        {
            links_.push_back({lower, upper, weight[lower]*h, weight[upper]*h});
        }
    }
    std::sort
    (
        links_.begin(),
        links_.end(),
        [](const link& a, const link& b)
        {
            return std::tie(a.lower, a.upper) < std::tie(b.lower, b.upper);
        }
    );
    for (const link& l : links_)
    {
        inverse_[l.upper] -= l.inLower*l.inUpper/inverse_[l.lower];
    }
    inverse_ = 1/inverse_;
}


void Foam::networkFactors::solve(scalarField& r) const
{
    r *= inverse_;
    for (const link& l : links_)
    {
        r[l.upper] += inverse_[l.upper]*l.inUpper*r[l.lower];
    }
    for (auto l = links_.rbegin(); l != links_.rend(); ++l)
    {
        r[l->lower] += inverse_[l->lower]*l->inLower*r[l->upper];
    }
}
