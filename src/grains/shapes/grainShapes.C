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
        dictionaryInput::getWord(shape, "type", {"cluster"});
        dictionaryInput::checkKeywords(shape, {"type", "centres", "radii"});

        nscd::Vectors<D> centres;
        const pointField points
        (
            dictionaryInput::getAs<pointField>
            (
                shape, "centres", "a list of points, as ((0 0 0) (1 0 0))"
            )
        );
        for (const point& x : points)
        {
            centres.push_back(space.fromSpace(x));
            if (!space.holds(x - points[0]))
            {
                dictionaryInput::badValue
                (
                    shape, "centres", dictionaryInput::written(shape, "centres"),
                    "points in one plane along that of the mesh"
                );
            }
        }
        const scalarList radii
        (
            dictionaryInput::getAs<scalarList>
            (
                shape, "radii", "a list of numbers > 0, as (1 1)"
            )
        );
        try
        {
            const nscd::PlacedCluster<D> placed
            (
                nscd::placedCluster<D>
                (
                    centres, std::vector<double>(radii.begin(), radii.end())
                )
            );
            clusters_.push_back(placed.shape);
            axes_.push_back(placed.orientation);
        }
        catch (const std::exception& err)
        {
            dictionaryInput::badValue
            (
                shape, "centres", dictionaryInput::written(shape, "centres"),
                "as many radii > 0 as there are centres; " + string(err.what())
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
    return find
    (
        dictionaryInput::getWordOrDefault
        (
            dict, "shape", grainSpace<D>::shape, names()
        )
    );
}


template class Foam::grainShapes<2>;
template class Foam::grainShapes<3>;
