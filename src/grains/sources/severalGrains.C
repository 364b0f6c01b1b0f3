/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "severalGrains.H"

#include "dictionaryInput.H"
#include "nscd/shape/Append.hpp"

#include <numeric>

addToSelection(grainSource, grainSources, several)


template<int D>
Foam::grainSources::several<D>::several
(
    const dictionary& dict,
    const typename grainSource<D>::context& ctx
)
:
    grainSource<D>(dict, ctx)
{
    dictionaryInput::checkKeywords(dict, {"type", "sources", "output"});

    const dictionary& sources = dictionaryInput::subDict(dict, "sources");
    if (sources.empty())
    {
        dictionaryInput::badValue
        (
            dict, "sources", "{}", "at least one sub-dictionary"
        );
    }
    for (const word& name : sources.toc())
    {
        sources_.append
        (
            grainSource<D>::New(dictionaryInput::subDict(sources, name), ctx)
        );
    }
}


template<int D>
nscd::Grains<D> Foam::grainSources::several<D>::read() const
{
    nscd::Grains<D> all(sources_[0].read());
    for (label i = 1; i < sources_.size(); ++i)
    {
        nscd::append(all, sources_[i].read());
    }
    std::iota(all.id.begin(), all.id.end(), 0);
    return all;
}
