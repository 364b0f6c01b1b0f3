/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "spatialMesh.H"

namespace Foam
{
    defineTypeNameAndDebug(spatialMesh, 0);
}


namespace
{

using namespace Foam;

std::vector<overlap::Point3> pointsOf(const polyMesh& mesh)
{
    std::vector<overlap::Point3> points;
    points.reserve(mesh.points().size());
    for (const point& p : mesh.points())
    {
        points.emplace_back(p.x(), p.y(), p.z());
    }
    return points;
}


std::vector<int> copyOf(const labelList& list)
{
    return std::vector<int>(list.begin(), list.end());
}


overlap::PolyhedralMesh polyhedra(const polyMesh& mesh)
{
    std::vector<int> start(1, 0), vertices;
    for (const face& f : mesh.faces())
    {
        vertices.insert(vertices.end(), f.begin(), f.end());
        start.push_back(int(vertices.size()));
    }
    return overlap::PolyhedralMesh
    (
        pointsOf(mesh), std::move(start), std::move(vertices),
        copyOf(mesh.faceOwner()), copyOf(mesh.faceNeighbour())
    );
}


// What f returns; an error of the mesh is fatal
template<class Function>
auto checked(const polyMesh& mesh, const Function& f)
{
    try
    {
        return f();
    }
    catch (const std::exception& err)
    {
        FatalErrorInFunction
            << "Grains cannot be mapped to mesh " << mesh.objectPath() << ": "
            << err.what() << nl
            << "    allowed: closed cells of positive volume, see checkMesh"
            << exit(FatalError);
        throw;
    }
}

}


Foam::spatialMesh::spatialMesh(const polyMesh& mesh)
:
    MeshObject<polyMesh, MoveableMeshObject, spatialMesh>(mesh),
    cells_(checked(mesh, [&]() { return polyhedra(mesh); })),
    ball_(cells_)
{}


bool Foam::spatialMesh::movePoints()
{
    checked(mesh_, [&]() { cells_.movePoints(pointsOf(mesh_)); });
    return true;
}
