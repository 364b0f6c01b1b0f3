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
        std::log1p(B)/B*surfacePerVolume*o.volume
       /(radius*(isPlane ? -std::log(part) : 1 - part));
}


void Foam::evaporation::conductThrough
(
    const volScalarField& T,
    surfaceScalarField& conductivity
) const
{
    const surfaceScalarField byPart(byDistance(term_.conductanceOfHeat(), T));
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


void Foam::evaporation::updateCut()
{
    if (!cut_)
    {
        return;
    }
    boolList isCut(droplets_.size());
    forAll(isCut, i)
    {
        isCut[i] = !droplets_.isSmall(i);
    }
    cut_->update(isCut);
}


void Foam::evaporation::setHolder()
{
    holder_.resize(mesh_.nCells());
    forAll(holder_, celli)
    {
        holder_[celli] =
            !cut_ ? term_.dropletOf(celli)
          : cut_->cells().fluid()[celli] > 0 ? -1
          : term_.inside().dropletIn(celli);
    }
}


void Foam::evaporation::follow()
{
    updateCut();
    setHolder();
    fromGrainsInCells_.clear();
}


Foam::scalar Foam::evaporation::share(const cellOverlap& o) const
{
    return cut_ ? term_.inside().share(o) : 0;
}


Foam::surroundings Foam::evaporation::ofShare() const
{
    const liquid& l = droplets_.properties();
    return {l.density, l.mu, l.film, l.density*l.Cp};
}


Foam::List<Foam::dropletFace> Foam::evaporation::surfaces() const
{
    return
        cut_
      ? dropletFace::list(*cut_, gas_.kappa().primitiveField())
      : dropletFace::list
        (
            term_, fvc::interpolate(gas_.kappa(), "interpolate(kappa)")
        );
}


void Foam::evaporation::add(const volScalarField& T, cellHeat& cells)
{
    faces_.clear();
    inCells_.clear();
    if (cut_)
    {
        inCells_.append(surfaces());
        cells.conductivity *=
            cut_->part(T, [&](const label i) { return temperature(i); });
    }
    else
    {
        faces_ = dropletFace::list(term_, cells.conductivity);
        conductThrough(T, cells.conductivity);
        dropletFace::shut(term_, cells.conductivity);
    }
    hold_ = holding(gas_.capacity(), cells.conductivity);

    for (label i = 0; i < droplets_.size(); ++i)
    {
        if (droplets_.isSmall(i))
        {
            for (const cellOverlap& o : droplets_.system().overlaps().of(i))
            {
                inCells_.append
                ({
                    o.cell, i, Zero, 0,
                    smallConductance(i, o, T[o.cell]), gas_.kappa()[o.cell]
                });
            }
        }
    }
    for (const List<dropletFace>& faces : {faces_, List<dropletFace>(inCells_)})
    {
        for (const dropletFace& f : faces)
        {
            cells.add
            (
                f.cell, f.coefficient(mesh_.V()[f.cell]), temperature(f.droplet)
            );
        }
    }

    const scalar C = gas_.capacity()/droplets_.properties().vapourDensity;
    forAll(T, celli)
    {
        const label d = holder_[celli];
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
    vectorField sides(droplets_.size(), Zero);
    fromFluid_ = Zero;
    stiffness_ = Zero;
    taken_ = 0;
    forAll(T, celli)
    {
        const label d = holder_[celli];
        if (d >= 0)
        {
            all[d] += deltaT*V[celli]*hold_*(T[celli] - temperature(d));
        }
        taken_ +=
            deltaT*V[celli]*C*(entering_[celli]*T[celli] - vapourHeat_[celli]);
    }
    for (const List<dropletFace>& faces : {faces_, List<dropletFace>(inCells_)})
    {
        for (const dropletFace& f : faces)
        {
            const scalar perDegree = deltaT*f.conductance*f.conductivity;
            const scalar heat = perDegree*(T[f.cell] - temperature(f.droplet));
            all[f.droplet] += heat;
            fromFluid_[f.droplet] += heat;
            sides[f.droplet] += heat*f.normal;
            stiffness_[f.droplet] += perDegree;
        }
    }
    forAll(fromGrainsInCells_, celli)
    {
        if (fromGrainsInCells_[celli] != 0)
        {
            all[term_.inside().dropletIn(celli)] += fromGrainsInCells_[celli];
        }
    }
    sumOverRanks(all);
    sumOverRanks(fromFluid_);
    sumOverRanks(sides);
    sumOverRanks(stiffness_);
    fromGrains_ = all - fromFluid_;
    reduce(taken_, sumOp<scalar>());
    taken_ += sum(all);
    takeFromCondensing(T);

    waiting_.add(fromFluid_, fromGrains_, sides, deltaT);
}
