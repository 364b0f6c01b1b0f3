/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainOutlets.H"

#include "dictionaryInput.H"

template<int D>
Foam::grainOutlets<D>::grainOutlets(const grainDynamics<D>& grains)
:
    progress_(grains.mesh().time()),
    number_(0),
    mass_(0),
    totalNumber_(0),
    totalMass_(0),
    momentum_(Zero),
    heat_(0)
{
    const dictionary& properties = grains.properties().dict();
    if (properties.found("outlets"))
    {
        const dictionary& dict =
            dictionaryInput::subDict(properties, "outlets");

        for (const word& name : dict.toc())
        {
            outlets_.append
            (
                grainOutlet<D>::New
                (
                    dictionaryInput::subDict(dict, name), grains.space()
                )
            );
        }
    }
}


template<int D>
void Foam::grainOutlets<D>::open(grainDynamics<D>& grains)
{
    if (outlets_.empty())
    {
        return;
    }

    std::vector<bool> gone(grains.size(), false);
    for (const grainOutlet<D>& outlet : outlets_)
    {
        outlet.mark(grains.grains().position, grains.outside(), gone);
    }

    number_ = 0;
    mass_ = 0;
    momentum_ = Zero;
    heat_ = 0;
    for (label i = 0; i < grains.size(); ++i)
    {
        if (gone[i])
        {
            ++number_;
            mass_ += grains.grains().mass[i];
            heat_ += grains.heat() ? grains.heat()->heat(grains.grains(), i) : 0;
            momentum_ +=
                grains.grains().mass[i]*grains.velocity(i)
              - grains.space().toSpace(grains.dynamics().contactImpulse()[i]);
        }
    }
    totalNumber_ += number_;
    totalMass_ += mass_;

    if (number_)
    {
        grains.remove(gone);
    }
    write(grains.mesh().time());
}


template<int D>
void Foam::grainOutlets<D>::write(const Time& runTime)
{
    if (!Pstream::master())
    {
        return;
    }
    if (!file_)
    {
        file_ = progress_.newFile
        (
            "discharge", "discharge.dat",
            "# time removed removedMass massFlowRate total totalMass"
        );
    }
    file_()
        << runTime.value() << ' ' << number_ << ' ' << mass_ << ' '
        << mass_/runTime.deltaTValue() << ' ' << totalNumber_ << ' '
        << totalMass_ << endl;
}


template class Foam::grainOutlets<2>;
template class Foam::grainOutlets<3>;
