/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainWalls.H"

#include "dictionaryInput.H"
#include "emptyPolyPatch.H"
#include "ListOps.H"
#include "polyBoundaryMesh.H"
#include "Pstream.H"
#include "triSurface.H"
#include "wordRes.H"

namespace Foam
{

// A piece of wall in space: its two ends
typedef Pair<point> piece;

static List<piece> patchPieces(const dictionary& dict, const planarMesh& plane)
{
    const polyBoundaryMesh& patches = plane.mesh().boundaryMesh();
    const wordRes names(dict.get<wordRes>("patches"));

    for (const wordRe& name : names)
    {
        if (findMatchingStrings(wordRes({name}), patches.names()).empty())
        {
            dictionaryInput::badValue
            (
                dict, "patches", name,
                "patches of the mesh " + dictionaryInput::listed(patches.names())
            );
        }
    }

    DynamicList<piece> pieces;
    for (const label patchi : patches.patchSet(names).sortedToc())
    {
        const polyPatch& patch = patches[patchi];
        if (isA<emptyPolyPatch>(patch))
        {
            dictionaryInput::badValue
            (
                dict, "patches", patch.name(),
                "patches whose type is not 'empty'"
            );
        }

        // The edge of a face that lies in front or behind
        for (const face& f : patch)
        {
            for (label i = 0; i < f.size(); ++i)
            {
                const point& p = patch.points()[f[i]];
                const point& q = patch.points()[f.nextLabel(i)];
                if
                (
                    plane.toPlane(p) != plane.toPlane(q)
                 && plane.outOfPlane(p) < plane.middle()
                 && plane.outOfPlane(q) < plane.middle()
                )
                {
                    pieces.append(piece(p, q));
                }
            }
        }
    }

    List<List<piece>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = pieces;
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    return ListListOps::combine<List<piece>>(all, accessOp<List<piece>>());
}


static List<piece> surfacePieces
(
    const dictionary& dict,
    const planarMesh& plane
)
{
    const Time& runTime = plane.mesh().time();
    const fileName file
    (
        runTime.globalPath()/runTime.constant()/"triSurface"
       /dict.get<fileName>("file")
    );
    if (!isFile(file))
    {
        dictionaryInput::badValue(dict, "file", file, "a file that exists");
    }
    const triSurface surface(file);

    DynamicList<piece> pieces;
    for (const labelledTri& tri : surface)
    {
        DynamicList<point> cut;
        forAll(tri, i)
        {
            const point& p = surface.points()[tri[i]];
            const point& q = surface.points()[tri[tri.fcIndex(i)]];
            const scalar hp = plane.outOfPlane(p) - plane.middle();
            const scalar hq = plane.outOfPlane(q) - plane.middle();

            if ((hp < 0) != (hq < 0))
            {
                cut.append(p + hp/(hp - hq)*(q - p));
            }
        }
        if (cut.size() == 2 && plane.toPlane(cut[0]) != plane.toPlane(cut[1]))
        {
            pieces.append(piece(cut[0], cut[1]));
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
    return pieces;
}

} // End namespace Foam


nscd::Walls<2> Foam::readGrainWalls
(
    const dictionary& dict,
    const planarMesh& plane,
    const grainMaterials& materials
)
{
    nscd::Walls<2> walls;

    for (const word& name : dict.toc())
    {
        const dictionary& wall = dictionaryInput::subDict(dict, name);
        const word type(wall.get<word>("type"));
        const label material = materials.index(wall, "material");

        List<piece> pieces;
        if (type == "patches")
        {
            dictionaryInput::checkKeywords
            (
                wall, {"type", "patches", "material"}
            );
            pieces = patchPieces(wall, plane);
        }
        else if (type == "surface")
        {
            dictionaryInput::checkKeywords(wall, {"type", "file", "material"});
            pieces = surfacePieces(wall, plane);
        }
        else
        {
            dictionaryInput::badValue(wall, "type", type, "patches, surface");
        }

        for (const piece& p : pieces)
        {
            walls.push_back
            ({
                plane.toPlane(p.first()), plane.toPlane(p.second()),
                int(material)
            });
        }
    }
    return mergedSegments(walls);
}
