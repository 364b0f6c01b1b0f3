/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shearLayers.H"

#include "fvc.H"

namespace
{

using namespace Foam;

//- What a layer needs of a cell
struct side
{
    scalar way, mu, drag, filled;

    //- Difference of velocity over stress between the face and the middle [m/Pa/s]
    scalar resistance() const
    {
        const scalar ways = way*std::sqrt(drag/mu);
        const scalar thin = ways > ROOTSMALL ? std::tanh(ways)/ways : scalar(1);
        return way/mu*(thin + 2*(1 - filled)*(1 - thin));
    }
};


scalar between(const side& P, const side& N)
{
    const scalar way = P.way + N.way;
    return
        way/(P.resistance() + N.resistance()) - way/(P.way/P.mu + N.way/N.mu);
}


//- Part of each cell that a bed fills, by the most of its neighbours
tmp<scalarField> filled(const volScalarField& eps)
{
    const fvMesh& mesh = eps.mesh();
    const scalarField solid(1 - eps.primitiveField());
    scalarField most(solid);
    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        most[P] = max(most[P], solid[N]);
        most[N] = max(most[N], solid[P]);
    }
    for (const fvPatchScalarField& patch : eps.boundaryField())
    {
        if (patch.coupled())
        {
            const scalarField beyond(1 - patch.patchNeighbourField());
            const labelUList& cells = patch.patch().faceCells();
            forAll(cells, i)
            {
                most[cells[i]] = max(most[cells[i]], beyond[i]);
            }
        }
    }
    return solid/max(most, VSMALL);
}

}


Foam::tmp<Foam::surfaceScalarField> Foam::viscosityOfLayers
(
    const volScalarField& mu,
    const volScalarField& drag,
    const volScalarField& eps
)
{
    const fvMesh& mesh = mu.mesh();
    tmp<surfaceScalarField> tresult
    (
        new surfaceScalarField
        (
            IOobject("muOfLayers", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(mu.dimensions(), Zero)
        )
    );
    surfaceScalarField& result = tresult.ref();

    volScalarField part
    (
        IOobject("filled", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero)
    );
    part.primitiveFieldRef() = filled(eps);
    part.correctBoundaryConditions();

    const surfaceScalarField& weights = mesh.weights();
    const surfaceScalarField& perWay = mesh.nonOrthDeltaCoeffs();
    const auto inside = [&](const label celli, const scalar way)
    {
        return side{way, max(mu[celli], VSMALL), drag[celli], part[celli]};
    };
    forAll(result, facei)
    {
        result[facei] = between
        (
            inside(mesh.owner()[facei], (1 - weights[facei])/perWay[facei]),
            inside(mesh.neighbour()[facei], weights[facei]/perWay[facei])
        );
    }
    forAll(result.boundaryField(), patchi)
    {
        fvsPatchScalarField& patch = result.boundaryFieldRef()[patchi];
        const labelUList& cells = patch.patch().faceCells();
        const scalarField& perWayHere = perWay.boundaryField()[patchi];
        if (patch.coupled())
        {
            const auto beyond = [patchi](const volScalarField& field)
            {
                return field.boundaryField()[patchi].patchNeighbourField();
            };
            const scalarField& weight = weights.boundaryField()[patchi];
            const scalarField muN(max(beyond(mu), VSMALL));
            const scalarField dragN(beyond(drag)), partN(beyond(part));
            forAll(patch, i)
            {
                patch[i] = between
                (
                    inside(cells[i], (1 - weight[i])/perWayHere[i]),
                    {weight[i]/perWayHere[i], muN[i], dragN[i], partN[i]}
                );
            }
        }
        else
        {
            // A wall's own, which a model of turbulence may have far off the cell's
            const scalarField& muHere = mu.boundaryField()[patchi];
            forAll(patch, i)
            {
                side P(inside(cells[i], 1/perWayHere[i]));
                P.mu = max(muHere[i], VSMALL);
                patch[i] = P.way/P.resistance() - muHere[i];
            }
        }
    }
    return tresult;
}


Foam::tmp<Foam::volVectorField> Foam::forceAcross
(
    const surfaceScalarField& viscosity,
    const volVectorField& U
)
{
    const fvMesh& mesh = U.mesh();
    const surfaceVectorField n(mesh.Sf()/mesh.magSf());
    return fvc::div(viscosity*mesh.magSf()*n*(n & fvc::snGrad(U)));
}
