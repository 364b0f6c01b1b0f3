/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainOutlets.H"

#include "dictionaryInput.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "patchesOutlet.H"
#include "wallPieces.H"

template<int D>
Foam::grainOutlets<D>::grainOutlets
(
    const grainProperties<D>& properties,
    const labelList& inlets,
    const word& name
)
:
    progress_(properties.space().mesh().time()),
    suffix_(name == grainSet().name ? word() : "." + name)
{
    if (properties.dict().found("outlets"))
    {
        const dictionary& dict =
            dictionaryInput::subDict(properties.dict(), "outlets");

        for (const word& name : dict.toc())
        {
            const dictionary& own = dictionaryInput::subDict(dict, name);
            outlets_.append(grainOutlet<D>::New(own, properties.space()));
            wallPieces::checkNoWalls
            (
                own, outlets_.last().openings(), properties.dict(),
                properties.space().mesh()
            );
        }
    }
    if (inlets.size())
    {
        outlets_.append
        (
            autoPtr<grainOutlet<D>>
            (
                new grainOutletTypes::patches<D>(inlets, properties.space())
            )
        );
    }
}


template<int D>
void Foam::grainOutlets<D>::meshChanged()
{
    for (grainOutlet<D>& outlet : outlets_)
    {
        outlet.meshChanged();
    }
}


template<int D>
Foam::labelList Foam::grainOutlets<D>::openings() const
{
    labelList result;
    for (const grainOutlet<D>& outlet : outlets_)
    {
        result.append(outlet.openings());
    }
    return result;
}


template<int D>
std::vector<bool> Foam::grainOutlets<D>::passed
(
    const nscd::Vectors<D>& before,
    const nscd::Vectors<D>& centres,
    const boolList& outside
) const
{
    std::vector<bool> gone(centres.size(), false);
    for (const grainOutlet<D>& outlet : outlets_)
    {
        outlet.mark(before, centres, outside, gone);
    }
    return gone;
}


template<int D>
void Foam::grainOutlets<D>::count
(
    const grainTally& removed,
    const Time& runTime
)
{
    total_ += removed;
    if (outlets_.empty() || !Pstream::master())
    {
        return;
    }
    if (!file_)
    {
        file_ = progress_.newFile
        (
            "discharge" + suffix_, "discharge.dat",
            "# time removed removedMass massFlowRate total totalMass"
        );
    }
    file_()
        << runTime.value() << ' ' << removed.number << ' ' << removed.mass
        << ' ' << removed.mass/runTime.deltaTValue() << ' ' << total_.number
        << ' ' << total_.mass << endl;
}


template<int D>
void Foam::grainOutlets<D>::save(const fileName& dir) const
{
    if (isEmpty() || !Pstream::master())
    {
        return;
    }
    const fileName file(dir/"outlets" + suffix_);
    OFstream os(file);
    os.precision(17);
    os  << "FoamFile { version 2.0; format ascii; class dictionary; object "
        << file.name() << "; }" << nl;
    os.writeEntry("total", total_.number);
    os.writeEntry("totalMass", total_.mass);
}


template<int D>
void Foam::grainOutlets<D>::load(const fileName& dir)
{
    if (isEmpty())
    {
        return;
    }
    const fileName file(dir/"outlets" + suffix_);
    if (!isFile(file, false))
    {
        Info<< "There is no " << file << ": outlets count from zero" << nl << endl;
        return;
    }
    const dictionary state((IFstream(file)()));
    total_.number = state.get<label>("total");
    total_.mass = state.get<scalar>("totalMass");
}


template class Foam::grainOutlets<2>;
template class Foam::grainOutlets<3>;
