/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vapour.H"

#include "dictionaryInput.H"
#include "meanOverGrains.H"

Foam::vapour::vapour
(
    const fvMesh& mesh,
    const singleFluid& fluid,
    const diffusionAmongGrains& diffusion
)
:
    fluid_(fluid),
    diffusion_(diffusion),
    D_("D", dimViscosity, 0)
{
    if (!fluid.properties().found("vapour"))
    {
        return;
    }
    const dictionary& dict =
        dictionaryInput::subDict(fluid.properties(), "vapour");
    dictionaryInput::checkKeywords(dict, {"D"});
    D_.value() = dictionaryInput::getScalar(dict, "D", dimViscosity, 0);

    psi_.reset(new fluidScalar(mesh, "psi"));
    const volScalarField& psi = psi_->field();
    dictionaryInput::checkDimensions(psi, psi.dimensions(), dimless);
    checkShares("internalField", psi.primitiveField());
    for (const fvPatchScalarField& patch : psi.boundaryField())
    {
        checkShares("boundaryField." + patch.patch().name(), patch);
    }
}


void Foam::vapour::checkShares
(
    const string& keyword,
    const scalarField& psi
) const
{
    // As runs that go on may have it: diffusion between cells that are not
    // orthogonal has no bounds
    constexpr scalar beyond = 1e-3;
    const scalar least = min(psi), most = max(psi);
    if (psi.size() && !(least >= -beyond && most <= 1 + beyond))
    {
        FatalErrorInFunction
            << "Keyword '" << keyword.c_str() << "' of the file "
            << psi_->field().objectPath() << " has the value "
            << (least >= -beyond ? most : least) << nl
            << "    allowed: 0 to 1 []" << exit(FatalError);
    }
}


void Foam::vapour::beforeMeshChange(const transportFlux& flux)
{
    if (isActive())
    {
        psi_->beforeMeshChange(flux);
    }
}


void Foam::vapour::meshChanged(const transportFlux& flux)
{
    if (isActive())
    {
        psi_->meshChanged(flux);
    }
}


void Foam::vapour::tell(grainSystem& grains, const scalarField& eps) const
{
    if (!isActive())
    {
        return;
    }
    // Where a grain leaves no fluid in its cells psi is an old one
    const scalarField& psi = psi_->field();
    const scalarField room(meanOverGrains(grains, eps));
    const scalarField inRoom(meanOverGrains(grains, eps*psi));
    scalarField ambient(meanOverGrains(grains, psi));
    forAll(ambient, graini)
    {
        if (room[graini] > 1e-6)
        {
            ambient[graini] = inRoom[graini]/room[graini];
        }
    }
    grains.setAmbient(ambient);
}


Foam::tmp<Foam::surfaceScalarField> Foam::vapour::diffusivity
(
    const volScalarField& open
) const
{
    tmp<surfaceScalarField> tresult(D_*diffusion_.onFaces(open));
    fluid_.addTurbulence(tresult.ref(), open);
    return tresult;
}


void Foam::vapour::carry(const transportFlux& flux)
{
    if (isActive())
    {
        carry(flux, diffusivity(flux.fraction()), cellExchange());
    }
}


void Foam::vapour::carry
(
    const transportFlux& flux,
    const surfaceScalarField& diffusivity,
    const cellExchange& exchange
)
{
    psi_->carry(flux, diffusivity, exchange);
}
