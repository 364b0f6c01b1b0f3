// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Mpi.hpp"
#include "nscd/contact/ContactForce.hpp"
#include "nscd/contact/ContactTable.hpp"
#include "nscd/impact/WetRestitution.hpp"
#include "nscd/problem/Solver.hpp"
#include "nscd/shape/Grains.hpp"
#include "nscd/walls/WallNames.hpp"
#include "nscd/walls/Walls.hpp"

#include <array>
#include <memory>
#include <string>

namespace nscd
{

/// How the contact problem is solved.
struct Settings
{
    /// Allowed error of a grain's position per (sub-)step [m]; the sweeps stop when the natural-map
    /// residual, in velocity units, is below tolerance/dt.
    double tolerance = 1e-7;

    /// Sweeps after which a step is accepted as it is (the report says so).
    int maxSweeps = 200;

    /// A sub-step moves no grain by more than this fraction of the smallest diameter (doc/theory, eq. 5.6).
    double maxDisplacement = 0.5;

    /// Number of spatial blocks, a power of two. The result depends on it, but not on the number of ranks.
    int blocks = 8;

    Solver solver = Solver::sweeps;

    /// Length of the periodic box along each axis [m]; 0 where it is not periodic.  Positions are not wrapped.
    std::array<double, 3> period{0, 0, 0};
};

/// What one step did.
struct StepReport
{
    std::size_t candidates = 0;   ///< pairs watched by the broad phase
    std::size_t contacts = 0;     ///< contacts in the last contact problem (pairs that may touch within the step)
    std::size_t active = 0;       ///< contacts with a non-zero impulse after the last sub-step
    int subSteps = 0;
    std::size_t impacts = 0;      ///< at contacts with restitution, of all ranks
    std::size_t exhausted = 0;    ///< contacts that had so many impacts that those after them are plastic
    int sweeps = 0;               ///< passes over the contacts, summed over the sub-steps
    std::size_t solves = 0;       ///< local solutions, of all ranks
    bool converged = true;        ///< in every sub-step impulses and displacements are within the tolerance, and no
                                  ///< overlap is so deep (0.1 of the smaller radius) that it takes several steps
    double residual = 0;          ///< worst natural-map residual at the end of a sub-step [m/s]
    double leftOverlap = 0;       ///< worst that displacements should have removed and have not [m]
    double worstOverlap = 0;      ///< deepest penetration of the final positions [m]
    double meanOverlap = 0;       ///< mean over the pairs that penetrate [m]
    double maxVelocity = 0;       ///< [m/s], after the step
    double contactWork = 0;       ///< kinetic energy that impulses give to grains and free walls, which forces alone
                                  ///< would have moved, and impacts at their own time; never positive without
                                  ///< driven walls [J] (doc/theory, eq. 5.7, 5.14)
    double detectionTime = 0;     ///< wall clock [s]
    double solutionTime = 0;      ///< wall clock [s]
};

/// Grains and walls in frictional contact (Signorini-Coulomb, time stepping after
/// Moreau and Jean; Henry 2025, chapter 2), advanced by warm-started non-linear Gauss-Seidel:
///     r_n >= 0,  u_n + max(gap, 0)/dt >= 0,  complementary,  and  |r_t| <= mu r_n.
/// Where there is restitution, bodies first fly from impact to impact (see Impacts.hpp), and contacts begin with the
/// velocities that these leave.
/// Overlaps are taken away by displacements, in frictionless sweeps after the impulses are known; grains gain no
/// velocity and no impulse from it.  A contact that carried an impulse in the step before lets its grains approach
/// again only once its gap exceeds 0.5 % of the smaller radius.  See doc/theory, eq. 5.1, 5.2, 5.8 and 5.9.
///
/// Every rank holds the state of all grains; the contact problem is shared out over the ranks by spatial blocks.
/// The result is the same, bit for bit, for every number of ranks.  Works without MPI_Init on one rank.
template <int D>
class ContactDynamics
{
public:
    /// 'wallBodies' are at their initial place.
    /// Throws std::invalid_argument for sizes that differ, radii or masses <= 0, values that are not
    /// finite, materials outside the table, or senseless settings; the message names the grain's id.
    ContactDynamics(Grains<D> grains, Walls<D> walls, ContactTable table, Settings settings,
                    MPI_Comm communicator = MPI_COMM_WORLD, std::vector<WallBody<D>> wallBodies = {});
    ~ContactDynamics();

    ContactDynamics(ContactDynamics&&) noexcept;
    ContactDynamics& operator=(ContactDynamics&&) noexcept;

    const Grains<D>& grains() const;
    const Walls<D>& walls() const;
    const Settings& settings() const;

    /// Bodies of the walls as they are now; wall(i).body is an index into them.
    const std::vector<WallBody<D>>& wallBodies() const;

    /// Velocity [m/s] and spin [rad/s] of a wall body in the steps to come.  Throws std::invalid_argument.
    void setWallMotion(int body, const Vector<D>& velocity, const Spin<D>& spin);

    /// Walls of prescribed motion go on for the time dt [s], without contacts: of grains that are held.
    void carryWalls(double dt);

    /// Force [N] and torque [N m] on a free wall body in the steps to come.  Throws std::invalid_argument.
    void setWallLoad(int body, const Vector<D>& force, const Spin<D>& torque);

    /// Names that save() writes and load() finds walls by.  Throws std::invalid_argument if they are not those of the
    /// walls and bodies.
    void setWallNames(WallNames names);

    /// Contacts of all ranks in the last step, in an order that does not depend on the number of ranks; after remove()
    /// those between what has stayed, after load() none.  Collective.
    std::vector<ContactForce<D>> contacts() const;

    /// What walls were given in the last step, once for each contact of each sub-step, also by grains that have been
    /// removed since.  Order as contacts(); after load() none.  Collective.
    std::vector<WallImpulse<D>> wallImpulses() const;

    /// Keep what touching() gives from the next step on.
    void recordTouching(bool on);

    /// Pairs of all ranks that touched in the last step, once for each sub-step in which they did, and once for their
    /// impacts in it; none unless recorded.  Order and removals as contacts().  Collective.
    std::vector<Touching<D>> touching() const;

    /// Write the contact problem of the last sub-step and the impulses that were found for it in FCLIB's local form
    /// (see Fclib.hpp), for comparison with other solvers.  Rolling moments and attractions are part of its q.
    /// Written by rank 0; collective.  Throws std::runtime_error.
    void dumpContactProblem(const std::string& file) const;

    /// Temperatures are not used by the dynamics: they are kept, and saved, with the grains [K].
    void setTemperature(std::vector<double> temperature);

    /// What surrounds each grain, for contact laws that ask for it (ContactParameters::cohesionBelow), until grains
    /// come or go; not saved.  Throws std::invalid_argument if the number is wrong.
    void setAmbient(std::vector<double> ambient);

    /// Take the marked grains away; the others keep their order, their contacts and the impulses.  Collective.
    /// Throws std::invalid_argument unless there is one mark per grain.
    void remove(const std::vector<bool>& gone);

    /// Put more grains in, after the others, which keep their order, their contacts and the impulses.  The new ones'
    /// clusters are those that the others have.  Collective.  Throws std::invalid_argument as the constructor does.
    void add(const Grains<D>& more);

    /// Radii [m] and masses [kg] from now on; places, contacts and impulses stay.  Collective.  Throws
    /// std::invalid_argument as the constructor does.
    void resize(std::vector<double> radius, std::vector<double> mass);

    /// Advance by dt [s] under a force [N] and a torque [N m] per grain that do not change within the step
    /// (weight is one of them): v += dt F/m, contacts, x += dt v.  Collective: all ranks give the same lists.
    /// Throws std::runtime_error when a value turns out not to be finite, or a grain's centre has been pressed through
    /// a wall; the message names the grain.
    StepReport step(const Vectors<D>& force, const Spins<D>& torque, double dt);

    /// From now on each grain meets others as if it were this many times as heavy, at least 1, and the moments of
    /// inertia of a cluster as many times as large: something moves with it, as the fluid around it does, but does not
    /// turn with what is round.  What contacts give to that is owed().  Until grains come or a state is loaded; throws
    /// std::invalid_argument for another number of values or one below 1.
    void setHeaviness(std::vector<double> heaviness);

    /// From now on impacts are those in a fluid, of a viscosity around each grain [Pa s], by a law of restitution; of
    /// two viscosities the mean by the inverse masses counts.  Until grains come or go, or a state is loaded; throws
    /// std::invalid_argument for another number of values.
    void setLubrication(WetRestitution law, std::vector<double> viscosity);

    /// Set contactImpulse(), lasting() and lastTimeStep() to what the contacts of a step would leave there if grains
    /// had these masses [kg], and nothing else: for bodies that have no step behind them.  Collective; arguments and
    /// errors of step().
    void foresee(const std::vector<double>& mass, const Vectors<D>& force, const Spins<D>& torque, double dt);

    /// Linear impulse [N s] and angular impulse [N m s] that contacts gave each grain during the last step.
    const Vectors<D>& contactImpulse() const;
    const Spins<D>& contactSpinImpulse() const;

    /// Force [N] and torque [N m] that contacts gave each grain in the last step, as far as it had them in the two
    /// steps before, too: what holds it, without bounces and landings.
    const Wrenches<D>& lasting() const;

    /// Impulse and angular impulse of contacts in the last step without the lasting force and torque of before [N s,
    /// N m s]; zero before the first.
    const Wrenches<D>& unexpected() const;

    /// Of what was unexpected the part of what moves with each grain [N s, N m s].  The grain gets it in the next step.
    const Wrenches<D>& owed() const;

    /// Length of the last step [s]; 0 before the first.
    double lastTimeStep() const;

    /// Deepest penetration of the present positions [m].
    double worstOverlap() const;

    /// Write grains, contacts and impulses to an HDF5 file: under a temporary name first, then renamed, so that
    /// the file is either complete or absent.  Written by rank 0; collective.  Throws std::runtime_error.
    void save(const std::string& file, double time) const;

    /// Replace the state by a saved one and return its time: continuing equals, bit for bit, never having
    /// stopped.  The number of grains comes from the file.  Throws std::runtime_error naming file and reason.
    double load(const std::string& file);

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

extern template class ContactDynamics<2>;
extern template class ContactDynamics<3>;

}  // namespace nscd
