/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "waitingHeat.H"

#include "keepUnmarked.H"


Foam::waitingHeat::waitingHeat
(
    const label nDroplets,
    const std::function<IOobject(const word&)>& file
)
:
    fromFluid_(file("dropletHeatFromFluid")),
    fromGrains_(file("dropletHeatFromGrains")),
    sides_(file("dropletHeatSides")),
    time_(file("dropletHeatTime"))
{
    fromFluid_.resize(nDroplets, 0);
    fromGrains_.resize(nDroplets, 0);
    sides_.resize(nDroplets, Zero);
    time_.resize(nDroplets, 0);
}


void Foam::waitingHeat::add
(
    const scalarField& fromFluid,
    const scalarField& fromGrains,
    const vectorField& sides,
    const scalar deltaT
)
{
    fromFluid_ += fromFluid;
    fromGrains_ += fromGrains;
    sides_ += sides;
    for (scalar& time : time_)
    {
        time += deltaT;
    }
}


Foam::scalar Foam::waitingHeat::partOfFluid(const label i) const
{
    const scalar byFluid = max(fromFluid_[i], scalar(0));
    const scalar byGrains = max(fromGrains_[i], scalar(0));
    return byFluid/max(byFluid + byGrains, VSMALL);
}


Foam::vector Foam::waitingHeat::side(const label i) const
{
    return fromFluid_[i] > 0 ? vector(sides_[i]/fromFluid_[i]) : vector(Zero);
}


Foam::scalar Foam::waitingHeat::due
(
    const label i,
    const scalar deltaT,
    const scalar least
)
{
    const scalar heat = of(i);
    const scalar part =
        min(deltaT/max(max(time_[i], least), VSMALL), scalar(1));
    // Else a step that was long once would be waited for ever
    constexpr scalar shorter = 0.1;
    time_[i] =
        heat > 0
      ? max((1 - part)*time_[i] - shorter*deltaT, scalar(0))
      : 0;
    return part*max(heat, scalar(0));
}


void Foam::waitingHeat::keep(const label i, const scalar part)
{
    fromFluid_[i] *= part;
    fromGrains_[i] *= part;
    sides_[i] *= part;
}


void Foam::waitingHeat::set(const label i, const scalar heat)
{
    fromFluid_[i] = heat;
    fromGrains_[i] = 0;
    sides_[i] = Zero;
}


void Foam::waitingHeat::follow
(
    const List<liquidDroplets::fate>& fates,
    const label nDroplets
)
{
    const auto gather = [&](auto& field)
    {
        using Type = typename std::decay<decltype(field[0])>::type;
        Field<Type> all(nDroplets, Zero);
        forAll(fates, i)
        {
            all[fates[i].now] += field[i];
        }
        field = all;
    };
    gather(fromFluid_);
    gather(fromGrains_);
    gather(sides_);
    scalarField time(nDroplets, Zero);
    forAll(fates, i)
    {
        scalar& longest = time[fates[i].now];
        longest = max(longest, time_[i]);
    }
    time_ = time;
}


void Foam::waitingHeat::remove(const std::vector<bool>& gone)
{
    keepUnmarked(fromFluid_, gone);
    keepUnmarked(fromGrains_, gone);
    keepUnmarked(sides_, gone);
    keepUnmarked(time_, gone);
}
