// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/BallFace.hpp"
#include "overlap/BallOverlap.hpp"
#include "overlap/PolyhedralMesh.hpp"

#include <vector>

namespace overlap
{

/// The part of a ball in a cell of a mesh.
struct CellOverlap : BallOverlap
{
    int cell;
    bool covered;  ///< the cell is within the ball
};

/// Exact intersections of balls with the cells of a mesh, one ball after the other.
///
/// What a face contributes is computed once and counted with opposite signs for the cells on its sides, so that the
/// volumes of a ball add up to its volume inside the mesh, to 1e-14, and the first moments to zero for a ball wholly
/// inside.  The ball may be much smaller or larger than the cells, and partly or wholly outside the mesh.
///
/// Holds the working space for one ball: use one for each thread.  The mesh must outlive it and may move between two
/// calls.
class BallMesh
{
public:
    explicit BallMesh(const PolyhedralMesh& mesh);

    /// The cells that the ball of the given centre and radius > 0 [m] overlaps, each once, in an order that depends on
    /// the mesh alone.  Valid until the next call.  Throws std::invalid_argument if the radius is not positive or a
    /// number is not finite.
    const std::vector<CellOverlap>& overlaps(const Point3& centre, double radius);

    /// Area of a face within the ball of the last call [m^2].
    double faceArea(int face);

private:
    struct Face
    {
        std::pair<double, double> heights;
        bool hasParts;
        FaceParts parts;
    };

    /// What CellSum asks for.
    struct Source
    {
        BallMesh& owner;
        const std::pair<double, double>& heights(std::size_t face) { return owner.find(face).heights; }
        const FaceParts& parts(std::size_t face) { return owner.parts(face); }
    };

    Face& find(std::size_t face);
    const FaceParts& parts(std::size_t face);
    void useOuterForm();

    const PolyhedralMesh& mesh_;
    UnitBall ball_{Point3::Zero(), 1, 1};
    std::vector<CellOverlap> overlaps_;

    std::vector<Face> faces_;            ///< those that this ball has asked for
    std::vector<std::uint32_t> place_;   ///< of a face among them
    std::vector<std::uint32_t> ballOf_;  ///< number of the ball that place_ is for
    std::uint32_t ballNumber_ = 0;
};

}  // namespace overlap
