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
    const otherHeat* others,
    const scalarField& toOthers
)
:
    grains_(grains),
    resolved_(resolved),
    fluidCapacity_(fluidCapacity),
    network_(grains.temperatures().network()),
    overlap_(overlapConductance/fluidCapacity),
    toOthers_(toOthers/fluidCapacity),
    temperatureOfOthers_(toOthers.size(), Zero),
    whole_(grains.size(), 1),
    bodyOfCells_(grains.mesh().nCells(), -1),
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
    forOthers
    (
        [&](const label, const cellOverlap& o)
        {
            temperatureOfOthers_[o.index] = others->temperatureIn(o.cell);
        }
    );
    setCells(lockedVolume);
    setRows();
    setReturned();
}


template<class Function>
void Foam::heatNodes::forOthers(const Function& f) const
{
    if (toOthers_.empty())
    {
        return;
    }
    const overlapList& overlaps = grains_.overlaps();
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            if (toOthers_[o.index] > 0)
            {
                f(graini, o);
            }
        }
    }
}


void Foam::heatNodes::setCells(const scalarField& lockedVolume)
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
    forAll(bodyOfCells_, celli)
    {
        bodyOfCells_[celli] = resolved_.grainOf(celli);
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

    scalarField others(grains_.size(), Zero), given(grains_.size(), Zero);
    forOthers
    (
        [&](const label graini, const cellOverlap& o)
        {
            const scalar h = whole_[graini]*toOthers_[o.index];
            others[graini] += h;
            given[graini] += h*temperatureOfOthers_[o.index];
        }
    );
    sumOverRanks(others);
    sumOverRanks(given);

    diagonal_ = sum + joined_ + others;
    source_ = scalarField(grains_.size(), Zero);
    values_ = scalarField(grains_.size(), Zero);
    forAll(diagonal_, i)
    {
        const scalar perStep = grainT.heatCapacity(i)/fluidCapacity_/deltaT;
        values_[i] = grainT.temperature(i);
        const scalar own =
            isInCells_[i]
          ? perStep
          : perStep*exponentialMean(diagonal_[i]/perStep);
        diagonal_[i] = inMesh(i)*(diagonal_[i] + own);
        source_[i] = inMesh(i)*(own*values_[i] + given[i]);
    }
    for (const nscd::HeatNetwork::Outlet& outlet : network_.outlets())
    {
        source_[outlet.i] +=
            inMesh(outlet.i)
           *outlet.conductance*outlet.temperature/fluidCapacity_;
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
     && !isInCells_.found(true)
     && gSum(overlap_) + gSum(toOthers_) == 0;
}


Foam::scalarField Foam::heatNodes::fromBodies(const scalarField& bodies) const
{
    scalarField result(grains_.size(), Zero);
    for (const nscd::HeatNetwork::Link& link : network_.links())
    {
        const scalar h = link.conductance/fluidCapacity_;
        result[link.i] += h*bodies[link.j];
        result[link.j] += h*bodies[link.i];
    }
    forAll(result, i)
    {
        result[i] *= inMesh(i);
    }
    return result;
}


void Foam::heatNodes::factorise(const scalarField& diagonal)
{
    scalarField weight(diagonal.size());
    forAll(weight, i)
    {
        weight[i] = inMesh(i);
    }
    factors_ = networkFactors(network_, fluidCapacity_, weight, diagonal);
}


void Foam::heatNodes::solveAlone(scalarField& r) const
{
    factors_.solve(r);
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
            given[o.cell] += overlap_[o.index]*bodies[graini];
        }
    }
    given /= V;
    grains_.voidFraction().smooth(given);
    cells += given*V;
}


Foam::scalarField Foam::heatNodes::fromCells(const scalarField& cells) const
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
    sumOverRanks(result);
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


Foam::scalarField Foam::heatNodes::fromOthers() const
{
    scalarField result(grains_.size(), Zero);
    forOthers
    (
        [&](const label graini, const cellOverlap& o)
        {
            result[graini] +=
                fluidCapacity_*toOthers_[o.index]
               *(temperatureOfOthers_[o.index] - values_[graini]);
        }
    );
    return result;
}


Foam::scalarField Foam::heatNodes::toOthersInCells() const
{
    scalarField result(grains_.mesh().nCells(), Zero);
    forOthers
    (
        [&](const label graini, const cellOverlap& o)
        {
            result[o.cell] +=
                fluidCapacity_*toOthers_[o.index]
               *(values_[graini] - temperatureOfOthers_[o.index]);
        }
    );
    return result;
}


Foam::scalarField Foam::heatNodes::heldInCells() const
{
    const grainTemperatures& grainT = grains_.temperatures();
    const scalar deltaT = grains_.mesh().time().deltaTValue();
    scalarField result(grains_.size(), Zero);
    forAll(result, i)
    {
        if (isInCells_[i])
        {
            result[i] =
                inMesh(i)*grainT.heatCapacity(i)/deltaT
               *(values_[i] - grainT.temperature(i));
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
