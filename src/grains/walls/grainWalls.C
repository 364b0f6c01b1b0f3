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
    const polyMesh& mesh = space.mesh();
    labelHashSet taken;

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
            // Of discs it is a segment, which turns
            if (D == 3 && body >= 0 && !motions_.last().turnedBy().empty())
            {
                const dictionary& motion = wall.subDict("motion");
                const word keyword(motions_.last().turnedBy());
                dictionaryInput::badValue
                (
                    motion, keyword, dictionaryInput::written(motion, keyword),
                    "motions that do not turn a wall of type plane; patches"
                    " and surfaces turn"
                );
            }
            auto plane = wallPieces::ofPlane(wall, space);
            plane.material = material;
            plane.body = body;
            planes.push_back(plane);
            extents_.push_back({name, 1, boundBox(), body});
            continue;
        }

        wallPieceList<D> own;
        if (type == "patches")
        {
            dictionaryInput::checkKeywords
            (
                wall, {"type", "patches", "material", "motion", "temperature"}
            );
            for (const label patchi : wallPieces::selectedPatches(wall, mesh))
            {
                if (!taken.insert(patchi))
                {
                    dictionaryInput::badValue
                    (
                        wall, "patches", mesh.boundaryMesh()[patchi].name(),
                        "patches that no other entry of 'walls' has"
                    );
                }
            }
            own = wallPieces::ofPatches(wall, space);
        }
        else
        {
            dictionaryInput::checkKeywords
            (
                wall,
                {
                    "type", "file", "scale", "material", "motion",
                    "temperature"
                }
            );
            own = wallPieces::ofSurface(wall, space);
        }
        extents_.push_back({name, label(own.size()), boundBox(), body});
        for (wallPiece<D>& piece : own)
        {
            for (const nscd::Vector<D>& x : wallPieces::corners(piece))
            {
                extents_.back().bounds.add(space.positionInSpace(x));
            }
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
    label heated = -1;
    if (wall.found("temperature"))
    {
        heated = heatedNames_.size();
        heatedNames_.append(wall.dictName());
        temperatures_.append
        (
            dictionaryInput::getPositive(wall, "temperature", dimTemperature)
        );
    }
    const label entry = heatedOfEntry_.size();
    heatedOfEntry_.append(heated);
    return
        materials.index(wall, "material") + materials.names().size()*entry;
}


template<int D>
void Foam::grainWalls<D>::separateKinds(const label nMaterials)
{
    for (auto& wall : walls_)
    {
        const label kind = nscd::materialOf(wall);
        entry_.append(kind/nMaterials);
        heated_.append(heatedOfEntry_[entry_.last()]);
        nscd::setMaterial(wall, kind % nMaterials);
    }
}


template<int D>
nscd::WallNames Foam::grainWalls<D>::names() const
{
    nscd::WallNames result;
    result.ofWall.assign(entry_.begin(), entry_.end());
    result.ofBody.resize(bodies_.size());
    for (const wallExtent& entry : extents_)
    {
        if (entry.body >= 0)
        {
            result.ofBody[entry.body] = int(result.entries.size());
        }
        result.entries.push_back(entry.name);
    }
    return result;
}


template<int D>
Foam::scalar Foam::grainWalls<D>::maxDeltaT() const
{
    scalar result = GREAT;
    for (const wallMotion<D>& motion : motions_)
    {
        result = min(result, motion.maxDeltaT());
    }
    return result;
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
