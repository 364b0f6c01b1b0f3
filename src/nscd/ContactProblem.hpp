// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/Arrangement.hpp"
#include "nscd/ContactForce.hpp"
#include "nscd/Impulses.hpp"
#include "nscd/LeveredContact.hpp"
#include "nscd/Schedule.hpp"

namespace nscd
{

/// Where the bodies are, how they turn and what they did before the step; in solver order, free walls last.
template <int D>
struct BodyData
{
    std::vector<Turning<D>> turning;     ///< empty when no contact is levered
    std::vector<Body<D>> before;         ///< at the beginning of the step; empty when nothing bounces
    Vectors<D> wallCentre;               ///< of the free walls
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

    /// Start a sub-step with the impulses of the last one, scaled to dt.
    void begin(const std::vector<Impulse<D>>& impulses, double dt);

    /// Select the candidates that would touch, or nearly so, at the bodies' present velocities and those that
    /// residual() has found missing, keeping all chosen before; take over their impulses without applying them.
    void choose(std::vector<Body<D>>& bodies, const std::vector<Impulse<D>>& impulses);

    /// Give the bodies the impulses of a group's contacts, and the attraction of those that cohere.
    void applyImpulses(int group, std::vector<Body<D>>& bodies) const;

    /// Solve a group's contacts one after the other; returns the square of the largest change [m^2/s^2].
    double sweep(int group, std::vector<Body<D>>& bodies);

    /// Largest natural-map residual [m/s] over all candidates, chosen or not; marks those missed.
    double residual(const std::vector<Body<D>>& bodies);

    /// Did the last residual() find candidates that should have been chosen?
    bool incomplete() const { return incomplete_; }

    /// Find what would overlap at the end of the step if the bodies moved with their present velocities; returns the
    /// worst as a velocity, overlap/dt [m/s].  The sweeps of separate() will remove the given share of it.
    double measureOverlaps(const std::vector<Body<D>>& bodies, double share);

    /// One sweep over a group that pushes overlapping bodies apart: displacements/dt stand in the bodies' velocity.
    /// Returns the square of the largest change [m^2/s^2].
    double separate(int group, std::vector<Body<D>>& displacements);

    /// Write the impulses back; zero for candidates that were not chosen.  Ages stay as they are.
    void store(std::vector<Impulse<D>>& impulses) const;

    /// Contacts with an impulse and the forces in them, with the numbers of the places of solver order.
    std::vector<ContactForce<D>> forces() const;

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
    };

    /// Place of a pair's second body; makes one for the point of contact of a moving wall.
    int secondBody(const Pair& pair, const Approach<D>& approach, std::vector<Body<D>>& bodies) const;

    bool isLevered(const Pair& pair) const;
    void addLevered(const Pair& pair, const Approach<D>& approach, const Impulse<D>& impulse, int j,
                    const std::vector<Body<D>>& bodies);

    /// Velocity along the normal with which a candidate opens [m/s].
    double openingVelocity(const Pair& pair, const Approach<D>& approach, const std::vector<Body<D>>& bodies) const;
    Vector<D> wallVelocity(int wallBody, const Vector<D>& arm) const;

    template <class C>
    double approachLimit(std::size_t p, double gap, const C& contact, const std::vector<Body<D>>& bodies) const;

    double attraction(std::size_t p, double gap, const Impulse<D>& impulse) const;

    /// Largest penetration velocity [m/s] of candidates that were not chosen; marks them.
    double findMissing(const std::vector<Body<D>>& bodies);

    const Arrangement<D>& arrangement_;
    const Candidates<D>& candidates_;
    const std::vector<WallBody<D>>& wallBodies_;
    const BodyData<D>& data_;
    double dt_ = 0;
    std::vector<char> kept_;              ///< candidates that are in the problem, or must be
    std::vector<char> loaded_;            ///< candidates with an impulse in the last sub-step
    bool incomplete_ = false;
    std::vector<Contact<D>> contacts_;
    std::vector<LeveredContact<D>> levered_;
    std::vector<Origin> origin_, leveredOrigin_;
    std::vector<Overlap<D>> overlaps_;    ///< of each contact, the levered ones of a group after the others
    std::vector<Begin> begin_;            ///< of each group, and the end
};

}  // namespace nscd
