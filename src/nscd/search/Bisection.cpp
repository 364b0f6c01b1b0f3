// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/search/Bisection.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

template <int D>
int longestAxis(const Vectors<D>& points, const int* begin, const int* end)
{
    Vector<D> lower = points[*begin];
    Vector<D> upper = lower;
    for (const int* p = begin; p != end; ++p)
    {
        lower = lower.cwiseMin(points[*p]);
        upper = upper.cwiseMax(points[*p]);
    }
    int axis = 0;
    (upper - lower).maxCoeff(&axis);
    return axis;
}

template <int D>
void cut(const Vectors<D>& points, int* begin, int* end, int firstBlock, int blocks, std::vector<int>& block)
{
    if (begin == end)
    {
        return;
    }
    if (blocks == 1)
    {
        std::for_each(begin, end, [&](int p) { block[p] = firstBlock; });
        return;
    }
    const int axis = longestAxis<D>(points, begin, end);
    int* middle = begin + (end - begin + 1) / 2;
    std::nth_element(begin, middle, end,
                     [&](int p, int q)
                     {
                         const double a = points[p][axis];
                         const double b = points[q][axis];
                         return a < b || (a == b && p < q);
                     });
    cut<D>(points, begin, middle, firstBlock, blocks / 2, block);
    cut<D>(points, middle, end, firstBlock + blocks / 2, blocks / 2, block);
}

}  // namespace

template <int D>
std::vector<int> bisect(const Vectors<D>& points, int blocks)
{
    std::vector<int> block(points.size(), 0);
    std::vector<int> index(points.size());
    std::iota(index.begin(), index.end(), 0);
    cut<D>(points, index.data(), index.data() + index.size(), 0, blocks, block);
    return block;
}

template std::vector<int> bisect<2>(const Vectors<2>&, int);
template std::vector<int> bisect<3>(const Vectors<3>&, int);

}  // namespace nscd
