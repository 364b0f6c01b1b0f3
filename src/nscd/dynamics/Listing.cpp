// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// When ContactDynamics lists its candidates anew, and how far around each grain.

#include "nscd/dynamics/Implementation.hpp"
#include "nscd/dynamics/RigidMotion.hpp"
#include "nscd/search/LargestNear.hpp"

namespace nscd
{

namespace
{

/// What a reach may be over the way in a sub-step of the fastest grain near one, besides the reach at rest.
constexpr double foresights[] = {1.05, 2.1, 4.2, 8.4};

/// What the pairs of a list cost in each sub-step and when it is made, over the part of a list that is the same for
/// any number of them; per grain and volume that its reach covers over its own (bench/README, "Lists").
constexpr double costOfPairs = 0.5, costOfPairsInList = 0.4;

/// Grains and walls that have gone further than was foreseen get this many times as far.
constexpr double generosity = 1.5;

/// Radii beyond the reach from which on a way is that of a solution gone wrong, which the next step reports: grains
/// move by a radius in a sub-step.
constexpr double thrown = 10;

}  // namespace

template <int D>
Reach ContactDynamics<D>::Implementation::reachAtRest() const
{
    const double reach = restReach * meanRadius_;
    return {std::vector<double>(grains_.size(), reach), wallBodies_.empty() ? 0 : reach};
}

template <int D>
Reach ContactDynamics<D>::Implementation::reachOfMotion(double dt) const
{
    std::vector<double> way(grains_.size());
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        way[i] = dt * freeSpeed(i);
    }
    // A grain may be hit, and get the velocity of one that comes
    way = largestNear<D>(grains_.position, way, 2 * largestRadius_ + dt * free_.largestSpeed);

    const double foresight = cheapestForesight(way);
    Reach reach = reachAtRest();
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        reach.ofGrain[i] += foresight * way[i];
    }
    reach.ofWalls += 2 * foresight * dt * largestWallSpeed(dt);
    return reach;
}

template <int D>
double ContactDynamics<D>::Implementation::cheapestForesight(const std::vector<double>& way) const
{
    const double atRest = restReach * meanRadius_;
    const double farthest = way.empty() ? 0 : *std::max_element(way.begin(), way.end());
    double best = foresights[0], least = std::numeric_limits<double>::infinity();
    for (const double foresight : foresights)
    {
        double pairs = 0;
        for (const double w : way)
        {
            const double size = 1 + (atRest + foresight * w) / meanRadius_;
            pairs += (D == 2 ? size * size : size * size * size) / static_cast<double>(way.size());
        }
        const double steps = foresight + (farthest > 0 ? atRest / farthest : 0);
        const double cost = costOfPairs * pairs + (1 + costOfPairsInList * pairs) / steps;
        if (cost < least)
        {
            least = cost;
            best = foresight;
        }
    }
    return best;
}

template <int D>
double ContactDynamics<D>::Implementation::wayOfGrain(std::size_t i, const Vector<D>& onwards, double turning) const
{
    const double way = (grains_.position[i] + onwards - candidates_.positions()[i]).norm();
    return grains_.shape[i] < 0 ? way
                                : way + turning +
                                      grains_.radius[i] *
                                          turnBetween(grains_.orientation[i], candidates_.orientations()[i]);
}

template <int D>
double ContactDynamics<D>::Implementation::wayOfWall(std::size_t b, const Vector<D>& onwards, double angle) const
{
    const WallBody<D>&now = wallBodies_[b], &listed = candidateWalls_[b];
    return (now.position + onwards - listed.position).norm() +
           (turnBetween(now.orientation, listed.orientation) + angle) * wallExtent_[b];
}

template <int D>
bool ContactDynamics<D>::Implementation::extend(double& reach, double way) const
{
    const bool tooFar = way > reach && way < reach + thrown * largestRadius_;
    reach = tooFar ? restReach * meanRadius_ + generosity * way : reach;
    return tooFar;
}

template <int D>
void ContactDynamics<D>::Implementation::updateCandidates(double dt)
{
    const Reach& reach = candidates_.reach();
    bool covered = wayOfWalls(dt) <= reach.ofWalls;
    for (std::size_t i = 0; covered && i < grains_.size(); ++i)
    {
        const double turning = dt * grains_.radius[i] * free_.spin[i].norm();
        covered = wayOfGrain(i, dt * free_.velocity[i], turning) <= reach.ofGrain[i];
    }
    if (covered)
    {
        arrangement_.move(grains_.position, grains_.orientation, members_, candidates_);
    }
    else
    {
        listAnew(reachOfMotion(dt));
    }
    if (lastSubStep_ > 0 && dt != lastSubStep_)
    {
        for (Impulse<D>& impulse : impulses_)
        {
            impulse.normal *= dt / lastSubStep_;
            impulse.tangential *= dt / lastSubStep_;
            impulse.rolling *= dt / lastSubStep_;
            impulse.attraction *= dt / lastSubStep_;
        }
    }
}

template <int D>
bool ContactDynamics<D>::Implementation::motionIsCovered(double dt, Reach& wanted) const
{
    wanted = candidates_.reach();
    bool covered = true;
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const Body<D>& body = bodies_[candidates_.place()[i]];
        const double turning = dt * std::sqrt(squaredNorm(body.surfaceSpeed));
        covered = !extend(wanted.ofGrain[i], wayOfGrain(i, dt * body.velocity, turning)) && covered;
    }
    std::size_t k = grains_.size();
    for (std::size_t b = 0; b < wallBodies_.size(); ++b)
    {
        if (isFree(wallBodies_[b]))
        {
            const Body<D>& body = bodies_[k++];
            const double angle = dt * std::sqrt(squaredNorm(body.surfaceSpeed));
            covered = !extend(wanted.ofWalls, wayOfWall(b, dt * body.velocity, angle)) && covered;
        }
    }
    return covered;
}

template <int D>
void ContactDynamics<D>::Implementation::listAnew(const Reach& reach)
{
    listAnew(reach, gatherImpulses(candidates_, impulses_, communicator_));
}

template <int D>
void ContactDynamics<D>::Implementation::listAnew(const Reach& reach, const std::vector<NamedImpulse<D>>& impulses)
{
    rebuildCandidates(grains_.position, grains_.orientation, reach, impulses);
    candidateWalls_ = wallBodies_;
}

template <int D>
void ContactDynamics<D>::Implementation::rebuildCandidates(const Vectors<D>& positions,
                                                           const Orientations<D>& orientations, const Reach& reach,
                                                           const std::vector<NamedImpulse<D>>& impulses)
{
    candidates_ = Candidates<D>({members_, arrangement_.walls(), freeBodyOfWall_, freeBodies(), reach, settings_.blocks,
                                 settings_.period, candidates_.work()},
                                positions, orientations, communicator_);
    schedule_ = std::make_unique<Schedule<D>>(candidates_, communicator_);
    impulses_ = matchImpulses(candidates_, impulses);
    arrangement_.arrange(grains_, members_, candidates_);
    arrangement_.surround(ambient_, members_, candidates_);
    unevenness_ = unevenness();
}

template <int D>
double ContactDynamics<D>::Implementation::wayOfWalls(double dt) const
{
    double farthest = 0;
    for (std::size_t b = 0; b < wallBodies_.size(); ++b)
    {
        farthest = std::max(farthest, wayOfWall(b, dt * wallBodies_[b].velocity, dt * wallBodies_[b].spin.norm()));
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

template Reach ContactDynamics<2>::Implementation::reachAtRest() const;
template Reach ContactDynamics<3>::Implementation::reachAtRest() const;
template double ContactDynamics<2>::Implementation::wayOfWall(std::size_t, const Vector<2>&, double) const;
template double ContactDynamics<3>::Implementation::wayOfWall(std::size_t, const Vector<3>&, double) const;
template bool ContactDynamics<2>::Implementation::extend(double&, double) const;
template bool ContactDynamics<3>::Implementation::extend(double&, double) const;
template void ContactDynamics<2>::Implementation::updateCandidates(double);
template void ContactDynamics<3>::Implementation::updateCandidates(double);
template bool ContactDynamics<2>::Implementation::motionIsCovered(double, Reach&) const;
template bool ContactDynamics<3>::Implementation::motionIsCovered(double, Reach&) const;
template void ContactDynamics<2>::Implementation::listAnew(const Reach&);
template void ContactDynamics<3>::Implementation::listAnew(const Reach&);
template void ContactDynamics<2>::Implementation::listAnew(const Reach&, const std::vector<NamedImpulse<2>>&);
template void ContactDynamics<3>::Implementation::listAnew(const Reach&, const std::vector<NamedImpulse<3>>&);
template double ContactDynamics<2>::Implementation::wayOfWalls(double) const;
template double ContactDynamics<3>::Implementation::wayOfWalls(double) const;
template double ContactDynamics<2>::Implementation::largestWallSpeed(double) const;
template double ContactDynamics<3>::Implementation::largestWallSpeed(double) const;
template void ContactDynamics<2>::Implementation::rebuildCandidates(const Vectors<2>&, const Orientations<2>&,
                                                                    const Reach&,
                                                                    const std::vector<NamedImpulse<2>>&);
template void ContactDynamics<3>::Implementation::rebuildCandidates(const Vectors<3>&, const Orientations<3>&,
                                                                    const Reach&,
                                                                    const std::vector<NamedImpulse<3>>&);

}  // namespace nscd
