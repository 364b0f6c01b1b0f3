/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "recommendedTimeStep.H"

namespace
{

// Largest speed and smallest diameter of grains
template<int D>
Foam::Pair<Foam::scalar> speedAndDiameter(const nscd::Grains<D>& grains)
{
    Foam::scalar speed = 0;
    Foam::scalar smallest = Foam::GREAT;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        smallest = Foam::min(smallest, 2*grains.radius[i]);
        speed = Foam::max(speed, grains.velocity[i].norm());
    }
    return {speed, smallest};
}

// 'courant' is the limit of the fluid [s]
void printLimits
(
    const Foam::scalar speed,
    const char* speedOf,
    const Foam::scalar smallest,
    const Foam::scalar g,
    const Foam::scalar courant
)
{
    using namespace Foam;

    const scalar displacement = 0.1*smallest/speed;
    const scalar weight = Foam::sqrt(0.01*smallest/max(g, SMALL));

    Info<< nl << "Speed to expect         " << speed
        << " m/s, the largest of the grains' own and of " << speedOf << nl
        << "Limits of deltaT        ";
    if (courant < GREAT)
    {
        Info<< "Courant number 0.5: " << courant << " s" << nl
            << "                        ";
    }
    Info<< "a tenth of the smallest diameter: " << displacement << " s" << nl
        << "                        fall from rest of 1 % of a diameter: "
        << weight << " s" << nl
        << "Recommended deltaT      " << min(courant, min(displacement, weight))
        << " s" << endl;
}

}


template<int D>
void Foam::printTimeStep
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains,
    const UList<settling>& alone
)
{
    scalar speed = speedAndDiameter(grains).first();
    for (const settling& grain : alone)
    {
        speed = max(speed, grain.speed);
    }

    if (speed < SMALL)
    {
        Info<< nl << "Recommended deltaT      none: no grain moves by itself,"
            << " the flow sets the limit" << endl;
        return;
    }
    printLimits
    (
        speed, "settling alone", speedAndDiameter(grains).second(),
        mag(properties.g()), 0.5*properties.space().cellSizeRange().first()/speed
    );
}


template<int D>
void Foam::printTimeStep
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains
)
{
    const vector& g = properties.g();
    const Pair<scalar> own(speedAndDiameter(grains));
    const scalar speed = max
    (
        own.first(),
        Foam::sqrt
        (
            2*(cmptMag(g) & properties.space().mesh().bounds().span())
        )
    );

    if (speed < SMALL)
    {
        Info<< nl << "Recommended deltaT      none: no grain moves by itself"
            << endl;
        return;
    }
    printLimits
    (
        speed, "a fall through the mesh", own.second(), mag(g), GREAT
    );
}


template void Foam::printTimeStep
(
    const grainProperties<2>&, const nscd::Grains<2>&, const UList<settling>&
);
template void Foam::printTimeStep
(
    const grainProperties<3>&, const nscd::Grains<3>&, const UList<settling>&
);
template void Foam::printTimeStep
(
    const grainProperties<2>&, const nscd::Grains<2>&
);
template void Foam::printTimeStep
(
    const grainProperties<3>&, const nscd::Grains<3>&
);
