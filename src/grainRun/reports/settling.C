/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "settling.H"

#include "coarseGraining.H"

Foam::scalar Foam::settlingSpeed
(
    const dragLaw& drag,
    const scalar d,
    const scalar rhop,
    const scalar rho,
    const scalar mu,
    const scalar g
)
{
    const scalar weight = mag(rhop - rho)*g;

    // gamma(w) w grows with w: bisect between rest and free fall in nothing
    scalar low = 0;
    scalar high = 1;
    while (drag.gamma(1, high, d, rho, mu)*high < weight)
    {
        high *= 2;
    }
    for (label i = 0; i < 60; ++i)
    {
        const scalar middle = 0.5*(low + high);
        if (drag.gamma(1, middle, d, rho, mu)*middle < weight)
        {
            low = middle;
        }
        else
        {
            high = middle;
        }
    }
    return high;
}


template<int D>
Foam::List<Foam::settling> Foam::settlingAlone
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains,
    const dragLaw& drag,
    const scalar rho,
    const scalar mu
)
{
    const scalar diameter =
        2*properties.space().lengthRatio(properties.packingRatio());
    const scalar coarse = coarseGraining(properties.coupling());
    const scalar g = mag(properties.g());

    List<settling> result(grains.size());
    forAll(result, i)
    {
        const scalar d = diameter*grains.radius[i];
        const scalar speed = settlingSpeed
        (
            drag, d/coarse,
            properties.materials().density(grains.material[i]), rho, mu, g
        );
        result[i] = {d/coarse, d, speed, rho*speed*d/coarse/mu};
    }
    return result;
}


template Foam::List<Foam::settling> Foam::settlingAlone
(
    const grainProperties<2>&, const nscd::Grains<2>&,
    const dragLaw&, const scalar, const scalar
);
template Foam::List<Foam::settling> Foam::settlingAlone
(
    const grainProperties<3>&, const nscd::Grains<3>&,
    const dragLaw&, const scalar, const scalar
);
