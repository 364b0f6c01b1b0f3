/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Kader.H"

Foam::scalar Foam::wallHeatRatio(const scalar yPlus, const scalar Pr)
{
    const scalar conducted = Pr*yPlus;
    const scalar Gamma = 0.01*pow4(conducted)/(1 + 5*pow3(Pr)*yPlus);
    if (Gamma < SMALL)
    {
        return 1;
    }
    const scalar beta = sqr(3.85*cbrt(Pr) - 1.3) + 2.12*log(Pr);
    const scalar T =
        conducted*exp(-Gamma) + (2.12*log(1 + yPlus) + beta)*exp(-1/Gamma);
    return max(conducted/T, scalar(1));
}
