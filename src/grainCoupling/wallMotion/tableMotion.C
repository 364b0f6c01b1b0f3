/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableMotion.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(wallMotion, wallMotions, table)

template<int D>
Foam::wallMotions::table<D>::table
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    space_(space),
    origin_(nscd::Vector<D>::Zero()),
    axis_(nscd::Spin<D>::Zero())
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "displacement", "angle", "origin", "axis"}
    );

    if (dict.found("displacement"))
    {
        displacement_ = Function1<vector>::New("displacement", dict);
    }
    if (dict.found("angle"))
    {
        angle_ = Function1<scalar>::New("angle", dict);
        origin_ = space.fromSpace(dict.get<point>("origin"));
        axis_ = readAxis(dict, space);
    }
}


template<int D>
nscd::WallBody<D> Foam::wallMotions::table<D>::body() const
{
    nscd::WallBody<D> result;
    result.position = origin_;
    return result;
}


template<int D>
void Foam::wallMotions::table<D>::set
(
    nscd::ContactDynamics<D>& dynamics,
    const label bodyi,
    const scalar t,
    const scalar deltaT,
    const nscd::Vector<D>& g
) const
{
    nscd::Vector<D> velocity(nscd::Vector<D>::Zero());
    nscd::Spin<D> spin(nscd::Spin<D>::Zero());
    if (displacement_)
    {
        velocity = space_.fromSpace
        (
            (displacement_->value(t + deltaT) - displacement_->value(t))/deltaT
        );
    }
    if (angle_)
    {
        spin = (angle_->value(t + deltaT) - angle_->value(t))/deltaT*axis_;
    }
    dynamics.setWallMotion(bodyi, velocity, spin);
}
