// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <vector>

namespace nscd
{

/// What the contact problem must know of a pair of materials.
struct ContactParameters
{
    double friction = 0;   ///< Coulomb coefficient mu >= 0: |r_t| <= mu r_n
};

/// Symmetric table of contact parameters for n materials.
class ContactTable
{
public:
    explicit ContactTable(int materials = 1)
        : n_(materials), table_(static_cast<std::size_t>(materials) * materials)
    {
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

private:
    ContactParameters& at(int a, int b) { return table_[static_cast<std::size_t>(a) * n_ + b]; }

    int n_;
    std::vector<ContactParameters> table_;
};

}  // namespace nscd
