/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainWalls.H"

#include "dictionaryInput.H"
#include "wallPieces.H"

template<int D>
Foam::grainWalls<D>::grainWalls
(
    const dictionary& dict,
    const grainSpace<D>& space,
    const grainMaterials& materials
)
{
    wallPieceList<D> pieces;
    nscd::Walls<D> planes;

    for (const word& name : dict.toc())
    {
        const dictionary& wall = dictionaryInput::subDict(dict, name);
        const word type
        (
            dictionaryInput::getWord
            (
                wall, "type", {"patches", "surface", "plane"}
            )
        );
        const int material = kind(wall, materials);

        int body = -1;
        if (wall.found("motion"))
        {
            body = int(bodies_.size());
            motions_.append
            (
                wallMotion<D>::New
                (
                    dictionaryInput::subDict(wall, "motion"), space
                )
            );
            bodies_.push_back(motions_.last().body());
        }

        if (type == "plane")
        {
            dictionaryInput::checkKeywords
            (
                wall,
                {
                    "type", "point", "normal", "material", "motion",
                    "temperature"
                }
            );
            auto plane = wallPieces::ofPlane(wall, space);
            plane.material = material;
            plane.body = body;
            planes.push_back(plane);
            continue;
        }

        wallPieceList<D> own;
        if (type == "patches")
        {
            dictionaryInput::checkKeywords
            (
                wall, {"type", "patches", "material", "motion", "temperature"}
            );
            own = wallPieces::ofPatches(wall, space);
        }
        else
        {
            dictionaryInput::checkKeywords
            (
                wall, {"type", "file", "material", "motion", "temperature"}
            );
            own = wallPieces::ofSurface(wall, space);
        }
        for (wallPiece<D>& piece : own)
        {
            piece.material = material;
            piece.body = body;
            pieces.push_back(piece);
        }
    }

    if constexpr (D == 2)
    {
        walls_ = mergedSegments(pieces);
    }
    else
    {
        walls_ = mergedFaces(pieces);
    }
    walls_.insert(walls_.end(), planes.begin(), planes.end());
    separateKinds(materials.names().size());
}


template<int D>
Foam::label Foam::grainWalls<D>::kind
(
    const dictionary& wall,
    const grainMaterials& materials
)
{
    const label material = materials.index(wall, "material");
    if (!wall.found("temperature"))
    {
        return material;
    }
    heatedNames_.append(wall.dictName());
    temperatures_.append
    (
        dictionaryInput::getPositive(wall, "temperature", dimTemperature)
    );
    return material + materials.names().size()*heatedNames_.size();
}


template<int D>
void Foam::grainWalls<D>::separateKinds(const label nMaterials)
{
    for (auto& wall : walls_)
    {
        const label kind = nscd::materialOf(wall);
        heated_.append(kind/nMaterials - 1);
        nscd::setMaterial(wall, kind % nMaterials);
    }
}


template<int D>
void Foam::grainWalls<D>::setMotion
(
    nscd::ContactDynamics<D>& dynamics,
    const scalar t,
    const scalar deltaT,
    const nscd::Vector<D>& g
) const
{
    forAll(motions_, bodyi)
    {
        motions_[bodyi].set(dynamics, bodyi, t, deltaT, g);
    }
}


template class Foam::grainWalls<2>;
template class Foam::grainWalls<3>;
