/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchesInjection.H"

#include "dictionaryInput.H"
#include "wallPieces.H"

addToSelection(grainInjection, grainInjectionTypes, patches)

template<int D>
Foam::grainInjectionTypes::patches<D>::patches
(
    const dictionary& dict,
    const grainProperties<D>& properties
)
:
    grainInjection<D>(dict, properties),
    patches_(wallPieces::selectedPatches(dict, properties.space().mesh())),
    area_(properties.space(), patches_),
    normal_(properties.space().fromSpace(area_.normal()))
{
    this->checkKeywords(dict, {"patches"});
    checkArea(dict);
    wallPieces::checkNoWalls
    (
        dict, patches_, properties.dict(), properties.space().mesh()
    );

    if (!this->hasVelocity() || this->velocity().dot(normal_) <= 0)
    {
        OStringStream value, allowed;
        value << properties.space().toSpace(this->velocity());
        allowed << "a velocity into the mesh, along " << area_.normal();
        dictionaryInput::badValue
        (
            dict, "velocity",
            this->hasVelocity() ? value.str() : string("none"), allowed.str()
        );
    }
}


template<int D>
void Foam::grainInjectionTypes::patches<D>::checkArea
(
    const dictionary& dict
) const
{
    if (!area_.isPlane())
    {
        dictionaryInput::badValue
        (
            dict, "patches", "with faces of several directions",
            "patches whose faces are in one plane"
        );
    }
    const scalar halfWidth = area_.halfWidth();
    if (this->largest() > halfWidth)
    {
        dictionaryInput::badValue
        (
            dict, "patches",
            "that let grains of a radius up to " + Foam::name(halfWidth)
          + " m pass",
            "patches wide enough for the largest grain, of radius "
          + Foam::name(this->largest()) + " m"
        );
    }
}


template<int D>
nscd::Box<D> Foam::grainInjectionTypes::patches<D>::region() const
{
    nscd::Box<D> box(area_.box());
    box.lower.array() -= this->largest();
    box.upper.array() += this->largest();
    return box;
}


template<int D>
bool Foam::grainInjectionTypes::patches<D>::draw
(
    nscd::Random& random,
    const scalar radius,
    const bool withFluid,
    nscd::Vector<D>& x
) const
{
    // Overlaps must not be lost in round-off, nor take place from the fluid
    constexpr scalar inside = 0.01;

    x = area_.randomPoint(random);
    if (area_.distanceFromRim(x) < radius*(1 + 1e-9))
    {
        return false;
    }
    x += (withFluid ? inside - 1 : 1)*radius*normal_;
    return true;
}
