/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedHeat.H"

#include "combineOverRanks.H"
#include "poorConductors.H"

bool Foam::resolvedHeat::conductsInside(const grainSystem& grains)
{
    const grainTemperatures& heat = grains.temperatures();
    if (!heat.conductInside())
    {
        return false;
    }
    const auto refuse = [&](const string& allowed)
    {
        FatalIOErrorInFunction(grains.motion().coupling())
            << "Keyword 'inside' of 'heat' in constant/grainProperties has the"
            << " value conducting" << nl
            << "    allowed: " << allowed.c_str() << exit(FatalIOError);
    };
    if (!grains.motion().isFixed())
    {
        refuse("isothermal, as the grains move: only fixed ones conduct inside");
    }
    if (heat.conductThroughContacts())
    {
        refuse("isothermal, or 'conductance none' beside it");
    }
    for (label i = 0; i < grains.size(); ++i)
    {
        if (heat.conductivity(i) <= 0)
        {
            refuse("isothermal, or materials with a conductivity [W/m/K]");
        }
    }
    return true;
}


Foam::resolvedHeat::resolvedHeat
(
    const grainSystem& grains,
    const resolvedTerm& resolved
)
:
    grains_(grains),
    resolved_(resolved),
    conducts_(conductsInside(grains)),
    lockedVolume_(grains.size(), Zero)
{
    if (!resolved.leavesParts())
    {
        return;
    }
    if (conducts_)
    {
        resolved.requireWholeCells("grains that conduct inside");
    }
    cut_ = std::make_unique<cutHeat>(grains);
}


Foam::tmp<Foam::volScalarField> Foam::resolvedHeat::grainOfCells() const
{
    tmp<volScalarField> tgrain
    (
        new volScalarField
        (
            IOobject
            (
                "grainOfCells", grains_.mesh().time().timeName(), grains_.mesh()
            ),
            grains_.mesh(),
            dimensionedScalar("none", dimless, -1)
        )
    );
    forAll(tgrain(), celli)
    {
        tgrain.ref()[celli] = resolved_.grainOf(celli);
    }
    tgrain.ref().correctBoundaryConditions();
    return tgrain;
}


template<class Function>
void Foam::resolvedHeat::forParts(const Function& f) const
{
    for (label graini = 0; graini < grains_.size(); ++graini)
    {
        if (resolved_.isResolved(graini))
        {
            for (const cellOverlap& o : grains_.overlaps().of(graini))
            {
                f(o.cell, graini, o.volume);
            }
        }
    }
}


Foam::scalar Foam::resolvedHeat::capacity(const label graini) const
{
    return grains_.temperatures().heatCapacity(graini)/grains_.volume(graini);
}


Foam::scalar Foam::resolvedHeat::conductivity
(
    const scalar k,
    const label own,
    const label neighbour,
    const scalar byPart
) const
{
    if (own == neighbour)
    {
        return conducts_ ? grains_.temperatures().conductivity(own) : 0;
    }
    if (!conducts_)
    {
        return byPart*k;
    }
    const auto ofGrain = [&](const label graini)
    {
        return grains_.temperatures().conductivity(graini);
    };
    const scalar kGrain =
        2/(1/ofGrain(own < 0 ? neighbour : own) + 1/ofGrain(neighbour < 0 ? own : neighbour));
    if (kGrain < k)
    {
        // But for what poorConductors finds inside
        return k;
    }
    const scalar part = 1/byPart;
    return 1/(part/k + (1 - part)/kGrain);
}


void Foam::resolvedHeat::setFaces
(
    const volScalarField& T,
    const volScalarField& kappa,
    const volScalarField& kappaOfFluid,
    surfaceScalarField& faces
) const
{
    const fvMesh& mesh = grains_.mesh();
    const volScalarField grain(grainOfCells());
    const surfaceScalarField byPart(byDistance(resolved_.conductanceOfHeat(), T));
    const surfaceScalarField fluid("kappaOfFluid", faces);

    // Where there is a locked cell on either side, of the fluid between what it is
    // locked to and another grain or a wall; else that which grains leave open
    const auto set = [&]
    (
        scalar& faceK,
        const scalar open,
        const scalar whole,
        const label own,
        const label neighbour,
        const bool isWall,
        const scalar part
    )
    {
        if (own >= 0 || neighbour >= 0)
        {
            const bool isGap = isWall || (own >= 0 && neighbour >= 0);
            faceK = conductivity(isGap ? whole : open, own, neighbour, part);
        }
    };
    const auto open = [](const label own, const scalar kOwn, const scalar kNeighbour)
    {
        return own < 0 ? kOwn : kNeighbour;
    };

    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        set
        (
            faces[facei],
            open(label(grain[P]), kappa[P], kappa[N]),
            0.5*(kappaOfFluid[P] + kappaOfFluid[N]),
            label(grain[P]), label(grain[N]), false, byPart[facei]
        );
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatchScalarField& g = grain.boundaryField()[patchi];
        const fvPatchScalarField& k = kappa.boundaryField()[patchi];
        const fvPatchScalarField& kFluid = kappaOfFluid.boundaryField()[patchi];
        const bool isWall = !g.coupled();
        const scalarField whole
        (
            isWall
          ? scalarField(kFluid)
          : scalarField(0.5*(kFluid.patchInternalField() + kFluid.patchNeighbourField()))
        );
        const scalarField own(g.patchInternalField());
        const scalarField neighbour
        (
            isWall ? scalarField(g.size(), -1) : scalarField(g.patchNeighbourField())
        );
        const scalarField kOwn(k.patchInternalField());
        const scalarField kNeighbour
        (
            isWall ? scalarField(k) : scalarField(k.patchNeighbourField())
        );
        forAll(g, i)
        {
            set
            (
                faces.boundaryFieldRef()[patchi][i],
                open(label(own[i]), kOwn[i], kNeighbour[i]),
                whole[i],
                label(own[i]), label(neighbour[i]), isWall,
                byPart.boundaryField()[patchi][i]
            );
        }
    }
    if (conducts_)
    {
        poorConductors(grains_, resolved_, fluid).set(fluid, faces);
    }
}


Foam::scalarField Foam::resolvedHeat::conductance() const
{
    return
        cut_ && resolved_.isActive()
      ? cut_->conductance()
      : scalarField(grains_.overlaps().size(), Zero);
}


void Foam::resolvedHeat::add
(
    const volScalarField& T,
    const volScalarField& kappa,
    const thermalFluid& fluid,
    const volVectorField& U,
    cellHeat& cells
)
{
    if (!resolved_.isActive())
    {
        return;
    }
    const fvMesh& mesh = grains_.mesh();
    const scalar deltaT = mesh.time().deltaTValue();

    lockedVolume_ = scalarField(grains_.size(), Zero);
    if (cut_)
    {
        boolList isResolved(grains_.size());
        forAll(isResolved, i)
        {
            isResolved[i] = resolved_.isResolved(i);
        }
        cut_->add(isResolved, T, kappa, fluid, U, cells);
        return;
    }
    forAll(mesh.V(), celli)
    {
        const label graini = resolved_.grainOf(celli);
        if (graini >= 0)
        {
            lockedVolume_[graini] += mesh.V()[celli];
        }
    }
    sumOverRanks(lockedVolume_);
    setFaces(T, kappa, fluid.kappa(), cells.conductivity);

    if (!conducts_)
    {
        return;
    }
    forParts
    (
        [&](const label celli, const label graini, const scalar volume)
        {
            cells.add
            (
                celli, volume/mesh.V()[celli]*capacity(graini)/deltaT, T[celli]
            );
        }
    );
}


void Foam::resolvedHeat::addReceived
(
    const volScalarField& T,
    scalarField& heat
) const
{
    if (!resolved_.isActive() || !conducts_)
    {
        return;
    }
    forParts
    (
        [&](const label celli, const label graini, const scalar volume)
        {
            heat[graini] +=
                capacity(graini)*volume
               *(T[celli] - grains_.temperatures().temperature(graini));
        }
    );
}
