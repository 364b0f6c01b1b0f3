// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/shape/Cluster.hpp"

#include "nscd/base/Check.hpp"
#include "nscd/shape/UnionMoments.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace nscd
{

namespace
{

/// Moments that differ by less, relative to the largest, are those of a symmetric body.
constexpr double sameMoment = 1e-6;

template <int D>
void check(const Vectors<D>& centres, const std::vector<double>& radii)
{
    if (centres.empty())
    {
        refuse("cluster: no members");
    }
    if (centres.size() != radii.size())
    {
        refuse("cluster: ", centres.size(), " centres but ", radii.size(), " radii");
    }
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
        if (!isFinite(centres[i]))
        {
            refuse("cluster: the centre of member ", i, " is not finite");
        }
        if (!isPositive(radii[i]))
        {
            refuse("cluster: radius ", radii[i], " m of member ", i, " is not positive");
        }
    }
}

/// Whether member i lies within another; of equal ones the first stays.
template <int D>
bool isHidden(const Vectors<D>& centres, const std::vector<double>& radii, std::size_t i)
{
    for (std::size_t j = 0; j < centres.size(); ++j)
    {
        const double depth = radii[j] - radii[i] - (centres[j] - centres[i]).norm();
        if (j != i && depth >= 0 && (depth > 0 || radii[j] > radii[i] || j < i))
        {
            return true;
        }
    }
    return false;
}

Orientation<2> principalAxes(const Eigen::Matrix2d& second)
{
    const double difference = second(0, 0) - second(1, 1), product = 2 * second(0, 1);
    if (std::hypot(difference, product) <= sameMoment * second.trace())
    {
        return Orientation<2>::Identity();
    }
    const double angle = std::atan2(product, difference) / 2;  // of the long axis
    const double quarter = std::acos(-1) / 2;
    return Orientation<2>(angle - quarter * std::round(angle / quarter));
}

/// Of all right-handed arrangements of the columns of Q, and their signs, the nearest to the identity.
Eigen::Matrix3d nearestArrangement(const Eigen::Matrix3d& q)
{
    Eigen::Matrix3d best;
    double bestTrace = -4;
    std::array<int, 3> order{0, 1, 2};
    do
    {
        for (int signs = 0; signs < 8; ++signs)
        {
            Eigen::Matrix3d candidate;
            for (int axis = 0; axis < 3; ++axis)
            {
                candidate.col(axis) = (signs >> axis & 1 ? -1 : 1) * q.col(order[axis]);
            }
            if (candidate.determinant() > 0 && candidate.trace() > bestTrace + 1e-12)
            {
                bestTrace = candidate.trace();
                best = candidate;
            }
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

Orientation<3> principalAxes(const Eigen::Matrix3d& second)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second);
    const Vector<3>& moment = solver.eigenvalues();
    const double same = sameMoment * moment[2];
    const bool lowSame = moment[1] - moment[0] <= same, highSame = moment[2] - moment[1] <= same;
    if (lowSame && highSame)
    {
        return Orientation<3>::Identity();
    }
    if (lowSame || highSame)
    {
        // The axis of a body of revolution: the nearest axis of the frame turns there by the shortest way
        const Vector<3> axis = solver.eigenvectors().col(lowSame ? 2 : 0);
        int nearest;
        axis.cwiseAbs().maxCoeff(&nearest);
        return Orientation<3>::FromTwoVectors(Vector<3>::Unit(nearest), axis[nearest] < 0 ? Vector<3>(-axis) : axis);
    }
    return Orientation<3>(nearestArrangement(solver.eigenvectors())).normalized();
}

Spin<2> principalMoments(const Eigen::Matrix2d& second)
{
    return Spin<2>(second.trace());
}

Spin<3> principalMoments(const Eigen::Matrix3d& second)
{
    return Spin<3>::Constant(second.trace()) - second.diagonal();
}

}  // namespace

template <int D>
PlacedCluster<D> placedCluster(const Vectors<D>& centres, const std::vector<double>& radii)
{
    check<D>(centres, radii);
    PlacedCluster<D> placed;
    Cluster<D>& shape = placed.shape;
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
        if (!isHidden<D>(centres, radii, i))
        {
            shape.centre.push_back(centres[i]);
            shape.radius.push_back(radii[i]);
        }
    }

    // Moments about a point among the members, in units of their extent: far from the origin nothing is lost
    const Vector<D> origin = shape.centre.front();
    double extent = 0;
    for (std::size_t i = 0; i < shape.centre.size(); ++i)
    {
        extent = std::max(extent, (shape.centre[i] - origin).norm() + shape.radius[i]);
    }
    const auto rescale = [&shape](const Vector<D>& o, double unit)
    {
        for (std::size_t i = 0; i < shape.centre.size(); ++i)
        {
            shape.centre[i] = (shape.centre[i] - o) / unit;
            shape.radius[i] /= unit;
        }
    };
    rescale(origin, extent);
    const Moments<D> moments = unionMoments<D>(shape.centre, shape.radius);
    const Vector<D> centre = moments.first / moments.volume;
    const Eigen::Matrix<double, D, D> second = moments.second / moments.volume - centre * centre.transpose();

    double size = 0;
    for (std::size_t i = 0; i < shape.centre.size(); ++i)
    {
        size = std::max(size, (shape.centre[i] - centre).norm() + shape.radius[i]);
    }
    rescale(centre, size);
    placed.size = size * extent;
    placed.position = origin + extent * centre;
    placed.orientation = principalAxes(second);

    const Eigen::Matrix<double, D, D> axes = placed.orientation.toRotationMatrix();
    for (Vector<D>& x : shape.centre)
    {
        x = axes.transpose() * x;
    }
    shape.volume = moments.volume / std::pow(size, D);
    shape.inertia = principalMoments(Eigen::Matrix<double, D, D>(axes.transpose() * second * axes / (size * size)));
    return placed;
}

template <int D>
Cluster<D> makeCluster(const Vectors<D>& centres, const std::vector<double>& radii, double* size)
{
    PlacedCluster<D> placed = placedCluster<D>(centres, radii);
    if (size)
    {
        *size = placed.size;
    }
    return placed.shape;
}

template <int D>
Cluster<D> makeRod(int members, double aspectRatio)
{
    if (members < 1)
    {
        refuse("rod: ", members, " members are less than 1");
    }
    if (!std::isfinite(aspectRatio) || aspectRatio < 1 || aspectRatio > members)
    {
        refuse("rod: aspect ratio ", aspectRatio, " is not between 1 and its number of members, ", members);
    }
    Vectors<D> centres;
    for (int i = 0; i < members; ++i)
    {
        const double along = members > 1 ? 2 * (aspectRatio - 1) * i / (members - 1) : 0;
        centres.push_back(along * Vector<D>::Unit(0));
    }
    return makeCluster<D>(centres, std::vector<double>(members, 1));
}

template PlacedCluster<2> placedCluster<2>(const Vectors<2>&, const std::vector<double>&);
template PlacedCluster<3> placedCluster<3>(const Vectors<3>&, const std::vector<double>&);
template Cluster<2> makeCluster<2>(const Vectors<2>&, const std::vector<double>&, double*);
template Cluster<3> makeCluster<3>(const Vectors<3>&, const std::vector<double>&, double*);
template Cluster<2> makeRod<2>(int, double);
template Cluster<3> makeRod<3>(int, double);

}  // namespace nscd
