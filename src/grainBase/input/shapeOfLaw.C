/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shapeOfLaw.H"

#include "dictionaryInput.H"

Foam::word Foam::dictionaryInput::shapeOfLaw
(
    const dictionary& dict,
    const word& ofGrains,
    const wordList& ofLaw
)
{
    const word shape
    (
        getWordOrDefault(dict, "shape", ofGrains, {"disc", "sphere"})
    );
    if (shape == "disc" && ofGrains == "sphere")
    {
        badValue
        (
            dict, "shape", "disc", "sphere, as this mesh is three-dimensional"
        );
    }
    if (!ofLaw.found(shape))
    {
        string allowed("a law of " + shape + "s; this one is of " + ofLaw[0] + 's');
        if (shape == ofGrains && ofGrains == "disc")
        {
            allowed += ": 'shape sphere;' beside it takes the grains for those";
        }
        badValue(dict, "type", written(dict, "type"), allowed);
    }
    return shape;
}
