/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarMesh.H"

#include <numeric>

namespace
{

// Even-odd rule; a point on a shared edge belongs to one side only
bool contains
(
    const Eigen::Vector2d* vertices,
    const Foam::label n,
    const Eigen::Vector2d& x
)
{
    bool inside = false;
    for (Foam::label i = 0, j = n - 1; i < n; j = i++)
    {
        const Eigen::Vector2d& p = vertices[i];
        const Eigen::Vector2d& q = vertices[j];

        if
        (
            (p.y() > x.y()) != (q.y() > x.y())
         && x.x() < (q.x() - p.x())*(x.y() - p.y())/(q.y() - p.y()) + p.x()
        )
        {
            inside = !inside;
        }
    }
    return inside;
}

}


void Foam::planarMesh::setBins()
{
    if (!nCells())
    {
        nBins_[0] = nBins_[1] = 0;
        return;
    }

    // About one cell a bin
    binSize_ = std::sqrt
    (
        domain_.sizes().prod()/std::max(label(1), nCells())
    );
    for (int d = 0; d < 2; ++d)
    {
        nBins_[d] = std::max(1, int(std::ceil(domain_.sizes()[d]/binSize_)));
    }

    const auto forBins = [&](const label celli, const auto& f)
    {
        int lower[2], upper[2];
        binRange(boxes_[celli], lower, upper);
        for (int j = lower[1]; j <= upper[1]; ++j)
        {
            for (int i = lower[0]; i <= upper[0]; ++i)
            {
                f(i + nBins_[0]*j);
            }
        }
    };

    binStart_.assign(nBins_[0]*nBins_[1] + 1, 0);
    for (label celli = 0; celli < nCells(); ++celli)
    {
        forBins(celli, [&](const label bin) { ++binStart_[bin + 1]; });
    }
    std::partial_sum(binStart_.begin(), binStart_.end(), binStart_.begin());

    binCells_.resize(binStart_.back());
    std::vector<label> next(binStart_);
    for (label celli = 0; celli < nCells(); ++celli)
    {
        forBins
        (
            celli,
            [&](const label bin) { binCells_[next[bin]++] = celli; }
        );
    }
}


Foam::label Foam::planarMesh::findCell
(
    const point2& x,
    const label hint
) const
{
    if (hint >= 0 && contains(polygon(hint), polygonSize(hint), x))
    {
        return hint;
    }
    label found = -1;
    forCells
    (
        Eigen::AlignedBox2d(x, x),
        [&](const label celli)
        {
            if (found < 0 && contains(polygon(celli), polygonSize(celli), x))
            {
                found = celli;
            }
        }
    );
    return found;
}
