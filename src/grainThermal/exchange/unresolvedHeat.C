/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unresolvedHeat.H"

#include "dictionaryInput.H"
#include "gatheredExchange.H"

Foam::unresolvedHeat::unresolvedHeat
(
    const grainSystem& grains,
    const carrier& fluid,
    const conductor& heat
)
:
    grains_(grains),
    fluid_(fluid),
    conductor_(heat),
    law_
    (
        heatLaw::New
        (
            dictionaryInput::subDict(grains.motion().coupling(), "heatTransfer"),
            grains.mesh().nGeometricD()
        )
    ),
    hasWarned_(false)
{}


Foam::surroundings Foam::unresolvedHeat::ofFluid(const label celli) const
{
    return
    {
        fluid_.rho()[celli],
        fluid_.mu()[celli],
        conductor_.kappa()[celli],
        conductor_.capacity(celli)
    };
}


Foam::scalar Foam::unresolvedHeat::h
(
    const label graini,
    const cellOverlap& o,
    const surroundings& around,
    const scalar cellEps,
    const scalar cellSlip,
    const undisturbedFlow::correction& own
) const
{
    const scalar share = o.volume/grains_.mesh().V()[o.cell];
    const scalar eps =
        own.share*own.eps
      + (1 - own.share)*min(cellEps + own.lone*share, scalar(1));
    const scalar slip =
        own.share*own.slip + (1 - own.share)*own.slipFactor*cellSlip;
    const scalar d = grains_.lawDiameter(graini);
    const scalar Re = around.rho*slip*d/around.mu;
    const scalar Pr = around.mu*around.capacity/(around.rho*around.kappa);

    const scalar Nu = law_->Nu(max(eps, law_->leastEps()), Re, Pr);
    return
        law_->perVolume(Nu, around.kappa, d)
       *selfInduced::heatFactor(Nu, Re*Pr, own.lone, d, own.length);
}


void Foam::unresolvedHeat::warn(heatLaw::range used)
{
    if (hasWarned_)
    {
        return;
    }
    reduce(used.leastEps, minOp<scalar>());
    reduce(used.mostRe, maxOp<scalar>());

    const heatLaw::range tried(law_->tried());
    if (used.leastEps < tried.leastEps || used.mostRe > tried.mostRe)
    {
        hasWarned_ = true;
        WarningInFunction
            << "The law of coupling/heatTransfer was found for fluid fractions"
            << " from " << tried.leastEps
            << " and superficial Reynolds numbers up to "
            << tried.mostRe << nl
            << "    here are a fluid fraction of " << used.leastEps
            << " and a Reynolds number of " << used.mostRe << " (said once)"
            << endl;
    }
}


void Foam::unresolvedHeat::add
(
    const grainFluidExchange& exchange,
    const volVectorField& U,
    const otherHeat* others,
    cellHeat& cells
)
{
    const tmp<volScalarField> teps(exchange.epsOfLaws());
    const volScalarField& eps = teps();
    const resolvedTerm& resolved = exchange.resolved();
    const overlapList& overlaps = grains_.overlaps();
    const scalarField& V = grains_.mesh().V();

    const List<undisturbedFlow::correction> undisturbed
    (
        exchange.unresolved().undisturbed().all(grains_.size())
    );

    flowAtOverlaps at;
    at.set
    (
        grains_, resolved, exchange.unresolved().undisturbed().cellSize(), U
    );

    heatLaw::range used{1, 0};
    conductance_ = scalarField(overlaps.size(), Zero);
    toOthers_.clear();
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (overlaps.of(graini).empty() || resolved.isResolved(graini))
        {
            continue;
        }
        const grainMotion::twist motion(grains_.motion().motion(graini));
        const undisturbedFlow::correction& own = undisturbed[graini];

        for (const cellOverlap& o : overlaps.of(graini))
        {
            const scalar slip =
                mag(U[o.cell] + at.velocity(o) - motion.at(o.arm));
            used.leastEps = min(used.leastEps, eps[o.cell]);
            used.mostRe = max
            (
                used.mostRe,
                eps[o.cell]*fluid_.rho()[o.cell]*slip
               *grains_.lawDiameter(graini)/fluid_.mu()[o.cell]
            );
            const scalar cellEps = max(eps[o.cell], exchangeFields::epsMin);
            const scalar share = others ? others->share(o) : 0;
            if (share > 0)
            {
                toOthers_.resize(overlaps.size(), 0);
                toOthers_[o.index] =
                    share*o.volume
                   *h
                    (
                        graini, o, others->ofShare(), cellEps, slip,
                        undisturbedFlow::correction()
                    );
            }
            conductance_[o.index] =
                (1 - share)*o.volume
               *h(graini, o, ofFluid(o.cell), cellEps, slip, own);
        }
    }
    warn(used);

    scalarField lone(undisturbed.size());
    forAll(lone, graini)
    {
        lone[graini] = undisturbed[graini].lone;
    }
    gatherExchange
    (
        grains_, exchange.unresolved().undisturbed().cellSize(), lone, conductance_
    );
    scalarField coefficient(V.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            coefficient[o.cell] += conductance_[o.index]/V[o.cell];
        }
    }
    grains_.voidFraction().smooth(coefficient);
    cells.coefficient += coefficient;
}
