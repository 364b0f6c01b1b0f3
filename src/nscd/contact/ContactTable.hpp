// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace nscd
{

/// What the contact problem must know of a pair of materials.
struct ContactParameters
{
    /// Coulomb coefficient mu >= 0: |r_t| <= mu r_n.
    double friction = 0;

    /// Coefficient 0 <= e <= 1 of impacts: what approaches with velocity v leaves with e v, with less where Newton's
    /// rule would create energy (see impactImpulse; doc/theory, eq. 5.15).  Contacts that last have none, nor have
    /// impacts that are slower than what forces do in a step.
    double restitution = 0;

    /// Resistance to rolling >= 0: the rolling moment is at most rolling * r_n * R with 1/R = 1/R_i + 1/R_j
    /// (doc/theory, eq. 5.11).
    double rolling = 0;

    /// Attraction of two grains in contact >= 0: cohesion + tension * R [N], R as for rolling (doc/theory, eq. 5.10).
    double cohesion = 0;   ///< [N]
    double tension = 0;    ///< [N/m]

    /// Time that a contact must have lasted before it attracts >= 0 [s].
    double cohesionDelay = 0;

    /// It attracts only where the ambient value, see Arrangement::ambient, is below.
    double cohesionBelow = std::numeric_limits<double>::infinity();

    bool coheres() const { return cohesion > 0 || tension > 0; }
};

/// Symmetric table of contact parameters for n materials.
class ContactTable
{
public:
    explicit ContactTable(int materials = 1)
        : n_(materials), table_(static_cast<std::size_t>(materials) * materials)
    {
    }

    /// With names of the materials, which saved states hold: a state is continued with the materials of the same
    /// names, whatever their order.
    explicit ContactTable(std::vector<std::string> names) : ContactTable(static_cast<int>(names.size()))
    {
        names_ = std::move(names);
    }

    void set(int a, int b, ContactParameters p)
    {
        at(a, b) = p;
        at(b, a) = p;
    }

    const ContactParameters& operator()(int a, int b) const
    {
        return table_[static_cast<std::size_t>(a) * n_ + b];
    }

    int materials() const { return n_; }

    /// Whether any pair attracts.
    bool coheres() const
    {
        return std::any_of(table_.begin(), table_.end(), [](const ContactParameters& p) { return p.coheres(); });
    }

    /// Whether a pair's attraction depends on what surrounds the contact.
    bool asksForAmbient() const
    {
        return std::any_of(table_.begin(), table_.end(),
                           [](const ContactParameters& p) { return std::isfinite(p.cohesionBelow); });
    }

    /// Empty if they have none.
    const std::vector<std::string>& names() const { return names_; }

private:
    ContactParameters& at(int a, int b) { return table_[static_cast<std::size_t>(a) * n_ + b]; }

    int n_;
    std::vector<ContactParameters> table_;
    std::vector<std::string> names_;
};

}  // namespace nscd
