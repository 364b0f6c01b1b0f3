/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchWalls.H"

#include "initialPoints.H"
#include "nscd/walls/WallMotion.hpp"
#include "wallPieces.H"

template<int D>
Foam::patchWalls<D>::patchWalls
(
    const dictionary& walls,
    const grainSpace<D>& space,
    const grainWalls<D>& grainWalls
)
:
    space_(space),
    grainWalls_(grainWalls),
    walls_(walls)
{
    for (const wallExtent& wall : grainWalls.extents())
    {
        const dictionary& dict = walls.subDict(wall.name);
        if (dict.get<word>("type") == "patches")
        {
            for
            (
                const label patchi
              : wallPieces::selectedPatches(dict, space.mesh())
            )
            {
                patches_.append({wall.name, patchi, wall.body, vectorField()});
            }
        }
    }
    keep(initialPoints(space.mesh())());
}


template<int D>
void Foam::patchWalls<D>::keep(const pointField& points)
{
    for (patchWall& wall : patches_)
    {
        const polyPatch& patch = space_.mesh().boundaryMesh()[wall.patch];
        wall.centres.resize(patch.size());
        forAll(patch, facei)
        {
            wall.centres[facei] = patch[facei].centre(points);
        }
    }
}


template<int D>
void Foam::patchWalls<D>::requireMesh() const
{
    for (const wallExtent& wall : grainWalls_.extents())
    {
        if
        (
            wall.body >= 0
         && grainWalls_.followsMesh(wall.body)
         && !space_.mesh().dynamic()
        )
        {
            FatalIOErrorInFunction(walls_.subDict(wall.name).subDict("motion"))
                << "Keyword 'type' of the motion of wall '" << wall.name
                << "' has the value 'mesh', but this mesh does not move" << nl
                << "    allowed: in grainFoam, with constant/dynamicMeshDict"
                << exit(FatalIOError);
        }
    }
}


template<int D>
void Foam::patchWalls<D>::warnOfUnseen() const
{
    for (const wallExtent& wall : grainWalls_.extents())
    {
        if (wall.body < 0)
        {
            continue;
        }
        const dictionary& dict = walls_.subDict(wall.name);
        const bool isPatches = dict.get<word>("type") == "patches";
        if (!isPatches || !space_.mesh().dynamic())
        {
            IOWarningInFunction(dict)
                << "Wall '" << wall.name << "' moves inside a mesh that does"
                << " not move with it: grains see its motion, the fluid does"
                << " not and flows through" << nl
                << "    A wall that moves both is a patch of a mesh that moves"
                << " (constant/dynamicMeshDict), see grainWallMotion" << endl;
        }
    }
}


template<int D>
void Foam::patchWalls<D>::meshChanged()
{
    if (space_.mesh().topoChanging())
    {
        keep(space_.mesh().points());
    }
}


template<int D>
void Foam::patchWalls<D>::check
(
    const std::vector<nscd::WallBody<D>>& bodies
) const
{
    const fvMesh& mesh = space_.mesh();
    if (mesh.topoChanging())
    {
        return;
    }
    const auto motions = nscd::rigidMotions<D>(grainWalls_.bodies(), bodies);

    // Of the mesh's extent: round-off of a motion along the patch
    constexpr scalar tolerance = 1e-6;

    for (const patchWall& wall : patches_)
    {
        const fvPatch& patch = mesh.boundary()[wall.patch];
        vectorField way(patch.Cf() - wall.centres);
        if (wall.body >= 0)
        {
            forAll(way, facei)
            {
                const nscd::Vector<D> x
                (
                    space_.fromSpace(wall.centres[facei])
                );
                const nscd::Vector<D> y(motions[wall.body](x));
                way[facei] -= space_.toSpace(nscd::Vector<D>(y - x));
            }
        }
        const scalar moved = gMax(mag(way & patch.nf()())());
        if (moved <= tolerance*mesh.bounds().mag())
        {
            continue;
        }
        FatalIOErrorInFunction(walls_)
            << "Patch '" << patch.name() << "' has moved by " << moved
            << " m across itself at time " << mesh.time().timeName() << ", "
            << (
                    wall.body < 0
                  ? "but the wall of grains that it is has no 'motion'"
                  : "away from the wall of grains that it is"
               )
            << ": '" << wall.name << "'" << nl
            << "    allowed: patches that keep their planes; walls that follow"
            << " the mesh, motion { type mesh; }; or that move it,"
            << " grainWallMotion" << exit(FatalIOError);
    }
}


template class Foam::patchWalls<2>;
template class Foam::patchWalls<3>;
