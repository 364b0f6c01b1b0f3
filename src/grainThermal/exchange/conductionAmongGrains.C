/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conductionAmongGrains.H"

#include "dictionaryInput.H"
#include "heatDimensions.H"

Foam::conductionAmongGrains::conductionAmongGrains(const grainSystem& grains)
:
    grains_(grains),
    law_
    (
        effectiveConductivity::New
        (
            grains.motion().coupling(), grains.mesh().nGeometricD()
        )
    )
{
    if (!isActive())
    {
        return;
    }
    const dictionary& materials =
        grains.motion().coupling().parent().subDict("materials");
    for (const word& name : materials.toc())
    {
        // Those of grains have a heat capacity
        const dictionary& material = materials.subDict(name);
        if (material.found("heatCapacity"))
        {
            dictionaryInput::getPositive(material, "conductivity", dimConductivity);
        }
    }
}


Foam::scalarField Foam::conductionAmongGrains::ofGrains
(
    const scalarField& kappa,
    const resolvedTerm& resolved
) const
{
    const scalar others = law_->nDimensions() - 1;
    const overlapList& overlaps = grains_.overlaps();
    const scalarField& V = grains_.mesh().V();
    scalarField weighted(V.size(), Zero);
    scalarField volume(V.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (resolved.isResolved(graini))
        {
            continue;
        }
        const scalar k = grains_.temperatures().conductivity(graini);
        for (const cellOverlap& o : overlaps.of(graini))
        {
            const scalar kFluid = kappa[o.cell];
            weighted[o.cell] +=
                (k - kFluid)/(k + others*kFluid)*o.volume/V[o.cell];
            volume[o.cell] += o.volume/V[o.cell];
        }
    }
    grains_.voidFraction().smooth(weighted);
    grains_.voidFraction().smooth(volume);
    const scalarField dipole(weighted/max(volume, VSMALL));
    return kappa*(1 + others*dipole)/max(1 - dipole, SMALL);
}


Foam::tmp<Foam::volScalarField> Foam::conductionAmongGrains::ratio
(
    const volScalarField& open,
    const volScalarField& kappa,
    const resolvedTerm& resolved
) const
{
    tmp<volScalarField> result(new volScalarField("conductivityRatio", open));
    const scalarField k(ofGrains(kappa.primitiveField(), resolved));
    scalarField& inside = result.ref().primitiveFieldRef();
    forAll(inside, celli)
    {
        inside[celli] = law_->ratio(open[celli], k[celli]/kappa[celli]);
    }
    for (fvPatchScalarField& patch : result.ref().boundaryFieldRef())
    {
        const fvPatchScalarField& kappaThere =
            kappa.boundaryField()[patch.patch().index()];
        const labelUList& cells = patch.patch().faceCells();
        forAll(patch, facei)
        {
            patch[facei] =
                law_->ratio(patch[facei], k[cells[facei]]/kappaThere[facei]);
        }
    }
    result.ref().correctBoundaryConditions();
    return result;
}
