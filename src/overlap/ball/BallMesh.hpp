// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/ball/BallFace.hpp"
#include "overlap/ball/BallOverlap.hpp"
#include "overlap/clip/PowerCell.hpp"
#include "overlap/mesh/PolyhedralMesh.hpp"

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
    ///
    /// The cell `hint` is tried first: if the whole ball is behind all planes of its faces, as in a large cell before
    /// the ball moved a little, nothing is searched.
    const std::vector<CellOverlap>& overlaps(const Point3& centre, double radius, int hint = -1);

    /// The same for what is left of the ball in half-spaces: with those of powerCell, for a member of a cluster, such
    /// that nothing is counted twice where members overlap.  The wetted surface is what they do not cut off.
    const std::vector<CellOverlap>& overlaps(const Point3& centre, double radius,
                                             const std::vector<HalfSpace<3>>& halfSpaces);

    /// Area of a face within the ball of the last call [m^2], half-spaces or not.
    double faceArea(int face);

private:
    /// Of a face that this ball has asked for, if its number is the ball's.
    struct Face
    {
        std::uint32_t ball = 0;
        std::int32_t parts = -1;  ///< place in parts_, -1 as long as nobody has asked for them
        std::pair<double, double> heights;
    };

    /// What CellSum asks for.
    struct Source
    {
        BallMesh& owner;
        const std::pair<double, double>& heights(std::size_t face) { return owner.face(face).heights; }
        const FaceParts& parts(std::size_t face) { return owner.parts(face); }
    };

    Face& face(std::size_t i);
    const FaceParts& parts(std::size_t i);
    bool holdsBall(int cell);
    void useOuterForm();
    void cut(CellOverlap& part, const std::vector<HalfSpace<3>>& halfSpaces) const;
    void removeEmpty();

    const PolyhedralMesh& mesh_;
    UnitBall ball_{Point3::Zero(), 1, 1};
    std::vector<CellOverlap> overlaps_;

    std::vector<Face> faces_;       ///< of the mesh
    std::vector<FaceParts> parts_;  ///< that this ball has asked for
    std::uint32_t ballNumber_ = 0;
};

}  // namespace overlap
