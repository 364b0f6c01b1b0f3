/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPieces.H"

#include "dictionaryInput.H"
#include "emptyPolyPatch.H"
#include "initialPoints.H"
#include "OSspecific.H"
#include "polyBoundaryMesh.H"
#include "processorPolyPatch.H"
#include "readGeometry.H"
#include "Time.H"
#include "wordRes.H"

#include <algorithm>

Foam::labelList Foam::wallPieces::selectedPatches
(
    const dictionary& dict,
    const polyMesh& mesh
)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const wordRes names
    (
        dictionaryInput::getAs<wordRes>
        (
            dict, "patches",
            "a list of patches of the mesh "
          + dictionaryInput::listed(patches.names())
        )
    );

    if (names.empty())
    {
        dictionaryInput::badValue
        (
            dict, "patches", "()",
            "one or more patches of the mesh "
          + dictionaryInput::listed(patches.names())
        );
    }
    for (const wordRe& name : names)
    {
        const wordList all(patches.names());
        const bool isThere = std::any_of
        (
            all.begin(), all.end(),
            [&](const word& patch) { return name.match(patch); }
        );
        if (!isThere)
        {
            dictionaryInput::badValue
            (
                dict, "patches", name,
                "patches of the mesh " + dictionaryInput::listed(patches.names())
            );
        }
    }

    // An expression can match what decomposePar adds, and cyclic ones
    DynamicList<label> selected;
    for (const label patchi : patches.patchSet(names).sortedToc())
    {
        const polyPatch& patch = patches[patchi];
        const bool isNamed = std::any_of
        (
            names.begin(), names.end(),
            [&](const wordRe& name) { return name == patch.name(); }
        );
        if (!patch.coupled())
        {
            selected.append(patchi);
        }
        else if (isNamed && !isA<processorPolyPatch>(patch))
        {
            dictionaryInput::badValue
            (
                dict, "patches", patch.name(),
                "patches that are not of type '" + patch.type()
              + "', which grains pass"
            );
        }
    }

    for (const label patchi : selected)
    {
        if (isA<emptyPolyPatch>(patches[patchi]))
        {
            dictionaryInput::badValue
            (
                dict, "patches", patches[patchi].name(),
                "patches whose type is not 'empty'"
            );
        }
    }
    return labelList(std::move(selected));
}


void Foam::wallPieces::checkNoWalls
(
    const dictionary& dict,
    const labelList& selected,
    const dictionary& grainProperties,
    const polyMesh& mesh
)
{
    const dictionary& walls = grainProperties.subDict("walls");
    for (const word& name : walls.toc())
    {
        const dictionary& wall = walls.subDict(name);
        if (wall.get<word>("type") != "patches")
        {
            continue;
        }
        for (const label patchi : selectedPatches(wall, mesh))
        {
            if (selected.found(patchi))
            {
                dictionaryInput::badValue
                (
                    dict, "patches", mesh.boundaryMesh()[patchi].name(),
                    "patches that are no walls of grains, as this is in 'walls'"
                );
            }
        }
    }
}


Foam::fileName Foam::wallPieces::surfaceFile
(
    const dictionary& dict,
    const Time& runTime
)
{
    const fileName file
    (
        runTime.globalPath()/runTime.constant()/"triSurface"
       /dictionaryInput::getAs<fileName>
        (
            dict, "file", "a file of constant/triSurface"
        )
    );
    if (!isFile(file))
    {
        dictionaryInput::badValue(dict, "file", file, "a file that exists");
    }
    return file;
}


nscd::Segment Foam::wallPieces::ofPlane
(
    const dictionary& dict,
    const grainSpace<2>& space
)
{
    const Pair<nscd::Vector<2>> plane(readPlane(dict, space));
    const nscd::Vector<2>& p = plane.first();
    const nscd::Vector<2>& n = plane.second();
    const boundBox bounds(initialPoints(space.mesh())());
    const Eigen::AlignedBox2d domain
    (
        space.fromSpace(bounds.min()), space.fromSpace(bounds.max())
    );

    // From the middle of the mesh on to both sides, wherever grains can be
    const nscd::Vector<2> middle(domain.center());
    const nscd::Vector<2> foot(middle - n.dot(middle - p)*n);
    const nscd::Vector<2> along
    (
        2*(domain.diagonal().norm() + (middle - p).norm())
       *nscd::Vector<2>(-n.y(), n.x())
    );
    nscd::Segment segment;
    segment.a = foot - along;
    segment.b = foot + along;
    return segment;
}


nscd::Plane Foam::wallPieces::ofPlane
(
    const dictionary& dict,
    const grainSpace<3>& space
)
{
    const Pair<nscd::Vector<3>> plane(readPlane(dict, space));
    return {plane.first(), plane.second()};
}
