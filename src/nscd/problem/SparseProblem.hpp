// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/LocalSolve.hpp"

namespace nscd
{

/// A frictional contact problem in its general form, for contacts 0 ... n-1 with components as in solveLocal():
///     u = W r + q,   each contact after Signorini and Coulomb with its own mu.
/// W is stored by rows of D x D blocks, columns in ascending order.
template <int D>
class SparseProblem
{
public:
    /// A number of W; rows and columns count components, D for each contact [1/kg].
    struct Entry
    {
        int row, column;
        double value;
    };

    /// A block of W in its row.
    struct Neighbour
    {
        int contact;
        Block<D> W;
    };

    /// Entries at the same place are added.  Throws std::invalid_argument, naming the contact, for lists of different
    /// length, entries outside W, values that are not finite, mu < 0 and W_NN <= 0.
    SparseProblem(Vectors<D> q, std::vector<double> friction, const std::vector<Entry>& entries);

    int contacts() const { return static_cast<int>(q_.size()); }
    const Vectors<D>& q() const { return q_; }
    const std::vector<double>& friction() const { return friction_; }

    /// The blocks of a contact's row.
    const Neighbour* begin(int contact) const { return blocks_.data() + rows_[contact]; }
    const Neighbour* end(int contact) const { return blocks_.data() + rows_[contact + 1]; }

    /// The block on the diagonal.
    const Block<D>& own(int contact) const { return blocks_[diagonal_[contact]].W; }

    /// Relative velocity at a contact [m/s].
    Vector<D> velocity(int contact, const Vectors<D>& r) const
    {
        Vector<D> u = q_[contact];
        for (const Neighbour* n = begin(contact); n != end(contact); ++n)
        {
            u += n->W * r[n->contact];
        }
        return u;
    }

    Vectors<D> velocities(const Vectors<D>& r) const;

    std::size_t blocks() const { return blocks_.size(); }

private:
    void check(const std::vector<Entry>& entries) const;
    void assemble(const std::vector<Entry>& entries);

    Vectors<D> q_;
    std::vector<double> friction_;
    std::vector<std::size_t> rows_, diagonal_;
    std::vector<Neighbour> blocks_;
};

/// How far impulses are from a solution, in units of velocity: for every contact the natural map
///     e = W_NN r - P(W_NN r - (u_N + mu |u_T|, u_T)),   P the projection on the cone |r_T| <= mu r_N,
/// which vanishes for solutions and nowhere else.
struct Residual
{
    double worst = 0;        ///< largest |e| [m/s]
    double relative = 0;     ///< root mean square of e over that of q_N
    double penetration = 0;  ///< largest approach velocity max(-u_N, 0) [m/s]
};

/// The natural map of one contact.
template <int D>
Vector<D> naturalMap(double wNN, double mu, const Vector<D>& r, const Vector<D>& u);

/// From the impulses alone; u = W r + q is computed anew.
template <int D>
Residual residual(const SparseProblem<D>& problem, const Vectors<D>& r);

extern template class SparseProblem<2>;
extern template class SparseProblem<3>;

}  // namespace nscd
