/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "evaporation.H"

#include "combineOverRanks.H"
#include "dictionaryInput.H"
#include "fvc.H"
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
    waitingFromFluid_(state("dropletHeatFromFluid")),
    waitingFromGrains_(state("dropletHeatFromGrains")),
    growth_(state("dropletGrowth")),
    fromFluid_(droplets.size(), Zero),
    fromGrains_(droplets.size(), Zero),
    lost_(droplets.size(), Zero),
    stiffness_(droplets.size(), Zero),
    vapourStiffness_(droplets.size(), Zero),
    vapour_(mesh_.nCells(), Zero),
    vapourHeat_(vapour_),
    vapourShare_(vapour_),
    hold_(0),
    taken_(0)
{
    waitingFromFluid_.resize(droplets.size(), 0);
    waitingFromGrains_.resize(droplets.size(), 0);
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
            saturated_ && saturated_->toEvaporate(f.droplet) < 0 ? -1 : 1;
        drive[i] =
            f.conductance
           *max
            (
                saturated_
              ? sign*(saturated_->share(Td) - steam_.psi().field()[f.cell])
              : f.conductivity*(T[f.cell] - Td),
                scalar(0)
            );
        allDrive[f.droplet] += drive[i];
        allArea[f.droplet] += f.area;
    }
    sumOverRanks(allDrive);
    sumOverRanks(allArea);

    scalarField result(faces.size());
    forAll(faces, i)
    {
        const label d = faces[i].droplet;
        const scalar byFluid = max(waitingFromFluid_[d], scalar(0));
        const scalar byGrains = max(waitingFromGrains_[d], scalar(0));
        scalar local = 0;
        if (isLocal_ && allDrive[d] > 0)
        {
            local = saturated_ ? 1 : byFluid/max(byFluid + byGrains, VSMALL);
        }
        result[i] =
            local*drive[i]/max(allDrive[d], VSMALL)
          + (1 - local)*faces[i].area/allArea[d];
    }
    return result;
}


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


void Foam::evaporation::remove(const std::vector<bool>& gone)
{
    keepUnmarked(waitingFromFluid_, gone);
    keepUnmarked(waitingFromGrains_, gone);
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
      : {&fromFluid_, &fromGrains_, &lost_, &stiffness_, &vapourStiffness_}
    )
    {
        *field = scalarField(droplets_.size(), Zero);
    }
}


void Foam::evaporation::follow(const List<liquidDroplets::fate>& fates)
{
    const auto gather = [&](IOField<scalar>& field)
    {
        scalarField all(droplets_.size(), Zero);
        forAll(fates, i)
        {
            all[fates[i].now] += field[i];
        }
        field = all;
    };
    gather(waitingFromFluid_);
    gather(waitingFromGrains_);
    gather(growth_);
    forAll(fates, i)
    {
        // Of those that merge, none is known
        growth_[fates[i].now] *= fates[i].share < 1 ? 0 : 1;
    }
    if (saturated_)
    {
        saturated_->follow(fates, droplets_.size());
    }
    clearStep();
}


Foam::scalar Foam::evaporation::evaporate(const label i)
{
    const scalar latent = droplets_.properties().latentHeat;
    const scalar mass = droplets_.mass(i);
    scalar heat = waitingFromFluid_[i] + waitingFromGrains_[i];
    scalar diffused = 0;
    scalar& lost = lost_[i];

    if (saturated_)
    {
        diffused = saturated_->waiting(i);
        lost = saturated_->evaporate
        (
            i, saturated_->toEvaporate(i), mass,
            stiffness_[i] + latent*vapourStiffness_[i], heat
        );
        waitingFromFluid_[i] = heat;
        waitingFromGrains_[i] = 0;
    }
    else
    {
        lost = max(heat, scalar(0))/latent;
        warnIfInDebt(-heat, latent*mass);
    }

    // What would be left has no heat of its own: it is too little to tell
    if (lost > 0 && mass - lost < droplets_.leastMass())
    {
        lost = mass;
    }
    if (!saturated_ && lost > 0)
    {
        const scalar left = 1 - lost*latent/heat;
        waitingFromFluid_[i] *= left;
        waitingFromGrains_[i] *= left;
    }
    return
        mag(lost) > VSMALL
      ? min(max(1 - diffused/lost, scalar(0)), scalar(1))
      : 0;
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
    vapourHeat_[celli] += perVolume*temperature(i);
    vapourShare_[celli] += perVolume*share;
}


void Foam::evaporation::warnIfShut()
{
    const auto& p_rgh = mesh_.lookupObject<volScalarField>("p_rgh");
    if (saidShut_ || !p_rgh.needReference() || sum(lost_) <= 0)
    {
        return;
    }
    saidShut_ = true;
    WarningInFunction
        << "Droplets evaporate and no patch lets the fluid out: the volume of"
        << " their vapour is taken evenly from that of the gas, which is"
        << " incompressible;" << nl
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
    const List<dropletFace> faces
    (
        dropletFace::list
        (
            term_, fvc::interpolate(gas_.kappa(), "interpolate(kappa)")
        )
    );
    scalarField isThere(droplets_.size(), Zero);
    for (const dropletFace& f : faces)
    {
        isThere[f.droplet] = 1;
    }
    sumOverRanks(isThere);
    const scalarField share(shares(faces, T));

    scalarField carried(lost_.size(), Zero);
    forAll(lost_, i)
    {
        lost_[i] = 0;
        if (isThere[i] > 0 || droplets_.isSmall(i))
        {
            carried[i] = evaporate(i);
        }
    }
    warnIfShut();

    const scalar deltaT = mesh_.time().deltaTValue();
    vapour_ = scalarField(mesh_.nCells(), Zero);
    vapourHeat_ = vapour_;
    vapourShare_ = vapour_;
    jets_.resize(faces.size());
    forAll(faces, i)
    {
        const label d = faces[i].droplet;
        const scalar rate = share[i]*lost_[d]/deltaT;
        addVapour(faces[i].cell, d, rate, carried[d]);
        jets_[i] = {faces[i].cell, d, faces[i].area, rate};
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
                lost_[i]/(deltaT*droplets_.system().mappedVolume()[i]);
            for (const cellOverlap& o : droplets_.system().overlaps().of(i))
            {
                addVapour(o.cell, i, perVolume*o.volume, carried[i]);
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
        (1/l.vapourDensity - 1/l.density)*vapour_;
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


void Foam::evaporation::add(const volScalarField& T, cellHeat& cells)
{
    faces_ = dropletFace::list(term_, cells.conductivity);
    cells.conductivity *= term_.conductance();
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
        cells.coefficient[celli] += C*vapour_[celli];
        cells.given[celli] += C*vapourHeat_[celli];
    }
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
            deltaT*V[celli]*C*(vapour_[celli]*T[celli] - vapourHeat_[celli]);
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

    waitingFromFluid_ += fromFluid_;
    waitingFromGrains_ += fromGrains_;
}


Foam::scalar Foam::evaporation::waiting() const
{
    return sum(waitingFromFluid_) + sum(waitingFromGrains_);
}
