// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

namespace nscd
{

/// A box with faces along the axes.
template <int D>
struct Bounds
{
    Vector<D> lower, upper;

    bool meets(const Bounds& other) const
    {
        for (int d = 0; d < D; ++d)
        {
            if (lower[d] > other.upper[d] || upper[d] < other.lower[d])
            {
                return false;
            }
        }
        return true;
    }

    void enclose(const Bounds& other)
    {
        lower = lower.cwiseMin(other.lower);
        upper = upper.cwiseMax(other.upper);
    }
};

/// Finds the boxes that meet a given one in a time that grows with the logarithm of their number.  Each group has a
/// tree of its own, so that the trees stay good when groups move against each other.
template <int D>
class BoxTree
{
public:
    BoxTree() = default;

    /// groups[i]: a number that says with which other boxes box i moves.
    BoxTree(const std::vector<Bounds<D>>& boxes, const std::vector<int>& groups);

    /// The same boxes where they are now; their places in the trees remain.
    void refit(const std::vector<Bounds<D>>& boxes);

    /// Call f(i) for every box i that meets the given one.  The order depends on where the boxes were when the tree
    /// was made, and on nothing else.
    template <class F>
    void forMeeting(const Bounds<D>& box, F&& f) const;

private:
    /// Depth first: the first child follows its parent, the second one the last of the first one's.
    struct Node
    {
        Bounds<D> box;
        int next;               ///< first node after this one's descendants
        int begin = 0, end = 0; ///< members of a leaf
    };

    void grow(const std::vector<Bounds<D>>& boxes, int begin, int end);

    std::vector<int> members_;
    std::vector<Node> nodes_;
    std::vector<Bounds<D>> boxes_;   ///< of the members
};

template <int D>
template <class F>
void BoxTree<D>::forMeeting(const Bounds<D>& box, F&& f) const
{
    for (int n = 0; n < static_cast<int>(nodes_.size());)
    {
        const Node& node = nodes_[n];
        if (!node.box.meets(box))
        {
            n = node.next;
            continue;
        }
        for (int m = node.begin; m < node.end; ++m)
        {
            if (boxes_[m].meets(box))
            {
                f(members_[m]);
            }
        }
        ++n;
    }
}

}  // namespace nscd
