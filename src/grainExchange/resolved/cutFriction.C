/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"

#include "fvc.H"

namespace
{

using namespace Foam;

//- Sum of the fourth powers of the components of a unit vector along the axes of
//  a cell, which are the normals of its faces
scalar fourthPowers
(
    const fvMesh& mesh,
    const label celli,
    const vector& direction
)
{
    scalar squares = 0, fourth = 0;
    for (const label facei : mesh.cells()[celli])
    {
        const vector n(normalised(mesh.faceAreas()[facei]));
        squares += sqr(n & direction);
        fourth += pow4(n & direction);
    }
    return fourth/squares;
}


//- Means over the cells away from the surface in a cell, and how much there is of
//  them: 1 if the next one along the normal is whole, 0 in a gap
struct cellsAhead
{
    scalar share = 0;
    vector velocity = Zero;
    vector way = Zero;

    void add(const scalar weight, const vector& U, const vector& toCentroid)
    {
        share += weight;
        velocity += weight*U;
        way += weight*toCentroid;
    }
};

}


Foam::scalar Foam::cutGrains::linkOfLine(const label walli) const
{
    const cutCells::wall& x = cells_.walls()[walli];
    return
        cells_.fluid()[x.cell] > 0
      ? fluid_.muStress()[x.cell]*mag(x.area)/x.distance
      : 0;
}


Foam::tmp<Foam::volVectorField> Foam::cutGrains::gradientInOpen
(
    const surfaceScalarField& faceForce
) const
{
    // Of a face that is closed: counts for a cell that has no other in a direction
    constexpr scalar least = 1e-6;

    const surfaceVectorField weighted
    (
        max(cells_.open(), least)*mesh_.Sf()/mesh_.magSf()
    );
    return
        inv(fvc::surfaceSum(weighted*mesh_.Sf()))
      & fvc::surfaceSum(weighted*faceForce);
}


void Foam::cutGrains::setLinks(const volVectorField& U) const
{
    // Of a cell that is all of a tube; 2 of a gap between planes
    constexpr scalar most = 3;

    // Reynolds number of the cells ahead from which on a boundary layer ends before
    // them
    constexpr scalar thin = 5;

    const List<cutCells::wall>& walls = cells_.walls();
    vectorField normal(mesh_.nCells(), Zero);
    for (const cutCells::wall& x : walls)
    {
        normal[x.cell] += x.share*x.arm/mag(x.arm);
    }

    List<cellsAhead> ahead(mesh_.nCells());
    forNeighbours
    (
        U,
        [&](const label c, const neighbour& x)
        {
            const scalar along = max(normal[c] & x.out, scalar(0));
            ahead[c].add(sqr(along)*pow4(x.fluid), x.velocity, x.way);
        }
    );

    const volScalarField& p = mesh_.lookupObject<volScalarField>("p_rgh");
    const volVectorField gradP
    (
        gradientInOpen(fvc::snGrad(p)*mesh_.magSf())
    );
    const scalarField& mu = fluid_.mu();
    const scalarField& rho = fluid_.rho();
    forAll(walls, i)
    {
        const cutCells::wall& x = walls[i];
        const label c = x.cell;
        const vector n(x.arm/mag(x.arm));
        const vector v(motion_[x.grain].at(x.arm));
        const vector slip((U[c] - v) - ((U[c] - v) & n)*n);
        const scalar speed = mag(slip);
        link_[i] = linkOfLine(i);
        if (link_[i] == 0 || speed < VSMALL)
        {
            continue;
        }
        const scalar h = cells_.cellSize(c);
        const scalar share = min(ahead[c].share, scalar(1));

        // Less than that of a parabola with its top in the cells ahead, or here
        scalar largest = 3*(1 - share)*speed/sqr(x.distance);
        if (share > SMALL)
        {
            const scalar y =
                x.distance + max(ahead[c].way/ahead[c].share & n, h/4);
            const vector beyond(ahead[c].velocity/ahead[c].share - v);
            const vector along(beyond - (beyond & n)*n);
            const scalar Re = rho[c]*mag(along)*y/mu[c];
            largest +=
                2*share/(1 + sqr(Re/thin))
               *max(along & slip, scalar(0))/(speed*sqr(y));
        }
        const scalar curvature =
            (mesh_.nGeometricD() - 1)*speed/(mag(x.arm)*x.distance)
          - (gradP[c] & slip)/(mu[c]*speed);
        const scalar squaredLength =
            share*(1 + 2*fourthPowers(mesh_, c, n))/24*sqr(h)
          + (1 - share)*2.0/3*sqr(x.distance);

        // A small cell is held anyway; it must not matter when it vanishes
        link_[i] *=
            1
          + min(2*cells_.fluid()[c], scalar(1))
           *min
            (
                squaredLength/speed*max(min(curvature, largest), scalar(0)),
                most
            );
    }
}
