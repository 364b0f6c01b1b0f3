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


//- Grains in the order of their labels, or in the opposite one: of two that are as
//  near to a cell one order has the first, the other the second
struct grainOrder
{
    label nGrains;
    bool isReversed;

    label grain(const label place) const
    {
        return isReversed ? nGrains - 1 - place : place;
    }
};


//- Place in the order, plus one, of the grain that has most of each locked cell; 0
//  for others
volScalarField grainsOfCells
(
    const grainSystem& grains,
    const volScalarField& locked,
    const grainOrder& order
)
{
    // Differences of volumes that are the same
    constexpr scalar roundOff = 1e-9;

    const fvMesh& mesh = locked.mesh();
    volScalarField result
    (
        IOobject("grainOfCell", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    scalarField most(mesh.nCells(), Zero);
    for (label place = 0; place < order.nGrains; ++place)
    {
        for (const cellOverlap& o : grains.overlaps().of(order.grain(place)))
        {
            if
            (
                locked[o.cell] > 0.5
             && o.volume > (1 + roundOff)*most[o.cell]
            )
            {
                most[o.cell] = o.volume;
                result[o.cell] = place + 1;
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
            const label place = label(grainOf[celli] + 0.5) - 1;
            if (place >= 0 && mag(grainOf[celli] - beyond) > 0.5)
            {
                force[place] += value;
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

//- Add part of the force on the cells of each grain, over their volume
void addForce
(
    const surfaceVectorField& stress,
    const volVectorField& inCells,
    const volScalarField& own,
    const label nGrains,
    const scalar part,
    volVectorField& result
)
{
    const scalarField& V = own.mesh().V().field();
    volScalarField grainOf("grainAround", own);
    for (label i = 0; i < layers; ++i)
    {
        spreadToNeighbours(grainOf);
    }
    grainOf.correctBoundaryConditions();

    vectorField force(nGrains, Zero);
    scalarField volume(nGrains, Zero);
    addStress(stress, grainOf, force);
    forAll(V, celli)
    {
        const label place = label(grainOf[celli] + 0.5) - 1;
        if (place >= 0)
        {
            force[place] -= V[celli]*inCells[celli];
            volume[place] += own[celli] > 0.5 ? V[celli] : 0;
        }
    }
    sumOverRanks(force);
    sumOverRanks(volume);
    forAll(V, celli)
    {
        const label place = label(own[celli] + 0.5) - 1;
        if (place >= 0)
        {
            result[celli] += part*force[place]/volume[place];
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
    tmp<volVectorField> tresult
    (
        new volVectorField
        (
            IOobject("tensionOnGrains", mesh.time().timeName(), mesh),
            mesh,
            dimensionedVector(dimForce/dimVolume, Zero)
        )
    );
    const surfaceVectorField stress(stressOfFaces(fluid));
    const volVectorField inCells
    (
        reconstructed(fluid.tensionOfFaces()*mesh.magSf())
    );
    const label nGrains = grains.overlaps().nGrains();
    for (const bool isReversed : {false, true})
    {
        addForce
        (
            stress,
            inCells,
            grainsOfCells(grains, locked, {nGrains, isReversed}),
            nGrains,
            0.5,
            tresult.ref()
        );
    }
    return tresult;
}
