/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatNodes.H"

#include "combineOverRanks.H"
#include "exponentialMean.H"

Foam::heatNodes::heatNodes
(
    const grainSystem& grains,
    const resolvedTerm& resolved,
    const scalar fluidCapacity,
    const scalarField& overlapConductance,
    const scalarField& lockedVolume,
    cellHeat& cells
)
:
    grains_(grains),
    resolved_(resolved),
    fluidCapacity_(fluidCapacity),
    network_(grains.temperatures().network()),
    overlap_(overlapConductance/fluidCapacity),
    whole_(grains.size(), 1),
    lockedShare_(grains.mesh().nCells(), Zero),
    isInCells_(grains.size(), false),
    returned_(grains.mesh().nCells(), Zero),
    joined_(grains.size(), Zero)
{
    for (const nscd::HeatNetwork::Link& link : network_.links())
    {
        joined_[link.i] += link.conductance/fluidCapacity_;
        joined_[link.j] += link.conductance/fluidCapacity_;
    }
    for (const nscd::HeatNetwork::Outlet& outlet : network_.outlets())
    {
        joined_[outlet.i] += outlet.conductance/fluidCapacity_;
    }
    setShares(lockedVolume);
    setRows();
    setReturned();

    // What locked cells lose through contacts, and get from walls
    const scalarField& V = grains_.mesh().V();
    scalarField fromWalls(grains_.size(), Zero);
    for (const nscd::HeatNetwork::Outlet& outlet : network_.outlets())
    {
        fromWalls[outlet.i] += outlet.conductance*outlet.temperature;
    }
    forAll(lockedShare_, celli)
    {
        if (lockedShare_[celli] > 0)
        {
            const label graini = resolved_.grainOf(celli);
            const scalar share =
                lockedShare_[celli]/whole_[graini]/V[celli];
            cells.coefficient[celli] +=
                share*joined_[graini]*fluidCapacity_;
            cells.given[celli] += share*fromWalls[graini];
        }
    }
}


void Foam::heatNodes::setShares(const scalarField& lockedVolume)
{
    forAll(whole_, i)
    {
        if (grains_.isAtOpening(i))
        {
            whole_[i] =
                grains_.volume(i)/max(grains_.mappedVolume()[i], VSMALL);
        }
    }
    if (!resolved_.isActive() || grains_.temperatures().conductInside())
    {
        return;
    }
    forAll(isInCells_, i)
    {
        isInCells_[i] = lockedVolume[i] > 0;
    }
    const scalarField& V = grains_.mesh().V();
    forAll(lockedShare_, celli)
    {
        const label graini = resolved_.grainOf(celli);
        if (graini >= 0)
        {
            lockedShare_[celli] = V[celli]/lockedVolume[graini];
        }
    }
}


void Foam::heatNodes::setRows()
{
    const grainTemperatures& grainT = grains_.temperatures();
    const overlapList& overlaps = grains_.overlaps();
    const scalar deltaT = grains_.mesh().time().deltaTValue();

    scalarField sum(grains_.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            sum[graini] += whole_[graini]*overlap_[o.index];
        }
    }
    sumOverRanks(sum);

    diagonal_ = sum + joined_;
    source_ = scalarField(grains_.size(), Zero);
    values_ = scalarField(grains_.size(), Zero);
    forAll(diagonal_, i)
    {
        const scalar perStep = grainT.heatCapacity(i)/fluidCapacity_/deltaT;
        values_[i] = grainT.temperature(i);
        if (isInCells_[i])
        {
            diagonal_[i] = perStep;
            continue;
        }
        const scalar own = perStep*exponentialMean(diagonal_[i]/perStep);
        diagonal_[i] += own;
        source_[i] = own*values_[i];
    }
    for (const nscd::HeatNetwork::Outlet& outlet : network_.outlets())
    {
        if (!isInCells_[outlet.i])
        {
            source_[outlet.i] +=
                outlet.conductance*outlet.temperature/fluidCapacity_;
        }
    }
    cellShare_ = sum/diagonal_;
}


void Foam::heatNodes::setReturned()
{
    const overlapList& overlaps = grains_.overlaps();
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            returned_[o.cell] += overlap_[o.index]*cellShare_[graini];
        }
    }
    scalarField perVolume(returned_/grains_.mesh().V());
    grains_.voidFraction().smooth(perVolume);
    returned_ = perVolume*grains_.mesh().V();
}


bool Foam::heatNodes::isAlone() const
{
    return
        network_.links().empty()
     && network_.outlets().empty()
     && gSum(overlap_) == 0;
}


void Foam::heatNodes::meet(const scalarField& T)
{
    if (isAlone())
    {
        values_ = (source_ + received(T, values_))/diagonal_;
    }
}


Foam::scalarField Foam::heatNodes::fromNetwork(const scalarField& bodies) const
{
    scalarField result(grains_.size(), Zero);
    for (const nscd::HeatNetwork::Link& link : network_.links())
    {
        const scalar h = link.conductance/fluidCapacity_;
        result[link.i] += h*bodies[link.j];
        result[link.j] += h*bodies[link.i];
    }
    return result;
}


void Foam::heatNodes::addToCells
(
    const scalarField& bodies,
    scalarField& cells
) const
{
    const scalarField& V = grains_.mesh().V();
    const overlapList& overlaps = grains_.overlaps();
    scalarField given(cells.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            given[o.cell] += overlap_[o.index]*bodies[graini]/V[o.cell];
        }
    }
    grains_.voidFraction().smooth(given);
    cells += given*V;

    if (resolved_.isActive() && network_.links().size())
    {
        const scalarField linked(fromNetwork(bodies));
        forAll(lockedShare_, celli)
        {
            if (lockedShare_[celli] > 0)
            {
                const label graini = resolved_.grainOf(celli);
                cells[celli] +=
                    lockedShare_[celli]/whole_[graini]*linked[graini];
            }
        }
    }
}


Foam::scalarField Foam::heatNodes::received
(
    const scalarField& cells,
    const scalarField& bodies
) const
{
    const overlapList& overlaps = grains_.overlaps();
    scalarField seen(cells);
    grains_.voidFraction().smooth(seen);
    scalarField result(grains_.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            result[graini] +=
                whole_[graini]*overlap_[o.index]*seen[o.cell];
        }
    }
    forAll(lockedShare_, celli)
    {
        if (lockedShare_[celli] > 0)
        {
            const label graini = resolved_.grainOf(celli);
            result[graini] +=
                diagonal_[graini]*lockedShare_[celli]*cells[celli];
        }
    }
    sumOverRanks(result);

    if (network_.links().size())
    {
        const scalarField linked(fromNetwork(bodies));
        forAll(result, i)
        {
            if (!isInCells_[i])
            {
                result[i] += linked[i];
            }
        }
    }
    return result;
}


Foam::scalarField Foam::heatNodes::fromFluid(const scalarField& T) const
{
    const overlapList& overlaps = grains_.overlaps();
    scalarField seen(T);
    grains_.voidFraction().smooth(seen);
    scalarField result(grains_.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            result[graini] +=
                fluidCapacity_*overlap_[o.index]
               *(seen[o.cell] - values_[graini]);
        }
    }
    return result;
}


Foam::scalarField Foam::heatNodes::throughNetwork() const
{
    scalarField result(grains_.size(), Zero);
    for (const nscd::HeatNetwork::Link& link : network_.links())
    {
        const scalar heat =
            link.conductance*(values_[link.j] - values_[link.i]);
        result[link.i] += heat;
        result[link.j] -= heat;
    }
    for (const nscd::HeatNetwork::Outlet& outlet : network_.outlets())
    {
        result[outlet.i] +=
            outlet.conductance*(outlet.temperature - values_[outlet.i]);
    }
    return result;
}


Foam::scalarList Foam::heatNodes::fromReservoirs(const label n) const
{
    scalarList result(n, Zero);
    for (const nscd::HeatNetwork::Outlet& outlet : network_.outlets())
    {
        result[outlet.reservoir] +=
            outlet.conductance*(outlet.temperature - values_[outlet.i]);
    }
    return result;
}
