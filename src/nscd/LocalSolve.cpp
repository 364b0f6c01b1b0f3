// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/LocalSolve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The contact without its normal direction: A r_T = u_T - slip, r_N = push - lever.r_T.
template <int D>
struct Reduced
{
    using Tangential = Eigen::Matrix<double, D - 1, 1>;
    using Square = Eigen::Matrix<double, D - 1, D - 1>;

    Reduced(const Block<D>& W, const Vector<D>& q, double friction)
        : lever(W.template block<1, D - 1>(0, 1).transpose() / W(0, 0)), mu(friction), push(-q[0] / W(0, 0)),
          slip(q.template tail<D - 1>() + W.template block<D - 1, 1>(1, 0) * push),
          A(W.template block<D - 1, D - 1>(1, 1) - W.template block<D - 1, 1>(1, 0) * lever.transpose()),
          rounding(8 * epsilon
                   * (W.template block<D - 1, D - 1>(1, 1).norm()
                      + W.template block<D - 1, 1>(1, 0).norm() * lever.norm() + epsilon * W(0, 0)))
    {
    }

    double normal(const Tangential& tangential) const { return push - lever.dot(tangential); }

    /// |r_T| - mu r_N: not positive within the cone.
    double excess(const Tangential& tangential) const { return tangential.norm() - mu * normal(tangential); }

    Vector<D> impulse(const Tangential& tangential) const
    {
        Vector<D> r;
        r << normal(tangential), tangential;
        return r;
    }

    Vector<D> withoutFriction() const { return impulse(Tangential::Zero()); }

    /// On the surface of the cone, r_T along the given unit vector.
    Vector<D> sliding(const Tangential& along) const
    {
        const double denominator = 1 + mu * lever.dot(along);
        if (denominator <= 0)
        {
            return withoutFriction();
        }
        const double r = push / denominator;
        return impulse(mu * r * along);
    }

    Tangential lever;
    double mu, push;
    Tangential slip;
    Square A;
    double rounding;  ///< eigenvalues of A below this are taken for zero [1/kg]
};

Vector<2> solve(const Reduced<2>& c)
{
    using Tangential = Reduced<2>::Tangential;
    if (c.A(0, 0) > c.rounding)
    {
        const Tangential stick = -c.slip / c.A(0, 0);
        if (c.excess(stick) <= 0)
        {
            return c.impulse(stick);
        }
    }
    return c.sliding(Tangential::Constant(c.slip[0] > 0 ? -1 : 1));
}

/// Solve M x = b for a regular M, by elimination with a pivot.
Vector<2> eliminate(const Block<2>& M, const Vector<2>& b)
{
    const int p = std::abs(M(0, 0)) >= std::abs(M(1, 0)) ? 0 : 1;
    const double factor = M(1 - p, 0) / M(p, 0);
    Vector<2> x;
    x[1] = (b[1 - p] - factor * b[p]) / (M(1 - p, 1) - factor * M(p, 1));
    x[0] = (b[p] - M(p, 1) * x[1]) / M(p, 0);
    return x;
}

/// The tangential impulses from none, t = 0, to the sticking one, t = 1,
///     [t A + (1 - t) a 1] r_T = -t slip,   that is u_T = -s r_T with s = a (1 - t)/t.
/// Where A = a 1, r_T is linear in t.
class Line
{
public:
    explicit Line(const Reduced<3>& contact) : c_(contact), mean_(0.5 * c_.A.trace())
    {
        const double spread = std::hypot(0.5 * (c_.A(0, 0) - c_.A(1, 1)), 0.5 * (c_.A(0, 1) + c_.A(1, 0)));
        smallest_ = mean_ - spread;
        a_ = mean_ > c_.rounding ? mean_ : std::abs(mean_) + spread + c_.rounding;
    }

    /// Is there a sticking impulse?
    bool regular() const { return smallest_ > c_.rounding; }

    /// How far the matrix is positive definite, t included.
    double end() const { return regular() ? 1 : (1 - 1e-13) * a_ / (a_ - std::min(smallest_, 0.0)); }

    Vector<2> impulse(double t) const { return eliminate(matrix(t), -t * c_.slip); }

    /// s |r_T|
    double slipSpeed(double t, const Vector<2>& impulse) const { return a_ * (1 - t) / t * impulse.norm(); }

    /// d excess/dt
    double slope(double t, const Vector<2>& impulse) const
    {
        const Vector<2> change = -eliminate(matrix(t), c_.slip + c_.A * impulse - a_ * impulse);
        return impulse.dot(change) / impulse.norm() + c_.mu * c_.lever.dot(change);
    }

private:
    Block<2> matrix(double t) const { return t * c_.A + (1 - t) * a_ * Block<2>::Identity(); }

    const Reduced<3>& c_;
    double mean_, smallest_, a_;
};

/// The impulse on the line where the excess vanishes; it is negative at t = 0 and positive at 'upper'.
Vector<2> slidingImpulse(const Reduced<3>& c, const Line& line, double upper, double upperExcess)
{
    double lower = 0;
    double before = upperExcess;
    double t = upper * c.mu * c.push / (c.mu * c.push + upperExcess);
    Vector<2> impulse = line.impulse(t);
    for (int iteration = 0; iteration < 200; ++iteration)
    {
        const double excess = c.excess(impulse);
        const double length = impulse.norm();
        if (std::abs(excess) <= 2 * epsilon * length || length == 0)
        {
            break;
        }
        (excess < 0 ? lower : upper) = t;
        const double slope = line.slope(t, impulse);
        const bool converges = slope > 0 && std::abs(excess) < 0.5 * std::abs(before);
        const double newton = converges ? t - excess / slope : upper;
        const double next = newton > lower && newton < upper ? newton : 0.5 * (lower + upper);
        if (next <= lower || next >= upper)
        {
            break;
        }
        t = next;
        before = excess;
        impulse = line.impulse(t);
    }
    return impulse;
}

Vector<3> solve(const Reduced<3>& c)
{
    const Line line(c);
    const double end = line.end();
    const Vector<2> stick = line.impulse(end);
    const double excess = c.excess(stick);
    if (excess <= 0)
    {
        // Where A is singular the end of the line sticks only if its slip is within the range of A
        const bool sticks = line.regular() || line.slipSpeed(end, stick) <= 1e-12 * c.slip.norm();
        return sticks ? c.impulse(stick) : c.withoutFriction();
    }
    const Vector<2> impulse = slidingImpulse(c, line, end, excess);
    const double length = impulse.norm();
    return length > 0 ? c.sliding(impulse / length) : c.withoutFriction();
}

}  // namespace

template <int D>
Vector<D> solveLocal(const Block<D>& W, const Vector<D>& q, double mu)
{
    if (q[0] >= 0)
    {
        return Vector<D>::Zero();
    }
    const Reduced<D> contact(W, q, mu);
    return mu > 0 && contact.slip.norm() > 0 ? solve(contact) : contact.withoutFriction();
}

template Vector<2> solveLocal<2>(const Block<2>&, const Vector<2>&, double);
template Vector<3> solveLocal<3>(const Block<3>&, const Vector<3>&, double);

}  // namespace nscd
