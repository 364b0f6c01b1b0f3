/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "evaporation.H"

#include "combineOverRanks.H"
#include "fvc.H"


Foam::scalar Foam::evaporation::holding
(
    const scalar capacity,
    const surfaceScalarField& conductivity
) const
{
    return
        1e4
       *(
            capacity/mesh_.time().deltaTValue()
          + gMax
            (
                fvc::surfaceSum
                (
                    conductivity*mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()
                )().primitiveField()
               /mesh_.V().field()
            )
        );
}


Foam::scalar Foam::evaporation::smallConductance
(
    const label i,
    const cellOverlap& o,
    const scalar T
) const
{
    const liquid& l = droplets_.properties();
    const scalar atSurface = saturated_ ? saturated_->share(temperature(i)) : 0;
    const scalar B = max
    (
        saturated_
      ? (atSurface - steam_.psi().field()[o.cell])/(1 - atSurface)
      : gas_.capacity()/l.vapourDensity*(T - l.boilingTemperature)
       /l.latentHeat,
        scalar(1e-6)
    );
    // Where the steady profile around a source in a cell has the cell's value
    const bool isPlane = mesh_.nGeometricD() == 2;
    const scalar radius = 0.5*droplets_.system().fluidDiameter(i);
    const scalar reach = (isPlane ? 0.2 : 0.315)*droplets_.cellSize(i);
    const scalar part = min(radius/reach, scalar(0.9));
    const scalar surfacePerVolume = mesh_.nGeometricD()/radius;
    return
        std::log1p(B)/B*surfacePerVolume*o.volume/mesh_.V()[o.cell]
       /(radius*(isPlane ? -std::log(part) : 1 - part));
}


void Foam::evaporation::conductThrough(surfaceScalarField& conductivity) const
{
    const surfaceScalarField byPart(term_.conductanceOfHeat());
    conductivity *= byPart;

    // What is between a droplet and a wall is gas, though its cell has none
    forAll(byPart.boundaryField(), patchi)
    {
        const fvsPatchScalarField& part = byPart.boundaryField()[patchi];
        if (part.coupled())
        {
            continue;
        }
        const labelUList& cells = part.patch().faceCells();
        forAll(part, i)
        {
            if (term_.dropletOf(cells[i]) >= 0)
            {
                conductivity.boundaryFieldRef()[patchi][i] =
                    part[i]*gas_.kappa().boundaryField()[patchi][i];
            }
        }
    }
}


void Foam::evaporation::add(const volScalarField& T, cellHeat& cells)
{
    faces_ = dropletFace::list(term_, cells.conductivity);
    conductThrough(cells.conductivity);
    hold_ = holding(gas_.capacity(), cells.conductivity);

    smalls_.clear();
    for (label i = 0; i < droplets_.size(); ++i)
    {
        if (droplets_.isSmall(i))
        {
            for (const cellOverlap& o : droplets_.system().overlaps().of(i))
            {
                const scalar h =
                    gas_.kappa()[o.cell]*smallConductance(i, o, T[o.cell]);
                cells.add(o.cell, h, temperature(i));
                smalls_.append({o.cell, i, 0, h*mesh_.V()[o.cell], 1});
            }
        }
    }

    const scalar C = gas_.capacity()/droplets_.properties().vapourDensity;
    forAll(T, celli)
    {
        const label d = term_.dropletOf(celli);
        if (d >= 0)
        {
            cells.add(celli, hold_, temperature(d));
        }
        cells.coefficient[celli] += C*entering_[celli];
        cells.given[celli] += C*vapourHeat_[celli];
    }
}


void Foam::evaporation::takeFromCondensing(const volScalarField& T)
{
    const scalar perMass =
        mesh_.time().deltaTValue()*gas_.capacity()
       /droplets_.properties().vapourDensity;
    scalarField heat(droplets_.size(), Zero);
    scalarField perDegree(droplets_.size(), Zero);
    for (const inflow& f : condensing_)
    {
        heat[f.droplet] -= perMass*f.rate*(T[f.cell] - temperature(f.droplet));
        perDegree[f.droplet] -= perMass*f.rate;
    }
    sumOverRanks(heat);
    sumOverRanks(perDegree);
    fromFluid_ += heat;
    stiffness_ += perDegree;
}


void Foam::evaporation::take(const volScalarField& T)
{
    const scalar deltaT = mesh_.time().deltaTValue();
    const scalarField& V = mesh_.V();
    const scalar C = gas_.capacity()/droplets_.properties().vapourDensity;

    scalarField all(droplets_.size(), Zero);
    fromFluid_ = Zero;
    stiffness_ = Zero;
    taken_ = 0;
    forAll(T, celli)
    {
        const label d = term_.dropletOf(celli);
        if (d >= 0)
        {
            all[d] += deltaT*V[celli]*hold_*(T[celli] - temperature(d));
        }
        taken_ +=
            deltaT*V[celli]*C*(entering_[celli]*T[celli] - vapourHeat_[celli]);
    }
    for (const List<dropletFace>& faces : {faces_, List<dropletFace>(smalls_)})
    {
        for (const dropletFace& f : faces)
        {
            const scalar perDegree = deltaT*f.conductance*f.conductivity;
            fromFluid_[f.droplet] +=
                perDegree*(T[f.cell] - temperature(f.droplet));
            stiffness_[f.droplet] += perDegree;
        }
    }
    for (const dropletFace& f : smalls_)
    {
        all[f.droplet] +=
            deltaT*f.conductance*(T[f.cell] - temperature(f.droplet));
    }
    sumOverRanks(all);
    sumOverRanks(fromFluid_);
    sumOverRanks(stiffness_);
    fromGrains_ = all - fromFluid_;
    reduce(taken_, sumOp<scalar>());
    taken_ += sum(all);
    takeFromCondensing(T);

    waitingFromFluid_ += fromFluid_;
    waitingFromGrains_ += fromGrains_;
    for (scalar& time : waitingTime_)
    {
        time += deltaT;
    }
}
