/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conservativeMap.H"

#include "emptyPolyPatch.H"

#include <Eigen/LU>

void Foam::conservativeMap::slopes
(
    const scalarField& x,
    const List<scalarField>& onPatches,
    std::vector<planarMesh::point2>& result
) const
{
    typedef planarMesh::point2 point2;
    const fvMesh& mesh = old_.mesh();

    // Least squares over the cells with fluid beside each, and over patches
    std::vector<Eigen::Matrix2d> A(x.size(), Eigen::Matrix2d::Zero());
    std::vector<point2> b(x.size(), point2(0, 0));
    const auto add = [&](const label celli, const vector& way, const scalar value)
    {
        const point2 d(old_.toPlane(way));
        const scalar weight = 1/d.squaredNorm();
        A[celli] += weight*d*d.transpose();
        b[celli] += weight*(value - x[celli])*d;
    };
    const vectorField& C = mesh.cellCentres();
    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label i = mesh.faceOwner()[facei], j = mesh.faceNeighbour()[facei];
        if (isOpen_[i] && isOpen_[j])
        {
            add(i, C[j] - C[i], x[j]);
            add(j, C[i] - C[j], x[i]);
        }
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch) || patch.coupled())
        {
            continue;
        }
        forAll(patch, k)
        {
            const label i = patch.faceCells()[k];
            if (isOpen_[i])
            {
                add
                (
                    i, patch.faceCentres()[k] - C[i],
                    onPatches[patch.index()][k]
                );
            }
        }
    }

    // All around each cell, bodies included
    scalarField low(x), high(x);
    for (const labelList& cells : mesh.pointCells())
    {
        scalar least = GREAT, most = -GREAT;
        for (const label i : cells)
        {
            least = min(least, x[i]);
            most = max(most, x[i]);
        }
        for (const label i : cells)
        {
            low[i] = min(low[i], least);
            high[i] = max(high[i], most);
        }
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const scalarField& values = onPatches[patch.index()];
        forAll(values, k)
        {
            const label i = patch.faceCells()[k];
            low[i] = min(low[i], values[k]);
            high[i] = max(high[i], values[k]);
        }
    }

    result.assign(x.size(), point2(0, 0));
    forAll(x, i)
    {
        const scalar trace = A[i].trace();
        if (isOpen_[i] && A[i].determinant() > 1e-6*sqr(trace))
        {
            result[i] = A[i].inverse()*b[i];
        }
    }

    // Where a piece is, from the middle of its cell's fluid as the content is kept
    scalarField share(x.size(), 1);
    for (const piece& p : pieces_)
    {
        if (p.volume <= 0)
        {
            continue;
        }
        const label i = p.from;
        const scalar change =
            result[i].dot(p.centre - middles_[i]);
        const scalar room = change > 0 ? high[i] - x[i] : low[i] - x[i];
        if (mag(change) > mag(room))
        {
            share[i] = min(share[i], room/change);
        }
    }
    forAll(x, i)
    {
        result[i] *= share[i];
    }
}
