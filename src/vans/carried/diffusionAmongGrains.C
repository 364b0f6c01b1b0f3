/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusionAmongGrains.H"

#include "harmonic.H"
#include "surfaceInterpolate.H"
#include "transportFlux.H"

Foam::diffusionAmongGrains::diffusionAmongGrains
(
    const grainSystem& grains,
    grainFluidExchange& exchange
)
:
    exchange_(exchange),
    law_
    (
        effectiveConductivity::New
        (
            grains.motion().coupling(), grains.mesh().nGeometricD(), "diffusivity"
        )
    )
{}


Foam::tmp<Foam::volScalarField> Foam::diffusionAmongGrains::ratio
(
    const volScalarField& amongSmall
) const
{
    tmp<volScalarField> tresult(new volScalarField("diffusivityRatio", amongSmall));
    const auto apply = [&](scalarField& shares)
    {
        for (scalar& share : shares)
        {
            share = max(law_->ratio(share, 0), transportFlux::least);
        }
    };
    apply(tresult.ref().primitiveFieldRef());
    for (fvPatchScalarField& patch : tresult.ref().boundaryFieldRef())
    {
        apply(patch);
    }
    return tresult;
}


Foam::tmp<Foam::surfaceScalarField> Foam::diffusionAmongGrains::onFaces
(
    const volScalarField& open
) const
{
    if (!law_->needsGrains())
    {
        return fvc::interpolate(open);
    }
    exchange_.followGrains();
    const volScalarField amongSmall
    (
        max
        (
            exchange_.resolved().amongSmall(exchange_.fields().fluidShare),
            transportFlux::least
        )
    );
    return
        fvc::interpolate(open/amongSmall)
       *harmonic(open.mesh()).interpolate(ratio(amongSmall));
}
