/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Walls in the plane of a two-dimensional mesh.
\*---------------------------------------------------------------------------*/

#include "wallPieces.H"

#include "dictionaryInput.H"
#include "initialPoints.H"
#include "wallSurface.H"

namespace
{

// The two ends of a segment in space
typedef Foam::Pair<Foam::point> ends;

Foam::wallPieceList<2> segments
(
    const Foam::List<ends>& list,
    const Foam::grainSpace<2>& space
)
{
    Foam::wallPieceList<2> result;
    for (const ends& e : list)
    {
        result.push_back
        ({
            space.fromSpace(e.first()), space.fromSpace(e.second())
        });
    }
    return result;
}

}


Foam::wallPieceList<2> Foam::wallPieces::ofPatches
(
    const dictionary& dict,
    const grainSpace<2>& space
)
{
    const tmp<pointField> points(initialPoints(space.mesh()));

    DynamicList<ends> local;
    for (const label patchi : selectedPatches(dict, space.mesh()))
    {
        const polyPatch& patch = space.mesh().boundaryMesh()[patchi];

        // The edge of a face that lies in front or behind
        for (const face& f : patch)
        {
            forAll(f, i)
            {
                const point& p = points()[f[i]];
                const point& q = points()[f.nextLabel(i)];
                if
                (
                    space.toPlane(p) != space.toPlane(q)
                 && space.outOfPlane(p) < space.middle()
                 && space.outOfPlane(q) < space.middle()
                )
                {
                    local.append(ends(p, q));
                }
            }
        }
    }
    return segments(gathered<ends>(local), space);
}


Foam::wallPieceList<2> Foam::wallPieces::ofSurface
(
    const dictionary& dict,
    const grainSpace<2>& space
)
{
    const fileName file(surfaceFile(dict, space.mesh().time()));
    const triSurface surface(readWallSurface(dict, file));

    DynamicList<ends> pieces;
    for (const labelledTri& tri : surface)
    {
        DynamicList<point> cut;
        forAll(tri, i)
        {
            const point& p = surface.points()[tri[i]];
            const point& q = surface.points()[tri[tri.fcIndex(i)]];
            const scalar hp = space.outOfPlane(p) - space.middle();
            const scalar hq = space.outOfPlane(q) - space.middle();

            if ((hp < 0) != (hq < 0))
            {
                cut.append(p + hp/(hp - hq)*(q - p));
            }
        }
        if (cut.size() == 2 && space.toPlane(cut[0]) != space.toPlane(cut[1]))
        {
            pieces.append(ends(cut[0], cut[1]));
        }
    }
    if (pieces.empty())
    {
        dictionaryInput::badValue
        (
            dict, "file", file,
            "a surface that crosses the middle plane of the mesh"
        );
    }
    return segments(pieces, space);
}
