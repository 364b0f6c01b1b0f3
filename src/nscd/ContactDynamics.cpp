// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/Check.hpp"
#include "nscd/Implementation.hpp"
#include "nscd/RigidMotion.hpp"
#include "nscd/Validation.hpp"

#include <limits>
#include <stdexcept>

namespace nscd
{

namespace
{

template <int D>
void requireFinite(const Vectors<D>& vectors, const Spins<D>& spins, const Grains<D>& grains, const char* vectorName,
                   const char* spinName)
{
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const bool vectorIsFinite = isFinite(vectors[i]);
        if (!vectorIsFinite || !isFinite(spins[i]))
        {
            throw std::runtime_error("grain " + std::to_string(grains.id[i]) + ": " +
                                     (vectorIsFinite ? spinName : vectorName) + " is not finite");
        }
    }
}

}  // namespace

template <int D>
ContactDynamics<D>::Implementation::Implementation(Grains<D> grains, Walls<D> walls, ContactTable table,
                                                   Settings settings, MPI_Comm communicator,
                                                   std::vector<WallBody<D>> wallBodies)
    : grains_(std::move(grains)), walls_((validate<D>(walls, table, wallBodies), std::move(walls))),
      table_((validate(table), std::move(table))), settings_(settings), communicator_(communicator),
      initialWallBodies_(std::move(wallBodies)), wallBodies_(initialWallBodies_),
      arrangement_(walls_, table_, settings.period)
{
    validate(settings_);
    validate(grains_, table_);
    contactImpulse_.assign(grains_.size(), Vector<D>::Zero());
    contactSpinImpulse_.assign(grains_.size(), Spin<D>::Zero());
    measureGrains();
    measureWalls();
    rebuildCandidates(grains_.position, grains_.orientation, restSkin * meanRadius_, {});
    StepReport report;
    measureOverlaps(report);
}

template <int D>
void ContactDynamics<D>::Implementation::measureGrains()
{
    members_ = Members<D>(grains_);
    smallestRadius_ = std::numeric_limits<double>::max();
    meanRadius_ = 0;
    for (const double r : members_.radius())
    {
        smallestRadius_ = std::min(smallestRadius_, r);
        meanRadius_ += r / static_cast<double>(members_.size());
    }
    bounces_ = false;
    levered_ = !members_.simple() || freeBodies() > 0;
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
std::vector<ContactForce<D>> ContactDynamics<D>::Implementation::contacts() const
{
    std::vector<ContactForce<D>> mine = problem_.forces();
    for (ContactForce<D>& c : mine)
    {
        c.first = members_.grain(candidates_.memberOrder()[c.first]);
        c.second = c.second < 0 ? c.second : members_.grain(candidates_.memberOrder()[c.second]);
    }
    return communicator_.gather(mine);
}

template <int D>
StepReport ContactDynamics<D>::Implementation::step(const Vectors<D>& force, const Spins<D>& torque, double dt)
{
    if (force.size() != grains_.size() || torque.size() != grains_.size())
    {
        throw std::invalid_argument(std::to_string(grains_.size()) + " grains but " + std::to_string(force.size()) +
                                    " forces and " + std::to_string(torque.size()) + " torques");
    }
    if (!isPositive(dt))
    {
        throw std::invalid_argument("time step " + std::to_string(dt) + " s is not positive");
    }
    requireFinite(force, torque, grains_, "force", "torque");
    requireFinite(grains_.velocity, grains_.spin, grains_, "velocity", "spin");

    StepReport report;
    report.subSteps = countSubSteps(force, torque, dt);
    std::fill(contactImpulse_.begin(), contactImpulse_.end(), Vector<D>::Zero());
    std::fill(contactSpinImpulse_.begin(), contactSpinImpulse_.end(), Spin<D>::Zero());
    const double subStep = dt / report.subSteps;
    for (int s = 0; s < report.subSteps; ++s)
    {
        advance(freeMotion(force, torque, subStep), subStep, report);
    }
    lastTimeStep_ = dt;

    const Stopwatch watch;
    measureOverlaps(report);
    for (const Vector<D>& v : grains_.velocity)
    {
        report.maxVelocity = std::max(report.maxVelocity, v.norm());
    }
    report.detectionTime += watch.seconds();
    return report;
}

template <int D>
int ContactDynamics<D>::Implementation::countSubSteps(const Vectors<D>& force, const Spins<D>& torque,
                                                      double dt) const
{
    const double farthest = dt * freeMotion(force, torque, dt).largestSpeed;
    const double subSteps = std::ceil(farthest / (settings_.maxDisplacement * 2 * smallestRadius_));
    constexpr double maxSubSteps = 10000;   // a run that has blown up must stop, not hang
    if (!(subSteps <= maxSubSteps))
    {
        throw std::runtime_error("a grain would move by " + std::to_string(farthest) + " m in a step of " +
                                 std::to_string(dt) + " s: too far for sub-steps");
    }
    return std::max(1, static_cast<int>(subSteps));
}

template <int D>
auto ContactDynamics<D>::Implementation::freeMotion(const Vectors<D>& force, const Spins<D>& torque,
                                                    double dt) const -> FreeMotion
{
    FreeMotion free;
    free.velocity.resize(grains_.size());
    free.spin.resize(grains_.size());
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        free.velocity[i] = grains_.velocity[i] + (dt / grains_.mass[i]) * force[i];
        free.spin[i] = grains_.spin[i] + spinOf<D>(grains_, i, grains_.orientation[i], dt * torque[i]);
        const double turning = grains_.shape[i] < 0 ? 0 : grains_.radius[i] * free.spin[i].norm();
        free.largestSpeed = std::max(free.largestSpeed, free.velocity[i].norm() + turning);
    }
    return free;
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
void ContactDynamics<D>::Implementation::measureOverlaps(StepReport& report)
{
    arrangement_.move(grains_, members_, candidates_);
    std::vector<double> sums(2 * candidates_.blocks(), 0.0);   // depths and numbers of each block
    double worst = 0;
    for (const Group& group : candidates_.groups())
    {
        for (std::size_t p = group.begin; p < group.end; ++p)
        {
            const double depth = arrangement_.depth(candidates_.pairs()[p]);
            if (depth > 0)
            {
                sums[2 * group.first] += depth;
                sums[2 * group.first + 1] += 1;
                worst = std::max(worst, depth);
            }
        }
    }
    worstOverlap_ = communicator_.max(worst);
    communicator_.sum(sums);
    double depth = 0;
    double number = 0;
    for (std::size_t b = 0; b < sums.size(); b += 2)
    {
        depth += sums[b];
        number += sums[b + 1];
    }
    report.worstOverlap = worstOverlap_;
    report.meanOverlap = number > 0 ? depth / number : 0;
}

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
void ContactDynamics<D>::setTemperature(std::vector<double> temperature)
{
    implementation_->setTemperature(std::move(temperature));
}

template <int D>
void ContactDynamics<D>::remove(const std::vector<bool>& gone)
{
    implementation_->remove(gone);
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
