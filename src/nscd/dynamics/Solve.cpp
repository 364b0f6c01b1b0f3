// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactDynamics' passes over the contact problem until its residual is small, and those that remove overlaps.

#include "nscd/dynamics/Implementation.hpp"

#include <numeric>

namespace nscd
{

namespace
{

/// Share of the overlaps, up to a part of the smaller radius, that a step removes when the impulses have not converged,
/// where there were no impacts.  Moving grains of a deep pile disturbs the force network; it must happen more slowly
/// than the sweeps restore it.  What is deeper comes of grains that fall, and would become deeper.
constexpr double cautiousShare = 0.1, shallow = 0.01, anyDepth = std::numeric_limits<double>::infinity();

/// Displacements that remove deep overlaps have not been found if their residual is above this part of the worst one,
/// as in a bed that is pressed as a whole, or where heavy grains lie on light ones: to ask for much makes it worse.
/// They will not be if it is above the second part after a quarter of the sweeps.
constexpr double notFound = 0.2, hopeless = 0.5;

/// Sweeps after which the contacts not chosen are looked at for the first time; then at four times the number.
constexpr int firstLook = 4;

/// Part of the tolerance below which the work queue lets changes wait.
constexpr double waitingShare = 0.3;

/// Part of the sweeps after which momentum is given up: friction has no potential, and the last digits are those of
/// plain sweeps.
constexpr double momentumUntil = 0.75;

/// Sweeps from which on Anderson's acceleration mixes, and those at the end that it leaves to plain sweeps
/// (doc/theory, eq. 5.18).
constexpr int firstMixing = 6, lastPlain = 2;

/// The sequence of factors of Nesterov's method, started anew when a pass changes more than the one before
/// (doc/theory, eq. 5.17).
class Momentum
{
public:
    /// Factor after a pass that changed this much.
    double next(double change)
    {
        if (change > last_)
        {
            restart();
            return 0;
        }
        last_ = change;
        const double theta = 0.5 * (1 + std::sqrt(1 + 4 * theta_ * theta_));
        const double factor = (theta_ - 1) / theta;
        theta_ = theta;
        return factor;
    }

    void restart()
    {
        theta_ = 1;
        last_ = std::numeric_limits<double>::infinity();
    }

private:
    double theta_ = 1;
    double last_ = std::numeric_limits<double>::infinity();
};

}  // namespace

template <int D>
Change ContactDynamics<D>::Implementation::pass(double tolerance)
{
    std::vector<double> sums(candidates_.blocks(), 0.0);
    Change total;
    schedule_->pass(bodies_,
                    [&](int group)
                    {
                        const Change change = settings_.solver == Solver::queue
                                                  ? problem_.workQueue(group, bodies_, waitingShare * tolerance)
                                                  : problem_.sweep(group, bodies_);
                        sums[candidates_.groups()[group].first] += change.sum;
                        total.solves += change.solves;
                        total.largest = std::max(total.largest, change.largest);
                    });
    total.largest = communicator_.max(total.largest);
    if (settings_.solver == Solver::nesterov)
    {
        communicator_.sum(sums);
        total.sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    }
    return total;
}

template <int D>
bool ContactDynamics<D>::Implementation::solve(double dt, StepReport& report)
{
    const double tolerance = settings_.tolerance / dt;
    double worthLooking = tolerance;
    int nextLook = firstLook;
    double residual = 0;
    Momentum momentum;
    const bool accelerated = settings_.solver == Solver::nesterov;
    const std::vector<std::size_t>& own = candidates_.rankBegin();
    const int rank = communicator_.rank();
    if (accelerated)
    {
        problem_.remember(bodies_);
    }
    Anderson anderson(communicator_, candidates_.blocks());
    Unknowns before, swept;
    for (int sweeps = 1; sweeps <= settings_.maxSweeps; ++sweeps)
    {
        const bool mixes = isUneven() && sweeps >= firstMixing && sweeps < settings_.maxSweeps - lastPlain;
        if (mixes)
        {
            problem_.get(before, bodies_, false, own[rank], own[rank + 1]);
        }
        const Change done = pass(tolerance);
        const double change = std::sqrt(done.largest);
        solves_ += done.solves;
        ++report.sweeps;
        if (change <= worthLooking || sweeps == nextLook || sweeps == settings_.maxSweeps)
        {
            worthLooking = std::min(worthLooking, change / 2);
            nextLook = sweeps < nextLook ? nextLook : 4 * nextLook;

            schedule_->refresh(bodies_);
            residual = communicator_.max(problem_.residual(bodies_));
            if (residual <= tolerance)
            {
                break;
            }
            if (communicator_.max(problem_.incomplete()) > 0)
            {
                if (impulsesOfStart_.empty())
                {
                    impulsesOfStart_ = impulses_;
                }
                problem_.store(impulses_);
                problem_.choose(bodies_, impulses_);
                anderson.restart();
                if (accelerated)
                {
                    momentum.restart();
                    problem_.remember(bodies_);
                }
                continue;
            }
        }
        if (mixes)
        {
            problem_.get(swept, bodies_, false, own[rank], own[rank + 1]);
            anderson.mix(before.values, swept.values, swept.weights, swept.ranges);
            problem_.set(swept, bodies_, false, own[rank], own[rank + 1]);
        }
        if (accelerated && sweeps < momentumUntil * settings_.maxSweeps)
        {
            problem_.extrapolate(momentum.next(done.sum), bodies_, own[rank], own[rank + 1]);
        }
    }
    communicator_.share(bodies_, own);
    report.residual = std::max(report.residual, residual);
    report.converged = report.converged && residual <= tolerance;
    return residual <= tolerance;
}

template <int D>
bool ContactDynamics<D>::Implementation::separate(double dt, bool converged, StepReport& report)
{
    displacements_.clear();
    const double tolerance = settings_.tolerance / dt;
    const double share = converged ? 1 : cautiousShare;
    Depths depths = problem_.measureOverlaps(bodies_, share, shallow);
    const double worst = communicator_.max(depths.worst);
    if (worst <= tolerance)
    {
        return true;
    }
    const bool isDeep = communicator_.max(depths.deep) > 0;
    const bool isUrgent = isUneven() || !data_.ahead.empty();
    const int maxSweeps = isDeep || isUrgent ? settings_.maxSweeps : std::max(1, settings_.maxSweeps / 4);
    double residual = moveApart(true, maxSweeps, tolerance, isDeep && !isUrgent ? hopeless * worst : anyDepth);
    if (residual > (isDeep ? notFound : 1) * worst)
    {
        // Acceleration goes off where there are more grains than room
        depths = problem_.measureOverlaps(bodies_, share, anyDepth);
        residual = moveApart(false, maxSweeps, tolerance);
    }
    communicator_.share(displacements_, candidates_.rankBegin());
    report.leftOverlap = std::max(report.leftOverlap, dt * (residual + communicator_.max(depths.spared)));
    return residual <= tolerance;
}

template <int D>
double ContactDynamics<D>::Implementation::moveApart(bool accelerated, int maxSweeps, double tolerance, double limit)
{
    displacements_ = bodies_;
    for (Body<D>& body : displacements_)
    {
        body.velocity.setZero();
    }
    const std::size_t begin = candidates_.rankBegin()[communicator_.rank()];
    const std::size_t end = candidates_.rankBegin()[communicator_.rank() + 1];
    Anderson anderson(communicator_, candidates_.blocks());
    Unknowns before, swept;
    double residual = 0;
    for (int sweeps = 1; sweeps <= maxSweeps; ++sweeps)
    {
        const bool mixes = accelerated && sweeps >= firstMixing && sweeps < maxSweeps - lastPlain;
        if (mixes)
        {
            problem_.get(before, displacements_, true, begin, end);
        }
        double change = 0;
        schedule_->pass(displacements_,
                        [&](int group) { change = std::max(change, problem_.separate(group, displacements_)); });
        const bool isQuarter = std::isfinite(limit) && sweeps == (maxSweeps + 3) / 4;
        const bool isTimeToLook = isQuarter || sweeps == (maxSweeps + 1) / 2 || sweeps == maxSweeps;
        if (std::sqrt(communicator_.max(change)) <= tolerance || isTimeToLook)
        {
            schedule_->refresh(displacements_);
            const double pushed = communicator_.max(problem_.addPushed(bodies_, displacements_));
            residual = communicator_.max(problem_.separationResidual(displacements_));
            if (residual <= tolerance || (isQuarter && residual > limit))
            {
                break;
            }
            if (pushed > 0)
            {
                anderson.restart();
                continue;
            }
        }
        if (mixes)
        {
            problem_.get(swept, displacements_, true, begin, end);
            anderson.mix(before.values, swept.values, swept.weights, swept.ranges);
            problem_.set(swept, displacements_, true, begin, end);
        }
    }
    return residual;
}

template Change ContactDynamics<2>::Implementation::pass(double);
template Change ContactDynamics<3>::Implementation::pass(double);
template bool ContactDynamics<2>::Implementation::solve(double, StepReport&);
template bool ContactDynamics<3>::Implementation::solve(double, StepReport&);
template bool ContactDynamics<2>::Implementation::separate(double, bool, StepReport&);
template bool ContactDynamics<3>::Implementation::separate(double, bool, StepReport&);

}  // namespace nscd
