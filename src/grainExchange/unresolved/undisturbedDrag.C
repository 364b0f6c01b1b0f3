/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "undisturbedFlow.H"

Foam::scalar Foam::undisturbedFlow::weight(const scalar x)
{
    const scalar log = std::log2(x);
    return min(max(min(2*(log + 1), (2 - log)/1.5), scalar(0)), scalar(1));
}


Foam::undisturbedFlow::correction Foam::undisturbedFlow::correctionOf
(
    const flowAround& flow,
    const vector& v,
    const selfInduced::drag& grain,
    const scalar diameter
) const
{
    const scalar x = diameter/max(flow.cellSize, VSMALL);

    correction result;
    result.covers = exact_ && x > std::sqrt(2.0);
    if (width_ == 0 || flow.volume <= 0)
    {
        return result;
    }

    // In the plane a lone body in creeping flow has no speed to compare with
    selfInduced::neighbours around;
    around.eps = flow.filteredEps;
    scalar Lambda = 0;
    if (mesh_.nGeometricD() == 3)
    {
        around = selfInduced::neighboursOf
        (
            flow.eps, flow.filteredEps, flow.ownShare, x
        );
        result.length = std::cbrt(flow.volume/flow.ownShare);
        Lambda = selfInduced::inCells(grain.d/result.length);
        const vector slip(flow.U - v);
        const vector e(slip/max(mag(slip), VSMALL));
        result.lone = around.lone;
        result.slipFactor = selfInduced::slipFactor
        (
            grain, flow.volume, around, Lambda, {0.3, e & flow.section & e},
            mag(slip)
        );
    }

    result.share = weight(x);
    if (result.share > 0)
    {
        const scalar filteredSlip = mag(flow.filteredU - v);
        result.eps = around.eps;
        result.slip =
            filteredSlip
           *selfInduced::slipFactor
            (
                grain, flow.volume, around,
                selfInduced::inFilteredFlow(Lambda, width_), {0.15, 1}, filteredSlip
            );
        result.coefficient =
            coefficient(flow, v, grain, result.eps, result.slip);
    }
    return result;
}


Foam::scalar Foam::undisturbedFlow::coefficient
(
    const flowAround& flow,
    const vector& v,
    const selfInduced::drag& grain,
    const scalar eps,
    const scalar undisturbedSlip
) const
{
    // Of a grain that moves with the fluid, the law's own coefficient remains
    const vector w(flow.U - v);
    const scalar least = 1e-8*grain.mu/(grain.rho*grain.d);
    const scalar slip = mag(w) + least;

    scalar drag = (undisturbedSlip + least)*grain.gamma(eps, undisturbedSlip);
    if (gradientOnGrains_)
    {
        const vector excess(flow.filteredGradP - flow.gradP);
        drag = max(drag - (excess & w)/slip, 0.05*drag);
    }
    else
    {
        drag /= eps;
    }
    return drag/slip;
}


Foam::scalar Foam::undisturbedFlow::gamma
(
    const label graini,
    const selfInduced::drag& grain,
    const scalar share,
    const scalar eps,
    const scalar slip
) const
{
    const scalar form = gradientOnGrains_ ? 1 : 1/eps;
    if (!isActive_)
    {
        return form*grain.gamma(eps, slip);
    }
    const correction& own = corrections_[graini];
    if (own.share >= 1)
    {
        return own.coefficient;
    }

    const scalar inCell =
        own.covers
      ? form*grain.law.gammaInCoveredCell(eps, slip, grain.d, grain.rho, grain.mu)
      : form*own.slipFactor*grain.gamma
        (
            min(eps + own.lone*share, scalar(1)), own.slipFactor*slip
        );
    return
        own.share <= 0
      ? inCell
      : std::pow(own.coefficient, own.share)*std::pow(inCell, 1 - own.share);
}
