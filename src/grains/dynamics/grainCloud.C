/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainDynamics.H"

#include "foamCompat.H"
#include "IOField.H"
#include "nscd/shape/Members.hpp"

namespace
{

using namespace Foam;

// A cloud of the points that are in cells of this rank
class pointCloud
{
    passiveParticleCloud cloud_;

    DynamicList<label> local_;

public:

    pointCloud(const polyMesh& mesh, const word& name)
    :
        cloud_(foamCompat::emptyCloud(mesh, name))
    {}

    void add(const label i, const point& x, const label celli, const label id)
    {
        if (celli >= 0)
        {
            passiveParticle* p = new passiveParticle(cloud_.pMesh(), x, celli);
            p->origId() = id;
            cloud_.addParticle(p);
            local_.append(i);
        }
    }

    void write() const { cloud_.write(); }

    // A field of the value of each index
    template<class Value>
    void write(const word& name, const Value& value) const
    {
        typedef typename std::decay<decltype(value(0))>::type Type;
        IOField<Type> field
        (
            cloud_.fieldIOobject(name, IOobject::NO_READ), local_.size()
        );
        forAll(local_, k)
        {
            field[k] = value(local_[k]);
        }
        field.write(local_.size());
    }
};

}


template<int D>
void Foam::grainDynamics<D>::writeCloud() const
{
    const nscd::Grains<D>& g = grains();
    locate();

    // Also the positions that older readers look for
    particle::writeLagrangianPositions = true;

    pointCloud cloud(mesh(), name_);
    forAll(cell_, i)
    {
        const point x
        (
            space().positionInSpace(properties_.wrapped(g.position[i]))
        );
        cloud.add(i, x, cell_[i], id(i));
    }
    cloud.write();

    cloud.write("id", [&](label i) { return id(i); });
    cloud.write("radius", [&](label i) { return scalar(g.radius[i]); });
    cloud.write("mass", [&](label i) { return scalar(g.mass[i]); });
    cloud.write("U", [&](label i) { return velocity(i); });
    cloud.write("omega", [&](label i) { return spin(i); });
    cloud.write("material", [&](label i) { return label(g.material[i]); });
    cloud.write("temperature", [&](label i) { return scalar(g.temperature[i]); });
    const labelList nContacts(contactNumbers());
    cloud.write("contacts", [&](label i) { return nContacts[i]; });
    cloud.write("contactForce", [&](label i) { return contactForce(i); });
    if (fluidForce_.size())
    {
        cloud.write("fluidForce", [&](label i) { return fluidForce_[i]; });
    }
    if (g.clusters.size())
    {
        cloud.write("shape", [&](label i) { return label(g.shape[i]); });
        writeMembers();
    }
}


template<int D>
Foam::labelList Foam::grainDynamics<D>::contactNumbers() const
{
    labelList number(size(), label(0));
    for (const nscd::ContactForce<D>& c : dynamics_->contacts())
    {
        ++number[c.first];
        if (c.second >= 0)
        {
            ++number[c.second];
        }
    }
    return number;
}


template<int D>
Foam::vector Foam::grainDynamics<D>::contactForce(const label graini) const
{
    const scalar deltaT = lastTimeStep();
    return
        deltaT > 0
      ? space().toSpace(dynamics_->contactImpulse()[graini])/deltaT
      : vector(Zero);
}


template<int D>
void Foam::grainDynamics<D>::writeMembers() const
{
    const nscd::Grains<D>& g = grains();
    const nscd::Members<D> members(g);
    const nscd::Vectors<D> centres(members.positions(g.position, g.orientation));

    pointCloud cloud(mesh(), "members");
    for (label m = 0; m < label(members.size()); ++m)
    {
        const nscd::Vector<D> x(properties_.wrapped(centres[m]));
        const label celli = space().findCell(x, cell_[members.grain(m)]);
        cloud.add(m, space().positionInSpace(x), celli, m);
    }
    cloud.write();

    cloud.write("radius", [&](label m) { return scalar(members.radius()[m]); });
    cloud.write("id", [&](label m) { return id(members.grain(m)); });
    cloud.write("U", [&](label m) { return velocity(members.grain(m)); });
}


template Foam::labelList Foam::grainDynamics<2>::contactNumbers() const;
template Foam::labelList Foam::grainDynamics<3>::contactNumbers() const;
template Foam::vector Foam::grainDynamics<2>::contactForce(label) const;
template Foam::vector Foam::grainDynamics<3>::contactForce(label) const;
template void Foam::grainDynamics<2>::writeCloud() const;
template void Foam::grainDynamics<3>::writeCloud() const;
