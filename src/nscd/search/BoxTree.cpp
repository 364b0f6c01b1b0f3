// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/search/BoxTree.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

constexpr int leafSize = 4;

}  // namespace

template <int D>
BoxTree<D>::BoxTree(const std::vector<Bounds<D>>& boxes, const std::vector<int>& groups)
    : members_(boxes.size())
{
    std::iota(members_.begin(), members_.end(), 0);
    std::stable_sort(members_.begin(), members_.end(), [&](int a, int b) { return groups[a] < groups[b]; });
    const int n = static_cast<int>(boxes.size());
    for (int begin = 0; begin < n;)
    {
        int end = begin;
        while (end < n && groups[members_[end]] == groups[members_[begin]])
        {
            ++end;
        }
        grow(boxes, begin, end);
        begin = end;
    }
    refit(boxes);
}

template <int D>
void BoxTree<D>::grow(const std::vector<Bounds<D>>& boxes, int begin, int end)
{
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    if (end - begin <= leafSize)
    {
        nodes_[node].begin = begin;
        nodes_[node].end = end;
    }
    else
    {
        const auto centre = [&](int i) -> Vector<D> { return boxes[i].lower + boxes[i].upper; };
        Bounds<D> centres{centre(members_[begin]), centre(members_[begin])};
        for (int m = begin; m < end; ++m)
        {
            centres.enclose({centre(members_[m]), centre(members_[m])});
        }
        int axis = 0;
        (centres.upper - centres.lower).maxCoeff(&axis);
        const int middle = (begin + end) / 2;
        std::nth_element(members_.begin() + begin, members_.begin() + middle, members_.begin() + end,
                         [&](int a, int b)
                         {
                             const double difference = centre(a)[axis] - centre(b)[axis];
                             return difference != 0 ? difference < 0 : a < b;
                         });
        grow(boxes, begin, middle);
        grow(boxes, middle, end);
    }
    nodes_[node].next = static_cast<int>(nodes_.size());
}

template <int D>
void BoxTree<D>::refit(const std::vector<Bounds<D>>& boxes)
{
    boxes_.clear();
    for (const int member : members_)
    {
        boxes_.push_back(boxes[member]);
    }
    for (std::size_t n = nodes_.size(); n-- > 0;)
    {
        Node& node = nodes_[n];
        if (node.end > node.begin)
        {
            node.box = boxes_[node.begin];
            std::for_each(boxes_.begin() + node.begin, boxes_.begin() + node.end,
                          [&](const Bounds<D>& box) { node.box.enclose(box); });
        }
        else
        {
            node.box = nodes_[n + 1].box;
            node.box.enclose(nodes_[nodes_[n + 1].next].box);
        }
    }
}

template class BoxTree<2>;
template class BoxTree<3>;

}  // namespace nscd
