/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "freeMotion.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(wallMotion, wallMotions, free)

template<int D>
Foam::wallMotions::free<D>::free
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    force_
    (
        space.fromSpace(dictionaryInput::getVectorOrZero(dict, "force"))
    )
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "mass", "centre", "inertia", "force", "velocity"}
    );

    body_.mass = dictionaryInput::getPositive(dict, "mass", dimMass);
    body_.position = readPoint(dict, "centre", space);
    body_.velocity =
        space.fromSpace(dictionaryInput::getVectorOrZero(dict, "velocity"));

    if (dict.found("inertia"))
    {
        const char* const allowed = "three values > 0, as (1 1 1)";
        const vector inertia
        (
            dictionaryInput::getAs<vector>(dict, "inertia", allowed)
        );
        if (cmptMin(inertia) <= 0)
        {
            dictionaryInput::badValue
            (
                dict, "inertia", dictionaryInput::written(dict, "inertia"),
                allowed
            );
        }
        body_.inertia = space.spinFromSpace(inertia).cwiseAbs();
    }
}


template<int D>
nscd::WallBody<D> Foam::wallMotions::free<D>::body() const
{
    return body_;
}


template<int D>
void Foam::wallMotions::free<D>::set
(
    nscd::ContactDynamics<D>& dynamics,
    const label bodyi,
    const scalar t,
    const scalar deltaT,
    const nscd::Vector<D>& g
) const
{
    dynamics.setWallLoad
    (
        bodyi, force_ + body_.mass*g, nscd::Spin<D>::Zero()
    );
}
