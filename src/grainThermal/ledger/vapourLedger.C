/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vapourLedger.H"

Foam::vapourLedger::vapourLedger(const vapour& steam, const fvMesh& mesh)
:
    vapour_(steam),
    progress_(mesh.time()),
    amount_(0)
{
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (!patch.coupled() && patch.type() != "empty")
        {
            patches_.append(patchi);
        }
    }
}


void Foam::vapourLedger::endStep(const transportFlux& flux)
{
    if (!vapour_.isActive())
    {
        return;
    }
    const fluidScalar& psi = vapour_.psi();
    const scalarField& values = psi.field().primitiveField();
    const scalar least = gMin(values), most = gMax(values);

    scalar largest = max(VSMALL, psi.magnitude(flux));
    for (const label patchi : patches_)
    {
        largest = max(largest, mag(psi.carriedOut()[patchi]));
        largest = max(largest, mag(psi.diffusedOut()[patchi]));
    }
    largest = max(largest, mag(psi.broughtIn()));
    const scalar error = mag(psi.unaccounted())/largest;
    amount_ = psi.integral(flux);

    Info<< "Vapour    " << amount_ << " m^3, psi " << least << " to " << most
        << ", unaccounted for " << error << endl;
    if (Pstream::master())
    {
        write(error, least, most);
    }
}


void Foam::vapourLedger::write
(
    const scalar error,
    const scalar least,
    const scalar most
)
{
    const char c = ',';
    const fluidScalar& psi = vapour_.psi();
    const fvMesh& mesh = psi.field().mesh();
    if (!file_)
    {
        string names("time,vapour,");
        for (const label patchi : patches_)
        {
            const word& name = mesh.boundary()[patchi].name();
            names += "convected_" + name + ",diffused_" + name + c;
        }
        names += "filled,error,leastPsi,mostPsi";
        file_ =
            progress_.newFile("vapourLedger", "vapourLedger.csv", names.c_str());
    }
    file_() << mesh.time().value() << c << amount_;
    for (const label patchi : patches_)
    {
        file_()
            << c << psi.carriedOut()[patchi] << c << psi.diffusedOut()[patchi];
    }
    file_()
        << c << psi.broughtIn() << c << error << c << least << c << most << endl;
}
