/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellsOnLine.H"

#include "DynamicList.H"

namespace
{

//- A point near by, so that a line that lies on faces passes cells on one of their
//  sides, that of the middle of the mesh
Foam::point offFaces
(
    const Foam::fvMesh& mesh,
    const Foam::point& p,
    const Foam::vector& direction
)
{
    using namespace Foam;
    const boundBox bounds(mesh.bounds());
    vector across(bounds.centre() - p);
    across -= (across & direction)*direction;
    if (mag(across) < 1e-6*bounds.mag())
    {
        across = vector(1, 0.7, 0.4);
        across -= (across & direction)*direction;
    }
    const scalar distance = 1e-6*std::cbrt(gMin(mesh.cellVolumes()));
    const vector step(distance/mag(across)*across);
    const vector aside(0.3*(direction ^ step));
    const point q(p + step + aside);
    return bounds.contains(q) ? q : p + step - aside;
}

}


Foam::List<Foam::cellOnLine> Foam::cellOnLine::list
(
    const fvMesh& mesh,
    const point& p,
    const vector& direction
)
{
    const vectorField& S = mesh.faceAreas();
    const pointField& C = mesh.faceCentres();

    const point q(offFaces(mesh, p, direction));

    DynamicList<cellOnLine> result;
    forAll(mesh.cells(), celli)
    {
        scalar begin = -GREAT, end = GREAT;
        for (const label facei : mesh.cells()[celli])
        {
            const bool isOwn = mesh.faceOwner()[facei] == celli;
            const vector n((isOwn ? S[facei] : -S[facei])/mag(S[facei]));
            const scalar slope = n & direction;
            const scalar outside = n & (q - C[facei]);
            if (slope > ROOTSMALL)
            {
                end = min(end, -outside/slope);
            }
            else if (slope < -ROOTSMALL)
            {
                begin = max(begin, -outside/slope);
            }
            else if (outside > 0)
            {
                end = -GREAT;
            }
        }
        if (end - begin > 1e-9*std::cbrt(mesh.cellVolumes()[celli]))
        {
            result.append({celli, begin, end});
        }
    }
    return List<cellOnLine>(std::move(result));
}
