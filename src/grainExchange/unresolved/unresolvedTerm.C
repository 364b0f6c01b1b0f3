/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unresolvedTerm.H"

#include "dictionaryInput.H"
#include "motionInStep.H"

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


void Foam::unresolvedTerm::predict
(
    const volScalarField& cellEps,
    const volVectorField& U,
    const resolvedTerm& resolved,
    exchangeFields& fields
)
{
    const overlapList& overlaps = grains_.overlaps();
    const scalar deltaT = grains_.mesh().time().deltaTValue();
    const scalarField& V = grains_.mesh().V();

    // Of the cells, what bodies that grains do not enter leave
    scalarField room(V);
    if (resolved.leavesParts())
    {
        const volScalarField open("open", resolved.open());
        forAll(room, celli)
        {
            room[celli] *= max(open[celli] + resolved.liquidIn(celli), SMALL);
        }
        inLiquid_.resize(overlaps.size());
    }

    transfer_.resize(overlaps.size());
    const bool isFixed = grains_.motion().isFixed();

    // Of the volume: what passes a cell that fixed grains cover
    constexpr scalar least = 1e-3;

    // Of the whole grain: where it lies in the surface of two fluids, its parts in
    // them would fall and rise by themselves in what the fluid expects
    const scalarField displaced(weight_.displaced());
    at_.set(grains_, resolved, undisturbed_.cellSize(), U);
    setKnownForce(U);
    undisturbed_.set(grains_, resolved, fluid_, cellEps, U, at_, *drag_);

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (overlaps.of(graini).empty() || resolved.isResolved(graini))
        {
            continue;
        }
        const scalar rhop = grains_.motion().density(graini);
        const grainMotion::twist motion(grains_.motion().motion(graini));
        const grainMotion::twist unexpected(grains_.motion().unexpectedChange(graini));
        const grainMotion::twist known
        {
            motion.velocity - unexpected.velocity, motion.spin - unexpected.spin
        };
        const bool covers = undisturbed_.of(graini).covers;
        const grainMotion::twist free
        (
            motionInStep
            (
                grains_.motion(),
                weight_,
                graini,
                motion,
                displaced[graini],
                deltaT
            )
        );

        for (const cellOverlap& o : overlaps.of(graini))
        {
            const vector& e = knownForce_[o.index];
            const vector& faster = at_.velocity(o);
            const vector own(free.at(o.arm) + deltaT/rhop*e);
            const implicitTransfer<vector>& t = transfer_[o.index] =
                implicitTransfer<vector>
                (
                    gamma
                    (
                        graini,
                        fluid_.rho()[o.cell],
                        fluid_.mu()[o.cell],
                        o.volume/room[o.cell],
                        resolved.isLiquid(o.cell),
                        max(cellEps[o.cell], exchangeFields::epsMin),
                        U[o.cell] + faster - motion.at(o.arm)
                    ),
                    deltaT,
                    rhop,
                    own - faster
                );

            scalar w = o.volume/V[o.cell];
            if (resolved.leavesParts())
            {
                fields.solid[o.cell] += w;
                fields.solidFlux[o.cell] += w*motion.at(o.arm);
            }
            const scalar inLiquid = resolved.inLiquid(o);
            if (inLiquid > 0)
            {
                addInLiquid
                (
                    graini, o, free, max(cellEps[o.cell], exchangeFields::epsMin),
                    resolved, fields
                );
                w *= 1 - inLiquid;
            }
            if (resolved.isLiquid(o.cell))
            {
                // The body has the cell's volume, and its liquid the reaction to
                // buoyancy and to its own acceleration (doc/theory, eq. 10.3)
                const scalar accelerated = t.a*fluid_.rho()[o.cell]/deltaT;
                fields.beta[o.cell] += w*(t.a*t.gamma + accelerated);
                fields.b[o.cell] +=
                    w
                   *(
                        t.a*t.gamma*t.free
                      + accelerated*resolved.liquidVelocity(o.cell)
                      - e
                    )
                  - weight_.forceInCell(w, o.cell);
                continue;
            }
            const scalar wa = w*t.a;
            const scalar wag = wa*t.gamma;
            const scalar wat = wa*deltaT/rhop;
            fields.kappa[o.cell] +=
                isFixed ? w*max(least - cellEps[o.cell], scalar(0)) : wat*t.gamma;
            fields.beta[o.cell] += wag;
            fields.b[o.cell] += wag*t.free - w*e;
            const vector flux(wa*own + w*(1 - t.a)*faster);
            fields.G[o.cell] += flux;
            fields.gained[o.cell] +=
                flux + w*((1 - t.a)*U[o.cell] - known.at(o.arm));
            fields.mobile[o.cell] += isFixed ? 0 : wa;
            fields.passing[o.cell] += covers ? w : wa;
            fields.passingG[o.cell] += covers ? w*own : flux;
            if (!covers)
            {
                fields.bBeside[o.cell] += wag*t.free - w*e;
                fields.betaBeside[o.cell] += wag;
            }
            if (gradientOnGrains_)
            {
                fields.K[o.cell] += wat;
            }
        }
    }
}
