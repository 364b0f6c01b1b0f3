// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/base/Check.hpp"
#include "nscd/dynamics/Validation.hpp"

namespace nscd
{

namespace
{

std::string nameOf(std::size_t wall)
{
    return "wall " + std::to_string(wall);
}

void checkShape(const Segment& wall, double, const std::string& name)
{
    if (!isFinite(wall.a) || !isFinite(wall.b))
    {
        refuse(name, ": an end point is not finite");
    }
    if ((wall.b - wall.a).norm() == 0)
    {
        refuse(name, ": its two end points coincide at (", wall.a.x(), ", ", wall.a.y(), ")");
    }
}

void checkShape(const Plane& wall, const std::string& name)
{
    if (!isFinite(wall.point) || !isFinite(wall.normal))
    {
        refuse(name, ": point or normal is not finite");
    }
    if (std::abs(wall.normal.norm() - 1) > 1e-9)
    {
        refuse(name, ": its normal has length ", wall.normal.norm(), " instead of 1");
    }
}

void checkShape(const Triangle& wall, double extent, const std::string& name)
{
    const Vector<3> ab = wall.b - wall.a;
    const Vector<3> ac = wall.c - wall.a;
    const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    if (longest == 0)
    {
        refuse(name, ": the three corners of the triangle coincide at (", wall.a.transpose(), ")");
    }
    const double height = ab.cross(ac).norm() / longest;
    if (height <= 1e-9 * extent)
    {
        refuse(name, ": the triangle has no area: it is ", longest, " m long and ", height,
               " m high, in a surface that extends over ", extent, " m");
    }
}

void checkShape(const std::variant<Plane, Triangle>& wall, double extent, const std::string& name)
{
    if (const auto* plane = std::get_if<Plane>(&wall))
    {
        checkShape(*plane, name);
    }
    else
    {
        checkShape(std::get<Triangle>(wall), extent, name);
    }
}

/// Largest extent of all triangles along an axis [m]; 0 without triangles.
double largestExtent(const Walls<3>& walls)
{
    Vector<3> lower, upper;
    bool any = false;
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
        const auto* triangle = std::get_if<Triangle>(&walls[w]);
        if (!triangle)
        {
            continue;
        }
        for (const Vector<3>& corner : {triangle->a, triangle->b, triangle->c})
        {
            if (!isFinite(corner))
            {
                refuse(nameOf(w), ": a corner of the triangle is not finite");
            }
            lower = any ? lower.cwiseMin(corner).eval() : corner;
            upper = any ? upper.cwiseMax(corner).eval() : corner;
            any = true;
        }
    }
    return any ? (upper - lower).maxCoeff() : 0;
}

double largestExtent(const Walls<2>&)
{
    return 0;
}

bool isPlane(const Segment&)
{
    return false;
}

bool isPlane(const std::variant<Plane, Triangle>& wall)
{
    return std::holds_alternative<Plane>(wall);
}

bool isRotation(const Eigen::Rotation2Dd& orientation)
{
    return std::isfinite(orientation.angle());
}

bool isRotation(const Eigen::Quaterniond& orientation)
{
    return isFinite(orientation.coeffs()) && std::abs(orientation.norm() - 1) < 1e-9;
}

template <int D>
void checkBody(const WallBody<D>& body, const std::string& name)
{
    const auto check = [&name](bool good, const char* what)
    {
        if (!good)
        {
            refuse(name, ": ", what);
        }
    };
    check(isFinite(body.position), "position is not finite");
    check(isFinite(body.velocity), "velocity is not finite");
    check(isFinite(body.spin), "spin is not finite");
    check(isFinite(body.force), "force is not finite");
    check(isFinite(body.torque), "torque is not finite");
    check(!std::isnan(body.mass) && body.mass > 0, "mass is not positive");
    for (int d = 0; d < body.inertia.size(); ++d)
    {
        check(!std::isnan(body.inertia[d]) && body.inertia[d] > 0, "a moment of inertia is not positive");
    }
    check(isRotation(body.orientation), "orientation is not a rotation");
}

}  // namespace

template <int D>
void checkSpin(const Walls<D>& walls, int body, const Spin<D>& spin)
{
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
        if (bodyOf(walls[w]) == body && isPlane(walls[w]) && !spin.isZero(0))
        {
            refuse(nameOf(w), ": a plane cannot turn with its body ", body, "; make it of triangles");
        }
    }
}

template <int D>
void validate(const Walls<D>& walls, const ContactTable& table, const std::vector<WallBody<D>>& bodies)
{
    const double extent = largestExtent(walls);
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
        const std::string name = nameOf(w);
        checkShape(walls[w], extent, name);
        checkMaterial(materialOf(walls[w]), table, name);
        const int body = bodyOf(walls[w]);
        if (body < -1 || body >= static_cast<int>(bodies.size()))
        {
            refuse(name, ": body ", body, " is neither -1 (fixed) nor one of the ", bodies.size(), " wall bodies");
        }
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        checkBody(bodies[b], "wall body " + std::to_string(b));
        const bool mayTurn = (bodies[b].inertia.array() < std::numeric_limits<double>::infinity()).any();
        checkSpin<D>(walls, static_cast<int>(b), mayTurn ? Spin<D>::Ones() : bodies[b].spin);
    }
}

template void checkSpin<2>(const Walls<2>&, int, const Spin<2>&);
template void checkSpin<3>(const Walls<3>&, int, const Spin<3>&);
template void validate<2>(const Walls<2>&, const ContactTable&, const std::vector<WallBody<2>>&);
template void validate<3>(const Walls<3>&, const ContactTable&, const std::vector<WallBody<3>>&);

}  // namespace nscd
