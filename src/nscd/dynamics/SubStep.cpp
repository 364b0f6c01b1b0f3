// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// One sub-step of ContactDynamics: candidates, choice of contacts, sweeps, motion.

#include "nscd/dynamics/Implementation.hpp"
#include "nscd/dynamics/RigidMotion.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace nscd
{

template <int D>
void ContactDynamics<D>::Implementation::advance(double dt, StepReport& report)
{
    Stopwatch watch;
    updateCandidates(dt);
    const Start start = startOfSubStep(report);
    Reach wanted;
    bool converged = solveContacts(dt, report, watch);
    while (!motionIsCovered(dt, wanted))
    {
        goBack(start, report);
        listAnew(wanted);
        converged = solveContacts(dt, report, watch);
    }
    problem_.store(impulses_);
    for (Impulse<D>& impulse : impulses_)
    {
        impulse.age = impulse.normal > 0 ? impulse.age + dt : 0;
    }
    lastSubStep_ = dt;
    const bool separated = separate(dt, converged, report);
    const std::vector<PassedWall> passed = problem_.passedWalls(bodies_, displacements_);
    move(dt, report);
    moveWalls(dt, report);

    std::vector<double> counts{double(candidates_.pairs().size()), double(problem_.contacts()),
                               double(problem_.active()), double(solves_), double(problem_.isCut()),
                               double(passed.size())};
    communicator_.sum(counts);
    report.converged = report.converged && separated && counts[4] == 0;
    if (counts[5] > 0)
    {
        refusePassedWalls(passed, report);
    }
    report.candidates = static_cast<std::size_t>(counts[0]);
    report.contacts = static_cast<std::size_t>(counts[1]);
    report.active = static_cast<std::size_t>(counts[2]);
    report.solves += static_cast<std::size_t>(counts[3]);
    report.solutionTime += watch.seconds();
}

template <int D>
bool ContactDynamics<D>::Implementation::solveContacts(double dt, StepReport& report, Stopwatch& watch)
{
    impulsesOfStart_.clear();
    if (bounces_)
    {
        collide(dt, report);
    }
    makeBodies(dt);
    problem_.begin(impulses_, dt,
                   coheres_ ? handOverAges(arrangement_, candidates_.pairs(), impulses_) : std::vector<char>());
    problem_.choose(bodies_, impulses_);
    contactsOfOthers_.clear();
    report.detectionTime += watch.restart();

    schedule_->pass(bodies_, [&](int group) { problem_.applyImpulses(group, bodies_); });
    solves_ = 0;
    return solve(dt, report);
}

template <int D>
auto ContactDynamics<D>::Implementation::startOfSubStep(const StepReport& report) const -> Start
{
    return bounces_ ? Start{report, grains_.position, grains_.orientation, free_, wallBodies_, contactImpulse_,
                            contactSpinImpulse_}
                    : Start{report, {}, {}, {}, {}, {}, {}};
}

template <int D>
void ContactDynamics<D>::Implementation::goBack(const Start& start, StepReport& report)
{
    report = start.report;
    if (!impulsesOfStart_.empty())
    {
        impulses_ = impulsesOfStart_;
    }
    if (bounces_)
    {
        grains_.position = start.position;
        grains_.orientation = start.orientation;
        free_ = start.free;
        wallBodies_ = start.wallBodies;
        contactImpulse_ = start.contactImpulse;
        contactSpinImpulse_ = start.contactSpinImpulse;
        arrangement_.walls().place(initialWallBodies_, wallBodies_);
    }
}

template <int D>
void ContactDynamics<D>::Implementation::refusePassedWalls(const std::vector<PassedWall>& mine,
                                                           const StepReport& report) const
{
    // The deepest, whatever the order of the ranks
    const std::vector<PassedWall> all = communicator_.gather(mine);
    const PassedWall& first =
        *std::min_element(all.begin(), all.end(), [](const PassedWall& a, const PassedWall& b)
                          { return std::tie(a.gap, a.first, a.wall) < std::tie(b.gap, b.first, b.wall); });
    const int grain = members_.grain(candidates_.memberOrder()[first.first]);
    std::ostringstream message;
    message << "grain " << grains_.id[grain] << " has been pressed through wall " << first.wall << ", with "
            << all.size() - 1 << " more: it overlapped the wall by " << std::max(0.0, -first.gap)
            << " m, its radius is " << grains_.radius[grain] << " m, the contacts' residual " << report.residual
            << " m/s; more grains than fit between the walls, too long a step, or too few sweeps";
    throw std::runtime_error(message.str());
}

template <int D>
Body<D> ContactDynamics<D>::Implementation::freeBody(std::size_t i) const
{
    const double m = grains_.mass[i];
    return {free_.velocity[i], surfaceSpeed<D>(free_.spin[i], grains_.radius[i]), 1 / (heaviness_[i] * m),
            1 / (heavinessOfTurning(i) * inertiaFactor<D> * m)};
}

template <int D>
void ContactDynamics<D>::Implementation::makeBodies(double dt)
{
    bodies_.resize(grains_.size());
    data_.turning.resize(levered_ ? grains_.size() : 0);
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const int k = candidates_.place()[i];
        bodies_[k] = freeBody(i);
        if (levered_)
        {
            data_.turning[k] = turningOf(grains_, i, heavinessOfTurning(i));
        }
    }
    for (const WallBody<D>& wall : wallBodies_)
    {
        if (isFree(wall))
        {
            const FreeWall<D> free(wall, dt);
            bodies_.push_back({free.velocity, surfaceSpeed<D>(free.spin, 1), 1 / wall.mass, 0});
            data_.turning.push_back(free.turning);
        }
    }
    bodies_.push_back({Vector<D>::Zero(), zeroTangent<D>(), 0, 0});
}

template <int D>
void ContactDynamics<D>::Implementation::move(double dt, StepReport& report)
{
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const int k = candidates_.place()[i];
        const Vector<D> impulse = heaviness_[i] * grains_.mass[i] * (bodies_[k].velocity - free_.velocity[i]);
        const Spin<D> spinChange =
            toSpin(Tangent<D>(bodies_[k].surfaceSpeed - surfaceSpeed<D>(free_.spin[i], grains_.radius[i]))) /
            grains_.radius[i];
        const Spin<D> spinImpulse = heavinessOfTurning(i) * angularMomentum<D>(grains_, i, spinChange);
        const Spin<D> spin = free_.spin[i] + spinChange;
        report.contactWork += 0.5 * impulse.dot(free_.velocity[i] + bodies_[k].velocity) +
                              0.5 * spinImpulse.dot(free_.spin[i] + spin);
        contactImpulse_[i] += impulse;
        contactSpinImpulse_[i] += spinImpulse;
        grains_.velocity[i] = bodies_[k].velocity;
        grains_.spin[i] = spin;
        grains_.position[i] += dt * bodies_[k].velocity;
        if (!displacements_.empty())
        {
            grains_.position[i] += dt * displacements_[k].velocity;
        }
        turn(grains_, i, dt);
    }
}

template <int D>
void ContactDynamics<D>::Implementation::moveWalls(double dt, StepReport& report)
{
    if (wallBodies_.empty())
    {
        return;
    }
    std::size_t k = grains_.size();
    for (WallBody<D>& wall : wallBodies_)
    {
        Vector<D> displacement = Vector<D>::Zero();
        if (isFree(wall))
        {
            const Vector<D>& velocity = bodies_[k].velocity;
            const Spin<D> spin = toSpin(bodies_[k].surfaceSpeed);
            const Vector<D> freeVelocity = wall.velocity + dt / wall.mass * wall.force;
            const Spin<D> freeSpin = wall.spin + dt * (data_.turning[k].inverse * wall.torque);
            report.contactWork +=
                0.5 * wall.mass * (velocity - freeVelocity).dot(freeVelocity + velocity) +
                0.5 * product(wall.orientation, wall.inertia, Spin<D>(spin - freeSpin), Spin<D>(freeSpin + spin));
            wall.velocity = velocity;
            wall.spin = spin;
            displacement = displacements_.empty() ? Vector<D>::Zero() : displacements_[k].velocity;
            ++k;
        }
        wall.position += dt * (wall.velocity + displacement);
        turn(wall, dt);
    }
    arrangement_.walls().place(initialWallBodies_, wallBodies_);
}

template <int D>
void ContactDynamics<D>::Implementation::carryWalls(double dt)
{
    for (WallBody<D>& wall : wallBodies_)
    {
        if (!isFree(wall))
        {
            wall.position += dt * wall.velocity;
            turn(wall, dt);
        }
    }
    arrangement_.walls().place(initialWallBodies_, wallBodies_);
}

template Body<2> ContactDynamics<2>::Implementation::freeBody(std::size_t) const;
template Body<3> ContactDynamics<3>::Implementation::freeBody(std::size_t) const;
template void ContactDynamics<2>::Implementation::carryWalls(double);
template void ContactDynamics<3>::Implementation::carryWalls(double);
template void ContactDynamics<2>::Implementation::advance(double, StepReport&);
template void ContactDynamics<3>::Implementation::advance(double, StepReport&);

}  // namespace nscd
