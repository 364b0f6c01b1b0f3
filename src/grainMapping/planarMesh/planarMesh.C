/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarMesh.H"

#include "emptyPolyPatch.H"
#include "meshPatches.H"
#include "overlap/disc/DiscPolygon.hpp"
#include "PstreamReduceOps.H"
#include "volFields.H"
#include "wedgePolyPatch.H"

void Foam::planarMesh::setAxes()
{
    requireWholePatches(mesh_);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(patch))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of mesh "
                << mesh_.polyMesh::objectPath() << " is of type 'wedge'" << nl
                << "    allowed: a mesh one cell thick with patches of type"
                << " 'empty' in front and behind, for discs, or one of three"
                << " dimensions, for spheres; grains have no symmetry of"
                << " revolution" << exit(FatalError);
        }
    }
    if (mesh_.nGeometricD() != 2)
    {
        FatalErrorInFunction
            << "Mesh " << mesh_.polyMesh::objectPath() << " has "
            << mesh_.nGeometricD() << " directions to solve" << nl
            << "    allowed for 'shape disc': 2, that is a mesh one cell thick"
            << " with patches of type 'empty' in front and behind"
            << exit(FatalError);
    }

    const Vector<label>& dirs = mesh_.geometricD();

    across_ = dirs.x() < 0 ? 0 : dirs.y() < 0 ? 1 : 2;
    a_ = across_ == 0 ? 1 : 0;
    b_ = across_ == 2 ? 1 : 2;
    hand_ = across_ == 1 ? -1 : 1;

    const boundBox& bounds = mesh_.bounds();
    middle_ = bounds.midpoint()[across_];
    depth_ = bounds.span()[across_];
}


void Foam::planarMesh::setPolygons()
{
    labelList frontFace(mesh_.nCells(), -1);
    labelList nEmpty(mesh_.nCells(), 0);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            forAll(patch, i)
            {
                frontFace[patch.faceCells()[i]] = patch.start() + i;
                ++nEmpty[patch.faceCells()[i]];
            }
        }
    }

    const pointField& points = mesh_.points();
    start_.assign(1, 0);

    forAll(frontFace, celli)
    {
        std::vector<point2> polygon;
        if (nEmpty[celli] == 2)
        {
            for (const label pointi : mesh_.faces()[frontFace[celli]])
            {
                polygon.push_back(toPlane(points[pointi]));
            }
        }

        const scalar area =
            polygon.empty()
          ? 0
          : overlap::polygon(polygon.data(), polygon.size()).area;

        if (mag(mag(area)*depth_ - mesh_.V()[celli]) > 1e-9*mesh_.V()[celli])
        {
            FatalErrorInFunction
                << "Cell " << celli << " at " << mesh_.C()[celli]
                << " of mesh " << mesh_.polyMesh::objectPath()
                << " is not a prism between two 'empty' faces" << nl
                << "    its volume is " << mesh_.V()[celli]
                << ", its area times the depth of the mesh "
                << mag(area)*depth_ << nl
                << "    allowed for 'shape disc': one layer of cells of the"
                << " same depth" << exit(FatalError);
        }

        if (area < 0)
        {
            std::reverse(polygon.begin(), polygon.end());
        }

        Eigen::AlignedBox2d box;
        for (const point2& x : polygon)
        {
            vertices_.push_back(x);
            box.extend(x);
        }
        boxes_.push_back(box);
        domain_.extend(box);
        start_.push_back(label(vertices_.size()));
    }
}


Foam::planarMesh::planarMesh(const fvMesh& mesh)
:
    mesh_(mesh)
{
    meshChanged();
}


void Foam::planarMesh::meshChanged()
{
    vertices_.clear();
    edges_.clear();
    boxes_.clear();
    domain_.setEmpty();

    setAxes();
    setPolygons();
    setEdges();
    setBins();
}


Eigen::AlignedBox2d Foam::planarMesh::globalDomain() const
{
    const boundBox& bounds = mesh_.bounds();    // of all ranks
    return {toPlane(bounds.min()), toPlane(bounds.max())};
}


Foam::Pair<Foam::scalar> Foam::planarMesh::cellSizeRange() const
{
    return
    {
        Foam::sqrt(gMin(mesh_.V())/depth_),
        Foam::sqrt(gMax(mesh_.V())/depth_)
    };
}
