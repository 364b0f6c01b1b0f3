/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"

#include "cutSlopes.H"
#include "fvc.H"
#include "fvm.H"
#include "gaussConvectionScheme.H"
#include "reconstruction.H"
#include "resolvedGrains.H"
#include "upwind.H"

Foam::tmp<Foam::surfaceScalarField> Foam::cutGrains::fluxOfVolume
(
    const surfaceScalarField& eps,
    const surfaceScalarField& phiU,
    const surfaceScalarField& phiOpen
) const
{
    const surfaceScalarField& cut = cells_.cutFaces();
    const surfaceScalarField isAlone(pos0(amongSmall_ - 1));
    return
        (1 - cut)*eps*phiU
      + cut
       *(
            isAlone*phiOpen
          + (1 - isAlone)*amongSmall_*cells_.open()*phiU
        );
}


Foam::tmp<Foam::surfaceScalarField> Foam::cutGrains::fluxInOpen
(
    const surfaceScalarField& phi,
    const surfaceScalarField& phiU,
    const surfaceScalarField& gradient
) const
{
    if (!isActive())
    {
        return phi;
    }
    const surfaceScalarField& cut = cells_.cutFaces();
    return
        (1 - cut)*phi
      + cut
       *(
            fvc::interpolate(movingShare())*phiU
          + fvc::flux(small_->G)
          - fvc::interpolate(small_->K)*gradient
        )
       /cells_.fluidOfFaces();
}


void Foam::cutGrains::shareSources(fvVectorMatrix& sources)
{
    if (!isActive())
    {
        return;
    }
    const vectorField& U = sources.psi().primitiveField();
    const scalarField& open = cells_.fluid();
    forAll(given_, celli)
    {
        scalar& diagonal = sources.diag()[celli];
        vector& source = sources.source()[celli];
        given_[celli] = (1 - open[celli])*(diagonal*U[celli] - source);
        diagonal *= open[celli];
        source *= open[celli];
    }
}


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
    // as the smaller one bears, and its small grains leave; nothing passes what is
    // closed by now
    const word scheme("div(" + massFlux.name() + ',' + U.name() + ')');
    const surfaceScalarField all(massFlux.name(), cut*massFlux);
    const surfaceScalarField flux(massFlux.name(), pos(cells_.open())*all);

    const surfaceScalarField bearable
    (
        min(4*smallerFluid(), scalar(1))
       *min(max(10*amongSmall_ - 3, scalar(0)), scalar(1))
    );

    tmp<surfaceScalarField> tflux(flux);
    const upwind<vector> simple(mesh_, flux);
    const surfaceVectorField ahead
    (
        fv::convectionScheme<vector>::New
        (
            mesh_, flux, mesh_.divScheme(scheme)
        )().interpolate(flux, U)
    );
    UEqn +=
        fv::gaussConvectionScheme<vector>
        (
            mesh_, flux,
            tmp<surfaceInterpolationScheme<vector>>(new upwind<vector>(mesh_, flux))
        ).fvmDiv(flux, U)
      - fvm::Sp(fvc::div(flux), U)
      + fvc::surfaceIntegrate(flux*bearable*(ahead - simple.interpolate(U)));

    const cutCurvature curvature(setLinks(U, mu));
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
    A_ = new volScalarField("cutA", A + small_->beta);
    setResistance();
    setInertia();
    const surfaceScalarField diagonal(fvc::interpolate(A_()));
    const surfaceScalarField open(cells_.fluidOfFaces());
    const surfaceScalarField moving(fvc::interpolate(movingShare()));
    left_ = smallerFluid()*fvc::interpolate(inertia)/(open*diagonal);
    moving_ = moving/open;
    const surfaceScalarField& cut = cells_.cutFaces();
    mobility =
        (1 - cut)*mobility
      + cut*cells_.open()
       *(
            moving_()*moving/diagonal
          + fvc::interpolate(small_->K)/open
        );
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
            moving_()
           *(
                fvc::flux(AU + small_->b)/fvc::interpolate(A_())
              + left_()*(oldFaceVelocity - tofCells)
            )
          + fvc::flux(small_->G)/cells_.fluidOfFaces()
        );
}


Foam::tmp<Foam::volScalarField> Foam::cutGrains::movingShare() const
{
    tmp<volScalarField> tshare(small_->fluidShare + small_->kappa);
    volScalarField& share = tshare.ref();
    forAll(cover_, celli)
    {
        share[celli] -= cover_[celli] < 0 ? 0 : 1;
    }
    share.correctBoundaryConditions();
    return tshare;
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
                (motion_[x.grain].at(x.arm) & at(mesh_.Sf(), x.patch, x.face))
              + at(gradient_(), x.patch, x.face)/inertia_[x.grain]
            );
    }
}


void Foam::cutGrains::correctFaceVelocity
(
    const surfaceScalarField& fluxOfOpen,
    const surfaceScalarField& gradient,
    surfaceScalarField& flux
) const
{
    if (!isActive())
    {
        return;
    }
    const surfaceScalarField& cut = cells_.cutFaces();
    flux =
        (1 - cut)*flux
      + cut
       *(
            fluxOfOpen/max(cells_.open(), scalar(SMALL))
          - (
                fvc::flux(small_->G) - fvc::interpolate(small_->K)*gradient
            )/cells_.fluidOfFaces()
        )
       /max(moving_(), exchangeFields::epsMin);

    // Of a face that is closed, the grain's
    using resolvedFace::at;
    for (const cutCells::part& x : cells_.parts())
    {
        if (at(cells_.open(), x.patch, x.face) == 0)
        {
            at(flux, x.patch, x.face) =
                motion_[x.grain].at(x.arm) & at(mesh_.Sf(), x.patch, x.face);
        }
    }
}


void Foam::cutGrains::correctForce
(
    const surfaceScalarField& faceForce,
    const surfaceScalarField& flux,
    const volScalarField&,
    const forceOfGrains& grains,
    volVectorField& gradient
)
{
    if (!isActive())
    {
        return;
    }
    gradient_ = new surfaceScalarField("gradientOfFaces", grains.gradient);

    const volVectorField inOpen
    (
        grains.share*gradientInOpen(faceForce)
      + grains.b
      - grains.beta*gradientInOpen(flux)
    );
    const volVectorField inAll(reconstructed(grains.gradient));
    const scalarField& open = cells_.fluid();
    for (const cutCells::wall& x : cells_.walls())
    {
        const label c = x.cell;
        gradient[c] = open[c] > 0 ? inOpen[c] : vector(Zero);
        pressure_[c] = mesh_.V()[c]*(open[c]*gradient[c] - inAll[c]);
        moment_[c] =
            open[c]*cells_.shift()[c]
          ^ (
                mesh_.V()[c]*gradient[c]
              - given_[c]/max(1 - open[c], SMALL)
            );
    }
}
