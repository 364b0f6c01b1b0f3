/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectiveViscosity.H"

#include "dictionaryInput.H"
#include "selected.H"
#include "volFields.H"

namespace Foam
{
    defineTypeNameAndDebug(effectiveViscosity, 0);
    defineRunTimeSelectionTable(effectiveViscosity, dictionary);
}


Foam::autoPtr<Foam::effectiveViscosity> Foam::effectiveViscosity::New
(
    const dictionary& coupling
)
{
    dictionary deflt;
    deflt.add("type", "none");

    const dictionary& dict =
        coupling.found("viscosity")
      ? dictionaryInput::subDict(coupling, "viscosity")
      : deflt;

    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict
    )(dict);
}


Foam::tmp<Foam::volScalarField> Foam::effectiveViscosity::ratio
(
    const volScalarField& eps
) const
{
    tmp<volScalarField> result(new volScalarField("viscosityRatio", eps));

    for (scalar& x : result.ref().primitiveFieldRef())
    {
        x = ratio(x);
    }
    for (fvPatchScalarField& patch : result.ref().boundaryFieldRef())
    {
        for (scalar& x : patch)
        {
            x = ratio(x);
        }
    }
    return result;
}
