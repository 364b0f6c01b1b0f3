/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletFaces.H"

#include "combineOverRanks.H"
#include "surfaceInterpolate.H"

namespace
{

using namespace Foam;

//- Change the areas such that each surface is closed: the sum of A n is zero
void closeSurfaces(const label nDroplets, DynamicList<dropletFace>& faces)
{
    vectorField open(nDroplets, Zero);
    symmTensorField second(open.size(), Zero);
    scalarField area(open.size(), Zero);
    for (const dropletFace& f : faces)
    {
        open[f.droplet] += f.area*f.normal;
        second[f.droplet] += f.area*sqr(f.normal);
        area[f.droplet] += f.area;
    }
    sumOverRanks(open);
    sumOverRanks(second);
    sumOverRanks(area);

    // Of a droplet of few faces, or across a mesh one cell thick, it has no inverse
    constexpr scalar least = 1e-3;
    vectorField tilt(open.size(), Zero);
    forAll(tilt, i)
    {
        if (area[i] > 0)
        {
            symmTensor whole(second[i]/area[i]);
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                symmTensor& w = whole;
                scalar& diagonal = d == 0 ? w.xx() : d == 1 ? w.yy() : w.zz();
                diagonal = max(diagonal, least);
            }
            tilt[i] = -inv(whole) & (open[i]/area[i]);
        }
    }
    for (dropletFace& f : faces)
    {
        f.area *= max(1 + (tilt[f.droplet] & f.normal), scalar(0.5));
    }
}


//- Droplet of each cell, -1 for gas
volScalarField dropletOfCells(const dropletTerm& term, const fvMesh& mesh)
{
    volScalarField result
    (
        IOobject("dropletOfCell", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("none", dimless, -1)
    );
    forAll(result, celli)
    {
        result[celli] = term.dropletOf(celli);
    }
    result.correctBoundaryConditions();
    return result;
}


//- Flow through a face of area S of a gradient along n, over what it is with the whole
//  difference of the cells, d apart, along the normal of the face; 1 where S is along d
scalar alongNormal(const vector& n, const vector& S, const vector& d)
{
    constexpr scalar least = 0.1;
    const vector across(S/mag(S)), between(d/mag(d));
    return
        max(mag(across & n), least)*mag(between & across)
       /max(mag(between & n), least);
}

}


Foam::List<Foam::dropletFace> Foam::dropletFace::list
(
    const dropletTerm& term,
    const surfaceScalarField& conductivity
)
{
    const fvMesh& mesh = conductivity.mesh();
    const volScalarField dropletOf(dropletOfCells(term, mesh));

    const surfaceScalarField conductance
    (
        term.conductance()*mesh.magSf()*mesh.nonOrthDeltaCoeffs()
    );
    const surfaceVectorField delta(mesh.delta());

    DynamicList<dropletFace> result;
    const auto add = [&]
    (
        const label cell,
        const label droplet,
        const vector& S,
        const vector& d,
        const scalar conductanceOfFace,
        const scalar conductivityOfFace
    )
    {
        const vector n(term.normal(cell, droplet));
        const scalar area = max(mag(S & n), 0.1*mag(S));
        result.append
        ({
            cell, droplet, n, area, conductanceOfFace*alongNormal(n, S, d), conductivityOfFace
        });
    };
    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        if ((dropletOf[P] < 0) != (dropletOf[N] < 0))
        {
            const bool isOwner = dropletOf[P] < 0;
            add
            (
                isOwner ? P : N, label(dropletOf[isOwner ? N : P]), mesh.Sf()[facei],
                delta[facei], conductance[facei], conductivity[facei]
            );
        }
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatchScalarField& d = dropletOf.boundaryField()[patchi];
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
                add
                (
                    d.patch().faceCells()[i], label(neighbour[i]), d.patch().Sf()[i],
                    delta.boundaryField()[patchi][i],
                    conductance.boundaryField()[patchi][i],
                    conductivity.boundaryField()[patchi][i]
                );
            }
        }
    }
    closeSurfaces(term.nDroplets(), result);
    return List<dropletFace>(std::move(result));
}


void Foam::dropletFace::shut
(
    const dropletTerm& term,
    surfaceScalarField& conductivity
)
{
    const surfaceScalarField gas
    (
        fvc::interpolate(pos(-0.5 - dropletOfCells(term, conductivity.mesh())))
    );
    conductivity *= 1 - pos(gas - SMALL)*pos(1 - SMALL - gas);
}


Foam::List<Foam::dropletFace> Foam::dropletFace::list
(
    const cutConduction& cut,
    const scalarField& conductivity
)
{
    DynamicList<dropletFace> result;
    for (const cutCells::wall& x : cut.cells().walls())
    {
        const scalar area = mag(x.area);
        if (cut.cells().fluid()[x.cell] > 0 && area > 0)
        {
            result.append
            ({
                x.cell, x.grain, -x.area/area, area, cut.perConductivity(x),
                conductivity[x.cell]
            });
        }
    }
    return List<dropletFace>(std::move(result));
}
