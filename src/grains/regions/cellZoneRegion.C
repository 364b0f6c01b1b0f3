/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellZoneRegion.H"

#include "dictionaryInput.H"
#include "emptyPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

addToSelection(grainRegion, grainRegions, cellZone)

namespace
{

using namespace Foam;

// Faces between a zone and what is not of it, as seen from the zone, all ranks
List<List<point>> facesAround(const dictionary& dict, const polyMesh& mesh)
{
    const wordList zones(mesh.cellZones().names());
    const word name(dictionaryInput::getWord(dict, "zone", zones));

    boolList isIn(mesh.nCells(), false);
    for (const label celli : mesh.cellZones()[name])
    {
        isIn[celli] = true;
    }
    boolList isBeyondIn;
    syncTools::swapBoundaryCellList(mesh, isIn, isBeyondIn);

    DynamicList<List<point>> local;
    for (label facei = 0; facei < mesh.nFaces(); ++facei)
    {
        const bool owner = isIn[mesh.faceOwner()[facei]];
        bool other = false;
        if (mesh.isInternalFace(facei))
        {
            other = isIn[mesh.faceNeighbour()[facei]];
        }
        else
        {
            const polyPatch& patch =
                mesh.boundaryMesh()[mesh.boundaryMesh().whichPatch(facei)];
            if (isA<emptyPolyPatch>(patch))
            {
                continue;
            }
            other =
                isA<processorPolyPatch>(patch)
             && !isA<processorCyclicPolyPatch>(patch)
             && isBeyondIn[facei - mesh.nInternalFaces()];
            // The other rank has the faces that its cells own
            if (!owner)
            {
                continue;
            }
        }
        if (owner != other)
        {
            const face& f = mesh.faces()[facei];
            local.append
            (
                List<point>(mesh.points(), owner ? f : f.reverseFace())
            );
        }
    }
    return wallPieces::gathered<List<point>>(local);
}


void addPiece
(
    wallPieceList<2>& pieces,
    const List<point>& f,
    const grainSpace<2>& space
)
{
    forAll(f, i)
    {
        const point& p = f[i];
        const point& q = f[f.fcIndex(i)];
        if
        (
            space.toPlane(p) != space.toPlane(q)
         && space.outOfPlane(p) < space.middle()
         && space.outOfPlane(q) < space.middle()
        )
        {
            pieces.push_back({space.fromSpace(p), space.fromSpace(q)});
        }
    }
}


void addPiece
(
    wallPieceList<3>& pieces,
    const List<point>& f,
    const grainSpace<3>& space
)
{
    wallFace piece;
    for (const point& p : f)
    {
        piece.vertices.push_back(space.fromSpace(p));
    }
    pieces.push_back(piece);
}


template<int D>
wallPieceList<D> piecesAround
(
    const dictionary& dict,
    const grainSpace<D>& space
)
{
    wallPieceList<D> pieces;
    for (const List<point>& f : facesAround(dict, space.mesh()))
    {
        addPiece(pieces, f, space);
    }
    return pieces;
}

}


template<int D>
Foam::grainRegions::cellZone<D>::cellZone
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    outline_(piecesAround<D>(dict, space))
{
    dictionaryInput::checkKeywords(dict, {"type", "zone"});
}
