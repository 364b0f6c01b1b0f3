/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedGrains.H"

#include "byVolume.H"
#include "fvcSnGrad.H"
#include "implicitInSpin.H"
#include "meanOverGrains.H"

void Foam::resolvedGrains::addTorque
(
    const volVectorField& U,
    const surfaceScalarField& mu,
    vectorField& torque
) const
{
    if (!isActive_)
    {
        return;
    }

    const surfaceScalarField perLength(mu*mesh_.magSf());
    const surfaceVectorField flux
    (
        perLength
       *(
            conductance_*fvc::snGrad(U)
          + mesh_.nonOrthDeltaCoeffs()*wallJump_
        )
    );
    const surfaceScalarField perSpeed
    (
        perLength*conductance_*mesh_.nonOrthDeltaCoeffs()
    );

    // Torque of each grain, and how much less it would be per spin
    vectorField viscous(grains_.size(), Zero);
    tensorField resistance(grains_.size(), Zero);

    forFluidFaces
    (
        [&]
        (
            const side& inGrain,
            const side& inFluid,
            const label sign,
            const label patchi,
            const label facei
        )
        {
            const vector f(sign*resolvedFace::at(flux, patchi, facei));
            const label graini = label(inGrain.grain);
            const vector arm
            (
                between(grains_.centres()[graini], inFluid.x)
              + inMesh(inGrain.x - inFluid.x)
               /resolvedFace::at(conductance_, patchi, facei)
            );
            viscous[graini] += arm ^ f;
            resistance[graini] +=
                resolvedFace::at(perSpeed, patchi, facei)
               *(magSqr(arm)*tensor::I - arm*arm);
        }
    );
    sumOverRanks(viscous);
    sumOverRanks(resistance);

    const scalarField grainMu(meanOverGrains(grains_, fluid_.mu()));
    const grainMotion& motion = grains_.motion();
    const scalar deltaT = mesh_.time().deltaTValue();
    forAll(torque, graini)
    {
        if (!isResolved_[graini])
        {
            continue;
        }
        torque[graini] = implicitInSpin
        (
            motion,
            graini,
            deltaT,
            torque[graini]
          + viscous[graini]
          - 2*grainMu[graini]*grains_.mappedVolume()[graini]*motion.spin(graini),
            resistance[graini]
        );
    }
}


bool Foam::resolvedGrains::hasClusters() const
{
    if (!isActive_)
    {
        return false;
    }
    forAll(isResolved_, graini)
    {
        if (isResolved_[graini] && grains_.members(graini).size() > 1)
        {
            return true;
        }
    }
    return false;
}


void Foam::resolvedGrains::addPressureTorque
(
    const volScalarField& p_rgh,
    const volScalarField& p,
    vectorField& torque
) const
{
    // The pressure on a disc or sphere has no moment
    if (!hasClusters())
    {
        return;
    }
    const volScalarField fluid(1 - locked_);
    const volScalarField& rho = fluid_.rhoWeight();
    const surfaceScalarField part
    (
        max(byVolume(fluid), scalar(SMALL))
    );
    const surfaceScalarField pOfFluid(byVolume(fluid*p_rgh)/part);
    const surfaceScalarField rhoOfFluid(byVolume(fluid*rho)/part);
    const surfaceScalarField ofWeight(byVolume(fluid*(p - p_rgh))/part);
    const scalarField displaced(meanOverGrains(grains_, rho.primitiveField()));
    const vector g(grains_.motion().g());

    vectorField moment(grains_.size(), Zero), ofMean(moment);
    scalarField sum(grains_.size(), Zero), area(grains_.size(), VSMALL);
    forFluidFaces
    (
        [&]
        (
            const side& inGrain,
            const side& inFluid,
            const label sign,
            const label patchi,
            const label facei
        )
        {
            const label graini = label(inGrain.grain);
            if (grains_.members(graini).size() == 1)
            {
                return;
            }
            const point x(resolvedFace::at(mesh_.Cf(), patchi, facei));
            const vector S(sign*resolvedFace::at(mesh_.Sf(), patchi, facei));
            const vector turn
            (
                between
                (
                    grains_.centres()[graini],
                    deepestMember(graini, x).centre
                )
              ^ S
            );
            // Without the weight of the mean density, which has no moment
            const scalar rhof = resolvedFace::at(rhoOfFluid, patchi, facei);
            const scalar excess =
                resolvedFace::at(pOfFluid, patchi, facei)
              + (1 - displaced[graini]/rhof)
               *(
                    resolvedFace::at(ofWeight, patchi, facei)
                  + rhof*(g & (x - inFluid.x))
                );
            moment[graini] += excess*turn;
            ofMean[graini] += turn;
            sum[graini] += mag(S)*excess;
            area[graini] += mag(S);
        }
    );
    sumOverRanks(sum);
    sumOverRanks(area);

    // Where other grains or walls are beside it the pressure is the mean
    torque -= moment - sum/area*ofMean;
}
