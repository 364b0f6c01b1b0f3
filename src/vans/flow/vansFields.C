/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vansFields.H"

#include "coupledPatches.H"
#include "dictionaryInput.H"
#include "fluidInput.H"
#include "fvcFlux.H"
#include "missingFields.H"

namespace
{

Foam::IOobject at
(
    const Foam::fvMesh& mesh,
    const Foam::word& name,
    const Foam::IOobject::readOption read
)
{
    using namespace Foam;
    return IOobject
    (
        name, mesh.time().timeName(), mesh, read, IOobject::AUTO_WRITE
    );
}


//- Fatal if a field of the start has absurd values
void checkMagnitude(const Foam::IOobject& io, const Foam::scalarField& magnitude)
{
    using namespace Foam;
    const scalar most = gMax(magnitude);
    if (!(most <= GREAT))
    {
        FatalErrorInFunction
            << "Keyword 'internalField' of the file " << io.objectPath()
            << " has a value of magnitude " << most << nl
            << "    allowed: finite values of at most " << GREAT
            << exit(FatalError);
    }
}

}


Foam::vansFields::vansFields(const fvMesh& mesh)
:
    p_rgh(at(mesh, "p_rgh", IOobject::MUST_READ), mesh),
    U(at(mesh, "U", IOobject::MUST_READ), mesh),
    phiU(at(mesh, "phiU", IOobject::READ_IF_PRESENT), fvc::flux(evaluateCoupled(U))),
    phiMomentum(at(mesh, "phiMomentum", IOobject::READ_IF_PRESENT), phiU),
    phiOpen(at(mesh, "phiOpen", IOobject::READ_IF_PRESENT), phiU),
    phi(at(mesh, "phi", IOobject::READ_IF_PRESENT), fvc::flux(U)),
    areOfStep(isThere(mesh, "phi"))
{
    dictionaryInput::checkDimensions(U, U.dimensions(), dimVelocity);
    dictionaryInput::checkDimensions(p_rgh, p_rgh.dimensions(), dimPressure);
    checkMagnitude(U, cmptMax(cmptMag(U.primitiveField())));
    checkMagnitude(p_rgh, mag(p_rgh.primitiveField()));
    mesh.solverDict(p_rgh.name());
    requireDivScheme(mesh, "div(tau)");
    refuseBounded(mesh, "div(phiEps,U)");
    refuseBounded(mesh, "div(rhoPhi,U)");
    reportMissingFields(mesh, {"phiU", "phi"}, "made from U");
}
