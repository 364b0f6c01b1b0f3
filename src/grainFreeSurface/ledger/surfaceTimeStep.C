/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceTimeStep.H"

#include "dictionaryInput.H"
#include "fvcSurfaceIntegrate.H"
#include "mathematicalConstants.H"

Foam::surfaceTimeStep::surfaceTimeStep
(
    const twoFluids& fluid,
    const volScalarField& eps
)
:
    fluid_(fluid),
    eps_(eps)
{
    entry("maxAlphaCo", 0.5);
    entry("maxCapillaryCo", 1);
}


Foam::scalar Foam::surfaceTimeStep::entry
(
    const word& keyword,
    const scalar deflt
) const
{
    return dictionaryInput::getPositiveOrDefault
    (
        eps_.mesh().time().controlDict(), keyword, dimless, deflt
    );
}


Foam::tmp<Foam::scalarField> Foam::surfaceTimeStep::isSurface() const
{
    const scalarField& alpha = fluid_.alpha().primitiveField();
    return
        pos0(alpha - 0.01)*pos0(0.99 - alpha)
       *pos0(eps_.primitiveField() - 0.1);
}


Foam::scalar Foam::surfaceTimeStep::courantNumber
(
    const surfaceScalarField& phiU
) const
{
    const scalarField sumPhi(fvc::surfaceSum(mag(phiU))().primitiveField());
    return 0.5*gMax(isSurface()*sumPhi/eps_.mesh().V().field());
}


Foam::scalar Foam::surfaceTimeStep::capillaryLimit() const
{
    const fvMesh& mesh = eps_.mesh();
    const scalar sigma = gMax(fluid_.sigma()().primitiveField());
    const scalarField surface(isSurface());
    const surfaceScalarField& inverse = mesh.nonOrthDeltaCoeffs();

    scalar largest = 0;
    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        if
        (
            surface[P] > 0 || surface[N] > 0
         || mag(fluid_.alpha()[P] - fluid_.alpha()[N]) > 0.01
        )
        {
            largest = max(largest, inverse[facei]);
        }
    }
    reduce(largest, maxOp<scalar>());
    if (sigma <= 0 || largest <= 0)
    {
        return GREAT;
    }
    const scalar rho =
        (fluid_.mixture().rho1() + fluid_.mixture().rho2()).value();
    return sqrt
    (
        rho/(4*constant::mathematical::pi*sigma*pow3(largest))
    );
}


std::vector<std::pair<const char*, Foam::scalar>>
Foam::surfaceTimeStep::limits(const surfaceScalarField& phiU)
{
    const Time& runTime = eps_.time();
    const dictionary& dict = runTime.controlDict();
    const scalar capillary = capillaryLimit();
    if
    (
        !hasWarned_ && !dict.getOrDefault("adjustTimeStep", false)
     && runTime.deltaTValue() > capillary
    )
    {
        hasWarned_ = true;
        WarningInFunction
            << "deltaT = " << runTime.deltaTValue()
            << " s is longer than the limit of capillary waves, " << capillary
            << " s after time " << runTime.timeName() << nl
            << "    surface tension may make waves that grow: a smaller deltaT,"
            << " or 'adjustTimeStep yes', avoids it (said once)" << endl;
    }
    return
    {
        {
            "maxAlphaCo",
            entry("maxAlphaCo", 0.5)/max(courantNumber(phiU), VSMALL)
        },
        {
            "maxCapillaryCo",
            capillary < GREAT ? entry("maxCapillaryCo", 1)*capillary : GREAT
        }
    };
}
