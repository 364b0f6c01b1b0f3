/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainShapes.H"

#include "dictionaryInput.H"
#include "pointField.H"

template<int D>
Foam::grainShapes<D>::grainShapes
(
    const dictionary& dict,
    const grainSpace<D>& space
)
{
    if (!dict.found("shapes"))
    {
        return;
    }
    const dictionary& shapes = dictionaryInput::subDict(dict, "shapes");

    for (const word& name : shapes.toc())
    {
        const dictionary& shape = dictionaryInput::subDict(shapes, name);
        const word type(shape.get<word>("type"));
        if (type != "cluster")
        {
            dictionaryInput::badValue(shape, "type", type, "cluster");
        }
        dictionaryInput::checkKeywords(shape, {"type", "centres", "radii"});

        nscd::Vectors<D> centres;
        for (const point& x : shape.get<pointField>("centres"))
        {
            centres.push_back(space.fromSpace(x));
        }
        const scalarList radii(shape.get<scalarList>("radii"));
        try
        {
            clusters_.push_back
            (
                nscd::makeCluster<D>
                (
                    centres, std::vector<double>(radii.begin(), radii.end())
                )
            );
        }
        catch (const std::exception& err)
        {
            dictionaryInput::badValue
            (
                shape, "centres", "and 'radii' " + string(err.what()),
                "as many radii > 0 as there are centres"
            );
        }
        names_.append(name);
    }
}


template<int D>
Foam::wordList Foam::grainShapes<D>::names() const
{
    wordList all(names_);
    all.append(word(grainSpace<D>::shape));
    return all;
}


template<int D>
Foam::label Foam::grainShapes<D>::find(const word& name) const
{
    const label i = names_.find(name);
    return i >= 0 ? i : name == grainSpace<D>::shape ? -1 : -2;
}


template<int D>
Foam::label Foam::grainShapes<D>::index(const dictionary& dict) const
{
    const word name(dict.getOrDefault<word>("shape", grainSpace<D>::shape));
    const label i = find(name);
    if (i < -1)
    {
        dictionaryInput::badValue
        (
            dict, "shape", name, dictionaryInput::listed(names())
        );
    }
    return i;
}


template class Foam::grainShapes<2>;
template class Foam::grainShapes<3>;
