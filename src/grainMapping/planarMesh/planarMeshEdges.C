/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarMesh.H"

void Foam::planarMesh::setEdges()
{
    const pointField& points = mesh_.points();

    edges_.resize(vertices_.size());
    for (label celli = 0; celli < nCells(); ++celli)
    {
        const label n = polygonSize(celli);
        for (label i = 0; i < n; ++i)
        {
            const point2& p = polygon(celli)[i];
            const point2 along(polygon(celli)[(i + 1) % n] - p);

            edge& e = edges_[start_[celli] + i];
            e.normal = point2(-along.y(), along.x()).normalized();
            e.offset = e.normal.dot(p);
            e.neighbour = -1;

            // The internal face that stands on this edge
            const point2 middle(p + 0.5*along);
            for (const label facei : mesh_.cells()[celli])
            {
                if
                (
                    mesh_.isInternalFace(facei)
                 && (toPlane(mesh_.faces()[facei].average(points, points)) - middle)
                        .norm() < 1e-6*along.norm()
                )
                {
                    const label owner = mesh_.faceOwner()[facei];
                    e.neighbour =
                        owner == celli ? mesh_.faceNeighbour()[facei] : owner;
                }
            }
        }
    }
}


Foam::planarMesh::approach Foam::planarMesh::near
(
    const label celli,
    const point2& x,
    const scalar distance
) const
{
    approach result;
    for (label k = start_[celli]; k < start_[celli + 1]; ++k)
    {
        const edge& e = edges_[k];
        const scalar d = e.normal.dot(x) - e.offset;
        if (d < distance)
        {
            ++result.nClose;
            result.distance = d;
            result.normal = e.normal;
            result.neighbour = e.neighbour;
        }
    }
    return result;
}
