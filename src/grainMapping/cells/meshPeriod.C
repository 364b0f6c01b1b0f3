/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPeriod.H"

#include "cyclicPolyPatch.H"
#include "polyMesh.H"
#include "processorCyclicPolyPatch.H"
#include "treeBoundBox.H"

namespace Foam
{

// The box of a cyclic patch, with the part that has become one of the
// processors' patches
static boundBox cyclicBounds(const polyMesh& mesh, const label cyclici)
{
    boundBox box(boundBox::invertedBox);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* cutPtr = isA<processorCyclicPolyPatch>(patch);
        if
        (
            patch.index() == cyclici
         || (cutPtr && cutPtr->referPatchID() == cyclici)
        )
        {
            for (const label pointi : patch.meshPoints())
            {
                box.add(mesh.points()[pointi]);
            }
        }
    }
    box.reduce();
    return box;
}

} // End namespace Foam


Foam::vector Foam::meshPeriod(const polyMesh& mesh)
{
    vector period(Zero);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* cyclicPtr = isA<cyclicPolyPatch>(patch);
        if (!cyclicPtr || !cyclicPtr->owner())
        {
            continue;
        }
        const boundBox one(cyclicBounds(mesh, patch.index()));
        const boundBox other(cyclicBounds(mesh, cyclicPtr->neighbPatchID()));

        // Vertices are written with a finite number of digits
        const scalar thin = 1e-6*mag(mesh.bounds().span());
        const vector apart(other.midpoint() - one.midpoint());
        bool isPeriod = false;
        for (direction d = 0; d < 3; ++d)
        {
            if
            (
                one.span()[d] < thin && other.span()[d] < thin
             && mag(mag(apart[d]) - mag(apart)) < thin
            )
            {
                period[d] = mag(apart[d]);
                isPeriod = true;
            }
        }
        if (!isPeriod)
        {
            WarningInFunction
                << "Grains do not pass through the cyclic patch "
                << patch.name() << ", which is not a plane normal to an axis"
                << " with its neighbour straight across" << endl;
        }
    }
    return period;
}


Foam::List<Foam::vector> Foam::cyclicSeparations(const polyMesh& mesh)
{
    DynamicList<vector> result;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* cyclicPtr = isA<cyclicPolyPatch>(patch);
        if (cyclicPtr && cyclicPtr->owner())
        {
            result.append
            (
                cyclicBounds(mesh, cyclicPtr->neighbPatchID()).midpoint()
              - cyclicBounds(mesh, patch.index()).midpoint()
            );
        }
    }
    return List<vector>(std::move(result));
}
