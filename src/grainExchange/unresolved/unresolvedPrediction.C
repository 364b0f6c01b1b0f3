/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "motionInStep.H"
#include "unresolvedTerm.H"

Foam::scalarField Foam::unresolvedTerm::room(const resolvedTerm& resolved) const
{
    scalarField result(grains_.mesh().V());
    if (resolved.leavesParts())
    {
        const volScalarField open("open", resolved.open());
        forAll(result, celli)
        {
            result[celli] *= max(open[celli] + resolved.liquidIn(celli), SMALL);
        }
    }
    return result;
}


Foam::unresolvedTerm::grainInStep Foam::unresolvedTerm::inStep
(
    const label graini,
    const scalar displaced
) const
{
    const grainMotion& grains = grains_.motion();
    const grainMotion::twist motion(grains.motion(graini));
    const grainMotion::twist unexpected(grains.unexpectedChange(graini));
    return
    {
        graini,
        motion,
        {motion.velocity - unexpected.velocity, motion.spin - unexpected.spin},
        motionInStep
        (
            grains, weight_, graini, motion, displaced,
            grains_.mesh().time().deltaTValue()
        )
    };
}


void Foam::unresolvedTerm::addInCellOfLiquid
(
    const cellOverlap& o,
    const scalar w,
    const resolvedTerm& resolved,
    exchangeFields& fields
) const
{
    const implicitTransfer<vector>& t = transfer_[o.index];

    // The body has the cell's volume, and its liquid the reaction to buoyancy and to
    // its own acceleration (doc/theory, eq. 10.3)
    const scalar accelerated =
        t.a*fluid_.rho()[o.cell]/grains_.mesh().time().deltaTValue();
    fields.beta[o.cell] += w*(t.a*t.gamma + accelerated);
    fields.b[o.cell] +=
        w
       *(
            t.a*t.gamma*t.free
          + accelerated*resolved.liquidVelocity(o.cell)
          - knownForce_[o.index]
        )
      - weight_.forceInCell(w, o.cell);
}


void Foam::unresolvedTerm::addInFluid
(
    const grainInStep& grain,
    const cellOverlap& o,
    const scalar w,
    const scalar eps,
    const vector& U,
    exchangeFields& fields
) const
{
    // Of the volume: what passes a cell that fixed grains cover
    constexpr scalar least = 1e-3;

    const bool isFixed = grains_.motion().isFixed();
    const bool covers = undisturbed_.of(grain.index).covers;
    const scalar deltaT = grains_.mesh().time().deltaTValue();
    const scalar rhop = grains_.motion().density(grain.index);
    const implicitTransfer<vector>& t = transfer_[o.index];
    const vector& e = knownForce_[o.index];
    const vector& faster = at_.velocity(o);
    const vector own(grain.free.at(o.arm) + deltaT/rhop*e);

    const scalar wa = w*t.a;
    const scalar wag = wa*t.gamma;
    const scalar wat = wa*deltaT/rhop;
    fields.kappa[o.cell] +=
        isFixed ? w*max(least - eps, scalar(0)) : wat*t.gamma;
    fields.beta[o.cell] += wag;
    fields.b[o.cell] += wag*t.free - w*e;
    const vector flux(wa*own + w*(1 - t.a)*faster);
    fields.G[o.cell] += flux;
    fields.gained[o.cell] += flux + w*((1 - t.a)*U - grain.known.at(o.arm));
    fields.mobile[o.cell] += isFixed ? 0 : wa;
    if (isFixed)
    {
        fields.betaOfLayers[o.cell] +=
            flowAtOverlaps::share
            (
                grains_.fluidDiameter(grain.index)
               /undisturbed_.cellSize()[o.cell]
            )
           *w*max(t.gamma - dragOfAddedMass(fluid_.rho()[o.cell]), scalar(0));
    }
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


void Foam::unresolvedTerm::predict
(
    const grainInStep& grain,
    const cellOverlap& o,
    const scalar room,
    const scalar cellEps,
    const vector& U,
    const resolvedTerm& resolved,
    exchangeFields& fields
)
{
    const scalar deltaT = grains_.mesh().time().deltaTValue();
    const scalar rhop = grains_.motion().density(grain.index);
    const scalar eps = max(cellEps, exchangeFields::epsMin);
    const vector velocity(grain.motion.at(o.arm));
    const vector& faster = at_.velocity(o);
    const vector own(grain.free.at(o.arm) + deltaT/rhop*knownForce_[o.index]);
    transfer_[o.index] =
        implicitTransfer<vector>
        (
            gamma
            (
                grain.index,
                fluid_.rho()[o.cell],
                fluid_.mu()[o.cell],
                o.volume/room,
                resolved.isLiquid(o.cell),
                eps,
                U + faster - velocity
            ),
            deltaT,
            rhop,
            own - faster
        );

    scalar w = o.volume/grains_.mesh().V()[o.cell];
    if (resolved.leavesParts())
    {
        fields.solid[o.cell] += w;
        fields.solidFlux[o.cell] += w*velocity;
    }
    const scalar inLiquid = resolved.inLiquid(o);
    if (inLiquid > 0)
    {
        addInLiquid(grain.index, o, grain.free, eps, resolved, fields);
        w *= 1 - inLiquid;
    }
    if (resolved.isLiquid(o.cell))
    {
        addInCellOfLiquid(o, w, resolved, fields);
        return;
    }
    addInFluid(grain, o, w, cellEps, U, fields);
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
    const scalarField room(this->room(resolved));
    transfer_.resize(overlaps.size());
    if (resolved.leavesParts())
    {
        inLiquid_.resize(overlaps.size());
    }

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
        const grainInStep grain(inStep(graini, displaced[graini]));
        for (const cellOverlap& o : overlaps.of(graini))
        {
            predict
            (
                grain, o, room[o.cell], cellEps[o.cell], U[o.cell], resolved, fields
            );
        }
    }
}
