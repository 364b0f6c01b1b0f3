/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainRoom.H"

template<int D>
Foam::grainRoom<D>::grainRoom
(
    const nscd::Grains<D>& grains,
    const nscd::WallContact<D>& walls,
    const std::array<double, 3>& period,
    const nscd::Box<D>& region,
    const scalar radius
)
:
    period_(period),
    walls_(walls)
{
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const scalar reach = radius + grains.radius[i];
        bool isNear = true;
        for (int d = 0; d < D; ++d)
        {
            const double x = grains.position[i][d];
            isNear =
                isNear
             && (
                    period_[d] > 0
                 || (
                        x > region.lower[d] - reach
                     && x < region.upper[d] + reach
                    )
                );
        }
        if (isNear)
        {
            take(grains.position[i], grains.radius[i]);
        }
    }
}


template<int D>
nscd::Vector<D> Foam::grainRoom<D>::shortest(nscd::Vector<D> x) const
{
    for (int d = 0; d < D; ++d)
    {
        if (period_[d] > 0)
        {
            x[d] -= period_[d]*std::round(x[d]/period_[d]);
        }
    }
    return x;
}


template<int D>
bool Foam::grainRoom<D>::isFree
(
    const nscd::Vector<D>& x,
    const scalar radius
) const
{
    for (std::size_t i = 0; i < centre_.size(); ++i)
    {
        const scalar reach = radius + radius_[i];
        if (shortest(x - centre_[i]).squaredNorm() < reach*reach)
        {
            return false;
        }
    }
    bool isFree = true;
    walls_.forNear(x, radius, [&](const int) { isFree = false; });
    return isFree;
}


template<int D>
void Foam::grainRoom<D>::take(const nscd::Vector<D>& x, const scalar radius)
{
    centre_.push_back(x);
    radius_.push_back(radius);
}


template class Foam::grainRoom<2>;
template class Foam::grainRoom<3>;
