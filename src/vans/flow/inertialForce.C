/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inertialForce.H"

#include "faceMomentum.H"
#include "fvc.H"
#include "localMax.H"
#include "localMin.H"
#include "reconstruction.H"

namespace
{

//- Of a cell's inertia in that of a face
Foam::tmp<Foam::volScalarField> movingShare
(
    const Foam::stepCoefficients& step,
    const Foam::exchangeFields& grains
)
{
    return max(Foam::faceMomentum::moving(step, grains), Foam::scalar(Foam::SMALL));
}

}


Foam::inertialForce::inertialForce
(
    const stepCoefficients& step,
    const exchangeFields& grains,
    const volScalarField& rho
)
:
    step_(step),
    grains_(grains),
    whole_("whole", rho/rho.time().deltaT()),
    wholef_
    (
        "wholef",
        localMin<scalar>(rho.mesh()).interpolate(whole_)
       /(
            localMax<scalar>(rho.mesh()).interpolate(whole_)
           *fvc::interpolate(1/whole_)
        )
    ),
    around_("around", reconstruction::New(rho.mesh()).mean(wholef_)),
    inertia_
    (
        "inertia",
        1
       /(
            max(step.alpha, exchangeFields::epsMin)*step.share/step.eps
          + whole_*grains.K*step.still
        )
    ),
    part_
    (
        "part",
        movingShare(step, grains)*step.still*inertia_
    ),
    partf_
    (
        "partf",
        wholef_
       /(
            fvc::interpolate(movingShare(step, grains))
           *fvc::interpolate(step.still)
        )
    ),
    gain_("gain", grains.gained)
{}


Foam::tmp<Foam::volVectorField> Foam::inertialForce::inCells
(
    surfaceScalarField& ofFaces
) const
{
    forAll(ofFaces.boundaryField(), patchi)
    {
        fvsPatchScalarField& patch = ofFaces.boundaryFieldRef()[patchi];
        if (!patch.coupled() && !grains_.freePatches.found(patchi))
        {
            patch == 0;
        }
    }
    return reconstructed(ofFaces);
}


Foam::tmp<Foam::volVectorField> Foam::inertialForce::onGained
(
    const volVectorField& gained
) const
{
    surfaceScalarField ofFaces("onGained", partf_*fvc::flux(part_*gained));
    return inCells(ofFaces);
}


void Foam::inertialForce::solve
(
    volVectorField& rest,
    volVectorField& residual
) const
{
    constexpr label most = 12;
    constexpr scalar tolerance = 1e-4;

    const scalarField& V = rest.mesh().V();
    const auto product = [&V](const volVectorField& a, const volVectorField& b)
    {
        return gSum((V*(a.primitiveField() & b.primitiveField()))());
    };
    const volScalarField givesWay("givesWay", grains_.K*step_.still);
    const scalar enough = sqr(tolerance)*product(rest, rest);
    PtrList<volVectorField> ways(most);
    PtrList<volVectorField> images(most);
    scalarField sizes(most);
    for (label i = 0; i < most && product(residual, residual) > enough; ++i)
    {
        ways.set(i, new volVectorField("way", residual));
        images.set
        (
            i, new volVectorField("image", residual - onGained(givesWay*residual))
        );
        for (label j = 0; j < i; ++j)
        {
            const dimensionedScalar along
            (
                "along", dimless, product(images[i], images[j])/sizes[j]
            );
            ways[i] -= along*ways[j];
            images[i] -= along*images[j];
        }
        sizes[i] = product(images[i], images[i]);
        if (sizes[i] <= VSMALL)
        {
            return;
        }
        const dimensionedScalar length
        (
            "length", dimless, product(residual, images[i])/sizes[i]
        );
        rest += length*ways[i];
        residual -= length*images[i];
    }
}


Foam::tmp<Foam::volVectorField> Foam::inertialForce::gradient
(
    const surfaceScalarField& ofFaces,
    const surfaceScalarField& flux,
    const surfaceScalarField& oldFlux
) const
{
    const volScalarField& still = step_.still;
    const volVectorField drag
    (
        "drag", step_.bByShare - step_.betaByShare*reconstructed(flux)
    );
    const surfaceScalarField other
    (
        "other",
        (ofFaces - step_.phib + step_.betaf*flux)/fvc::interpolate(still)
    );
    const surfaceScalarField change("change", flux - oldFlux);
    const volVectorField accelerated(reconstructed(wholef_*change));
    surfaceScalarField known("known", other + partf_*fvc::interpolate(part_)*change);
    const volVectorField besides(inCells(known));

    // What grains gain has the gradient that is looked for
    const auto gained = [&](const volVectorField& rest)
    {
        return grains_.gained - grains_.K*(still*rest + drag);
    };
    volVectorField rest("rest", reconstructed(other));
    volVectorField residual("residual", besides - onGained(gained(rest)) - rest);
    solve(rest, residual);

    gain_ = gained(rest);
    return
        still
       *(besides - onGained(gain_) - inertia_*(accelerated - (around_ & gain_)))
      + drag;
}


Foam::tmp<Foam::scalarField> Foam::inertialForce::atPatch
(
    const label patchi,
    const scalarField& change
) const
{
    const fvPatch& patch = gain_.mesh().boundary()[patchi];
    const labelUList& cells = patch.faceCells();
    const vectorField normal(patch.nf());
    tmp<scalarField> tresult(new scalarField(patch.size()));
    forAll(cells, i)
    {
        const label celli = cells[i];
        tresult.ref()[i] =
            step_.still[celli]*inertia_[celli]*whole_[celli]
           *((gain_[celli] & normal[i]) - change[i]/patch.magSf()[i]);
    }
    return tresult;
}
