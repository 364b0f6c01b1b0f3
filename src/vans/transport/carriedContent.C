/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carriedContent.H"

namespace
{

using namespace Foam;

template<class Function>
scalarField ofEach(const scalarField& x, const Function& f)
{
    scalarField result(x.size());
    forAll(x, i)
    {
        result[i] = f(x[i]);
    }
    return result;
}

}


Foam::scalarField Foam::carriedContent::of(const scalarField& T) const
{
    return ofEach(T, [&](const scalar x) { return of(x); });
}


Foam::scalarField Foam::carriedContent::slope(const scalarField& T) const
{
    return ofEach(T, [&](const scalar x) { return slope(x); });
}


Foam::scalarField Foam::carriedContent::value(const scalarField& H) const
{
    return ofEach(H, [&](const scalar x) { return value(x); });
}


void Foam::carriedContent::transport
(
    fvScalarMatrix& matrix,
    const surfaceScalarField& flux,
    const volScalarField& T
) const
{
    const labelUList& owner = T.mesh().owner();
    const labelUList& neighbour = T.mesh().neighbour();
    const scalarField c(slope(T.primitiveField()));

    // H = rest + c T
    const scalarField rest(of(T.primitiveField()) - c*T.primitiveField());

    scalarField& lower = matrix.lower();
    scalarField& upper = matrix.upper();
    scalarField& diag = matrix.diag();
    scalarField carried(diag*rest);
    forAll(upper, facei)
    {
        const label P = owner[facei], N = neighbour[facei];
        carried[P] += upper[facei]*rest[N];
        carried[N] += lower[facei]*rest[P];
        upper[facei] *= c[N];
        lower[facei] *= c[P];
    }
    diag *= c;

    forAll(T.boundaryField(), patchi)
    {
        const fvPatchScalarField& TPatch = T.boundaryField()[patchi];
        const labelUList& cells = TPatch.patch().faceCells();
        scalarField& own = matrix.internalCoeffs()[patchi];
        scalarField& given = matrix.boundaryCoeffs()[patchi];
        if (TPatch.coupled())
        {
            const scalarField TOther(TPatch.patchNeighbourField());
            forAll(TOther, i)
            {
                const scalar cOther = slope(TOther[i]);
                carried[cells[i]] +=
                    own[i]*rest[cells[i]]
                  - given[i]*(of(TOther[i]) - cOther*TOther[i]);
                own[i] *= c[cells[i]];
                given[i] *= cOther;
            }
            continue;
        }
        forAll(TPatch, i)
        {
            const scalar cPatch = slope(TPatch[i]);
            own[i] *= cPatch;
            given[i] =
                cPatch*given[i]
              - flux.boundaryField()[patchi][i]
               *(of(TPatch[i]) - cPatch*TPatch[i]);
        }
    }
    matrix.source() -= carried;
}
