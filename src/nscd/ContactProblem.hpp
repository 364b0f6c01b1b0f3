// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/Arrangement.hpp"
#include "nscd/Impulses.hpp"
#include "nscd/Schedule.hpp"

namespace nscd
{

/// This rank's share of the contact problem of one sub-step of length dt.
/// Bodies are in solver order; one more at the end stands for all walls.
template <int D>
class ContactProblem
{
public:
    ContactProblem(const Arrangement<D>& arrangement, const Candidates<D>& candidates)
        : arrangement_(arrangement), candidates_(candidates)
    {
    }

    /// Start a sub-step with the impulses of the last one, scaled to dt.
    void begin(const std::vector<Impulse<D>>& impulses, double dt);

    /// Select the candidates that would touch, or nearly so, at the bodies' present velocities and those that
    /// residual() has found missing, keeping all chosen before; take over their impulses without applying them.
    void choose(const std::vector<Body<D>>& bodies, const std::vector<Impulse<D>>& impulses);

    /// Give the bodies the impulses of a group's contacts.
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

    /// Write the impulses back; zero for candidates that were not chosen.
    void store(std::vector<Impulse<D>>& impulses) const;

    std::size_t contacts() const { return contacts_.size(); }
    std::size_t active() const;

private:
    const Arrangement<D>& arrangement_;
    const Candidates<D>& candidates_;
    double dt_ = 0;
    std::vector<char> kept_;              ///< candidates that are in the problem, or must be
    std::vector<char> loaded_;            ///< candidates with an impulse in the last sub-step
    bool incomplete_ = false;
    std::vector<Contact<D>> contacts_;
    std::vector<double> gap_;           ///< of each contact, not less than what one step may remove [m]
    std::vector<Overlap<D>> overlaps_;  ///< of each contact
    std::vector<std::size_t> source_;   ///< candidate of each contact
    std::vector<std::size_t> begin_;    ///< first contact of each group, and the end
};

}  // namespace nscd
