/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lockedGrains.H"

#include "byVolume.H"
#include "reconstruction.H"
#include "zeroGradientFvPatchFields.H"

void Foam::lockedGrains::startCorrections
(
    const volScalarField& inertia,
    const volScalarField& A,
    const surfaceScalarField& drag,
    surfaceScalarField& mobility
)
{
    if (!isActive())
    {
        return;
    }

    // All the inertia of the two cells, the grain's, too.  What fluid beside a
    // grain has from its neighbours does not take it through the surface: there,
    // viscosity holds it to the grain.
    const surfaceScalarField& faces = cells_.lockedFaces();
    inertia_ = byVolume((1 - locked())*inertia);
    hold_ = byVolume((1 - locked())*A) - inertia_();
    mobility_ = 1/(byVolume(A) + drag);
    ownDrag_ = locked()*A;
    ownForce_.clear();
    mobility = (1 - faces)*mobility + faces*mobility_();
}


void Foam::lockedGrains::correctFlux
(
    const volVectorField& AU,
    const surfaceScalarField& oldFlux,
    const surfaceScalarField&,
    const volVectorField& U,
    const surfaceScalarField& knownForce,
    surfaceScalarField& flux
)
{
    if (!isActive())
    {
        return;
    }
    const surfaceScalarField& faces = cells_.lockedFaces();
    ownForce_ = locked()*AU;
    flux =
        (1 - faces)*flux
      + faces*mobility_()
       *(
            fluxByVolume(ownForce_())
          + inertia_()*oldFlux
          + hold_()*cells_.bodyFlux(U)
          + knownForce
          + rigidForce_
        );
}


void Foam::lockedGrains::correctFaceForce(surfaceScalarField& force) const
{
    if (isActive())
    {
        force -= rigidForce_;
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::lockedGrains::densityBeside
(
    const surfaceScalarField& fluidPart
) const
{
    volScalarField density
    (
        IOobject("lockedDensity", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimDensity, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(density, celli)
    {
        const label graini = cells_.grain(celli);
        if (graini >= 0)
        {
            density[celli] = grains_.motion().density(graini);
        }
    }
    density.correctBoundaryConditions();
    return
        max
        (
            byVolume(density),
            dimensionedScalar("least", dimDensity, VSMALL)
        )
       /max(1 - fluidPart, scalar(SMALL));
}


void Foam::lockedGrains::correctForce
(
    const surfaceScalarField& faceForce,
    const surfaceScalarField& flux,
    const volScalarField& rho,
    const forceOfGrains& grains,
    volVectorField& gradient
)
{
    if (!isActive())
    {
        return;
    }

    // The inertia that a locked cell would have of the fluid beside it is missing
    // at their face
    const surfaceScalarField fluidPart(byVolume(1 - locked()));
    const surfaceScalarField beside
    (
        "beside", pos(fluidPart*(1 - fluidPart) - SMALL)
    );
    const surfaceScalarField rhoBeside
    (
        byVolume((1 - locked())*rho)/max(fluidPart, scalar(SMALL))
    );
    const surfaceScalarField full
    (
        "fullInertia",
        beside*rhoBeside*(flux - flux.oldTime())/mesh_.time().deltaT()
    );
    const surfaceScalarField missing((1 - fluidPart)*full);
    gradient += locked()*reconstructed(full) - reconstructed(missing);

    if (grains_.motion().isFixed())
    {
        gradient +=
            (1 - 2*locked())
           *reconstructed
            (
                cells_.continued(faceForce + grains.atLocked - missing, grains)
            );
        return;
    }

    // What viscosity and rigidity do to a grain the fluid at its faces sees as far
    // as it has the grain's inertia; as far as it has not, its pressure goes on
    // along the surface as it does in the fluid, and the grain takes the difference
    const surfaceScalarField lighter
    (
        beside*max(1 - rhoBeside/densityBeside(fluidPart), scalar(0))
    );
    surfaceScalarField seen(faceForce + grains.atLocked - missing);
    if (ownForce_.valid())
    {
        const surfaceScalarField own
        (
            lighter
           *(fluxByVolume(ownForce_()) - byVolume(ownDrag_())*flux)
        );
        seen -= own;
        gradient +=
            locked()*reconstructed(own/max(1 - fluidPart, scalar(SMALL)))
          - reconstructed(own);
    }
    gradient +=
        (1 - 2*locked())
       *reconstructed(lighter*cells_.continued(seen, grains));
}


void Foam::lockedGrains::correctMotion
(
    volVectorField& U,
    const surfaceScalarField& flux,
    const surfaceScalarField& drag
)
{
    if (!isActive() || grains_.motion().isFixed())
    {
        return;
    }
    cells_.makeRigid(freeU_, cellInertia_, U);

    // A face that comes to a grain takes its motion as fast as the fluid beside
    // it follows its neighbours; others have it and go on with the grain.  What
    // holds a face back is a pressure in the grain, which pushes the fluid aside
    // where faces are not across the line of their cells.
    const surfaceScalarField asBody(cells_.bodyFlux(U));
    const surfaceScalarField before
    (
        flux.oldTime() - cells_.bodyFlux(lastU_)
    );
    const dimensionedScalar least("least", inertia_().dimensions(), VSMALL);
    const surfaceScalarField left
    (
        inertia_()
       /max
        (
            inertia_() + hold_() + mag(mesh_.nonOrthCorrectionVectors())*drag,
            least
        )
    );
    const surfaceScalarField stiffness(sqr(inertia_() + drag)*mobility_());
    rigidForce_ += cells_.withoutForce
    (
        stiffness*(asBody + left*before - flux),
        stiffness
    );
}
