/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "evaporation.H"

#include "dictionaryInput.H"
#include "keepUnmarked.H"


Foam::evaporation::evaporation
(
    liquidDroplets& droplets,
    const dropletTerm& term,
    const grainFluidExchange& exchange,
    const thermalFluid& gas,
    const vapour& steam,
    const volScalarField& T
)
:
    droplets_(droplets),
    term_(term),
    exchange_(exchange),
    gas_(gas),
    steam_(steam),
    mesh_(droplets.system().mesh()),
    isLocal_
    (
        dictionaryInput::getWordOrDefault
        (
            droplets.dict(), "blowing", "local", {"local", "uniform"}
        )
     == "local"
    ),
    waiting_(droplets.size(), [this](const word& name) { return state(name); }),
    growth_(state("dropletGrowth")),
    fromFluid_(droplets.size(), Zero),
    fromGrains_(droplets.size(), Zero),
    lost_(droplets.size(), Zero),
    flow_(droplets.size(), Zero),
    stiffness_(droplets.size(), Zero),
    vapourStiffness_(droplets.size(), Zero),
    notCarried_(droplets.size(), Zero),
    liquid_(mesh_.nCells(), Zero),
    vapour_(liquid_),
    entering_(vapour_),
    vapourHeat_(vapour_),
    vapourShare_(vapour_),
    hold_(0),
    cut_(droplets.areCut() ? new cutConduction(droplets.system()) : nullptr),
    taken_(0)
{
    growth_.resize(droplets.size(), 0);
    if (droplets.dict().found("saturation"))
    {
        saturated_.reset
        (
            new saturatedSurface
            (
                dictionaryInput::subDict(droplets.dict(), "saturation"),
                droplets.properties(),
                droplets.size(),
                [this](const word& name) { return state(name); }
            )
        );
        if (!steam.isActive())
        {
            FatalIOErrorInFunction(droplets.dict())
                << "Keyword 'saturation', and constant/transportProperties has no"
                << " dictionary 'vapour'" << nl
                << "    allowed: 'vapour' with 'D', and a field 0/psi"
                << exit(FatalIOError);
        }
    }
    else
    {
        checkTemperature(T);
    }
}


void Foam::evaporation::checkTemperature(const volScalarField& T) const
{
    const scalar boiling = droplets_.properties().boilingTemperature;
    const scalar least = gMin(T.primitiveField());
    // In cells that are not orthogonal the gas at the surface may be colder by a
    // part of its range
    constexpr scalar part = 1e-3;
    const scalar range = gMax(T.primitiveField()) - least;
    if (least < (1 - 1e-9)*boiling - part*range)
    {
        FatalIOErrorInFunction(droplets_.dict())
            << "Keyword 'boilingTemperature' of 'liquid' has the value "
            << boiling << ", and the gas is colder: " << least << " K" << nl
            << "    allowed: at most the lowest temperature of 0/T, as vapour does"
            << " not become liquid again; or 'saturation'" << exit(FatalIOError);
    }
}


Foam::IOobject Foam::evaporation::state(const word& name) const
{
    return IOobject
    (
        name,
        mesh_.time().timeName(),
        "uniform",
        mesh_,
        IOobject::READ_IF_PRESENT,
        IOobject::AUTO_WRITE
    );
}


void Foam::evaporation::remove(const std::vector<bool>& gone)
{
    waiting_.remove(gone);
    keepUnmarked(growth_, gone);
    if (saturated_)
    {
        saturated_->remove(gone);
    }
    clearStep();
}


void Foam::evaporation::keepGrowth()
{
    forAll(growth_, i)
    {
        growth_[i] =
            (droplets_.system().motion().radius(i) - radius_[i])
           /mesh_.time().deltaTValue();
    }
}


void Foam::evaporation::clearStep()
{
    for
    (
        scalarField* field
      : {
            &fromFluid_, &fromGrains_, &lost_, &flow_, &stiffness_,
            &vapourStiffness_, &notCarried_
        }
    )
    {
        *field = scalarField(droplets_.size(), Zero);
    }
}


void Foam::evaporation::follow(const List<liquidDroplets::fate>& fates)
{
    waiting_.follow(fates, droplets_.size());
    scalarField growth(droplets_.size(), Zero);
    forAll(fates, i)
    {
        // Of those that merge, none is known
        growth[fates[i].now] = fates[i].share < 1 ? 0 : growth_[i];
    }
    growth_ = growth;
    if (saturated_)
    {
        saturated_->follow(fates, droplets_.size());
    }
    clearStep();
}
