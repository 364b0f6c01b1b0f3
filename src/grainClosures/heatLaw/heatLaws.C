/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ChurchillBernstein.H"
#include "Gunn.H"
#include "heatLawWithoutCoefficients.H"
#include "LiMason.H"
#include "RanzMarshall.H"
#include "WakaoKaguei.H"

addHeatLawWithoutCoefficients(ChurchillBernstein)
addHeatLawWithoutCoefficients(Gunn)
addHeatLawWithoutCoefficients(LiMason)
addHeatLawWithoutCoefficients(RanzMarshall)
addHeatLawWithoutCoefficients(WakaoKaguei)
