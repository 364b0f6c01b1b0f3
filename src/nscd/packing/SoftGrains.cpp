// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/packing/SoftGrains.hpp"

#include "nscd/search/Neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nscd
{

template <int D>
SoftGrains<D>::SoftGrains(const Vector<D>& size, const std::array<bool, D>& periodic, std::vector<double> radii,
                          Vectors<D> centres)
    : size_(size), periodic_(periodic), radius_(std::move(radii)), x_(std::move(centres)),
      v_(x_.size(), Vector<D>::Zero()), force_(x_.size())
{
    double smallest = radius_.front(), mean = 0;
    for (const double r : radius_)
    {
        smallest = std::min(smallest, r);
        mean += r / static_cast<double>(radius_.size());
    }
    margin_ = std::min(0.5 * mean, smallest);
    for (const double r : radius_)
    {
        const double ratio = smallest / r;
        inverseMass_.push_back(D == 2 ? ratio : ratio * ratio);
    }
    findForces();
}

template <int D>
double SoftGrains<D>::typicalOverlap() const
{
    return std::sqrt(energy_ / static_cast<double>(x_.size()));
}

template <int D>
bool SoftGrains<D>::pairsAreOutdated() const
{
    for (std::size_t i = 0; i < xOfPairs_.size(); ++i)
    {
        if ((x_[i] - xOfPairs_[i]).squaredNorm() > 0.25 * margin_ * margin_)
        {
            return true;
        }
    }
    return xOfPairs_.empty();
}

template <int D>
std::array<double, 3> SoftGrains<D>::period() const
{
    std::array<double, 3> result{0, 0, 0};
    for (int axis = 0; axis < D; ++axis)
    {
        result[axis] = periodic_[axis] ? size_[axis] : 0;
    }
    return result;
}

template <int D>
const Vectors<D>& SoftGrains<D>::centres()
{
    x_ = wrapped<D>(std::move(x_), period());
    return x_;
}

template <int D>
void SoftGrains<D>::findPairs()
{
    pairs_.clear();
    const Neighbours<D> neighbours(centres(), radius_, margin_, period());
    for (int i = 0; i < static_cast<int>(x_.size()); ++i)
    {
        neighbours.forNear(i, i, [&](int j) { pairs_.push_back({i, j}); });
    }
    xOfPairs_ = x_;
}

/// From i to the nearest image of j.
template <int D>
Vector<D> SoftGrains<D>::separation(int i, int j) const
{
    Vector<D> d = x_[j] - x_[i];
    for (int axis = 0; axis < D; ++axis)
    {
        if (periodic_[axis] && std::abs(d[axis]) > 0.5 * size_[axis])
        {
            d[axis] -= std::copysign(size_[axis], d[axis]);
        }
    }
    return d;
}

template <int D>
void SoftGrains<D>::findForces()
{
    if (pairsAreOutdated())
    {
        findPairs();
    }
    std::fill(force_.begin(), force_.end(), Vector<D>::Zero());
    energy_ = deepest_ = 0;
    for (const auto& [i, j] : pairs_)
    {
        const Vector<D> d = separation(i, j);
        const double reach = radius_[i] + radius_[j], square = d.squaredNorm();
        if (square < reach * reach)
        {
            const double distance = std::max(std::sqrt(square), 1e-9 * reach), overlap = reach - distance;
            const Vector<D> f = overlap / distance * d;
            force_[i] -= f;
            force_[j] += f;
            energy_ += overlap * overlap;
            deepest_ = std::max(deepest_, overlap / reach);
        }
    }
    for (int axis = 0; axis < D; ++axis)
    {
        for (std::size_t i = 0; !periodic_[axis] && i < x_.size(); ++i)
        {
            addWalls(i, axis);
        }
    }
}

template <int D>
void SoftGrains<D>::addWalls(std::size_t i, int axis)
{
    const double below = std::max(0.0, radius_[i] - x_[i][axis]);
    const double above = std::max(0.0, x_[i][axis] + radius_[i] - size_[axis]);
    force_[i][axis] += below - above;
    energy_ += below * below + above * above;
    deepest_ = std::max(deepest_, std::max(below, above) / radius_[i]);
}

template <int D>
void SoftGrains<D>::move(double dt, double kept)
{
    for (std::size_t i = 0; i < x_.size(); ++i)
    {
        v_[i] = kept * (v_[i] + dt * inverseMass_[i] * force_[i]);
        x_[i] += dt * v_[i];
    }
    findForces();
}

/// FIRE (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006) with its authors' parameters: velocities are turned towards
/// the forces, and stopped when they point uphill.
template <int D>
void SoftGrains<D>::quench(double enough)
{
    double dt = 0.3, mixing = 0.1, energyThen = energy_;
    int downhill = 0;
    std::fill(v_.begin(), v_.end(), Vector<D>::Zero());
    for (int step = 1; deepest_ > enough; ++step)
    {
        double power = 0, motion = 0, drive = 0;
        for (std::size_t i = 0; i < x_.size(); ++i)
        {
            power += force_[i].dot(v_[i]);
            motion += v_[i].squaredNorm() / inverseMass_[i];
            drive += force_[i].squaredNorm() * inverseMass_[i];
        }
        if (power > 0)
        {
            const double turned = mixing * std::sqrt(motion / drive);
            for (std::size_t i = 0; i < x_.size(); ++i)
            {
                v_[i] = (1 - mixing) * v_[i] + turned * inverseMass_[i] * force_[i];
            }
            if (++downhill > 5)
            {
                dt = std::min(1.1 * dt, 0.7);
                mixing *= 0.99;
            }
        }
        else
        {
            std::fill(v_.begin(), v_.end(), Vector<D>::Zero());
            downhill = 0;
            dt = std::max(0.5 * dt, 0.01);
            mixing = 0.1;
        }
        move(dt);

        // Below the density of jamming the energy falls by orders of magnitude in so many steps
        if (step % 200 == 0 && std::exchange(energyThen, energy_) < 4 * energy_)
        {
            return;
        }
    }
}

template <int D>
void SoftGrains<D>::anneal(Random& random, double amplitude, double rate, double enough)
{
    constexpr double dt = 0.3;
    for (std::size_t i = 0; i < x_.size(); ++i)
    {
        const double speed = amplitude * std::sqrt(3 * inverseMass_[i]);  // a uniform number's variance is 1/3
        for (int axis = 0; axis < D; ++axis)
        {
            v_[i][axis] = random.uniform(-speed, speed);
        }
    }
    double left = 1;
    for (int step = 0; left > 1e-3 && deepest_ > enough; ++step)
    {
        move(dt, 1 - rate * dt);
        left *= 1 - rate * dt / 2;  // half of the energy is that of the overlaps
    }
}

template class SoftGrains<2>;
template class SoftGrains<3>;

}  // namespace nscd
