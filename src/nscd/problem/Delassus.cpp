// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/problem/Delassus.hpp"

#include "nscd/base/Check.hpp"

namespace nscd
{

namespace
{

/// A body's linear and angular motion along the directions of a contact's frame.
template <int D>
struct Side
{
    int contact;
    Block<D> linear;                                               ///< frame, with the sign of the body
    Eigen::Matrix<double, D, Spin<D>::RowsAtCompileTime> angular;  ///< frame^T (spin -> velocity at the contact point)
};

/// Velocity at the end of the arm per spin.
Eigen::Matrix<double, 2, 1> lever(const Vector<2>& arm)
{
    return {-arm.y(), arm.x()};
}

Eigen::Matrix<double, 3, 3> lever(const Vector<3>& arm)
{
    Eigen::Matrix<double, 3, 3> m;
    m << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    return m;
}

/// Only the second body, whose sign is positive, is an image.
template <int D>
Vector<D> shiftOf(const ContactPoint<D>& c, double sign)
{
    return sign > 0 ? c.shift : Vector<D>::Zero();
}

template <int D>
Side<D> side(const RigidBody<D>& body, const Vector<D>& shift, const ContactPoint<D>& c, int contact, double sign)
{
    const Block<D> directions = sign * contactFrame(c.normal).transpose();
    return {contact, directions, directions * lever(Vector<D>(c.point - body.position - shift))};
}

}  // namespace

template <int D>
SparseProblem<D> delassus(const std::vector<RigidBody<D>>& bodies, const std::vector<ContactPoint<D>>& contacts)
{
    std::vector<std::vector<Side<D>>> sides(bodies.size());
    Vectors<D> q;
    std::vector<double> friction;
    for (std::size_t k = 0; k < contacts.size(); ++k)
    {
        const ContactPoint<D>& c = contacts[k];
        const int count = static_cast<int>(bodies.size());
        if (c.first < 0 || c.second < 0 || c.first >= count || c.second >= count || c.first == c.second)
        {
            refuse("contact ", k, " is between bodies ", c.first, " and ", c.second, " of ", count);
        }
        q.push_back(c.approach * Vector<D>::Unit(0));
        friction.push_back(c.friction);
        for (const auto& [b, sign] : {std::pair(c.first, -1.0), std::pair(c.second, 1.0)})
        {
            const Side<D> s = side<D>(bodies[b], shiftOf(c, sign), c, static_cast<int>(k), sign);
            q.back() += s.linear * bodies[b].velocity + s.angular * bodies[b].spin;
            sides[b].push_back(s);
        }
    }

    std::vector<typename SparseProblem<D>::Entry> entries;
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        if (bodies[b].inverseMass == 0 && bodies[b].inverseInertia.isZero(0))
        {
            continue;
        }
        for (const Side<D>& row : sides[b])
        {
            for (const Side<D>& column : sides[b])
            {
                const Block<D> W = bodies[b].inverseMass * row.linear * column.linear.transpose()
                                   + row.angular * bodies[b].inverseInertia * column.angular.transpose();
                for (int i = 0; i < D; ++i)
                {
                    for (int j = 0; j < D; ++j)
                    {
                        entries.push_back({D * row.contact + i, D * column.contact + j, W(i, j)});
                    }
                }
            }
        }
    }
    return {std::move(q), std::move(friction), entries};
}

template <int D>
std::vector<RigidBody<D>> withImpulses(std::vector<RigidBody<D>> bodies, const std::vector<ContactPoint<D>>& contacts,
                                       const Vectors<D>& r)
{
    for (std::size_t k = 0; k < contacts.size(); ++k)
    {
        const ContactPoint<D>& c = contacts[k];
        for (const auto& [b, sign] : {std::pair(c.first, -1.0), std::pair(c.second, 1.0)})
        {
            RigidBody<D>& body = bodies[b];
            const Side<D> s = side<D>(body, shiftOf(c, sign), c, static_cast<int>(k), sign);
            body.velocity += body.inverseMass * s.linear.transpose() * r[k];
            body.spin += body.inverseInertia * s.angular.transpose() * r[k];
        }
    }
    return bodies;
}

template SparseProblem<2> delassus<2>(const std::vector<RigidBody<2>>&, const std::vector<ContactPoint<2>>&);
template SparseProblem<3> delassus<3>(const std::vector<RigidBody<3>>&, const std::vector<ContactPoint<3>>&);
template std::vector<RigidBody<2>> withImpulses<2>(std::vector<RigidBody<2>>, const std::vector<ContactPoint<2>>&,
                                                   const Vectors<2>&);
template std::vector<RigidBody<3>> withImpulses<3>(std::vector<RigidBody<3>>, const std::vector<ContactPoint<3>>&,
                                                   const Vectors<3>&);

}  // namespace nscd
