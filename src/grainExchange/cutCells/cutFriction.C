/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"
#include "cutNeighbours.H"

#include "fvc.H"
#include "Spalding.H"

namespace
{

using namespace Foam;

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


//- A velocity near a wall and that of the cells ahead, along the wall and against
//  it, in the mean over cells
struct profile
{
    scalar near;
    scalar distance;

    //- Of the distances of the fluid in the cell, in the mean [m^2]
    scalar squares;

    scalar ahead;
    scalar distanceAhead;

    //- Of the distances of the fluid ahead from its middle [m^2]
    scalar spreadAhead;

    //- Of a parabola with its top in the cells ahead, or of the one through both
    //  velocities and the wall, whichever is more [1/m/s]
    scalar curvature() const
    {
        const scalar y = distanceAhead;
        const scalar withTop =
            2*ahead/max(sqr(y) - spreadAhead, sqr(y)/2);
        const scalar throughBoth =
            2*(y*near/distance - ahead)
           /max(sqr(y) + spreadAhead - y*squares/distance, spreadAhead);
        return max(withTop, throughBoth);
    }
};

}


Foam::scalar Foam::cutGrains::linkOfLine(const label walli) const
{
    const cutCells::wall& x = cells_.walls()[walli];
    return
        cells_.fluid()[x.cell] > 0
      ? fluid_.mu()[x.cell]*mag(x.area)/x.distance
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


Foam::cutCurvature Foam::cutGrains::setLinks
(
    const volVectorField& U,
    const surfaceScalarField& mu
) const
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
        normal[x.cell] += x.share*x.normal;
    }

    List<cellsAhead> ahead(mesh_.nCells());
    forCutNeighbours
    (
        cells_,
        U,
        [&](const label c, const cutNeighbour<vector>& x)
        {
            const scalar along = max(normal[c] & x.out, scalar(0));
            ahead[c].add(sqr(along)*pow4(x.fluid), x.value, x.way);
        }
    );

    const volScalarField& p = mesh_.lookupObject<volScalarField>("p_rgh");
    const volVectorField gradP
    (
        gradientInOpen(fvc::snGrad(p)*mesh_.magSf())
    );
    // By small grains
    const scalarField thicker
    (
        (
            fvc::average(mu)
           /max
            (
                fvc::average(fvc::interpolate(fluid_.muStress())),
                dimensionedScalar("small", dimDynamicViscosity, VSMALL)
            )
        )().primitiveField()
    );
    const scalarField moving(movingShare()().primitiveField());
    const scalarField& open = cells_.fluid();
    const scalarField& rho = fluid_.rho();
    cutCurvature result(cells_, mesh_);
    forAll(walls, i)
    {
        const cutCells::wall& x = walls[i];
        const label c = x.cell;
        const vector& n = x.normal;
        const vector v(motion_[x.grain].at(x.arm));
        const vector slip((U[c] - v) - ((U[c] - v) & n)*n);
        const scalar speed = mag(slip);
        link_[i] = thicker[c]*linkOfLine(i);
        if (link_[i] == 0 || speed < VSMALL)
        {
            continue;
        }
        const scalar viscosity = thicker[c]*fluid_.mu()[c];
        if (fluid_.isTurbulent())
        {
            link_[i] *= wallShearRatio(rho[c]*speed*x.distance/viscosity);
        }
        const vector drive
        (
            (moving[c]*gradP[c] + small_->beta[c]*v - small_->b[c])/open[c]
        );
        const scalar share = min(ahead[c].share, scalar(1));
        const scalar squares = sqr(x.distance) + cells_.spreadAlong(x);

        // Less than that of a parabola here, or of one that the cells ahead are on
        scalar largest = 3*(1 - share)*speed/sqr(x.distance);
        if (share > SMALL)
        {
            const scalar y =
                x.distance
              + max(ahead[c].way/ahead[c].share & n, cells_.cellSize(c)/4);
            const vector beyond(ahead[c].velocity/ahead[c].share - v);
            const vector along(beyond - (beyond & n)*n);
            const profile both
            {
                speed, x.distance, squares,
                max(along & slip, scalar(0))/speed, y,
                n & (cells_.spreadOfWhole(c) & n)
            };
            const scalar Re = rho[c]*mag(along)*y/viscosity;
            largest += share*both.curvature()/(1 + sqr(Re/thin));
        }
        const scalar curvature =
            (mesh_.nGeometricD() - 1)*speed/(x.radius*x.distance)
          - (drive & slip)/(viscosity*speed);
        const scalar bounded = max(min(curvature, largest), scalar(0));
        link_[i] *= 1 + min(squares*bounded/(2*speed), most);
        result.add(x, -bounded*slip/speed);
    }
    return result;
}
