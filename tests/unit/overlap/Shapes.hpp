// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/disc/DiscPolygon.hpp"

#include <cmath>
#include <vector>

namespace overlap
{

using Polygon = std::vector<Point2>;

inline Polygon rectangle(double xMin, double yMin, double xMax, double yMax)
{
    return {{xMin, yMin}, {xMax, yMin}, {xMax, yMax}, {xMin, yMax}};
}

inline Point2 rotated(const Point2& p, double angle)
{
    return {std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

inline AreaMoment discPolygon(const Point2& centre, double radius, const Polygon& cell)
{
    return discPolygon(centre, radius, cell.data(), cell.size());
}

inline AreaMoment unitDisc(const Polygon& cell)
{
    return discPolygon({0, 0}, 1, cell);
}

inline AreaMoment polygon(const Polygon& cell)
{
    return polygon(cell.data(), cell.size());
}

/// Area of the part of the unit disc with x > h, |h| <= 1.
inline double segmentArea(double h)
{
    const double halfChord = std::sqrt((1 - h) * (1 + h));
    return std::atan2(halfChord, h) - h * halfChord;
}

}  // namespace overlap
