// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/base/Check.hpp"
#include "nscd/base/Random.hpp"
#include "nscd/packing/Packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace nscd
{

namespace
{

/// Grains placed so far, by cells at least as wide as the widest grain.
template <int D>
class PlacedGrains
{
public:
    PlacedGrains(const Box<D>& box, double cellWidth, std::size_t grains)
        : lower_(box.lower)
    {
        const double extent = (box.upper - box.lower).prod();
        const double enough = std::pow(extent / (4.0 * static_cast<double>(grains) + 64), 1.0 / D);
        width_ = std::max(cellWidth, enough);
        std::size_t total = 1;
        for (int d = 0; d < D; ++d)
        {
            cells_[d] = 1 + static_cast<int>((box.upper[d] - box.lower[d]) / width_);
            total *= cells_[d];
        }
        members_.resize(total);
    }

    bool isFree(const Vector<D>& x, double radius) const
    {
        bool free = true;
        forNeighbours(x,
                      [&](std::size_t cell)
                      {
                          for (const Disc& other : members_[cell])
                          {
                              const double distance = radius + other.radius;
                              free = free && (other.x - x).squaredNorm() >= distance * distance;
                          }
                      });
        return free;
    }

    void add(const Vector<D>& x, double radius)
    {
        const std::array<int, 3> c = coordinates(x);
        members_[index(c[0], c[1], c[2])].push_back({x, radius});
    }

private:
    struct Disc
    {
        Vector<D> x;
        double radius;
    };

    std::array<int, 3> coordinates(const Vector<D>& x) const
    {
        std::array<int, 3> c{0, 0, 0};
        for (int d = 0; d < D; ++d)
        {
            c[d] = std::min(cells_[d] - 1, static_cast<int>((x[d] - lower_[d]) / width_));
        }
        return c;
    }

    std::size_t index(int i, int j, int k) const
    {
        return (static_cast<std::size_t>(k) * cells_[1] + j) * cells_[0] + i;
    }

    template <class F>
    void forNeighbours(const Vector<D>& x, F&& f) const
    {
        const std::array<int, 3> c = coordinates(x);
        for (int k = std::max(0, c[2] - 1); k <= std::min(cells_[2] - 1, c[2] + 1); ++k)
        {
            for (int j = std::max(0, c[1] - 1); j <= std::min(cells_[1] - 1, c[1] + 1); ++j)
            {
                for (int i = std::max(0, c[0] - 1); i <= std::min(cells_[0] - 1, c[0] + 1); ++i)
                {
                    f(index(i, j, k));
                }
            }
        }
    }

    Vector<D> lower_;
    double width_;
    std::array<int, 3> cells_{1, 1, 1};
    std::vector<std::vector<Disc>> members_;
};

template <int D>
void check(const Box<D>& box, const std::vector<double>& radii, int maxTries)
{
    checkBox<D>(box);
    const double narrowest = (box.upper - box.lower).minCoeff();
    for (const double radius : radii)
    {
        checkRadius(radius);
        if (2 * radius > narrowest)
        {
            refuse("radius ", radius, " m: the box is only ", narrowest, " m wide");
        }
    }
    if (maxTries < 1)
    {
        refuse("maxTries ", maxTries, " is less than 1");
    }
}

}  // namespace

template <int D>
Vectors<D> randomFill(const Box<D>& box, const std::vector<double>& radii, std::uint64_t seed, int maxTries,
                      const std::function<bool(const Vector<D>&, double)>& accepts)
{
    check<D>(box, radii, maxTries);
    std::vector<std::size_t> largestFirst(radii.size());
    std::iota(largestFirst.begin(), largestFirst.end(), 0);
    std::stable_sort(largestFirst.begin(), largestFirst.end(),
                     [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });

    Vectors<D> centres(radii.size(), Vector<D>::Zero());
    if (radii.empty())
    {
        return centres;
    }
    PlacedGrains<D> placed(box, 2 * radii[largestFirst[0]], radii.size());
    Random random(seed);
    for (std::size_t n = 0; n < radii.size(); ++n)
    {
        const double radius = radii[largestFirst[n]];
        Vector<D>& x = centres[largestFirst[n]];
        int tries = 0;
        do
        {
            if (tries++ == maxTries)
            {
                throw std::runtime_error("grain " + std::to_string(n + 1) + " of " + std::to_string(radii.size()) +
                                         ", largest first, found no place in " + std::to_string(maxTries) + " tries");
            }
            for (int d = 0; d < D; ++d)
            {
                x[d] = random.uniform(box.lower[d] + radius, box.upper[d] - radius);
            }
        } while (!placed.isFree(x, radius) || (accepts && !accepts(x, radius)));
        placed.add(x, radius);
    }
    return centres;
}

template Vectors<2> randomFill<2>(const Box<2>&, const std::vector<double>&, std::uint64_t, int,
                                      const std::function<bool(const Vector<2>&, double)>&);
template Vectors<3> randomFill<3>(const Box<3>&, const std::vector<double>&, std::uint64_t, int,
                                      const std::function<bool(const Vector<3>&, double)>&);

}  // namespace nscd
