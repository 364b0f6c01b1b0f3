// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/problem/Anderson.hpp"

#include <numeric>

namespace nscd
{

void Anderson::mix(const std::vector<double>& x, std::vector<double>& G, const std::vector<double>& weights,
                   const std::vector<Range>& ranges)
{
    F_.resize(weights.size());
    lastF_.resize(weights.size());
    for (std::size_t k = 0; k < weights.size(); ++k)
    {
        F_[k] = weights[k] * (G[k] - x[k]);
    }
    std::vector<double> sums(3 * static_cast<std::size_t>(blocks_), 0.0);
    for (const Range& range : ranges)
    {
        double* sum = sums.data() + 3 * static_cast<std::size_t>(range.block);
        for (std::size_t k = range.begin; k < range.end; ++k)
        {
            const double change = F_[k] - lastF_[k];
            sum[0] += F_[k] * F_[k];
            sum[1] += F_[k] * change;
            sum[2] += change * change;
        }
    }
    communicator_.sum(sums);
    double square = 0, product = 0, squareOfChange = 0;
    for (std::size_t b = 0; b < sums.size(); b += 3)
    {
        square += sums[b];
        product += sums[b + 1];
        squareOfChange += sums[b + 2];
    }

    const bool mixes = hasLast_ && square <= 4 * lastSquare_ && squareOfChange > 1e-20 * square;
    const std::vector<double> swept = G;
    if (mixes)
    {
        const double gamma = product / squareOfChange;
        for (std::size_t k = 0; k < G.size(); ++k)
        {
            G[k] -= gamma * (swept[k] - lastG_[k]);
        }
    }
    lastG_ = swept;
    lastF_.swap(F_);
    lastSquare_ = square;
    hasLast_ = true;
}

}  // namespace nscd
