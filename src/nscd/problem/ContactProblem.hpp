// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/Arrangement.hpp"
#include "nscd/contact/ContactForce.hpp"
#include "nscd/contact/Impulses.hpp"
#include "nscd/contact/LeveredContact.hpp"
#include "nscd/contact/Schedule.hpp"
#include "nscd/problem/Anderson.hpp"

namespace nscd
{

/// How the bodies turn, and their flights when some bounce; in solver order, free walls last, then the fixed body.
template <int D>
struct BodyData
{
    std::vector<Turning<D>> turning;     ///< empty when no contact is levered

    /// Principal moments of inertia over the square of turning's length, while bodies fly [kg]; zero for what is round.
    Spins<D> inertia;

    /// Velocities after impacts, before the contact problem; empty when nothing bounces.
    std::vector<Body<D>> flight;

    /// The same of those bodies that had impacts: the arrangement has them where their flight would end (their flight
    /// back to the beginning of the sub-step may lead through others); zero for the other bodies.  Empty when none had.
    std::vector<Body<D>> ahead;
};

/// Overlaps as velocities, overlap/dt [m/s].
struct Depths
{
    double worst = 0;
    double spared = 0;   ///< worst part that this sub-step is to leave
    bool deep = false;   ///< is one deeper than 'shallow'?
};

/// What a pass over contacts did.
struct Change
{
    double largest = 0;        ///< square of the largest W times change of an impulse [m^2/s^2]
    double sum = 0;            ///< of these squares
    std::size_t solves = 0;

    void add(double square)
    {
        largest = std::max(largest, square);
        sum += square;
        ++solves;
    }
};

/// A grain whose centre has come to the other side of a wall.
struct PassedWall
{
    int first, wall;   ///< place of the member in solver order
    double gap;        ///< at the beginning of the sub-step [m]
};

/// Impulses, or displacing pushes, with the weights that make them velocities, and which of them belong to which block;
/// then the velocities of this rank's bodies.
struct Unknowns
{
    std::vector<double> values, weights;
    std::vector<Anderson::Range> ranges;
};

/// A contact as other solvers want it; arms are over the bodies' lengths.
template <int D>
struct SolvedContact
{
    int first, second;        ///< bodies; second < 0: a wall that is not free
    Vector<D> normal, armI, armJ;
    double approachLimit, friction;
    Vector<D> impulse;        ///< in the frame [N s]
    Vector<D> wallVelocity;   ///< [m/s]
};

/// This rank's share of the contact problem of one sub-step of length dt.
/// Bodies are in solver order; then comes one that stands for the fixed walls and, as contacts need them, one for the
/// point of contact of each moving wall.
template <int D>
class ContactProblem
{
public:
    ContactProblem(const Arrangement<D>& arrangement, const Candidates<D>& candidates,
                   const std::vector<WallBody<D>>& wallBodies, const BodyData<D>& data)
        : arrangement_(arrangement), candidates_(candidates), wallBodies_(wallBodies), data_(data)
    {
    }

    /// Be without contacts: the list of candidates is another one.
    void clear();

    /// Start a sub-step with the impulses of the last one, scaled to dt; marked candidates go on with those of others.
    void begin(const std::vector<Impulse<D>>& impulses, double dt, std::vector<char> goesOn);

    /// Select the candidates that would touch, or nearly so, at the bodies' present velocities and those that
    /// residual() has found missing, keeping all chosen before; take over their impulses without applying them.
    void choose(std::vector<Body<D>>& bodies, const std::vector<Impulse<D>>& impulses);

    /// Give the bodies the impulses of a group's contacts, and the attraction of those that cohere.
    void applyImpulses(int group, std::vector<Body<D>>& bodies) const;

    /// Solve a group's contacts one after the other.
    Change sweep(int group, std::vector<Body<D>>& bodies);

    /// Solve those contacts of a group that are off by more than the tolerance [m/s], and again those whose bodies have
    /// changed by more than it since (Henry 2025, algorithm 2 with its queue, but what has changed is accumulated).
    Change workQueue(int group, std::vector<Body<D>>& bodies, double tolerance);

    /// Go on in the direction of the last change: impulses += factor * (impulses - those of the last call), and the
    /// bodies [begin, end) likewise.
    void extrapolate(double factor, std::vector<Body<D>>& bodies, std::size_t begin, std::size_t end);

    /// Remember the present impulses and velocities for extrapolate().
    void remember(const std::vector<Body<D>>& bodies);

    /// Largest natural-map residual [m/s] over all candidates, chosen or not; marks those missed.
    double residual(const std::vector<Body<D>>& bodies);

    /// Did the last residual() find candidates that should have been chosen?
    bool incomplete() const { return incomplete_; }

    /// Find what would overlap at the end of the step if the bodies moved with their present velocities.  The sweeps of
    /// separate() will remove the given share of its first part, of 'shallow' of the smaller radius, and all beyond;
    /// and all of it at contacts of bodies that had an impact.
    Depths measureOverlaps(const std::vector<Body<D>>& bodies, double share, double shallow);

    /// One sweep over a group that pushes overlapping bodies apart: displacements/dt stand in the bodies' velocity.
    /// Returns the square of the largest change [m^2/s^2].
    double separate(int group, std::vector<Body<D>>& displacements);

    /// How far the displacements are from the solution [m/s]: natural map of the frictionless problem.
    double separationResidual(const std::vector<Body<D>>& displacements) const;

    /// Let separate() know of the candidates without a contact into which the displacements push; returns how far, as
    /// a velocity [m/s].
    double addPushed(const std::vector<Body<D>>& bodies, const std::vector<Body<D>>& displacements);

    /// Has an overlap been cut to what one step may remove?
    bool isCut() const;

    /// Contacts with walls whose grain ends beyond the wall.
    std::vector<PassedWall> passedWalls(const std::vector<Body<D>>& bodies,
                                        const std::vector<Body<D>>& displacements) const;

    /// The unknowns of the sweeps, or of those that remove overlaps, with the bodies [begin, end).
    void get(Unknowns& u, std::vector<Body<D>>& bodies, bool overlaps, std::size_t begin, std::size_t end);
    void set(const Unknowns& u, std::vector<Body<D>>& bodies, bool overlaps, std::size_t begin, std::size_t end);

    /// Write the impulses back; zero for candidates that were not chosen.  Ages stay as they are.
    void store(std::vector<Impulse<D>>& impulses) const;

    /// Contacts with an impulse, of this problem or of impacts before, and the mean forces in them; with the numbers of
    /// the places of solver order.
    std::vector<ContactForce<D>> forces(const std::vector<PairImpulse<D>>& impacts) const;

    /// What walls are given by contacts of this problem and by impacts before.
    std::vector<WallImpulse<D>> wallImpulses(const std::vector<PairImpulse<D>>& impacts) const;

    /// This rank's contacts; the velocities are those of the bodies that walls stand for.
    std::vector<SolvedContact<D>> solvedContacts(const std::vector<Body<D>>& bodies) const;

    std::size_t contacts() const { return contacts_.size() + levered_.size(); }
    std::size_t active() const;

private:
    /// Contacts of a group: [contact, ...) of the plain ones, [levered, ...) of the others.
    struct Begin
    {
        std::size_t contact, levered;
    };

    /// What the sweeps do not need of a contact.
    struct Origin
    {
        std::size_t pair;
        double gap;            ///< not less than what one step may remove [m]
        double attraction;     ///< impulse [N s]
        double wholeGap;       ///< [m]
    };

    /// f(impulse) for each contact of a group that gave one, if wanted(pair).
    template <class Wanted, class F>
    void forImpulses(std::size_t group, Wanted&& wanted, F&& f) const;

    /// f(group, number, weight) for the numbers of all contacts.
    template <class F>
    void forGroups(const std::vector<Body<D>>& bodies, bool overlaps, F&& f);

    /// Place of a pair's second body; makes one for the point of contact of a moving wall.
    int secondBody(const Pair& pair, const Approach<D>& approach, std::vector<Body<D>>& bodies) const;

    /// Where the bodies of a candidate meet, and what the gap was along that normal at the beginning [m].
    struct Meeting
    {
        Approach<D> approach;
        double gap;
    };

    std::optional<Meeting> meeting(std::size_t p) const;

    /// Of two discs or spheres that are let bounce: with the normal where their flights end.  Those that pass each
    /// other do not touch, and as the distance is convex, those that are stopped do not overlap.
    Meeting meetingAtEnd(const Pair& pair, const Approach<D>& approach) const;

    /// How a candidate opens along its normal [m/s], and the gap of its meeting [m].
    struct Opening
    {
        Vector<D> normal;
        double velocity, gap;
    };

    /// By the bodies' velocities; none if it stays apart at them, and at one besides.
    std::optional<Opening> openingOf(std::size_t p, const std::vector<Body<D>>& bodies,
                                     const Vector<D>& besides = Vector<D>::Zero()) const;

    /// Two grains, not clusters, that stay apart by more than this [m] at the bodies' velocities, and one besides.
    bool staysApart(const Pair& pair, double apart, const std::vector<Body<D>>& bodies,
                    const Vector<D>& besides = Vector<D>::Zero()) const;

    bool isLevered(const Pair& pair) const;
    void addLevered(const Pair& pair, const Approach<D>& approach, const Impulse<D>& impulse, int j,
                    const std::vector<Body<D>>& bodies);

    /// Velocity along the normal with which a candidate opens [m/s], without and with what driven walls do.
    double openingByBodies(const Pair& pair, const Approach<D>& approach, const std::vector<Body<D>>& bodies) const;
    double openingVelocity(const Pair& pair, const Approach<D>& approach, const std::vector<Body<D>>& bodies) const;
    Vector<D> wallVelocity(int wallBody, const Vector<D>& arm) const;
    bool hadImpact(int body) const;

    /// Append overlaps to those of their groups, [begin[g], begin[g + 1]) to those of g.
    void insertOverlaps(const std::vector<Overlap<D>>& more, const std::vector<std::size_t>& moreBegin);

    /// From the centre of a free wall, where it is arranged, to a contact [m].
    Vector<D> wallArm(const Pair& pair, const Approach<D>& approach, int body) const;

    /// Velocity with which a contact may close [m/s].
    double approachLimit(std::size_t p, double gap, bool attracts) const;

    double attraction(std::size_t p, double gap, const Impulse<D>& impulse) const;

    /// Largest penetration velocity [m/s] of candidates that were not chosen; marks them.
    double findMissing(const std::vector<Body<D>>& bodies);

    /// Contacts by body: those of body b are touching_[touchingBegin_[b] ... touchingBegin_[b + 1]), levered ones
    /// counted on from the plain ones.
    void listTouching(std::size_t bodies);

    template <class F>
    void forTouching(int group, int body, F&& f) const;

    const Arrangement<D>& arrangement_;
    const Candidates<D>& candidates_;
    const std::vector<WallBody<D>>& wallBodies_;
    const BodyData<D>& data_;
    double dt_ = 0;
    std::vector<char> kept_;              ///< candidates that are in the problem, or must be
    std::vector<char> loaded_;            ///< candidates with an impulse in the last sub-step, or that go on with one
    bool incomplete_ = false;
    std::vector<Contact<D>> contacts_;
    std::vector<LeveredContact<D>> levered_;
    std::vector<Origin> origin_, leveredOrigin_;
    std::vector<Overlap<D>> overlaps_;    ///< of a group's contacts, its levered ones, then what they push into
    std::vector<std::size_t> overlapBegin_;   ///< first of each group, and the end
    std::vector<char> listed_;            ///< candidates among them
    std::vector<Begin> begin_;            ///< of each group, and the end

    std::vector<int> touching_, touchingBegin_, queue_;
    std::vector<double> pending_;         ///< change of a contact's bodies since it was solved [m/s]; < 0 in the queue

    std::vector<Contact<D>> oldContacts_;
    std::vector<LeveredContact<D>> oldLevered_;
    std::vector<Body<D>> oldBodies_;
};

}  // namespace nscd
