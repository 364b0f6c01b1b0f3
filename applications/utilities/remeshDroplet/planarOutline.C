/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarOutline.H"

#include "emptyPolyPatch.H"
#include "Map.H"

Foam::planarOutline::planarOutline(const planarMesh& plane)
{
    const fvMesh& mesh = plane.mesh();
    Map<label> indices;
    const auto indexOf = [&](const label pointi)
    {
        if (indices.insert(pointi, label(points_.size())))
        {
            points_.push_back(plane.toPlane(mesh.points()[pointi]));
        }
        return indices[pointi];
    };

    Map<label> next;
    sides_.resize(mesh.boundaryMesh().size());
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            continue;
        }
        for (const face& f : patch)
        {
            forAll(f, i)
            {
                const label a = f[i], b = f[f.fcIndex(i)];
                if
                (
                    plane.outOfPlane(mesh.points()[a]) < plane.middle()
                 && plane.outOfPlane(mesh.points()[b]) < plane.middle()
                )
                {
                    sides_[patch.index()].append
                    (
                        labelPair(indexOf(a), indexOf(b))
                    );
                    next.insert(indexOf(a), indexOf(b));
                }
            }
        }
    }

    DynamicList<labelList> loops;
    while (next.size())
    {
        const label first = next.cbegin().key();
        DynamicList<label> loop;
        for (label i = first; next.found(i);)
        {
            loop.append(i);
            const label after = next[i];
            next.erase(i);
            i = after;
        }
        loops.append(loop);
    }
    loops_.transfer(loops);
}
