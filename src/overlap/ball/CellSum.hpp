// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/ball/BallFace.hpp"
#include "overlap/ball/BallOverlap.hpp"
#include "overlap/mesh/CellShape.hpp"

#include <algorithm>
#include <cmath>

namespace overlap
{

inline BallOverlap noOverlap(const Point3& centre)
{
    return {0, centre, 0, Point3::Zero()};
}

inline BallOverlap wholeBall(const UnitBall& ball)
{
    const double r = ball.radius;
    return {4 * pi / 3 * r * r * r, ball.centre, 4 * pi * r * r, Point3::Zero()};
}

/// Whether ball and box overlap.
inline bool meets(const Point3& centre, double radius, const Point3& low, const Point3& high)
{
    return (centre.cwiseMax(low).cwiseMin(high) - centre).squaredNorm() < radius * radius;
}

/// Whether all vertices f(0), f(1), ..., f(n - 1) of a cell are in the ball, and with them the cell.
template <class Vertex>
bool covers(const Point3& centre, double radius, const CellShape& shape, std::size_t n, Vertex&& f)
{
    if ((shape.high - shape.low).maxCoeff() > 2 * radius) return false;
    for (std::size_t k = 0; k < n; ++k)
    {
        if ((f(k) - centre).squaredNorm() > radius * radius) return false;
    }
    return true;
}

/// The ball's part in a cell that it does not cover, from the contributions of the cell's faces.
///
/// Source offers heights(face): lowest and highest height of the face's planes, and parts(face): FaceParts, computed
/// here or kept from the cell on the face's other side.
template <class Source>
class CellSum
{
public:
    CellSum(const UnitBall& ball, const CellView& cell, Source& source) : ball_(ball), cell_(cell), source_(source) {}

    /// inner: from what is within the ball unless the centre is near a face; outer: from what is outside.
    enum class Form
    {
        inner,
        outer
    };

    BallOverlap overlap(Form form = Form::inner)
    {
        const BallOverlap none = noOverlap(ball_.centre);
        if (separated()) return none;

        addParts();
        if (!reached_)
        {
            holdsBall_ = holdsCentre();
            return holdsBall_ ? wholeBall(ball_) : none;
        }

        if (near_ || form == Form::outer)
        {
            addOuterParts();
        }
        else
        {
            takeInnerParts();
        }
        if (volume_ < 1e-3 && !near_ && !resolved_) resolve();
        return volume_ > 0 ? scaled() : none;
    }

    /// Whether overlap() has found the centre near a face of the cell.
    bool isNear() const { return near_; }

    /// Whether overlap() has found the whole ball in the cell.
    bool holdsBall() const { return holdsBall_; }

private:
    double cellVolume() const { return cell_.shape.volume * ball_.scale * ball_.scale * ball_.scale; }

    /// How far the cell reaches in front of the planes of its own facets.
    double dent() const { return cell_.shape.dent * ball_.scale; }

    /// A plane of the cell has the ball in front of it, and of all that is of the cell there.
    bool separated()
    {
        for (std::size_t i = 0; i < cell_.nFaces; ++i)
        {
            const auto [low, high] = source_.heights(cell_.faces[i].face);
            inward_ = std::min(inward_, cell_.faces[i].sign > 0 ? low : -high);
            if (inward_ <= -1 - dent()) return true;
        }
        return false;
    }

    void addParts()
    {
        for (std::size_t i = 0; i < cell_.nFaces; ++i)
        {
            const auto [low, high] = source_.heights(cell_.faces[i].face);
            if (low < 1 && high > -1) add(cell_.faces[i].sign, source_.parts(cell_.faces[i].face));
        }
    }

    void add(double sign, const FaceParts& parts)
    {
        if (!parts.reached) return;
        reached_ = true;
        near_ = near_ || parts.near;
        resolved_ = resolved_ && parts.resolved;
        sum_.volume += sign * parts.volume;
        sum_.patch += sign * parts.patch;
        sum_.areaVector += sign * parts.areaVector;
        sum_.moment += sign * parts.moment;
    }

    /// Valid where the centre is not near the cell's boundary.
    bool holdsCentre() const
    {
        if (cell_.shape.convex()) return inward_ > 0;

        // What is behind all planes is in the cell, convex or not; beyond the dents nothing is
        constexpr double rounding = 1e-9;
        if (inward_ > rounding) return true;
        if (inward_ < -dent() - rounding) return false;
        if ((ball_.centre.array() < cell_.shape.low.array()).any()
            || (ball_.centre.array() > cell_.shape.high.array()).any())
        {
            return false;
        }
        double sum = 0;
        for (std::size_t i = 0; i < cell_.nFaces; ++i)
            sum += cell_.faces[i].sign * solidAngle(ball_, cell_.facets, cell_.faces[i].face);
        return sum > 2 * pi;
    }

    void addOuterParts()
    {
        for (std::size_t i = 0; i < cell_.nFaces; ++i)
        {
            const OuterParts parts = outerParts(ball_, cell_.facets, cell_.faces[i].face);
            volume_ += cell_.faces[i].sign * parts.volume;
            patch_ += cell_.faces[i].sign * parts.patch;
        }
    }

    void takeInnerParts()
    {
        const double turns = holdsCentre() ? 1 : 0;
        volume_ = 4 * pi / 3 * turns - sum_.volume;
        patch_ = 4 * pi * turns - sum_.patch;
    }

    void resolve()
    {
        sum_ = FaceParts();
        for (std::size_t i = 0; i < cell_.nFaces; ++i)
        {
            const auto [low, high] = source_.heights(cell_.faces[i].face);
            if (low < 1 && high > -1) add(cell_.faces[i].sign, resolvedParts(ball_, cell_.facets, cell_.faces[i].face));
        }
        takeInnerParts();
    }

    BallOverlap scaled() const
    {
        const double r = ball_.radius, volume = std::min({volume_, 4 * pi / 3, cellVolume()});
        BallOverlap result;
        result.volume = volume * r * r * r;
        result.wettedArea = std::clamp(patch_, 0.0, 4 * pi) * r * r;
        result.wettedVector = -r * r * sum_.areaVector;

        // The centroid of a sliver is noise in the last digits of the volume: keep it within ball and cell
        for (int d = 0; d < 3; ++d)
        {
            const double arm = std::clamp(sum_.moment[d], -volume, volume) / volume;
            result.centroid[d] = std::clamp(ball_.centre[d] + r * arm, cell_.shape.low[d], cell_.shape.high[d]);
        }
        return result;
    }

    const UnitBall& ball_;
    CellView cell_;
    Source& source_;

    double inward_ = 1e300, volume_ = 0, patch_ = 0;
    bool reached_ = false, near_ = false, resolved_ = true, holdsBall_ = false;
    FaceParts sum_;
};

}  // namespace overlap
