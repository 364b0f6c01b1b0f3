// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/dynamics/Implementation.hpp"

namespace nscd
{

template <int D>
ContactDynamics<D>::ContactDynamics(Grains<D> grains, Walls<D> walls, ContactTable table, Settings settings,
                                    MPI_Comm communicator, std::vector<WallBody<D>> wallBodies)
    : implementation_(std::make_unique<Implementation>(std::move(grains), std::move(walls), std::move(table), settings,
                                                       communicator, std::move(wallBodies)))
{
}

template <int D>
ContactDynamics<D>::~ContactDynamics() = default;

template <int D>
ContactDynamics<D>::ContactDynamics(ContactDynamics&&) noexcept = default;

template <int D>
ContactDynamics<D>& ContactDynamics<D>::operator=(ContactDynamics&&) noexcept = default;

template <int D>
const Grains<D>& ContactDynamics<D>::grains() const
{
    return implementation_->grains();
}

template <int D>
const Walls<D>& ContactDynamics<D>::walls() const
{
    return implementation_->walls();
}

template <int D>
const Settings& ContactDynamics<D>::settings() const
{
    return implementation_->settings();
}

template <int D>
StepReport ContactDynamics<D>::step(const Vectors<D>& force, const Spins<D>& torque, double dt)
{
    return implementation_->step(force, torque, dt);
}

template <int D>
void ContactDynamics<D>::foresee(const std::vector<double>& mass, const Vectors<D>& force, const Spins<D>& torque,
                                 double dt)
{
    implementation_->foresee(mass, force, torque, dt);
}

template <int D>
const std::vector<WallBody<D>>& ContactDynamics<D>::wallBodies() const
{
    return implementation_->wallBodies();
}

template <int D>
void ContactDynamics<D>::setWallMotion(int body, const Vector<D>& velocity, const Spin<D>& spin)
{
    implementation_->setWallMotion(body, velocity, spin);
}

template <int D>
void ContactDynamics<D>::carryWalls(double dt)
{
    implementation_->carryWalls(dt);
}

template <int D>
void ContactDynamics<D>::setWallLoad(int body, const Vector<D>& force, const Spin<D>& torque)
{
    implementation_->setWallLoad(body, force, torque);
}

template <int D>
std::vector<ContactForce<D>> ContactDynamics<D>::contacts() const
{
    return implementation_->contacts();
}

template <int D>
std::vector<WallImpulse<D>> ContactDynamics<D>::wallImpulses() const
{
    return implementation_->wallImpulses();
}

template <int D>
void ContactDynamics<D>::recordTouching(bool on)
{
    implementation_->recordTouching(on);
}

template <int D>
std::vector<Touching<D>> ContactDynamics<D>::touching() const
{
    return implementation_->touching();
}

template <int D>
void ContactDynamics<D>::dumpContactProblem(const std::string& file) const
{
    implementation_->dumpContactProblem(file);
}

template <int D>
const Vectors<D>& ContactDynamics<D>::contactImpulse() const
{
    return implementation_->contactImpulse();
}

template <int D>
const Spins<D>& ContactDynamics<D>::contactSpinImpulse() const
{
    return implementation_->contactSpinImpulse();
}

template <int D>
const Wrenches<D>& ContactDynamics<D>::lasting() const
{
    return implementation_->lasting();
}

template <int D>
const Wrenches<D>& ContactDynamics<D>::unexpected() const
{
    return implementation_->unexpected();
}

template <int D>
const Wrenches<D>& ContactDynamics<D>::owed() const
{
    return implementation_->owed();
}

template <int D>
void ContactDynamics<D>::setHeaviness(std::vector<double> heaviness)
{
    implementation_->setHeaviness(std::move(heaviness));
}

template <int D>
void ContactDynamics<D>::setLubrication(WetRestitution law, std::vector<double> viscosity)
{
    implementation_->setLubrication(std::move(law), std::move(viscosity));
}

template <int D>
double ContactDynamics<D>::lastTimeStep() const
{
    return implementation_->lastTimeStep();
}

template <int D>
double ContactDynamics<D>::worstOverlap() const
{
    return implementation_->worstOverlap();
}

template <int D>
void ContactDynamics<D>::setAmbient(std::vector<double> ambient)
{
    implementation_->setAmbient(std::move(ambient));
}

template <int D>
void ContactDynamics<D>::setTemperature(std::vector<double> temperature)
{
    implementation_->setTemperature(std::move(temperature));
}

template <int D>
void ContactDynamics<D>::setWallNames(WallNames names)
{
    implementation_->setWallNames(std::move(names));
}

template <int D>
void ContactDynamics<D>::remove(const std::vector<bool>& gone)
{
    implementation_->remove(gone);
}

template <int D>
void ContactDynamics<D>::add(const Grains<D>& more)
{
    implementation_->add(more);
}

template <int D>
void ContactDynamics<D>::resize(std::vector<double> radius, std::vector<double> mass)
{
    implementation_->resize(std::move(radius), std::move(mass));
}

template <int D>
void ContactDynamics<D>::save(const std::string& file, double time) const
{
    implementation_->save(file, time);
}

template <int D>
double ContactDynamics<D>::load(const std::string& file)
{
    return implementation_->load(file);
}

template class ContactDynamics<2>;
template class ContactDynamics<3>;

}  // namespace nscd
