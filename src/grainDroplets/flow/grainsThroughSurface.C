/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletTerm.H"

#include "combineOverRanks.H"
#include "fvcFlux.H"
#include "fvcSurfaceIntegrate.H"
#include "surfaceInterpolate.H"


Foam::volVectorField Foam::dropletTerm::translation
(
    const volVectorField& U
) const
{
    const grainSystem& system = droplets_.system();
    const scalarField& V = system.mesh().V();
    scalarField volume(nDroplets(), Zero);
    vectorField mean(nDroplets(), Zero);
    forAll(V, celli)
    {
        const label i = dropletOf(celli);
        if (i >= 0)
        {
            const vector arm
            (
                system.shortest(system.mesh().C()[celli] - system.centres()[i])
            );
            volume[i] += V[celli];
            mean[i] += V[celli]*(U[celli] - (system.motion().motion(i).spin ^ arm));
        }
    }
    sumOverRanks(volume);
    sumOverRanks(mean);
    mean /= max(volume, VSMALL);

    volVectorField result("translation", 0*U);
    forAll(result, celli)
    {
        const label i = dropletOf(celli);
        result[celli] = i < 0 ? vector(Zero) : mean[i];
    }
    result.correctBoundaryConditions();
    return result;
}


Foam::volVectorField Foam::dropletTerm::outward() const
{
    volVectorField result
    (
        "outward", locked()*dimensionedVector("zero", dimless, Zero)
    );
    forAll(result, celli)
    {
        const label i = dropletOf(celli);
        if (i >= 0)
        {
            result[celli] = normal(celli, i);
        }
    }
    result.correctBoundaryConditions();
    return result;
}


Foam::tmp<Foam::surfaceScalarField> Foam::dropletTerm::partOfSurface
(
    const exchangeFields& grains
) const
{
    if (!isActive() || cut_)
    {
        return tmp<surfaceScalarField>();
    }
    // Where grains cover all of the fluid's cell the pressure needs a hold
    constexpr scalar least = 1e-6;

    const volScalarField open("open", 1 - locked());
    const surfaceScalarField gasPart(fvc::interpolate(open));
    const surfaceScalarField beside(lockedFaces()*pos(gasPart - SMALL));
    return
        (1 - beside)
      + beside*max
        (
            fvc::interpolate(open*(1 - grains.passing))
           /max(gasPart, scalar(SMALL)),
            least
        );
}


void Foam::dropletTerm::addVolumeSource
(
    const exchangeFields& grains,
    const volVectorField& U,
    volScalarField& source
) const
{
    if (cut_)
    {
        addVolumeSourceInParts(grains, source);
        return;
    }
    const scalarField& V = U.mesh().V();
    const volScalarField open("open", 1 - locked());
    const surfaceScalarField gasPart(fvc::interpolate(open));
    const surfaceScalarField beside
    (
        lockedFaces()*pos(gasPart*(1 - gasPart) - SMALL)
    );
    const surfaceScalarField perGas(beside/max(gasPart, scalar(SMALL)));
    const surfaceScalarField perLocked(beside/max(1 - gasPart, scalar(SMALL)));
    const surfaceScalarField part(partOfSurface(grains));

    // What goes out of the cells besides that part of the surface's flux: of the
    // fluid grains that pass, and of the droplet the rest of its own motion
    const volScalarField outOfFluid
    (
        fvc::surfaceIntegrate(perGas*fvc::flux(open*grains.passingG))
    );
    const volScalarField outOfDroplet
    (
        fvc::surfaceIntegrate
        (
            (1 - part)*perLocked*fvc::flux(translation(U))
        )
    );

    // The droplet swells by what comes in
    const surfaceScalarField area
    (
        "area", part*mag(perLocked*fvc::flux(outward()))
    );
    const scalarField areaOfCell(fvc::surfaceSum(area)().primitiveField());

    scalarField taken(nDroplets(), Zero), surface(nDroplets(), Zero);
    forAll(V, celli)
    {
        const label i = dropletOf(celli);
        if (i >= 0)
        {
            taken[i] += V[celli]*(outOfDroplet[celli] - outOfFluid[celli]);
            surface[i] += areaOfCell[celli];
        }
    }
    sumOverRanks(taken);
    sumOverRanks(surface);

    volScalarField speed("speed", 0*mag(U));
    forAll(speed, celli)
    {
        const label i = dropletOf(celli);
        speed[celli] = i < 0 ? 0 : taken[i]/max(surface[i], VSMALL);
    }
    speed.correctBoundaryConditions();
    const scalarField swelling
    (
        fvc::surfaceSum(perLocked*fvc::interpolate(locked()*speed)*area)()
       .primitiveField()
    );
    forAll(source, celli)
    {
        source[celli] +=
            open[celli]*(swelling[celli]/V[celli] - outOfFluid[celli])
          - locked()[celli]*outOfDroplet[celli];
    }
}


void Foam::dropletTerm::addVolumeSourceInParts
(
    const exchangeFields& grains,
    volScalarField& source
) const
{
    const List<cutCells::wall>& walls = cut_->cells().walls();
    const scalarField& V = source.mesh().V();

    // Grains that come in per time [m^3/s], and what makes room for them
    scalarField taken(nDroplets(), Zero), surface(nDroplets(), Zero);
    for (const cutCells::wall& x : walls)
    {
        const scalar passes =
            x.area
          & (
                grains.solidFlux[x.cell]
              - grains.solid[x.cell]*cut_->motionOf(x.grain).velocity
            );
        source[x.cell] -= passes/V[x.cell];
        taken[x.grain] += passes;
        surface[x.grain] += mag(x.area)*(1 - grains.solid[x.cell]);
    }
    sumOverRanks(taken);
    sumOverRanks(surface);

    // The droplet swells by them
    for (const cutCells::wall& x : walls)
    {
        source[x.cell] +=
            mag(x.area)*(1 - grains.solid[x.cell])/V[x.cell]
           *taken[x.grain]/max(surface[x.grain], VSMALL);
    }
}
