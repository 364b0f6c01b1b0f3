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
    starts_.resize(mesh.boundaryMesh().size());
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
                    starts_[patch.index()].append((f.size() - i) % f.size());
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


Foam::scalar Foam::planarOutline::distance(const planarMesh::point2& x) const
{
    scalar result = GREAT;
    for (const List<labelPair>& sides : sides_)
    {
        for (const labelPair& side : sides)
        {
            const planarMesh::point2& a = points_[side.first()];
            const planarMesh::point2 along(points_[side.second()] - a);
            const scalar t = along.dot(x - a)/along.squaredNorm();
            const planarMesh::point2 nearest
            (
                a + min(max(t, scalar(0)), scalar(1))*along
            );
            result = min(result, (x - nearest).norm());
        }
    }
    return result;
}
