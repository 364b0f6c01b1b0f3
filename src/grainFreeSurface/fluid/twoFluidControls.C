/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoFluidControls.H"

#include "dictionaryInput.H"
#include "fluidInput.H"
#include "fvMesh.H"
#include "vansTurbulence.H"

namespace
{

//- Cells would be divided in the direction that the mesh does not have
void refuseRefinementInPlane(const Foam::fvMesh& mesh)
{
    using namespace Foam;
    IOobject io
    (
        "dynamicMeshDict", mesh.time().constant(), mesh,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (mesh.nGeometricD() == 3 || !io.typeHeaderOk<IOdictionary>(true))
    {
        return;
    }
    const IOdictionary dict(io);
    const word keyword("dynamicFvMesh");
    const word type(dict.getOrDefault<word>(keyword, word::null));
    if (type.find("Refine") != std::string::npos)
    {
        dictionaryInput::badValue
        (
            dict, keyword, type,
            "refinement of meshes that are more than one cell thick; for others"
            " a graded mesh, or one of gmsh"
        );
    }
}

}


void Foam::checkTwoFluidControls(const fvMesh& mesh)
{
    checkPISO(mesh.solutionDict(), {"nOuterCorrectors", "correctPhi"}, "PIMPLE");
    const dictionary& dict = mesh.solutionDict().subDict("PIMPLE");
    dictionaryInput::getLabelOrDefault(dict, "nOuterCorrectors", 1, 1, 1);

    const dictionary& schemes =
        dictionaryInput::subDict(mesh.schemesDict(), "ddtSchemes");
    dictionaryInput::getWord
    (
        schemes, schemes.found("ddt(U)") ? "ddt(U)" : "default", {"Euler"}
    );

    refuseFiles(mesh.time(), {"MRFProperties"});
    requireDictionaries
    (
        mesh.time(), {"turbulenceProperties", "fvOptions", "dynamicMeshDict"}
    );
    refuseRefinementInPlane(mesh);
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
