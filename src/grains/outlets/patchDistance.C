/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchDistance.H"

#include "combineOverRanks.H"
#include "emptyPolyPatch.H"

Foam::autoPtr<Foam::patchDistance::tree> Foam::patchDistance::treeOf
(
    const polyMesh& mesh,
    const labelUList& faces
)
{
    if (faces.empty())
    {
        return nullptr;
    }
    treeBoundBox box(mesh.points());
    box.inflate(0.01);
    return autoPtr<tree>::New
    (
        treeDataFace(false, mesh, faces), box, 8, scalar(10), scalar(3)
    );
}


Foam::patchDistance::patchDistance
(
    const polyMesh& mesh,
    const labelUList& patches
)
:
    mesh_(mesh),
    patches_(patches)
{
    meshChanged();
}


void Foam::patchDistance::meshChanged()
{
    DynamicList<label> chosen, others;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(patch) && !patch.coupled())
        {
            DynamicList<label>& faces =
                patches_.found(patch.index()) ? chosen : others;
            forAll(patch, i)
            {
                faces.append(patch.start() + i);
            }
        }
    }
    chosen_ = treeOf(mesh_, chosen);
    others_ = treeOf(mesh_, others);
}


Foam::scalarField Foam::patchDistance::distances
(
    const autoPtr<tree>& faces,
    const UList<point>& x,
    const UList<scalar>& reach
)
{
    scalarField result(x.size(), GREAT);
    if (faces)
    {
        forAll(x, i)
        {
            const pointIndexHit hit(faces->findNearest(x[i], sqr(reach[i])));
            if (hit.hit())
            {
                result[i] = mag(hit.hitPoint() - x[i]);
            }
        }
    }
    combineOverRanks(result, minEqOp<scalar>());
    return result;
}


Foam::boolList Foam::patchDistance::arePatchesWithin
(
    const UList<point>& x,
    const UList<scalar>& reach
) const
{
    const scalarField distance(distances(chosen_, x, reach));
    boolList result(x.size());
    forAll(result, i)
    {
        result[i] = distance[i] < reach[i];
    }
    return result;
}


Foam::boolList Foam::patchDistance::arePatchesNearest
(
    const UList<point>& x
) const
{
    // A point beyond the common edge of two patches is as far from both
    constexpr scalar same = 1 + 1e-6;

    const scalarField chosen(fromPatches(x));
    const scalarField others
    (
        distances(others_, x, scalarField(x.size(), GREAT))
    );
    boolList result(x.size());
    forAll(result, i)
    {
        result[i] = chosen[i] <= same*others[i];
    }
    return result;
}
