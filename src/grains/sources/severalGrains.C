/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "severalGrains.H"

#include "dictionaryInput.H"
#include "nscd/shape/Append.hpp"
#include "occupiedSpace.H"

#include <numeric>

addToSelection(grainSource, grainSources, several)


template<int D>
Foam::grainSources::several<D>::several
(
    const dictionary& dict,
    const typename grainSource<D>::context& ctx
)
:
    grainSource<D>(dict, ctx),
    dict_(dict)
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
}


template<int D>
nscd::Grains<D> Foam::grainSources::several<D>::read() const
{
    const dictionary& sources = dict_.subDict("sources");
    nscd::Grains<D> all;
    bool isFirst = true;
    for (const word& name : sources.toc())
    {
        const occupiedSpace<D> occupied(all, this->context_.contact.period);
        typename grainSource<D>::context ctx(this->context_);
        ctx.isFree = [&](const nscd::Vector<D>& x, const scalar radius)
        {
            return occupied.isFree(x, radius);
        };
        nscd::Grains<D> more
        (
            grainSource<D>::New
            (
                dictionaryInput::subDict(sources, name), ctx
            )->read()
        );
        if (isFirst)
        {
            all = std::move(more);
            isFirst = false;
        }
        else
        {
            nscd::append(all, more);
        }
    }
    std::iota(all.id.begin(), all.id.end(), 0);
    return all;
}
