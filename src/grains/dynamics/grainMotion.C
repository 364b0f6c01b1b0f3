/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainDynamics.H"

Foam::autoPtr<Foam::grainMotion> Foam::grainMotion::New
(
    const fvMesh& mesh,
    const vector& g,
    const grainSet& set
)
{
    return
        isPlanar(mesh)
      ? autoPtr<grainMotion>(new grainDynamics<2>(mesh, g, set))
      : autoPtr<grainMotion>(new grainDynamics<3>(mesh, g, set));
}
