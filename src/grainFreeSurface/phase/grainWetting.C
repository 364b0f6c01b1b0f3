/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainWetting.H"

#include "dictionaryInput.H"
#include "unitConversion.H"

namespace
{

using namespace Foam;

//- Of a material [rad], negative for none
scalar contactAngle(const dictionary& material)
{
    constexpr scalar none = -1;

    const word keyword("contactAngle");
    if
    (
        !material.found(keyword)
     || dictionaryInput::written(material, keyword) == "none"
    )
    {
        return none;
    }
    return degToRad
    (
        dictionaryInput::getScalar(material, keyword, dimless, 0, 180)
    );
}

}


Foam::grainWetting::grainWetting(const grainSystem& grains)
:
    grains_(grains),
    isAny_(false)
{
    const dictionary& materials =
        grains.motion().coupling().parent().subDict("materials");
    const wordList names(materials.toc());
    angles_.resize(names.size());
    forAll(names, i)
    {
        angles_[i] = contactAngle(materials.subDict(names[i]));
        isAny_ = isAny_ || angles_[i] >= 0;
    }
}


Foam::grainWetting::place Foam::grainWetting::placeIn
(
    const label graini,
    const point& x
) const
{
    const Vector<label>& directions = grains_.mesh().geometricD();

    place result{Zero, -GREAT, 0, 0};
    for (const grainMember& body : grains_.members(graini))
    {
        vector r(grains_.shortest(x - body.centre));
        for (direction i = 0; i < vector::nComponents; ++i)
        {
            if (directions[i] < 0)
            {
                r[i] = 0;
            }
        }
        const scalar depth = body.radius - mag(r);
        if (depth > result.depth)
        {
            result =
            {
                r/max(mag(r), VSMALL), depth, mag(r)/body.radius, body.radius
            };
        }
    }
    return result;
}


void Foam::grainWetting::set
(
    const scalarField& curvature,
    volVectorField& normal,
    scalarField& sine
) const
{
    // Deeper there is no line that leaves with the angle
    constexpr scalar most = 0.99;

    const pointField& centres = grains_.mesh().cellCentres();
    const overlapList& overlaps = grains_.overlaps();

    normal == dimensionedVector(dimless, Zero);
    scalarField depth(centres.size(), -GREAT);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        const scalar own = angles_[grains_.motion().material(graini)];
        for (const cellOverlap& o : overlaps.of(graini))
        {
            const place at(placeIn(graini, centres[o.cell]));
            if (at.depth > depth[o.cell])
            {
                depth[o.cell] = at.depth;
                normal[o.cell] = own < 0 ? vector(Zero) : at.outwards;
                const scalar r = max(at.radius, SMALL);
                const scalar bend = curvature[o.cell]*at.size;
                sine[o.cell] = max
                (
                    min((cos(own) - 0.5*bend*(1 - sqr(r)))/r, most), -most
                );
            }
        }
    }
    normal.correctBoundaryConditions();
}
