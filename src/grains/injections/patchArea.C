/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchArea.H"

#include "cyclicPolyPatch.H"
#include "ListListOps.H"
#include "Pstream.H"

#include <algorithm>
#include <map>
#include <numeric>

namespace
{

using namespace Foam;

bool isBefore(const point& a, const point& b)
{
    return
        std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

}


template<int D>
Foam::patchArea<D>::patchArea
(
    const grainSpace<D>& space,
    const labelList& patches
)
:
    space_(space),
    area_(Zero)
{
    const faces all(gathered(patches));
    for (const pointField& face : all.points)
    {
        addTriangles(face);
    }
    findRim(all);
}


template<int D>
typename Foam::patchArea<D>::faces Foam::patchArea<D>::gathered
(
    const labelList& patches
) const
{
    const polyBoundaryMesh& boundary = space_.mesh().boundaryMesh();

    boolList isCyclic(space_.mesh().nPoints(), false);
    for (const polyPatch& patch : boundary)
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            UIndirectList<bool>(isCyclic, patch.meshPoints()) = true;
        }
    }

    List<List<pointField>> points(Pstream::nProcs());
    List<List<boolList>> cyclic(Pstream::nProcs());
    for (const label patchi : patches)
    {
        for (const face& f : boundary[patchi])
        {
            points[Pstream::myProcNo()].append(f.points(space_.mesh().points()));
            boolList edges(f.size());
            forAll(f, i)
            {
                edges[i] = isCyclic[f[i]] && isCyclic[f.nextLabel(i)];
            }
            cyclic[Pstream::myProcNo()].append(edges);
        }
    }
    Pstream::gatherList(points);
    Pstream::scatterList(points);
    Pstream::gatherList(cyclic);
    Pstream::scatterList(cyclic);

    faces all
    {
        ListListOps::combine<List<pointField>>(points, accessOp<List<pointField>>()),
        ListListOps::combine<List<boolList>>(cyclic, accessOp<List<boolList>>())
    };
    labelList order(all.points.size());
    std::iota(order.begin(), order.end(), 0);
    pointField centres(order.size());
    forAll(centres, i)
    {
        centres[i] = average(all.points[i]);
    }
    std::sort
    (
        order.begin(), order.end(),
        [&](label a, label b) { return isBefore(centres[a], centres[b]); }
    );
    return
    {
        List<pointField>(UIndirectList<pointField>(all.points, order)),
        List<boolList>(UIndirectList<boolList>(all.isCyclic, order))
    };
}


template<int D>
void Foam::patchArea<D>::addTriangles(const pointField& face)
{
    for (label i = 1; i + 1 < face.size(); ++i)
    {
        const vector area
        (
            0.5*((face[i] - face[0]) ^ (face[i + 1] - face[0]))
        );
        area_ += area;
        triangles_.append(FixedList<point, 3>({face[0], face[i], face[i + 1]}));
        areas_.push_back(mag(area) + (areas_.empty() ? 0 : areas_.back()));
    }
}


template<int D>
void Foam::patchArea<D>::findRim(const faces& all)
{
    typedef std::pair<point, point> edge;
    const auto isLess = [](const edge& a, const edge& b)
    {
        return
            isBefore(a.first, b.first)
         || (!isBefore(b.first, a.first) && isBefore(a.second, b.second));
    };
    std::map<edge, label, decltype(isLess)> number(isLess);
    forAll(all.points, facei)
    {
        const pointField& face = all.points[facei];
        forAll(face, i)
        {
            edge e(face[i], face[face.fcIndex(i)]);
            if (isBefore(e.second, e.first))
            {
                std::swap(e.first, e.second);
            }
            number[e] += all.isCyclic[facei][i] ? 2 : 1;
        }
    }
    for (const auto& one : number)
    {
        const nscd::Vector<D> a(space_.fromSpace(one.first.first));
        const nscd::Vector<D> b(space_.fromSpace(one.first.second));
        const scalar length = mag(one.first.first - one.first.second);

        // In a plane, edges that cross it
        if (one.second == 1 && (D == 3 || (a - b).norm() < 1e-6*length))
        {
            rim_.push_back({a, b});
        }
    }
}


template<int D>
Foam::vector Foam::patchArea<D>::normal() const
{
    // The order of the sum does not matter to it
    constexpr scalar digits = 1e12;
    vector n(-area_/max(mag(area_), VSMALL));
    for (scalar& x : n)
    {
        x = std::round(digits*x)/digits + 0.0;
    }
    return n/max(mag(n), VSMALL);
}


template<int D>
bool Foam::patchArea<D>::isPlane() const
{
    return !areas_.empty() && mag(area_) > (1 - 1e-6)*areas_.back();
}


template<int D>
nscd::Vector<D> Foam::patchArea<D>::randomPoint
(
    nscd::Random& random
) const
{
    const double a = random.uniform(0, areas_.back());
    const label i = min
    (
        label(std::upper_bound(areas_.begin(), areas_.end(), a) - areas_.begin()),
        triangles_.size() - 1
    );
    double u = random.uniform(0, 1), v = random.uniform(0, 1);
    if (u + v > 1)
    {
        u = 1 - u;
        v = 1 - v;
    }
    const FixedList<point, 3>& t = triangles_[i];
    return space_.fromSpace(t[0] + u*(t[1] - t[0]) + v*(t[2] - t[0]));
}


template<int D>
Foam::scalar Foam::patchArea<D>::distanceFromRim(const nscd::Vector<D>& x) const
{
    scalar nearest = GREAT;
    for (const auto& edge : rim_)
    {
        const nscd::Vector<D> along = edge.second - edge.first;
        const scalar length2 = along.squaredNorm();
        const scalar s =
            length2 > 0
          ? min(max((x - edge.first).dot(along)/length2, 0.0), 1.0)
          : 0;
        nearest = min(nearest, (edge.first + s*along - x).norm());
    }
    return nearest;
}


template<int D>
nscd::Box<D> Foam::patchArea<D>::box() const
{
    Eigen::AlignedBox<double, D> box;
    for (const auto& triangle : triangles_)
    {
        for (const point& x : triangle)
        {
            box.extend(space_.fromSpace(x));
        }
    }
    return {box.min(), box.max()};
}


template<int D>
Foam::scalar Foam::patchArea<D>::halfWidth() const
{
    nscd::Random random(1);
    scalar width = 0;
    for (label i = 0; i < 1000; ++i)
    {
        width = max(width, distanceFromRim(randomPoint(random)));
    }
    return width;
}


template class Foam::patchArea<2>;
template class Foam::patchArea<3>;
