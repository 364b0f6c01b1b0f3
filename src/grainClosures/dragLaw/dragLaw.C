/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dragLaw.H"

#include "selected.H"
#include "shapeOfLaw.H"

namespace Foam
{
    defineTypeNameAndDebug(dragLaw, 0);
    defineRunTimeSelectionTable(dragLaw, dictionary);
}


Foam::autoPtr<Foam::dragLaw> Foam::dragLaw::New
(
    const dictionary& dict,
    const label nDimensions
)
{
    const auto construct =
        dictionaryInput::selected(*dictionaryConstructorTablePtr_, dict);

    dictionary full(dict);
    if (!full.found("shape"))
    {
        full.add("shape", word(nDimensions == 3 ? "sphere" : "disc"));
    }
    autoPtr<dragLaw> law(construct(full));

    dictionaryInput::shapeOfLaw
    (
        dict, nDimensions == 3 ? "sphere" : "disc", law->shapes()
    );
    return law;
}


Foam::scalar Foam::dragLaw::gammaInCoveredCell
(
    const scalar eps,
    const scalar w,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    // A law that rises by less than ten times is one of lone grains; it gets
    // Wen and Yu's power.  Others keep their own limit.
    const scalar lone = gamma(1, w, d, rho, mu);
    const scalar own = gamma(eps, w, d, rho, mu);
    return
        gamma(0.01, w, d, rho, mu) < 10*lone
      ? max(own, std::pow(eps, -2.65)*lone)
      : own;
}
