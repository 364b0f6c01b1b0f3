/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshMotion.H"

#include "dictionaryInput.H"
#include "initialPoints.H"
#include "wallPieces.H"

addToSelection(wallMotion, wallMotions, mesh)

template<int D>
Foam::wallMotions::mesh<D>::mesh
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    space_(space),
    wall_(dict.parent())
{
    dictionaryInput::checkKeywords(dict, {"type"});

    if (wall_.getOrDefault<word>("type", "none") != "patches")
    {
        dictionaryInput::badValue
        (
            dict, "type", "mesh",
            "other motions, where the wall's type is not 'patches'"
        );
    }
    patches_ = wallPieces::selectedPatches(wall_, space.mesh());

    const tmp<pointField> points(initialPoints(space.mesh()));
    for (const label patchi : patches_)
    {
        initial_.append
        (
            pointField
            (
                points(), space.mesh().boundaryMesh()[patchi].meshPoints()
            )
        );
    }
}


template<int D>
Foam::vector Foam::wallMotions::mesh<D>::displacement() const
{
    const fvMesh& mesh = space_.mesh();
    if (mesh.topoChanging())
    {
        FatalIOErrorInFunction(wall_)
            << "Keyword 'motion' of wall '" << wall_.dictName() << "' is of"
            << " type 'mesh', and the mesh splits or merges cells" << nl
            << "    allowed: a mesh that only moves" << exit(FatalIOError);
    }

    vector low(vector::uniform(GREAT));
    vector high(vector::uniform(-GREAT));
    forAll(patches_, i)
    {
        const vectorField way
        (
            mesh.boundaryMesh()[patches_[i]].localPoints() - initial_[i]
        );
        for (const vector& v : way)
        {
            low = min(low, v);
            high = max(high, v);
        }
    }
    reduce(low, minOp<vector>());
    reduce(high, maxOp<vector>());

    // Of the mesh's extent: round-off of points on disk
    constexpr scalar tolerance = 1e-6;

    if (cmptMax(high - low) > tolerance*mesh.bounds().mag())
    {
        FatalIOErrorInFunction(wall_)
            << "Keyword 'motion' of wall '" << wall_.dictName() << "' is of"
            << " type 'mesh', but the points of its patches move by between "
            << low << " and " << high << " m until time "
            << mesh.time().timeName() << nl
            << "    allowed: patches that the mesh neither turns nor bends; a"
            << " wall that turns moves the mesh by grainWallMotion"
            << exit(FatalIOError);
    }
    return 0.5*(low + high);
}


template<int D>
void Foam::wallMotions::mesh<D>::set
(
    nscd::ContactDynamics<D>& dynamics,
    const label bodyi,
    const scalar,
    const scalar deltaT,
    const nscd::Vector<D>&
) const
{
    // To the patch, whatever the round-off of earlier steps
    const nscd::Vector<D> way
    (
        space_.fromSpace(displacement())
      - dynamics.wallBodies()[bodyi].position
    );
    dynamics.setWallMotion(bodyi, way/deltaT, nscd::Spin<D>::Zero());
}
