// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/problem/SparseProblem.hpp"

#include "nscd/base/Check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nscd
{

namespace
{

/// Stands for the sum of q_N^2 where that vanishes [m^2/s^2].
constexpr double smallestSquare = 1e-280;

}  // namespace

template <int D>
SparseProblem<D>::SparseProblem(Vectors<D> q, std::vector<double> friction, const std::vector<Entry>& entries)
    : q_(std::move(q)), friction_(std::move(friction))
{
    check(entries);
    assemble(entries);
    for (int c = 0; c < contacts(); ++c)
    {
        const bool positive = diagonal_[c] < rows_[c + 1] && blocks_[diagonal_[c]].contact == c && own(c)(0, 0) > 0;
        if (!positive)
        {
            refuse("contact ", c, ": W_NN is not positive");
        }
    }
}

template <int D>
void SparseProblem<D>::check(const std::vector<Entry>& entries) const
{
    if (friction_.size() != q_.size())
    {
        refuse(friction_.size(), " coefficients of friction for ", q_.size(), " contacts");
    }
    for (int c = 0; c < contacts(); ++c)
    {
        if (!std::isfinite(friction_[c]) || friction_[c] < 0)
        {
            refuse("contact ", c, ": the coefficient of friction ", friction_[c], " is not 0 or more");
        }
        if (!isFinite(q_[c]))
        {
            refuse("contact ", c, ": q is not finite");
        }
    }
    const int size = D * contacts();
    for (const Entry& e : entries)
    {
        if (e.row < 0 || e.row >= size || e.column < 0 || e.column >= size)
        {
            refuse("an entry in row ", e.row, " and column ", e.column, " of W, which is ", size, " x ", size);
        }
        if (!std::isfinite(e.value))
        {
            refuse("contact ", e.row / D, ": W is not finite");
        }
    }
}

template <int D>
void SparseProblem<D>::assemble(const std::vector<Entry>& entries)
{
    std::vector<std::size_t> first(q_.size() + 1, 0);
    for (const Entry& e : entries)
    {
        ++first[e.row / D + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Entry> sorted(entries.size());
    {
        std::vector<std::size_t> next = first;
        for (const Entry& e : entries)
        {
            sorted[next[e.row / D]++] = e;
        }
    }
    rows_.push_back(0);
    for (int c = 0; c < contacts(); ++c)
    {
        const auto begin = sorted.begin() + first[c];
        const auto end = sorted.begin() + first[c + 1];
        std::stable_sort(begin, end, [](const Entry& a, const Entry& b) { return a.column / D < b.column / D; });
        for (auto e = begin; e != end; ++e)
        {
            if (blocks_.size() == rows_[c] || blocks_.back().contact != e->column / D)
            {
                blocks_.push_back({e->column / D, Block<D>::Zero()});
            }
            blocks_.back().W(e->row % D, e->column % D) += e->value;
        }
        const auto own = std::lower_bound(blocks_.begin() + rows_[c], blocks_.end(), c,
                                          [](const Neighbour& n, int contact) { return n.contact < contact; });
        diagonal_.push_back(own - blocks_.begin());
        rows_.push_back(blocks_.size());
    }
}

template <int D>
Vectors<D> SparseProblem<D>::velocities(const Vectors<D>& r) const
{
    Vectors<D> u(q_.size());
    for (int c = 0; c < contacts(); ++c)
    {
        u[c] = velocity(c, r);
    }
    return u;
}

template <int D>
Vector<D> naturalMap(double wNN, double mu, const Vector<D>& r, const Vector<D>& u)
{
    const Vector<D> x = wNN * r;
    Vector<D> y = x - u;
    y[0] -= mu * u.template tail<D - 1>().norm();
    const double tangential = y.template tail<D - 1>().norm();
    if (tangential <= mu * y[0])
    {
        return x - y;
    }
    const double normal = (y[0] + mu * tangential) / (1 + mu * mu);
    if (normal <= 0)
    {
        return x;
    }
    y[0] = normal;
    y.template tail<D - 1>() *= mu * normal / tangential;
    return x - y;
}

template <int D>
Residual residual(const SparseProblem<D>& problem, const Vectors<D>& r)
{
    Residual result;
    double sum = 0, reference = 0, largest = 0;
    for (int c = 0; c < problem.contacts(); ++c)
    {
        const Vector<D> u = problem.velocity(c, r);
        const double square = naturalMap<D>(problem.own(c)(0, 0), problem.friction()[c], r[c], u).squaredNorm();
        sum += square;
        largest = std::max(largest, square);
        reference += problem.q()[c][0] * problem.q()[c][0];
        result.penetration = std::max(result.penetration, -u[0]);
    }
    result.worst = std::sqrt(largest);
    result.relative = std::sqrt(sum) / std::sqrt(std::max(reference, smallestSquare));
    return result;
}

template class SparseProblem<2>;
template class SparseProblem<3>;
template Vector<2> naturalMap<2>(double, double, const Vector<2>&, const Vector<2>&);
template Vector<3> naturalMap<3>(double, double, const Vector<3>&, const Vector<3>&);
template Residual residual<2>(const SparseProblem<2>&, const Vectors<2>&);
template Residual residual<3>(const SparseProblem<3>&, const Vectors<3>&);

}  // namespace nscd
