/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "crossingGrains.H"

#include "combineOverRanks.H"

Foam::crossingGrains::crossingGrains(const grainSystem& grains)
:
    grains_(grains)
{}


Foam::crossingGrains::partsOfGrains Foam::crossingGrains::parts() const
{
    const fvMesh& mesh = grains_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    partsOfGrains result;
    const overlapList& overlaps = grains_.overlaps();
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (!grains_.isAtOpening(graini) && !parts_.found(graini))
        {
            continue;
        }
        for (const cellOverlap& o : overlaps.of(graini))
        {
            for (const label facei : mesh.cells()[o.cell])
            {
                const label patchi = patches.whichPatch(facei);
                if (patches_.found(patchi))
                {
                    const label i = facei - patches[patchi].start();
                    const scalar area = mesh.magSf().boundaryField()[patchi][i];
                    result(graini).append
                    (
                        part{patchi, i, area*o.volume/mesh.V()[o.cell]}
                    );
                }
            }
        }
    }
    return result;
}


void Foam::crossingGrains::startStep(const labelHashSet& freePatches)
{
    DynamicList<label> given;
    for (const label patchi : grains_.motion().openings())
    {
        if (!freePatches.found(patchi))
        {
            given.append(patchi);
        }
    }
    patches_.transfer(given);

    volume_ = grains_.mappedVolume();
    parts_.clear();
    if (patches_.size())
    {
        parts_ = parts();
    }
}


void Foam::crossingGrains::meshChanged()
{
    if (patches_.size())
    {
        parts_ = parts();
    }
}


Foam::Map<Foam::scalarField> Foam::crossingGrains::flux
(
    const scalarField& share
) const
{
    Map<scalarField> result;
    if (patches_.empty())
    {
        return result;
    }
    const fvMesh& mesh = grains_.mesh();
    const label n = grains_.size();
    const auto areas = [&](const partsOfGrains& parts)
    {
        scalarField result(n, Zero);
        forAllConstIters(parts, iter)
        {
            for (const part& one : iter.val())
            {
                result[iter.key()] += one.area;
            }
        }
        sumOverRanks(result);
        return result;
    };

    // Of a grain that has left there is what was in the mesh before
    const partsOfGrains now(parts());
    const scalarField area(areas(now)), areaBefore(areas(parts_));

    for (const label patchi : patches_)
    {
        result.insert(patchi, scalarField(mesh.boundary()[patchi].size(), Zero));
    }
    for (label graini = 0; graini < n; ++graini)
    {
        const bool isThere = area[graini] > 0;
        const scalar whole = isThere ? area[graini] : areaBefore[graini];
        const partsOfGrains& parts = isThere ? now : parts_;
        if (whole <= 0 || !parts.found(graini))
        {
            continue;
        }
        const scalar before = graini < volume_.size() ? volume_[graini] : 0;
        const scalar out =
            share[graini]
           *(before - grains_.mappedVolume()[graini])/mesh.time().deltaTValue();
        for (const part& one : parts[graini])
        {
            result[one.patch][one.face] += out*one.area/whole;
        }
    }
    return result;
}


Foam::scalarField Foam::crossingGrains::limited
(
    const scalarField& grains,
    const scalarField& mixture
)
{
    scalarField within(grains);
    forAll(within, i)
    {
        if (grains[i]*mixture[i] > 0 && mag(grains[i]) > mag(mixture[i]))
        {
            within[i] = mixture[i];
        }
    }
    const scalar excess = gSum(scalarField(grains - within));
    const scalarField room(max(sign(excess)*mixture, scalar(0)));
    const scalarField left
    (
        pos(room)*max(room - max(sign(excess)*within, scalar(0)), scalar(0))
    );
    const scalar all = gSum(left);
    if (all < mag(excess))
    {
        return grains;
    }
    return within + (excess/max(all, VSMALL))*left;
}
