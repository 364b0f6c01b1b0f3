/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unresolvedTerm.H"

#include "dictionaryInput.H"

Foam::unresolvedTerm::unresolvedTerm
(
    const grainSystem& grains,
    const carrier& fluid,
    const bool gradientOnGrains
)
:
    grains_(grains),
    fluid_(fluid),
    weight_(grains, fluid),
    drag_
    (
        dragLaw::New
        (
            dictionaryInput::subDict(grains.motion().coupling(), "drag"),
            grains.mesh().nGeometricD()
        )
    ),
    addedMass_
    (
        dictionaryInput::getScalarOrDefault
        (
            grains.motion().coupling(), "addedMass", dimless, 0, 0
        )
    ),
    lift_(liftLaw::all(grains.motion().coupling())),
    gradientOnGrains_(gradientOnGrains),
    undisturbed_(grains, gradientOnGrains)
{}


Foam::scalar Foam::unresolvedTerm::dragOfAddedMass(const scalar rho) const
{
    return addedMass_*rho/grains_.mesh().time().deltaTValue();
}


Foam::scalar Foam::unresolvedTerm::gamma
(
    const label graini,
    const scalar rho,
    const scalar mu,
    const scalar share,
    const bool isLiquid,
    const scalar eps,
    const vector& slip
) const
{
    const selfInduced::drag grain{*drag_, grains_.lawDiameter(graini), rho, mu};
    const scalar own =
        (
            isLiquid
          ? undisturbed_.gammaInLiquid(grain, share, eps, mag(slip))
          : undisturbed_.gamma(graini, grain, share, eps, mag(slip))
        )
      + dragOfAddedMass(rho);
    if (!grains_.motion().isFixed())
    {
        return own;
    }

    // Times the drag of a bed that hardly lets the fluid through, and inertia
    constexpr scalar densest = 0.1, held = 1e4;

    const scalar inertia = rho/grains_.mesh().time().deltaTValue();
    return min(own, held*(inertia + grain.gamma(densest, mag(slip))));
}


Foam::vector Foam::unresolvedTerm::slipInLiquid
(
    const label graini,
    const cellOverlap& o,
    const resolvedTerm& resolved
) const
{
    return
        resolved.liquidVelocity(o.cell)
      - grains_.motion().motion(graini).at(o.arm);
}


void Foam::unresolvedTerm::addInLiquid
(
    const label graini,
    const cellOverlap& o,
    const grainMotion::twist& free,
    const scalar eps,
    const resolvedTerm& resolved,
    exchangeFields& fields
)
{
    const scalar deltaT = grains_.mesh().time().deltaTValue();
    const scalar V = grains_.mesh().V()[o.cell];
    const liquidOfBodies liquid(resolved.ofLiquid());
    const vector slip(slipInLiquid(graini, o, resolved));
    const scalar added = dragOfAddedMass(liquid.density);
    const scalar rhop = grains_.motion().density(graini);
    const implicitTransfer<vector>& t = inLiquid_[o.index] =
        implicitTransfer<vector>
        (
            gamma
            (
                graini, liquid.density, liquid.mu, o.volume/V, true, eps, slip
            ),
            deltaT,
            rhop,
            free.at(o.arm) - deltaT/rhop*added*slip
        );

    // The body has the cell's volume, and its liquid the reaction to buoyancy and to
    // its own acceleration (doc/theory, eq. 10.3)
    const scalar w = resolved.inLiquid(o)*o.volume/V;
    const scalar accelerated = t.a*liquid.density/deltaT;
    fields.betaOfBodies[o.cell] += w*(t.a*t.gamma + accelerated);
    fields.bOfBodies[o.cell] +=
        w
       *(
            t.a*t.gamma*t.free
          + accelerated*resolved.liquidVelocity(o.cell)
          + added*slip
        )
      - weight_.force(w, liquid.density);
}


Foam::vector Foam::unresolvedTerm::forceOfLiquid
(
    const label graini,
    const cellOverlap& o,
    const resolvedTerm& resolved
) const
{
    const scalar deltaT = grains_.mesh().time().deltaTValue();
    const implicitTransfer<vector>& t = inLiquid_[o.index];
    const scalar density = resolved.ofLiquid().density;
    const vector v(resolved.velocityOfLiquid(o.cell));
    return
        t.given(v, Zero)
      + t.a*density/deltaT*(v - resolved.liquidVelocity(o.cell))
      - dragOfAddedMass(density)*slipInLiquid(graini, o, resolved);
}
