/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "networkFactors.H"

Foam::networkFactors::networkFactors
(
    const nscd::HeatNetwork& network,
    const scalar capacity,
    const scalarField& weight,
    const scalarField& diagonal
)
:
    start_(diagonal.size() + 1, Zero),
    inverse_(diagonal)
{
    // A grain may touch an image of itself
    const auto forLinks = [&](const auto& f)
    {
        for (const nscd::HeatNetwork::Link& l : network.links())
        {
            if (l.i != l.j)
            {
                f(min(l.i, l.j), max(l.i, l.j), l.conductance/capacity);
            }
        }
    };
    forLinks([&](const label lower, label, scalar) { ++start_[lower + 1]; });
    for (label i = 1; i < start_.size(); ++i)
    {
        start_[i] += start_[i - 1];
    }
    upper_.resize(start_.last());
    toUpper_.resize(upper_.size());
    toLower_.resize(upper_.size());
    labelList next(start_);
    forLinks
    (
        [&](const label lower, const label upper, const scalar h)
        {
            const label at = next[lower]++;
            upper_[at] = upper;
            toUpper_[at] = weight[upper]*h;
            toLower_[at] = weight[lower]*h;
        }
    );

    forAll(inverse_, i)
    {
        inverse_[i] = 1/inverse_[i];
        for (label at = start_[i]; at < start_[i + 1]; ++at)
        {
            inverse_[upper_[at]] -= toLower_[at]*toUpper_[at]*inverse_[i];
            toLower_[at] *= inverse_[i];
        }
    }
    forAll(upper_, at)
    {
        toUpper_[at] *= inverse_[upper_[at]];
    }
}


void Foam::networkFactors::solve(scalarField& r) const
{
    r *= inverse_;
    forAll(r, i)
    {
        for (label at = start_[i]; at < start_[i + 1]; ++at)
        {
            r[upper_[at]] += toUpper_[at]*r[i];
        }
    }
    forAllReverse(r, i)
    {
        for (label at = start_[i]; at < start_[i + 1]; ++at)
        {
            r[i] += toLower_[at]*r[upper_[at]];
        }
    }
}
