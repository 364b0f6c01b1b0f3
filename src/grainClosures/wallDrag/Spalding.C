/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Spalding.H"

Foam::scalar Foam::wallShearRatio(const scalar Re)
{
    constexpr scalar kappa = 0.41, E = 9.8;

    // Of laminar layers 1 to 1e-11; what is more than that would be round-off
    constexpr scalar laminar = 1e-5;
    if (Re < laminar)
    {
        return 1;
    }

    // Both are beyond the solution; from there Newton's steps only come nearer
    scalar u = min(sqrt(Re), 2 + log(1 + E*Re)/kappa);
    for (label i = 0; i < 50; ++i)
    {
        const scalar k = kappa*u;
        const scalar e = exp(k);
        const scalar y = u + (e - 1 - k - sqr(k)/2 - pow3(k)/6)/E;
        const scalar slope = 1 + kappa*(e - 1 - k - sqr(k)/2)/E;
        const scalar step = (u*y - Re)/(y + u*slope);
        u -= step;
        if (mag(step) < 1e-12*u)
        {
            break;
        }
    }
    return Re/sqr(u);
}
