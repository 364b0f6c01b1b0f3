/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Beetstra.H"
#include "DiFelice.H"
#include "ErgunWenYu.H"
#include "KochHill.H"
#include "Rong.H"
#include "SchillerNaumann.H"
#include "Stokes.H"
#include "thesisPrinted.H"
#include "withoutCoefficients.H"

addDragLawWithoutCoefficients(Beetstra)
addDragLawWithoutCoefficients(DiFelice)
addDragLawWithoutCoefficients(ErgunWenYu)
addDragLawWithoutCoefficients(KochHill)
addDragLawWithoutCoefficients(Rong)
addDragLawWithoutCoefficients(SchillerNaumann)
addDragLawWithoutCoefficients(Stokes)
addDragLawWithoutCoefficients(thesisPrinted)
