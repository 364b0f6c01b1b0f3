/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "poorConductors.H"

#include "HashSet.H"

#include <algorithm>

Foam::scalar Foam::poorConductors::negativePart(scalar a, scalar b, scalar c)
{
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);

    if (c <= 0)
    {
        return 1;
    }
    if (a >= 0)
    {
        return 0;
    }
    return b >= 0 ? a/(a - b)*a/(a - c) : 1 - c/(c - a)*c/(c - b);
}


Foam::scalar Foam::poorConductors::distance
(
    const label graini,
    const point& x
) const
{
    const Vector<label>& dims = grains_.mesh().geometricD();
    scalar least = GREAT;
    for (const grainMember& body : grains_.members(graini))
    {
        vector r(grains_.shortest(x - body.centre));
        for (direction i = 0; i < vector::nComponents; ++i)
        {
            r[i] *= dims[i] > 0;
        }
        least = min(least, mag(r) - body.radius);
    }
    return least;
}


Foam::scalar Foam::poorConductors::partInside
(
    const label graini,
    const label facei
) const
{
    const face& f = grains_.mesh().faces()[facei];
    const pointField& x = grains_.mesh().points();
    const point& middle = grains_.mesh().faceCentres()[facei];
    const scalar inMiddle = distance(graini, middle);

    scalar inside = 0, whole = VSMALL;
    forAll(f, i)
    {
        const point& one = x[f[i]];
        const point& other = x[f.nextLabel(i)];
        const scalar area = mag((one - middle) ^ (other - middle));
        whole += area;
        inside +=
            area
           *negativePart
            (
                inMiddle, distance(graini, one), distance(graini, other)
            );
    }
    return inside/whole;
}


void Foam::poorConductors::add(const label graini)
{
    const fvMesh& mesh = grains_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const scalar k = grains_.temperatures().conductivity(graini);

    labelHashSet seen;
    for (const cellOverlap& o : grains_.overlaps().of(graini))
    {
        for (const label facei : mesh.cells()[o.cell])
        {
            if (!seen.insert(facei))
            {
                continue;
            }
            if (mesh.isInternalFace(facei))
            {
                const scalar part = partInside(graini, facei);
                part_[facei] += part;
                conductance_[facei] += part*k;
                continue;
            }
            const label patchi = patches.whichPatch(facei);
            if (patches[patchi].coupled())
            {
                const label i = facei - patches[patchi].start();
                const scalar part = partInside(graini, facei);
                part_.boundaryFieldRef()[patchi][i] += part;
                conductance_.boundaryFieldRef()[patchi][i] += part*k;
            }
        }
    }
}


Foam::poorConductors::poorConductors
(
    const grainSystem& grains,
    const resolvedTerm& resolved,
    const surfaceScalarField& kappa
)
:
    grains_(grains),
    resolved_(resolved),
    part_
    (
        IOobject("partInside", grains.mesh().time().timeName(), grains.mesh()),
        grains.mesh(),
        dimensionedScalar(dimless, Zero)
    ),
    conductance_("conductanceInside", part_*dimensionedScalar(kappa.dimensions(), Zero))
{
    const scalar ofFluid = gMax(kappa);
    for (label i = 0; i < grains.size(); ++i)
    {
        if
        (
            resolved_.isResolved(i)
         && grains_.temperatures().conductivity(i) < ofFluid
        )
        {
            add(i);
        }
    }
}


void Foam::poorConductors::set
(
    const surfaceScalarField& kappa,
    surfaceScalarField& faces
) const
{
    const auto set = []
    (
        const scalarField& part,
        const scalarField& conductance,
        const scalarField& k,
        scalarField& faces
    )
    {
        forAll(faces, i)
        {
            // Grains may overlap by what contacts leave
            const scalar excess = max(part[i], scalar(1));
            if (part[i] > 0 && conductance[i] < part[i]*k[i])
            {
                faces[i] =
                    conductance[i]/excess + (1 - part[i]/excess)*k[i];
            }
        }
    };
    set
    (
        part_.primitiveField(),
        conductance_.primitiveField(),
        kappa.primitiveField(),
        faces.primitiveFieldRef()
    );
    forAll(faces.boundaryField(), patchi)
    {
        if (faces.boundaryField()[patchi].coupled())
        {
            set
            (
                part_.boundaryField()[patchi],
                conductance_.boundaryField()[patchi],
                kappa.boundaryField()[patchi],
                faces.boundaryFieldRef()[patchi]
            );
        }
    }
}
