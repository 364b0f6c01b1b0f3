// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// One step of ContactDynamics: its sub-steps and its report.

#include "nscd/base/Check.hpp"
#include "nscd/dynamics/Implementation.hpp"
#include "nscd/dynamics/RigidMotion.hpp"
#include "nscd/dynamics/Validation.hpp"

#include <limits>
#include <sstream>
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

/// Of a force as much as lasts: at most twice what an earlier one has in its direction.  Once as much would make
/// less of a force that varies, as the sweeps leave it, on average.
template <class V>
V lastingPart(const V& now, const V& before)
{
    const double most = 2 * now.dot(before);
    const double square = now.squaredNorm();
    return most <= 0 ? V(V::Zero()) : most < square ? V(most / square * now) : now;
}

}  // namespace

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
    const Wrenches<D> before = meanOfContacts(lastTimeStep_);
    const Wrenches<D> given = withOwed(force, torque, dt);
    setFreeMotion(given, dt);
    report.subSteps = countSubSteps(dt);
    std::fill(contactImpulse_.begin(), contactImpulse_.end(), Vector<D>::Zero());
    std::fill(contactSpinImpulse_.begin(), contactSpinImpulse_.end(), Spin<D>::Zero());
    touching_.clear();
    wallImpulses_.clear();
    const double subStep = dt / report.subSteps;
    for (int s = 0; s < report.subSteps; ++s)
    {
        if (report.subSteps > 1)
        {
            setFreeMotion(given, subStep);
            requireReach(subStep * std::max(free_.largestSpeed, largestWallSpeed(subStep)), subStep);
        }
        advance(subStep, report);
        keepTouching(subStep);
        arrangement_.move(grains_.position, grains_.orientation, members_, candidates_);
        wallImpulses_.push_back(problem_.wallImpulses(impacts_.impulses()));
    }
    lastTimeStep_ = dt;
    keepOwed(dt);
    lasting_ = meanOfContacts(dt);
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        lasting_.force[i] = lastingPart(lastingPart(lasting_.force[i], before.force[i]), earlier_.force[i]);
        lasting_.torque[i] = lastingPart(lastingPart(lasting_.torque[i], before.torque[i]), earlier_.torque[i]);
    }
    earlier_ = before;

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
void ContactDynamics<D>::Implementation::foresee(const std::vector<double>& mass, const Vectors<D>& force,
                                                 const Spins<D>& torque, double dt)
{
    Grains<D> grains = grains_;
    grains.mass = mass;
    Implementation trial(std::move(grains), walls_, table_, settings_, communicator_.handle(), initialWallBodies_);
    trial.wallBodies_ = wallBodies_;
    trial.arrangement_.walls().place(initialWallBodies_, wallBodies_);
    if (!ambient_.empty())
    {
        trial.setAmbient(ambient_);
    }
    trial.step(force, torque, dt);
    contactImpulse_ = trial.contactImpulse_;
    contactSpinImpulse_ = trial.contactSpinImpulse_;
    lastTimeStep_ = trial.lastTimeStep_;
    lasting_ = earlier_ = meanOfContacts(dt);
}

template <int D>
Wrenches<D> ContactDynamics<D>::Implementation::meanOfContacts(double dt) const
{
    Wrenches<D> mean{contactImpulse_, contactSpinImpulse_};
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        mean.force[i] *= dt > 0 ? 1 / dt : 0;
        mean.torque[i] *= dt > 0 ? 1 / dt : 0;
    }
    return mean;
}

template <int D>
int ContactDynamics<D>::Implementation::countSubSteps(double dt) const
{
    const double farthest = dt * std::max(free_.largestSpeed, largestWallSpeed(dt));
    requireReach(farthest, dt);
    return std::max(1, static_cast<int>(std::ceil(farthest / (settings_.maxDisplacement * 2 * smallestRadius_))));
}

template <int D>
void ContactDynamics<D>::Implementation::requireReach(double farthest, double dt) const
{
    constexpr double maxSubSteps = 10000;
    if (!(farthest / (settings_.maxDisplacement * 2 * smallestRadius_) <= maxSubSteps))
    {
        std::ostringstream message;
        message << "a grain or a wall would move by " << farthest << " m in a step of " << dt
                << " s: too far for sub-steps";
        throw std::runtime_error(message.str());
    }
}

template <int D>
double ContactDynamics<D>::Implementation::owedPart(std::size_t i) const
{
    return 1 - 1 / heaviness_[i];
}

template <int D>
double ContactDynamics<D>::Implementation::owedPartOfTorque(std::size_t i) const
{
    return 1 - 1 / heavinessOfTurning(i);
}

template <int D>
Wrenches<D> ContactDynamics<D>::Implementation::withOwed(const Vectors<D>& force, const Spins<D>& torque,
                                                         double dt) const
{
    Wrenches<D> given{force, torque};
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        given.force[i] += owed_.force[i] / dt + owedPart(i) * lasting_.force[i];
        given.torque[i] += owed_.torque[i] / dt + owedPartOfTorque(i) * lasting_.torque[i];
    }
    return given;
}

template <int D>
void ContactDynamics<D>::Implementation::keepOwed(double dt)
{
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        unexpected_.force[i] = contactImpulse_[i] - dt * lasting_.force[i];
        unexpected_.torque[i] = contactSpinImpulse_[i] - dt * lasting_.torque[i];
        owed_.force[i] = owedPart(i) * unexpected_.force[i];
        owed_.torque[i] = owedPartOfTorque(i) * unexpected_.torque[i];
    }
}

template <int D>
void ContactDynamics<D>::Implementation::setFreeMotion(const Wrenches<D>& given, double dt)
{
    free_.velocity.resize(grains_.size());
    free_.spin.resize(grains_.size());
    free_.largestSpeed = 0;
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        free_.velocity[i] = grains_.velocity[i] + (dt / grains_.mass[i]) * given.force[i];
        free_.spin[i] = grains_.spin[i] + spinOf<D>(grains_, i, grains_.orientation[i], dt * given.torque[i]);
        free_.largestSpeed = std::max(free_.largestSpeed, freeSpeed(i));
    }
}

template <int D>
double ContactDynamics<D>::Implementation::freeSpeed(std::size_t i) const
{
    const double turning = grains_.shape[i] < 0 ? 0 : grains_.radius[i] * free_.spin[i].norm();
    return free_.velocity[i].norm() + turning;
}

template <int D>
void ContactDynamics<D>::Implementation::measureOverlaps(StepReport& report)
{
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

template StepReport ContactDynamics<2>::Implementation::step(const Vectors<2>&, const Spins<2>&, double);
template StepReport ContactDynamics<3>::Implementation::step(const Vectors<3>&, const Spins<3>&, double);
template void ContactDynamics<2>::Implementation::foresee(const std::vector<double>&, const Vectors<2>&,
                                                          const Spins<2>&, double);
template void ContactDynamics<3>::Implementation::foresee(const std::vector<double>&, const Vectors<3>&,
                                                          const Spins<3>&, double);
template Wrenches<2> ContactDynamics<2>::Implementation::meanOfContacts(double) const;
template Wrenches<3> ContactDynamics<3>::Implementation::meanOfContacts(double) const;
template void ContactDynamics<2>::Implementation::measureOverlaps(StepReport&);
template void ContactDynamics<3>::Implementation::measureOverlaps(StepReport&);
template double ContactDynamics<2>::Implementation::freeSpeed(std::size_t) const;
template double ContactDynamics<3>::Implementation::freeSpeed(std::size_t) const;

}  // namespace nscd
