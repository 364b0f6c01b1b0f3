/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodicCells.H"

#include "labelVector.H"
#include "ListOps.H"
#include "meshPeriod.H"

Foam::autoPtr<Foam::grainCells> Foam::periodicCells::New
(
    autoPtr<grainCells> cells
)
{
    const vector period(meshPeriod(cells->mesh()));
    if (period == vector::zero)
    {
        return cells;
    }
    return autoPtr<grainCells>(new periodicCells(std::move(cells), period));
}


Foam::periodicCells::periodicCells
(
    autoPtr<grainCells> cells,
    const vector& period
)
:
    cells_(std::move(cells)),
    period_(period),
    bounds_(cells_->mesh().bounds())
{}


template<class Function>
void Foam::periodicCells::forImages
(
    const point& x,
    const scalar reach,
    const Function& f
) const
{
    vector home(Zero);
    labelVector first(Zero), last(Zero);
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (period_[d] > 0)
        {
            home[d] = wrap(x[d], bounds_.min()[d], period_[d]);
            const scalar from = x[d] + home[d] - bounds_.min()[d];
            first[d] = from + reach > period_[d] ? -1 : 0;
            last[d] = from < reach ? 1 : 0;
        }
    }
    for (label i = first.x(); i <= last.x(); ++i)
    {
        for (label j = first.y(); j <= last.y(); ++j)
        {
            for (label k = first.z(); k <= last.z(); ++k)
            {
                f(home + cmptMultiply(vector(i, j, k), period_));
            }
        }
    }
}


Foam::vector Foam::periodicCells::shortest(const vector& x) const
{
    vector result(x);
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (period_[d] > 0)
        {
            result[d] -= period_[d]*std::round(x[d]/period_[d]);
        }
    }
    return result;
}


bool Foam::periodicCells::isWithinBounds(const grainMember& body) const
{
    grainMember image(body);
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (period_[d] > 0)
        {
            image.centre[d] = bounds_.midpoint()[d];
        }
    }
    return cells_->isWithinBounds(image);
}


void Foam::periodicCells::appendOverlaps
(
    const grainMember& body,
    const label hint,
    overlapList& overlaps
) const
{
    forImages
    (
        body.centre,
        body.radius,
        [&](const vector& displacement)
        {
            cells_->appendOverlaps
            (
                {body.centre + displacement, body.radius}, hint, overlaps
            );
        }
    );
}


void Foam::periodicCells::appendOverlaps
(
    const UList<grainMember>& members,
    const point& centre,
    overlapList& overlaps
) const
{
    scalar reach = 0;
    for (const grainMember& m : members)
    {
        reach = max(reach, mag(m.centre - centre) + m.radius);
    }
    List<grainMember> image(members);
    forImages
    (
        centre,
        reach,
        [&](const vector& displacement)
        {
            forAll(image, i)
            {
                image[i].centre = members[i].centre + displacement;
            }
            cells_->appendOverlaps(image, centre + displacement, overlaps);
        }
    );
}


void Foam::periodicCells::findNear
(
    const grainMember& body,
    DynamicList<label>& cells
) const
{
    DynamicList<label> near;
    cells.clear();
    forImages
    (
        body.centre,
        body.radius,
        [&](const vector& displacement)
        {
            cells_->findNear
            (
                {body.centre + displacement, body.radius}, near
            );
            cells.append(near);
        }
    );
    inplaceUniqueSort(cells);
}
