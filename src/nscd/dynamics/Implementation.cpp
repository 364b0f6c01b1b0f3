// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What ContactDynamics holds, and how it is set.

#include "nscd/base/Check.hpp"
#include "nscd/dynamics/Implementation.hpp"
#include "nscd/dynamics/RigidMotion.hpp"
#include "nscd/dynamics/Validation.hpp"

#include <limits>
#include <stdexcept>

namespace nscd
{

template <int D>
ContactDynamics<D>::Implementation::Implementation(Grains<D> grains, Walls<D> walls, ContactTable table,
                                                   Settings settings, MPI_Comm communicator,
                                                   std::vector<WallBody<D>> wallBodies)
    : grains_(std::move(grains)), walls_((validate<D>(walls, table, wallBodies), std::move(walls))),
      table_((validate(table), std::move(table))), settings_((validate(settings), settings)),
      communicator_(communicator),
      initialWallBodies_(std::move(wallBodies)), wallBodies_(initialWallBodies_),
      arrangement_(walls_, table_, settings.period)
{
    validate(grains_, table_);
    validate(settings_, grains_);
    validate<D>(settings_, walls_);
    contactImpulse_.assign(grains_.size(), Vector<D>::Zero());
    contactSpinImpulse_.assign(grains_.size(), Spin<D>::Zero());
    lasting_ = earlier_ = unexpected_ = owed_ = {contactImpulse_, contactSpinImpulse_};
    heaviness_.assign(grains_.size(), 1);
    measureGrains();
    measureWalls();
    listAnew(reachAtRest(), {});
    StepReport report;
    measureOverlaps(report);
}

template <int D>
void ContactDynamics<D>::Implementation::measureGrains()
{
    members_ = Members<D>(grains_);
    smallestRadius_ = std::numeric_limits<double>::max();
    meanRadius_ = 0;
    largestRadius_ = grains_.size() ? *std::max_element(grains_.radius.begin(), grains_.radius.end()) : 0;
    for (const double r : members_.radius())
    {
        smallestRadius_ = std::min(smallestRadius_, r);
        meanRadius_ += r / static_cast<double>(members_.size());
    }
    bounces_ = false;
    levered_ = !members_.simple() || freeBodies() > 0;
    coheres_ = table_.coheres();
    for (int a = 0; a < table_.materials(); ++a)
    {
        for (int b = a; b < table_.materials(); ++b)
        {
            bounces_ = bounces_ || table_(a, b).restitution > 0;
            levered_ = levered_ || table_(a, b).rolling > 0;
        }
    }
}

template <int D>
void ContactDynamics<D>::Implementation::measureWalls()
{
    candidateWalls_ = wallBodies_;
    wallExtent_.assign(wallBodies_.size(), 0.0);
    std::vector<int> number(wallBodies_.size(), -1);
    int free = 0;
    for (std::size_t b = 0; b < wallBodies_.size(); ++b)
    {
        number[b] = isFree(wallBodies_[b]) ? free++ : -1;
    }
    freeBodyOfWall_.clear();
    for (const auto& wall : walls_)
    {
        const int body = bodyOf(wall);
        freeBodyOfWall_.push_back(body < 0 ? -1 : number[body]);
        if (body >= 0)
        {
            wallExtent_[body] = std::max(wallExtent_[body], extentFrom(wall, initialWallBodies_[body].position));
        }
    }
    arrangement_.walls().place(initialWallBodies_, wallBodies_);
}

template <int D>
void ContactDynamics<D>::Implementation::setWallMotion(int body, const Vector<D>& velocity, const Spin<D>& spin)
{
    checkWallBody(body, false, isFinite(velocity) && isFinite(spin));
    checkSpin<D>(walls_, body, spin);
    wallBodies_[body].velocity = velocity;
    wallBodies_[body].spin = spin;
}

template <int D>
void ContactDynamics<D>::Implementation::setWallLoad(int body, const Vector<D>& force, const Spin<D>& torque)
{
    checkWallBody(body, true, isFinite(force) && isFinite(torque));
    wallBodies_[body].force = force;
    wallBodies_[body].torque = torque;
}

template <int D>
void ContactDynamics<D>::Implementation::checkWallBody(int body, bool free, bool finite) const
{
    if (body < 0 || body >= static_cast<int>(wallBodies_.size()))
    {
        throw std::invalid_argument("wall body " + std::to_string(body) + " of " + std::to_string(wallBodies_.size()));
    }
    if (isFree(wallBodies_[body]) != free)
    {
        throw std::invalid_argument("wall body " + std::to_string(body) +
                                    (free ? " is not free: its motion is prescribed, loads have no effect"
                                          : " is free: its motion cannot be prescribed"));
    }
    if (!finite)
    {
        throw std::invalid_argument("wall body " + std::to_string(body) + ": a value is not finite");
    }
}

template <int D>
std::vector<ContactForce<D>> ContactDynamics<D>::Implementation::ownContacts() const
{
    std::vector<ContactForce<D>> mine = contactsOfOthers_;
    for (ContactForce<D> c : problem_.forces(impacts_.impulses()))
    {
        c.first = members_.grain(candidates_.memberOrder()[c.first]);
        c.second = c.second < 0 ? c.second : members_.grain(candidates_.memberOrder()[c.second]);
        mine.push_back(c);
    }
    return mine;
}

template <int D>
std::vector<ContactForce<D>> ContactDynamics<D>::Implementation::contacts() const
{
    return communicator_.gather(ownContacts());
}

template <int D>
std::vector<WallImpulse<D>> ContactDynamics<D>::Implementation::wallImpulses() const
{
    std::vector<WallImpulse<D>> all;
    for (const std::vector<WallImpulse<D>>& mine : wallImpulses_)
    {
        const std::vector<WallImpulse<D>> gathered = communicator_.gather(mine);
        all.insert(all.end(), gathered.begin(), gathered.end());
    }
    return all;
}

template <int D>
void ContactDynamics<D>::Implementation::setTemperature(std::vector<double> temperature)
{
    if (temperature.size() != grains_.size())
    {
        throw std::invalid_argument(std::to_string(grains_.size()) + " grains but " +
                                    std::to_string(temperature.size()) + " temperatures");
    }
    grains_.temperature = std::move(temperature);
}

template <int D>
void ContactDynamics<D>::Implementation::setWallNames(WallNames names)
{
    if (names.ofWall.size() != walls_.size() || names.ofBody.size() != wallBodies_.size())
    {
        throw std::invalid_argument(std::to_string(walls_.size()) + " walls and " +
                                    std::to_string(wallBodies_.size()) + " wall bodies but names of " +
                                    std::to_string(names.ofWall.size()) + " and " +
                                    std::to_string(names.ofBody.size()));
    }
    wallNames_ = std::move(names);
}

template <int D>
void ContactDynamics<D>::Implementation::setAmbient(std::vector<double> ambient)
{
    if (ambient.size() != grains_.size())
    {
        throw std::invalid_argument(std::to_string(grains_.size()) + " grains but " + std::to_string(ambient.size()) +
                                    " ambient values");
    }
    ambient_ = std::move(ambient);
    arrangement_.surround(ambient_, members_, candidates_);
}

template <int D>
void ContactDynamics<D>::Implementation::setHeaviness(std::vector<double> heaviness)
{
    if (heaviness.size() != grains_.size())
    {
        throw std::invalid_argument(std::to_string(grains_.size()) + " grains but the heaviness of " +
                                    std::to_string(heaviness.size()));
    }
    for (std::size_t i = 0; i < heaviness.size(); ++i)
    {
        if (!(heaviness[i] >= 1 && std::isfinite(heaviness[i])))
        {
            throw std::invalid_argument("grain " + std::to_string(grains_.id[i]) + ": heaviness " +
                                        std::to_string(heaviness[i]) + " is not finite and at least 1");
        }
    }
    heaviness_ = std::move(heaviness);
}

template <int D>
void ContactDynamics<D>::Implementation::setLubrication(WetRestitution law, std::vector<double> viscosity)
{
    if (viscosity.size() != grains_.size())
    {
        throw std::invalid_argument(std::to_string(grains_.size()) + " grains but " +
                                    std::to_string(viscosity.size()) + " viscosities");
    }
    viscosity_ = std::move(viscosity);
    impacts_.setLubrication(std::move(law));
}

template ContactDynamics<2>::Implementation::Implementation(Grains<2>, Walls<2>, ContactTable, Settings, MPI_Comm,
                                                            std::vector<WallBody<2>>);
template ContactDynamics<3>::Implementation::Implementation(Grains<3>, Walls<3>, ContactTable, Settings, MPI_Comm,
                                                            std::vector<WallBody<3>>);
template void ContactDynamics<2>::Implementation::measureGrains();
template void ContactDynamics<3>::Implementation::measureGrains();
template void ContactDynamics<2>::Implementation::setWallMotion(int, const Vector<2>&, const Spin<2>&);
template void ContactDynamics<3>::Implementation::setWallMotion(int, const Vector<3>&, const Spin<3>&);
template void ContactDynamics<2>::Implementation::setWallLoad(int, const Vector<2>&, const Spin<2>&);
template void ContactDynamics<3>::Implementation::setWallLoad(int, const Vector<3>&, const Spin<3>&);
template std::vector<ContactForce<2>> ContactDynamics<2>::Implementation::ownContacts() const;
template std::vector<ContactForce<3>> ContactDynamics<3>::Implementation::ownContacts() const;
template std::vector<ContactForce<2>> ContactDynamics<2>::Implementation::contacts() const;
template std::vector<ContactForce<3>> ContactDynamics<3>::Implementation::contacts() const;
template std::vector<WallImpulse<2>> ContactDynamics<2>::Implementation::wallImpulses() const;
template std::vector<WallImpulse<3>> ContactDynamics<3>::Implementation::wallImpulses() const;
template void ContactDynamics<2>::Implementation::setTemperature(std::vector<double>);
template void ContactDynamics<3>::Implementation::setTemperature(std::vector<double>);
template void ContactDynamics<2>::Implementation::setWallNames(WallNames);
template void ContactDynamics<3>::Implementation::setWallNames(WallNames);
template void ContactDynamics<2>::Implementation::setHeaviness(std::vector<double>);
template void ContactDynamics<3>::Implementation::setHeaviness(std::vector<double>);
template void ContactDynamics<2>::Implementation::setLubrication(WetRestitution, std::vector<double>);
template void ContactDynamics<3>::Implementation::setLubrication(WetRestitution, std::vector<double>);
template void ContactDynamics<2>::Implementation::setAmbient(std::vector<double>);
template void ContactDynamics<3>::Implementation::setAmbient(std::vector<double>);

}  // namespace nscd
