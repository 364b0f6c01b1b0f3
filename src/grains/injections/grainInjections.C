/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainInjections.H"

#include "dictionaryInput.H"
#include "heatDimensions.H"
#include "IFstream.H"
#include "OSspecific.H"

template<int D>
Foam::grainInjections<D>::grainInjections
(
    const grainProperties<D>& properties
)
:
    properties_(properties),
    progress_(properties.space().mesh().time()),
    walls_(properties.walls().walls(), properties.contact().period),
    nextId_(0)
{
    if (properties.dict().found("injections"))
    {
        const dictionary& dict =
            dictionaryInput::subDict(properties.dict(), "injections");

        names_ = dict.toc();
        for (const word& name : names_)
        {
            injections_.append
            (
                grainInjection<D>::New
                (
                    dictionaryInput::subDict(dict, name), properties
                )
            );
        }
        files_.resize(names_.size());
    }
}


template<int D>
Foam::labelList Foam::grainInjections<D>::openings() const
{
    labelList result;
    for (const grainInjection<D>& injection : injections_)
    {
        result.append(injection.openings());
    }
    return result;
}


template<int D>
void Foam::grainInjections<D>::check
(
    const bool conducts,
    const std::set<label>& materials
) const
{
    std::set<label> others(materials);
    for (const grainInjection<D>& injection : injections_)
    {
        others.insert(injection.material());
    }
    for (const auto& wall : properties_.walls().walls())
    {
        others.insert(nscd::materialOf(wall));
    }
    forAll(injections_, i)
    {
        for (const label other : others)
        {
            properties_.materials().checkPair(injections_[i].material(), other);
        }
        if (!conducts)
        {
            continue;
        }
        const word& material =
            properties_.materials().names()[injections_[i].material()];
        dictionaryInput::getPositive
        (
            properties_.dict().subDict("materials").subDict(material),
            "heatCapacity", dimHeatCapacity
        );
        if (injections_[i].temperature() <= 0)
        {
            dictionaryInput::badValue
            (
                properties_.dict().subDict("injections").subDict(names_[i]),
                "temperature", "none", "a temperature [K], as there is 'heat'"
            );
        }
    }
}


template<int D>
void Foam::grainInjections<D>::startAfter(const nscd::Grains<D>& grains)
{
    for (const auto id : grains.id)
    {
        nextId_ = max(nextId_, label(id) + 1);
    }
}


template<int D>
nscd::Grains<D> Foam::grainInjections<D>::due
(
    const scalar now,
    const nscd::ContactDynamics<D>& dynamics,
    const bool withFluid,
    const typename grainInjection<D>::lookup& at
)
{
    if (dynamics.wallBodies().size())
    {
        walls_.place(properties_.walls().bodies(), dynamics.wallBodies());
    }
    nscd::Grains<D> more;
    forAll(injections_, i)
    {
        const grainTally injected
        (
            injections_[i].inject
            (
                now, dynamics.grains(), walls_, withFluid, at, more
            )
        );
        write(i, now, injected);
    }
    for (auto& id : more.id)
    {
        id = nextId_++;
    }
    return more;
}


template<int D>
void Foam::grainInjections<D>::write
(
    const label i,
    const scalar now,
    const grainTally& injected
)
{
    if (!Pstream::master())
    {
        return;
    }
    if (!files_.set(i))
    {
        files_.set
        (
            i,
            progress_.newFile
            (
                "injection", names_[i] + ".dat",
                "# time injected injectedMass total owed"
            )
        );
    }
    files_[i]
        << now << ' ' << injected.number << ' ' << injected.mass << ' '
        << injections_[i].number() << ' ' << injections_[i].owed() << endl;
}


template<int D>
void Foam::grainInjections<D>::save(const fileName& file) const
{
    if (empty() || !Pstream::master())
    {
        return;
    }
    OFstream os(file);
    os.precision(17);
    os  << "FoamFile { version 2.0; format ascii; class dictionary; object "
        << file.name() << "; }" << nl;
    os.writeEntry("nextGrain", nextId_);
    forAll(injections_, i)
    {
        injections_[i].state().writeEntry(names_[i], os);
    }
}


template<int D>
void Foam::grainInjections<D>::load(const fileName& file)
{
    if (!isFile(file, false))
    {
        if (!empty())
        {
            Info<< "There is no " << file << ": injections count from zero" << nl << endl;
        }
        return;
    }
    const dictionary state((IFstream(file)()));
    nextId_ = max(nextId_, state.get<label>("nextGrain"));
    forAll(injections_, i)
    {
        if (state.found(names_[i]))
        {
            injections_[i].setState(state.subDict(names_[i]));
        }
    }
}


template class Foam::grainInjections<2>;
template class Foam::grainInjections<3>;
