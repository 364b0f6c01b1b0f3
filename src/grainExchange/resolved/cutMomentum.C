/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"

#include "combineOverRanks.H"
#include "cutSlopes.H"
#include "fvc.H"
#include "fvm.H"
#include "gaussConvectionScheme.H"
#include "reconstruction.H"
#include "resolvedGrains.H"
#include "upwind.H"

void Foam::cutGrains::addToMomentum
(
    fvVectorMatrix& UEqn,
    const surfaceScalarField& massFlux,
    const surfaceScalarField& mu
) const
{
    if (!isActive())
    {
        return;
    }
    const volVectorField& U = UEqn.psi();
    const surfaceScalarField& cut = cells_.cutFaces();

    // Upwind between cells of which one may be small, and as much of the scheme
    // as the smaller one bears; nothing passes what is closed by now
    const word scheme("div(" + massFlux.name() + ',' + U.name() + ')');
    const surfaceScalarField all(massFlux.name(), cut*massFlux);
    const surfaceScalarField flux(massFlux.name(), pos(cells_.open())*all);

    const surfaceScalarField bearable(min(4*smallerFluid(), scalar(1)));

    tmp<surfaceScalarField> tflux(flux);
    const upwind<vector> simple(mesh_, flux);
    const surfaceVectorField ahead
    (
        fv::convectionScheme<vector>::New
        (
            mesh_, flux, mesh_.divScheme(scheme)
        )().interpolate(flux, U)
    );
    UEqn -= fvm::div(all, U, scheme) - fvm::Sp(fvc::div(all), U);
    UEqn +=
        fv::gaussConvectionScheme<vector>
        (
            mesh_, flux,
            tmp<surfaceInterpolationScheme<vector>>(new upwind<vector>(mesh_, flux))
        ).fvmDiv(flux, U)
      - fvm::Sp(fvc::div(flux), U)
      + fvc::surfaceIntegrate(flux*bearable*(ahead - simple.interpolate(U)));

    const cutCurvature curvature(setLinks(U));
    const cutSlopes<vector> slopes
    (
        cells_, U, [&](const label walli) { return velocityAt(walli); }
    );
    UEqn -= fvc::surfaceIntegrate(mu*mesh_.magSf()*slopes.besideTheLine());
    UEqn -= fvc::surfaceIntegrate(curvature.flux(mu));

    outflow_ =
        fvc::surfaceIntegrate(massFlux - all + flux)().primitiveField()
       *mesh_.V().field();

    scalarField& diagonal = UEqn.diag();
    vectorField& source = UEqn.source();
    const List<cutCells::wall>& walls = cells_.walls();
    forAll(walls, i)
    {
        diagonal[walls[i].cell] += link_[i];
        source[walls[i].cell] += link_[i]*velocityAt(i);
    }
    forAll(hold_, celli)
    {
        if (cover_[celli] >= 0)
        {
            diagonal[celli] += hold_[celli];
            source[celli] += hold_[celli]*velocityIn(celli);
        }
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::cutGrains::smallerFluid() const
{
    tmp<surfaceScalarField> tsmaller(0*cells_.cutFaces());
    surfaceScalarField& smaller = tsmaller.ref();
    const scalarField& fluid = cells_.fluid();
    forAll(mesh_.owner(), facei)
    {
        smaller[facei] =
            min(fluid[mesh_.owner()[facei]], fluid[mesh_.neighbour()[facei]]);
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchScalarField& x = cells_.fluid().boundaryField()[patchi];
        if (mesh_.boundary()[patchi].coupled())
        {
            smaller.boundaryFieldRef()[patchi] =
                min(x.patchInternalField(), x.patchNeighbourField());
        }
    }
    return tsmaller;
}


void Foam::cutGrains::startCorrections
(
    const volScalarField& inertia,
    const volScalarField& A,
    const surfaceScalarField&,
    surfaceScalarField& mobility
)
{
    if (!isActive())
    {
        return;
    }
    A_ = new volScalarField("cutA", A);
    resists_ = Zero;
    forAll(link_, i)
    {
        resists_[cells_.walls()[i].grain] += link_[i]*(1 - follows(i));
    }
    sumOverRanks(resists_);
    setInertia();
    const surfaceScalarField diagonal(fvc::interpolate(A));
    left_ = smallerFluid()*fvc::interpolate(inertia)/(cells_.fluidOfFaces()*diagonal);
    const surfaceScalarField& cut = cells_.cutFaces();
    mobility =
        (1 - cut)*mobility + cut*cells_.open()*cells_.fluidOfFaces()/diagonal;
}


void Foam::cutGrains::correctFlux
(
    const volVectorField& AU,
    const surfaceScalarField&,
    const surfaceScalarField& oldFaceVelocity,
    const volVectorField& U,
    const surfaceScalarField&,
    surfaceScalarField& flux
)
{
    if (!isActive())
    {
        return;
    }
    const surfaceScalarField& cut = cells_.cutFaces();
    const volScalarField& fluid = cells_.fluid();
    const tmp<surfaceScalarField> tofCells
    (
        fvc::flux(fluid*U.oldTime())/cells_.fluidOfFaces()
    );
    flux =
        (1 - cut)*flux
      + cut*cells_.open()
       *(
            fvc::flux(AU)/fvc::interpolate(A_())
          + left_()*(oldFaceVelocity - tofCells)
        );
}


void Foam::cutGrains::setInertia()
{
    // So much of the fluid's that a grain which is fixed hardly yields
    constexpr scalar fixed = 1e4;

    const grainMotion& motion = grains_.motion();
    const scalar deltaT = mesh_.time().deltaTValue();
    if (motion.isFixed())
    {
        inertia_ = scalarField
        (
            grains_.size(), fixed*gMax(fluid_.rho().primitiveField())/deltaT
        );
        return;
    }
    inertia_ = resists_/grains_.mappedVolume();
    forAll(inertia_, graini)
    {
        inertia_[graini] += motion.density(graini)/deltaT;
    }
}


void Foam::cutGrains::correctSource(fvVectorMatrix& UEqn)
{
    if (!isActive() || grains_.motion().isFixed())
    {
        return;
    }
    vectorField& source = UEqn.source();
    const List<cutCells::wall>& walls = cells_.walls();
    forAll(walls, i)
    {
        const cutCells::wall& x = walls[i];
        source[x.cell] +=
            link_[i]
           *(motion_[x.grain].at(x.arm) - inSource_[x.grain].at(x.arm));
    }
    inSource_ = motion_;
}


void Foam::cutGrains::addToMobility(surfaceScalarField& mobility) const
{
    for (const cutCells::part& x : cells_.parts())
    {
        resolvedFace::at(mobility, x.patch, x.face) += x.share/inertia_[x.grain];
    }
}


void Foam::cutGrains::addToFlux(surfaceScalarField& flux) const
{
    using resolvedFace::at;

    for (const cutCells::part& x : cells_.parts())
    {
        at(flux, x.patch, x.face) +=
            x.share
           *(
                (motion_[x.grain].velocity & at(mesh_.Sf(), x.patch, x.face))
              + at(gradient_(), x.patch, x.face)/inertia_[x.grain]
            );
    }
}


void Foam::cutGrains::correctFaceVelocity
(
    const surfaceScalarField& fluxOfOpen,
    surfaceScalarField& flux
) const
{
    if (!isActive())
    {
        return;
    }
    const surfaceScalarField& cut = cells_.cutFaces();
    flux = (1 - cut)*flux + cut*fluxOfOpen/max(cells_.open(), scalar(SMALL));

    // Of a face that is closed, the grain's
    using resolvedFace::at;
    for (const cutCells::part& x : cells_.parts())
    {
        if (at(cells_.open(), x.patch, x.face) == 0)
        {
            at(flux, x.patch, x.face) =
                motion_[x.grain].velocity & at(mesh_.Sf(), x.patch, x.face);
        }
    }
}


void Foam::cutGrains::correctForce
(
    const surfaceScalarField& faceForce,
    const surfaceScalarField&,
    const volScalarField&,
    const forceOfGrains&,
    volVectorField& gradient
)
{
    if (!isActive())
    {
        return;
    }
    gradient_ = new surfaceScalarField("gradientOfFaces", faceForce);

    const volVectorField inOpen(gradientInOpen(faceForce));
    const volVectorField inAll(reconstructed(faceForce));
    const scalarField& open = cells_.fluid();
    for (const cutCells::wall& x : cells_.walls())
    {
        const label c = x.cell;
        gradient[c] = open[c] > 0 ? inOpen[c] : vector(Zero);
        pressure_[c] = mesh_.V()[c]*(open[c]*gradient[c] - inAll[c]);
    }
}


void Foam::cutGrains::correctMotion
(
    volVectorField& U,
    const surfaceScalarField&,
    const surfaceScalarField&
)
{
    if (!isActive())
    {
        return;
    }
    if (!grains_.motion().isFixed())
    {
        moveGrains(U);
    }
    sumLinks();
    forAll(cover_, celli)
    {
        if (cover_[celli] >= 0)
        {
            U[celli] = velocityIn(celli);
        }
    }
}


void Foam::cutGrains::moveGrains(volVectorField& U)
{
    setRemainder(U);
    vectorField force(grains_.size(), Zero);
    addForceOfCells(U, force);
    sumOverRanks(force);

    const List<grainMotion::twist> last(motion_);
    const scalar deltaT = mesh_.time().deltaTValue();
    forAll(motion_, graini)
    {
        const scalar inertia = grains_.motion().mass(graini)/deltaT;
        motion_[graini].velocity =
            (
                inertia*free_[graini].velocity
              + resists_[graini]*last[graini].velocity
              + force[graini]
            )
           /(inertia + resists_[graini]);
    }
    const List<cutCells::wall>& walls = cells_.walls();
    forAll(walls, i)
    {
        const label graini = walls[i].grain;
        U[walls[i].cell] +=
            follows(i)*(motion_[graini].velocity - last[graini].velocity);
    }
}
