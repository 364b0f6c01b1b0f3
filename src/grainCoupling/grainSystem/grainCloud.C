/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainDynamics.H"

#include "IOField.H"
#include "passiveParticleCloud.H"

template<int D>
void Foam::grainDynamics<D>::writeCloud() const
{
    const nscd::Grains<D>& g = grains();

    // Also the positions that older readers look for
    particle::writeLagrangianPositions = true;

    passiveParticleCloud cloud
    (
        mesh(), "grains", IDLList<passiveParticle>()
    );
    DynamicList<label> local;
    for (label i = 0; i < size(); ++i)
    {
        if (cell_[i] >= 0)
        {
            passiveParticle* grain =
                new passiveParticle
                (
                    mesh(),
                    space().positionInSpace(properties_.wrapped(g.position[i])),
                    cell_[i]
                );
            grain->origId() = g.id[i];
            cloud.addParticle(grain);
            local.append(i);
        }
    }
    cloud.write();

    const auto writeField = [&](const word& name, const auto& value)
    {
        typedef typename std::decay<decltype(value(0))>::type Type;
        IOField<Type> field
        (
            cloud.fieldIOobject(name, IOobject::NO_READ), local.size()
        );
        forAll(local, k)
        {
            field[k] = value(local[k]);
        }
        field.write(local.size());
    };

    writeField("radius", [&](label i) { return scalar(g.radius[i]); });
    writeField("mass", [&](label i) { return scalar(g.mass[i]); });
    writeField("U", [&](label i) { return velocity(i); });
    writeField("omega", [&](label i) { return spin(i); });
    if (fluidForce_.size())
    {
        writeField("fluidForce", [&](label i) { return fluidForce_[i]; });
    }
    writeField("material", [&](label i) { return label(g.material[i]); });
    writeField
    (
        "temperature", [&](label i) { return scalar(g.temperature[i]); }
    );
}


template void Foam::grainDynamics<2>::writeCloud() const;
template void Foam::grainDynamics<3>::writeCloud() const;
