/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainSpace.H"

#include "meshPatches.H"
#include "PstreamReduceOps.H"
#include "volFields.H"

Foam::grainSpace<3>::grainSpace(const fvMesh& mesh)
:
    mesh_(mesh)
{
    requireWholePatches(mesh_);

    // What findCell needs and all ranks make together
    mesh_.tetBasePtIs();
}


Foam::Pair<Foam::scalar> Foam::grainSpace<3>::cellSizeRange() const
{
    return {Foam::cbrt(gMin(mesh_.V())), Foam::cbrt(gMax(mesh_.V()))};
}


Foam::label Foam::grainSpace<3>::findCell
(
    const nscd::Vector<3>& x,
    const label hint
) const
{
    const point p(toSpace(x));
    if (hint >= 0 && mesh_.pointInCell(p, hint, polyMesh::CELL_TETS))
    {
        return hint;
    }
    return mesh_.findCell(p);
}
