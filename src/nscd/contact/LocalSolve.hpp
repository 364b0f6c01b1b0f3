// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

namespace nscd
{

/// A block of the Delassus operator [1/kg]: velocity of one contact per impulse of one.
template <int D>
using Block = Eigen::Matrix<double, D, D>;

/// The impulse r [N s] that solves the problem of Signorini and Coulomb at one contact whose normal and tangential
/// directions are coupled; components (N, T) in 2-D, (N, T1, T2) in 3-D:
///
///     u = W r + q,   0 <= u_N,  r_N >= 0,  u_N r_N = 0,   |r_T| <= mu r_N,   r_T = -mu r_N u_T/|u_T| if u_T != 0.
///
/// W need not be symmetric; W_NN > 0 and mu >= 0.  Solved exactly, to rounding, whenever W is positive definite; a
/// solution then exists for every mu, also where W_NN < mu |W_NT| (Painleve: the contact jams, u = 0).  Where there
/// are several solutions, no impulse is preferred, then sticking.  Where W is singular or indefinite and there is no
/// solution, the impulse without friction: finite, u_N = 0.
///
/// With the slip that an impulse without friction leaves, b, and the Schur complement A,
///
///     r_N = -(q_N + W_NT r_T)/W_NN,   A r_T = u_T - b,   b = q_T - W_TN q_N/W_NN,   A = W_TT - W_TN W_NT/W_NN,
///
/// sticking is u_T = 0 and sliding u_T = -s r_T with the s > 0 for which |r_T| = mu r_N.  In 2-D r_T has the sign of
/// -b (doc/theory, eq. 5.5; Henry 2025, eq. 2.38-2.41, with the signs of 2.39 and 2.40 exchanged).  In 3-D Newton's
/// method, kept between bounds, finds s; it is one step when A is a multiple of the identity.  It starts from the
/// guess, e.g. the impulse of the last sweep, which changes the time it takes but, where there is one solution, not
/// the result.
template <int D>
Vector<D> solveLocal(const Block<D>& W, const Vector<D>& q, double mu, const Vector<D>& guess = Vector<D>::Zero());

extern template Vector<2> solveLocal<2>(const Block<2>&, const Vector<2>&, double, const Vector<2>&);
extern template Vector<3> solveLocal<3>(const Block<3>&, const Vector<3>&, double, const Vector<3>&);

}  // namespace nscd
