/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletFaces.H"


Foam::List<Foam::dropletFace> Foam::dropletFace::list
(
    const dropletTerm& term,
    const surfaceScalarField& conductivity
)
{
    const fvMesh& mesh = conductivity.mesh();
    volScalarField droplet
    (
        IOobject("dropletOfCell", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("none", dimless, -1)
    );
    forAll(droplet, celli)
    {
        droplet[celli] = term.dropletOf(celli);
    }
    droplet.correctBoundaryConditions();

    const surfaceScalarField conductance
    (
        term.conductance()*mesh.magSf()*mesh.nonOrthDeltaCoeffs()
    );

    DynamicList<dropletFace> result;
    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        if ((droplet[P] < 0) != (droplet[N] < 0))
        {
            const bool isOwner = droplet[P] < 0;
            result.append
            ({
                isOwner ? P : N, label(droplet[isOwner ? N : P]),
                mesh.magSf()[facei], conductance[facei], conductivity[facei]
            });
        }
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatchScalarField& d = droplet.boundaryField()[patchi];
        if (!d.coupled())
        {
            continue;
        }
        const scalarField own(d.patchInternalField());
        const scalarField neighbour(d.patchNeighbourField());
        forAll(d, i)
        {
            if (own[i] < 0 && neighbour[i] >= 0)
            {
                result.append
                ({
                    d.patch().faceCells()[i], label(neighbour[i]),
                    d.patch().magSf()[i], conductance.boundaryField()[patchi][i],
                    conductivity.boundaryField()[patchi][i]
                });
            }
        }
    }
    return List<dropletFace>(std::move(result));
}
