/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wetFaces.H"

#include "cutCell.H"

namespace
{

using namespace Foam;

//- A cell as a face sees it
struct faceSide
{
    scalar alpha;

    scalar level;

    bool isFull() const { return alpha >= 1; }
    bool isEmpty() const { return alpha <= 0; }
};


//- Parts of a face that are below the levels of its cells, the lesser first
Pair<scalar> wetParts
(
    const faceSide& P,
    const faceSide& N,
    const face& corners,
    const pointField& points,
    const vector& up
)
{
    const auto part = [&](const faceSide& side) -> scalar
    {
        return
            side.isFull() ? 1
          : side.isEmpty() ? 0
          : shareBelow(corners, points, up, side.level);
    };
    const scalar ofP = part(P), ofN = part(N);
    return Pair<scalar>(min(ofP, ofN), max(ofP, ofN));
}


scalar limited(const scalar value, const scalar flux, const Pair<scalar>& parts)
{
    const scalar a = flux*parts.first(), b = flux*parts.second();
    return max(min(value, max(a, b)), min(a, b));
}

}


Foam::scalar Foam::shareBelow
(
    const face& corners,
    const pointField& points,
    const vector& up,
    const scalar height
)
{
    const point middle(corners.centre(points));
    scalar wet = 0, all = 0;
    forAll(corners, i)
    {
        const point& a = points[corners[i]];
        const point& b = points[corners.nextLabel(i)];
        const scalar area = mag((a - middle) ^ (b - middle));
        wet += area*cutCell::shareBelow(a & up, b & up, middle & up, height);
        all += area;
    }
    return wet/all;
}


void Foam::limitToWetFaces
(
    const surfaceScalarField& flux,
    const volScalarField& levels,
    const volScalarField& alpha,
    const vector& up,
    surfaceScalarField& alphaFlux
)
{
    const fvMesh& mesh = flux.mesh();
    const faceList& faces = mesh.faces();
    const pointField& points = mesh.points();

    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        alphaFlux[facei] = limited
        (
            alphaFlux[facei], flux[facei],
            wetParts
            (
                {alpha[P], levels[P]}, {alpha[N], levels[N]},
                faces[facei], points, up
            )
        );
    }
    forAll(levels.boundaryField(), patchi)
    {
        const fvPatchScalarField& level = levels.boundaryField()[patchi];
        if (!level.coupled())
        {
            continue;
        }
        const labelUList& cells = level.patch().faceCells();
        const scalarField levelN(level.patchNeighbourField());
        const scalarField alphaN
        (
            alpha.boundaryField()[patchi].patchNeighbourField()
        );
        fvsPatchScalarField& value = alphaFlux.boundaryFieldRef()[patchi];
        forAll(cells, i)
        {
            value[i] = limited
            (
                value[i], flux.boundaryField()[patchi][i],
                wetParts
                (
                    {alpha[cells[i]], levels[cells[i]]}, {alphaN[i], levelN[i]},
                    faces[level.patch().start() + i], points, up
                )
            );
        }
    }
}
