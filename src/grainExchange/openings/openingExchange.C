/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openingExchange.H"

#include "combineOverRanks.H"

Foam::openingExchange::openingExchange
(
    const grainSystem& grains,
    const carrier& fluid
)
:
    grains_(grains),
    weight_(grains, fluid),
    outside_(Zero)
{}


Foam::labelHashSet Foam::openingExchange::freePatches
(
    const volVectorField& U,
    const labelList& ofOthers
) const
{
    labelList all(grains_.motion().openings());
    all.append(ofOthers);
    // Fluid that passes grains which stay has their drag as far as there
    forAll(U.mesh().boundary(), patchi)
    {
        if (U.mesh().boundary()[patchi].type() == fvPatch::typeName)
        {
            all.append(patchi);
        }
    }

    labelHashSet result;
    for (const label patchi : all)
    {
        if (U.boundaryField()[patchi].assignable())
        {
            result.insert(patchi);
        }
    }
    return result;
}


Foam::List<Foam::openingExchange::inside>
Foam::openingExchange::insides() const
{
    const overlapList& overlaps = grains_.overlaps();

    List<inside> result(grains_.size());
    if (grains_.motion().openings().empty())
    {
        return result;
    }
    const tmp<scalarField> rho(weight_.seen());
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (!grains_.isAtOpening(graini))
        {
            continue;
        }
        for (const cellOverlap& o : overlaps.of(graini))
        {
            result[graini].moment += o.volume*o.arm;
            result[graini].buoyancy += weight_.force(o.volume, rho()[o.cell]);
        }
    }
    sumRecordsOverRanks(result);
    return result;
}


void Foam::openingExchange::extendForce
(
    const resolvedTerm& resolved,
    vectorField& force,
    vectorField& torque
)
{
    const List<inside> insides(this->insides());

    outside_ = Zero;
    forAll(force, graini)
    {
        if (grains_.isAtOpening(graini))
        {
            const scalar volume = grains_.mappedVolume()[graini];
            const scalar more = grains_.volume(graini)/volume - 1;
            const inside& in = insides[graini];

            if (!resolved.isResolved(graini))
            {
                torque[graini] -=
                    (in.moment/volume) ^ (force[graini] - in.buoyancy);
                torque[graini] *= 1 + more;
            }
            outside_ +=
                grains_.mesh().time().deltaTValue()*more*force[graini];
            force[graini] *= 1 + more;
        }
    }
}


bool Foam::openingExchange::shareOf
(
    const std::vector<bool>& those,
    scalarField& share,
    vectorField& flux
) const
{
    const overlapList& overlaps = grains_.overlaps();
    const fvMesh& mesh = grains_.mesh();

    share = scalarField(mesh.nCells(), Zero);
    flux = vectorField(mesh.nCells(), Zero);
    bool isAny = false;
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (!those[graini])
        {
            continue;
        }
        for (const cellOverlap& o : overlaps.of(graini))
        {
            const scalar w = o.volume/mesh.V()[o.cell];
            share[o.cell] += w;
            flux[o.cell] += w*grains_.motion().velocity(graini, o.arm);
            isAny = true;
        }
    }
    return returnReduce(isAny, orOp<bool>());
}
