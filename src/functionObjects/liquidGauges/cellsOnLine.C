/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellsOnLine.H"

#include "DynamicList.H"

Foam::List<Foam::cellOnLine> Foam::cellOnLine::list
(
    const fvMesh& mesh,
    const point& p,
    const vector& direction
)
{
    const vectorField& S = mesh.faceAreas();
    const pointField& C = mesh.faceCentres();

    DynamicList<cellOnLine> result;
    forAll(mesh.cells(), celli)
    {
        scalar begin = -GREAT, end = GREAT;
        for (const label facei : mesh.cells()[celli])
        {
            const bool isOwn = mesh.faceOwner()[facei] == celli;
            const vector n((isOwn ? S[facei] : -S[facei])/mag(S[facei]));
            const scalar slope = n & direction;
            const scalar outside = n & (p - C[facei]);
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
