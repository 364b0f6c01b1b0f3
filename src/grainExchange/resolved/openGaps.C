/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedGrains.H"

#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPolyPatch.H"

namespace
{

//- Is there no fluid beyond a patch?
bool isClosed(const Foam::polyPatch& patch)
{
    using namespace Foam;
    return
        isA<wallPolyPatch>(patch)
     || isA<symmetryPolyPatch>(patch)
     || isA<symmetryPlanePolyPatch>(patch);
}


//- Does the fluid between two bodies give way to them?  They have the reduced
//  radius r, and the reduced mass of a sphere of that radius and a density.
bool givesWay
(
    const Foam::scalar density,
    const Foam::scalar r,
    const Foam::scalar speed,
    const Foam::scalar mu
)
{
    // Below, nothing bounces off a wall (Gondret, Lance and Petit, Phys. Fluids
    // 14, 643, 2002, doi:10.1063/1.1427920)
    constexpr Foam::scalar least = 10;

    return 2*density*r*speed > 9*least*mu;
}

}


Foam::scalar Foam::resolvedGrains::speedAlong
(
    const label graini,
    const point& x,
    const vector& n
) const
{
    const vector arm(between(grains_.centres()[graini], x));
    return grains_.motion().motion(graini).at(arm) & n;
}


bool Foam::resolvedGrains::isOpen
(
    const label celli,
    const label otheri
) const
{
    const label graini = grain(celli);
    const point& x = mesh_.C()[celli];

    const grainMember a(deepestMember(graini, x));
    const grainMember b(deepestMember(otheri, x));
    const vector n(normalised(between(a.centre, b.centre)));

    const scalar r = a.radius*b.radius/(a.radius + b.radius);
    const scalar ma = grains_.motion().density(graini)*pow3(a.radius);
    const scalar mb = grains_.motion().density(otheri)*pow3(b.radius);

    return givesWay
    (
        1/(pow3(r)*(1/ma + 1/mb)),
        r,
        mag(speedAlong(graini, x, n) - speedAlong(otheri, x, n)),
        fluid_.mu()[celli]
    );
}


bool Foam::resolvedGrains::isOpenAtWall
(
    const label celli,
    const vector& n,
    const scalar wallSpeed
) const
{
    const label graini = grain(celli);
    const point& x = mesh_.C()[celli];

    return givesWay
    (
        grains_.motion().density(graini),
        deepestMember(graini, x).radius,
        mag(speedAlong(graini, x, n) - wallSpeed),
        fluid_.mu()[celli]
    );
}


void Foam::resolvedGrains::openGaps()
{
    if (grains_.motion().isFixed())
    {
        return;
    }
    boolList open(mesh_.nCells(), false);

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
            if
            (
                !own.isLocked() || !nei.isLocked() || own.grain == nei.grain
            )
            {
                return;
            }
            if (patchi < 0)
            {
                const label owner = mesh_.owner()[facei];
                const label neighbour = mesh_.neighbour()[facei];
                open[owner] = open[owner] || isOpen(owner, label(nei.grain));
                open[neighbour] =
                    open[neighbour] || isOpen(neighbour, label(own.grain));
            }
            else
            {
                const label celli = mesh_.boundary()[patchi].faceCells()[facei];
                open[celli] = open[celli] || isOpen(celli, label(nei.grain));
            }
        }
    );

    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!isClosed(patch.patch()))
        {
            continue;
        }
        const vectorField n(patch.nf());
        scalarField speed(patch.size(), Zero);
        if (mesh_.moving())
        {
            speed = mesh_.phi().boundaryField()[patchi]/patch.magSf();
        }
        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            open[celli] =
                open[celli]
             || (grain(celli) >= 0 && isOpenAtWall(celli, n[i], speed[i]));
        }
    }

    forAll(open, celli)
    {
        if (open[celli])
        {
            grain_[celli] = -1;
            locked_[celli] = 0;
        }
    }
    grain_.correctBoundaryConditions();
    locked_.correctBoundaryConditions();
}
