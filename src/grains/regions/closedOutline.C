/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "closedOutline.H"

#include "mathematicalConstants.H"

#include <algorithm>

namespace
{

using nscd::Vector;

double distanceTo(const std::array<Vector<2>, 2>& s, const Vector<2>& x)
{
    const Vector<2> along(s[1] - s[0]);
    const double t = (x - s[0]).dot(along)/along.squaredNorm();
    return (x - s[0] - std::clamp(t, 0.0, 1.0)*along).norm();
}


double distanceTo(const Vector<3>& a, const Vector<3>& b, const Vector<3>& x)
{
    const Vector<3> along(b - a);
    const double t = (x - a).dot(along)/along.squaredNorm();
    return (x - a - std::clamp(t, 0.0, 1.0)*along).norm();
}


double distanceTo(const std::array<Vector<3>, 3>& t, const Vector<3>& x)
{
    const Vector<3> n((t[1] - t[0]).cross(t[2] - t[0]).normalized());
    bool isAbove = true;
    double least = std::numeric_limits<double>::max();
    for (int k = 0; k < 3; ++k)
    {
        const Vector<3>& a = t[k];
        const Vector<3>& b = t[(k + 1) % 3];
        isAbove = isAbove && n.dot((b - a).cross(x - a)) >= 0;
        least = std::min(least, distanceTo(a, b, x));
    }
    return isAbove ? std::abs(n.dot(x - t[0])) : least;
}


// Does a ray from x along the first axis cross the segment?
bool crosses(const std::array<Vector<2>, 2>& s, const Vector<2>& x)
{
    const Vector<2>& a = s[0];
    const Vector<2>& b = s[1];
    return
        (a.y() > x.y()) != (b.y() > x.y())
     && x.x() < a.x() + (x.y() - a.y())/(b.y() - a.y())*(b.x() - a.x());
}


// Van Oosterom, A. & Strackee, J. (1983). The solid angle of a plane triangle.
// IEEE Trans. Biomed. Eng. 30, 125-126. doi:10.1109/TBME.1983.325207
double solidAngle(const std::array<Vector<3>, 3>& t, const Vector<3>& x)
{
    const Vector<3> a(t[0] - x), b(t[1] - x), c(t[2] - x);
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2*std::atan2
    (
        a.dot(b.cross(c)),
        la*lb*lc + a.dot(b)*lc + b.dot(c)*la + c.dot(a)*lb
    );
}

}


template<int D>
Foam::closedOutline<D>::closedOutline(const wallPieceList<D>& pieces)
{
    for (const wallPiece<D>& piece : pieces)
    {
        const nscd::Vectors<D> x(wallPieces::corners(piece));
        if constexpr (D == 2)
        {
            pieces_.push_back({x[0], x[1]});
        }
        else
        {
            for (std::size_t k = 1; k + 1 < x.size(); ++k)
            {
                pieces_.push_back({x[0], x[k], x[k + 1]});
            }
        }
    }
}


template<>
bool Foam::closedOutline<2>::isWithin(const nscd::Vector<2>& x) const
{
    return std::count_if
    (
        pieces_.begin(), pieces_.end(),
        [&](const auto& s) { return crosses(s, x); }
    ) % 2;
}


template<>
bool Foam::closedOutline<3>::isWithin(const nscd::Vector<3>& x) const
{
    double sum = 0;
    for (const auto& t : pieces_)
    {
        sum += solidAngle(t, x);
    }
    return std::abs(sum) > constant::mathematical::twoPi;
}


template<int D>
Foam::scalar Foam::closedOutline<D>::distance(const nscd::Vector<D>& x) const
{
    scalar least = GREAT;
    for (const auto& piece : pieces_)
    {
        least = min(least, distanceTo(piece, x));
    }
    return least;
}


template class Foam::closedOutline<2>;
template class Foam::closedOutline<3>;
