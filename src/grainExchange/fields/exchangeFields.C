/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exchangeFields.H"

#include "voidFractionMethod.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

//- A field that meshes that move ask for before it is set anew
Foam::IOobject kept(const Foam::word& name, const Foam::fvMesh& mesh)
{
    using namespace Foam;
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        mesh.dynamic() ? IOobject::READ_IF_PRESENT : IOobject::NO_READ,
        mesh.dynamic() ? IOobject::AUTO_WRITE : IOobject::NO_WRITE
    );
}


template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh> zeroField
(
    const Foam::fvMesh& mesh,
    const Foam::word& name,
    const Foam::dimensionSet& dims
)
{
    using namespace Foam;
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensioned<Type>(dims, Zero)
    );
}


//- Free patches have the values of their cells
template<class Type>
void correctPatches
(
    Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>& field,
    const Foam::labelHashSet& freePatches
)
{
    using namespace Foam;
    field.correctBoundaryConditions();
    for (const label patchi : freePatches)
    {
        fvPatchField<Type>& patch = field.boundaryFieldRef()[patchi];
        patch == patch.patchInternalField();
    }
}

}


Foam::exchangeFields::exchangeFields
(
    const fvMesh& mesh,
    const bool gradientActsOnGrains,
    const scalar artificialDiffusion
)
:
    fluidShare
    (
        kept("fluidShare", mesh),
        mesh,
        dimensionedScalar("one", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    kappa(zeroField<scalar>(mesh, "kappa", dimless)),
    beta(zeroField<scalar>(mesh, "beta", dimDensity/dimTime)),
    b(zeroField<vector>(mesh, "b", dimForce/dimVolume)),
    G(zeroField<vector>(mesh, "G", dimVelocity)),
    K(zeroField<scalar>(mesh, "K", dimTime/dimDensity)),
    gained(zeroField<vector>(mesh, "gained", dimVelocity)),
    mobile(zeroField<scalar>(mesh, "mobile", dimless)),
    betaOfLayers(zeroField<scalar>(mesh, "betaOfLayers", dimDensity/dimTime)),
    passing(zeroField<scalar>(mesh, "passing", dimless)),
    passingG(zeroField<vector>(mesh, "passingG", dimVelocity)),
    bBeside(zeroField<vector>(mesh, "bBeside", dimForce/dimVolume)),
    betaBeside(zeroField<scalar>(mesh, "betaBeside", dimDensity/dimTime)),
    bOfBodies(zeroField<vector>(mesh, "bOfBodies", dimForce/dimVolume)),
    betaOfBodies(zeroField<scalar>(mesh, "betaOfBodies", dimDensity/dimTime)),
    solid(zeroField<scalar>(mesh, "solid", dimless)),
    solidFlux(zeroField<vector>(mesh, "solidFlux", dimVelocity)),
    gradientOnGrains(gradientActsOnGrains),
    pressureDiffusion(artificialDiffusion)
{}


void Foam::exchangeFields::clear()
{
    kappa = dimensionedScalar(kappa.dimensions(), Zero);
    beta = dimensionedScalar(beta.dimensions(), Zero);
    b = dimensionedVector(b.dimensions(), Zero);
    G = dimensionedVector(G.dimensions(), Zero);
    K = dimensionedScalar(K.dimensions(), Zero);
    gained = dimensionedVector(gained.dimensions(), Zero);
    mobile = dimensionedScalar(mobile.dimensions(), Zero);
    betaOfLayers = dimensionedScalar(betaOfLayers.dimensions(), Zero);
    passing = dimensionedScalar(passing.dimensions(), Zero);
    passingG = dimensionedVector(passingG.dimensions(), Zero);
    bBeside = dimensionedVector(bBeside.dimensions(), Zero);
    betaBeside = dimensionedScalar(betaBeside.dimensions(), Zero);
    bOfBodies = dimensionedVector(bOfBodies.dimensions(), Zero);
    betaOfBodies = dimensionedScalar(betaOfBodies.dimensions(), Zero);
    solid = dimensionedScalar(solid.dimensions(), Zero);
    solidFlux = dimensionedVector(solidFlux.dimensions(), Zero);
}


void Foam::exchangeFields::smooth(const voidFractionMethod& method)
{
    method.smooth(kappa.primitiveFieldRef());
    method.smooth(beta.primitiveFieldRef());
    method.smooth(b.primitiveFieldRef());
    method.smooth(G.primitiveFieldRef());
    method.smooth(K.primitiveFieldRef());
    method.smooth(gained.primitiveFieldRef());
    method.smooth(mobile.primitiveFieldRef());
    method.smooth(betaOfLayers.primitiveFieldRef());
}


void Foam::exchangeFields::correctBoundaryConditions()
{
    correctPatches(kappa, freePatches);
    correctPatches(beta, freePatches);
    correctPatches(b, freePatches);
    correctPatches(G, freePatches);
    correctPatches(K, freePatches);
    correctPatches(gained, freePatches);
    correctPatches(mobile, freePatches);
    correctPatches(betaOfLayers, freePatches);
    correctPatches(passing, freePatches);
    correctPatches(passingG, freePatches);
    correctPatches(bBeside, freePatches);
    correctPatches(betaBeside, freePatches);
}
