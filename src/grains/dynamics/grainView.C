/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainView.H"

namespace Foam
{
    defineTypeName(grainView);
    const word grainView::registryName("grains");
}


Foam::grainView::grainView(const fvMesh& mesh, const word& name)
:
    regIOobject
    (
        IOobject(name, mesh.time().timeName(), mesh)
    )
{}


const Foam::grainView& Foam::grainView::of
(
    const fvMesh& mesh,
    const word& askedBy
)
{
    const grainView* grainsPtr = mesh.cfindObject<grainView>(registryName);
    if (!grainsPtr)
    {
        FatalErrorInFunction
            << "Function object " << askedBy
            << " finds no grains: this solver has none" << nl
            << "    allowed: the solvers of grainFoam" << exit(FatalError);
    }
    return *grainsPtr;
}
