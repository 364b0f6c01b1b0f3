/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoFluidControls.H"

#include "dictionaryInput.H"
#include "fluidInput.H"
#include "fvMesh.H"
#include "vansTurbulence.H"

void Foam::checkTwoFluidControls(const fvMesh& mesh)
{
    checkPISO
    (
        mesh.solutionDict(), {"nOuterCorrectors", "correctPhi", "closeMomentum"},
        "PIMPLE"
    );
    const dictionary& dict = mesh.solutionDict().subDict("PIMPLE");
    dictionaryInput::getLabelOrDefault(dict, "nOuterCorrectors", 1, 1, 1);
    dictionaryInput::getWordOrDefault(dict, "closeMomentum", "no", {"yes", "no"});

    refuseFiles(mesh.time(), {"MRFProperties"});
    requireDictionaries
    (
        mesh.time(), {"turbulenceProperties", "fvOptions", "dynamicMeshDict"}
    );
    if (vansTurbulence::isSelected(mesh))
    {
        FatalErrorInFunction
            << "constant/turbulenceProperties: turbulence of two fluids with"
            << " grains is not in this solver" << nl
            << "    allowed: simulationType laminar" << exit(FatalError);
    }
}


void Foam::checkVoidFraction(const dictionary& coupling)
{
    const dictionary& dict = dictionaryInput::subDict(coupling, "voidFraction");
    dictionaryInput::getWord(dict, "type", {"exactOverlap", "diffused"});
}
