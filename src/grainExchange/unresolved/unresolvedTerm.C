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


Foam::scalar Foam::unresolvedTerm::dragOfAddedMass(const label celli) const
{
    return
        addedMass_*fluid_.rho()[celli]/grains_.mesh().time().deltaTValue();
}


Foam::scalar Foam::unresolvedTerm::gamma
(
    const label graini,
    const cellOverlap& o,
    const scalar share,
    const bool isLiquid,
    const scalar eps,
    const vector& slip
) const
{
    const selfInduced::drag grain
    {
        *drag_,
        grains_.lawDiameter(graini),
        fluid_.rho()[o.cell],
        fluid_.mu()[o.cell]
    };
    return
        (
            isLiquid
          ? undisturbed_.gammaInLiquid(grain, share, eps, mag(slip))
          : undisturbed_.gamma(graini, grain, share, eps, mag(slip))
        )
      + dragOfAddedMass(o.cell);
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

    // Of the cells, what resolved grains leave
    scalarField room(V);
    if (resolved.leavesParts())
    {
        room *= max(resolved.open()().primitiveField(), SMALL);
    }

    transfer_.resize(overlaps.size());
    const bool isFixed = grains_.motion().isFixed();

    // Of the whole grain: where it lies in the surface of two fluids, its parts in
    // them would fall and rise by themselves in what the fluid expects
    const scalarField displaced(weight_.displaced());
    setKnownForce(U);
    undisturbed_.set(grains_, resolved, fluid_, cellEps, U, *drag_);

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (overlaps.of(graini).empty() || resolved.isResolved(graini))
        {
            continue;
        }
        const scalar rhop = grains_.motion().density(graini);
        const grainMotion::twist motion(grains_.motion().motion(graini));
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
            const implicitTransfer<vector>& t = transfer_[o.index] =
                implicitTransfer<vector>
                (
                    gamma
                    (
                        graini,
                        o,
                        o.volume/room[o.cell],
                        resolved.isLiquid(o.cell),
                        max(cellEps[o.cell], exchangeFields::epsMin),
                        U[o.cell] - motion.at(o.arm)
                    ),
                    deltaT,
                    rhop,
                    free.at(o.arm) + deltaT/rhop*e
                );

            const scalar w = o.volume/V[o.cell];
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
            fields.kappa[o.cell] += wat*t.gamma;
            fields.beta[o.cell] += wag;
            fields.b[o.cell] += wag*t.free - w*e;
            fields.G[o.cell] += wa*t.free;
            fields.mobile[o.cell] += isFixed ? 0 : wa;
            fields.passing[o.cell] += covers ? w : wa;
            fields.passingG[o.cell] += (covers ? w : wa)*t.free;
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
