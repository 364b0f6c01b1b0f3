/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dryLedger.H"

#include "contactReport.H"

template<int D>
Foam::dryLedger<D>::dryLedger(const grainDynamics<D>& grains)
:
    grains_(grains),
    progress_(grains.mesh().time()),
    impulse_(Zero),
    momentumError_(0),
    heat_(0),
    wallHeat_(0),
    heatError_(0)
{
    measure();

    Info<< "Grains: " << grains_.size() << ", mass " << mass_ << " kg"
        << grains_.space().ofDepth().c_str() << endl;
}


template<int D>
void Foam::dryLedger<D>::measure()
{
    mass_ = 0;
    kineticEnergy_ = 0;
    potentialEnergy_ = 0;
    momentum_ = Zero;
    heat_ = 0;
    for (label i = 0; i < grains_.size(); ++i)
    {
        if (grains_.heat())
        {
            heat_ += grains_.heat()->heat(grains_.grains(), i);
        }
        const scalar m = grains_.grains().mass[i];
        mass_ += m;
        kineticEnergy_ +=
            0.5*m*magSqr(grains_.velocity(i))
          + 0.5*(grains_.spin(i) & grains_.angularMomentum(i));
        potentialEnergy_ -= m*(grains_.properties().g() & grains_.centre(i));
        momentum_ += m*grains_.velocity(i);
    }
}


template<int D>
void Foam::dryLedger<D>::startStep()
{
    Info<< nl << "Time = " << grains_.mesh().time().timeName() << nl << endl;
}


template<int D>
void Foam::dryLedger<D>::endStep()
{
    const grainTally& injected = grains_.injected();
    const scalar oldMass = mass_ + injected.mass;
    const vector oldMomentum(momentum_ + injected.momentum);
    const scalar oldHeat = heat_ + injected.heat;
    measure();

    impulse_ = grains_.wallImpulse();

    const vector weight
    (
        oldMass*grains_.mesh().time().deltaTValue()*grains_.properties().g()
    );
    momentumError_ =
        mag
        (
            momentum_ + grains_.removed().momentum - oldMomentum - weight - impulse_
        )
       /max(mag(oldMomentum) + mag(weight) + mag(impulse_), VSMALL);

    closeHeat(oldHeat);
    checkEnergy();
    print();
    write();
}


template<int D>
void Foam::dryLedger<D>::closeHeat(const scalar oldHeat)
{
    if (grains_.heat())
    {
        wallHeat_ = sum(grains_.heat()->wallHeat());
        heatError_ =
            mag(heat_ + grains_.removed().heat - oldHeat - wallHeat_)
           /max(oldHeat, VSMALL);
    }
}


template<int D>
void Foam::dryLedger<D>::print() const
{
    contactReport::print(grains_.lastStep());

    Info<< "Grains    " << grains_.size() << ", injected "
        << grains_.injected().number << ", removed "
        << grains_.removed().number << ", in all " << grains_.allRemoved() << nl
        << "Energy    kinetic " << kineticEnergy_ << " J, potential "
        << potentialEnergy_ << " J, contacts gave "
        << grains_.lastStep().contactWork << " J" << nl
        << "Momentum  " << momentum_ << " N s, unaccounted for "
        << momentumError_ << nl;
    if (grains_.heat())
    {
        Info<< "Heat      " << heat_ << " J, walls gave " << wallHeat_
            << " J, removed " << grains_.removed().heat << " J, unaccounted for "
            << heatError_ << nl;
    }

    progress_.print();
}


template<int D>
Foam::string Foam::dryLedger<D>::columns() const
{
    string names
    (
        "time,grains,injected,injectedMass,removed,removedMass,kineticEnergy,potentialEnergy,"
        "contactWork,momentum_x,momentum_y,momentum_z,impulse_x,impulse_y,"
        "impulse_z,momentumError,"
    );
    if (grains_.heat())
    {
        names += "heat,injectedHeat,removedHeat,";
        for (const word& wall : grains_.heat()->walls())
        {
            names += "heatFrom_" + wall + ',';
        }
        names += "heatError,";
    }
    return names + CONTACT_COLUMNS ",elapsedTime";
}


template<int D>
void Foam::dryLedger<D>::write()
{
    if (!Pstream::master())
    {
        return;
    }

    if (!file_)
    {
        file_ = progress_.newFile
        (
            "ledger", "ledger.csv", columns().c_str()
        );
    }

    const char c = ',';
    file_()
        << grains_.mesh().time().value() << c << grains_.size()
        << c << grains_.injected().number << c << grains_.injected().mass
        << c << grains_.removed().number << c << grains_.removed().mass
        << c << kineticEnergy_ << c << potentialEnergy_
        << c << grains_.lastStep().contactWork
        << c << momentum_.x() << c << momentum_.y() << c << momentum_.z()
        << c << impulse_.x() << c << impulse_.y() << c << impulse_.z()
        << c << momentumError_ << c;
    if (grains_.heat())
    {
        file_() << heat_ << c << grains_.injected().heat << c << grains_.removed().heat << c;
        for (const scalar heat : grains_.heat()->wallHeat())
        {
            file_() << heat << c;
        }
        file_() << heatError_ << c;
    }
    contactReport::write(file_(), grains_.lastStep());
    file_() << c << progress_.elapsed() << endl;
}


template<int D>
void Foam::dryLedger<D>::checkEnergy() const
{
    // Walls that move can give any
    if (grains_.properties().walls().bodies().size())
    {
        return;
    }

    // Round-off of the energies, and of a fall by a diameter
    scalar scale = kineticEnergy_;
    for (label i = 0; i < grains_.size(); ++i)
    {
        scale +=
            2*grains_.radius(i)*grains_.grains().mass[i]
           *mag(grains_.properties().g());
    }

    const scalar work = grains_.lastStep().contactWork;
    if (work > 1e-6*scale)
    {
        WarningInFunction
            << "Contacts gave " << work << " J in this step, of a kinetic"
            << " energy of " << kineticEnergy_ << " J: solve the contact"
            << " problem better, with a larger 'maxSweeps' or a smaller"
            << " 'deltaT'" << endl;
    }
}


template class Foam::dryLedger<2>;
template class Foam::dryLedger<3>;
