/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainsInDroplets.H"

#include "volFields.H"
#include "combineOverRanks.H"
#include "liquidDroplets.H"


Foam::grainsInDroplets::grainsInDroplets
(
    const grainSystem& grains,
    const liquidDroplets& droplets
)
:
    grains_(grains),
    droplets_(droplets)
{
    find();
}


void Foam::grainsInDroplets::setDroplets()
{
    const overlapList& overlaps = droplets_.system().overlaps();
    dropletIn_.resize(grains_.mesh().nCells());
    dropletIn_ = -1;
    scalarField most(dropletIn_.size(), Zero);
    for (label i = 0; i < droplets_.size(); ++i)
    {
        for (const cellOverlap& o : overlaps.of(i))
        {
            if (o.volume > most[o.cell])
            {
                most[o.cell] = o.volume;
                dropletIn_[o.cell] = i;
            }
        }
    }
}


Foam::label Foam::grainsInDroplets::dropletIn(const label celli) const
{
    const label i = dropletIn_[celli];
    return i < 0 || droplets_.isSmall(i) ? -1 : i;
}


Foam::scalar Foam::grainsInDroplets::share(const cellOverlap& o) const
{
    return dropletIn(o.cell) < 0 ? 0 : share_[o.index];
}


Foam::scalar Foam::grainsInDroplets::share(const label celli) const
{
    return
        dropletIn(celli) < 0 || solid_[celli] <= 0
      ? 0
      : inCell_[celli]/solid_[celli];
}


Foam::scalar Foam::grainsInDroplets::byPlace
(
    const label graini,
    const cellOverlap& o
) const
{
    const grainSystem& system = droplets_.system();
    const label i = dropletIn_[o.cell];
    vector fromCentre
    (
        system.shortest(grains_.centres()[graini] + o.arm - system.centres()[i])
    );
    const label D = grains_.mesh().nGeometricD();
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        fromCentre[d] = grains_.mesh().geometricD()[d] < 0 ? 0 : fromCentre[d];
    }
    const scalar size =
        grains_.fluidDiameter(graini)
       *pow(o.volume/grains_.volume(graini), 1.0/D);
    const scalar above = mag(fromCentre) - system.motion().radius(i);
    return min(max(0.5 - above/size, scalar(0)), scalar(1));
}


void Foam::grainsInDroplets::setShares()
{
    const overlapList& overlaps = grains_.overlaps();
    const scalarField& V = grains_.mesh().V();
    share_.resize(overlaps.size());
    share_ = 0;
    inCell_ = scalarField(V.size(), Zero);
    solid_ = scalarField(V.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            if (dropletIn_[o.cell] >= 0)
            {
                share_[o.index] =
                    droplets_.areCut() && dropletIn(o.cell) >= 0
                  ? byPlace(graini, o)
                  : min(droplets_.filled(o.cell), scalar(1));
                solid_[o.cell] += o.volume/V[o.cell];
                inCell_[o.cell] += share_[o.index]*o.volume/V[o.cell];
            }
        }
    }
    if (droplets_.areCut())
    {
        leaveRoom();
    }
}


void Foam::grainsInDroplets::leaveRoom()
{
    // Most of a part of a cell that grains fill, unless they fill more of all of it
    constexpr scalar dense = 0.9;

    const scalarField before(inCell_);
    forAll(inCell_, celli)
    {
        if (dropletIn(celli) >= 0)
        {
            const scalar filled = min(droplets_.filled(celli), scalar(1));
            const scalar most = max(solid_[celli], dense);
            inCell_[celli] = min
            (
                max(before[celli], solid_[celli] - most*(1 - filled)),
                most*filled
            );
        }
    }
    for (const cellOverlap& o : grains_.overlaps().all())
    {
        const scalar change = inCell_[o.cell] - before[o.cell];
        if (change < 0)
        {
            share_[o.index] *= inCell_[o.cell]/before[o.cell];
        }
        else if (change > 0)
        {
            share_[o.index] +=
                (1 - share_[o.index])*change/(solid_[o.cell] - before[o.cell]);
        }
    }
}


void Foam::grainsInDroplets::setVolumes()
{
    volume_ = scalarField(droplets_.size(), Zero);
    for (label i = 0; i < droplets_.size(); ++i)
    {
        for (const cellOverlap& o : droplets_.system().overlaps().of(i))
        {
            volume_[i] += o.volume*inCell_[o.cell]/droplets_.filled(o.cell);
        }
    }
    sumOverRanks(volume_);
}


void Foam::grainsInDroplets::find()
{
    setDroplets();
    setShares();
    setVolumes();
}
