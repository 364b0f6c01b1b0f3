/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "evaporation.H"

#include "combineOverRanks.H"
#include "dictionaryInput.H"
#include "fvc.H"


Foam::evaporation::evaporation
(
    liquidDroplets& droplets,
    const dropletTerm& term,
    const thermalFluid& gas,
    const volScalarField& T
)
:
    droplets_(droplets),
    term_(term),
    gas_(gas),
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
    fromFluid_(droplets.size(), Zero),
    fromGrains_(droplets.size(), Zero),
    lost_(droplets.size(), Zero),
    vapour_(mesh_.nCells(), Zero),
    hold_(0),
    taken_(0)
{
    waitingFromFluid_.resize(droplets.size(), 0);
    waitingFromGrains_.resize(droplets.size(), 0);

    const liquid& l = droplets.properties();
    const scalar least = gMin(T.primitiveField());
    if (least < (1 - 1e-9)*l.boilingTemperature)
    {
        FatalIOErrorInFunction(droplets.dict())
            << "Keyword 'boilingTemperature' of 'liquid' has the value "
            << l.boilingTemperature << ", and the gas is colder: " << least
            << " K" << nl
            << "    allowed: at most the lowest temperature of 0/T, as vapour does"
            << " not become liquid again" << exit(FatalIOError);
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


Foam::List<Foam::evaporation::link> Foam::evaporation::surface
(
    const surfaceScalarField& conductivity
) const
{
    volScalarField droplet
    (
        IOobject("dropletOfCell", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("none", dimless, -1)
    );
    forAll(droplet, celli)
    {
        droplet[celli] = term_.dropletOf(celli);
    }
    droplet.correctBoundaryConditions();

    const surfaceScalarField conductance
    (
        term_.conductance()*mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()
    );

    DynamicList<link> result;
    forAll(mesh_.neighbour(), facei)
    {
        const label P = mesh_.owner()[facei], N = mesh_.neighbour()[facei];
        if ((droplet[P] < 0) != (droplet[N] < 0))
        {
            const bool isOwner = droplet[P] < 0;
            result.append
            ({
                isOwner ? P : N, label(droplet[isOwner ? N : P]),
                mesh_.magSf()[facei], conductance[facei], conductivity[facei]
            });
        }
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchScalarField& d = droplet.boundaryField()[patchi];
        if (!d.coupled())
        {
            continue;
        }
        const scalarField own(d.patchInternalField());
        const scalarField neighbour(d.patchNeighbourField());
        forAll(d, i)
        {
            if (own[i] < 0 && neighbour[i] >= 0)
            {
                result.append
                ({
                    d.patch().faceCells()[i], label(neighbour[i]),
                    d.patch().magSf()[i], conductance.boundaryField()[patchi][i],
                    conductivity.boundaryField()[patchi][i]
                });
            }
        }
    }
    return List<link>(std::move(result));
}


Foam::scalarField Foam::evaporation::shares
(
    const List<link>& links,
    const volScalarField& T
) const
{
    scalarField heat(links.size());
    scalarField allHeat(droplets_.size(), Zero);
    scalarField allArea(droplets_.size(), Zero);
    forAll(links, i)
    {
        const link& l = links[i];
        heat[i] = l.conductance*l.conductivity
           *max(T[l.cell] - droplets_.properties().boilingTemperature, scalar(0));
        allHeat[l.droplet] += heat[i];
        allArea[l.droplet] += l.area;
    }
    sumOverRanks(allHeat);
    sumOverRanks(allArea);

    scalarField result(links.size());
    forAll(links, i)
    {
        const label d = links[i].droplet;
        const scalar byFluid = max(waitingFromFluid_[d], scalar(0));
        const scalar byGrains = max(waitingFromGrains_[d], scalar(0));
        const scalar local =
            isLocal_ && allHeat[d] > 0
          ? byFluid/max(byFluid + byGrains, VSMALL)
          : 0;
        result[i] =
            local*heat[i]/max(allHeat[d], VSMALL)
          + (1 - local)*links[i].area/allArea[d];
    }
    return result;
}


Foam::scalar Foam::evaporation::smallCoefficient
(
    const label i,
    const cellOverlap& o,
    const scalar T
) const
{
    const liquid& l = droplets_.properties();
    const scalar B = max
    (
        gas_.capacity()/gas_.rho()[o.cell]*(T - l.boilingTemperature)
       /l.latentHeat,
        scalar(1e-6)
    );
    // Where the steady profile around a source in a cell has the cell's temperature
    const bool isPlane = mesh_.nGeometricD() == 2;
    const scalar radius = 0.5*droplets_.system().fluidDiameter(i);
    const scalar reach = (isPlane ? 0.2 : 0.315)*droplets_.cellSize(i);
    const scalar part = min(radius/reach, scalar(0.9));
    const scalar surfacePerVolume = mesh_.nGeometricD()/radius;
    return
        gas_.kappa()[o.cell]/(radius*(isPlane ? -std::log(part) : 1 - part))
       *std::log1p(B)/B*surfacePerVolume*o.volume/mesh_.V()[o.cell];
}


void Foam::evaporation::remove(const std::vector<bool>& gone)
{
    for (IOField<scalar>* waiting : {&waitingFromFluid_, &waitingFromGrains_})
    {
        label left = 0;
        forAll(*waiting, i)
        {
            if (!gone[i])
            {
                (*waiting)[left++] = (*waiting)[i];
            }
        }
        waiting->resize(left);
    }
    fromFluid_ = scalarField(droplets_.size(), Zero);
    fromGrains_ = fromFluid_;
    lost_ = fromFluid_;
}


void Foam::evaporation::startStep(const volScalarField& T)
{
    const scalar latent = droplets_.properties().latentHeat;
    const List<link> links
    (
        surface(fvc::interpolate(gas_.kappa(), "interpolate(kappa)"))
    );
    scalarField isThere(droplets_.size(), Zero);
    for (const link& l : links)
    {
        isThere[l.droplet] = 1;
    }
    sumOverRanks(isThere);
    forAll(isThere, d)
    {
        isThere[d] = isThere[d] > 0 || droplets_.isSmall(d);
    }
    const scalarField share(shares(links, T));

    forAll(lost_, d)
    {
        const scalar heat = waitingFromFluid_[d] + waitingFromGrains_[d];
        lost_[d] =
            isThere[d] > 0
          ? min(max(heat, scalar(0))/latent, droplets_.mass(d))
          : 0;
        if (lost_[d] > 0 && droplets_.mass(d) - lost_[d] < droplets_.leastMass())
        {
            // What is left has no heat of its own: it is too little to tell
            lost_[d] = droplets_.mass(d);
        }
        if (lost_[d] > 0)
        {
            const scalar left = 1 - lost_[d]*latent/heat;
            waitingFromFluid_[d] *= left;
            waitingFromGrains_[d] *= left;
        }
    }

    vapour_ = scalarField(mesh_.nCells(), Zero);
    forAll(links, i)
    {
        const label celli = links[i].cell;
        vapour_[celli] +=
            share[i]*lost_[links[i].droplet]
           /(mesh_.V()[celli]*mesh_.time().deltaTValue());
    }
    for (label i = 0; i < droplets_.size(); ++i)
    {
        if (droplets_.isSmall(i))
        {
            for (const cellOverlap& o : droplets_.system().overlaps().of(i))
            {
                vapour_[o.cell] +=
                    lost_[i]*o.volume/droplets_.system().mappedVolume()[i]
                   /(mesh_.V()[o.cell]*mesh_.time().deltaTValue());
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
    const scalar boiling = droplets_.properties().boilingTemperature;
    links_ = surface(cells.conductivity);
    cells.conductivity *= term_.conductance();

    // A ten-thousandth of the difference to the gas is left
    hold_ = 1e4
       *(
            gas_.capacity()/mesh_.time().deltaTValue()
          + gMax
            (
                fvc::surfaceSum
                (
                    cells.conductivity*mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()
                )().primitiveField()
               /mesh_.V().field()
            )
        );

    smalls_.clear();
    for (label i = 0; i < droplets_.size(); ++i)
    {
        if (droplets_.isSmall(i))
        {
            for (const cellOverlap& o : droplets_.system().overlaps().of(i))
            {
                const scalar h = smallCoefficient(i, o, T[o.cell]);
                cells.add(o.cell, h, boiling);
                smalls_.append({o.cell, i, 0, h*mesh_.V()[o.cell], 1});
            }
        }
    }

    const scalarField vapour(vapourVolume());
    forAll(T, celli)
    {
        if (term_.isLiquid(celli))
        {
            cells.add(celli, hold_, boiling);
        }
        if (vapour[celli] > 0)
        {
            cells.add(celli, gas_.capacity()*vapour[celli], boiling);
        }
    }
}


void Foam::evaporation::take(const volScalarField& T)
{
    const scalar boiling = droplets_.properties().boilingTemperature;
    const scalar deltaT = mesh_.time().deltaTValue();
    const scalarField& V = mesh_.V();
    const scalarField vapour(vapourVolume());

    scalarField all(droplets_.size(), Zero);
    fromFluid_ = Zero;
    taken_ = 0;
    forAll(T, celli)
    {
        const label d = term_.dropletOf(celli);
        if (d >= 0)
        {
            all[d] += deltaT*V[celli]*hold_*(T[celli] - boiling);
        }
        taken_ +=
            deltaT*V[celli]*gas_.capacity()*vapour[celli]*(T[celli] - boiling);
    }
    for (const link& l : smalls_)
    {
        const scalar heat = deltaT*l.conductance*(T[l.cell] - boiling);
        all[l.droplet] += heat;
        fromFluid_[l.droplet] += heat;
    }
    for (const link& l : links_)
    {
        fromFluid_[l.droplet] +=
            deltaT*l.conductance*l.conductivity*(T[l.cell] - boiling);
    }
    sumOverRanks(all);
    sumOverRanks(fromFluid_);
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
