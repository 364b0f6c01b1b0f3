/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutConduction.H"

#include "cellHeat.H"
#include "cutSlopes.H"

Foam::cutConduction::cutConduction(const grainSystem& bodies)
:
    bodies_(bodies),
    cells_(bodies)
{}


Foam::scalar Foam::cutConduction::perConductivity(const cutCells::wall& x) const
{
    const fvMesh& mesh = bodies_.mesh();
    if (cells_.fluid()[x.cell] <= 0)
    {
        return x.share*mesh.V()[x.cell]/sqr(cells_.cellSize(x.cell));
    }
    // Of a wedge that is all corner
    constexpr scalar most = 3;

    const scalar squares = sqr(x.distance) + cells_.spreadAlong(x);
    const scalar curvature = (mesh.nGeometricD() - 1)/x.radius;
    return
        mag(x.area)/x.distance
       *(1 + min(0.5*squares*curvature/x.distance, most));
}


Foam::tmp<Foam::scalarField> Foam::cutConduction::toSurface
(
    const label patchi
) const
{
    // Of a wedge the fluid is as near to the patch as it is
    constexpr scalar nearest = 1e-4;

    const fvPatch& patch = cells_.fluid().mesh().boundary()[patchi];
    const scalarField way
    (
        1
      - patch.deltaCoeffs()
       *(patch.nf() & cells_.shift().boundaryField()[patchi].patchInternalField())
    );
    return max(way, cutCells::nearest)/max(way, nearest);
}


Foam::tmp<Foam::surfaceScalarField> Foam::cutConduction::ratio
(
    const volScalarField& x,
    const surfaceValue& atSurface
) const
{
    constexpr scalar least = 0.1, most = 3;

    const fvMesh& mesh = x.mesh();
    const cutSlopes<scalar> slopes
    (
        cells_,
        x,
        [&](const label walli) { return atSurface(cells_.walls()[walli].grain); }
    );
    tmp<surfaceScalarField> tratio(slopes.besideTheLine());
    surfaceScalarField& ratio = tratio.ref();
    const auto set = [](scalar& result, const scalar alone)
    {
        result =
            mag(alone) > VSMALL ? min(max(1 + result/alone, least), most) : 1;
    };
    const surfaceScalarField perLength
    (
        cells_.conductance()*mesh.nonOrthDeltaCoeffs()
    );
    forAll(mesh.owner(), i)
    {
        set
        (
            ratio[i], perLength[i]*(x[mesh.neighbour()[i]] - x[mesh.owner()[i]])
        );
    }
    forAll(mesh.boundary(), patchi)
    {
        fvsPatchScalarField& atPatch = ratio.boundaryFieldRef()[patchi];
        const fvPatchScalarField& xPatch = x.boundaryField()[patchi];
        if (!xPatch.coupled())
        {
            atPatch =
                givesTemperature(xPatch)
              ? toSurface(patchi)
              : tmp<scalarField>
                (
                    cells_.open().boundaryField()[patchi]
                   /max(cells_.conductance().boundaryField()[patchi], VSMALL)
                );
            continue;
        }
        const scalarField jump
        (
            xPatch.patchNeighbourField() - xPatch.patchInternalField()
        );
        forAll(jump, i)
        {
            set(atPatch[i], perLength.boundaryField()[patchi][i]*jump[i]);
        }
    }
    ratio.dimensions().reset(dimless);
    return tratio;
}
