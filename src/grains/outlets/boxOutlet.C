/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxOutlet.H"

#include "dictionaryInput.H"
#include "meshPeriod.H"
#include "nscd/packing/Packing.hpp"
#include "readGeometry.H"

#include <algorithm>
#include <cmath>

addToSelection(grainOutlet, grainOutletTypes, box)

namespace
{

//- Does the straight way from one point to another meet a box?
template<int D>
bool meets
(
    const nscd::Vector<D>& from,
    const nscd::Vector<D>& to,
    const Eigen::AlignedBox<double, D>& box
)
{
    // Shares of the way at which it enters and leaves
    Foam::scalar enters = 0, leaves = 1;
    for (int d = 0; d < D; ++d)
    {
        const Foam::scalar way = to[d] - from[d];
        const Foam::scalar lower = box.min()[d] - from[d];
        const Foam::scalar upper = box.max()[d] - from[d];
        if (Foam::mag(way) < Foam::VSMALL)
        {
            if (lower > 0 || upper < 0)
            {
                return false;
            }
            continue;
        }
        enters = Foam::max(enters, (way > 0 ? lower : upper)/way);
        leaves = Foam::min(leaves, (way > 0 ? upper : lower)/way);
    }
    return enters <= leaves;
}

}


template<int D>
Foam::grainOutletTypes::box<D>::box
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    period_(space.fromSpace(meshPeriod(space.mesh()))),
    around_(1, nscd::Vector<D>::Zero())
{
    dictionaryInput::checkKeywords(dict, {"type", "box"});

    const nscd::Box<D> box(readBox(dict, space));
    box_ = {box.lower, box.upper};
    for (int d = 0; d < D; ++d)
    {
        const nscd::Vectors<D> others(around_);
        for (const nscd::Vector<D>& x : others)
        {
            if (period_[d] > 0)
            {
                const nscd::Vector<D> one(period_[d]*nscd::Vector<D>::Unit(d));
                around_.push_back(x + one);
                around_.push_back(x - one);
            }
        }
    }
}


template<int D>
bool Foam::grainOutletTypes::box<D>::isOnWay
(
    const nscd::Vector<D>& from,
    const nscd::Vector<D>& to
) const
{
    // The box beside the middle of the way, and those around it
    const nscd::Vector<D> off(0.5*(from + to) - box_.center());
    nscd::Vector<D> nearest(nscd::Vector<D>::Zero());
    for (int d = 0; d < D; ++d)
    {
        if (period_[d] > 0)
        {
            nearest[d] = period_[d]*std::round(off[d]/period_[d]);
        }
    }
    return std::any_of
    (
        around_.begin(), around_.end(),
        [&](const nscd::Vector<D>& periods)
        {
            const nscd::Vector<D> shift(nearest + periods);
            return meets<D>(from - shift, to - shift, box_);
        }
    );
}


template<int D>
void Foam::grainOutletTypes::box<D>::mark
(
    const nscd::Vectors<D>& before,
    const nscd::Vectors<D>& centres,
    const boolList&,
    std::vector<bool>& gone
) const
{
    for (std::size_t i = 0; i < gone.size(); ++i)
    {
        gone[i] = gone[i] || isOnWay(before[i], centres[i]);
    }
}
