/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "occupiedSpace.H"

#include <algorithm>
#include <cmath>

template<int D>
Foam::occupiedSpace<D>::occupiedSpace
(
    const nscd::Grains<D>& grains,
    const std::array<double, 3>& period
)
:
    period_(period)
{
    for (const double r : grains.radius)
    {
        width_ = std::max(width_, 2*r);
    }
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        nscd::Vector<D> x(grains.position[i]);
        for (int d = 0; d < D; ++d)
        {
            x[d] -= period_[d] > 0 ? period_[d]*std::floor(x[d]/period_[d]) : 0;
        }
        balls_[cellOf(x)].push_back({x, grains.radius[i]});
    }
}


template<int D>
typename Foam::occupiedSpace<D>::cell Foam::occupiedSpace<D>::cellOf
(
    const nscd::Vector<D>& x
) const
{
    cell c;
    for (int d = 0; d < D; ++d)
    {
        c[d] = std::int64_t(std::floor(x[d]/width_));
    }
    return c;
}


template<int D>
bool Foam::occupiedSpace<D>::isFreeAt
(
    const nscd::Vector<D>& x,
    const scalar radius
) const
{
    const nscd::Vector<D> reach
    (
        nscd::Vector<D>::Constant(radius + 0.5*width_)
    );
    const cell first(cellOf(x - reach)), last(cellOf(x + reach));
    cell c(first);
    while (true)
    {
        const auto found = balls_.find(c);
        if (found != balls_.end())
        {
            for (const ball& b : found->second)
            {
                if ((b.centre - x).norm() < b.radius + radius)
                {
                    return false;
                }
            }
        }
        int d = 0;
        while (d < D && c[d] == last[d])
        {
            c[d] = first[d];
            ++d;
        }
        if (d == D)
        {
            return true;
        }
        ++c[d];
    }
}


template<int D>
bool Foam::occupiedSpace<D>::isFree
(
    const nscd::Vector<D>& x,
    const scalar radius
) const
{
    if (balls_.empty())
    {
        return true;
    }

    // The image among the grains, and those a period beside it
    nscd::Vectors<D> images{x};
    for (int d = 0; d < D; ++d)
    {
        if (period_[d] > 0)
        {
            nscd::Vectors<D> more;
            for (nscd::Vector<D> y : images)
            {
                y[d] -= period_[d]*std::floor(y[d]/period_[d]);
                for (const int shift : {-1, 0, 1})
                {
                    more.push_back(y + shift*period_[d]*nscd::Vector<D>::Unit(d));
                }
            }
            images = more;
        }
    }
    return std::all_of
    (
        images.begin(), images.end(),
        [&](const nscd::Vector<D>& y) { return isFreeAt(y, radius); }
    );
}


template class Foam::occupiedSpace<2>;
template class Foam::occupiedSpace<3>;
