/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutCells.H"

#include "fvcSurfaceIntegrate.H"
#include "resolvedGrains.H"
#include "surfaceInterpolate.H"

template<class Function>
void Foam::cutCells::forFaces(const label celli, const Function& f) const
{
    for (const label facei : mesh_.cells()[celli])
    {
        const scalar sign = mesh_.faceOwner()[facei] == celli ? 1 : -1;
        if (mesh_.isInternalFace(facei))
        {
            f(facei, sign, -1, facei);
            continue;
        }
        const label patchi = mesh_.boundaryMesh().whichPatch(facei);
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.size())
        {
            f(facei, sign, patchi, facei - patch.start());
        }
    }
}


void Foam::cutCells::addParts
(
    const label graini,
    DynamicList<part>& parts
) const
{
    const cutBody body(this->body(graini));
    labelHashSet seen;
    for (const cellOverlap& o : grains_.overlaps().of(graini))
    {
        forFaces
        (
            o.cell,
            [&](const label facei, scalar, const label patchi, const label i)
            {
                if (!seen.insert(facei))
                {
                    return;
                }
                const cutBody::part x = body.of
                (
                    facei,
                    between(grains_.centres()[graini], mesh_.faceCentres()[facei])
                );
                if (x.share > 0)
                {
                    const vector arm(body.isRound() ? vector(Zero) : x.arm);
                    parts.append(part{graini, patchi, i, x.share, arm});
                }
            }
        );
    }
}


void Foam::cutCells::setFaces()
{
    using resolvedFace::at;

    DynamicList<part> parts;
    forGrains([&](const label graini) { addParts(graini, parts); });

    surfaceScalarField closed(0*open_);
    for (const part& x : parts)
    {
        at(closed, x.patch, x.face) += x.share;
    }

    // Closed where a cell is; the same on both sides of a face of two ranks
    open_ = 1 - closed;
    const auto round = [](scalar& x) { x = x < least_ ? 0 : min(x, scalar(1)); };
    forAll(mesh_.owner(), facei)
    {
        scalar& x = open_[facei];
        const scalar less =
            min(fluid_[mesh_.owner()[facei]], fluid_[mesh_.neighbour()[facei]]);
        x = less > 0 ? x : 0;
        round(x);
        cutFaces_[facei] = less < 1;
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        scalarField less(fluid_.boundaryField()[patchi].patchInternalField());
        if (patch.coupled())
        {
            less = min(less, fluid_.boundaryField()[patchi].patchNeighbourField()());
        }
        forAll(patch, i)
        {
            scalar& x = open_.boundaryFieldRef()[patchi][i];
            x = less[i] > 0 ? x : 0;
            round(x);
            cutFaces_.boundaryFieldRef()[patchi][i] =
                patch.coupled() && less[i] < 1;
        }
    }

    // What counts as nothing goes to the grain
    for (part& x : parts)
    {
        const scalar all = at(closed, x.patch, x.face);
        x.share *= (1 - at(open_, x.patch, x.face))/all;
    }
    parts_.transfer(parts);

    openCells_.primitiveFieldRef() =
        pos(0.5 - fvc::surfaceSum(cutFaces_)().primitiveField());
    openCells_.correctBoundaryConditions();
    openCells_.primitiveFieldRef() = pos
    (
        0.5
      - fvc::surfaceSum
        (
            1 - pos(fvc::interpolate(openCells_) - 1 + SMALL)
        )().primitiveField()
    );
    openCells_.correctBoundaryConditions();
}


void Foam::cutCells::setWalls()
{
    // Of each grain, what it has of the faces
    List<DynamicList<label>> partsOf(grains_.overlaps().nGrains());
    forAll(parts_, i)
    {
        partsOf[parts_[i].grain].append(i);
    }

    const scalarField solid(this->solid());
    DynamicList<wall> walls;
    forGrains
    (
        [&](const label graini)
        {
            addWalls(graini, partsOf[graini], solid, walls);
        }
    );
    walls_.transfer(walls);
}


void Foam::cutCells::addWalls
(
    const label graini,
    const labelUList& partsOfGrain,
    const scalarField& solid,
    DynamicList<wall>& walls
) const
{
    using resolvedFace::at;

    Map<scalar> inside, outside;
    for (const label i : partsOfGrain)
    {
        const part& x = parts_[i];
        if (x.patch < 0)
        {
            inside.insert(x.face, x.share);
        }
        else
        {
            outside.insert(mesh_.boundary()[x.patch].start() + x.face, x.share);
        }
    }

    const cutBody body(this->body(graini));
    Map<label> wallOf;
    for (const cellOverlap& o : grains_.overlaps().of(graini))
    {
        const scalar share = o.volume/solid[o.cell];
        if (!wallOf.insert(o.cell, walls.size()))
        {
            walls[wallOf[o.cell]].share += share;
            continue;
        }
        wall x{graini, o.cell, o.index, Zero, Zero, Zero, 0, 1, share};
        forFaces
        (
            o.cell,
            [&]
            (
                const label facei,
                const scalar sign,
                const label patchi,
                const label i
            )
            {
                const Map<scalar>& shares = patchi < 0 ? inside : outside;
                const auto found = shares.cfind(facei);
                if (found.found())
                {
                    x.area += sign*(*found)*at(mesh_.Sf(), patchi, i);
                }
            }
        );

        const cutBody::surfacePoint next = body.nearest
        (
            between(grains_.centres()[graini], mesh_.C()[o.cell])
          + centroid_[o.cell]
        );
        x.arm = next.arm;
        x.normal = next.normal;
        x.radius = next.radius;
        x.distance = max
        (
            max(next.distance, halfFilm(x)), 1e-3*cellSize_[o.cell]
        );
        walls.append(x);
    }
}


void Foam::cutCells::leavePatches()
{
    List<part> kept(parts_.size());
    label n = 0;
    for (const part& x : parts_)
    {
        if (x.patch < 0 || mesh_.boundary()[x.patch].coupled())
        {
            kept[n++] = x;
        }
    }
    kept.resize(n);
    parts_.transfer(kept);
}


void Foam::cutCells::setConductance()
{
    const auto ratio = [&]
    (
        const scalar open,
        const scalar apart,
        const vector& normal,
        const vector& shift
    )
    {
        return open*apart/max(nearest*apart, apart + (normal & shift));
    };
    const surfaceScalarField& coeffs = mesh_.nonOrthDeltaCoeffs();
    const surfaceVectorField& S = mesh_.Sf();

    forAll(mesh_.owner(), i)
    {
        const vector shift
        (
            centroid_[mesh_.neighbour()[i]] - centroid_[mesh_.owner()[i]]
        );
        conductance_[i] = ratio(open_[i], 1/coeffs[i], S[i]/mag(S[i]), shift);
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const fvPatchVectorField& x = centroid_.boundaryField()[patchi];
        vectorField shift(-x.patchInternalField());
        if (patch.coupled())
        {
            shift += x.patchNeighbourField()();
        }
        const vectorField n(patch.nf());
        forAll(patch, i)
        {
            conductance_.boundaryFieldRef()[patchi][i] = ratio
            (
                open_.boundaryField()[patchi][i],
                1/coeffs.boundaryField()[patchi][i],
                n[i], shift[i]
            );
        }
    }
}
