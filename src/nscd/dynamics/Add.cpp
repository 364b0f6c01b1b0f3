// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactDynamics::add and resize: grains come or become others, those that are there keep their contacts.

#include "nscd/dynamics/Implementation.hpp"
#include "nscd/dynamics/Validation.hpp"
#include "nscd/shape/Append.hpp"

namespace nscd
{

template <int D>
void ContactDynamics<D>::Implementation::add(const Grains<D>& more)
{
    Grains<D> all = grains_;
    append(all, more);
    replace(std::move(all));
}

template <int D>
void ContactDynamics<D>::Implementation::resize(std::vector<double> radius, std::vector<double> mass)
{
    Grains<D> all = grains_;
    all.radius = std::move(radius);
    all.mass = std::move(mass);
    replace(std::move(all));
}

template <int D>
void ContactDynamics<D>::Implementation::replace(Grains<D> all)
{
    validate(all, table_);
    validate(settings_, all);

    // Members are numbered grain by grain: those that are there keep their numbers
    contactsOfOthers_ = ownContacts();
    const std::vector<NamedImpulse<D>> impulses = gatherImpulses(candidates_, impulses_, communicator_);

    grains_ = std::move(all);
    contactImpulse_.resize(grains_.size(), Vector<D>::Zero());
    contactSpinImpulse_.resize(grains_.size(), Spin<D>::Zero());
    heaviness_.resize(grains_.size(), 1);
    for (Wrenches<D>* known : {&unexpected_, &owed_, &lasting_, &earlier_})
    {
        known->force.resize(grains_.size(), Vector<D>::Zero());
        known->torque.resize(grains_.size(), Spin<D>::Zero());
    }

    ambient_.clear();
    viscosity_.clear();
    measureGrains();
    problem_.clear();
    impacts_.clear();
    listAnew(reachAtRest(), impulses);
}

template void ContactDynamics<2>::Implementation::add(const Grains<2>&);
template void ContactDynamics<3>::Implementation::add(const Grains<3>&);
template void ContactDynamics<2>::Implementation::resize(std::vector<double>, std::vector<double>);
template void ContactDynamics<3>::Implementation::resize(std::vector<double>, std::vector<double>);

}  // namespace nscd
