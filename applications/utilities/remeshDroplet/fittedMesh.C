/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fittedMesh.H"

#include "cellModel.H"
#include "emptyPolyPatch.H"
#include "Time.H"

namespace
{

using namespace Foam;

// Cells are in the zones of what was at their centres
void addZones(const planarMesh& old, fvMesh& mesh)
{
    const cellZoneMesh& oldZones = old.mesh().cellZones();
    List<cellZone*> zones(oldZones.size());
    for (const cellZone& zone : oldZones)
    {
        DynamicList<label> cells;
        forAll(mesh.cellCentres(), celli)
        {
            const point& x = mesh.cellCentres()[celli];
            if (zone.whichCell(old.findCell(old.toPlane(x))) >= 0)
            {
                cells.append(celli);
            }
        }
        zones[zone.index()] =
            zone.clone(cells, zone.index(), mesh.cellZones()).ptr();
    }
    mesh.addZones(List<pointZone*>(), List<faceZone*>(), zones);
}

}


Foam::autoPtr<Foam::fvMesh> Foam::fittedMesh
(
    const planarMesh& old,
    const planarOutline& outline,
    const triangulation& triangles,
    const Time& runTime,
    const word& instance
)
{
    const polyBoundaryMesh& patches = old.mesh().boundaryMesh();
    const label n = triangles.points().size();

    // Lower ones first
    const vector across(old.spinInSpace(1)/mag(old.spinInSpace(1)));
    const scalar isAlong = cmptSum(across);
    const vector half(0.5*old.depth()*isAlong*across);
    pointField points(2*n);
    for (label i = 0; i < n; ++i)
    {
        const point x(old.positionInSpace(triangles.points()[i]));
        points[i] = x - half;
        points[n + i] = x + half;
    }

    const cellModel& prism = cellModel::ref(cellModel::PRISM);
    cellShapeList cells;
    faceList lower, upper;
    for (const FixedList<label, 3>& t : triangles.triangles())
    {
        // From below
        const label a = t[0];
        const label b = isAlong > 0 ? t[1] : t[2];
        const label c = isAlong > 0 ? t[2] : t[1];
        cells.append
        (
            cellShape(prism, labelList({a, b, c, n + a, n + b, n + c}))
        );
        lower.append(face({a, c, b}));
        upper.append(face({n + a, n + b, n + c}));
    }

    faceListList faces(patches.size());
    wordList names(patches.size());
    PtrList<dictionary> dicts(patches.size());
    for (const polyPatch& patch : patches)
    {
        const label i = patch.index();
        names[i] = patch.name();
        OStringStream entries;
        patch.write(entries);
        dicts.set(i, new dictionary(IStringStream(entries.str())()));
        dicts[i].remove("nFaces");
        dicts[i].remove("startFace");
        const List<labelPair>& sides = outline.sides()[i];
        forAll(sides, k)
        {
            const label a = sides[k].first(), b = sides[k].second();
            const label start = outline.starts()[i][k];
            faces[i].append
            (
                rotateList(face({a, b, n + b, n + a}), -start)
            );
        }
        if (isA<emptyPolyPatch>(patch) && patch.size())
        {
            const scalarField at
            (
                patch.faceCentres() & (isAlong*across)
            );
            if (min(at) < old.middle())
            {
                faces[i].append(lower);
            }
            if (max(at) > old.middle())
            {
                faces[i].append(upper);
            }
        }
    }

    const IOobject io
    (
        polyMesh::defaultRegion, instance, runTime,
        IOobject::NO_READ, IOobject::AUTO_WRITE
    );
    polyMesh shapes
    (
        IOobject("triangles", instance, runTime),
        std::move(points), cells, faces, names, dicts,
        "unmatched", emptyPolyPatch::typeName
    );
    // Made from cells, each begins at a point of theirs
    faceList ordered(shapes.faces());
    for (const polyPatch& patch : shapes.boundaryMesh())
    {
        forAll(patch, k)
        {
            face& f = ordered[patch.start() + k];
            f = rotateList(f, -f.which(faces[patch.index()][k][0]));
        }
    }
    autoPtr<fvMesh> result
    (
        new fvMesh
        (
            io, pointField(shapes.points()), std::move(ordered),
            labelList(shapes.faceOwner()), labelList(shapes.faceNeighbour())
        )
    );
    List<polyPatch*> copies(patches.size());
    forAll(copies, i)
    {
        copies[i] =
            shapes.boundaryMesh()[i].clone(result().boundaryMesh()).ptr();
    }
    result().addFvPatches(copies);
    addZones(old, result());
    result().setInstance(instance);
    return result;
}
