/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "phaseFraction.H"

#include "dictionaryInput.H"

Foam::label Foam::phaseFraction::readControl
(
    const volScalarField& alpha,
    const word& keyword,
    const label deflt
)
{
    return dictionaryInput::getLabelOrDefault
    (
        alpha.mesh().solverDict(alpha.name()), keyword, deflt, 1
    );
}


void Foam::phaseFraction::checkControls(const volScalarField& alpha)
{
    const dictionary& dict = alpha.mesh().solverDict(alpha.name());
    // With those of a linear solver, which interFoam has here without MULESCorr
    dictionaryInput::checkKeywords
    (
        dict,
        {
            "MULESCorr", "nAlphaCorr", "nAlphaSubCycles", "nLimiterIter",
            "cAlpha", "icAlpha", "scAlpha", "alphaApplyPrevCorr",
            "smoothLimiter", "extremaCoeff", "boundaryExtremaCoeff",
            "solver", "preconditioner", "smoother", "nSweeps", "tolerance",
            "relTol", "minIter", "maxIter", "log",
            "agglomerator", "nCellsInCoarsestLevel", "mergeLevels",
            "cacheAgglomeration", "processorAgglomerator", "nPreSweeps",
            "preSweepsLevelMultiplier", "maxPreSweeps", "nPostSweeps",
            "postSweepsLevelMultiplier", "maxPostSweeps", "nFinestSweeps",
            "interpolateCorrection", "scaleCorrection", "directSolveCoarsest",
            "coarsestLevelCorr"
        }
    );
    const auto demand = [&](const word& keyword, const bool allowed)
    {
        if (dict.getOrDefault(keyword, allowed) != allowed)
        {
            dictionaryInput::badValue
            (
                dict, keyword, dictionaryInput::written(dict, keyword),
                allowed
              ? "yes: cells that grains cut have no Courant limit of their own"
              : "no"
            );
        }
    };
    demand("MULESCorr", true);
    demand("alphaApplyPrevCorr", false);
    for (const word keyword : {"icAlpha", "scAlpha"})
    {
        dictionaryInput::getScalarOrDefault(dict, keyword, dimless, 0, 0, 0);
    }
    dictionaryInput::getScalar(dict, "cAlpha", dimless, 0);
    // Without a default in MULES::limitCorr
    dictionaryInput::getLabel(dict, "nLimiterIter", 1);
}
