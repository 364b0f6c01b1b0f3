// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Communicator.hpp"

#include <vector>

namespace nscd
{

/// Anderson's acceleration of a fixed point x = G(x), of depth one (Walker and Ni 2011, doi:10.1137/10078356X), with
/// F = G(x) - x and dF, dG the changes since the last iteration,
///
///     x <- G - gamma dG,   gamma = F.dF/dF.dF,
///
/// which begins anew where |F|^2 has grown fourfold (doc/theory, eq. 5.18).  Sweeps over contacts of mass ratio q
/// approach their fixed point by a factor of 1 - 1/q only, along one direction, which this finds.  Sums are taken block
/// by block: the result does not depend on the number of ranks.
class Anderson
{
public:
    /// Values [begin, end) belong to a block.
    struct Range
    {
        int block;
        std::size_t begin, end;
    };

    Anderson(const Communicator& communicator, int blocks) : communicator_(communicator), blocks_(blocks) {}

    void restart() { hasLast_ = false; }

    /// Change G(x) into the next x.  Values beyond 'weights', which make the others comparable, are carried along.
    /// Collective.
    void mix(const std::vector<double>& x, std::vector<double>& G, const std::vector<double>& weights,
             const std::vector<Range>& ranges);

private:
    const Communicator& communicator_;
    int blocks_;
    std::vector<double> F_, lastF_, lastG_;
    double lastSquare_ = 0;
    bool hasLast_ = false;
};

}  // namespace nscd
