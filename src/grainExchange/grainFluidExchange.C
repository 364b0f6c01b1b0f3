/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFluidExchange.H"

#include "dictionaryInput.H"
#include "zeroGradientFvPatchFields.H"

template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>
Foam::grainFluidExchange::zeroField
(
    const word& name,
    const dimensionSet& dims
) const
{
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject(name, mesh_.time().timeName(), mesh_),
        mesh_,
        dimensioned<Type>(dims, Zero)
    );
}


bool Foam::grainFluidExchange::readForm(const dictionary& dict)
{
    return
        dictionaryInput::getWordOrDefault(dict, "form", "A", {"A", "B"}) == "A";
}


Foam::grainFluidExchange::grainFluidExchange
(
    grainSystem& grains,
    const dimensionedScalar& rho,
    const dimensionedScalar& mu
)
:
    grains_(grains),
    mesh_(grains.mesh()),
    rho_(rho),
    mu_(mu),
    drag_
    (
        dragLaw::New
        (
            dictionaryInput::subDict
            (
                grains.motion().coupling(), "drag"
            ),
            mesh_.nGeometricD()
        )
    ),
    addedMass_
    (
        dictionaryInput::getScalarOrDefault
        (
            grains.motion().coupling(), "addedMass", dimless, 0, 0
        )
    ),
    lift_(liftLaw::all(grains.motion().coupling())),
    gradientOnGrains_(readForm(grains.motion().coupling())),
    undisturbed_(grains, gradientOnGrains_),
    resolved_(grains, rho.value(), mu.value()),
    eps_
    (
        IOobject
        (
            "eps",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedScalar("eps", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    fluidShare_("fluidShare", eps_),
    overfull_(0),
    kappa_(zeroField<scalar>("kappa", dimless)),
    beta_(zeroField<scalar>("beta", dimDensity/dimTime)),
    b_(zeroField<vector>("b", dimForce/dimVolume)),
    G_(zeroField<vector>("G", dimVelocity)),
    K_(zeroField<scalar>("K", dimTime/dimDensity)),
    outside_(Zero),
    given_(Zero),
    received_(Zero)
{
    setEps();
}


void Foam::grainFluidExchange::setEps()
{
    const overlapList& overlaps = grains_.overlaps();

    scalarField solid(mesh_.nCells(), Zero);
    for (label k = 0; k < overlaps.size(); ++k)
    {
        solid[overlaps.cell[k]] += overlaps.volume[k];
    }
    solid /= mesh_.V().field();
    grains_.voidFraction().smooth(solid);

    overfull_ = 0;
    forAll(solid, celli)
    {
        const scalar room = 1 - solid[celli];
        eps_[celli] = max(room, scalar(0));
        overfull_ += max(-room, scalar(0))*mesh_.V()[celli];
    }
    reduce(overfull_, sumOp<scalar>());
    eps_.correctBoundaryConditions();
}


Foam::tmp<Foam::volVectorField> Foam::grainFluidExchange::seenByGrains
(
    const volVectorField& x
) const
{
    if (!grains_.voidFraction().smooths())
    {
        return tmp<volVectorField>(x);
    }
    tmp<volVectorField> result(new volVectorField(x.name() + "Seen", x));
    grains_.voidFraction().smooth(result.ref().primitiveFieldRef());
    result.ref().correctBoundaryConditions();
    return result;
}


void Foam::grainFluidExchange::predict(const volVectorField& cellU)
{
    const stopwatch::lap lap(time_);
    const tmp<volVectorField> tU(seenByGrains(cellU));
    const volVectorField& U = tU();
    const overlapList& overlaps = grains_.overlaps();
    const scalar deltaT = mesh_.time().deltaTValue();

    gamma_.resize(overlaps.size());
    a_.resize(overlaps.size());
    vo_.resize(overlaps.size());
    resolved_.update();
    setFluidShare();
    setKnownForce(U);
    undisturbed_.set(grains_, resolved_, eps_, U, *drag_, rho_.value(), mu_.value());

    kappa_ = dimensionedScalar(kappa_.dimensions(), Zero);
    beta_ = dimensionedScalar(beta_.dimensions(), Zero);
    b_ = dimensionedVector(b_.dimensions(), Zero);
    G_ = dimensionedVector(G_.dimensions(), Zero);
    K_ = dimensionedScalar(K_.dimensions(), Zero);

    const scalarField& V = mesh_.V();
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if
        (
            overlaps.start[graini] == overlaps.start[graini + 1]
         || resolved_.isResolved(graini)
        )
        {
            continue;
        }
        const scalar rhop = grains_.motion().density(graini);
        const scalar d = grains_.fluidDiameter(graini);
        const grainMotion::twist motion(grains_.motion().motion(graini));
        const grainMotion::twist freeMotion(this->freeMotion(graini));

        for
        (
            label k = overlaps.start[graini];
            k < overlaps.start[graini + 1];
            ++k
        )
        {
            const label celli = overlaps.cell[k];
            const vector& arm = overlaps.arm[k];
            const vector v(motion.at(arm));

            const scalar eps = max(eps_[celli], epsMin);
            gamma_[k] = drag_->gamma
            (
                eps, mag(U[celli] - v), d, rho_.value(), mu_.value()
            );
            if (!gradientOnGrains_)
            {
                gamma_[k] /= eps;
            }
            gamma_[k] = undisturbed_.corrected(gamma_[k], graini);
            gamma_[k] += dragOfAddedMass();
            a_[k] = 1/(1 + gamma_[k]*deltaT/rhop);
            vo_[k] = freeMotion.at(arm) + deltaT/rhop*e_[k];

            const scalar w = overlaps.volume[k]/V[celli];
            const scalar wa = w*a_[k];
            const scalar wag = wa*gamma_[k];
            const scalar wat = wa*deltaT/rhop;
            kappa_[celli] += wat*gamma_[k];
            beta_[celli] += wag;
            b_[celli] += wag*vo_[k] - w*e_[k];
            G_[celli] += wa*vo_[k];
            if (gradientOnGrains_)
            {
                K_[celli] += wat;
            }
        }
    }

    addLocked();

    const voidFractionMethod& method = grains_.voidFraction();
    method.smooth(kappa_.primitiveFieldRef());
    method.smooth(beta_.primitiveFieldRef());
    method.smooth(b_.primitiveFieldRef());
    method.smooth(G_.primitiveFieldRef());
    method.smooth(K_.primitiveFieldRef());

    kappa_.correctBoundaryConditions();
    beta_.correctBoundaryConditions();
    b_.correctBoundaryConditions();
    G_.correctBoundaryConditions();
    K_.correctBoundaryConditions();

    setFreePatches(cellU);
    extrapolate(kappa_);
    extrapolate(beta_);
    extrapolate(b_);
    extrapolate(G_);
    extrapolate(K_);
}
