/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainSystem.H"

#include "coarseGraining.H"
#include "combineOverRanks.H"
#include "dictionaryInput.H"
#include "periodicCells.H"

#include <algorithm>

Foam::grainSystem::grainSystem
(
    const fvMesh& mesh,
    const vector& g,
    const bool withHeat
)
:
    mesh_(mesh),
    motion_(grainMotion::New(mesh, g)),
    coarseGraining_(coarseGraining(motion_->coupling()))
{
    if (motion_->conducts() && !withHeat)
    {
        FatalIOErrorInFunction(motion_->coupling())
            << "Keyword 'heat' of constant/grainProperties: this solver does"
            << " not conduct heat" << nl
            << "    allowed: in dryGrainFoam and grainThermalFoam"
            << exit(FatalIOError);
    }
    for (const word& keyword : wordList({"heatTransfer", "conductivity"}))
    {
        if (!withHeat && motion_->coupling().found(keyword))
        {
            dictionaryInput::badValue
            (
                motion_->coupling(), keyword, "a law",
                "nothing, as this solver has no heat; grainThermalFoam has"
            );
        }
    }
    if (withHeat && !motion_->conducts())
    {
        FatalIOErrorInFunction(motion_->coupling())
            << "Keyword 'heat' of constant/grainProperties is missing" << nl
            << "    allowed: heat { conductance <law>; }, or none for grains"
            << " that exchange heat with the fluid alone"
            << exit(FatalIOError);
    }

    if (withHeat && motion_->isFixed())
    {
        motion_->temperatures()->requireNoContacts();
    }

    motion_->warnOfUnseenWalls();
    start();
}


Foam::grainSystem::grainSystem
(
    const fvMesh& mesh,
    const vector& g,
    const grainSet& set
)
:
    mesh_(mesh),
    motion_(grainMotion::New(mesh, g, set)),
    coarseGraining_(coarseGraining(motion_->coupling()))
{
    start();
}


void Foam::grainSystem::start()
{
    setCells();
    map();
    checkLost();
}


void Foam::grainSystem::resize(const scalarField& radius, const scalarField& mass)
{
    motion_->resize(radius, mass);
    map();
}


void Foam::grainSystem::setCells()
{
    voidFraction_.clear();
    cells_ = periodicCells::New(motion_->cells());
    voidFraction_ = voidFractionMethod::New
    (
        dictionaryInput::subDict(motion_->coupling(), "voidFraction"),
        *cells_
    );
    if (motion_->openings().size())
    {
        openings_.reset(new patchDistance(mesh_, motion_->openings()));
    }

    // Their cells are first tried in the next search
    overlaps_.clear();
}


Foam::vectorField Foam::grainSystem::waysOfCells() const
{
    if (!mesh_.moving() || mesh_.topoChanging())
    {
        return vectorField();
    }
    vectorField way(size(), Zero);
    const pointField& before = mesh_.oldPoints();
    for (label i = 0; i < size(); ++i)
    {
        for (const cellOverlap& o : overlaps_.of(i))
        {
            const labelList& points = mesh_.cellPoints()[o.cell];
            for (const label pointi : points)
            {
                way[i] +=
                    o.volume*(mesh_.points()[pointi] - before[pointi])
                   /points.size();
            }
        }
    }
    sumOverRanks(way);
    forAll(way, i)
    {
        way[i] /= max(mappedVolume_[i], VSMALL);
    }
    return way;
}


void Foam::grainSystem::meshChanged()
{
    const vectorField ways(waysOfCells());
    motion_->meshChanged();
    setCells();
    map(ways);
}


void Foam::grainSystem::map()
{
    map(vectorField());
}


void Foam::grainSystem::map(const vectorField& displacements)
{
    grainBodies bodies(motion_->bodies());
    forAll(displacements, i)
    {
        bodies.centre[i] += displacements[i];
        for (label k = bodies.start[i]; k < bodies.start[i + 1]; ++k)
        {
            bodies.member[k].centre += displacements[i];
        }
    }
    const bool areMapped = overlaps_.nGrains() > 0 && bodies == bodies_;
    if (areMapped)
    {
        return;
    }
    std::swap(bodies_, bodies);
    voidFraction_->map(bodies_, overlaps_);

    mappedVolume_.resize(size());
    scalarField nRanks(size());
    forAll(mappedVolume_, i)
    {
        mappedVolume_[i] = 0;
        for (const cellOverlap& o : overlaps_.of(i))
        {
            mappedVolume_[i] += o.volume;
        }
        nRanks[i] = overlaps_.of(i).empty() ? 0 : 1;
    }
    sumOverRanks(mappedVolume_);
    sumOverRanks(nRanks);
    DynamicList<label> shared;
    forAll(nRanks, i)
    {
        if (nRanks[i] > 1)
        {
            shared.append(i);
        }
    }
    shared_.transfer(shared);
    findAtOpenings();
}


void Foam::grainSystem::findAtOpenings()
{
    isAtOpening_ = boolList(size(), false);
    if (!openings_)
    {
        return;
    }

    // Overlaps of a grain that is wholly in the mesh are exact to round-off
    constexpr scalar whole = 1 - 1e-9;

    DynamicList<label> part;
    DynamicList<point> x;
    DynamicList<scalar> reach;
    forAll(mappedVolume_, i)
    {
        if (mappedVolume_[i] > 0 && mappedVolume_[i] < whole*volume(i))
        {
            scalar farthest = 0;
            for (const grainMember& body : members(i))
            {
                farthest = max
                (
                    farthest, mag(body.centre - centres()[i]) + body.radius
                );
            }
            part.append(i);
            x.append(centres()[i]);
            reach.append(farthest);
        }
    }
    const boolList isNear(openings_->arePatchesWithin(x, reach));
    forAll(part, k)
    {
        isAtOpening_[part[k]] = isNear[k];
    }
}


void Foam::grainSystem::add(const dictionary& source, const label firstId)
{
    motion_->add(source, firstId);
    map();
}


void Foam::grainSystem::merge
(
    const label graini,
    const label grainj,
    const scalar radius
)
{
    motion_->merge(graini, grainj, radius);
    map();
}


bool Foam::grainSystem::inject(const volVectorField& U)
{
    motion_->inject(&U);
    const bool isMore = motion_->injected().number;
    if (isMore)
    {
        map();
    }
    return isMore;
}


std::vector<bool> Foam::grainSystem::leaving() const
{
    std::vector<bool> gone(motion_->leaving());
    if (std::find(gone.begin(), gone.end(), true) == gone.end())
    {
        return gone;
    }
    const boolList& outside = motion_->outside();
    forAll(outside, i)
    {
        gone[i] = gone[i] && (!outside[i] || mappedVolume_[i] <= 0);
    }
    return gone;
}


void Foam::grainSystem::discharge(const std::vector<bool>& gone)
{
    const label before = size();
    motion_->discharge(gone);
    if (size() < before)
    {
        map();
    }
}


void Foam::grainSystem::remove(const std::vector<bool>& gone)
{
    const label before = size();
    motion_->remove(gone);
    if (size() < before)
    {
        map();
    }
}


bool Foam::grainSystem::isWithinBounds(const label graini) const
{
    for (const grainMember& body : bodies_.members(graini))
    {
        if (!cells_->isWithinBounds(body))
        {
            return false;
        }
    }
    return true;
}


void Foam::grainSystem::foresee
(
    const vectorField& fluidForce,
    const scalarField& massOfDrag,
    const scalar deltaT
)
{
    const stopwatch::lap lap(motionTime_);
    motion_->foresee(fluidForce, massOfDrag, deltaT);
}


void Foam::grainSystem::move
(
    const vectorField& fluidForce,
    const vectorField& fluidTorque,
    const scalar deltaT
)
{
    {
        const stopwatch::lap lap(motionTime_);
        motion_->move(fluidForce, fluidTorque, deltaT);
    }
    map();
}


void Foam::grainSystem::checkLost() const
{
    forAll(mappedVolume_, i)
    {
        if (mappedVolume_[i] <= 0)
        {
            FatalErrorInFunction
                << motion_->one() << ' ' << motion_->id(i) << " at "
                << centres()[i] << " with velocity " << motion_->velocity(i)
                << " has left the mesh at time " << mesh().time().timeName()
                << nl << "    there is a gap in the walls, no outlet where it"
                << " left, or the time step"
                << " is too large for the contact solver (worst overlap "
                << motion_->lastStep().worstOverlap << " m)"
                << exit(FatalError);
        }
    }
}
