/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedTerm.H"

Foam::chosenOption Foam::resolvedTerm::chosen
(
    const dictionary& coupling,
    const bool isPossible
)
{
    return couplingOption
    (
        coupling, "resolvedGrains", wordList({"locked", "cutCells"}),
        {"from", 4, 2, 100}, isPossible
    );
}


Foam::scalarField Foam::resolvedTerm::entrained
(
    const grainSystem& grains,
    const buoyancy& weight
) const
{
    // Over the fluid displaced by a sphere, and a disc, that touches a plane: 0.80
    // and 2.29.  Never more than what cells have: it would make the grain faster.
    constexpr scalar ofSphere = 0.75, ofDisc = 2;

    scalarField result(grains.size(), Zero);
    if (!isActive() || grains.motion().isFixed())
    {
        return result;
    }
    const label D = grains.mesh().nGeometricD();
    const scalarField displaced(weight.displaced());
    forAll(result, i)
    {
        if (!isResolved(i))
        {
            continue;
        }
        // A slender one that goes along its axis
        scalar extent = 0;
        for (const grainMember& body : grains.members(i))
        {
            extent = max
            (
                extent,
                body.radius
              + mag(grains.shortest(body.centre - grains.centres()[i]))
            );
        }
        result[i] =
            (D == 2 ? ofDisc : ofSphere)
           *pow(0.5*grains.fluidDiameter(i)/extent, D)
           *displaced[i]/grains.motion().density(i);
    }
    return result;
}


Foam::tmp<Foam::volScalarField> Foam::resolvedTerm::amongSmall
(
    const volScalarField& fluidShare
) const
{
    if (!leavesParts())
    {
        return fluidShare + (1 - open());
    }
    const volScalarField open("open", this->open());
    const volScalarField covered("covered", 1 - pos(open));
    return (fluidShare + covered)/(open + covered);
}


void Foam::resolvedTerm::predict
(
    fvVectorMatrix& UEqn,
    const volVectorField& pressureForce
) const
{
    solve(UEqn == -pressureForce);
}


Foam::tmp<Foam::surfaceScalarField> Foam::resolvedTerm::onFaces
(
    const tmp<surfaceScalarField>& others,
    const tmp<surfaceScalarField>& locked
) const
{
    if (!isActive())
    {
        locked.clear();
        return others;
    }
    return (1 - lockedFaces())*others + lockedFaces()*locked;
}
