/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedGrains.H"

#include "combineOverRanks.H"
#include "fvcFlux.H"

template<class Function>
void Foam::resolvedGrains::forGrainFaces(const Function& f) const
{
    forLinks
    (
        [&]
        (
            const side& own,
            const side& nei,
            const label patchi,
            const label facei
        )
        {
            if (!own.isLocked() || !nei.isLocked() || own.grain == nei.grain)
            {
                f(own, nei, label(max(own.grain, nei.grain)), patchi, facei);
            }
        }
    );
}


template<class Type>
Foam::Field<Type> Foam::resolvedGrains::meanOfCells
(
    const Field<Type>& values,
    const scalarField& weight
) const
{
    const scalarField& V = mesh_.V();
    scalarField volume(grains_.size(), Zero);
    Field<Type> sum(grains_.size(), Zero);
    forAll(V, celli)
    {
        const label graini = grain(celli);
        if (graini >= 0)
        {
            volume[graini] += weight[celli]*V[celli];
            sum[graini] += weight[celli]*V[celli]*values[celli];
        }
    }
    sumOverRanks(volume);
    sumOverRanks(sum);

    return sum/max(volume, VSMALL);
}

template Foam::scalarField Foam::resolvedGrains::meanOfCells
(
    const scalarField&,
    const scalarField&
) const;

template Foam::vectorField Foam::resolvedGrains::meanOfCells
(
    const vectorField&,
    const scalarField&
) const;


void Foam::resolvedGrains::makeRigid
(
    const volVectorField& freeU,
    const scalarField& inertia,
    volVectorField& U
) const
{
    const vectorField change
    (
        meanOfCells<vector>(U.primitiveField() - freeU.primitiveField(), inertia)
    );
    forAll(U, celli)
    {
        const label graini = grain(celli);
        if (graini >= 0)
        {
            U[celli] = freeU[celli] + change[graini];
        }
    }
    U.correctBoundaryConditions();
}


void Foam::resolvedGrains::setBodyFlux
(
    const volVectorField& U,
    surfaceScalarField& flux
) const
{
    if (!isActive_)
    {
        return;
    }
    const vectorField translation(meanOfCells(U, scalarField(mesh_.nCells(), 1)));
    forGrainFaces
    (
        [&]
        (
            const side& own,
            const side& nei,
            const label graini,
            const label patchi,
            const label facei
        )
        {
            const point& centre = grains_.centres()[graini];
            const scalar inOwn = 0.5*(own.isLocked() + !nei.isLocked());
            vector arm(Zero);
            if (inOwn > 0)
            {
                arm += inOwn*between(centre, own.x);
            }
            if (inOwn < 1)
            {
                arm += (1 - inOwn)*between(centre, nei.x);
            }
            resolvedFace::at(flux, patchi, facei) =
                resolvedFace::at(mesh_.Sf(), patchi, facei)
              & (
                    translation[graini]
                  + (grains_.motion().spin(graini) ^ arm)
                );
        }
    );
}


Foam::tmp<Foam::surfaceScalarField> Foam::resolvedGrains::bodyFlux
(
    const volVectorField& U
) const
{
    tmp<surfaceScalarField> tresult(new surfaceScalarField(0*fvc::flux(U)));
    setBodyFlux(U, tresult.ref());
    return tresult;
}


Foam::tmp<Foam::surfaceScalarField> Foam::resolvedGrains::withoutForce
(
    const surfaceScalarField& force,
    const surfaceScalarField& inertia
) const
{
    tmp<surfaceScalarField> tresult(new surfaceScalarField(0*force));
    surfaceScalarField& result = tresult.ref();

    vectorField sum(grains_.size(), Zero);
    tensorField mass(grains_.size(), Zero);
    forGrainFaces
    (
        [&]
        (
            const side& own,
            const side& nei,
            const label graini,
            const label patchi,
            const label facei
        )
        {
            // One half of a coupled face is on the other side
            const vector way
            (
                (patchi < 0 ? 1 : 0.5)*inMesh(nei.x - own.x)
            );
            sum[graini] += resolvedFace::at(force, patchi, facei)*way;
            mass[graini] +=
                resolvedFace::at(inertia, patchi, facei)
               *way*resolvedFace::at(mesh_.Sf(), patchi, facei);
        }
    );
    sumOverRanks(sum);
    sumOverRanks(mass);

    // A grain at a boundary, or between others, may have no face across a
    // direction
    constexpr scalar least = 1e-9;

    vectorField velocity(grains_.size(), Zero);
    forAll(velocity, graini)
    {
        const scalar scale = tr(mass[graini]);
        if (scale > 0)
        {
            const tensor m(mass[graini] + least*scale*tensor::I);
            velocity[graini] = inv(m) & sum[graini];
        }
    }

    forGrainFaces
    (
        [&]
        (
            const side&,
            const side&,
            const label graini,
            const label patchi,
            const label facei
        )
        {
            resolvedFace::at(result, patchi, facei) =
                resolvedFace::at(force, patchi, facei)
              - resolvedFace::at(inertia, patchi, facei)
               *(resolvedFace::at(mesh_.Sf(), patchi, facei) & velocity[graini]);
        }
    );
    return tresult;
}
