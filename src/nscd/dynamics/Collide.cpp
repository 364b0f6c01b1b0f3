// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactDynamics' impacts within a sub-step: the flights from impact to impact, before the contact problem.

#include "nscd/dynamics/Implementation.hpp"
#include "nscd/dynamics/RigidMotion.hpp"

#include <numeric>

namespace nscd
{

namespace
{

/// The time is cut into windows, so that blocks see each other's impacts in about their order; and a window ends after
/// some passes over the blocks, though an endless number of impacts may not have ended (inelastic collapse).
constexpr int windows = 2, mostPasses = 20;

/// If a body becomes faster than the fastest one was by this factor, what they may meet is listed anew.
constexpr double faster = 1.25;

template <int D>
Vector<D> meanVelocity(const std::vector<Flyer<D>>& flyers)
{
    Vector<D> sum = Vector<D>::Zero();
    for (const Flyer<D>& flyer : flyers)
    {
        sum += flyer.body.velocity;
    }
    return sum / static_cast<double>(flyers.size());
}

/// Largest speed, surfaces included, against the usual velocity [m/s].
template <int D>
double largestSpeed(const std::vector<Flyer<D>>& flyers, const std::vector<Launch<D>>& launches,
                    const Vector<D>& usual)
{
    double largest = 0;
    for (std::size_t k = 0; k + 1 < launches.size(); ++k)   // the last is fixed
    {
        const Body<D>& body = flyers[k].body;
        const double turning = launches[k].round ? 0 : std::sqrt(squaredNorm(body.surfaceSpeed));
        largest = std::max(largest, (body.velocity - usual).norm() + turning);
    }
    return largest;
}

}  // namespace

template <int D>
void ContactDynamics<D>::Implementation::launch(double dt)
{
    flyers_.assign(candidates_.fixedBody() + 1, {});
    launches_.assign(candidates_.fixedBody() + 1, {});
    data_.turning.resize(levered_ ? grains_.size() : 0);
    data_.inertia.assign(data_.turning.size(), Spin<D>::Zero());
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const int k = candidates_.place()[i];
        flyers_[k].body = freeBody(i);
        launches_[k].push = free_.velocity[i] - grains_.velocity[i];
        launches_[k].drift = grains_.position[i] - candidates_.positions()[i];
        launches_[k].viscosity = viscosity_.empty() ? 0 : viscosity_[i];
        launches_[k].round = grains_.shape[i] < 0;
        if (!launches_[k].round)
        {
            launches_[k].turned =
                grains_.radius[i] * turnBetween(grains_.orientation[i], candidates_.orientations()[i]);
            flyers_[k].orientation = grains_.orientation[i];
            data_.inertia[k] = heavinessOfTurning(i) * grains_.mass[i] * shapeInertia(grains_, i);
        }
        if (levered_)
        {
            data_.turning[k] = turningOf(grains_, i, heavinessOfTurning(i));
        }
    }
    std::size_t k = grains_.size();
    for (std::size_t b = 0; b < wallBodies_.size(); ++b)
    {
        const WallBody<D>& wall = wallBodies_[b];
        if (isFree(wall))
        {
            const FreeWall<D> free(wall, dt);
            flyers_[k].body = {free.velocity, surfaceSpeed<D>(free.spin, 1), 1 / wall.mass, 0};
            flyers_[k].orientation = wall.orientation;
            launches_[k].push = free.velocity - wall.velocity;
            launches_[k].drift = wall.position - candidateWalls_[b].position;
            data_.turning.push_back(free.turning);
            data_.inertia.push_back(wall.inertia);
            ++k;
        }
    }
    flyers_[k].body = {Vector<D>::Zero(), zeroTangent<D>(), 0, 0};
}

template <int D>
bool ContactDynamics<D>::Implementation::fly(double dt)
{
    double known = 0, fastest = 0;
    do
    {
        launch(dt);
        const Vector<D> usual = meanVelocity(flyers_);
        known = faster * std::max(fastest, largestSpeed<D>(flyers_, launches_, usual));
        const bool any = impacts_.begin(flyers_, launches_, impulses_, dt, settings_.tolerance / dt, usual, known);
        if (communicator_.max(any) == 0)
        {
            return false;
        }
        for (int window = 1; window <= windows; ++window)
        {
            passWindow(window * dt / windows);
        }
        flyers_.resize(candidates_.fixedBody() + 1);
        communicator_.share(flyers_, candidates_.rankBegin());
        fastest = largestSpeed<D>(flyers_, launches_, usual);
    } while (fastest > known);
    return true;
}

template <int D>
void ContactDynamics<D>::Implementation::passWindow(double until)
{
    bool some = true;
    for (int pass = 0; some && pass < mostPasses; ++pass)
    {
        const std::size_t before = impacts_.count();
        schedule_->pass(flyers_, [&](int group) { impacts_.work(group, flyers_, until); });
        some = communicator_.max(impacts_.count() > before) > 0;
    }
}

template <int D>
bool ContactDynamics<D>::Implementation::flightsAreCovered(double dt, Reach& wanted) const
{
    wanted = candidates_.reach();
    bool covered = true;
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const int k = candidates_.place()[i];
        const Flyer<D>& f = flyers_[k];
        const double farthest = std::max(f.farthest, way(f, f.body, launches_[k], dt));
        covered = !extend(wanted.ofGrain[i], farthest) && covered;
    }
    std::size_t k = grains_.size();
    for (std::size_t b = 0; b < wallBodies_.size(); ++b)
    {
        const WallBody<D>& wall = wallBodies_[b];
        if (isFree(wall))
        {
            const Flyer<D>& f = flyers_[k];
            const double turn = turnBetween(wall.orientation, candidateWalls_[b].orientation) +
                                std::sqrt(squaredNorm(Tangent<D>(f.turned + dt * f.body.surfaceSpeed)));
            const double farthest =
                std::max(f.farthest, way(f, f.body, launches_[k], dt)) + turn * wallExtent_[b];
            covered = !extend(wanted.ofWalls, farthest) && covered;
            ++k;
        }
    }
    return !extend(wanted.ofWalls, wayOfWalls(dt)) && covered;
}

template <int D>
void ContactDynamics<D>::Implementation::collide(double dt, StepReport& report)
{
    data_.flight.clear();
    data_.ahead.clear();
    Reach wanted;
    bool any = fly(dt);
    while (any && !flightsAreCovered(dt, wanted))
    {
        listAnew(wanted);
        any = fly(dt);
    }
    if (!any)
    {
        impacts_.clear();
    }
    else
    {
        impacts_.collectImpulses();
        land(dt);
        placeAtEnds(dt);
    }
    data_.flight.resize(candidates_.fixedBody() + 1);
    for (std::size_t k = 0; k < data_.flight.size(); ++k)
    {
        data_.flight[k] = flyers_[k].body;
    }

    std::vector<double> sums = impacts_.energy();
    sums.push_back(static_cast<double>(impacts_.count()));
    sums.push_back(static_cast<double>(impacts_.exhausted()));
    communicator_.sum(sums);
    report.contactWork += std::accumulate(sums.begin(), sums.end() - 2, 0.0);
    report.impacts += static_cast<std::size_t>(sums.end()[-2]);
    report.exhausted += static_cast<std::size_t>(sums.back());
}

template <int D>
void ContactDynamics<D>::Implementation::land(double dt)
{
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        Flyer<D>& f = flyers_[candidates_.place()[i]];
        if (f.impacts == 0)
        {
            continue;
        }
        const double r = grains_.radius[i];
        const Vector<D> change = f.body.velocity - free_.velocity[i];
        contactImpulse_[i] += heaviness_[i] * grains_.mass[i] * change;
        free_.velocity[i] = f.body.velocity;
        grains_.position[i] += f.offset;
        if (grains_.shape[i] < 0)
        {
            const Spin<D> spinChange =
                toSpin(Tangent<D>(f.body.surfaceSpeed - surfaceSpeed<D>(free_.spin[i], r))) / r;
            contactSpinImpulse_[i] += angularMomentum<D>(grains_, i, spinChange);
            free_.spin[i] += spinChange;
            grains_.orientation[i] = turned(grains_.orientation[i], Spin<D>(toSpin(f.turned) / r), 1);
        }
        else
        {
            const Spin<D> before = angularMomentum<D>(grains_, i, free_.spin[i]);
            free_.spin[i] = toSpin(f.body.surfaceSpeed) / r;
            grains_.orientation[i] = f.orientation;
            turn(grains_.orientation[i], free_.spin[i], shapeInertia(grains_, i), -f.since);
            contactSpinImpulse_[i] +=
                heavinessOfTurning(i) * (angularMomentum<D>(grains_, i, free_.spin[i]) - before);
            f.body.surfaceSpeed = surfaceSpeed<D>(free_.spin[i], r);
        }
    }
    std::size_t k = grains_.size();
    for (WallBody<D>& wall : wallBodies_)
    {
        if (isFree(wall))
        {
            Flyer<D>& f = flyers_[k++];
            if (f.impacts > 0)
            {
                Spin<D> spin = toSpin(f.body.surfaceSpeed);
                wall.orientation = f.orientation;
                turn(wall.orientation, spin, wall.inertia, -f.since);
                f.body.surfaceSpeed = toTangent(spin);
                const FreeWall<D> free(wall, dt);
                wall.velocity += f.body.velocity - free.velocity;
                wall.spin += spin - free.spin;
                wall.position += f.offset;
            }
        }
    }
}

template <int D>
void ContactDynamics<D>::Implementation::placeAtEnds(double dt)
{
    data_.ahead.assign(candidates_.fixedBody() + 1, {Vector<D>::Zero(), zeroTangent<D>(), 0, 0});
    Vectors<D> positions = grains_.position;
    Orientations<D> orientations = grains_.orientation;
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const int k = candidates_.place()[i];
        if (flyers_[k].impacts > 0)
        {
            data_.ahead[k] = flyers_[k].body;
            positions[i] += dt * free_.velocity[i];
            if (grains_.shape[i] >= 0)
            {
                Spin<D> spin = free_.spin[i];
                turn(orientations[i], spin, shapeInertia(grains_, i), dt);
            }
        }
    }
    arrangement_.move(positions, orientations, members_, candidates_);

    std::vector<WallBody<D>> walls = wallBodies_;
    bool wallsHit = false;
    std::size_t k = grains_.size();
    for (WallBody<D>& wall : walls)
    {
        if (isFree(wall))
        {
            if (flyers_[k].impacts > 0)
            {
                data_.ahead[k] = flyers_[k].body;
                wall.position += dt * flyers_[k].body.velocity;
                wall.spin = toSpin(flyers_[k].body.surfaceSpeed);
                turn(wall, dt);
                wallsHit = true;
            }
            ++k;
        }
    }
    if (wallsHit)
    {
        arrangement_.walls().place(initialWallBodies_, walls);
    }
}

template void ContactDynamics<2>::Implementation::collide(double, StepReport&);
template void ContactDynamics<3>::Implementation::collide(double, StepReport&);

}  // namespace nscd
