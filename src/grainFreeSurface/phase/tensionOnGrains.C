/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tensionOnGrains.H"

#include "combineOverRanks.H"
#include "fvc.H"
#include "reconstruction.H"
#include "spreadToNeighbours.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

using namespace Foam;

//- Layers of cells around those of a grain, beyond which the fraction and its
//  gradient know of no grain
constexpr label layers = 2;


//- Index of the grain that has most of each locked cell, plus one; 0 for others
volScalarField grainsOfCells
(
    const grainSystem& grains,
    const volScalarField& locked
)
{
    const fvMesh& mesh = locked.mesh();
    volScalarField result
    (
        IOobject("grainOfCell", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    scalarField most(mesh.nCells(), Zero);
    const overlapList& overlaps = grains.overlaps();
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            if (locked[o.cell] > 0.5 && o.volume > most[o.cell])
            {
                most[o.cell] = o.volume;
                result[o.cell] = graini + 1;
            }
        }
    }
    return result;
}


//- Stress of tension through faces [N]
surfaceVectorField stressOfFaces(const twoFluids& fluid)
{
    const surfaceVectorField gradient
    (
        fvc::interpolate(fvc::grad(fluid.alpha()))
    );
    const surfaceVectorField& S = gradient.mesh().Sf();
    const surfaceScalarField size
    (
        max
        (
            mag(gradient),
            dimensionedScalar("small", dimless/dimLength, VSMALL)
        )
    );
    return
        fvc::interpolate(fluid.sigma())
       *(size*S - gradient*(gradient & S)/size);
}


void addStress
(
    const surfaceVectorField& stress,
    const volScalarField& grainOf,
    vectorField& force
)
{
    const fvMesh& mesh = grainOf.mesh();
    const auto add =
        [&](const label celli, const scalar beyond, const vector& value)
        {
            const label graini = label(grainOf[celli] + 0.5) - 1;
            if (graini >= 0 && mag(grainOf[celli] - beyond) > 0.5)
            {
                force[graini] += value;
            }
        };
    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        add(P, grainOf[N], stress[facei]);
        add(N, grainOf[P], -stress[facei]);
    }
    forAll(grainOf.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = grainOf.boundaryField()[patchi];
        const scalarField beyond
        (
            patch.coupled()
          ? patch.patchNeighbourField()
          : tmp<scalarField>(new scalarField(patch.size(), -1))
        );
        forAll(patch, i)
        {
            add
            (
                patch.patch().faceCells()[i],
                beyond[i],
                stress.boundaryField()[patchi][i]
            );
        }
    }
}

}


Foam::tmp<Foam::volVectorField> Foam::tensionOnGrains
(
    const twoFluids& fluid,
    const grainSystem& grains,
    const volScalarField& locked
)
{
    const fvMesh& mesh = locked.mesh();
    if
    (
        gMax(locked.primitiveField()) < 0.5
     || gMax(fluid.sigma()().primitiveField()) <= 0
    )
    {
        return tmp<volVectorField>();
    }
    volScalarField grainOf(grainsOfCells(grains, locked));
    const scalarField own(grainOf.primitiveField());
    for (label i = 0; i < layers; ++i)
    {
        spreadToNeighbours(grainOf);
    }
    grainOf.correctBoundaryConditions();

    const label nGrains = grains.overlaps().nGrains();
    vectorField force(nGrains, Zero);
    scalarField volume(nGrains, Zero);
    addStress(stressOfFaces(fluid), grainOf, force);
    const volVectorField inCells(reconstructed(fluid.tensionOfFaces()*mesh.magSf()));
    forAll(own, celli)
    {
        const label graini = label(grainOf[celli] + 0.5) - 1;
        if (graini >= 0)
        {
            force[graini] -= mesh.V()[celli]*inCells[celli];
            volume[graini] += own[celli] > 0.5 ? mesh.V()[celli] : 0;
        }
    }
    sumOverRanks(force);
    sumOverRanks(volume);

    tmp<volVectorField> tresult
    (
        new volVectorField
        (
            IOobject("tensionOnGrains", mesh.time().timeName(), mesh),
            mesh,
            dimensionedVector(dimForce/dimVolume, Zero)
        )
    );
    volVectorField& result = tresult.ref();
    forAll(own, celli)
    {
        const label graini = label(own[celli] + 0.5) - 1;
        if (graini >= 0)
        {
            result[celli] = force[graini]/volume[graini];
        }
    }
    return tresult;
}
