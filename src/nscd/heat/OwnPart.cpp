// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/heat/OwnPart.hpp"

#include "nscd/base/Pi.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace nscd
{

namespace
{

/// Sine of the angle below which planes are parallel.
constexpr double parallel = 1e-8;

/// The line in which another plane cuts off a plane.
template <int D>
struct Cut
{
    Vector<D> outward;   ///< in the plane, of unit length
    double distance;     ///< of the line from the foot, negative if that is cut off, too [m]
};

template <int D>
struct Direction
{
    Vector<D> way;
    double weight;
};

/// Directions in the plane of a normal, half of them along 'axis'.
std::vector<Direction<2>> directions(const Vector<2>&, const Vector<2>& axis, double)
{
    return {{axis, 0.5}, {-axis, 0.5}};
}

/// They crowd along a line across the axis at 'part' of the rim's distance, as asinh of where they meet it; the last
/// ones meet it far outside the rim.
std::vector<Direction<3>> directions(const Vector<3>& normal, const Vector<3>& axis, double part)
{
    constexpr int n = 34;
    const double end = std::asinh(4 / std::max(std::min(std::abs(part), 1.0), 1e-4));
    std::vector<Direction<3>> result;
    for (int i = 0; i < n; ++i)
    {
        const auto angle = [&](int k)
        { return k == 0 || k == n ? (k - n / 2) * pi / n : std::atan(std::sinh(end * (2.0 * (k - 1) / (n - 2) - 1))); };
        const double from = angle(i), to = angle(i + 1), middle = 0.5 * (from + to), weight = (to - from) / (2 * pi);
        const Vector<3> along = std::cos(middle) * axis, across = std::sin(middle) * normal.cross(axis);
        result.push_back({along + across, weight});
        result.push_back({across - along, weight});
    }
    return result;
}

}  // namespace

template <int D>
std::optional<std::vector<Stretch>> ownPart(const std::vector<NearPlane<D>>& planes, std::size_t own, double farthest)
{
    const NearPlane<D>& plane = planes[own];
    const double rim = std::sqrt(std::max(farthest * farthest - plane.distance * plane.distance, 0.0));
    std::vector<Cut<D>> cuts;
    for (const NearPlane<D>& other : planes)
    {
        const double cosine = plane.normal.dot(other.normal);
        const Vector<D> outward = other.normal - cosine * plane.normal;
        const double sine = outward.norm();
        if (sine > parallel)
        {
            const double distance = (other.distance - cosine * plane.distance) / sine;
            if (distance < rim)
            {
                cuts.push_back({outward / sine, distance});
            }
        }
        else if (cosine > 0 && std::tie(other.distance, other.wall) < std::tie(plane.distance, plane.wall))
        {
            return {};
        }
    }
    std::vector<Stretch> stretches;
    if (cuts.empty())
    {
        return stretches;
    }
    const Cut<D>& nearest = *std::min_element(cuts.begin(), cuts.end(), [](const Cut<D>& a, const Cut<D>& b)
                                              { return a.distance < b.distance; });
    for (const Direction<D>& direction : directions(plane.normal, nearest.outward, nearest.distance / rim))
    {
        Stretch stretch{direction.weight};
        for (const Cut<D>& cut : cuts)
        {
            const double outward = direction.way.dot(cut.outward);
            if (outward > 0)
            {
                stretch.to = std::min(stretch.to, cut.distance / outward);
            }
            else if (outward < 0)
            {
                stretch.from = std::max(stretch.from, cut.distance / outward);
            }
        }
        stretches.push_back(stretch);
    }
    const bool any = std::any_of(stretches.begin(), stretches.end(), [&](const Stretch& s)
                                 { return s.from < std::min(s.to, rim); });
    return any ? std::optional(stretches) : std::nullopt;
}

template std::optional<std::vector<Stretch>> ownPart<2>(const std::vector<NearPlane<2>>&, std::size_t, double);
template std::optional<std::vector<Stretch>> ownPart<3>(const std::vector<NearPlane<3>>&, std::size_t, double);

}  // namespace nscd
