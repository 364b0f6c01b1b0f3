/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "weightOnFaces.H"

#include "linear.H"
#include "meshPeriod.H"
#include "referenceHeight.H"

Foam::weightOnFaces::weightOnFaces
(
    const fvMesh& mesh,
    const dimensionedVector& g
)
:
    mesh_(mesh),
    g_(g),
    ghRef_(ghRef(mesh, g))
{}


void Foam::weightOnFaces::requireLevelPeriods() const
{
    // Vertices are written with a finite number of digits
    constexpr scalar roundOff = 1e-6;

    const vector& g = g_.value();
    for (const vector& apart : cyclicSeparations(mesh_))
    {
        if (mag(g & apart) > roundOff*mag(g)*mag(apart))
        {
            FatalErrorInFunction
                << "Keyword 'value' of constant/g has the value " << g
                << ", with a part along the way " << apart
                << " from a cyclic patch to its neighbour" << nl
                << "    allowed: gravity across it, as the weight of the fluid is"
                << " not uniform" << exit(FatalError);
        }
    }
}


Foam::tmp<Foam::volScalarField> Foam::weightOnFaces::gh() const
{
    tmp<volScalarField> tgh
    (
        new volScalarField
        (
            IOobject("ghOfWeight", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(ghRef_.dimensions(), Zero)
        )
    );
    volScalarField& gh = tgh.ref();
    gh.primitiveFieldRef() =
        (g_.value() & mesh_.C().primitiveField()) - ghRef_.value();
    gh.correctBoundaryConditions();
    for (fvPatchScalarField& patch : gh.boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch == (g_.value() & patch.patch().Cf()) - ghRef_.value();
        }
    }
    return tgh;
}


Foam::tmp<Foam::surfaceScalarField> Foam::weightOnFaces::heights() const
{
    const tmp<volScalarField> tgh(gh());
    const volScalarField& gh = tgh();
    tmp<surfaceScalarField> tresult
    (
        new surfaceScalarField
        (
            IOobject("ghOfFaces", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(gh.dimensions(), Zero)
        )
    );
    surfaceScalarField& result = tresult.ref();

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    forAll(neighbour, facei)
    {
        result[facei] = 0.5*(gh[owner[facei]] + gh[neighbour[facei]]);
    }
    forAll(result.boundaryField(), patchi)
    {
        const fvPatchScalarField& ghP = gh.boundaryField()[patchi];
        const scalarField inside(ghP.patchInternalField());
        if (ghP.coupled())
        {
            result.boundaryFieldRef()[patchi] =
                0.5*(inside + ghP.patchNeighbourField());
        }
        else
        {
            result.boundaryFieldRef()[patchi] = 0.5*(inside + ghP);
        }
    }
    return tresult;
}


Foam::tmp<Foam::surfaceScalarField> Foam::weightOnFaces::difference
(
    const volScalarField& rho,
    const surfaceScalarField& gh
) const
{
    tmp<surfaceScalarField> tresult
    (
        new surfaceScalarField
        (
            IOobject("weightDifference", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(gh.dimensions()*rho.dimensions(), Zero)
        )
    );
    surfaceScalarField& result = tresult.ref();
    result.setOriented();

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    forAll(neighbour, facei)
    {
        result[facei] = gh[facei]*(rho[neighbour[facei]] - rho[owner[facei]]);
    }
    forAll(result.boundaryField(), patchi)
    {
        const fvPatchScalarField& rhoP = rho.boundaryField()[patchi];
        const fvsPatchScalarField& ghP = gh.boundaryField()[patchi];
        const scalarField inside(rhoP.patchInternalField());
        if (rhoP.coupled())
        {
            result.boundaryFieldRef()[patchi] =
                ghP*(rhoP.patchNeighbourField() - inside);
        }
        else
        {
            result.boundaryFieldRef()[patchi] = ghP*(rhoP - inside);
        }
    }
    return tresult;
}


Foam::tmp<Foam::volVectorField> Foam::weightOnFaces::gradient
(
    const surfaceScalarField& difference
) const
{
    tmp<volVectorField> tresult
    (
        new volVectorField
        (
            IOobject("weightGradient", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedVector(difference.dimensions()/dimLength, Zero)
        )
    );
    volVectorField& result = tresult.ref();
    const surfaceVectorField& S = mesh_.Sf();
    const surfaceScalarField& w = mesh_.weights();

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    forAll(neighbour, facei)
    {
        result[owner[facei]] += (1 - w[facei])*difference[facei]*S[facei];
        result[neighbour[facei]] += w[facei]*difference[facei]*S[facei];
    }
    forAll(result.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const fvsPatchScalarField& d = difference.boundaryField()[patchi];
        forAll(patch.faceCells(), i)
        {
            const scalar share =
                patch.coupled() ? 1 - w.boundaryField()[patchi][i] : 1;

            result[patch.faceCells()[i]] += share*d[i]*patch.Sf()[i];
        }
    }
    result.primitiveFieldRef() /= mesh_.V().field();
    result.correctBoundaryConditions();
    return tresult;
}


Foam::tmp<Foam::surfaceScalarField> Foam::weightOnFaces::force
(
    const volScalarField& rho
) const
{
    return force(rho, heights());
}


Foam::tmp<Foam::surfaceScalarField> Foam::weightOnFaces::force
(
    const volScalarField& rho,
    const surfaceScalarField& gh
) const
{
    const surfaceScalarField difference(this->difference(rho, gh));
    surfaceScalarField correction
    (
        mesh_.nonOrthCorrectionVectors()
      & linear<vector>(mesh_).interpolate(gradient(difference))
    );
    correction.setOriented();
    surfaceScalarField straight(mesh_.nonOrthDeltaCoeffs()*difference);
    straight.setOriented();
    tmp<surfaceScalarField> tforce
    (
        new surfaceScalarField
        (
            "weightOnFaces",
            straight + correction
        )
    );
    surfaceScalarField& force = tforce.ref();

    // As fvPatchField::snGrad
    forAll(force.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!patch.coupled())
        {
            force.boundaryFieldRef()[patchi] =
                patch.deltaCoeffs()*difference.boundaryField()[patchi];
        }
    }
    force *= mesh_.magSf();
    return tforce;
}
