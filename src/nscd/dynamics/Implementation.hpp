// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Stopwatch.hpp"
#include "nscd/dynamics/ContactDynamics.hpp"
#include "nscd/dynamics/State.hpp"
#include "nscd/impact/Impacts.hpp"
#include "nscd/problem/ContactProblem.hpp"

namespace nscd
{

template <int D>
class ContactDynamics<D>::Implementation
{
public:
    Implementation(Grains<D> grains, Walls<D> walls, ContactTable table, Settings settings, MPI_Comm communicator,
                   std::vector<WallBody<D>> wallBodies);

    const Grains<D>& grains() const { return grains_; }
    const Walls<D>& walls() const { return walls_; }
    const Settings& settings() const { return settings_; }
    const Vectors<D>& contactImpulse() const { return contactImpulse_; }
    const Spins<D>& contactSpinImpulse() const { return contactSpinImpulse_; }
    const Wrenches<D>& lasting() const { return lasting_; }
    const Wrenches<D>& unexpected() const { return unexpected_; }
    const Wrenches<D>& owed() const { return owed_; }
    double lastTimeStep() const { return lastTimeStep_; }
    double worstOverlap() const { return worstOverlap_; }

    const std::vector<WallBody<D>>& wallBodies() const { return wallBodies_; }

    void setWallMotion(int body, const Vector<D>& velocity, const Spin<D>& spin);
    void carryWalls(double dt);
    void setWallLoad(int body, const Vector<D>& force, const Spin<D>& torque);
    std::vector<ContactForce<D>> contacts() const;
    std::vector<WallImpulse<D>> wallImpulses() const;
    void recordTouching(bool on);
    std::vector<Touching<D>> touching() const;
    void dumpContactProblem(const std::string& file) const;
    StepReport step(const Vectors<D>& force, const Spins<D>& torque, double dt);
    void foresee(const std::vector<double>& mass, const Vectors<D>& force, const Spins<D>& torque, double dt);
    void setTemperature(std::vector<double> temperature);
    void setWallNames(WallNames names);

    void setAmbient(std::vector<double> ambient);
    void setHeaviness(std::vector<double> heaviness);
    void setLubrication(WetRestitution law, std::vector<double> viscosity);
    void remove(const std::vector<bool>& gone);
    void add(const Grains<D>& more);
    void resize(std::vector<double> radius, std::vector<double> mass);
    void save(const std::string& file, double time) const;
    double load(const std::string& file);
    void restoreWalls(const State<D>& state);

private:
    /// Velocities that the grains would have without contacts.
    struct FreeMotion
    {
        Vectors<D> velocity;
        Spins<D> spin;
        double largestSpeed = 0;
    };

    /// A list of candidates made for grains at rest holds until one has moved by this fraction of the mean radius.
    static constexpr double restReach = 0.15;

    /// Ratio of neighbours' masses up to which plain sweeps do well.
    static constexpr double evenMasses = 100;

    /// Of grains those that are there come first.
    void replace(Grains<D> all);
    void measureGrains();
    void measureWalls();
    void checkWallBody(int body, bool free, bool finite) const;
    int countSubSteps(double dt) const;

    /// Stop a run that has blown up, which would overflow or hang: throws std::runtime_error if a grain or a wall
    /// would move by more than ten thousand sub-steps allow [m].
    void requireReach(double farthest, double dt) const;

    /// Contacts of this rank in the last step.
    std::vector<ContactForce<D>> ownContacts() const;

    /// Of the sub-step of length dt that has just ended, if they are recorded.
    void keepTouching(double dt);

    /// What contacts gave each grain over a time [s], on average.
    Wrenches<D> meanOfContacts(double dt) const;

    /// Of what contacts give a grain the part of what moves with it.
    double owedPart(std::size_t i) const;
    double owedPartOfTorque(std::size_t i) const;

    /// A grain with its velocities without contacts, as it meets others.
    Body<D> freeBody(std::size_t i) const;

    /// Of a grain's moments of inertia: nothing turns with a disc or sphere.
    double heavinessOfTurning(std::size_t i) const { return grains_.shape[i] < 0 ? 1 : heaviness_[i]; }

    /// Forces and torques of a step with those that make up for the heaviness: what is owed to the grains, and what
    /// their contacts give to all that moves with them while they last.
    Wrenches<D> withOwed(const Vectors<D>& force, const Spins<D>& torque, double dt) const;

    /// Set unexpected_ and owed_ by the contacts of a step of length dt.
    void keepOwed(double dt);

    void setFreeMotion(const Wrenches<D>& given, double dt);

    /// Of a grain's fastest point without contacts; the surface of a disc or sphere is where it is however it turns.
    double freeSpeed(std::size_t i) const;

    void advance(double dt, StepReport& report);

    /// What a sub-step that begins anew needs; without impacts only the report.
    struct Start
    {
        StepReport report;
        Vectors<D> position;
        Orientations<D> orientation;
        FreeMotion free;
        std::vector<WallBody<D>> wallBodies;
        Vectors<D> contactImpulse;
        Spins<D> contactSpinImpulse;
    };

    Start startOfSubStep(const StepReport& report) const;
    void goBack(const Start& start, StepReport& report);

    /// Impacts and contacts of the sub-step up to the velocities at its end; false when the sweeps run out.
    bool solveContacts(double dt, StepReport& report, Stopwatch& watch);

    Reach reachAtRest() const;

    /// By the velocities without contacts of each grain and of those around it.
    Reach reachOfMotion(double dt) const;

    /// Sub-steps to look ahead when each grain goes this far in one [m]: a list for more of them has more pairs.
    double cheapestForesight(const std::vector<double>& way) const;

    /// How far a grain or a wall is from where it was when candidates were listed, after it has gone on [m] and turned
    /// [m, rad]: the farthest of its points [m].
    double wayOfGrain(std::size_t i, const Vector<D>& onwards, double turning) const;
    double wayOfWall(std::size_t b, const Vector<D>& onwards, double angle) const;

    /// Enlarge the reach if the way is farther than it, and not absurd; returns whether it was.
    bool extend(double& reach, double way) const;

    /// List the candidates anew unless they cover motion with the velocities without contacts.
    void updateCandidates(double dt);

    /// Do the candidates cover motion with the bodies' velocities?  If not, gives what would.
    bool motionIsCovered(double dt, Reach& wanted) const;

    void listAnew(const Reach& reach);
    void listAnew(const Reach& reach, const std::vector<NamedImpulse<D>>& impulses);
    void rebuildCandidates(const Vectors<D>& positions, const Orientations<D>& orientations, const Reach& reach,
                           const std::vector<NamedImpulse<D>>& impulses);
    void makeBodies(double dt);

    /// Impacts of the sub-step: flights from one to the next until its end, with candidates that cover them.
    /// Velocities without contacts are those after them from then on.
    void collide(double dt, StepReport& report);

    /// Let bodies fly with their velocities without contacts and collide.  False, and nothing done, when there are no
    /// impacts.  Collective.
    bool fly(double dt);
    void passWindow(double until);
    void launch(double dt);

    /// Are the flights within what the candidates cover?  If not, gives what would cover them.
    bool flightsAreCovered(double dt, Reach& wanted) const;

    /// Take over velocities and offsets of the flights.  What is not round turns back to the beginning from its last
    /// impact, freely: the step that turns it on keeps the angular momentum and the energy that impacts have left.
    void land(double dt);

    /// Arrange bodies that had impacts where their flight would end (see BodyData).
    void placeAtEnds(double dt);

    /// Throws std::runtime_error on all ranks, one of which has such grains.  Collective.
    [[noreturn]] void refusePassedWalls(const std::vector<PassedWall>& mine, const StepReport& report) const;

    /// Largest ratio of the masses of two bodies that may meet.  Collective.
    double unevenness() const;
    double massOfFreeWall(int body) const;

    /// Is it so large that plain sweeps take too long?
    bool isUneven() const { return settings_.solver == Solver::sweeps && unevenness_ > evenMasses; }

    /// One pass of the chosen solver over all groups; its largest change is that of all ranks.  Collective.
    Change pass(double tolerance);

    /// Sweep until the impulses are within the tolerance; false when the sweeps run out.
    bool solve(double dt, StepReport& report);

    /// Displacements over dt that take overlaps away without touching the grains' velocity.  (With the correction
    /// inside the impulses, warm-started sweeps that do not converge make a deep pile bounce for ever: the correction
    /// would have to be slower than the sweeps carry impulses through the pile.)
    /// False when the sweeps run out.
    bool separate(double dt, bool converged, StepReport& report);

    /// Find these displacements; returns the residual [m/s].  Gives up where it is above a limit after a quarter of
    /// the sweeps.
    double moveApart(bool accelerated, int maxSweeps, double tolerance,
                     double limit = std::numeric_limits<double>::infinity());

    void move(double dt, StepReport& report);
    void moveWalls(double dt, StepReport& report);

    /// Bound of how far a wall will have moved at the end of the step, since the candidates were listed [m].
    double wayOfWalls(double dt) const;

    /// Bound of the speed of a point of a wall in a step without contacts [m/s].
    double largestWallSpeed(double dt) const;

    static bool isFree(const WallBody<D>& wall) { return std::isfinite(wall.mass); }
    int freeBodies() const { return static_cast<int>(std::count_if(wallBodies_.begin(), wallBodies_.end(), isFree)); }

    /// Penetration of the present positions; collective.
    void measureOverlaps(StepReport& report);

    Grains<D> grains_;
    std::vector<double> ambient_;   ///< of each grain; empty for nothing
    Walls<D> walls_;
    ContactTable table_;
    Settings settings_;
    Communicator communicator_;
    const std::vector<WallBody<D>> initialWallBodies_;
    std::vector<WallBody<D>> wallBodies_, candidateWalls_;   ///< now, and when the candidates were listed
    WallNames wallNames_;
    std::vector<double> wallExtent_;      ///< of each body: farthest point of its walls from its position [m]
    std::vector<int> freeBodyOfWall_;     ///< number of the free body a wall belongs to; -1 for none
    Arrangement<D> arrangement_;

    bool bounces_ = false, levered_ = false, coheres_ = false;   ///< do some contacts?
    Members<D> members_;
    double smallestRadius_ = 0, meanRadius_ = 0, largestRadius_ = 0;
    Candidates<D> candidates_;
    double unevenness_ = 1;
    FreeMotion free_;                    ///< of the present sub-step
    BodyData<D> data_;
    std::unique_ptr<Schedule<D>> schedule_;
    ContactProblem<D> problem_{arrangement_, candidates_, wallBodies_, data_};
    Impacts<D> impacts_{arrangement_, candidates_, wallBodies_, data_};
    std::vector<Flyer<D>> flyers_;
    std::vector<Launch<D>> launches_;
    std::vector<ContactForce<D>> contactsOfOthers_;   ///< than removed ones, whose problem is no more
    std::vector<std::vector<WallImpulse<D>>> wallImpulses_;   ///< of this rank in each sub-step
    bool recordsTouching_ = false;
    std::vector<std::vector<Touching<D>>> touching_;   ///< of this rank in each sub-step: contacts, then impacts
    std::vector<Body<D>> bodies_;
    std::vector<Body<D>> displacements_;   ///< over dt, in their velocity; empty where there are no overlaps
    std::size_t solves_ = 0;             ///< of this rank in this sub-step
    std::vector<Impulse<D>> impulses_;   ///< of this rank's candidates, from the last sub-step
    std::vector<Impulse<D>> impulsesOfStart_;   ///< the same once the problem has stored others; empty before

    Vectors<D> contactImpulse_;
    Spins<D> contactSpinImpulse_;
    std::vector<double> viscosity_;   ///< of the fluid around each grain [Pa s]; empty for none
    std::vector<double> heaviness_;   ///< of each grain: see setHeaviness()
    Wrenches<D> unexpected_, owed_;   ///< impulses [N s, N m s]: see unexpected(), owed()
    Wrenches<D> lasting_, earlier_;   ///< of contacts: see lasting(), and in the step before the last
    double lastTimeStep_ = 0, lastSubStep_ = 0, worstOverlap_ = 0;
};

}  // namespace nscd
