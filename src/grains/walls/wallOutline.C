/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallOutline.H"

#include "grainWalls.H"
#include "nscd/walls/WallMotion.hpp"

namespace
{

nscd::Vectors<2> corners(const nscd::Segment& s, const Foam::grainSpace<2>&)
{
    return {s.a, s.b};
}

nscd::Vectors<3> corners
(
    const nscd::WallOf<3>::type& wall,
    const Foam::grainSpace<3>& space
)
{
    if (const auto* t = std::get_if<nscd::Triangle>(&wall))
    {
        return {t->a, t->b, t->c};
    }
    const nscd::Plane& plane = std::get<nscd::Plane>(wall);
    const Eigen::AlignedBox3d domain(space.globalDomain());
    const nscd::Vector<3> middle
    (
        domain.center()
      - plane.normal.dot(domain.center() - plane.point)*plane.normal
    );
    const nscd::Vector<3> s
    (
        0.5*domain.diagonal().norm()*plane.normal.unitOrthogonal()
    );
    const nscd::Vector<3> t(plane.normal.cross(s));
    return {middle - s - t, middle + s - t, middle + s + t, middle - s + t};
}

}


template<int D>
std::vector<Foam::wallOutline> Foam::wallOutlines
(
    const grainWalls<D>& walls,
    const std::vector<nscd::WallBody<D>>& now,
    const grainSpace<D>& space
)
{
    const auto motions = nscd::rigidMotions<D>(walls.bodies(), now);

    std::vector<wallOutline> result;
    for (const auto& wall : walls.walls())
    {
        wallOutline outline;
        outline.body = nscd::bodyOf(wall);
        for (nscd::Vector<D> x : corners(wall, space))
        {
            if (outline.body >= 0)
            {
                x = motions[outline.body](x);
            }
            outline.points.append(space.positionInSpace(x));
        }
        result.push_back(outline);
    }
    return result;
}


template std::vector<Foam::wallOutline> Foam::wallOutlines<2>
(
    const grainWalls<2>&,
    const std::vector<nscd::WallBody<2>>&,
    const grainSpace<2>&
);
template std::vector<Foam::wallOutline> Foam::wallOutlines<3>
(
    const grainWalls<3>&,
    const std::vector<nscd::WallBody<3>>&,
    const grainSpace<3>&
);
