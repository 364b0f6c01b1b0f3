// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// One sub-step of ContactDynamics: candidates, choice of contacts, sweeps, motion.

#include "nscd/Implementation.hpp"

namespace nscd
{

namespace
{

/// Sweeps after which the contacts not chosen are looked at for the first time; then at four times the number.
constexpr int firstLook = 4;

/// Share of the overlaps that a step removes when the impulses have not converged.  Moving grains of a deep pile
/// disturbs the force network; it must happen more slowly than the sweeps restore it.
constexpr double cautiousShare = 0.1;

template <int D>
Tangent<D> surfaceSpeed(const Spin<D>& spin, double radius)
{
    if constexpr (D == 2)
    {
        return radius * spin[0];
    }
    else
    {
        return radius * spin;
    }
}

template <int D>
Spin<D> toSpin(const Tangent<D>& t)
{
    if constexpr (D == 2)
    {
        return Spin<2>(t);
    }
    else
    {
        return t;
    }
}

}  // namespace

template <int D>
void ContactDynamics<D>::Implementation::advance(const FreeMotion& free, double dt, StepReport& report)
{
    Stopwatch watch;
    updateCandidates(free, dt);
    makeBodies(free);
    problem_.begin(impulses_, dt);
    problem_.choose(bodies_, impulses_);
    report.detectionTime += watch.restart();

    schedule_->pass(bodies_, [&](int group) { problem_.applyImpulses(group, bodies_); });
    const bool converged = solve(dt, report);
    problem_.store(impulses_);
    lastSubStep_ = dt;
    separate(dt, converged);
    move(free, dt);

    std::vector<double> counts{double(candidates_.pairs().size()), double(problem_.contacts()),
                               double(problem_.active())};
    communicator_.sum(counts);
    report.candidates = static_cast<std::size_t>(counts[0]);
    report.contacts = static_cast<std::size_t>(counts[1]);
    report.active = static_cast<std::size_t>(counts[2]);
    report.solutionTime += watch.seconds();
}

template <int D>
void ContactDynamics<D>::Implementation::updateCandidates(const FreeMotion& free, double dt)
{
    double farthest = 0;
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const Vector<D> end = grains_.position[i] + dt * free.velocity[i];
        farthest = std::max(farthest, (end - candidates_.positions()[i]).squaredNorm());
    }
    if (!candidates_.cover(std::sqrt(farthest)))
    {
        rebuildCandidates(grains_.position, restSkin * meanRadius_ + 2 * dt * free.largestSpeed,
                          gatherImpulses(candidates_, impulses_, communicator_));
    }
    else
    {
        arrangement_.move(grains_, candidates_.order());
    }
    if (lastSubStep_ > 0 && dt != lastSubStep_)
    {
        for (Impulse<D>& impulse : impulses_)
        {
            impulse.normal *= dt / lastSubStep_;
            impulse.tangential *= dt / lastSubStep_;
        }
    }
}

template <int D>
void ContactDynamics<D>::Implementation::rebuildCandidates(const Vectors<D>& positions, double skin,
                                                           const std::vector<NamedImpulse<D>>& impulses)
{
    candidates_ = Candidates<D>(positions, grains_.radius, arrangement_.walls(), skin, settings_.blocks, communicator_);
    schedule_ = std::make_unique<Schedule<D>>(candidates_, communicator_);
    impulses_ = matchImpulses(candidates_, impulses);
    arrangement_.arrange(grains_, candidates_.order());
}

template <int D>
void ContactDynamics<D>::Implementation::makeBodies(const FreeMotion& free)
{
    bodies_.clear();
    for (const int i : candidates_.order())
    {
        bodies_.push_back({free.velocity[i], surfaceSpeed<D>(free.spin[i], grains_.radius[i]), 1 / grains_.mass[i]});
    }
    bodies_.push_back({Vector<D>::Zero(), zeroTangent<D>(), 0});
}

template <int D>
bool ContactDynamics<D>::Implementation::solve(double dt, StepReport& report)
{
    const double tolerance = settings_.tolerance / dt;
    double worthLooking = tolerance;
    int nextLook = firstLook;
    double residual = 0;
    for (int sweeps = 1; sweeps <= settings_.maxSweeps; ++sweeps)
    {
        double change = 0;
        schedule_->pass(bodies_, [&](int group) { change = std::max(change, problem_.sweep(group, bodies_)); });
        change = std::sqrt(communicator_.max(change));
        ++report.sweeps;
        if (change > worthLooking && sweeps != nextLook && sweeps != settings_.maxSweeps)
        {
            continue;
        }
        worthLooking = std::min(worthLooking, change / 2);
        nextLook = sweeps < nextLook ? nextLook : 4 * nextLook;

        communicator_.share(bodies_, candidates_.rankBegin());
        residual = communicator_.max(problem_.residual(bodies_));
        if (residual <= tolerance)
        {
            break;
        }
        if (communicator_.max(problem_.incomplete()) > 0)
        {
            problem_.store(impulses_);
            problem_.choose(bodies_, impulses_);
        }
    }
    report.residual = std::max(report.residual, residual);
    report.converged = report.converged && residual <= tolerance;
    return residual <= tolerance;
}

template <int D>
void ContactDynamics<D>::Implementation::separate(double dt, bool converged)
{
    displacements_ = bodies_;
    for (Body<D>& body : displacements_)
    {
        body.velocity.setZero();
    }
    const double tolerance = settings_.tolerance / dt;
    if (communicator_.max(problem_.measureOverlaps(bodies_, converged ? 1 : cautiousShare)) <= tolerance)
    {
        return;
    }
    const int maxSweeps = std::max(1, settings_.maxSweeps / 4);
    for (int sweeps = 0; sweeps < maxSweeps; ++sweeps)
    {
        double change = 0;
        schedule_->pass(displacements_,
                        [&](int group) { change = std::max(change, problem_.separate(group, displacements_)); });
        if (std::sqrt(communicator_.max(change)) <= tolerance)
        {
            break;
        }
    }
    communicator_.share(displacements_, candidates_.rankBegin());
}

template <int D>
void ContactDynamics<D>::Implementation::move(const FreeMotion& free, double dt)
{
    for (std::size_t k = 0; k < grains_.size(); ++k)
    {
        const int i = candidates_.order()[k];
        const double m = grains_.mass[i];
        const double r = grains_.radius[i];
        const Spin<D> surfaceChange =
            toSpin<D>(bodies_[k].surfaceSpeed - surfaceSpeed<D>(free.spin[i], r));
        contactImpulse_[i] += m * (bodies_[k].velocity - free.velocity[i]);
        contactSpinImpulse_[i] += inertiaFactor<D> * m * r * surfaceChange;
        grains_.velocity[i] = bodies_[k].velocity;
        grains_.spin[i] = free.spin[i] + surfaceChange / r;
        grains_.position[i] += dt * (bodies_[k].velocity + displacements_[k].velocity);
    }
}

template class ContactDynamics<2>::Implementation;
template class ContactDynamics<3>::Implementation;

}  // namespace nscd
