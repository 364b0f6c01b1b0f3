/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "recommendedTimeStep.H"

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


void Foam::printTimeStep
(
    const grainProperties& properties,
    const nscd::Grains<2>& grains,
    const dragLaw& drag,
    const scalar rho,
    const scalar mu
)
{
    const scalar g = mag(properties.g());

    scalar speed = 0;
    scalar smallest = GREAT;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const scalar d = 2*grains.radius[i];
        const scalar rhop = properties.materials().density(grains.material[i]);

        smallest = min(smallest, d);
        speed = max(speed, grains.velocity[i].norm());
        speed = max
        (
            speed,
            settlingSpeed
            (
                drag, d*Foam::sqrt(properties.packingRatio()),
                rhop, rho, mu, g
            )
        );
    }

    if (speed < SMALL)
    {
        Info<< nl << "Recommended deltaT      none: no grain moves by itself,"
            << " the flow sets the limit" << endl;
        return;
    }

    const scalar courant =
        0.5*properties.plane().cellSizeRange().first()/speed;
    const scalar displacement = 0.1*smallest/speed;
    const scalar weight = Foam::sqrt(0.01*smallest/max(g, SMALL));

    Info<< nl << "Speed to expect         " << speed
        << " m/s, the largest of the grains' own and of settling alone" << nl
        << "Limits of deltaT        Courant number 0.5: " << courant << " s"
        << nl
        << "                        a tenth of the smallest diameter: "
        << displacement << " s" << nl
        << "                        fall from rest of 1 % of a diameter: "
        << weight << " s" << nl
        << "Recommended deltaT      " << min(courant, min(displacement, weight))
        << " s" << endl;
}
