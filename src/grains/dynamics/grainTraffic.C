/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainDynamics.H"

#include "volFields.H"

template<int D>
Foam::grainTally Foam::grainDynamics<D>::tally(const label i) const
{
    const scalar m = grains().mass[i];
    grainTally result;
    result.number = 1;
    result.mass = m;
    result.volume = m/properties_.materials().density(material(i));
    result.momentum = m*velocity(i) + space().toSpace(dynamics().owed().force[i]);
    result.heat = heat_ ? heat_->heat(grains(), i) : 0;
    return result;
}


template<int D>
Foam::grainTally Foam::grainDynamics<D>::tally() const
{
    grainTally all;
    for (label i = 0; i < size(); ++i)
    {
        all += tally(i);
    }
    return all;
}


template<int D>
Foam::vector Foam::grainDynamics<D>::wallImpulse() const
{
    vector sum(Zero);
    for (const nscd::Vector<D>& impulse : dynamics().contactImpulse())
    {
        sum += space().toSpace(impulse);
    }
    return sum;
}


template<int D>
typename Foam::grainInjection<D>::surroundings Foam::grainDynamics<D>::at
(
    const nscd::Vector<D>& x,
    const volVectorField* U
) const
{
    const label celli = space().findCell(properties_.wrapped(x));
    vector velocity(Zero);
    if (celli >= 0 && U)
    {
        velocity = U->primitiveField()[celli];
    }

    // A point on a face can be in two cells of two ranks
    label nCells = celli >= 0;
    reduce(nCells, sumOp<label>());
    reduce(velocity, sumOp<vector>());
    return {nCells > 0, velocity/max(nCells, 1)};
}


template<int D>
void Foam::grainDynamics<D>::inject(const volVectorField* U)
{
    injected_ = grainTally();
    if (injections_.empty())
    {
        return;
    }
    const nscd::Grains<D> more
    (
        injections_.due
        (
            mesh().time().value(),
            dynamics(),
            U,
            [&](const nscd::Vector<D>& x) { return at(x, U); }
        )
    );
    if (more.size() == 0)
    {
        return;
    }
    const label before = size();
    add(more, properties_.dict().subDict("injections"));
    for (label i = before; i < size(); ++i)
    {
        injected_ += tally(i);
    }
}


template<int D>
void Foam::grainDynamics<D>::add
(
    const nscd::Grains<D>& more,
    const dictionary& source
)
{
    try
    {
        dynamics_->add(more);
    }
    catch (const std::exception& err)
    {
        FatalIOErrorInFunction(source)
            << "Keyword '" << source.dictName() << "': " << err.what()
            << exit(FatalIOError);
    }
    isLocated_ = false;
    before_.insert(before_.end(), more.position.begin(), more.position.end());
    cell_.resize(size(), label(-1));
    if (fluidForce_.size())
    {
        fluidForce_.resize(size(), Zero);
    }
}


template<int D>
void Foam::grainDynamics<D>::discharge(const std::vector<bool>& gone)
{
    removed_ = grainTally();
    for (label i = 0; i < size(); ++i)
    {
        if (gone[i])
        {
            removed_ += tally(i);
            removed_.momentum -= space().toSpace(dynamics().contactImpulse()[i]);
        }
    }
    if (removed_.number)
    {
        remove(gone);
    }
    outlets_.count(removed_, mesh().time());
}


template<int D>
void Foam::grainDynamics<D>::remove(const std::vector<bool>& gone)
{
    locate();
    label kept = 0;
    forAll(cell_, i)
    {
        if (!gone[i])
        {
            cell_[kept] = cell_[i];
            before_[kept] = before_[i];
            if (fluidForce_.size())
            {
                fluidForce_[kept] = fluidForce_[i];
            }
            ++kept;
        }
    }
    before_.resize(kept);
    fluidForce_.resize(fluidForce_.empty() ? 0 : kept);
    dynamics_->remove(gone);
    isLocated_ = false;
}


template Foam::grainTally Foam::grainDynamics<2>::tally() const;
template Foam::grainTally Foam::grainDynamics<3>::tally() const;
template Foam::vector Foam::grainDynamics<2>::wallImpulse() const;
template Foam::vector Foam::grainDynamics<3>::wallImpulse() const;
template void Foam::grainDynamics<2>::inject(const volVectorField*);
template void Foam::grainDynamics<3>::inject(const volVectorField*);
template void Foam::grainDynamics<2>::discharge(const std::vector<bool>&);
template void Foam::grainDynamics<3>::discharge(const std::vector<bool>&);
template void Foam::grainDynamics<2>::remove(const std::vector<bool>&);
template void Foam::grainDynamics<3>::remove(const std::vector<bool>&);
template void Foam::grainDynamics<2>::add
(
    const nscd::Grains<2>&, const dictionary&
);
template void Foam::grainDynamics<3>::add
(
    const nscd::Grains<3>&, const dictionary&
);
