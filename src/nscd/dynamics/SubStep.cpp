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
    if (bounces_)
    {
        collide(dt, report);
    }
    makeBodies(dt);
    problem_.begin(impulses_, dt);
    problem_.choose(bodies_, impulses_);
    contactsOfOthers_.clear();
    report.detectionTime += watch.restart();

    schedule_->pass(bodies_, [&](int group) { problem_.applyImpulses(group, bodies_); });
    solves_ = 0;
    const bool converged = solve(dt, report);
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
void ContactDynamics<D>::Implementation::updateCandidates(double dt)
{
    double farthest = 0;
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        double way = (grains_.position[i] + dt * free_.velocity[i] - candidates_.positions()[i]).squaredNorm();
        if (grains_.shape[i] >= 0)
        {
            const double turn = turnBetween(grains_.orientation[i], candidates_.orientations()[i]);
            way = std::sqrt(way) + grains_.radius[i] * (turn + dt * free_.spin[i].norm());
            way *= way;
        }
        farthest = std::max(farthest, way);
    }
    if (!candidates_.cover(std::sqrt(farthest), wallDisplacement(dt)))
    {
        // For two steps and more, or for one if grains are so fast that pairs would become many
        const double way = dt * free_.largestSpeed;
        const double grains = std::min(4 * way, 2.2 * way + 0.2 * meanRadius_);
        const double skin = restSkin * meanRadius_ + std::max(grains, 2 * (way + dt * largestWallSpeed(dt)));
        rebuildCandidates(grains_.position, grains_.orientation, skin,
                          gatherImpulses(candidates_, impulses_, communicator_));
        candidateWalls_ = wallBodies_;
    }
    else
    {
        arrangement_.move(grains_.position, grains_.orientation, members_, candidates_);
    }
    if (lastSubStep_ > 0 && dt != lastSubStep_)
    {
        for (Impulse<D>& impulse : impulses_)
        {
            impulse.normal *= dt / lastSubStep_;
            impulse.tangential *= dt / lastSubStep_;
            impulse.rolling *= dt / lastSubStep_;
        }
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
double ContactDynamics<D>::Implementation::unevenness() const
{
    double largest = 1;
    const auto mass = [&](int body)
    {
        const bool isGrain = body < static_cast<int>(grains_.size());
        return isGrain ? grains_.mass[candidates_.order()[body]] : massOfFreeWall(body);
    };
    for (const Pair& pair : candidates_.pairs())
    {
        const int j = candidates_.secondBody(pair);
        if (j < candidates_.fixedBody())
        {
            const double ratio = mass(candidates_.body(pair.first)) / mass(j);
            largest = std::max({largest, ratio, 1 / ratio});
        }
    }
    return communicator_.max(largest);
}

template <int D>
double ContactDynamics<D>::Implementation::massOfFreeWall(int body) const
{
    int k = static_cast<int>(grains_.size());
    for (const WallBody<D>& wall : wallBodies_)
    {
        if (isFree(wall) && k++ == body)
        {
            return wall.mass;
        }
    }
    return 1;
}

template <int D>
void ContactDynamics<D>::Implementation::rebuildCandidates(const Vectors<D>& positions,
                                                           const Orientations<D>& orientations, double skin,
                                                           const std::vector<NamedImpulse<D>>& impulses)
{
    candidates_ = Candidates<D>({members_, arrangement_.walls(), freeBodyOfWall_, freeBodies(), skin, settings_.blocks,
                                 settings_.period, candidates_.work()},
                                positions, orientations, communicator_);
    schedule_ = std::make_unique<Schedule<D>>(candidates_, communicator_);
    impulses_ = matchImpulses(candidates_, impulses);
    arrangement_.arrange(grains_, members_, candidates_);
    arrangement_.surround(ambient_, members_, candidates_);
    unevenness_ = unevenness();
}

template <int D>
void ContactDynamics<D>::Implementation::makeBodies(double dt)
{
    bodies_.resize(grains_.size());
    data_.turning.resize(levered_ ? grains_.size() : 0);
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const int k = candidates_.place()[i];
        bodies_[k] = {free_.velocity[i], surfaceSpeed<D>(free_.spin[i], grains_.radius[i]), 1 / grains_.mass[i]};
        if (levered_)
        {
            data_.turning[k] = turningOf(grains_, static_cast<int>(i));
        }
    }
    for (const WallBody<D>& wall : wallBodies_)
    {
        if (isFree(wall))
        {
            const FreeWall<D> free(wall, dt);
            bodies_.push_back({free.velocity, surfaceSpeed<D>(free.spin, 1), 1 / wall.mass});
            data_.turning.push_back(free.turning);
        }
    }
    bodies_.push_back({Vector<D>::Zero(), zeroTangent<D>(), 0});
}

template <int D>
void ContactDynamics<D>::Implementation::move(double dt, StepReport& report)
{
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const int k = candidates_.place()[i];
        const Vector<D> impulse = grains_.mass[i] * (bodies_[k].velocity - free_.velocity[i]);
        const Spin<D> spinChange =
            toSpin(Tangent<D>(bodies_[k].surfaceSpeed - surfaceSpeed<D>(free_.spin[i], grains_.radius[i]))) /
            grains_.radius[i];
        const Spin<D> spinImpulse = angularMomentum<D>(grains_, i, spinChange);
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
        wall.orientation = turned(wall.orientation, wall.spin, dt);
    }
    arrangement_.walls().place(initialWallBodies_, wallBodies_);
}

template <int D>
double ContactDynamics<D>::Implementation::wallDisplacement(double dt) const
{
    double farthest = 0;
    for (std::size_t b = 0; b < wallBodies_.size(); ++b)
    {
        const WallBody<D>& wall = wallBodies_[b];
        const double turn = turnBetween(wall.orientation, candidateWalls_[b].orientation) + dt * wall.spin.norm();
        farthest = std::max(farthest, (wall.position + dt * wall.velocity - candidateWalls_[b].position).norm() +
                                          turn * wallExtent_[b]);
    }
    return farthest;
}

template <int D>
double ContactDynamics<D>::Implementation::largestWallSpeed(double dt) const
{
    double largest = 0;
    for (std::size_t b = 0; b < wallBodies_.size(); ++b)
    {
        const WallBody<D>& wall = wallBodies_[b];
        const Vector<D> velocity = wall.velocity + dt / wall.mass * wall.force;
        largest = std::max(largest, velocity.norm() + wall.spin.norm() * wallExtent_[b]);
    }
    return largest;
}

template void ContactDynamics<2>::Implementation::advance(double, StepReport&);
template void ContactDynamics<3>::Implementation::advance(double, StepReport&);
template double ContactDynamics<2>::Implementation::wallDisplacement(double) const;
template double ContactDynamics<3>::Implementation::wallDisplacement(double) const;
template double ContactDynamics<2>::Implementation::largestWallSpeed(double) const;
template double ContactDynamics<3>::Implementation::largestWallSpeed(double) const;
template void ContactDynamics<2>::Implementation::rebuildCandidates(const Vectors<2>&, const Orientations<2>&, double,
                                                                    const std::vector<NamedImpulse<2>>&);
template void ContactDynamics<3>::Implementation::rebuildCandidates(const Vectors<3>&, const Orientations<3>&, double,
                                                                    const std::vector<NamedImpulse<3>>&);

}  // namespace nscd
