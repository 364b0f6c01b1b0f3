/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutCell.H"

#include <limits>

void Foam::cutCell::sort(scalar& low, scalar& middle, scalar& high)
{
    if (low > middle)
    {
        Swap(low, middle);
    }
    if (middle > high)
    {
        Swap(middle, high);
    }
    if (low > middle)
    {
        Swap(low, middle);
    }
}


Foam::scalar Foam::cutCell::triangle::below(const scalar z) const
{
    if (z <= low)
    {
        return 0;
    }
    if (z >= high)
    {
        return 1;
    }
    return
        z < middle
      ? sqr(z - low)/((middle - low)*(high - low))
      : 1 - sqr(high - z)/max((high - middle)*(high - low), VSMALL);
}


Foam::scalar Foam::cutCell::shareBelow
(
    scalar a,
    scalar b,
    scalar c,
    const scalar height
)
{
    sort(a, b, c);
    return triangle{a, b, c, 0, 0}.below(height);
}


void Foam::cutCell::add
(
    const point& a,
    const point& b,
    const point& c,
    const vector& up
)
{
    scalar low = a & up, middle = b & up, high = c & up;
    sort(low, middle, high);
    const vector S(0.5*((b - a) ^ (c - a)));
    triangles_.append({low, middle, high, a & S, up & S});
    low_ = min(low_, low);
    high_ = max(high_, high);
    volume_ += (a & S)/3;
}


Foam::cutCell::cutCell
(
    const primitiveMesh& mesh,
    const label celli,
    const vector& up
)
:
    centre_(mesh.cellCentres()[celli] & up),
    low_(GREAT),
    high_(-GREAT),
    volume_(0)
{
    const point& centre = mesh.cellCentres()[celli];
    for (const label facei : mesh.cells()[celli])
    {
        const bool isOwner = mesh.faceOwner()[facei] == celli;
        const face& corners = mesh.faces()[facei];
        const point middle(mesh.faceCentres()[facei] - centre);
        forAll(corners, i)
        {
            const point a(mesh.points()[corners[i]] - centre);
            const point b(mesh.points()[corners.nextLabel(i)] - centre);
            add(middle, isOwner ? a : b, isOwner ? b : a, up);
        }
    }
}


Foam::scalar Foam::cutCell::shareBelow(const scalar z) const
{
    scalar volume = 0;
    for (const triangle& t : triangles_)
    {
        const scalar below = t.below(z);
        if (below > 0)
        {
            volume += below*(t.pS - z*t.upS);
        }
    }
    return volume/(3*volume_);
}


Foam::scalar Foam::cutCell::level(const scalar share) const
{
    if (share <= 0)
    {
        return centre_ + low_;
    }
    if (share >= 1)
    {
        return centre_ + high_;
    }

    // Regula falsi (Illinois): an end that stays counts half
    constexpr label most = 120;
    constexpr scalar roundOff = 4*std::numeric_limits<scalar>::epsilon();

    scalar low = low_, high = high_;
    scalar atLow = -share, atHigh = 1 - share;
    scalar z = low;
    label last = 0;
    for (label i = 0; i < most; ++i)
    {
        const scalar before = z;
        z = low - (high - low)*atLow/(atHigh - atLow);
        const scalar difference = shareBelow(z) - share;
        if
        (
            mag(difference) < roundOff
         || (i > 0 && mag(z - before) < roundOff*(high_ - low_))
        )
        {
            break;
        }
        const label side = difference < 0 ? -1 : 1;
        (difference < 0 ? low : high) = z;
        (difference < 0 ? atLow : atHigh) = difference;
        if (side == last)
        {
            (difference < 0 ? atHigh : atLow) *= 0.5;
        }
        last = side;
    }
    return centre_ + z;
}
