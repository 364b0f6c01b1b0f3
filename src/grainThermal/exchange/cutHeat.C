/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutHeat.H"

#include "cutSlopes.H"

Foam::cutHeat::cutHeat(const grainSystem& grains)
:
    grains_(grains),
    cells_(grains)
{}


Foam::scalar Foam::cutHeat::perConductivity(const cutCells::wall& x) const
{
    const fvMesh& mesh = grains_.mesh();
    if (cells_.fluid()[x.cell] <= 0)
    {
        return x.share*mesh.V()[x.cell]/sqr(cells_.cellSize(x.cell));
    }
    // Of a wedge that is all corner
    constexpr scalar most = 3;

    const scalar squares = sqr(x.distance) + cells_.spreadAlong(x);
    const scalar curvature = (mesh.nGeometricD() - 1)/mag(x.arm);
    return
        mag(x.area)/x.distance
       *(1 + min(0.5*squares*curvature/x.distance, most));
}


Foam::tmp<Foam::surfaceScalarField> Foam::cutHeat::ratio
(
    const volScalarField& T
) const
{
    constexpr scalar least = 0.1, most = 3;

    const fvMesh& mesh = T.mesh();
    const cutSlopes<scalar> slopes
    (
        cells_,
        T,
        [&](const label walli)
        {
            return grains_.temperatures().temperature(cells_.walls()[walli].grain);
        }
    );
    tmp<surfaceScalarField> tratio(slopes.besideTheLine());
    surfaceScalarField& ratio = tratio.ref();
    const auto set = [](scalar& x, const scalar alone)
    {
        x = mag(alone) > VSMALL ? min(max(1 + x/alone, least), most) : 1;
    };
    const surfaceScalarField perLength
    (
        cells_.conductance()*mesh.nonOrthDeltaCoeffs()
    );
    forAll(mesh.owner(), i)
    {
        set
        (
            ratio[i], perLength[i]*(T[mesh.neighbour()[i]] - T[mesh.owner()[i]])
        );
    }
    forAll(mesh.boundary(), patchi)
    {
        fvsPatchScalarField& atPatch = ratio.boundaryFieldRef()[patchi];
        const fvPatchScalarField& TPatch = T.boundaryField()[patchi];
        if (!TPatch.coupled())
        {
            atPatch =
                givesTemperature(TPatch)
              ? scalarField(atPatch.size(), 1)
              : scalarField
                (
                    cells_.open().boundaryField()[patchi]
                   /max(cells_.conductance().boundaryField()[patchi], VSMALL)
                );
            continue;
        }
        const scalarField jump
        (
            TPatch.patchNeighbourField() - TPatch.patchInternalField()
        );
        forAll(jump, i)
        {
            set(atPatch[i], perLength.boundaryField()[patchi][i]*jump[i]);
        }
    }
    ratio.dimensions().reset(dimless);
    return tratio;
}


void Foam::cutHeat::add
(
    const boolList& isResolved,
    const volScalarField& T,
    const volScalarField& kappa,
    cellHeat& cells
)
{
    cells_.update(isResolved);
    cells.conductivity *= cells_.conductance()*ratio(T);

    const scalarField& V = T.mesh().V();
    conductance_ = scalarField(grains_.overlaps().size(), Zero);
    for (const cutCells::wall& x : cells_.walls())
    {
        conductance_[x.overlap] = kappa[x.cell]*perConductivity(x);
        cells.coefficient[x.cell] += conductance_[x.overlap]/V[x.cell];
    }
}
