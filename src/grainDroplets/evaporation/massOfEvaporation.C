/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "evaporation.H"

#include "combineOverRanks.H"
#include "fvc.H"


Foam::scalarField Foam::evaporation::shares
(
    const List<dropletFace>& faces,
    const volScalarField& T
) const
{
    scalarField drive(faces.size());
    scalarField allDrive(droplets_.size(), Zero);
    scalarField allArea(droplets_.size(), Zero);
    forAll(faces, i)
    {
        const dropletFace& f = faces[i];
        const scalar Td = temperature(f.droplet);
        // What condenses comes from where there is more than at the surface
        const scalar sign =
            saturated_ && saturated_->toPass(f.droplet) < 0 ? -1 : 1;
        scalar difference = f.conductivity*(T[f.cell] - Td);
        if (saturated_)
        {
            const scalar share = saturated_->share(Td);
            const scalar psi = steam_.psi().field()[f.cell];
            difference =
                sign*(share - psi)
               *saturatedSurface::diffusing(share, psi)
               *saturatedSurface::flow(share, psi);
        }
        drive[i] = f.conductance*max(difference, scalar(0));
        allDrive[f.droplet] += drive[i];
        allArea[f.droplet] += f.area;
    }
    sumOverRanks(allDrive);
    sumOverRanks(allArea);

    scalarField result(faces.size());
    forAll(faces, i)
    {
        const label d = faces[i].droplet;
        scalar local = 0;
        if (isLocal_ && allDrive[d] > 0)
        {
            local = saturated_ ? 1 : waiting_.partOfFluid(d);
        }
        result[i] =
            local*drive[i]/max(allDrive[d], VSMALL)
          + (1 - local)*faces[i].area/allArea[d];
    }
    if (cut_ && isLocal_ && !saturated_)
    {
        turn(faces, result);
    }
    return result;
}


void Foam::evaporation::turn
(
    const List<dropletFace>& faces,
    scalarField& shares
) const
{
    symmTensorField products(droplets_.size(), Zero);
    vectorField missing(droplets_.size(), Zero);
    forAll(faces, i)
    {
        const dropletFace& f = faces[i];
        products[f.droplet] += f.area*sqr(f.normal);
        missing[f.droplet] -= shares[i]*f.normal;
    }
    sumOverRanks(products);
    sumOverRanks(missing);

    forAll(missing, d)
    {
        missing[d] += waiting_.partOfFluid(d)*waiting_.side(d);
        for (direction way = 0; way < vector::nComponents; ++way)
        {
            if (mesh_.geometricD()[way] < 0)
            {
                products[d] += tr(products[d])*sqr(vector(way == 0, way == 1, way == 2));
                missing[d][way] = 0;
            }
        }
        missing[d] =
            det(products[d]) > 1e-6*pow3(tr(products[d]))
          ? inv(products[d]) & missing[d]
          : vector(Zero);
    }

    scalarField all(droplets_.size(), Zero);
    forAll(faces, i)
    {
        const dropletFace& f = faces[i];
        shares[i] =
            max(shares[i] + f.area*(missing[f.droplet] & f.normal), scalar(0));
        all[f.droplet] += shares[i];
    }
    sumOverRanks(all);
    forAll(faces, i)
    {
        shares[i] /= all[faces[i].droplet];
    }
}


Foam::scalarField Foam::evaporation::leastTime
(
    const List<dropletFace>& faces
) const
{
    scalarField result(droplets_.size(), Zero);
    if (!cut_)
    {
        return result;
    }
    scalarField conductivity(droplets_.size(), Zero);
    scalarField area(droplets_.size(), Zero);
    for (const dropletFace& f : faces)
    {
        conductivity[f.droplet] += f.area*f.conductivity;
        area[f.droplet] += f.area;
    }
    sumOverRanks(conductivity);
    sumOverRanks(area);
    forAll(result, d)
    {
        if (area[d] > 0)
        {
            const scalar h = droplets_.cellSize(d);
            const scalar diffusivity =
                conductivity[d]/(area[d]*gas_.capacity());
            const scalar Pe =
                mag(droplets_.system().motion().velocity(d))*h/diffusivity;
            result[d] = 2*sqr(h)/diffusivity*Pe/(1 + sqr(Pe));
        }
    }
    return result;
}


Foam::scalar Foam::evaporation::evaporate
(
    const label i,
    const scalar leastTime
)
{
    const scalar latent = droplets_.properties().latentHeat;
    const scalar mass = droplets_.mass(i);
    scalar heat = waiting_.of(i);
    scalar diffused = 0;
    scalar& lost = lost_[i];
    scalar& flow = flow_[i];

    if (saturated_)
    {
        diffused = saturated_->waiting(i);
        flow = mesh_.time().deltaTValue()*saturated_->toPass(i);
        // What condenses is known when it has left the gas
        const scalar mass0 =
            diffused
          + max(flow, scalar(0))*saturated_->share(temperature(i));
        lost = saturated_->evaporate
        (
            i, mass0, mass, stiffness_[i] + latent*vapourStiffness_[i], heat
        );
        flow += lost - mass0;
        waiting_.set(i, heat);
    }
    else
    {
        lost =
            waiting_.due(i, mesh_.time().deltaTValue(), leastTime)/latent;
        flow = lost;
        warnIfInDebt(-heat, latent*mass);
    }

    // What would be left has no heat of its own: it is too little to tell
    if (lost > 0 && mass - lost < droplets_.leastMass())
    {
        flow += mass - lost;
        lost = mass;
    }
    if (!saturated_ && lost > 0)
    {
        waiting_.keep(i, 1 - lost*latent/heat);
    }
    // Vapour that condenses has the share that it has in the gas
    const scalar share =
        flow > VSMALL
      ? min(max((lost - diffused)/flow, scalar(0)), scalar(1))
      : 0;
    notCarried_[i] = lost - diffused - share*max(flow, scalar(0));
    return share;
}


void Foam::evaporation::addVapour
(
    const label celli,
    const label i,
    const scalar rate,
    const scalar share
)
{
    const scalar perVolume = rate/mesh_.V()[celli];
    vapour_[celli] += perVolume;
    if (rate < 0)
    {
        condensing_.append(inflow{celli, i, rate});
        return;
    }
    entering_[celli] += perVolume;
    vapourHeat_[celli] += perVolume*temperature(i);
    vapourShare_[celli] += perVolume*share;
}


void Foam::evaporation::warnIfShut()
{
    const auto& p_rgh = mesh_.lookupObject<volScalarField>("p_rgh");
    if (saidShut_ || !p_rgh.needReference() || sum(mag(flow_)()) <= 0)
    {
        return;
    }
    saidShut_ = true;
    WarningInFunction
        << "Droplets evaporate, or vapour condenses, and no patch lets the fluid"
        << " through: the volume of the vapour is taken evenly from that of the gas,"
        << " or added to it, which is incompressible;" << nl
        << "    an opening, a fixed value of p_rgh on a patch, avoids it"
        << " (said once)" << endl;
}


void Foam::evaporation::warnIfInDebt(const scalar debt, const scalar all)
{
    if (saidDebt_ || debt < 1e-3*all)
    {
        return;
    }
    saidDebt_ = true;
    WarningInFunction
        << "A droplet has given " << debt << " J to gas or grains that are colder"
        << " than its boilingTemperature, which it keeps: there is no vapour until it"
        << " has got as much;" << nl
        << "    'saturation' lets it cool and evaporate below boiling (said once)"
        << endl;
}


void Foam::evaporation::startStep(const volScalarField& T)
{
    updateCut();
    const List<dropletFace> faces(surfaces());
    scalarField isThere(droplets_.size(), Zero);
    for (const dropletFace& f : faces)
    {
        isThere[f.droplet] = 1;
    }
    sumOverRanks(isThere);
    const scalarField share(shares(faces, T));
    const scalarField least(leastTime(faces));

    scalarField carried(lost_.size(), Zero);
    forAll(lost_, i)
    {
        lost_[i] = 0;
        flow_[i] = 0;
        notCarried_[i] = 0;
        if (isThere[i] > 0 || droplets_.isSmall(i))
        {
            carried[i] = evaporate(i, least[i]);
        }
    }
    warnIfShut();

    const scalar deltaT = mesh_.time().deltaTValue();
    liquid_ = scalarField(mesh_.nCells(), Zero);
    vapour_ = liquid_;
    entering_ = vapour_;
    vapourHeat_ = vapour_;
    vapourShare_ = vapour_;
    condensing_.clear();
    jets_.resize(faces.size());
    forAll(faces, i)
    {
        const label d = faces[i].droplet;
        const scalar rate = share[i]*flow_[d]/deltaT;
        addVapour(faces[i].cell, d, rate, carried[d]);
        liquid_[faces[i].cell] +=
            share[i]*lost_[d]/(deltaT*mesh_.V()[faces[i].cell]);
        jets_[i] = {faces[i].cell, d, faces[i].normal, faces[i].area, rate};
    }
    radius_.resize(droplets_.size());
    forAll(radius_, i)
    {
        radius_[i] = droplets_.system().motion().radius(i);
    }
    for (label i = 0; i < droplets_.size(); ++i)
    {
        if (droplets_.isSmall(i))
        {
            const scalar perVolume =
                1/(deltaT*droplets_.system().mappedVolume()[i]);
            for (const cellOverlap& o : droplets_.system().overlaps().of(i))
            {
                const scalar part = perVolume*o.volume;
                addVapour(o.cell, i, part*flow_[i], carried[i]);
                liquid_[o.cell] += part*lost_[i]/mesh_.V()[o.cell];
            }
        }
    }
}


Foam::tmp<Foam::volScalarField> Foam::evaporation::volumeSource() const
{
    const liquid& l = droplets_.properties();
    tmp<volScalarField> tsource
    (
        new volScalarField
        (
            IOobject("vapourSource", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(dimless/dimTime, Zero)
        )
    );
    tsource.ref().primitiveFieldRef() =
        vapour_/l.vapourDensity - liquid_/l.density;
    return tsource;
}


Foam::scalarField Foam::evaporation::withVapour(const scalarField& filled) const
{
    scalarField result(mesh_.time().deltaTValue()*vapourVolume());
    if (filled.size())
    {
        result += filled;
    }
    return result;
}
