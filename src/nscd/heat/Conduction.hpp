// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/dynamics/ContactDynamics.hpp"
#include "nscd/heat/HeatNetwork.hpp"
#include "nscd/heat/ThermalContact.hpp"

#include <optional>

namespace nscd
{

/// A wall that grains may touch.
struct ThermalWall
{
    int material = 0;
    std::optional<double> temperature;  ///< [K]; adiabatic if there is none
};

/// Grains after a step of conduction.
struct Heated
{
    std::vector<double> temperature;  ///< of the grains [K]
    std::vector<double> wallHeat;     ///< that each wall gave to the grains [J]
};

/// The law that a dimension has unless another is chosen: strips of cylinders, circles of spheres.
template <int D>
ConductanceLaw defaultConductance()
{
    return D == 2 ? conductance::strip : conductance::spheres;
}

/// Conduction of heat between grains, each of one temperature, through their contacts (Henry 2025, section 4.1.1, with
/// the sign that warms the colder grain; doc/theory, eq. 6.1):
///     m_i c_i dT_i/dt = sum_j H_ij (T_j - T_i).
///
/// Advanced by the implicit Euler method.  For every time step no grain leaves the range of its neighbours' and its own
/// temperatures, entropy does not fall, and the steady state is the exact one; no method of higher order keeps the
/// first for every time step (Bolley and Crouzeix, RAIRO Anal. Numer. 12, 237, 1978).  The linear system is that
/// of a graph, symmetric and positive definite, solved by conjugate gradients; heat is conserved to round-off however
/// well it is solved.  All is computed in the order of the contacts: ranks that hold the same state find the same
/// result, bit for bit, and need no communication.
///
/// What presses a cohesive contact together is its load and the attraction (as in the theory of Derjaguin, Muller and
/// Toporov, J. Colloid Interface Sci. 53, 314, 1975): a contact in tension conducts until it breaks.
template <int D>
class Conduction
{
public:
    /// Materials as in the grains' and walls' indices; 'length' is the depth of the mesh in 2-D [m], unused in 3-D.
    /// Throws std::invalid_argument for values <= 0, or a Poisson ratio outside (-1, 0.5].
    explicit Conduction(std::vector<ThermalMaterial> materials, double length = 1,
                        ConductanceLaw law = defaultConductance<D>());

    /// Conductance of a contact [W/K] whose surfaces press on each other with ContactForce::pressing.  Its radii are
    /// those of the grains (of a cluster, that of the member that touches).
    double conductance(const ContactForce<D>& contact, const Grains<D>& grains,
                       const std::vector<ThermalWall>& walls) const;

    /// Heat that flows through a contact from the first body to the second [W] at the grains' temperatures; to an
    /// adiabatic wall none.
    double heatFlow(const ContactForce<D>& contact, const Grains<D>& grains,
                    const std::vector<ThermalWall>& walls) const;

    /// Temperatures after dt [s]; heatCapacity is m c of each grain [J/K].  Throws std::invalid_argument for lists of
    /// different length, unknown materials, grains or walls, and values that are not positive.
    Heated advance(const Grains<D>& grains, const std::vector<double>& heatCapacity,
                   const std::vector<ContactForce<D>>& contacts, const std::vector<ThermalWall>& walls,
                   double dt) const;

    /// What the contacts join, those of a grain with facets whose patches lie over each other as one (ContactPatch);
    /// throws as 'advance'.
    HeatNetwork network(const Grains<D>& grains, const std::vector<double>& heatCapacity,
                        const std::vector<ContactForce<D>>& contacts, const std::vector<ThermalWall>& walls) const;

    /// The same of all that touched in a step of length dt [s], each with its share of it; impacts by their own time.
    HeatNetwork network(const Grains<D>& grains, const std::vector<double>& heatCapacity,
                        const std::vector<Touching<D>>& touching, const std::vector<ThermalWall>& walls,
                        double dt) const;

private:
    ThermalContact thermalContact(int first, int second, const Vector<D>& point, const Grains<D>& grains,
                                  const std::vector<ThermalWall>& walls) const;

    /// In a step of length dt [W/K]; of what lasts, the share of a patch with 'joined' times the force.
    double conductance(const Touching<D>& touching, const Grains<D>& grains, const std::vector<ThermalWall>& walls,
                       double dt, double joined) const;

    void check(const Grains<D>& grains, const std::vector<double>& heatCapacity,
               const std::vector<ThermalWall>& walls) const;

    /// forceOf(pair): while it lasts, and over the step [N]; conductanceOf(pair, joined) [W/K]
    template <class Pair, class ForceOf, class ConductanceOf>
    HeatNetwork join(const Grains<D>& grains, const std::vector<double>& heatCapacity, const std::vector<Pair>& pairs,
                     const std::vector<ThermalWall>& walls, ForceOf&& forceOf, ConductanceOf&& conductanceOf) const;

    std::vector<ThermalMaterial> materials_;
    double length_;
    ConductanceLaw law_;
};

}  // namespace nscd
