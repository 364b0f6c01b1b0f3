// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Small random scenes: nothing that the constructor accepts may yield a number that is not finite, an endless loop,
// momentum or energy from nowhere, or a restart that goes on differently.
//
//     fuzz [seed] [steps]
//
// Scene k of a run has the seed 'seed' + k: what fails is repeated by 'fuzz <its seed> 1'.

#include "RandomScene.hpp"

#include <algorithm>
#include <cfenv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace
{

std::uint64_t seedNow = 0;
constexpr unsigned patience = 120;   ///< that a scene may take, with sanitizers [s]

[[noreturn]] void die(int signal)
{
    std::fprintf(stderr, "seed %llu: %s\n", static_cast<unsigned long long>(seedNow),
                 signal == SIGALRM ? "hangs" : signal == SIGFPE ? "floating-point exception" : "crash");
    std::_Exit(1);
}

struct Failure : std::logic_error
{
    using std::logic_error::logic_error;
};

void require(bool fact, const std::string& what)
{
    if (!fact)
    {
        throw Failure(what);
    }
}

std::string text(double value)
{
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.3g", value);
    return digits;
}

template <int D>
bool isFinite(const nscd::ContactDynamics<D>& dynamics)
{
    const nscd::Grains<D>& grains = dynamics.grains();
    bool finite = true;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        finite = finite && grains.position[i].allFinite() && grains.velocity[i].allFinite() &&
                 grains.spin[i].allFinite() && grains.orientation[i].toRotationMatrix().allFinite() &&
                 dynamics.contactImpulse()[i].allFinite() && dynamics.contactSpinImpulse()[i].allFinite();
    }
    for (const auto& wall : dynamics.wallBodies())
    {
        finite = finite && wall.position.allFinite() && wall.velocity.allFinite() && wall.spin.allFinite();
    }
    return finite;
}

/// One scene and its history.
template <int D>
class Trial
{
public:
    explicit Trial(std::uint64_t seed) : draw_(seed + (std::uint64_t(1) << 40)), random_(seed) {}

    /// Returns the number of steps.
    int run();

    std::string describe() const { return random_.describe(); }

private:
    void step(nscd::ContactDynamics<D>& dynamics);
    void checkMomentum(const nscd::ContactDynamics<D>& dynamics, const nscd::Grains<D>& before) const;
    void checkEnergy(const nscd::ContactDynamics<D>& dynamics, const nscd::Grains<D>& before,
                     const std::vector<nscd::WallBody<D>>& wallsBefore, const nscd::StepReport& report);
    void checkOverlap(const nscd::ContactDynamics<D>& dynamics, double before, const nscd::StepReport& report) const;
    void restart(const nscd::ContactDynamics<D>& dynamics);
    void checkEnd(const std::string& error, double overlapBefore) const;

    Draw draw_;
    RandomScene<D> random_;
    double largestEnergy_ = 0;
    std::vector<nscd::ContactDynamics<D>> continued_;   ///< none or one, from a file
};

template <int D>
int Trial<D>::run()
{
    auto dynamics = random_.dynamics();
    const int steps = draw_.pick({5, 20, 100});
    const int restarted = draw_.below(2 * steps);
    for (int i = 0; i < steps; ++i)
    {
        if (i == restarted)
        {
            restart(dynamics);
        }
        std::vector<nscd::ContactDynamics<D>*> all{&dynamics};
        if (!continued_.empty())
        {
            all.push_back(&continued_[0]);
        }
        random_.act(all);
        const double overlapBefore = dynamics.worstOverlap();
        try
        {
            step(dynamics);
        }
        catch (const std::runtime_error& error)
        {
            checkEnd(error.what(), overlapBefore);
            return i + 1;
        }
        if (!continued_.empty())
        {
            continued_[0].step(random_.force, random_.torque, random_.dt);
            require(sameBits(dynamics, continued_[0]), "differs after a restart");
        }
    }
    return steps;
}

/// A grain may be pressed through a wall where grains were drawn onto each other or onto walls, or where the sweeps
/// leave contacts unsolved; not in a step that is solved and begins without deep overlaps.
template <int D>
void Trial<D>::checkEnd(const std::string& error, double overlapBefore) const
{
    if (error.find("too far for sub-steps") != std::string::npos)
    {
        return;
    }
    const std::string ofResidual = "the contacts' residual ";
    const auto at = error.find(ofResidual);
    require(error.find("pressed through wall") != std::string::npos && at != std::string::npos, error);
    const double unsolved = random_.dt * std::strtod(error.c_str() + at + ofResidual.size(), nullptr);
    const std::vector<double>& radius = random_.scene.grains.radius;
    // Members of clusters are down to a fifth of the cluster
    const double deep = (random_.hasClusters() ? 0.02 : 0.1) * *std::min_element(radius.begin(), radius.end());
    require(overlapBefore > deep || unsolved > deep, error + "; unsolved " + text(unsolved));
}

template <int D>
void Trial<D>::restart(const nscd::ContactDynamics<D>& dynamics)
{
    const std::string file = "fuzz_" + std::to_string(::getpid()) + ".h5";
    dynamics.save(file, 1);
    RandomScene<D> other = random_;
    other.bodies = dynamics.wallBodies();   // with their present loads; where they started is not theirs to change
    for (std::size_t b = 0; b < other.bodies.size(); ++b)
    {
        other.bodies[b].position = random_.bodies[b].position;
        other.bodies[b].orientation = random_.bodies[b].orientation;
    }
    continued_.push_back(other.dynamics());
    continued_[0].load(file);
    std::remove(file.c_str());
    require(sameBits(dynamics, continued_[0]), "a loaded state is not what was saved");
    continued_[0].contacts();
}

template <int D>
void Trial<D>::step(nscd::ContactDynamics<D>& dynamics)
{
    const nscd::Grains<D> before = dynamics.grains();
    const std::vector<nscd::WallBody<D>> wallsBefore = dynamics.wallBodies();
    const double overlapBefore = dynamics.worstOverlap();
    const nscd::StepReport report = dynamics.step(random_.force, random_.torque, random_.dt);
    require(isFinite(dynamics), "a value is not finite");
    require(std::isfinite(report.residual) && std::isfinite(report.worstOverlap) && std::isfinite(report.contactWork),
            "the report is not finite");
    checkMomentum(dynamics, before);
    checkEnergy(dynamics, before, wallsBefore, report);
    checkOverlap(dynamics, overlapBefore, report);
}

template <int D>
void Trial<D>::checkMomentum(const nscd::ContactDynamics<D>& dynamics, const nscd::Grains<D>& before) const
{
    if (!random_.scene.walls.empty())
    {
        return;
    }
    nscd::Vector<D> gain = nscd::Vector<D>::Zero();
    double scale = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        const nscd::Vector<D> now = before.mass[i] * dynamics.grains().velocity[i];
        gain += now - before.mass[i] * before.velocity[i] - random_.dt * random_.force[i];
        scale += now.norm() + before.mass[i] * before.velocity[i].norm() + dynamics.contactImpulse()[i].norm();
    }
    require(gain.norm() <= 1e-11 * scale, "momentum from nowhere: " + text(gain.norm()) + " of " + text(scale));
}

/// Contacts take energy out, those that bounce too.  What the solver leaves unsolved may give some.
template <int D>
void Trial<D>::checkEnergy(const nscd::ContactDynamics<D>& dynamics, const nscd::Grains<D>& before,
                           const std::vector<nscd::WallBody<D>>& wallsBefore, const nscd::StepReport& report)
{
    if (random_.coheres() || random_.hasDrivenWalls() || report.subSteps > 1 || !report.converged)
    {
        return;
    }
    double energy = 0;
    double impulses = 0;   // and momenta: a residual is also an impulse of a contact that opens
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        const nscd::Vector<D> acceleration = random_.force[i] / before.mass[i];
        energy += before.mass[i] * (before.velocity[i] + random_.dt * acceleration).squaredNorm();
        energy += before.mass[i] * before.radius[i] * before.radius[i] * before.spin[i].squaredNorm();
        impulses += before.mass[i] * dynamics.grains().velocity[i].norm();
    }
    for (std::size_t b = 0; b < wallsBefore.size(); ++b)
    {
        const auto& was = wallsBefore[b];
        energy += was.mass * (was.velocity + random_.dt / was.mass * was.force).squaredNorm();
        if (std::isfinite(was.inertia[0]))   // isotropic
        {
            energy +=
                was.inertia[0] * (was.spin + random_.dt * was.torque.cwiseQuotient(was.inertia)).squaredNorm();
        }
    }
    for (const auto& contact : dynamics.contacts())
    {
        impulses += random_.dt * contact.force.norm();
    }
    const double rounding = 1e-15 * impulses / *std::min_element(before.mass.begin(), before.mass.end());
    const double unsolved = 10 * (report.residual + rounding) * impulses;
    largestEnergy_ = std::max(largestEnergy_, energy);   // impulses of the step before leave round-off
    require(report.contactWork <= unsolved + 1e-11 * energy + 1e-14 * largestEnergy_,
            "energy from nowhere: " + text(report.contactWork) + " of " + text(energy) + ", unsolved " +
                text(unsolved));
}

/// Discs and spheres that do not overlap do not after a step that was solved.
template <int D>
void Trial<D>::checkOverlap(const nscd::ContactDynamics<D>& dynamics, double before,
                            const nscd::StepReport& report) const
{
    const double tolerance = random_.scene.settings.tolerance;
    if (random_.hasClusters() || !random_.bodies.empty() || !report.converged || before > tolerance)
    {
        return;
    }
    double reach = 0;
    for (std::size_t i = 0; i < dynamics.grains().size(); ++i)
    {
        reach = std::max(reach, dynamics.grains().position[i].norm() + dynamics.grains().radius[i]);
    }
    require(report.worstOverlap <= 20 * report.subSteps * tolerance + 1e-10 * reach,
            "a new overlap of " + text(report.worstOverlap) + ", radius " + text(dynamics.grains().radius[0]) +
                ", tolerance " + text(tolerance));
}

template <int D>
int runTrial(std::uint64_t seed)
{
    Trial<D> trial(seed);
    try
    {
        return trial.run();
    }
    catch (const Failure& failure)
    {
        throw Failure(failure.what() + (" in " + trial.describe()));
    }
}

int runScene(std::uint64_t seed)
{
    return seed % 2 ? runTrial<2>(seed) : runTrial<3>(seed);
}

}  // namespace

int main(int argc, char** argv)
{
    const std::uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
    const long steps = argc > 2 ? std::atol(argv[2]) : 20000;
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    std::signal(SIGFPE, die);
    std::signal(SIGALRM, die);
    long done = 0, scenes = 0, refused = 0, failed = 0;
    for (; done < steps; ++scenes)
    {
        seedNow = seed + static_cast<std::uint64_t>(scenes);
        alarm(patience);
        try
        {
            done += runScene(seedNow);
        }
        catch (const std::invalid_argument&)
        {
            ++refused;
            ++done;
        }
        catch (const std::exception& error)
        {
            std::fprintf(stderr, "seed %llu: %s\n", static_cast<unsigned long long>(seedNow), error.what());
            ++failed;
            ++done;
        }
    }
    std::printf("%ld steps of %ld scenes, %ld of them refused, %ld failed\n", done, scenes, refused, failed);
    return failed == 0 ? 0 : 1;
}
